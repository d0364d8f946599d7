// Claim. The judge's readers read what well-formed files say, in each format, and refuse malformed
// files with the place of the fault.
// Oracle. Writers in example_files.hpp, from the descriptions of the formats; two files of VTK 9.1
// (its writer of XML files, zlib, inline and appended base64; ranges and information keys left
// out); a Gmsh file with tags and sections as Gmsh 4.8 writes them.
#include "tables/check/mesh.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "tables/check/malformed.hpp"
#include "tests/tables/check/big_endian.hpp"
#include "tests/tables/check/example_files.hpp"
#include "tests/tables/check/example_meshes.hpp"
#include "tests/tables/check/replaced.hpp"

namespace hexatlas::check {
namespace {

using examples::replaced;

Mesh sample() {
  examples::Example example = examples::cubes(examples::box(2, 2, 2));
  example.mesh.quads = example.surface.quads;
  example.mesh.points[3] = {-1.5e-300, 4.9e-324, 1.7976931348623157e308};
  return example.mesh;
}

void expect_equal(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)), 0);
  EXPECT_EQ(a.hexahedra, b.hexahedra);
  EXPECT_EQ(a.quads, b.quads);
}

void expect_malformed(const std::string& name, const std::string& bytes, const std::string& words) {
  try {
    static_cast<void>(parse_surface(name, bytes));
    ADD_FAILURE() << name << " was read; expected: " << words;
  } catch (const Malformed& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find(name + ":"), 0U) << error.what();
  }
}

/// Expects that of the file with its first `from` replaced.
auto changes_of(const std::string& name, const std::string& good) {
  return [=](const std::string& from, const std::string& to, const std::string& words) {
    expect_malformed(name, replaced(good, from, to), words);
  };
}

constexpr const char* kVtkInline =
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" h"
    "eader_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\">\n"
    "<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"12\" NumberOfCells=\"2\">\n"
    "<PointData>\n"
    "</PointData>\n"
    "<CellData>\n"
    "</CellData>\n"
    "<Points>\n"
    "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"bi"
    "nary\">\n"
    "AQAAAACAAAAgAQAAMgAAAA==eF5jYMAOZs0EgZ322MVPYoijyiP0wfjYxU9iiKMD/Pph4icxxHHpx0+f"
    "xBAHALUqW20=\n"
    "</DataArray>\n"
    "</Points>\n"
    "<Cells>\n"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"binary\">\n"
    "AQAAAACAAACAAAAALgAAAA==eF41zLkBACAMw8BAgDzsvy8FspurLLO/gQsdDwY2Fuo3caM6+iVeVOcB"
    "EyAAWQ==\n"
    "</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"binary\">\n"
    "AQAAAACAAAAQAAAADgAAAA==eF7jYIAAASgNAAEQABk=\n"
    "</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">\n"
    "AQAAAACAAAACAAAACgAAAA==eF7j4QEAACYAGQ==\n"
    "</DataArray>\n"
    "</Cells>\n"
    "</Piece>\n"
    "</UnstructuredGrid>\n"
    "</VTKFile>\n";
constexpr const char* kVtkAppended =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" h"
    "eader_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
    "<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"12\"                   NumberOfCells=\"2\"              "
    "     >\n"
    "<PointData>\n"
    "</PointData>\n"
    "<CellData>\n"
    "</CellData>\n"
    "<Points>\n"
    "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ap"
    "pended\"                           offset=\"0\"                   >\n"
    "</DataArray>\n"
    "</Points>\n"
    "<Cells>\n"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"appended\"             "
    "                            offset=\"112\"                 />\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"appended\"                  "
    "                       offset=\"220\"                 />\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"appended\"                    "
    "                     offset=\"284\"                 >\n"
    "</DataArray>\n"
    "</Cells>\n"
    "</Piece>\n"
    "</UnstructuredGrid>\n"
    "<AppendedData encoding=\"base64\">\n"
    "_AQAAAAAAAAAAgAAAAAAAACABAAAAAAAAMgAAAAAAAAA=eF5jYMAOZs0EgZ322MVPYoijyiP0wfjYxU9"
    "iiKMD/Pph4icxxHHpx0+fxBAHALUqW20=AQAAAAAAAAAAgAAAAAAAAIAAAAAAAAAALgAAAAAAAAA=eF4"
    "1zLkBACAMw8BAgDzsvy8FspurLLO/gQsdDwY2Fuo3caM6+iVeVOcBEyAAWQ==AQAAAAAAAAAAgAAAAAA"
    "AABAAAAAAAAAADgAAAAAAAAA=eF7jYIAAASgNAAEQABk=AQAAAAAAAAAAgAAAAAAAAAIAAAAAAAAACgA"
    "AAAAAAAA=eF7j4QEAACYAGQ==\n"
    "</AppendedData>\n"
    "</VTKFile>\n";

TEST(ReadMesh, ReadsWhatEachFormatSays) {
  const Mesh mesh = sample();
  Mesh no_quads = mesh;
  no_quads.quads.clear();
  for (const auto& format : examples::kMeshFormats) {
    SCOPED_TRACE(format.name);
    expect_equal(parse_mesh(format.name, format.write(mesh)), mesh);
    expect_equal(parse_mesh(format.name, format.write(no_quads)), no_quads);
  }
}

// What VTK takes for granted on all machines of today.
TEST(ReadMesh, ReadsVtuWithoutAByteOrder) {
  const std::string words = " byte_order=\"LittleEndian\"";
  expect_equal(parse_mesh("a.vtu", replaced(examples::vtu_ascii(sample()), words, "")), sample());
  expect_equal(parse_mesh("a.vtu", replaced(kVtkAppended, words, "")),
               parse_mesh("a.vtu", kVtkAppended));
}

TEST(ReadMesh, ReadsSurfaces) {
  const Mesh mesh = sample();
  Mesh no_cells = mesh;
  no_cells.hexahedra.clear();
  const Surface surface{mesh.points, mesh.quads};
  const auto expect_surface = [&surface](const Surface& read) {
    expect_equal({read.points, {}, read.quads}, {surface.points, {}, surface.quads});
  };
  expect_surface(parse_surface("a.obj", examples::obj(surface)));
  expect_surface(parse_surface("a.off", examples::off(surface)));
  expect_surface(parse_surface("a.vtk", examples::vtk_2(no_cells)));
  expect_surface(
      parse_surface("a.mesh", replaced(examples::medit(no_cells), "Hexahedra", "Edges")));
  expect_malformed("a.vtk", examples::vtk_2(mesh), "a surface has no hexahedra");
}

TEST(ReadMesh, ReadsFilesOfVtk) {
  Mesh two;
  for (const double z : {0.0, 0.1}) {
    for (const double y : {0.0, 0.1}) {
      for (const double x : {0.0, 0.1, 0.2}) two.points.push_back({x, y, z});
    }
  }
  two.hexahedra = {{0, 1, 4, 3, 6, 7, 10, 9}, {1, 2, 5, 4, 7, 8, 11, 10}};
  expect_equal(parse_mesh("inline.vtu", kVtkInline), two);
  expect_equal(parse_mesh("appended.vtu", kVtkAppended), two);
}

TEST(ReadMesh, ReadsGmshTagsAndPassesOverOtherSections) {
  const char* const file =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"a $Nodes\"\n"
      "$EndPhysicalNames\n$Entities\n1 0 0 0\n1 0 0 0 0\n$EndEntities\n"
      "$Nodes\n2 8 3 40\n0 1 0 1\n40\n0 0 0\n3 1 1 7\n3\n4\n5\n6\n7\n8\n9\n"
      "1 0 0 0 0 0\n1 1 0 0 0 0\n0 1 0 0 0 0\n0 0 1 0 0 0\n1 0 1 0 0 0\n1 1 1 0 0 0\n"
      "0 1 1 .5 .5 .5\n$EndNodes\n"
      "$Elements\n3 3 1 9\n0 1 15 1\n1 40\n1 1 1 1\n2 40 3\n3 1 5 1\n9 40 3 4 5 6 7 8 9\n"
      "$EndElements\n";
  const Mesh mesh = parse_mesh("a.msh", file);
  EXPECT_EQ(mesh.points.size(), 8U);
  EXPECT_EQ(mesh.points[6], (Point{1, 1, 1}));
  EXPECT_EQ(mesh.hexahedra, (std::vector<Hexahedron>{{0, 1, 2, 3, 4, 5, 6, 7}}));
}

TEST(ReadMesh, AcceptsHarmlessOddities) {
  const Mesh mesh = sample();
  std::string crlf = "\xEF\xBB\xBF";
  for (const char c : examples::medit(mesh))
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_equal(parse_mesh("a.mesh", crlf), mesh);
  const std::string fields = "CELL_DATA 2\nSCALARS a int 1\nLOOKUP_TABLE default\n1\n2\n";
  expect_equal(parse_mesh("a.vtk", examples::vtk_51(mesh) + fields), mesh);
  expect_equal(parse_mesh("a.vtk", replaced(examples::vtk_51(mesh), "CELLS ",
                                            "METADATA\nINFORMATION 0\n\nCELLS ")),
               mesh);
  const std::string empty = "Triangles 0\nNormals 1\n0 0 .5\nTangentAtVertices 1\n1 1\nHexahedra";
  expect_equal(parse_mesh("a.mesh", replaced(examples::medit(mesh), "Hexahedra", empty)), mesh);
  const Surface surface = parse_surface(
      "a.obj",
      "o a\nl 1 2\np 1\nv 0 0 0\nv +1 0 0 1\nv 1 1 0 0.5 0.5 0.5\nv 0 1e0 0\nvn 0 0 1\n"
      "usemtl m\nf 1/1/1 -3//1 3/4 -1 # a quad\n");
  EXPECT_EQ(surface.quads, (std::vector<Quad>{{0, 1, 2, 3}}));
}

/// A file of version 5.1, of one pixel and with fields.
std::string with_field(bool binary, const std::string& type) {
  const auto numbers = [binary](const std::vector<std::uint64_t>& list, bool is_wide) {
    if (binary) return examples::big_endian(list, is_wide) + "\n";
    std::string text;
    for (const std::uint64_t number : list) text += std::to_string(number) + "\n";
    return text;
  };
  const bool is_wide = type == "vtktypeint64";
  const std::string field = "FIELD FieldData 2\nTimeValue 1 1 int\n" + numbers({7}, false) +
                            "METADATA\nINFORMATION 0\n\nb 2 3 long\n" +
                            numbers({1, 2, 3, 4, 5, 0}, true);
  const std::vector<std::uint64_t> points(12);  // all zero, as bits or in words
  return std::string("# vtk DataFile Version 5.1\ntitle\n") + (binary ? "BINARY\n" : "ASCII\n") +
         field + "DATASET UNSTRUCTURED_GRID\n" + field + "POINTS 4 double\n" +
         numbers(points, true) + "CELLS 2 4\nOFFSETS " + type + "\n" + numbers({0, 4}, is_wide) +
         "CONNECTIVITY " + type + "\n" + numbers({0, 1, 2, 3}, is_wide) + "CELL_TYPES 1\n" +
         numbers({8}, false);
}

TEST(ReadMesh, ReadsFieldsPixelsAndTypesOfIntegers) {
  for (const bool binary : {false, true})
    for (const std::string type : {"vtktypeint32", "vtktypeint64"}) {
      const Surface surface = parse_surface("a.vtk", with_field(binary, type));
      EXPECT_EQ(surface.points.size(), 4U);
      EXPECT_EQ(surface.quads, (std::vector<Quad>{{0, 1, 3, 2}}));
    }
  const auto bad = changes_of("a.vtk", with_field(false, "int"));
  bad("TimeValue 1 1 int", "TimeValue 1 1 strings", "unknown type of numbers 'strings'");
  bad("TimeValue 1 1", "TimeValue 1 2", "expected a number");
  bad("TimeValue 1 1", "TimeValue 1 99999", "more than the rest of the file");
  bad("FieldData 2", "FieldData 3", "a.vtk:");
  bad("OFFSETS int", "OFFSETS float", "unknown type of integers 'float'");
}

// As VTK 9.1 writes them: the two highest bits of a length say in how many bytes it is.
TEST(ReadMesh, PassesOverStrings) {
  const std::string good = with_field(false, "int");
  EXPECT_EQ(parse_surface("a.vtk", replaced(good, "FIELD FieldData 2\n",
                                            "FIELD FieldData 3\nnames 2 2 string\na%20b\n\n7\n\n"))
                .quads,
            parse_surface("a.vtk", good).quads);
  const std::string binary = with_field(true, "int");
  const std::string strings = std::string("\xc3") + "a\nb" + std::string("\x80\x03", 2) + "FIE" +
                              std::string("\x40\0\0\1", 4) + "x" +
                              std::string("\0\0\0\0\0\0\0\2", 8) + "yz\n";
  const auto with = [&](const std::string& found) {
    return replaced(binary, "FIELD FieldData 2\n", "FIELD FieldData 3\nnames 1 4 string\n" + found);
  };
  EXPECT_EQ(parse_surface("a.vtk", with(strings)).quads, parse_surface("a.vtk", binary).quads);
  for (const std::string& length : {std::string("\xff"), std::string(8, '\x3f')})
    EXPECT_THROW((void)parse_surface("a.vtk", with(length)), Malformed);
  EXPECT_THROW((void)parse_surface("a.vtk", replaced(good, "FieldData 2\n",
                                                     "FieldData 3\nnames 9999 9999 string\n")),
               Malformed);
}

TEST(ReadMesh, ReadsVoxels) {
  const Mesh mesh = sample();
  for (const std::string version : {"2.0", "4.0", "4.1"}) {
    std::string file = replaced(examples::vtk_2(mesh), "2.0", version);
    const std::size_t types = file.find("CELL_TYPES");
    file.replace(file.find("\n12\n", types), 4, "\n11\n");
    Mesh expected = mesh;
    std::swap(expected.hexahedra[0][2], expected.hexahedra[0][3]);
    std::swap(expected.hexahedra[0][6], expected.hexahedra[0][7]);
    expect_equal(parse_mesh("a.vtk", file), expected);
  }
}

TEST(ReadMesh, RefusesMalformedVtk) {
  const std::string good = examples::vtk_2(sample());
  const auto bad = changes_of("a.vtk", good);
  expect_malformed("a.vtk", "", "too early");
  expect_malformed("a.vtk", good.substr(0, good.size() / 2), "a.vtk:");
  bad("2.0", "9.9", "a.vtk:1: unknown version");
  bad("ASCII", "BINARY", "unknown or misplaced keyword");
  bad("ASCII", "BASE64", "a.vtk:3: expected 'ASCII'");
  bad("POINTS 27", "POINTS 28", "expected a number");
  bad("POINTS 27", "POINTS 26", "unknown or misplaced keyword");
  bad("POINTS 27", "POINTS 2147483647", "more than the rest of the file");
  bad("POINTS 27", "POINTS 9223372036854775807", "more than the rest of the file");
  bad("POINTS 27", "POINTS 99999999999999999999999", "natural number");
  bad("POINTS 27", "POINTS -8", "natural number");
  bad("double\n0 0 0", "double\n0 nan 0", "a.vtk:6: the number 'nan' is not finite");
  bad("double\n0 0 0", "double\n0 1e400 0", "a.vtk:6: expected a number");
  bad("double\n0 0 0", "double\n0 0x1p3 0", "a.vtk:6: expected a number");
  bad("double\n0 0 0", "double\n0 0,5 0", "a.vtk:6: expected a number");
  bad("double\n0 0 0", "double\n0 --3 0", "a.vtk:6: expected a number");
  bad("\n8 ", "\n7 ", "size of CELLS is wrong");
  bad("\n12\n", "\n13\n", "neither a hexahedron nor a quad");
  bad("\n9\n", "\n12\n", "neither a hexahedron nor a quad");
  bad("\n8 0", "\n8 27", "point 27 is not among the 27 points");
  bad("\n8 0", "\n8 4294967296", "point 4294967296 is not among");
  bad("\n8 0", "\n8 -1", "natural number");
  bad("CELL_TYPES 32", "CELL_TYPES 31", "unknown or misplaced keyword");
  bad("CELL_TYPES", "POINTS", "POINTS occurs twice");
  bad("CELLS ", std::string("CE\0LLS ", 7), "unknown or misplaced keyword 'CE?LLS'");
  const std::string new_style = examples::vtk_51(sample());
  expect_malformed("a.vtk",
                   replaced(new_style, "OFFSETS vtktypeint64\n0\n8", "OFFSETS vtktypeint64\n0\n7"),
                   "neither a hexahedron");
  expect_malformed("a.vtk",
                   replaced(new_style, "OFFSETS vtktypeint64\n0\n8", "OFFSETS vtktypeint64\n0\n99"),
                   "offsets of the cells");
}

TEST(ReadMesh, RefusesMalformedVtu) {
  const std::string ascii = examples::vtu_ascii(sample());
  const auto bad = [](const std::string& good, const std::string& from, const std::string& to,
                      const char* words) {
    expect_malformed("a.vtu", replaced(good, from, to), words);
  };
  expect_malformed("a.vtu", ascii.substr(0, ascii.size() / 2), "not XML");
  bad(ascii, "UnstructuredGrid\"", "PolyData\"", "a.vtu:2: the type is not");
  bad(ascii, "LittleEndian", "MiddleEndian", "unknown byte_order");
  bad(ascii, "NumberOfPoints=\"27\"", "NumberOfPoints=\"26\"", "too long");
  bad(ascii, "NumberOfPoints=\"27\"", "NumberOfPoints=\"28\"", "too early");
  bad(ascii, "NumberOfPoints=\"27\"", "NumberOfPoints=\"2147483646\"", "too early");
  bad(ascii, "NumberOfPoints=\"27\"", "", "natural number");
  bad(ascii, "Name=\"types\"", "Name=\"kinds\"", "there is no array types");
  bad(ascii, "Name=\"offsets\"", "Name=\"types\"", "occurs twice");
  bad(ascii, "\"UInt8\"", "\"Float32\"", "must hold integers");
  bad(ascii, "NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"", "3 components");
  bad(ascii, "</Piece>", "</Piece><Piece/>", "more than one element Piece");
  const std::string coded = examples::vtu_base64(sample());
  bad(coded, "LittleEndian", "BigEndian", "big-endian");
  bad(coded, "format=\"binary\">\niAI", "format=\"binary\">\niBI", "length");
  bad(coded, "format=\"binary\">\niAI", "format=\"binary\">\n!AI", "not base64");
  bad(coded, "NumberOfPoints=\"27\"", "NumberOfPoints=\"2147483646\"", "length");
  const std::string raw = examples::vtu_appended_raw(sample());
  bad(raw, "offset=\"0\"", "offset=\"1\"", "length");
  bad(raw, "offset=\"0\"", "offset=\"99999999\"", "outside the data");
  bad(raw, "</AppendedData>", "", "cut");
  bad(raw, ">\n_", ">\nx_", "does not begin with '_'");
  bad(kVtkInline, "vtkZLib", "vtkLZ4", "unknown compressor");
  bad(kVtkInline, "AQAAAACAAAAgAQAAMgAAAA==eF5j", "AQAAAACAAAAgAQAAMgAAAA==eF5k", "damaged");
  bad(kVtkInline, "AQAAAACAAAAgAQAAMgAAAA==", "////fwCAAAAgAQAAMgAAAA==", "more compressed blocks");
  bad(kVtkInline, "AQAAAACAAAAgAQAAMgAAAA==", "AQAAAACAAAAgAQAA////fw==", "too early");
}

// Three more than 2^61 words are more bytes than 64 bits count.
TEST(ReadMesh, RefusesMoreCompressedBlocksThanThereAreBytes) {
  const std::string header("\0\0\0\0\0\0\0\x20", 8);
  const std::string file =
      "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid>"
      "<Piece NumberOfPoints=\"1\" NumberOfCells=\"1\"><Points>"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0</DataArray>"
      "</Points><Cells>"
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"appended\" offset=\"0\"/>"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">1152921504606846975"
      "</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">12</DataArray>"
      "</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">\n_" +
      header + std::string(16, '\1') + "\n</AppendedData></VTKFile>\n";
  try {
    static_cast<void>(parse_mesh("a.vtu", file));
    ADD_FAILURE() << "is read";
  } catch (const Malformed& error) {
    EXPECT_NE(std::string(error.what()).find("too early"), std::string::npos) << error.what();
  }
}

TEST(ReadMesh, RefusesMalformedMedit) {
  const std::string good = examples::medit(sample());
  const auto bad = changes_of("a.mesh", good);
  bad("End", "", "too early");
  bad("End", "End more", "something follows End");
  bad("Formatted 2", "Formatted 99", "unknown version");
  bad("Dimension 3", "Dimension 2", "expected '3'");
  bad("Hexahedra", "Tetrahedra", "a cell is neither a hexahedron nor a quad");
  bad("Quadrilaterals", "Hexahedra", "occurs twice");
  bad("Vertices\n27", "Vertices\n26", "unknown or unsupported keyword");
  bad("Quadrilaterals\n24", "Quadrilaterals\n4000000000", "more than the rest");
  bad(" 27 ", " 28 ", "point 28 is not among the 27 points");
  bad(" 27 ", " 0 ", "point 0 is not among");
  bad(" 27 ", " 4294967298 ", "is not among");
  bad("\nVertices", "\nHexahedra 1 1 2 3 4 5 6 7 8 0\nVertices", "is not among the 0 points");
}

TEST(ReadMesh, RefusesMalformedGmsh) {
  const auto bad = [](const std::string& good, const std::string& from, const std::string& to,
                      const char* words) {
    expect_malformed("a.msh", replaced(good, from, to), words);
  };
  const std::string old_style = examples::gmsh_22(sample());
  bad(old_style, "2.2 0 8", "2.2 1 8", "a binary file; save it as ASCII");
  bad(old_style, "2.2 0 8", "2.2 2 8", "expected '0'");
  bad(old_style, "2.2", "3.0", "unknown version");
  bad(old_style, "\n2 ", "\n1 ", "zero or occurs twice");
  bad(old_style, "$EndNodes", "$EndNode", "expected '$EndNodes'");
  bad(old_style, " 5 2 0 1 1 ", " 5 2 0 1 28 ", "no node with tag 28");
  bad(old_style, " 5 2 0 1 1 ", " 4 2 0 1 1 ", "Gmsh type 4");
  bad(old_style, "$EndElements\n", "$EndElements\n$Elements\n0\n$EndElements\n", "misplaced");
  bad(old_style, "$EndElements\n", "$EndElements\n$More\n", "does not end");
  const std::string new_style = examples::gmsh_41(sample());
  bad(new_style, "1 27 1 27", "1 28 1 27", "the number of nodes is wrong");
  bad(new_style, "1 27 1 27", "1 27 1 26", "outside the stated range");
  bad(new_style, "2 32 1 32", "2 31 1 32", "the number of elements is wrong");
  bad(new_style, "3 1 0 27", "4 1 0 27", "starts wrongly");
}

TEST(ReadMesh, RefusesMalformedPolygons) {
  expect_malformed("a.obj", "v 0 0\n", "a.obj:1: a point has three");
  expect_malformed("a.obj", "v 0 0 0\nf 1 1 1\n", "a.obj:2: a face is not a quad");
  expect_malformed("a.obj", "v 0 0 0\nf 1 1 1 2\n", "a.obj:2: point 2 is not among");
  expect_malformed("a.obj", "f 1 1 1 -1\nv 0 0 0\n", "a.obj:1: point -1 is not among the 0");
  EXPECT_EQ(parse_surface("a.obj", "f 1 2 1 2\nv 0 0 0\nv 1 0 0\n").points.size(), 2U);
  expect_malformed("a.obj", "v 0 0 0\nf 1 1 1 0\n", "point 0 is not among");
  expect_malformed("a.obj", "v 0 0 0\nf 1 1 1 -2\n", "point -2 is not among");
  expect_malformed("a.obj", "v 0 0 0\nf 1 1 1 /1\n", "expected an integer");
  expect_malformed("a.obj", "curv 0 0 0\n", "unknown record 'curv'");
  expect_malformed("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 0\n", "a.off:4: a face is not a quad");
  expect_malformed("a.off", "OFF\n1 1 0\n0 0 0\n4 0 0 0 1\n", "point 1 is not among");
  expect_malformed("a.off", "OFF\n1 1 0\n0 0 0\n4 0 0 0 0\n4\n", "something follows");
  expect_malformed("a.off", "OFF\n1 4000000000 0\n0 0 0\n", "more than the rest");
  expect_malformed("a.stl", "solid\n", "a mesh file ends in");
}

TEST(ReadMesh, ReadsSurfacesWithColoursAndPolyData) {
  const Surface square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  const std::string head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n";
  const std::string points = "POINTS 4 double\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string polygons = "POLYGONS 1 5\n4 0 1 2 3\n";
  const std::string newer =
      "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET POLYDATA\n" + points +
      "POLYGONS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\n";
  for (const auto& [name, bytes] :
       {std::pair{"a.off",
                  std::string("COFF\n4 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3 4\n1 1 0 0 0 0\n0 1 0 0 0 0\n"
                              "4 0 1 2 3 1 0 0\n")},
        std::pair{"a.vtk", head + points + polygons},
        std::pair{"a.vtk", head + points + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n" + polygons +
                               "CELL_DATA 1\nSCALARS x int\n"},
        std::pair{"a.vtk", newer}}) {
    const Surface read = parse_surface(name, bytes);
    EXPECT_EQ(read.points, square.points);
    EXPECT_EQ(read.quads, square.quads);
  }
  const auto bad = [](const std::string& bytes, const std::string& reason) {
    expect_malformed("a.vtk", bytes, reason);
  };
  // The number of edges may be missing, as for the meshers.
  const std::string rest = "0 0 0\n1 0 0 9\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  for (const std::string heading :
       {"COFF\n4 1\n", "OFF 4 1\n", "OFF\n4 1 # two\n", "OFF\n4 1 4 \n"})
    EXPECT_EQ(parse_surface("a.off", heading + rest).points, square.points) << heading;
  expect_malformed("a.off", "COFF\n1 0 0\n0 0 0 red\n", "a.off:3: expected a number");
  expect_malformed("a.off", "COFF\n1 0 0\n0 0 0 1 2 3 4 5\n", "more numbers than a colour has");
  expect_malformed("a.off", "COFF\n1 0 0\n0 0\n0\n", "a.off:3: a point has three coordinates");
  bad(head + points, "POINTS and POLYGONS must both be present");
  bad(head + points + polygons + polygons, "POLYGONS occurs twice");
  bad(head + points + "POLYGONS 1 6\n5 0 1 2 3 0\n", "type 7");
  bad(head + points + "POLYGONS 1 5\n4 0 1 2 4\n", "point 4 is not among");
  bad(head + points + "CELLS 1 5\n4 0 1 2 3\n", "misplaced keyword 'CELLS'");
  bad(head + points + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n", "'TRIANGLE_STRIPS'");
}

TEST(ReadMesh, TellsFormatsApartByTheirFirstBytes) {
  const Mesh wanted = sample();
  for (const auto& [name, write] : examples::kMeshFormats) {
    SCOPED_TRACE(name);
    expect_equal(parse_mesh("standard input", write(wanted)), wanted);
    expect_equal(parse_mesh("/dev/fd/63", "\xEF\xBB\xBF" + write(wanted)), wanted);
  }
  const Surface surface{wanted.points, wanted.quads};
  for (const std::string& bytes :
       {examples::obj(surface), examples::off(surface), "# OFF\n" + examples::obj(surface),
        "# vtk\n" + examples::off(surface)}) {
    const Surface read = parse_surface("standard input", bytes);
    expect_equal({read.points, {}, read.quads}, {wanted.points, {}, wanted.quads});
  }
  expect_malformed("standard input", "", "is empty");
  expect_malformed("standard input", "# only a comment", "is empty");
  expect_malformed("standard input", "solid\n", "unknown record 'solid'");
  EXPECT_THROW(static_cast<void>(parse_mesh("standard input", examples::obj(surface))), Malformed);
}

}  // namespace
}  // namespace hexatlas::check
