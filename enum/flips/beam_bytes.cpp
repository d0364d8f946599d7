// The saved form of a search. Integers are little-endian:
//   "hexbeam3", the options that matter (max_quads, fronts per class and per level, scars per unit
//   of irregularity and per simple zone, seed, dominance), level, last level, candidates,
//   truncated; 8 bytes each.
//   For each shard the number of families (4), and for each family: quads (1), the binary code,
//   the number of fronts (4), and per front: family and place of the parent (4 + 4), bottom and
//   sides of the flip (1 + 1), level (2), mark (1), origin (1).

#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/beam.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

static_assert(std::endian::native == std::endian::little, "the saved form is a plain copy");

constexpr std::string_view kMagic = "hexbeam3";

template <class Number>
void put(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, raw.size());
  bytes.append(raw.data(), raw.size());
}

class Source {
 public:
  Source(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[nodiscard]] std::string_view take(std::size_t count) {
    if (count > bytes_.size()) refuse("is cut short");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class Number>
  [[nodiscard]] Number get() {
    Number number{};
    std::memcpy(&number, take(sizeof(Number)).data(), sizeof(Number));
    return number;
  }
  [[noreturn]] void refuse(const std::string& reason) const {
    throw core::InvalidInput(name_, "a saved search that " + reason);
  }
  [[nodiscard]] std::size_t left() const noexcept { return bytes_.size(); }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

void put_options(std::string& bytes, const BeamOptions& options) {
  put<std::uint64_t>(bytes, static_cast<std::uint64_t>(options.max_quads));
  put<std::uint64_t>(bytes, options.fronts_per_class);
  put<std::uint64_t>(bytes, options.fronts_per_level);
  put<std::uint64_t>(bytes, options.scars_per_irregularity);
  put<std::uint64_t>(bytes, options.scars_per_simple_zone);
  put<std::uint64_t>(bytes, options.seed);
  put<std::uint64_t>(bytes, options.use_dominance ? 1 : 0);
}

/// What put_options() wrote, in words.
std::string words_for_options(std::string_view bytes, const std::string& name) {
  Source source(bytes, name);
  const auto next = [&source] { return std::to_string(source.get<std::uint64_t>()); };
  std::string words = "boundaries of at most " + next() + " quads";
  words += ", " + next() + " balls per boundary and level";
  words += ", " + next() + " per level";
  if (const auto reward = next(); reward != "0")
    words += ", " + reward + " scars less per unit of irregularity";
  if (const auto more = next(); more != "0") words += ", " + more + " scars more per simple zone";
  words += ", seed " + next();
  return words + (source.get<std::uint64_t>() != 0 ? "" : ", without dominance");
}

constexpr std::size_t kBytesPerFront = 14;

StoredFront get_front(Source& source) {
  StoredFront front;
  front.parent.family = source.get<std::uint32_t>();
  front.parent.place = source.get<std::uint32_t>();
  front.flip.bottom = source.get<std::uint8_t>();
  front.flip.sides = source.get<std::uint8_t>();
  front.level = source.get<std::uint16_t>();
  const auto mark = source.get<std::uint8_t>();
  const auto origin = source.get<std::uint8_t>();
  if (mark > static_cast<std::uint8_t>(FrontMark::expanded) || origin >= kFrontOrigins ||
      front.flip.sides >= kSideSets)
    source.refuse("is damaged");
  front.origin = static_cast<FrontOrigin>(origin);
  front.mark = static_cast<FrontMark>(mark);
  return front;
}

/// One family, given to `keep(code, fronts)`; its fronts have no scars yet.
template <class Keep>
void get_family(Source& source, std::size_t shard, Keep&& keep) {
  const int quads = source.get<std::uint8_t>();
  if (quads < 6 || quads > kMaxStateQuads) source.refuse("is damaged");
  const auto code = canon::from_binary(quads, source.take(canon::binary_size(quads)));
  if (!code || FrontStore::shard_of(*code) != shard) source.refuse("is damaged");
  const auto count = source.get<std::uint32_t>();
  if (count == 0 || count > source.left() / kBytesPerFront) source.refuse("is damaged");
  std::vector<StoredFront> fronts;
  fronts.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) fronts.push_back(get_front(source));
  keep(*code, std::move(fronts));
}

}  // namespace

std::string Beam::to_bytes() const {
  std::string bytes(kMagic);
  bytes.reserve(16 * (fronts() + 2 * classes()));
  put_options(bytes, options_);
  put<std::uint64_t>(bytes, static_cast<std::uint64_t>(level_));
  put<std::uint64_t>(bytes, static_cast<std::uint64_t>(last_level_));
  put<std::uint64_t>(bytes, candidates_);
  put<std::uint64_t>(bytes, store_.is_truncated() ? 1 : 0);
  for (std::size_t shard = 0; shard < FrontStore::kShards; ++shard) {
    const auto families = store_.families(shard);
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(families.size()));
    for (const FrontStore::Family& own : families) {
      put<std::uint8_t>(bytes, own.code.quads);
      bytes += canon::to_binary(own.code);
      put<std::uint32_t>(bytes, static_cast<std::uint32_t>(own.fronts.size()));
      for (const StoredFront& front : own.fronts) {
        put<std::uint32_t>(bytes, front.parent.family);
        put<std::uint32_t>(bytes, front.parent.place);
        put<std::uint8_t>(bytes, front.flip.bottom);
        put<std::uint8_t>(bytes, front.flip.sides);
        put<std::uint16_t>(bytes, front.level);
        put<std::uint8_t>(bytes, static_cast<std::uint8_t>(front.mark));
        put<std::uint8_t>(bytes, static_cast<std::uint8_t>(front.origin));
      }
    }
  }
  return bytes;
}

Beam Beam::from_bytes(std::string_view bytes, const State& start, const BeamOptions& options,
                      const std::string& name) {
  Source source(bytes, name);
  if (source.take(std::min(kMagic.size(), bytes.size())) != kMagic)
    throw core::InvalidInput(name, "is no saved search");
  std::string wanted;
  put_options(wanted, options);
  const std::string_view made = source.take(wanted.size());
  if (made != wanted)
    source.refuse("goes on only as it was made: " + words_for_options(made, name));

  Beam beam(start, options);
  beam.store_ = FrontStore(beam.store_.limits());
  beam.frontier_.clear();
  beam.level_ = static_cast<int>(source.get<std::uint64_t>() & 0xFFFFU);
  beam.last_level_ = static_cast<int>(source.get<std::uint64_t>() & 0xFFFFU);
  beam.candidates_ = source.get<std::uint64_t>();
  if (source.get<std::uint64_t>() != 0) beam.store_.set_truncated();
  std::vector<std::vector<FrontId>> by_level(static_cast<std::size_t>(beam.last_level_) + 1);
  for (std::size_t shard = 0; shard < FrontStore::kShards; ++shard) {
    const auto families = source.get<std::uint32_t>();
    for (std::uint32_t f = 0; f < families; ++f)
      get_family(source, shard, [&](const canon::Code& code, std::vector<StoredFront> fronts) {
        if (beam.store_.find(code)) source.refuse("is damaged");
        for (std::uint32_t place = 0; place < fronts.size(); ++place) {
          const std::size_t level = fronts[place].level;
          if (level >= by_level.size()) source.refuse("is damaged");
          by_level[level].push_back({FrontStore::number_of(shard, f), place});
        }
        beam.store_.append_family(code, std::move(fronts));
      });
  }
  const auto root = beam.store_.find(start.code);
  if (source.left() != 0 || by_level[0].size() != 1 || !root || by_level[0][0] != FrontId{*root, 0})
    source.refuse("is damaged");
  beam.store_.set_scars(by_level[0][0], start.scars);
  for (std::size_t level = 1; level < by_level.size(); ++level)
    beam.restore_level(by_level[level], name);
  beam.collect_chosen();
  return beam;
}

/// Makes the states of one level again. Those of the level below must be there.
void Beam::restore_level(std::span<const FrontId> ids, const std::string& name) {
  constexpr std::size_t kIdsPerChunk = 4096;
  const std::size_t chunks = (ids.size() + kIdsPerChunk - 1) / kIdsPerChunk;
  const auto damaged = [&] { return core::InvalidInput(name, "a saved search that is damaged"); };
  parallel::parallel_for(options_.threads, chunks, [&](std::size_t c) {
    const std::size_t begin = c * kIdsPerChunk;
    for (const FrontId id : ids.subspan(begin, std::min(kIdsPerChunk, ids.size() - begin))) {
      const StoredFront& own = store_.at(id);
      if (!store_.contains(own.parent) || store_.at(own.parent).level + 1 != own.level)
        throw damaged();
      const Front front = front_of(state(own.parent));
      if (own.flip.bottom >= front.boundary.quads()) throw damaged();
      const int after = front.boundary.quads() + 6 - 2 * own.flip.consumed();
      if (after < 6 || after > kMaxStateQuads) throw damaged();
      const auto prism = prism_of(front.boundary, own.flip);
      if (!prism || !may_glue(front, own.flip, *prism)) throw damaged();
      const State made = canonical_state(glued(front, own.flip, *prism).front).state;
      if (made.code != store_.family(id.family).code) throw damaged();
      store_.set_scars(id, made.scars);
    }
  });
}

}  // namespace hexatlas::flips
