// Claim. report() counts the cells by their verdict, takes the least and the mean shape, and adds
// up the volumes; of a hybrid mesh, for each shape by itself.
// Oracle. A mesh put together from cells whose verdict and shape are known by hand; many cells one
// by one; a cube cut into cells of four shapes.
#include "meshing/quality/report.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "enum/core/errors.hpp"
#include "meshing/quality/volume.hpp"

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
  EXPECT_EQ(r.cells, 5U);
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

/// More hexahedra than a batch, of all verdicts.
TEST(Report, AgreesWithOneByOne) {
  std::mt19937_64 random(20261204);
  std::uniform_int_distribution<int> move(-3, 3);
  mesh::HexMesh mesh;
  for (int cell = 0; cell < 700; ++cell) {
    append_box(mesh, 1);
    for (std::size_t v = 0; v < 8; ++v) {
      mesh::Point& p = mesh.points[mesh.hexahedra.back()[v]];
      p = {8 * p.x + move(random), 8 * p.y + move(random), 8 * p.z + move(random)};
    }
  }
  quality::Report expected;
  for (const auto& cell : mesh.hexahedra) {
    const auto corners = quality::corners_of<8>(mesh.points, cell);
    const quality::Verdict verdict = quality::verdict_of_hexahedron(corners);
    expected.valid += verdict.validity == quality::Validity::valid ? 1 : 0;
    expected.inverted += verdict.inverted ? 1 : 0;
    expected.exact_decisions += verdict.exact ? 1 : 0;
    expected.volume += quality::volume(corners);
  }
  const quality::Report r = quality::report(mesh);
  EXPECT_EQ(r.cells, 700U);
  EXPECT_EQ(r.valid, expected.valid);
  EXPECT_EQ(r.inverted, expected.inverted);
  EXPECT_EQ(r.exact_decisions, expected.exact_decisions);
  EXPECT_DOUBLE_EQ(r.volume, expected.volume);
  EXPECT_EQ(r.valid + r.invalid + r.undecided, 700U);
  EXPECT_GT(r.valid, 100U);
  EXPECT_GT(r.inverted, 100U);
}

/// A cube of side 2, on it another cut into two prisms, on that a pyramid; and three tetrahedra.
mesh::HybridMesh four_shapes() {
  mesh::HybridMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2},
                 {2, 2, 2}, {0, 0, 4}, {2, 0, 4}, {0, 2, 4}, {2, 2, 4}, {1, 1, 5}};
  mesh.hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};
  mesh.prisms = {{4, 5, 6, 8, 9, 10}, {5, 7, 6, 9, 11, 10}};
  mesh.pyramids = {{8, 9, 11, 10, 12}};
  mesh.tetrahedra = {{8, 9, 10, 12}, {9, 8, 10, 12}, {8, 9, 10, 4}};  // right, left, left-handed
  return mesh;
}

TEST(HybridReport, EachShapeByItself) {
  const quality::HybridReport r = quality::report(four_shapes());
  EXPECT_EQ(r.hexahedra.cells, 1U);
  EXPECT_EQ(r.hexahedra.valid, 1U);
  EXPECT_DOUBLE_EQ(r.hexahedra.volume, 8);
  EXPECT_DOUBLE_EQ(r.hexahedra.min_scaled_jacobian, 1);
  EXPECT_EQ(r.prisms.cells, 2U);
  EXPECT_EQ(r.prisms.valid, 2U);
  EXPECT_DOUBLE_EQ(r.prisms.volume, 8);
  // Half squares: the sines of the angles are 1 and twice 1 / sqrt 2.
  EXPECT_NEAR(r.prisms.mean_scaled_jacobian, (1 + std::sqrt(2.0)) * 2 / (3 * std::sqrt(3.0)),
              1e-15);
  EXPECT_EQ(r.prisms.histogram[9], 2U);
  EXPECT_EQ(r.pyramids.cells, 1U);
  EXPECT_EQ(r.pyramids.valid, 1U);
  EXPECT_NEAR(r.pyramids.volume, 4.0 / 3, 1e-15);
  // u, v, z have the lengths 2, 2, sqrt 2 at each corner of the base: 3 (4 sqrt 2)^(2/3) / 10.
  EXPECT_NEAR(r.pyramids.min_scaled_jacobian, 3 * std::pow(4 * std::sqrt(2.0), 2.0 / 3) / 10,
              1e-14);
  EXPECT_EQ(r.tetrahedra.cells, 3U);
  EXPECT_EQ(r.tetrahedra.valid, 1U);
  EXPECT_EQ(r.tetrahedra.invalid, 2U);
  EXPECT_EQ(r.tetrahedra.inverted, 2U);
  EXPECT_EQ(r.tetrahedra.exact_decisions, 0U);
  EXPECT_NEAR(r.tetrahedra.volume, 4.0 / 6 - 4.0 / 6 - 8.0 / 6, 1e-15);
  EXPECT_EQ(r.tetrahedra.histogram[0], 2U);
}

TEST(HybridReport, OfNothingAndOfBadIndices) {
  const quality::HybridReport nothing = quality::report(mesh::HybridMesh{});
  EXPECT_EQ(nothing.prisms.cells, 0U);
  EXPECT_EQ(nothing.prisms.min_scaled_jacobian, 0);
  mesh::HybridMesh mesh = four_shapes();
  mesh.pyramids[0][4] = 13;
  EXPECT_THROW((void)quality::report(mesh), core::PreconditionViolated);
  mesh = four_shapes();
  mesh.prisms[1][0] = 13;
  EXPECT_THROW((void)quality::report(mesh), core::PreconditionViolated);
}

TEST(Report, OfNothing) {
  const quality::Report r = quality::report(mesh::HexMesh{});
  EXPECT_EQ(r.cells, 0U);
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
