// Claim. interior_points() are the inner points of a lattice of cubes; the volume of a part is that
// of its lattice, wherever these are and at any scale, negative if the cubes are inside out;
// points_of_interfaces() are those between layers of it; fault_of_sides() tells what kind of
// overlap no places can mend, and nothing of a lattice. Oracle. What is known of a lattice.
#include "meshing/hexahedrize/sides.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "enum/cells/cube.hpp"

namespace hexatlas {
namespace {

/// n^3 cubes; the inner points anywhere.
mesh::HexMesh lattice(mesh::Index n, std::mt19937_64& random) {
  mesh::HexMesh mesh;
  const mesh::Index m = n + 1;
  const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  for (mesh::Index i = 0; i < m * m * m; ++i) {
    const std::array<mesh::Index, 3> at{i % m, i / m % m, i / (m * m)};
    const bool is_inner = std::all_of(at.begin(), at.end(), [n](auto k) { return k > 0 && k < n; });
    mesh.points.push_back({at[0] + (is_inner ? unit() : 0), at[1] + (is_inner ? unit() : 0),
                           at[2] + (is_inner ? unit() : 0)});
    if (std::any_of(at.begin(), at.end(), [n](auto k) { return k == n; })) continue;
    mesh.hexahedra.push_back(
        {i, i + 1, i + m, i + m + 1, i + m * m, i + m * m + 1, i + m * m + m, i + m * m + m + 1});
  }
  return mesh;
}

TEST(Sides, OfLattices) {
  std::mt19937_64 random(1);
  for (const mesh::Index n : {1U, 2U, 3U, 5U}) {
    mesh::HexMesh mesh = lattice(n, random);
    EXPECT_EQ(hexahedrize::fault_of_sides(mesh), std::nullopt);
    const auto is_interior = hexahedrize::interior_points(mesh);
    EXPECT_EQ(std::count(is_interior.begin(), is_interior.end(), 1), (n - 1) * (n - 1) * (n - 1));
    ASSERT_EQ(hexahedrize::parts_of(mesh).size(), 1U);
    EXPECT_EQ(hexahedrize::parts_of(mesh)[0].side, exact::Sign::positive);
    EXPECT_EQ(hexahedrize::parts_of(mesh)[0].boundary_quads, 6 * n * n);
    for (auto& cell : mesh.hexahedra) cells::exchange_axes(cell);
    EXPECT_EQ(hexahedrize::fault_of_sides(mesh), std::nullopt);
    EXPECT_EQ(hexahedrize::parts_of(mesh)[0].side, exact::Sign::negative);
    for (const double scale : {1e-300, 1e300}) {
      mesh::HexMesh scaled = mesh;
      for (mesh::Point& p : scaled.points) p = {scale * p.x, scale * p.y, scale * p.z};
      EXPECT_EQ(hexahedrize::parts_of(scaled)[0].side, exact::Sign::negative);
    }
    mesh.points.push_back({});
    EXPECT_EQ(hexahedrize::points_of_cells(mesh).back(), 0);
    EXPECT_EQ(hexahedrize::interior_points(mesh).back(), 0);
  }
}

TEST(Sides, Interfaces) {
  constexpr mesh::Index kN = 4;
  std::mt19937_64 random(2);
  mesh::HexModel model{lattice(kN, random), {}, {}};
  EXPECT_EQ(hexahedrize::points_of_interfaces(model),
            std::vector<std::uint8_t>(model.mesh.points.size(), 0));
  const auto layer = [](mesh::Index place, mesh::Index axis) {  // of a point, or of a cube
    const mesh::Index m = kN + 1;
    return axis == 0 ? place % m : axis == 1 ? place / m % m : place / (m * m);
  };
  std::vector<std::uint8_t> wanted;
  for (mesh::Index v = 0; v < model.mesh.points.size(); ++v)
    wanted.push_back(layer(v, 0) == 2 ? 1 : 0);
  for (const auto& cell : model.mesh.hexahedra)
    model.regions.push_back(layer(cell[0], 0) < 2 ? 7 : 9);
  EXPECT_EQ(hexahedrize::points_of_interfaces(model), wanted);
  for (const auto& cell : model.mesh.hexahedra) {  // and the top of the lowest cubes; the bottom
    if (layer(cell[0], 2) != 0) continue;
    model.quads.push_back({cell[6], cell[7], cell[5], cell[4]});
    model.quads.push_back({cell[0], cell[1], cell[3], cell[2]});
  }
  for (mesh::Index v = 0; v < wanted.size(); ++v)
    if (layer(v, 2) == 1) wanted[v] = 1;
  EXPECT_EQ(hexahedrize::points_of_interfaces(model), wanted);
}

TEST(Sides, OfSlenderAndFlatCells) {
  std::mt19937_64 random(4);
  mesh::HexMesh mesh = lattice(1, random);
  mesh.points.assign(8, {});
  const auto side_with = [&](double y, double z) {
    for (unsigned i = 0; i < 8; ++i)
      mesh.points[i] = {i % 2 != 0 ? 1.0 : 0.0, i / 2 % 2 != 0 ? y : 0.0, i / 4 != 0 ? z : 0.0};
    return hexahedrize::parts_of(mesh)[0].side;
  };
  for (const double width : {1e-5, 1e-8, 1e-15, 1e-150, 1e-300}) {
    EXPECT_EQ(side_with(width, width), exact::Sign::positive);
    EXPECT_EQ(side_with(width, -width), exact::Sign::negative);
    EXPECT_EQ(side_with(width, 0), exact::Sign::zero);
  }
  // The cell (0, 0, 0) and (1, 1, 1) but for one vertex: half a bit inside out or not.
  for (const double lift : {0x1p-60, -0x1p-60}) {
    (void)side_with(1, 0);
    mesh.points[7].z = lift;
    EXPECT_EQ(hexahedrize::parts_of(mesh)[0].side,
              lift > 0 ? exact::Sign::positive : exact::Sign::negative);
  }
}

TEST(Sides, PartsAreToldApart) {
  std::mt19937_64 random(3);
  mesh::HexMesh mesh = lattice(2, random);
  mesh::HexMesh other = lattice(3, random);
  const auto shift = static_cast<mesh::Index>(mesh.points.size() - 1);  // a vertex in common
  for (auto& cell : other.hexahedra) {
    cells::exchange_axes(cell);
    for (mesh::Index& v : cell) v = v == 0 ? 0 : v + shift;
    mesh.hexahedra.push_back(cell);
  }
  mesh.points.insert(mesh.points.end(), other.points.begin() + 1, other.points.end());
  const auto parts = hexahedrize::parts_of(mesh);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].cells.size(), 8U);
  EXPECT_EQ(parts[1].cells.size(), 27U);
  EXPECT_EQ(parts[0].side, exact::Sign::positive);
  EXPECT_EQ(parts[1].side, exact::Sign::negative);
}

TEST(Sides, FaultsAreTold) {
  std::mt19937_64 random(2);
  const mesh::HexMesh good = lattice(2, random);
  mesh::HexMesh bad = good;
  cells::exchange_axes(bad.hexahedra[3]);
  EXPECT_NE(hexahedrize::fault_of_sides(bad)->find("on the same side of"), std::string::npos);
  bad = good;
  std::swap(bad.hexahedra[0][1], bad.hexahedra[0][3]);
  EXPECT_NE(hexahedrize::fault_of_sides(bad)->find("in different cycles"), std::string::npos);
  bad = good;  // a third one at the quad x = 1 of the first
  auto cell = good.hexahedra[0];
  for (const std::size_t corner : {0U, 2U, 4U, 6U})
    cell[corner] = static_cast<mesh::Index>(bad.points.size() + corner / 2);
  bad.points.resize(bad.points.size() + 4);
  bad.hexahedra.push_back(cell);
  EXPECT_EQ(hexahedrize::fault_of_sides(bad), "the quad 1 4 13 10 is in 3 hexahedra");
  bad = good;  // a hexahedron and its mirror image on the same points
  bad.hexahedra = {good.hexahedra[0], good.hexahedra[0]};
  cells::exchange_axes(bad.hexahedra[1]);
  EXPECT_NE(hexahedrize::fault_of_sides(bad)->find("has no boundary"), std::string::npos);
}

}  // namespace
}  // namespace hexatlas
