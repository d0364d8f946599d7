// Claim. report() counts the cells by their verdict and takes the least and the mean shape.
// Oracle. A mesh put together from cells whose verdict and shape are known by hand.
#include "meshing/quality/report.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "enum/core/errors.hpp"

namespace {

using namespace hexatlas;

/// Appends the box with the given height over the unit square.
void append_box(mesh::HexMesh& mesh, double height) {
  std::array<mesh::Index, 8> cell{};
  for (std::size_t v = 0; v < 8; ++v) {
    cell[v] = static_cast<mesh::Index>(mesh.points.size());
    mesh.points.push_back({v & 1U ? 1.0 : 0.0, v & 2U ? 1.0 : 0.0, v & 4U ? height : 0.0});
  }
  mesh.hexahedra.push_back(cell);
}

TEST(Report, CountsByVerdict) {
  mesh::HexMesh mesh;
  append_box(mesh, 1);   // valid, 1
  append_box(mesh, 4);   // valid, 1
  append_box(mesh, 0);   // invalid and inverted, 0
  append_box(mesh, -1);  // invalid and inverted, -1
  append_box(mesh, 1);   // valid; corner 7 raised: 1/2 there
  mesh.points[mesh.hexahedra.back()[7]] = {1, 1, 2};
  const quality::Report r = quality::report(mesh);
  EXPECT_EQ(r.hexahedra, 5U);
  EXPECT_EQ(r.valid, 3U);
  EXPECT_EQ(r.invalid, 2U);
  EXPECT_EQ(r.undecided, 0U);
  EXPECT_EQ(r.inverted, 2U);
  EXPECT_EQ(r.exact_decisions, 1U);  // the flat box
  EXPECT_DOUBLE_EQ(r.min_scaled_jacobian, -1);
  EXPECT_NEAR(r.mean_scaled_jacobian, (1 + 1 + 0 - 1 + 0.5) / 5, 1e-15);
  EXPECT_EQ(r.histogram[0], 2U);                   // 0 and -1
  EXPECT_EQ(r.histogram[9], 2U);                   // 1, twice
  EXPECT_EQ(r.histogram[4] + r.histogram[5], 1U);  // 1/2 up to rounding
}

TEST(Report, OfNothing) {
  const quality::Report r = quality::report({});
  EXPECT_EQ(r.hexahedra, 0U);
  EXPECT_EQ(r.min_scaled_jacobian, 0);
  EXPECT_EQ(r.mean_scaled_jacobian, 0);
}

TEST(Report, RefusesAnIndexOutOfRange) {
  mesh::HexMesh mesh;
  append_box(mesh, 1);
  mesh.hexahedra[0][3] = 8;
  EXPECT_THROW((void)quality::report(mesh), core::PreconditionViolated);
}

}  // namespace
