// Claim. The promise of a cavity is the least number of hexahedra over all balls known and all
// their positions, scars in common at their price. Oracle. All balls, turned by all automorphisms
// of the boundary, found by where one dart goes.
#include "enum/flips/matching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::Dart;
using complex::Quadrangulation;

/// Where the vertices go if dart 0 goes to `to`, in the same sense of rotation or the other one.
std::optional<canon::Labelling> extended(const Quadrangulation& q, Dart to, bool is_mirrored) {
  // Mirrored, a dart goes to one that runs against it, so that `next` goes against `next`.
  std::vector<int> image(static_cast<std::size_t>(q.darts()), -1);
  std::vector<Dart> reached{0};
  image[0] = to;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Dart d = reached[i];
    const auto own = static_cast<Dart>(image[d]);
    for (const auto& [from, there] :
         {std::pair(Quadrangulation::next(d),
                    is_mirrored ? Quadrangulation::prev(own) : Quadrangulation::next(own)),
          std::pair(q.twin(d), q.twin(own))}) {
      if (image[from] >= 0 && image[from] != there) return std::nullopt;
      if (image[from] < 0) reached.push_back(from);
      image[from] = there;
    }
  }
  canon::Labelling result{};
  for (int d = 0; d < q.darts(); ++d) {
    const auto own = static_cast<Dart>(image[static_cast<std::size_t>(d)]);
    result[q.origin(static_cast<Dart>(d))] =
        q.origin(is_mirrored ? Quadrangulation::next(own) : own);
  }
  return result;
}

flips::Promise promise_by_all(const flips::Beam& beam, const flips::Cavity& cavity, int price) {
  const Quadrangulation q = canon::decode(cavity.state.code).value();
  flips::Promise least = flips::kNoPromise;
  for (int d = 0; d < q.darts(); ++d)
    for (const bool is_mirrored : {false, true}) {
      const auto turn = extended(q, static_cast<Dart>(d), is_mirrored);
      if (!turn) continue;
      for (const flips::FrontRecord& ball : beam.fronts_of(cavity.state.code)) {
        const int common = ball.scars.renamed(*turn).size_in_common(cavity.state.scars);
        least = std::min(
            least, static_cast<flips::Promise>(ball.level + 1 + cavity.collar + price * common));
      }
    }
  return least;
}

TEST(Matcher, PromisesTheLeastOverAllBallsAndPositions) {
  const flips::Beam beam = support::grown(22, 5, 400, 8);
  // The outside of a ball is like the inside of a collar: its states serve as cavities.
  std::vector<flips::Cavity> cavities;
  for (const flips::FrontId id : beam.frontier()) cavities.push_back({beam.state(id), 3});
  ASSERT_GT(cavities.size(), 100U);
  const flips::BeamBalls balls(beam);
  int conflicts = 0;
  for (const int price : {1, 2, 100}) {
    flips::Matcher matcher(balls, 1 << 14, 2);
    (void)matcher.match(cavities);
    const std::vector<flips::Promise> promises = matcher.promises(cavities, price);
    ASSERT_EQ(promises.size(), cavities.size());
    for (std::size_t i = 0; i < cavities.size(); ++i) {
      EXPECT_EQ(promises[i], promise_by_all(beam, cavities[i], price));
      conflicts += promises[i] >= 100 ? 1 : 0;
    }
  }
  EXPECT_GT(conflicts, 10) << "cavities that no ball fits";
}

TEST(Matcher, PromisesNothingWhereNoBallIsSmallEnough) {
  const flips::Beam beam = support::grown(16, 5, 50, 6);
  std::vector<flips::Cavity> cavities;
  for (const flips::FrontId id : beam.frontier()) cavities.push_back({beam.state(id), 3});
  const flips::BeamBalls balls(beam);
  flips::Matcher matcher(balls, 4, 1);
  (void)matcher.match(cavities);
  for (const flips::Promise promise : matcher.promises(cavities, 1))
    EXPECT_EQ(promise, flips::kNoPromise);
}

}  // namespace
