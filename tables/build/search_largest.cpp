// The phases of a search that are for the largest meshes only, and for boundaries without one.
#include <algorithm>
#include <utility>

#include "enum/complex/dual_class.hpp"
#include "enum/flips/annealing.hpp"
#include "enum/flips/cut.hpp"
#include "enum/flips/faulty_cut.hpp"
#include "enum/flips/faulty_meeting.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/flips/symmetric_front.hpp"
#include "enum/flips/transplant.hpp"
#include "tables/build/search.hpp"

namespace hexatlas::build {
namespace {

constexpr std::size_t kBoundariesPerStep = 32;

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
  constexpr std::size_t kRounds = 20'000;
  constexpr std::size_t kCostOfSymmetric = 8;  // rounds that one of these takes as long as
  const std::size_t rounds =
      (options.anneal_starts + 3 * options.anneal_faulty + options.anneal_cut +
       options.anneal_transplant + static_cast<std::size_t>(options.anneal_leaps)) *
      static_cast<std::size_t>(options.anneal_rounds);
  const std::size_t symmetric_rounds = (options.anneal_starts + 2 * options.anneal_faulty) *
                                       static_cast<std::size_t>(options.anneal_symmetric);
  return std::clamp<std::size_t>(kRounds / (rounds + kCostOfSymmetric * symmetric_rounds), 1,
                                 kBoundariesPerStep);
}

}  // namespace

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

/// The next targets of a phase for the largest, at most so many; none at its end.
std::vector<const canon::Code*> TableSearch::next_largest(std::size_t count) {
  std::vector<const canon::Code*> result;
  for (; position_ < targets_.size() && result.size() < count; ++position_) {
    const canon::Code& code = targets_[position_];
    if (hexahedra(code) >= taken_from_ && is_for(phase_, code)) result.push_back(&code);
  }
  return result;
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

void TableSearch::cut_step() {
  const auto batch = next_largest(kBoundariesPerStep);
  if (batch.empty()) return begin(Phase::symmetric, options_.symmetrized);
  adopt_all(batch, [&](const canon::Code& code, int) { return cut(code); });
}

/// Collars that make fewer than `below` hexahedra, by so many threads.
flips::MeetingOptions TableSearch::collars_for(int below, int threads) const {
  flips::MeetingOptions result{.collars = options_.collars,
                               .max_collar = options_.max_collar,
                               .below = below,
                               .guided = options_.guided};
  result.collars.threads = threads;
  return result;
}

flips::MeetingOptions TableSearch::symmetric_collars_for(const canon::Code& code, int below,
                                                         int threads) const {
  flips::MeetingOptions result{.collars = options_.symmetric,
                               .max_collar = options_.max_symmetric,
                               .below = below,
                               .guided = options_.guided};
  result.collars.seed = seed_for(code);  // others in each round
  result.collars.threads = threads;
  return result;
}

/// What a ball and a collar make. One that goes through long boundaries is no shelling for a Beam.
TableSearch::Found TableSearch::met(const canon::Code& code, complex::HexComplex mesh) const {
  const bool is_shelled = flips::widest_boundary(mesh) <= flips::kMaxStateQuads;
  return in_order(code, {std::move(mesh), flips::FrontOrigin::met, is_shelled});
}

/// They are grown in the step that needs them first, so that a search which is taken up again gets
/// on even if it is stopped after every step.
const flips::SymmetricBalls* TableSearch::symmetric_balls() {
  if (options_.max_symmetric_ball == 0) return nullptr;
  if (!symmetric_balls_)
    symmetric_balls_.emplace(options_.symmetric_balls, options_.max_symmetric_ball);
  return &*symmetric_balls_;
}

void TableSearch::symmetric_step() {
  const auto batch = next_largest(per_step(options_.symmetric));
  if (batch.empty()) return begin(Phase::collars, options_.collared);
  const flips::SymmetricBalls* symmetric = symmetric_balls();
  adopt_all(batch, [&](const canon::Code& code, int threads) -> std::optional<Found> {
    auto filling = flips::best_symmetric_meeting(
        flips::BeamBalls(balls_), code, symmetric_collars_for(code, hexahedra(code), threads),
        symmetric);
    if (!filling) return std::nullopt;
    return met(code, std::move(filling->mesh));
  });
}

void TableSearch::collar_step() {
  const auto batch = next_largest(per_step(options_.collars));
  if (batch.empty()) return begin(Phase::annealing, options_.annealed);
  adopt_all(batch, [&](const canon::Code& code, int threads) -> std::optional<Found> {
    auto filling =
        flips::best_meeting(flips::BeamBalls(balls_), code, collars_for(hexahedra(code), threads));
    if (!filling) return std::nullopt;
    return met(code, std::move(filling->mesh));
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

/// Meshes of this boundary with parts of meshes of others, of fewer hexahedra and faults than this.
std::vector<flips::FaultyMesh> TableSearch::transplants(const canon::Code& code, int below,
                                                        int threads) const {
  constexpr std::size_t kTriesEach = 200;
  const flips::MeshSource known = [&](const canon::Code& boundary, int most) {
    return hexahedra(boundary) < most ? std::optional(unchecked_mesh(boundary)) : std::nullopt;
  };
  flips::TransplantOptions options{.tries = kTriesEach * options_.anneal_transplant,
                                   .wanted = {.below = below, .count = options_.anneal_transplant},
                                   .seed = seed_for(code),
                                   .threads = threads};
  return flips::transplants(balls_, known, code, options);
}

/// Meshes of this boundary with a few faults, not much larger than one with so many hexahedra.
std::vector<flips::FaultyMesh> TableSearch::faulty_beginnings(
    const canon::Code& code, int size, int threads, const flips::SymmetricBalls* symmetric) const {
  constexpr int kWorthATry = 5;  // hexahedra, faults at their price
  std::vector<flips::FaultyMesh> result;
  const auto add = [&](std::vector<flips::FaultyMesh> meshes) {
    for (auto& mesh : meshes) result.push_back(std::move(mesh));
  };
  const auto meetings = [&](const flips::MeetingOptions& strict) {
    return flips::FaultyMeetingOptions{
        .collars = strict.collars,
        .max_collar = strict.max_collar,
        .wanted = {.below = strict.below, .count = options_.anneal_faulty},
        .guided = strict.guided};
  };
  if (options_.anneal_faulty > 0) {
    flips::FaultyMeetingOptions plain = meetings(collars_for(size + kWorthATry, threads));
    plain.collars.seed = seed_for(code);  // others in each round
    add(flips::faulty_meetings(balls_, code, plain));
    add(flips::faulty_symmetric_meetings(
        balls_, code, meetings(symmetric_collars_for(code, size + kWorthATry, threads)),
        symmetric));
  }
  if (options_.anneal_cut > 0) {
    flips::FaultyCutOptions options{
        .wanted = {.below = size + kWorthATry, .count = options_.anneal_cut}};
    options.collars.seed = seed_for(code);
    options.collars.threads = threads;
    add(flips::faulty_cuts(balls_, code, options));
  }
  if (options_.anneal_transplant > 0) add(transplants(code, size + kWorthATry, threads));
  return result;
}

void TableSearch::anneal_step() {
  const auto batch = next_largest(annealed_per_step(options_));
  if (batch.empty()) return next_round();
  const flips::SymmetricBalls* symmetric = options_.anneal_faulty > 0 ? symmetric_balls() : nullptr;
  adopt_all(batch, [&](const canon::Code& code, int threads) -> std::optional<Found> {
    flips::Beginnings begin{beginnings(code, threads), {}};
    if (begin.strict.empty()) return std::nullopt;
    const int size = static_cast<int>(begin.strict.front().hexahedra.size());
    begin.faulty = faulty_beginnings(code, size, threads, symmetric);
    auto mesh = flips::least_by_annealing(begin, code.quads, balls_,
                                          {.rounds = options_.anneal_rounds,
                                           .leaps = options_.anneal_leaps,
                                           .seed = seed_for(code),
                                           .threads = threads,
                                           .symmetric_rounds = options_.anneal_symmetric,
                                           .symmetric = symmetric});
    if (static_cast<int>(mesh.hexahedra.size()) >= hexahedra(code)) return std::nullopt;
    return in_order(code, {std::move(mesh), flips::FrontOrigin::exchanged});
  });
}

}  // namespace hexatlas::build
