// Claim. untangled() gives the same points for any number of threads: for meshes treated as a
// whole, from several starts, and in parts. Oracle. One thread.
#include <gtest/gtest.h>

#include "realize/untangle/untangle.hpp"
#include "tests/realize/untangle/grids.hpp"

namespace hexatlas::untangle {
namespace {

void expect_same(const Mesh& mesh, int effort, bool as_given) {
  const auto points =
      untangled(mesh, {.effort = effort, .threads = 1, .starts_as_given = as_given});
  EXPECT_EQ(points, untangled(mesh, {.effort = effort, .threads = 3, .starts_as_given = as_given}));
}

TEST(UntangleThreads, AMeshTreatedAsAWhole) {
  support::Random random(1);
  Mesh mesh = grids::cubes(6);
  grids::scatter(mesh, 6, random);
  expect_same(mesh, 1, true);
}

TEST(UntangleThreads, SeveralStarts) {
  Mesh mesh = grids::cubes(3);
  std::swap(mesh.points.front(), mesh.points.back());
  expect_same(mesh, 1, false);
}

TEST(UntangleThreads, AMeshInParts) {
  support::Random random(2);
  Mesh mesh = grids::cubes(28);
  for (std::size_t v = 0; v < mesh.points.size(); v += 4999)
    if (mesh.is_free[v] != 0) mesh.points[v].x += 1.7;
  expect_same(mesh, 1, true);
}

}  // namespace
}  // namespace hexatlas::untangle
