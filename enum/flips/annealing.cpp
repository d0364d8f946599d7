#include "enum/flips/annealing.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <utility>

#include "enum/complex/dual_class.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/mesh_involution.hpp"
#include "enum/flips/symmetric_walk.hpp"
#include "enum/flips/walk.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;
using core::Random;

/// exp(-1/T) and exp(-p/T) for temperatures T and prices p of a fault: T = 0.9 with p = 6.4, cold
/// enough to freeze a mesh of a boundary with 20 quads, and T = 1.3 with p = 4.7, which keeps it
/// from sticking (decisions 0019 and 0024). As numbers, so that no two libraries' exponentials
/// differ.
constexpr std::array<Climate, 2> kClimates{Climate(0.3313, 0.00082), Climate(0.4666, 0.0276)};
/// T = 1.9 and p = 3: a leap may cost much.
constexpr Climate kOfLeaps(0.5908, 0.2062);
constexpr int kStepsPerRound = 500;
constexpr int kFarAbove = 12;      ///< hexahedra more than the least mesh: no leap from there
constexpr int kTriesToLeap = 300;  ///< where none of them helps, hardly any will

int size_of(const HexComplex& mesh) { return static_cast<int>(mesh.hexahedra.size()); }

using Mesh = std::optional<HexComplex>;

/// Whether the mesh has fewer hexahedra than the other one, if there is any.
bool is_smaller(const HexComplex& mesh, const Mesh& other) {
  return !other || size_of(mesh) < size_of(*other);
}

/// A walk, and the least mesh without faults that it saw.
template <class Walk>
struct Walker {
  template <class Make>
  explicit Walker(const Make& make) : walk(make()) {
    if (walk.faults() == 0) best = walk.mesh();
  }

  void go_on(const Climate& climate, BallLayers& layers) {
    for (int i = 0; i < kStepsPerRound; ++i) {
      if (!walk.step(climate, layers) || walk.faults() > 0) continue;
      if (is_smaller(walk.mesh(), best)) best = walk.mesh();
    }
  }

  Walk walk;
  Mesh best;
};

/// Whether two walks trade places, so that each mesh has its probability in each climate.
template <class Walk>
bool trade(const Walk& cold, const Climate& of_cold, const Walk& hot, const Climate& of_hot,
           Random& random) {
  const int more = size_of(hot.mesh()) - size_of(cold.mesh());
  const int faults = hot.faults() - cold.faults();
  return random.uniform() * of_hot.factor(more, faults) < of_cold.factor(more, faults);
}

/// The least mesh without faults that walks in all climates see. `walk_of(seed)`: one of them at
/// its beginning; `layers`: for each climate.
template <class WalkOf>
Mesh tempered(WalkOf&& walk_of, int rounds, int threads, Random& random,
              std::vector<BallLayers>& layers) {
  using Own = Walker<decltype(walk_of(std::uint64_t{}))>;
  std::deque<Own> walkers;
  std::array<Own*, kClimates.size()> at{};  // the walker in each climate
  for (Own*& own : at) {
    const std::uint64_t seed = random.number();
    own = &walkers.emplace_back([&] { return walk_of(seed); });
  }
  for (int round = 0; round < rounds; ++round) {
    parallel::parallel_for(threads, at.size(),
                           [&](std::size_t i) { at[i]->go_on(kClimates[i], layers[i]); });
    for (std::size_t i = at.size() - 1; i-- > 0;)
      if (trade(at[i]->walk, kClimates[i], at[i + 1]->walk, kClimates[i + 1], random))
        std::swap(at[i], at[i + 1]);
  }
  Mesh least;
  for (Own& walker : walkers)
    if (walker.best && is_smaller(*walker.best, least)) least = std::move(walker.best);
  return least;
}

/// The involutions of a mesh's boundary, whose vertices are 0 .. quads+1.
std::vector<Involution> involutions_of_boundary(const HexComplex& mesh) {
  std::vector<complex::QuadVertices> quads;
  for (const complex::BoundaryQuad& quad : complex::boundary_of(mesh)) {
    complex::QuadVertices& own = quads.emplace_back();
    for (std::size_t i = 0; i < own.size(); ++i) own[i] = static_cast<complex::Vertex>(quad[i]);
  }
  return involutions_of(complex::Quadrangulation::from_quads(quads).value());
}

/// The least mesh known of each dual class, relative to the first of all meshes.
class LeastOfClasses {
 public:
  LeastOfClasses(const HexComplex& reference, int quads)
      : reference_(reference), shared_(static_cast<complex::VertexId>(quads + 2)) {}

  void put(HexComplex mesh) {
    Mesh& own = of_class_[static_cast<std::size_t>(complex::dual_class(mesh, reference_, shared_))];
    if (is_smaller(mesh, own)) own = std::move(mesh);
  }
  [[nodiscard]] const HexComplex& least() const {
    const Mesh* result = &of_class_[0];
    for (const Mesh& mesh : of_class_)
      if (mesh && is_smaller(*mesh, *result)) result = &mesh;
    return result->value();
  }
  /// One of those that are not much larger than the least one.
  [[nodiscard]] const HexComplex& some(Random& random) const {
    std::vector<const HexComplex*> near;
    const int most = size_of(least()) + kFarAbove;
    for (const Mesh& mesh : of_class_)
      if (mesh && size_of(*mesh) <= most) near.push_back(&*mesh);
    return *near[random.below(near.size())];
  }

 private:
  const HexComplex& reference_;
  complex::VertexId shared_;
  std::array<Mesh, 8> of_class_;
};

}  // namespace

HexComplex least_by_annealing(const Beginnings& begin, int quads, const Beam& balls,
                              const AnnealingOptions& options) {
  core::expects(!begin.strict.empty(), "annealing begins with a mesh");
  Random random(options.seed);
  std::vector<BallLayers> layers(kClimates.size(), BallLayers(balls));
  LeastOfClasses least(begin.strict.front(), quads);
  const auto anneal = [&](const HexComplex& mesh, int faults) {
    const auto walk_of = [&](std::uint64_t seed) { return Walk(mesh, quads, balls, seed, faults); };
    if (Mesh found = tempered(walk_of, options.rounds, options.threads, random, layers))
      least.put(*std::move(found));
  };
  std::vector<Involution> involutions;
  if (options.symmetric_rounds > 0) involutions = involutions_of_boundary(begin.strict.front());
  const auto begin_with = [&](const HexComplex& mesh, int faults) {
    anneal(mesh, faults);
    for (const Involution& involution : involutions) {
      if (!extended(involution, mesh, quads, SubBall::neighbours_of(mesh))) continue;
      const auto walk_of = [&](std::uint64_t seed) {
        return SymmetricWalk(mesh, quads, involution, balls, options.symmetric, seed);
      };
      if (Mesh found = tempered(walk_of, options.symmetric_rounds, options.threads, random, layers))
        anneal(*found, 0);
    }
  };
  for (const HexComplex& mesh : begin.strict) begin_with(mesh, 0);
  for (const FaultyMesh& own : begin.faulty) begin_with(own.mesh, own.faults);
  for (int i = 0; i < options.leaps; ++i) {
    Walk walk(least.some(random), quads, balls, random.number());
    const auto kind = random.below(2) == 0 ? Walk::Leap::any_other : Walk::Leap::other_parity;
    if (walk.leap(kOfLeaps, layers.back(), kTriesToLeap, kind)) anneal(walk.mesh(), walk.faults());
  }
  return least.least();
}

}  // namespace hexatlas::flips
