#include "tables/build/search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/quads/generate.hpp"
#include "tables/build/filled.hpp"
#include "tables/format/sha256.hpp"

namespace hexatlas::build {
namespace {

constexpr std::size_t kExchangesPerStep = 1024;
constexpr int kNone = 1 << 14;  ///< more than any mesh has

flips::State single_hexahedron() {
  return flips::canonical_state(flips::single_hexahedron()).state;
}

flips::BeamOptions limits(std::size_t per_class, std::size_t per_level, std::uint64_t seed,
                          int threads) {
  flips::BeamOptions options;
  options.max_quads = 24;
  options.fronts_per_class = per_class;
  options.fronts_per_level = per_level;
  options.seed = seed;
  options.threads = threads;
  return options;
}

void put(std::string& bytes, std::uint64_t number) {
  for (unsigned shift = 0; shift < 64; shift += 8)
    bytes += static_cast<char>(number >> shift & 0xFFU);
}

std::uint64_t get(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (unsigned i = 0; i < 8; ++i)
    number |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  bytes.remove_prefix(8);
  return number;
}

std::string digest_of(std::string_view bytes) {
  const format::Digest digest = format::sha256(std::array{bytes});
  return {digest.begin(), digest.end()};
}

constexpr std::string_view kMagic = "hexsrch1";
constexpr std::size_t kPlaceSize = 4 * 8;
constexpr std::size_t kDigestSize = 32;

}  // namespace

std::vector<canon::Code> three_connected_codes(int max_quads) {
  std::vector<canon::Code> codes;
  for (int n = 6; n <= max_quads; n += 2)
    (void)quads::generate(quads::Class::three_connected, n,
                          [&](const complex::Quadrangulation& q, int, int) {
                            codes.push_back(canon::canonical_form(q).code);
                          });
  std::sort(codes.begin(), codes.end());
  return codes;
}

SearchOptions default_search(std::uint64_t seed, int threads) {
  SearchOptions options;
  options.balls = limits(40, 1'000'000, seed, threads);
  options.collars = limits(20, 3'000, seed, threads);
  options.collars.max_quads = flips::kMaxSearchQuads;  // some have no flip that adds less than 4
  return options;
}

std::string_view name_of(flips::FrontOrigin origin) noexcept {
  constexpr std::array<std::string_view, flips::kFrontOrigins> kNames{"sweep", "exchange",
                                                                      "collar"};
  return kNames[static_cast<std::size_t>(origin)];
}

TableSearch::TableSearch(std::vector<canon::Code> targets, const SearchOptions& options)
    : targets_(std::move(targets)), options_(options), balls_(single_hexahedron(), options.balls) {
  core::expects(std::is_sorted(targets_.begin(), targets_.end()), "targets ascend");
  core::expects(options.rounds >= 1 && options.max_hexahedra >= 1, "a search has a round");
}

void TableSearch::step() {
  core::expects(!is_finished(), "the search goes on");
  if (phase_ == Phase::sweep) return sweep_step();
  if (phase_ == Phase::exchange) return exchange_step();
  collar_step();
}

void TableSearch::sweep_step() {
  const bool is_last = balls_.level() + 1 >= options_.max_hexahedra ||
                       (balls_.frontier().empty() && balls_.level() >= balls_.last_level());
  if (!is_last) {
    (void)balls_.expand_level();
    return;
  }
  phase_ = Phase::exchange;
  position_ = 0;
}

std::optional<flips::FrontId> TableSearch::smallest(const canon::Code& code) const {
  const auto family = balls_.store().find(code);
  if (!family) return std::nullopt;
  const auto& fronts = balls_.store().family(*family).fronts;
  const auto least = std::min_element(
      fronts.begin(), fronts.end(),
      [](const flips::StoredFront& a, const flips::StoredFront& b) { return a.level < b.level; });
  return flips::FrontId{*family, static_cast<std::uint32_t>(least - fronts.begin())};
}

int TableSearch::hexahedra(const canon::Code& code) const {
  const auto id = smallest(code);
  return id ? balls_.level_of(*id) + 1 : kNone;
}

void TableSearch::exchange_step() {
  const std::size_t end = std::min(position_ + kExchangesPerStep, targets_.size());
  std::vector<std::optional<complex::HexComplex>> found(end - position_);
  parallel::parallel_for(options_.balls.threads, found.size(), [&](std::size_t i) {
    const canon::Code& code = targets_[position_ + i];
    const auto id = smallest(code);
    if (!id || options_.growths == 0) return;
    const std::uint64_t seed = options_.balls.seed * 0x9E3779B97F4A7C15ULL +
                               static_cast<std::uint64_t>(round_) * 0xC2B2AE3D27D4EB4FULL +
                               std::hash<canon::Code>{}(code);
    found[i] = flips::smaller_by_replacement(flips::filling_of(balls_, *id).mesh, code.quads,
                                             balls_, {options_.growths, seed});
  });
  for (const auto& mesh : found)
    if (mesh) (void)flips::add_ball(balls_, *mesh, flips::FrontOrigin::exchanged);
  position_ = end;
  if (position_ == targets_.size()) begin_collars();
}

void TableSearch::begin_collars() {
  phase_ = Phase::collars;
  position_ = 0;
  std::vector<int> sizes;
  for (const canon::Code& code : targets_) sizes.push_back(hexahedra(code));
  std::sort(sizes.rbegin(), sizes.rend());
  const std::size_t count = std::min(options_.collared, sizes.size());
  collared_from_ = count == 0 ? kNone + 1 : sizes[count - 1];
  // Ties would make more of them than asked for.
  if (count < sizes.size() && sizes[count] == collared_from_ && sizes.front() > collared_from_)
    ++collared_from_;
}

void TableSearch::collar_step() {
  while (position_ < targets_.size() && hexahedra(targets_[position_]) < collared_from_)
    ++position_;
  if (position_ == targets_.size()) return next_round();
  const canon::Code& code = targets_[position_++];
  flips::MeetingOptions options{
      .collars = options_.collars, .max_collar = options_.max_collar, .below = hexahedra(code)};
  if (const auto filling = flips::best_meeting(flips::BeamBalls(balls_), code, options))
    (void)flips::add_ball(balls_, filling->mesh, flips::FrontOrigin::met);
}

void TableSearch::next_round() {
  phase_ = ++round_ == options_.rounds ? Phase::finished : Phase::sweep;
  position_ = 0;
  balls_.rewind();
}

TableSearch::Progress TableSearch::progress() const {
  const std::string round =
      "round " + std::to_string(round_ + 1) + " of " + std::to_string(options_.rounds);
  if (phase_ == Phase::sweep)
    return {round + ", sweep", static_cast<std::size_t>(balls_.level()) + 1,
            static_cast<std::size_t>(options_.max_hexahedra)};
  return {round + (phase_ == Phase::exchange ? ", exchange" : ", collars"), position_,
          targets_.size()};
}

std::vector<TableSearch::Row> TableSearch::rows() const {
  std::vector<Row> result;
  for (const canon::Code& code : targets_)
    if (const auto id = smallest(code))
      result.push_back({code, balls_.level_of(*id) + 1, balls_.origin_of(*id)});
  return result;
}

std::vector<canon::Code> TableSearch::without_mesh() const {
  std::vector<canon::Code> result;
  std::copy_if(targets_.begin(), targets_.end(), std::back_inserter(result),
               [&](const canon::Code& code) { return !smallest(code); });
  return result;
}

complex::HexComplex TableSearch::mesh(const canon::Code& target) const {
  const auto id = smallest(target);
  core::expects(id.has_value(), "the target has a mesh");
  complex::HexComplex mesh = flips::filling_of(balls_, *id).mesh;
  ensure_fills(mesh, target);
  return mesh;
}

/// What a saved search must have been made with, apart from the options of the balls.
std::string TableSearch::settings() const {
  std::string text;
  for (const canon::Code& code : targets_) text += canon::to_text(code);
  for (const std::uint64_t number :
       {static_cast<std::uint64_t>(options_.max_hexahedra),
        static_cast<std::uint64_t>(options_.growths),
        static_cast<std::uint64_t>(options_.collars.max_quads),
        std::uint64_t{options_.collars.fronts_per_class},
        std::uint64_t{options_.collars.fronts_per_level}, options_.collars.seed,
        static_cast<std::uint64_t>(options_.max_collar), std::uint64_t{options_.collared}})
    text += ' ' + std::to_string(number);
  return digest_of(text);
}

std::string TableSearch::to_bytes() const {
  std::string bytes(kMagic);
  bytes += settings();
  put(bytes, static_cast<std::uint64_t>(phase_));
  put(bytes, static_cast<std::uint64_t>(round_));
  put(bytes, position_);
  put(bytes, static_cast<std::uint64_t>(collared_from_));
  bytes += balls_.to_bytes();
  return bytes + digest_of(bytes);
}

TableSearch TableSearch::from_bytes(std::string_view bytes, std::vector<canon::Code> targets,
                                    const SearchOptions& options, const std::string& name) {
  TableSearch search(std::move(targets), options);
  const std::string settings = search.settings();
  const std::size_t header = kMagic.size() + settings.size() + kPlaceSize;
  if (bytes.substr(0, kMagic.size()) != kMagic)
    throw core::InvalidInput(name, "is no saved search");
  if (bytes.size() < header + kDigestSize ||
      digest_of(bytes.substr(0, bytes.size() - kDigestSize)) !=
          bytes.substr(bytes.size() - kDigestSize))
    throw core::InvalidInput(name, "a saved search that is damaged");
  if (bytes.substr(kMagic.size(), settings.size()) != settings)
    throw core::InvalidInput(name, "is a search for other boundaries or with other options");
  bytes.remove_suffix(kDigestSize);
  std::string_view place = bytes.substr(kMagic.size() + settings.size());
  search.phase_ = static_cast<Phase>(get(place));
  search.round_ = static_cast<int>(get(place));
  search.position_ = get(place);
  search.collared_from_ = static_cast<int>(get(place));
  search.balls_ =
      flips::Beam::from_bytes(bytes.substr(header), single_hexahedron(), options.balls, name);
  if (search.is_finished() && search.round_ < options.rounds) search.phase_ = Phase::sweep;
  return search;
}

std::vector<format::TableRow> table_rows(const TableSearch& search) {
  const std::vector<TableSearch::Row> rows = search.rows();
  std::vector<format::TableRow> result(rows.size());
  parallel::parallel_for(search.balls().options().threads, rows.size(), [&](std::size_t i) {
    result[i] = {rows[i].code, search.mesh(rows[i].code), 1};
  });
  return result;
}

}  // namespace hexatlas::build
