// Claim. What is written reads back bit for bit, in each format, whatever the locale; the same mesh
// gives the same bytes; the files have the layout that other programs rely on.
// Oracle. Seeded random meshes compared with themselves; literal files.
#include <gtest/gtest.h>

#include <limits>
#include <locale>
#include <random>

#include "enum/core/errors.hpp"
#include "tests/meshing/io/random_meshes.hpp"
#include "tests/meshing/io/samples.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

constexpr std::array kAllFormats{obj, off, vtk, vtu, medit, gmsh};
constexpr std::array kHexFormats{vtk, vtu, medit, gmsh};
constexpr std::array kGmshVersions{io::GmshVersion::v2_2, io::GmshVersion::v4_1};

/// Printing through streams or printf would now give decimal commas and grouped digits.
class Commas : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class RoundTrip : public testing::Test {
 protected:
  void SetUp() override { old_ = std::locale::global(std::locale(std::locale(), new Commas)); }
  void TearDown() override { std::locale::global(old_); }

 private:
  std::locale old_;
};

TEST_F(RoundTrip, SurfacesInAllFormats) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::size_t points = 4 + random() % (seed % 10 == 0 ? 5000 : 50);
    const mesh::SurfaceMesh mesh{
        random_points(random, points), random_cells<4>(random, points, 1 + random() % 60), {}};
    for (const FileFormat format : kAllFormats)
      for (const io::GmshVersion version : kGmshVersions) {
        const std::string text = io::to_text(mesh, format, version);
        EXPECT_TRUE(same(io::parse_surface(text, format, "f"), mesh)) << io::extension_of(format);
        EXPECT_EQ(text, io::to_text(mesh, format, version));
      }
  }
}

TEST_F(RoundTrip, HexahedraInAllFormats) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::size_t points = 8 + random() % (seed % 10 == 0 ? 5000 : 50);
    const mesh::HexMesh mesh{random_points(random, points),
                             random_cells<8>(random, points, 1 + random() % 60)};
    for (const FileFormat format : kHexFormats)
      for (const io::GmshVersion version : kGmshVersions)
        for (const bool has_boundary : {false, true}) {
          io::WriteOptions options{version, {}};
          if (has_boundary) options.boundary = {{0, 1, 2, 3}, {4, 5, 6, 7}};
          const std::string text = io::to_text(mesh, format, options);
          EXPECT_TRUE(same(io::parse_hexahedra(text, format, "f"), mesh))
              << io::extension_of(format);
        }
  }
}

const mesh::HexMesh kCube{{{0, 0, 0},
                           {1.5, 0, 0},
                           {0, 1, 0},
                           {1.5, 1, 0},
                           {0, 0, 1},
                           {1.5, 0, 1},
                           {0, 1, 1},
                           {1.5, 1, 1}},
                          {{0, 1, 2, 3, 4, 5, 6, 7}}};

TEST(WriteHexahedra, VtkLayout) {
  const std::string expected =
      "# vtk DataFile Version 3.0\nhexatlas mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS 8 double\n0 0 0\n1.5 0 0\n0 1 0\n1.5 1 0\n0 0 1\n1.5 0 1\n0 1 1\n1.5 1 1\n"
      "CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n12\n";
  EXPECT_EQ(io::to_text(kCube, vtk), expected);
  EXPECT_EQ(io::to_text(kCube, vtk, {io::GmshVersion::v4_1, {{0, 2, 3, 1}}}), expected);
}

TEST(WriteHexahedra, MeditLayout) {
  const std::string points =
      "MeshVersionFormatted 2\nDimension 3\nVertices\n8\n0 0 0 0\n1.5 0 0 0\n0 1 0 0\n1.5 1 0 0\n"
      "0 0 1 0\n1.5 0 1 0\n0 1 1 0\n1.5 1 1 0\n";
  const std::string hexahedra = "Hexahedra\n1\n1 2 4 3 5 6 8 7 0\nEnd\n";
  EXPECT_EQ(io::to_text(kCube, medit), points + hexahedra);
  EXPECT_EQ(io::to_text(kCube, medit, {io::GmshVersion::v4_1, {{0, 2, 3, 1}}}),
            points + "Quadrilaterals\n1\n1 3 4 2 0\n" + hexahedra);
}

TEST(WriteHexahedra, GmshLayout) {
  const std::string v4 = io::to_text(kCube, gmsh, {io::GmshVersion::v4_1, {{0, 2, 3, 1}}});
  EXPECT_NE(v4.find("$Entities\n0 0 1 1\n1 0 0 0 1.5 1 1 0 0\n1 0 0 0 1.5 1 1 0 1 1\n"),
            std::string::npos);
  EXPECT_NE(v4.find("$Elements\n2 2 1 2\n2 1 3 1\n1 1 3 4 2\n3 1 5 1\n2 1 2 4 3 5 6 8 7\n"),
            std::string::npos);
  const std::string v2 = io::to_text(kCube, gmsh, {io::GmshVersion::v2_2, {}});
  EXPECT_NE(v2.find("$Elements\n1\n1 5 2 0 1 1 2 4 3 5 6 8 7\n$EndElements\n"), std::string::npos);
}

TEST(WriteHexahedra, ShortestForm) {
  mesh::HexMesh mesh = kCube;
  mesh.points[0] = {0.1, -0.0, 5e-324};
  mesh.points[1] = {1e300, 1.0 / 3, 123456};
  EXPECT_NE(io::to_text(mesh, vtk).find("\n0.1 -0 5e-324\n1e+300 0.3333333333333333 123456\n"),
            std::string::npos);
}

TEST(WriteHexahedra, Preconditions) {
  mesh::HexMesh mesh = kCube;
  EXPECT_THROW(static_cast<void>(io::to_text(mesh, obj)), core::PreconditionViolated);
  mesh.hexahedra[0][7] = 8;
  EXPECT_THROW(static_cast<void>(io::to_text(mesh, vtk)), core::PreconditionViolated);
  mesh = kCube;
  mesh.points[3].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(io::to_text(mesh, vtu)), core::PreconditionViolated);
}

}  // namespace
