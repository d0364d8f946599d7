// The saved form of a search. Integers are little-endian:
//   "hexsrch2", the digest of targets and settings (32), phase, round, position, least size of the
//   phase (8 each), the number of meshes beside the beam (8), and for each: quads (1), the binary
//   code, hexahedra (2), origin (1), length of the record (4), the record; then the beam
//   (enum/flips/beam_bytes.cpp) and the SHA-256 of all before it.

#include <algorithm>
#include <array>
#include <utility>

#include "enum/core/errors.hpp"
#include "tables/build/search.hpp"
#include "tables/format/bytes.hpp"
#include "tables/format/record.hpp"
#include "tables/format/sha256.hpp"

namespace hexatlas::build {
namespace {

constexpr std::string_view kMagic = "hexsrch2";
constexpr std::size_t kDigestSize = 32;
constexpr std::size_t kPlaceSize = 4 * sizeof(std::uint64_t);

std::string digest_of(std::string_view bytes) {
  const format::Digest digest = format::sha256(std::array{bytes});
  return {digest.begin(), digest.end()};
}

/// What follows the magic word, without the digest at the end.
std::string_view intact(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kMagic)) throw core::InvalidInput(name, "is no saved search");
  if (bytes.size() < kMagic.size() + kDigestSize + kPlaceSize + kDigestSize ||
      digest_of(bytes.substr(0, bytes.size() - kDigestSize)) !=
          bytes.substr(bytes.size() - kDigestSize))
    throw core::InvalidInput(name, "a saved search that is damaged");
  bytes.remove_suffix(kDigestSize);
  return bytes.substr(kMagic.size());
}

template <std::unsigned_integral T>
T take(std::string_view& bytes, const std::string& name) {
  if (bytes.size() < sizeof(T)) throw core::InvalidInput(name, "a saved search that is cut short");
  const T value = format::get<T>(bytes, 0);
  bytes.remove_prefix(sizeof(T));
  return value;
}

std::string_view take(std::string_view& bytes, std::size_t count, const std::string& name) {
  if (bytes.size() < count) throw core::InvalidInput(name, "a saved search that is cut short");
  const std::string_view taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return taken;
}

}  // namespace

/// What a saved search must have been made with, apart from the options of the balls.
std::string TableSearch::settings() const {
  std::string text;
  for (const canon::Code& code : targets_) text += canon::to_text(code);
  for (const std::uint64_t number :
       {static_cast<std::uint64_t>(options_.max_hexahedra),
        static_cast<std::uint64_t>(options_.growths), std::uint64_t{options_.cut},
        std::uint64_t{options_.cuts_each}, static_cast<std::uint64_t>(options_.cut_growths),
        static_cast<std::uint64_t>(options_.cut_interior), std::uint64_t{options_.cut_uphill},
        static_cast<std::uint64_t>(options_.max_symmetric), std::uint64_t{options_.symmetrized},
        static_cast<std::uint64_t>(options_.max_symmetric_ball),
        static_cast<std::uint64_t>(options_.max_collar), std::uint64_t{options_.collared},
        static_cast<std::uint64_t>(options_.anneal_rounds), std::uint64_t{options_.annealed},
        std::uint64_t{options_.anneal_starts}, std::uint64_t{options_.anneal_faulty},
        std::uint64_t{options_.anneal_cut}, static_cast<std::uint64_t>(options_.anneal_leaps)})
    text += ' ' + std::to_string(number);
  for (const flips::BeamOptions* own :
       {&options_.symmetric, &options_.symmetric_balls, &options_.collars})
    for (const std::uint64_t number :
         {static_cast<std::uint64_t>(own->max_quads), std::uint64_t{own->fronts_per_class},
          std::uint64_t{own->fronts_per_level}, std::uint64_t{own->scars_per_quad}})
      text += ' ' + std::to_string(number);
  // Later than the others: a search that does without is as it was.
  if (options_.annealed != 0 && options_.anneal_transplant != 0)
    text += " transplants " + std::to_string(options_.anneal_transplant);
  if (options_.annealed != 0 && options_.anneal_symmetric != 0)
    text += " symmetric annealing " + std::to_string(options_.anneal_symmetric);
  if (options_.max_symmetric_ball != 0 && (options_.symmetric_balls.scars_per_irregularity != 0 ||
                                           options_.symmetric_balls.scars_per_simple_zone != 0))
    text += " symmetric balls that prefer what others do";
  if (options_.guided != 0) text += " guided " + std::to_string(options_.guided);
  return digest_of(text);
}

std::string TableSearch::to_bytes() const {
  std::string bytes(kMagic);
  bytes += settings();
  for (const std::uint64_t number :
       {static_cast<std::uint64_t>(phase_), static_cast<std::uint64_t>(round_),
        std::uint64_t{position_}, static_cast<std::uint64_t>(taken_from_),
        std::uint64_t{loose_.size()}})
    format::put(bytes, number);
  for (const auto& [code, own] : loose_) {
    format::put(bytes, code.quads);
    bytes += canon::to_binary(code);
    format::put(bytes, static_cast<std::uint16_t>(own.hexahedra));
    format::put(bytes, static_cast<std::uint8_t>(own.origin));
    format::put(bytes, static_cast<std::uint32_t>(own.record.size()));
    bytes += own.record;
  }
  bytes += balls_.to_bytes();
  return bytes + digest_of(bytes);
}

/// The meshes beside the beam and the balls, from what follows the place.
void TableSearch::restore_found(std::string_view bytes, const std::string& name) {
  for (auto left = take<std::uint64_t>(bytes, name); left > 0; --left) {
    const auto quads = take<std::uint8_t>(bytes, name);
    const auto code = canon::from_binary(quads, take(bytes, canon::binary_size(quads), name));
    Loose own;
    own.hexahedra = take<std::uint16_t>(bytes, name);
    own.origin = static_cast<flips::FrontOrigin>(take<std::uint8_t>(bytes, name));
    own.record = take(bytes, take<std::uint32_t>(bytes, name), name);
    const auto boundary = code ? canon::decode(*code) : std::nullopt;
    if (!boundary || static_cast<std::uint8_t>(own.origin) >= flips::kFrontOrigins ||
        !format::decode_record(own.record, *boundary, own.hexahedra))
      throw core::InvalidInput(name, "a saved search that is damaged");
    if (std::binary_search(targets_.begin(), targets_.end(), *code)) loose_[*code] = std::move(own);
  }
  balls_ = flips::Beam::from_bytes(bytes, flips::canonical_state(flips::single_hexahedron()).state,
                                   options_.balls, name);
}

TableSearch TableSearch::from_bytes(std::string_view bytes, std::vector<canon::Code> targets,
                                    const SearchOptions& options, const std::string& name) {
  TableSearch search(std::move(targets), options);
  std::string_view rest = intact(bytes, name);
  if (take(rest, kDigestSize, name) != search.settings())
    throw core::InvalidInput(name,
                             "is a search for other boundaries or with other options: it "
                             "goes on with those of the command that began it only");
  const auto phase = take<std::uint64_t>(rest, name);
  if (phase > static_cast<std::uint64_t>(Phase::finished))
    throw core::InvalidInput(name, "a saved search that is damaged");
  search.phase_ = static_cast<Phase>(phase);
  search.round_ = static_cast<int>(take<std::uint64_t>(rest, name));
  search.position_ = take<std::uint64_t>(rest, name);
  search.taken_from_ = static_cast<int>(take<std::uint64_t>(rest, name));
  search.restore_found(rest, name);
  if (search.is_finished() && search.round_ < options.rounds) search.phase_ = Phase::sweep;
  return search;
}

bool TableSearch::is_saved(std::string_view bytes) noexcept { return bytes.starts_with(kMagic); }

TableSearch TableSearch::started_from(std::string_view bytes, std::vector<canon::Code> targets,
                                      const SearchOptions& options, const std::string& name) {
  TableSearch search(std::move(targets), options);
  std::string_view rest = intact(bytes, name).substr(kDigestSize + kPlaceSize);
  search.restore_found(rest, name);
  search.balls_.rewind();
  return search;
}

}  // namespace hexatlas::build
