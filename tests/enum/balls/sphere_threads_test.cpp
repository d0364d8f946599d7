// Claim. Lists do not depend on the number of threads. Oracle. One thread.
#include <gtest/gtest.h>

#include "enum/balls/spheres_cells.hpp"

namespace {

using namespace hexatlas;

TEST(SphereThreads, SeveralThreadsGetTheListsOfOne) {
  const auto alone = balls::spheres(8);
  std::size_t reports = 0;
  const auto together =
      balls::spheres(8, {4, [&](int vertices, std::size_t found, std::size_t flipped) {
                           EXPECT_LE(vertices, 8);
                           EXPECT_LE(flipped, found);
                           ++reports;
                         }});
  EXPECT_EQ(together.found, alone.found);
  EXPECT_GE(reports, 3U);
  const auto balls_alone = balls::balls(alone);
  const auto balls_together = balls::balls(alone, 4);
  ASSERT_EQ(balls_together.size(), balls_alone.size());
  for (std::size_t i = 0; i < balls_alone.size(); ++i) {
    EXPECT_EQ(balls_together[i].triangulation, balls_alone[i].triangulation);
    EXPECT_EQ(balls_together[i].automorphisms, balls_alone[i].automorphisms);
  }
  const auto prism = *complex::cell_named("prism");
  const auto cells_alone = balls::triangulations_from(alone, prism);
  const auto cells_together = balls::triangulations_from(alone, prism, {}, 4);
  EXPECT_EQ(cells_together.labelled, cells_alone.labelled);
  ASSERT_EQ(cells_together.classes.size(), cells_alone.classes.size());
  for (std::size_t i = 0; i < cells_alone.classes.size(); ++i)
    EXPECT_EQ(cells_together.classes[i].triangulation, cells_alone.classes[i].triangulation);
}

}  // namespace
