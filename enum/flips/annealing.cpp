#include "enum/flips/annealing.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/flips/walk.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;
using core::Random;

/// exp(-1/T) and exp(-p/T) for temperatures T from 0.8 to 1.9 and prices p from 7 to 3: where
/// meshes of boundaries with 20 quads freeze, and where they melt (decision 0019). As numbers, so
/// that no two libraries' exponentials differ.
constexpr std::array<Climate, 8> kClimates{Climate(0.2865, 0.000158), Climate(0.3313, 0.00082),
                                           Climate(0.3767, 0.00327),  Climate(0.4220, 0.0104),
                                           Climate(0.4666, 0.0276),   Climate(0.5098, 0.0614),
                                           Climate(0.5513, 0.1193),   Climate(0.5908, 0.2062)};
constexpr int kStepsPerRound = 500;
constexpr std::size_t kTried = 4;  ///< of so many meshes one goes on

int size_of(const HexComplex& mesh) { return static_cast<int>(mesh.hexahedra.size()); }

/// A walk, and the least that it saw.
struct Walker {
  Walker(const HexComplex& mesh, int quads, const Beam& balls, std::uint64_t seed)
      : walk(mesh, quads, balls, seed), best(mesh), least_with_one_fault(size_of(mesh)) {}

  void go_on(const Climate& climate, BallLayers& layers) {
    for (int i = 0; i < kStepsPerRound; ++i) {
      if (!walk.step(climate, layers)) continue;
      const int size = size_of(walk.mesh());
      if (walk.faults() == 0 && size < size_of(best)) best = walk.mesh();
      if (walk.faults() == 1) least_with_one_fault = std::min(least_with_one_fault, size);
    }
  }

  Walk walk;
  HexComplex best;  ///< without faults
  int least_with_one_fault;
};

/// Whether two walks trade places, so that each mesh has its probability in each climate.
bool trade(const Walk& cold, const Climate& of_cold, const Walk& hot, const Climate& of_hot,
           Random& random) {
  const int more = size_of(hot.mesh()) - size_of(cold.mesh());
  const int faults = hot.faults() - cold.faults();
  return random.uniform() * of_hot.factor(more, faults) < of_cold.factor(more, faults);
}

/// Walks in all climates, begun with the same mesh.
class Tempering {
 public:
  Tempering(const HexComplex& mesh, int quads, const Beam& balls, std::uint64_t seed)
      : balls_(balls), random_(seed) {
    for (std::size_t i = 0; i < kClimates.size(); ++i) {
      walkers_.emplace_back(mesh, quads, balls, random_.number());
      at_[i] = i;
    }
  }

  void go_on(int rounds, int threads) {
    std::vector<BallLayers> layers(kClimates.size(), BallLayers(balls_));
    for (int round = 0; round < rounds; ++round) {
      parallel::parallel_for(threads, at_.size(), [&](std::size_t i) {
        walkers_[at_[i]].go_on(kClimates[i], layers[i]);
      });
      for (std::size_t i = at_.size() - 1; i-- > 0;)
        if (trade(walkers_[at_[i]].walk, kClimates[i], walkers_[at_[i + 1]].walk, kClimates[i + 1],
                  random_))
          std::swap(at_[i], at_[i + 1]);
    }
  }

  [[nodiscard]] const HexComplex& best() const {
    return std::min_element(
               walkers_.begin(), walkers_.end(),
               [](const Walker& a, const Walker& b) { return size_of(a.best) < size_of(b.best); })
        ->best;
  }
  /// The less, the more may be hoped for: a fault is often mended by a few hexahedra.
  [[nodiscard]] int promise() const {
    int with_one_fault = walkers_.front().least_with_one_fault;
    for (const Walker& walker : walkers_)
      with_one_fault = std::min(with_one_fault, walker.least_with_one_fault);
    return 3 * size_of(best()) + with_one_fault;
  }

 private:
  const Beam& balls_;
  Random random_;
  std::deque<Walker> walkers_;
  std::array<std::size_t, kClimates.size()> at_{};  ///< the walker in each climate
};

}  // namespace

HexComplex least_by_annealing(const std::vector<HexComplex>& starts, int quads, const Beam& balls,
                              const AnnealingOptions& options) {
  core::expects(!starts.empty(), "annealing begins with a mesh");
  Random random(options.seed);
  HexComplex least = starts.front();
  std::deque<Tempering> all;
  std::vector<Tempering*> live;
  live.reserve(starts.size());
  for (const HexComplex& mesh : starts)
    live.push_back(&all.emplace_back(mesh, quads, balls, random.number()));
  for (int rounds = options.rounds;; rounds *= 2) {
    const int inside = live.size() == 1 ? options.threads : 1;
    parallel::parallel_for(options.threads, live.size(),
                           [&](std::size_t i) { live[i]->go_on(rounds, inside); });
    for (const Tempering* each : live)
      if (size_of(each->best()) < size_of(least)) least = each->best();
    if (live.size() == 1) return least;
    std::stable_sort(live.begin(), live.end(), [](const Tempering* a, const Tempering* b) {
      return a->promise() < b->promise();
    });
    live.resize((live.size() + kTried - 1) / kTried);
  }
}

}  // namespace hexatlas::flips
