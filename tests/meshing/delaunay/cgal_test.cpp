// Claim. The tetrahedra are those of CGAL's Delaunay triangulation where it is unique; elsewhere
// they are the same but for ties: unions of tetrahedra with the same sphere agree.
// Oracle. CGAL, an independent program: its points, its predicates, its triangulation.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "meshing/delaunay/triangulation.hpp"
#include "tests/meshing/delaunay/cgal_cells.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/oracle.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Triangulation;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Structure = CGAL::Triangulation_data_structure_3<
    CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>>;
using Cgal = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
using Index = std::uint32_t;

/// A point is inserted if it is the first at its place.
Cgal cgal_of(const Cloud& points) {
  Cgal result;
  for (Index i = 0; i < points.size(); ++i) {
    const std::size_t before = result.number_of_vertices();
    const auto vertex = result.insert({points[i].x, points[i].y, points[i].z});
    if (result.number_of_vertices() > before) vertex->info() = i;
  }
  return result;
}

/// Tetrahedra that are neighbours and have one sphere are one Delaunay cell: its vertices.
std::set<std::set<Index>> cells_of(const Cloud& points, const Tetrahedra& mesh) {
  std::vector<std::size_t> parent(mesh.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  const auto at = [&](Index v) { return Kernel::Point_3(points[v].x, points[v].y, points[v].z); };
  std::map<std::set<Index>, std::size_t> owner;
  for (std::size_t k = 0; k < mesh.size(); ++k)
    for (const Index apex : mesh[k]) {
      std::set<Index> facet(mesh[k].begin(), mesh[k].end());
      facet.erase(apex);
      const auto [other, is_new] = owner.emplace(facet, k);
      if (is_new) continue;
      const auto& t = mesh[other->second];
      if (CGAL::side_of_oriented_sphere(at(t[0]), at(t[1]), at(t[2]), at(t[3]), at(apex)) ==
          CGAL::ON_ORIENTED_BOUNDARY)
        parent[root(k)] = root(other->second);
    }
  std::map<std::size_t, std::set<Index>> cells;
  for (std::size_t k = 0; k < mesh.size(); ++k)
    cells[root(k)].insert(mesh[k].begin(), mesh[k].end());
  std::set<std::set<Index>> result;
  for (const auto& [representative, vertices] : cells) result.insert(vertices);
  return result;
}

struct Tally {
  std::size_t solid = 0, unique = 0, differ = 0;
};

void compare(const Cloud& points, Tally& tally) {
  const Triangulation made(points);
  const Cgal cgal = cgal_of(points);
  ASSERT_EQ(made.dimension(), cgal.dimension());
  ASSERT_EQ(made.points() - made.duplicates(), cgal.number_of_vertices());
  if (made.dimension() < 3) return;
  ASSERT_TRUE(cgal.is_valid());
  const Tetrahedra ours = made.tetrahedra(), theirs = tetrahedra_of(cgal);
  const auto cells = cells_of(points, theirs);
  ASSERT_EQ(cells_of(points, ours), cells);
  ++tally.solid;
  if (ours != theirs) ++tally.differ;
  if (cells.size() == theirs.size()) {
    ++tally.unique;
    ASSERT_EQ(ours, theirs);
  }
}

TEST(Cgal, AgreesOnSmallSets) {
  Random random(20261281);
  Tally tally;
  for (std::size_t trial = 0; trial < 10000; ++trial) {
    const double step = trial / 8 % 3 == 0 ? 0.1 : 1;
    compare(real(small_set(trial, trial % 10 == 0 ? 40 : 16, random), step), tally);
    if (HasFatalFailure()) FAIL() << "trial " << trial;
  }
  EXPECT_GT(tally.solid, 9000U);
  EXPECT_GT(tally.unique, 2000U);
  EXPECT_LT(tally.unique, 8000U);
}

TEST(Cgal, AgreesOnSomeThousandPoints) {
  Random random(20261282);
  Tally tally;
  for (const Cloud& points :
       {uniform(3000, random), clusters(2000, random), sphere(2000, random), grid(10, 1),
        grid(10, 0.1), helix(150, 2), with_duplicates(uniform(1000, random), random)})
    compare(points, tally);
  EXPECT_EQ(tally.solid, 7U);
  EXPECT_GE(tally.unique, 3U);
}

}  // namespace
