#include "tables/build/search.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/quads/generate.hpp"
#include "tables/fill/filled.hpp"
#include "tables/format/record.hpp"

namespace hexatlas::build {
namespace {

constexpr std::size_t kExchangesPerStep = 1024;
constexpr int kShellings = 10;  ///< tries to find a shelling

constexpr std::array<std::string_view, flips::kFrontOrigins> kOriginNames{"sweep", "exchange",
                                                                          "collar", "cut", "table"};

/// A shared seed and number of threads, and balls that prefer the same, symmetric or not.
SearchOptions adjusted(SearchOptions options) {
  for (flips::BeamOptions* own : {&options.symmetric, &options.symmetric_balls, &options.collars}) {
    own->seed = options.balls.seed;
    own->threads = options.balls.threads;
  }
  options.symmetric_balls.scars_per_irregularity = options.balls.scars_per_irregularity;
  options.symmetric_balls.scars_per_simple_zone = options.balls.scars_per_simple_zone;
  return options;
}

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

std::string_view name_of(flips::FrontOrigin origin) noexcept {
  return kOriginNames[static_cast<std::size_t>(origin)];
}

flips::FrontOrigin origin_named(std::string_view name) noexcept {
  const auto at = std::find(kOriginNames.begin(), kOriginNames.end(), name);
  return at == kOriginNames.end() ? flips::FrontOrigin::known
                                  : static_cast<flips::FrontOrigin>(at - kOriginNames.begin());
}

TableSearch::TableSearch(std::vector<canon::Code> targets, const SearchOptions& options)
    : targets_(std::move(targets)),
      options_(adjusted(options)),
      balls_(flips::canonical_state(flips::single_hexahedron()).state, options.balls) {
  core::expects(std::is_sorted(targets_.begin(), targets_.end()), "targets ascend");
  core::expects(options.rounds >= 1 && options.max_hexahedra >= 1, "a search has a round");
}

void TableSearch::step() {
  core::expects(!is_finished(), "the search goes on");
  if (phase_ == Phase::sweep) return sweep_step();
  if (phase_ == Phase::exchange) return exchange_step();
  if (phase_ == Phase::cuts) return cut_step();
  if (phase_ == Phase::symmetric) return symmetric_step();
  if (phase_ == Phase::collars) return collar_step();
  anneal_step();
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

std::uint64_t TableSearch::seed_for(const canon::Code& code) const {
  return options_.balls.seed * 0x9E3779B97F4A7C15ULL +
         static_cast<std::uint64_t>(round_) * 0xC2B2AE3D27D4EB4FULL +
         std::hash<canon::Code>{}(code);
}

void TableSearch::exchange_step() {
  const std::size_t end = std::min(position_ + kExchangesPerStep, targets_.size());
  std::vector<const canon::Code*> batch;
  for (; position_ < end; ++position_) batch.push_back(&targets_[position_]);
  adopt_all(batch, [&](const canon::Code& code, int) -> std::optional<Found> {
    const int known = hexahedra(code);
    if (known == kNone || options_.growths == 0) return std::nullopt;
    const bool is_shelled = loose(code) == nullptr;
    auto mesh = flips::smaller_by_replacement(unchecked_mesh(code), code.quads, balls_,
                                              {options_.growths, seed_for(code), is_shelled, 0});
    if (!mesh) return std::nullopt;
    return Found{*std::move(mesh), flips::FrontOrigin::exchanged, is_shelled};
  });
  if (position_ == targets_.size()) begin(Phase::cuts, options_.cut);
}

/// The same mesh, in the order of a shelling if one was found.
TableSearch::Found TableSearch::in_order(const canon::Code& code, Found found) const {
  if (found.is_shelled) return found;
  auto shelled = flips::in_shelling_order(found.mesh, kShellings, seed_for(code));
  if (shelled) found = {*std::move(shelled), found.origin, true};
  return found;
}

/// Finds meshes for several targets, each with one thread, or for one with all threads.
void TableSearch::adopt_all(const std::vector<const canon::Code*>& batch, const Finder& find) {
  const int threads = options_.balls.threads;
  const int inside = batch.size() == 1 ? threads : 1;
  std::vector<std::optional<Found>> found(batch.size());
  parallel::parallel_for(threads, batch.size(),
                         [&](std::size_t i) { found[i] = find(*batch[i], inside); });
  for (std::size_t i = 0; i < batch.size(); ++i)
    if (found[i]) adopt(*batch[i], *found[i]);
}

void TableSearch::adopt(const canon::Code& code, const Found& found) {
  if (found.is_shelled) {
    (void)flips::add_ball(balls_, found.mesh, found.origin);
    return;
  }
  const int count = static_cast<int>(found.mesh.hexahedra.size());
  if (count >= hexahedra(code)) return;
  loose_[code] = {count, found.origin,
                  format::encode_record(found.mesh, canon::decode(code).value())};
}

std::size_t TableSearch::take_over(const format::Table& table, const std::string& name,
                                   const Origins& origins) {
  std::vector<std::optional<Found>> found(targets_.size());
  parallel::parallel_for(options_.balls.threads, targets_.size(), [&](std::size_t i) {
    const canon::Code& code = targets_[i];
    const auto ordinal = table.find(code);
    if (!ordinal || static_cast<int>(table.entry(*ordinal).hexahedra) >= hexahedra(code)) return;
    complex::HexComplex mesh = fill::mesh_in(table, *ordinal, name);
    auto shelled = flips::in_shelling_order(mesh, kShellings, seed_for(code));
    const bool is_shelled = shelled.has_value();
    const auto origin = origins.find(code);
    found[i] =
        Found{is_shelled ? *std::move(shelled) : std::move(mesh),
              origin == origins.end() ? flips::FrontOrigin::known : origin->second, is_shelled};
  });
  std::size_t taken = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i]) {
      adopt(targets_[i], *found[i]);
      ++taken;
    }
  balls_.rewind();
  return taken;
}

void TableSearch::next_round() {
  phase_ = ++round_ >= options_.rounds ? Phase::finished : Phase::sweep;
  position_ = 0;
  balls_.rewind();
  symmetric_balls_.reset();
}

TableSearch::Progress TableSearch::progress() const {
  const std::string round = "round " + std::to_string(round_ + 1) + " of " +
                            std::to_string(std::max(options_.rounds, round_ + 1));
  if (phase_ == Phase::sweep)
    return {round + ", sweep", static_cast<std::size_t>(balls_.level()) + 1,
            static_cast<std::size_t>(options_.max_hexahedra)};
  constexpr std::array<std::string_view, 7> kNames{
      "sweep", "exchange", "cuts", "symmetric collars", "collars", "annealing", "end"};
  return {round + ", " + std::string(kNames[static_cast<std::size_t>(phase_)]), position_,
          targets_.size()};
}

const TableSearch::Loose* TableSearch::loose(const canon::Code& code) const {
  const auto at = loose_.find(code);
  if (at == loose_.end()) return nullptr;
  const auto level = balls_.first_level(code);
  return level && *level + 1 <= at->second.hexahedra ? nullptr : &at->second;
}

int TableSearch::hexahedra(const canon::Code& code) const {
  if (const Loose* own = loose(code)) return own->hexahedra;
  const auto level = balls_.first_level(code);
  return level ? *level + 1 : kNone;
}

flips::FrontOrigin TableSearch::origin(const canon::Code& code) const {
  if (const Loose* own = loose(code)) return own->origin;
  return balls_.origin_of(balls_.smallest(code).value());
}

complex::HexComplex TableSearch::unchecked_mesh(const canon::Code& code) const {
  if (const Loose* own = loose(code))
    return format::decode_record(own->record, canon::decode(code).value(), own->hexahedra).value();
  return flips::filling_of(balls_, balls_.smallest(code).value()).mesh;
}

std::vector<TableSearch::Row> TableSearch::rows() const {
  std::vector<Row> result;
  for (const canon::Code& code : targets_)
    if (const int count = hexahedra(code); count != kNone)
      result.push_back({code, count, origin(code)});
  return result;
}

std::vector<canon::Code> TableSearch::without_mesh() const {
  std::vector<canon::Code> result;
  std::copy_if(targets_.begin(), targets_.end(), std::back_inserter(result),
               [&](const canon::Code& code) { return hexahedra(code) == kNone; });
  return result;
}

complex::HexComplex TableSearch::mesh(const canon::Code& target) const {
  core::expects(hexahedra(target) != kNone, "the target has a mesh");
  complex::HexComplex mesh = unchecked_mesh(target);
  fill::ensure_fills(mesh, target);
  return mesh;
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
