#include "enum/flips/annealing.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <utility>

#include "enum/complex/dual_class.hpp"
#include "enum/core/checks.hpp"
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
struct Walker {
  Walker(const HexComplex& mesh, int faults, int quads, const Beam& balls, std::uint64_t seed)
      : walk(mesh, quads, balls, seed, faults) {
    if (faults == 0) best = mesh;
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
bool trade(const Walk& cold, const Climate& of_cold, const Walk& hot, const Climate& of_hot,
           Random& random) {
  const int more = size_of(hot.mesh()) - size_of(cold.mesh());
  const int faults = hot.faults() - cold.faults();
  return random.uniform() * of_hot.factor(more, faults) < of_cold.factor(more, faults);
}

/// The least mesh without faults that walks in all climates see, begun with the same mesh.
/// `layers`: for each climate.
Mesh tempered(const HexComplex& mesh, int faults, int quads, const Beam& balls, int rounds,
              int threads, Random& random, std::vector<BallLayers>& layers) {
  std::deque<Walker> walkers;
  std::array<Walker*, kClimates.size()> at{};  // the walker in each climate
  for (Walker*& own : at) own = &walkers.emplace_back(mesh, faults, quads, balls, random.number());
  for (int round = 0; round < rounds; ++round) {
    parallel::parallel_for(threads, at.size(),
                           [&](std::size_t i) { at[i]->go_on(kClimates[i], layers[i]); });
    for (std::size_t i = at.size() - 1; i-- > 0;)
      if (trade(at[i]->walk, kClimates[i], at[i + 1]->walk, kClimates[i + 1], random))
        std::swap(at[i], at[i + 1]);
  }
  Mesh least;
  for (Walker& walker : walkers)
    if (walker.best && is_smaller(*walker.best, least)) least = std::move(walker.best);
  return least;
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
    if (Mesh found =
            tempered(mesh, faults, quads, balls, options.rounds, options.threads, random, layers))
      least.put(*std::move(found));
  };
  for (const HexComplex& mesh : begin.strict) anneal(mesh, 0);
  for (const FaultyMesh& own : begin.faulty) anneal(own.mesh, own.faults);
  for (int i = 0; i < options.leaps; ++i) {
    Walk walk(least.some(random), quads, balls, random.number());
    const auto kind = random.below(2) == 0 ? Walk::Leap::any_other : Walk::Leap::other_parity;
    if (walk.leap(kOfLeaps, layers.back(), kTriesToLeap, kind)) anneal(walk.mesh(), walk.faults());
  }
  return least.least();
}

}  // namespace hexatlas::flips
