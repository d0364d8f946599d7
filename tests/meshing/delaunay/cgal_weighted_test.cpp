// Claim. With weights the tetrahedra, and the vertices, are those of CGAL's regular triangulation,
// of points in general position.
// Oracle. CGAL, an independent program. Coordinates and weights are random doubles, so that ties
// are out of the question; what is random is checked not to be one.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
using Vertices =
    CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Structure =
    CGAL::Triangulation_data_structure_3<Vertices, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Cgal = CGAL::Regular_triangulation_3<Kernel, Structure>;
using Index = std::uint32_t;

Cgal cgal_of(const Cloud& points, const std::vector<double>& weights) {
  Cgal result;
  for (Index i = 0; i < points.size(); ++i) {
    const Kernel::Point_3 place(points[i].x, points[i].y, points[i].z);
    const auto vertex = result.insert(Kernel::Weighted_point_3(place, weights[i]));
    if (vertex != Cgal::Vertex_handle()) vertex->info() = i;
  }
  return result;
}

void compare(const Cloud& points, const std::vector<double>& weights, std::size_t& hidden) {
  const Triangulation made(points, weights);
  const Cgal cgal = cgal_of(points, weights);
  ASSERT_EQ(made.dimension(), 3);
  ASSERT_EQ(made.tetrahedra(), tetrahedra_of(cgal));
  ASSERT_EQ(made.duplicates(), 0U);
  ASSERT_EQ(made.points() - made.hidden().size(), cgal.number_of_vertices());
  hidden += made.hidden().size();
}

/// A share of the points has weights of this size, the others a hundredth of it.
std::vector<double> weights_of(std::size_t count, double size, Random& random) {
  std::vector<double> weights(count);
  for (double& w : weights) w = (random() % 4 == 0 ? size : size / 100) * (2 * unit(random) - 1);
  return weights;
}

TEST(CgalWeighted, AgreesOnSmallSets) {
  Random random(20261621);
  std::size_t hidden = 0, points = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Cloud cloud = uniform(4 + random() % 30, random, 1, 1, trial % 3 == 0 ? 0.01 : 1);
    const double size = std::array{1e-3, 0.1, 1.0, 1e6}[trial % 4];
    compare(cloud, weights_of(cloud.size(), size, random), hidden);
    if (HasFatalFailure()) FAIL() << "trial " << trial;
    points += cloud.size();
  }
  EXPECT_GT(hidden, points / 10);
  EXPECT_LT(hidden, points / 2);
}

TEST(CgalWeighted, AgreesOnSomeThousandPoints) {
  Random random(20261622);
  std::size_t hidden = 0;
  for (const double size : {1e-4, 1e-2, 1.0})
    for (const Cloud& points :
         {uniform(3000, random), clusters(1500, random), sphere(1500, random)})
      compare(points, weights_of(points.size(), size, random), hidden);
  EXPECT_GT(hidden, 3000U);
}

}  // namespace
