#include "tables/build/search.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "enum/complex/dual_class.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/annealing.hpp"
#include "enum/flips/cut.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/flips/symmetric_front.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/quads/generate.hpp"
#include "tables/fill/filled.hpp"
#include "tables/format/record.hpp"

namespace hexatlas::build {
namespace {

constexpr std::size_t kExchangesPerStep = 1024;
constexpr std::size_t kBoundariesPerStep = 32;  ///< of those that each get more
constexpr int kShellings = 10;                  ///< tries to find a shelling
constexpr int kNone = 1 << 14;                  ///< more than any mesh has

constexpr std::array<std::string_view, flips::kFrontOrigins> kOriginNames{"sweep", "exchange",
                                                                          "collar", "cut", "table"};

/// Whether a phase for the largest meshes is for boundaries like this one.
bool is_for(TableSearch::Phase phase, const canon::Code& code) {
  return phase != TableSearch::Phase::symmetric ||
         !flips::involutions_of(canon::decode(code).value()).empty();
}

/// How many boundaries get collars within one step. A search of wide collars takes long enough to
/// share it among the threads; that of narrow ones is for one thread. The step must not depend on
/// the number of threads: what is found at once does not know of each other.
std::size_t per_step(const flips::BeamOptions& collars) {
  constexpr std::size_t kWide = 10'000;
  return collars.fronts_per_level > kWide ? 1 : kBoundariesPerStep;
}

/// The same for annealing: about two minutes of two processors at most, or one boundary.
std::size_t annealed_per_step(const SearchOptions& options) {
  constexpr std::size_t kRounds = 5'000;
  const std::size_t rounds =
      2 * options.anneal_starts * static_cast<std::size_t>(options.anneal_rounds);
  return std::clamp<std::size_t>(kRounds / rounds, 1, kBoundariesPerStep);
}

/// A shared seed and number of threads.
SearchOptions adjusted(SearchOptions options) {
  for (flips::BeamOptions* own : {&options.symmetric, &options.collars}) {
    own->seed = options.balls.seed;
    own->threads = options.balls.threads;
  }
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

/// A phase for the largest meshes only, and for those without one.
void TableSearch::begin(Phase phase, std::size_t largest) {
  phase_ = phase;
  position_ = 0;
  std::vector<std::pair<int, const canon::Code*>> by_size;
  for (const canon::Code& code : targets_) by_size.emplace_back(hexahedra(code), &code);
  std::sort(by_size.rbegin(), by_size.rend());
  std::vector<int> sizes;  // of those that the phase is for, one more than wanted
  for (const auto& [size, code] : by_size) {
    if (sizes.size() > largest) break;
    if (is_for(phase, *code)) sizes.push_back(size);
  }
  const std::size_t count = std::min(largest, sizes.size());
  taken_from_ = count == 0 ? kNone + 1 : sizes[count - 1];
  // Ties would make more of them than asked for.
  if (count > 0 && count < sizes.size() && sizes[count] == taken_from_ &&
      sizes.front() > taken_from_)
    ++taken_from_;
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

TableSearch::Found TableSearch::smaller(const canon::Code& code, const complex::HexComplex& mesh,
                                        flips::FrontOrigin origin, int growths) const {
  Found found{mesh, origin};
  if (auto made = flips::smaller_by_replacement(
          mesh, code.quads, balls_, {growths, seed_for(code), false, options_.cut_uphill}))
    found = {*std::move(made), flips::FrontOrigin::exchanged};
  return found;
}

/// The least of what comes from the mesh known and from cuts, if it is any progress. A boundary
/// without a mesh gets one first, and more of the effort in later rounds.
std::optional<TableSearch::Found> TableSearch::cut(const canon::Code& code) const {
  constexpr int kWorthATry = 10;    // exchange may well take off so many
  constexpr int kWideCircle = 10;   // ten times the time of a circle of 8
  constexpr int kFewInteriors = 4;  // of more there are too many within wide circles
  const int known = hexahedra(code);
  const int growths = known == kNone ? options_.growths : options_.cut_growths;
  flips::CutOptions limits;
  limits.max_quads = options_.balls.max_quads;
  if (known != kNone && options_.cut_interior <= kFewInteriors) limits.max_circle = kWideCircle;
  limits.max_interior = options_.cut_interior;
  limits.below = known + kWorthATry;
  limits.count = known == kNone ? 1 : options_.cuts_each;
  std::vector<Found> candidates;
  for (const auto& mesh : flips::best_cuts(flips::BeamBalls(balls_), code, limits))
    candidates.push_back(smaller(code, mesh, flips::FrontOrigin::joined, growths));
  if (known != kNone)
    candidates.push_back(smaller(code, unchecked_mesh(code), origin(code), growths));
  const auto least =
      std::min_element(candidates.begin(), candidates.end(), [](const Found& a, const Found& b) {
        return a.mesh.hexahedra.size() < b.mesh.hexahedra.size();
      });
  if (least == candidates.end() || static_cast<int>(least->mesh.hexahedra.size()) >= known)
    return std::nullopt;
  return in_order(code, std::move(*least));
}

/// The same mesh, in the order of a shelling if one was found.
TableSearch::Found TableSearch::in_order(const canon::Code& code, Found found) const {
  if (found.is_shelled) return found;
  auto shelled = flips::in_shelling_order(found.mesh, kShellings, seed_for(code));
  if (shelled) found = {*std::move(shelled), found.origin, true};
  return found;
}

void TableSearch::cut_step() {
  const auto batch = next_largest(kBoundariesPerStep);
  if (batch.empty()) return begin(Phase::symmetric, options_.symmetrized);
  adopt_all(batch, [&](const canon::Code& code, int) { return cut(code); });
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
    complex::HexComplex mesh = table.mesh(*ordinal);
    if (const auto reason = fill::reason_against(mesh, code))
      throw core::InvalidInput(name, "the mesh of " + canon::to_text(code) + ": " + *reason);
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

/// The next targets of a phase for the largest, at most so many; none at its end.
std::vector<const canon::Code*> TableSearch::next_largest(std::size_t count) {
  std::vector<const canon::Code*> result;
  for (; position_ < targets_.size() && result.size() < count; ++position_) {
    const canon::Code& code = targets_[position_];
    if (hexahedra(code) >= taken_from_ && is_for(phase_, code)) result.push_back(&code);
  }
  return result;
}

/// Collars that make fewer than `below` hexahedra, by so many threads.
flips::MeetingOptions TableSearch::collars_for(int below, int threads) const {
  flips::MeetingOptions result{
      .collars = options_.collars, .max_collar = options_.max_collar, .below = below};
  result.collars.threads = threads;
  return result;
}

flips::MeetingOptions TableSearch::symmetric_collars_for(const canon::Code& code, int below,
                                                         int threads) const {
  flips::MeetingOptions result{
      .collars = options_.symmetric, .max_collar = options_.max_symmetric, .below = below};
  result.collars.seed = seed_for(code);  // others in each round
  result.collars.threads = threads;
  return result;
}

void TableSearch::symmetric_step() {
  const auto batch = next_largest(per_step(options_.symmetric));
  if (batch.empty()) return begin(Phase::collars, options_.collared);
  adopt_all(batch, [&](const canon::Code& code, int threads) -> std::optional<Found> {
    auto filling = flips::best_symmetric_meeting(
        flips::BeamBalls(balls_), code, symmetric_collars_for(code, hexahedra(code), threads));
    if (!filling) return std::nullopt;
    const bool is_shelled = flips::widest_boundary(filling->mesh) <= flips::kMaxStateQuads;
    return in_order(code, {std::move(filling->mesh), flips::FrontOrigin::met, is_shelled});
  });
}

void TableSearch::collar_step() {
  const auto batch = next_largest(per_step(options_.collars));
  if (batch.empty()) return begin(Phase::annealing, options_.annealed);
  adopt_all(batch, [&](const canon::Code& code, int threads) -> std::optional<Found> {
    auto filling =
        flips::best_meeting(flips::BeamBalls(balls_), code, collars_for(hexahedra(code), threads));
    if (!filling) return std::nullopt;
    return Found{std::move(filling->mesh), flips::FrontOrigin::met, true};
  });
}

/// Meshes to begin annealing with: the known one, and others by collars with a symmetry or without.
std::vector<complex::HexComplex> TableSearch::beginnings(const canon::Code& code,
                                                         int threads) const {
  constexpr int kWorthATry = 40;  // annealing may well take off so many
  std::vector<complex::HexComplex> result;
  const int known = hexahedra(code);
  if (known != kNone) result.push_back(unchecked_mesh(code));
  const std::size_t wanted = options_.anneal_starts;
  if (known != kNone && wanted == 1) return result;
  flips::MeetingOptions plain = collars_for(known + kWorthATry, threads);
  plain.collars.seed = seed_for(code);  // others in each round
  for (auto& filling : flips::varied_meetings(balls_, code, plain))
    result.push_back(std::move(filling.mesh));
  for (auto& filling : flips::varied_symmetric_meetings(
           balls_, code, symmetric_collars_for(code, known + kWorthATry, threads)))
    result.push_back(std::move(filling.mesh));
  const auto on_boundary = static_cast<complex::VertexId>(code.quads + 2);
  result = complex::spread_over_dual_classes(std::move(result), on_boundary);
  if (result.size() > wanted) result.resize(wanted);
  return result;
}

void TableSearch::anneal_step() {
  const auto batch = next_largest(annealed_per_step(options_));
  if (batch.empty()) return next_round();
  adopt_all(batch, [&](const canon::Code& code, int threads) -> std::optional<Found> {
    const std::vector<complex::HexComplex> starts = beginnings(code, threads);
    if (starts.empty()) return std::nullopt;
    auto mesh = flips::least_by_annealing(
        starts, code.quads, balls_,
        {.rounds = options_.anneal_rounds, .seed = seed_for(code), .threads = threads});
    if (static_cast<int>(mesh.hexahedra.size()) >= hexahedra(code)) return std::nullopt;
    return in_order(code, {std::move(mesh), flips::FrontOrigin::exchanged});
  });
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
