// Claim. The points of a file are read in each format, with cells or without; none at all is an
// answer; every defect is refused with InvalidInput at its line or point; formats without a surface
// or cells say so.
// Oracle. Hand-made files, literal points, lines counted by hand.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/meshing/io/malformed.hpp"
#include "tests/meshing/io/sample_points.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

void expect_points_refused(const std::vector<Malformed>& table) {
  expect_all_refused(table, io::parse_points);
}

TEST(Points, OfFilesWithoutCells) {
  for (const Sample& sample : points_samples()) {
    const auto points = io::parse_points(sample.bytes, sample.format, "f");
    EXPECT_EQ(points, kPoints) << sample.name;
    if (sample.format == xyz) {
      EXPECT_TRUE(same(points, points_of_xyz()));
    }
  }
}

TEST(Points, OfMeshes) {
  for (const auto& samples : {surface_samples(), hexahedra_samples(), tetrahedra_samples()})
    for (const Sample& sample : samples)
      EXPECT_EQ(io::parse_points(sample.bytes, sample.format, "f"), kPoints) << sample.name;
}

TEST(Points, NoneAtAll) {
  const std::vector<Sample> empty{
      {"xyz", xyz, "", {}},
      {"xyz", xyz, "# nothing\n\n", {}},
      {"raw", raw, "", {}},
      {"obj", obj, "# nothing\n", {}},
      {"off", off, "OFF\n0 0 0\n", {}},
      {"ply",
       ply,
       "ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nproperty int y\nproperty int z\n"
       "end_header\n",
       {}},
      {"vtk", vtk, "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n", {}},
      {"medit", medit, "MeshVersionFormatted 2\nDimension 3\nVertices 0\nEnd\n", {}},
      {"gmsh", gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n0\n$EndNodes\n", {}},
      {"hxtet", hxtet, std::string("HXTET\0\0\1", 8) + std::string(16, '\0'), {}},
  };
  for (const Sample& sample : empty)
    EXPECT_TRUE(io::parse_points(sample.bytes, sample.format, "f").empty()) << sample.name;
}

TEST(Points, WithWeights) {
  const auto text =
      io::parse_weighted_points("1 2 3 -4.5\n# no\n0 -0 1e300 5e-324 more\n", xyz, "f");
  EXPECT_EQ(text.points, (std::vector<mesh::Point>{{1, 2, 3}, {0, 0, 1e300}}));
  EXPECT_EQ(text.weights, (std::vector<double>{-4.5, 5e-324}));
  const std::string one = packed(1.0) + packed(2.0) + packed(3.0), two = packed(4.0) + one;
  const auto binary = io::parse_weighted_points(one + packed(-4.5) + two, raw, "f");
  EXPECT_EQ(binary.points, (std::vector<mesh::Point>{{1, 2, 3}, {4, 1, 2}}));
  EXPECT_EQ(binary.weights, (std::vector<double>{-4.5, 3}));
  EXPECT_TRUE(io::parse_weighted_points("", raw, "f").points.empty());
  EXPECT_TRUE(io::parse_weighted_points("", xyz, "f").weights.empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_all_refused(
      {{xyz, "0 0 0 0\n1 2 3\n", 2, "line of 3 columns; x y z weight are expected"},
       {xyz, "0 0 0 inf\n", 1, "'inf' is not a finite number"},
       {xyz, "0 0 0 w\n", 1, "'w' is not a number"},
       {raw, one, 0, "has 24 bytes, which is not a multiple of 32, four doubles per point"},
       {raw, one + packed(nan), 0, "point 0, counted from 0, has a weight that is not a finite"},
       {raw, two + packed(nan) + two, 0, "has 72 bytes"},
       {raw, one + packed(1.0) + packed(nan) + one, 0, "point 1, counted from 0, has a coordinate"},
       {ply, "ply\n", 0, "the format .ply is not one for points with weights (known: .xyz .bin)"}},
      io::parse_weighted_points);
}

TEST(Points, EndsOfLinesAndMark) {
  std::string dos = kXyz;
  for (std::size_t at = 0; (at = dos.find('\n', at)) != std::string::npos; at += 2)
    dos.replace(at, 1, "\r\n");
  EXPECT_TRUE(same(io::parse_points(dos, xyz, "f"), points_of_xyz()));
  EXPECT_TRUE(same(io::parse_points("\xEF\xBB\xBF" + kXyz, xyz, "f"), points_of_xyz()));
  EXPECT_EQ(io::parse_points("1 2 3", xyz, "f"), (std::vector<mesh::Point>{{1, 2, 3}}));
  // In binary the same bytes are data.
  const std::string mark = "\xEF\xBB\xBF" + std::string(21, '\0');
  EXPECT_EQ(io::parse_points(mark, raw, "f").size(), 1U);
}

TEST(Malformed, Xyz) {
  expect_points_refused({
      {xyz, "0 0 0\n1 2\n", 2, "line of 2 columns; x y z are expected"},
      {xyz, "\n\n8\nC 0 0 0\n", 3, "line of 1 column;"},
      {xyz, "0 0 0\nC 0 0 0\n", 2, "'C' is not a number"},
      {xyz, "0 0 0\r\n1 nan 0\r\n", 2, "'nan' is not a finite number"},
      {xyz, "0 0 -inf\n", 1, "'-inf' is not a finite number"},
      {xyz, "0 0 1e400\n", 1, "outside the range of double precision"},
      {xyz, "1,2,3\n", 1, "line of 1 column;"},
      {xyz, "0 0 0\n1 0 0\r0 1 0\r", 2, "carriage return that ends no line"},
      {xyz, "1, 2, 3\n", 1, "'1,' is not a number"},
      {xyz, "0 0 0\n0 0 0x1\n", 2, "'0x1' is not a number"},
      {xyz, std::string("0 0 0\n1 \0 2 3\n", 14), 2, "NUL byte"},
      {xyz, kGarbage, 1, "NUL byte"},
  });
}

TEST(Malformed, Raw) {
  std::string not_finite = raw_points();
  not_finite.replace(3 * 24 + 8, 8, packed(std::numeric_limits<double>::quiet_NaN()));
  std::string infinite = raw_points();
  infinite.replace(7 * 24 + 16, 8, packed(-std::numeric_limits<double>::infinity()));
  expect_points_refused({
      {raw, raw_points().substr(1), 0, "has 191 bytes, which is not a multiple of 24"},
      {raw, raw_points() + "\n", 0, "has 193 bytes"},
      {raw, not_finite, 0, "point 3, counted from 0, has a coordinate that is not a finite number"},
      {raw, infinite, 0, "point 7, counted from 0, has"},
  });
}

/// Addresses that nobody may read: the number of points is refused before any of them is.
TEST(Malformed, TooManyPoints) {
  const std::size_t size = (std::size_t{mesh::kMostPoints} + 1) * 24;
  void* const nothing =
      ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (nothing == MAP_FAILED) GTEST_SKIP() << "no such range of addresses";
  const std::string_view bytes(static_cast<const char*>(nothing), size);
  try {
    static_cast<void>(io::parse_points(bytes, raw, "f"));
    ADD_FAILURE() << "accepted";
  } catch (const core::InvalidInput& error) {
    EXPECT_STREQ(error.what(), "f: 4294967295 points; at most 4294967294 are possible");
  }
  ::munmap(nothing, size);
}

TEST(Malformed, ListsOfPointsThatAreNotThere) {
  const std::string head = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n";
  expect_points_refused({
      {vtk, head, 4, "the file ends where POINTS is expected"},
      {gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", 3, "ends where $Nodes is expected"},
      {medit, "MeshVersionFormatted 2\nDimension 3\nEnd\n", 3, "there is no section Vertices"},
      {obj, "", 0, "is empty"},
      {ply, "", 0, "is empty"},
      {hxtet, "", 0, "is empty"},
      {vtk, head + "POINTS 9 float\n" + kPointRows, 5, "count 9 is too large: only 49 bytes"},
      {vtk, head + "POINTS 8 float\n" + edit(kPointRows, "\n1 1 1", "\n1.0 1"), 13,
       "the file ends where a coordinate is expected"},
      {off, edit(kOff, "4 3 0 4 7\n", "4 3 0 4 8\n"), 17, "index 8 is too large"},
  });
}

TEST(Malformed, FormatsWithoutSurfacesOrCells) {
  const std::string surfaces = " is not one for surfaces (known: .obj .off .vtk .vtu .mesh .msh)";
  for (const Sample& sample : points_samples()) {
    const FileFormat format = sample.format;
    if (format == xyz || format == raw || format == ply) {
      const std::string name = "the format " + std::string(io::extension_of(format));
      expect_all_refused({{format, sample.bytes, 0, name + surfaces}}, io::parse_surface);
      expect_all_refused({{format, sample.bytes, 0, name + surfaces}}, io::parse_facets);
      const std::string why = name + " is not one for hexahedra (known: .vtk .vtu .mesh .msh)";
      expect_all_refused({{format, sample.bytes, 0, why}}, io::parse_hexahedra);
      EXPECT_THROW(static_cast<void>(io::to_text(mesh::SurfaceMesh{}, format)),
                   core::PreconditionViolated);
    }
  }
  expect_all_refused({{hxtet, hxtet_bytes(), 0, "the format .hxtet" + surfaces}},
                     io::parse_surface);
  expect_all_refused({{hxtet, hxtet_bytes(), 0, ".hxtet is not one for hexahedra"}},
                     io::parse_hexahedra);
}

TEST(Format, OfPoints) {
  EXPECT_EQ(io::format_of_path("a.XYZ"), xyz);
  EXPECT_EQ(io::format_of_path("a.bin"), raw);
  EXPECT_EQ(io::format_of_path("a.ply"), ply);
  EXPECT_EQ(io::format_of_path("a.hxtet"), hxtet);
  for (const Sample& sample : points_samples()) {
    if (sample.format == raw)
      EXPECT_THROW(static_cast<void>(io::detect_format(sample.bytes, "f")), core::InvalidInput);
    else
      EXPECT_EQ(io::detect_format(sample.bytes, "f"), sample.format) << sample.name;
  }
  EXPECT_EQ(io::detect_format(hxtet_bytes(), "f"), hxtet);
  EXPECT_EQ(io::detect_format("-.5 1 2", "f"), xyz);
}

TEST(Points, OfPaths) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "hexatlas_io_points";
  std::filesystem::create_directories(folder);
  const std::string file = folder / "a.bin";
  std::ofstream(file, std::ios::binary) << raw_points();
  EXPECT_EQ(io::read_points(file), kPoints);
  EXPECT_EQ(io::read_points(file, raw), kPoints);
  const auto message = [&](const auto& read) {
    try {
      static_cast<void>(read());
    } catch (const core::InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  // Names are judged before files are opened.
  EXPECT_EQ(
      message([] { return io::read_surface("missing.ply"); }),
      "missing.ply: the format .ply is not one for surfaces (known: .obj .off .vtk .vtu .mesh "
      ".msh)");
  EXPECT_EQ(
      message([] { return io::read_points("a.stl"); }),
      "a.stl: the extension names no known mesh format (known: .obj .off .vtk .vtu .mesh .msh "
      ".xyz .bin .ply .hxtet)");
  EXPECT_EQ(message([] { return io::read_hexahedra("a.stl"); }),
            "a.stl: the extension names no known mesh format (known: .vtk .vtu .mesh .msh)");
  EXPECT_EQ(
      message([] { return io::read_tetrahedra("a.xyz"); }),
      "a.xyz: the format .xyz is not one for tetrahedra (known: .vtk .vtu .mesh .msh .hxtet)");
  std::filesystem::remove_all(folder);
}

}  // namespace
