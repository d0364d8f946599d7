// Claim. Each reader takes the mesh that a file states: points in the file's order, quads with
// their lines, hexahedra in the numbering x + 2y + 4z. Oracle. Hand-written files of the unit cube
// (samples.hpp); the numbering is checked on the coordinates, not on the conversion table.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "enum/core/errors.hpp"
#include "tests/meshing/io/samples.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using io::parse_hexahedra;
using io::parse_surface;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

TEST(ReadSurface, EachFormatGivesTheCubeWithItsLines) {
  for (const Sample& sample : surface_samples()) {
    SCOPED_TRACE(sample.name);
    const mesh::SurfaceMesh mesh = parse_surface(sample.bytes, sample.format, "f");
    EXPECT_EQ(mesh.points, kPoints);
    EXPECT_EQ(mesh.quads, kQuads);
    EXPECT_EQ(mesh.quad_line, sample.quad_line);
  }
}

TEST(ReadHexahedra, CornerOfTheUnitCubeIsXPlus2YPlus4Z) {
  for (const Sample& sample : hexahedra_samples()) {
    SCOPED_TRACE(sample.name);
    const mesh::HexMesh mesh = parse_hexahedra(sample.bytes, sample.format, "f");
    ASSERT_EQ(mesh.points, kPoints);
    ASSERT_EQ(mesh.hexahedra.size(), 1U);
    for (unsigned v = 0; v < 8; ++v) {
      const mesh::Point expected{double(v & 1U), double(v >> 1U & 1U), double(v >> 2U & 1U)};
      EXPECT_EQ(mesh.points[mesh.hexahedra[0][v]], expected) << "corner " << v;
    }
  }
}

TEST(ReadSurface, LineEndsTabsAndByteOrderMarkDoNotMatter) {
  for (const Sample& sample : surface_samples()) {
    if (sample.bytes.find('\0') != std::string::npos) continue;  // binary
    SCOPED_TRACE(sample.name);
    const std::string odd = "\xEF\xBB\xBF" + replaced(sample.bytes, "\n", "\r\n");
    const mesh::SurfaceMesh mesh = parse_surface(odd, sample.format, "f");
    EXPECT_EQ(mesh.points, kPoints);
    EXPECT_EQ(mesh.quads, kQuads);
    EXPECT_EQ(mesh.quad_line, sample.quad_line);
  }
  for (const auto& [format, text] : {std::pair{FileFormat::obj, kObj},
                                     {FileFormat::off, kOff},
                                     {FileFormat::medit, kMedit},
                                     {FileFormat::gmsh, kGmsh4}}) {
    const std::string spread = replaced(replaced(text, " ", "\t \t"), "\n", " \n");
    EXPECT_EQ(parse_surface(spread, format, "f").quads, kQuads);
  }
}

TEST(ReadSurface, LastLineMayLackItsEnd) {
  for (const auto& [format, text] : {std::pair{FileFormat::obj, kObj},
                                     {FileFormat::off, kOff},
                                     {FileFormat::vtk, kVtkGrid},
                                     {FileFormat::medit, kMedit},
                                     {FileFormat::gmsh, kGmsh4},
                                     {FileFormat::vtu, kVtuAscii}})
    EXPECT_EQ(parse_surface(text.substr(0, text.size() - 1), format, "f").quads, kQuads);
}

TEST(ReadSurface, CoordinatesAreRoundedCorrectlyAndKeptBitForBit) {
  const std::string off =
      "OFF\n4 1 0\n-0.0 5e-324 1.7976931348623157e308\n+1. .5 -2.2250738585072014E-308\n"
      "0.1 9007199254740993 1e-310\n1 2 3\n4 0 1 2 3\n";
  const mesh::SurfaceMesh mesh = parse_surface(off, FileFormat::off, "f");
  EXPECT_TRUE(std::signbit(mesh.points[0].x));
  EXPECT_EQ(mesh.points[0].y, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(mesh.points[0].z, std::numeric_limits<double>::max());
  EXPECT_EQ(mesh.points[1], (mesh::Point{1, 0.5, -std::numeric_limits<double>::min()}));
  EXPECT_EQ(mesh.points[2], (mesh::Point{0.1, 9007199254740992.0, 1e-310}));  // ties to even
}

TEST(ReadSurface, UnusedAndEqualPointsAreKept) {
  const std::string obj = "v 9 9 9\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 3 4 5 6\n";
  const mesh::SurfaceMesh mesh = parse_surface(obj, FileFormat::obj, "f");
  EXPECT_EQ(mesh.points.size(), 6U);
  EXPECT_EQ(mesh.quads, (std::vector<std::array<mesh::Index, 4>>{{2, 3, 4, 5}}));
}

TEST(ReadSurface, ObjFacesMayPrecedeVerticesAndCarryColours) {
  const std::string obj = "f 1 2 3 4\nv 0 0 0 1 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0 1 .5 .5 .5\n";
  const mesh::SurfaceMesh mesh = parse_surface(obj, FileFormat::obj, "f");
  EXPECT_EQ(mesh.points[3], (mesh::Point{0, 1, 0}));
  EXPECT_EQ(mesh.quad_line, std::vector<std::uint32_t>{1});
}

TEST(ReadSurface, OffVariants) {
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  for (const std::string& text :
       {"OFF 4 1 5\n" + points + "4 0 1 2 3\n", "OFF\n4 1\n" + points + "4 0 1 2 3\n",
        "# first\n\nOFF # keyword\n\n4 1 0\n\n" + points + "\n\n4 0 1 2 3 0.1 0.2 0.3 1\n# last",
        std::string("COFF\n4 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3 4\n1 1 0 0 0 0\n0 1 0 0 0 0\n"
                    "4 0 1 2 3\n")})
    EXPECT_EQ(parse_surface(text, FileFormat::off, "f").quads,
              (std::vector<std::array<mesh::Index, 4>>{{0, 1, 2, 3}}))
        << text;
}

TEST(ReadSurface, VtkPixelsAreReorderedAndKeywordsMayBeLowerCase) {
  const std::string vtk =
      "# vtk DataFile Version 4.2\nt\nascii\ndataset unstructured_grid\npoints 4 float\n"
      "0 0 0 1 0 0 0 1 0 1 1 0\ncells 1 5\n4 0 1 2 3\ncell_types 1\n8\n";
  EXPECT_EQ(parse_surface(vtk, FileFormat::vtk, "f").quads,
            (std::vector<std::array<mesh::Index, 4>>{{0, 1, 3, 2}}));
}

// As VTK 9.1 writes an array of strings: an empty one is an empty line.
TEST(ReadSurface, VtkFieldsMayHaveStrings) {
  const auto with = [](const std::string& arrays) {
    return edit(kVtkGrid, "FieldData 1\n", "FieldData " + arrays);
  };
  const auto plain = parse_surface(kVtkGrid, FileFormat::vtk, "f");
  const auto other = parse_surface(with("3\nnames 1 3 string\na%20b\n\n7\nunit 1 0 string\n"),
                                   FileFormat::vtk, "f");
  EXPECT_EQ(other.points, plain.points);
  EXPECT_EQ(other.quads, plain.quads);
  EXPECT_THROW((void)parse_surface(with("2\nnames 1 99999 string\na\n"), FileFormat::vtk, "f"),
               core::InvalidInput);
}

TEST(ReadHexahedra, VtkVoxelsHaveOurNumbering) {
  const std::string voxel = replaced(kHexVtk, "\n12\n", "\n11\n");
  EXPECT_EQ(parse_hexahedra(voxel, FileFormat::vtk, "f").hexahedra[0],
            (std::array<mesh::Index, 8>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(ReadSurface, VtuPiecesAreConcatenated) {
  const std::size_t begin = kVtuAscii.find("<Piece"), end = kVtuAscii.find("</Unstructured");
  std::string twice = kVtuAscii;
  twice.insert(end, kVtuAscii.substr(begin, end - begin));
  const mesh::SurfaceMesh mesh = parse_surface(twice, FileFormat::vtu, "f");
  ASSERT_EQ(mesh.points.size(), 16U);
  ASSERT_EQ(mesh.quads.size(), 12U);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(mesh.quads[i + 6][k], kQuads[i][k] + 8);
}

TEST(ReadSurface, VtuHeaderMayBeABase64TextOfItsOwn) {
  const std::string split = replaced(kVtuInline, "BgAAAAkJCQkJCQ==", "BgAAAA==CQkJCQkJ");
  EXPECT_EQ(parse_surface(split, FileFormat::vtu, "f").quads, kQuads);
}

TEST(ReadSurface, VtuAppendedBase64) {
  // Offsets count characters behind the underscore.
  std::string vtu = kVtuInline, data;
  for (std::size_t at = 0; (at = vtu.find("format=\"binary\">", at)) != std::string::npos;) {
    const std::size_t first = at + 16, last = vtu.find("</DataArray>", at);
    std::string text = replaced(vtu.substr(first, last - first), "\n", "");
    vtu.replace(at, last - at,
                "format=\"appended\" offset=\"" + std::to_string(data.size()) + "\">");
    data += text;
  }
  vtu = replaced(vtu, "</VTKFile>",
                 "<AppendedData encoding=\"base64\">\n _" + data + "\n</AppendedData></VTKFile>");
  EXPECT_EQ(parse_surface(vtu, FileFormat::vtu, "f").quads, kQuads);
}

TEST(ReadHexModel, HasRegionsAndQuads) {
  std::string points;
  for (const char* z : {"0", "1", "2"})
    for (const char* xy : {"0 0", "1 0", "1 1", "0 1"})
      points += std::string(xy) + " " + z + " 0\n";
  const std::string medit =
      "MeshVersionFormatted 2\nDimension 3\nVertices 12\n" + points +
      "Triangles 1\n1 2 3 4\nQuadrilaterals 1\n5 6 7 8 3\nHexahedra 2\n1 2 3 4 5 6 7 8 -1\n"
      "5 6 7 8 9 10 11 12 6\nEnd\n";
  const mesh::HexModel model = parse_hex_model(medit, FileFormat::medit, "f");
  EXPECT_EQ(model.mesh.hexahedra, parse_hexahedra(medit, FileFormat::medit, "f").hexahedra);
  EXPECT_EQ(model.regions, (std::vector<std::uint32_t>{0xFFFF'FFFF, 6}));
  EXPECT_EQ(model.quads, (std::vector<std::array<mesh::Index, 4>>{{4, 5, 6, 7}}));
}

TEST(ReadHexahedra, QuadsOfTheBoundaryAreIgnored) {
  EXPECT_EQ(parse_hexahedra(kHexMedit, FileFormat::medit, "f").hexahedra.size(), 1U);
  EXPECT_EQ(parse_hexahedra(kHexGmsh2, FileFormat::gmsh, "f").hexahedra.size(), 1U);
}

}  // namespace
