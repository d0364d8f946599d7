// Claim. Every defect of an OBJ, OFF or MEDIT file, and of a file of hexahedra, is refused with
// InvalidInput at its line.
// Oracle. Hand-made defects in the samples, with the line counted by hand.
#include "tests/meshing/io/malformed.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

TEST(Malformed, EmptyBlankAndBinaryFiles) {
  for (const FileFormat format : {obj, off, vtk, vtu, medit, gmsh}) {
    expect_surfaces_refused({{format, "", 0, "is empty"}, {format, "\xEF\xBB\xBF", 0, "is empty"}});
    for (const std::string& bytes : {std::string("\n\n"), std::string(" "), kGarbage})
      EXPECT_THROW(static_cast<void>(io::parse_surface(bytes, format, "f")), core::InvalidInput);
  }
}

TEST(Malformed, Obj) {
  expect_surfaces_refused({
      {obj, "# nothing\n", 0, "contains no quad"},
      {obj, "v 0 0 0\n", 0, "contains no quad"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1 4 3"), 13, "triangle; every facet must be a quad"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1 4 3 2 5"), 13, "pentagon; every facet must be a quad"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1 2 3 4 5 6"), 13, "hexagon; every facet must be a quad"},
      {obj, edit(kObj, "f 1 4 3 2", "f"), 13, "polygon; every facet must be a quad"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1 0 3 2"), 13, "index 0 is below 1"},
      {obj, edit(kObj, "f 4 1 5 8", "f 4 1 5 9"), 18, "index 9 is too large: there are 8 points"},
      {obj, edit(kObj, "f 4 1 5 8", "f 4 1 5 4294967298"), 18, "index 4294967298 is too large"},
      {obj, edit(kObj, "f 4 1 5 8", "f 4 1 5 9223372036854775808"), 18, "too large"},
      {obj, edit(kObj, "f -6", "f -9"), 17, "index -9 counts back beyond the first of 8"},
      {obj, edit(kObj, "f -6", "f -9223372036854775808"), 17, "counts back"},
      {obj, edit(kObj, "f -6", "f --6"), 17, "'--6' is not an integer"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1 4 1 2"), 13, "quad with a repeated vertex"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1 4 3 -5"), 13, "quad with a repeated vertex"},
      {obj, edit(kObj, "f 1 4 3 2", "f 1.5 4 3 2"), 13, "'1.5' is not an integer"},
      {obj, edit(kObj, "f 1 4 3 2", "f 0x1 4 3 2"), 13, "is not an integer"},
      {obj, edit(kObj, "5/1", "5/"), 14, "is not an integer"},
      {obj, edit(kObj, "5/1", "/1"), 14, "is not an integer"},
      {obj, edit(kObj, "5/1", "5/0"), 14, "index 0 in '5/0'"},
      {obj, edit(kObj, "1//1", "1//"), 15, "is not an integer"},
      {obj, edit(kObj, "2/1/1", "2/1/1/1"), 16, "is not an integer"},
      {obj, edit(kObj, "v 1 1 0", "v 1 1"), 5, "vertex with 2 numbers"},
      {obj, edit(kObj, "v 1 1 0", "v 1 1 0 1 1 1 1 1"), 5, "vertex with 8 numbers"},
      {obj, edit(kObj, "v 1 1 0", "v 1 nan 0"), 5, "'nan' is not a finite number"},
      {obj, edit(kObj, "v 1 1 0", "v 1 -inf 0"), 5, "'-inf' is not a finite number"},
      {obj, edit(kObj, "v 1 1 0", "v 1 1e400 0"), 5, "outside the range of double precision"},
      {obj, edit(kObj, "v 1 1 0", "v 1 1e-400 0"), 5, "outside the range of double precision"},
      {obj, edit(kObj, "v 1 1 0", "v 1 0,5 0"), 5, "'0,5' is not a number"},
      {obj, edit(kObj, "v 1 1 0", "v 1 0x1p3 0"), 5, "'0x1p3' is not a number"},
      {obj, edit(kObj, "v 1 1 0", "v 1 1d0 0"), 5, "'1d0' is not a number"},
      {obj, edit(kObj, "v 1 1 0", "v 1 +-1 0"), 5, "'+-1' is not a number"},
      {obj, edit(kObj, "vt 0 0", "wurst 0 0"), 11, "unknown record 'wurst'"},
      {obj, edit(kObj, "vt 0 0", std::string("vt\0 0", 5)), 11, "NUL byte"},
      {obj, edit(kObj, "vt 0 0", std::string(100000, 'x')), 11, "unknown record 'xxxx"},
  });
}

TEST(Malformed, ObjLineOfManyWords) {
  std::string line = "l";
  for (int i = 0; i < 1 << 20; ++i) line += " 1";
  expect_surfaces_refused({{obj, line + "\n" + kObj, 1, "line of more than 1048576 words"}});
}

TEST(Malformed, Off) {
  const std::string last = "4 3 0 4 7\n";
  expect_surfaces_refused({
      {off, "OFF\n", 1, "the file ends where the counts is expected"},
      {off, "OFF\n4 1 0\n", 2, "count 4 is too large"},
      {off, edit(kOff, "OFF", "4OFF"), 1, "OFF or COFF is expected, not '4OFF'"},
      {off, edit(kOff, "OFF", "OFF BINARY"), 1, "binary OFF; save as ASCII"},
      {off, edit(kOff, "8 6 12", "8"), 3, "vertices, faces and edges are expected"},
      {off, edit(kOff, "8 6 12", "8 6 12 0"), 3, "vertices, faces and edges are expected"},
      {off, edit(kOff, "8 6 12", "-8 6 12"), 3, "count -8 is negative"},
      {off, edit(kOff, "8 6 12", "8 -6 12"), 3, "count -6 is negative"},
      {off, edit(kOff, "8 6 12", "8 6 -1"), 3, "number of edges is negative"},
      {off, edit(kOff, "8 6 12", "9223372036854775808 6 0"), 3, "too large"},
      {off, edit(kOff, "8 6 12", "9223372036854775807 6 0"), 3, "is too large: only"},
      {off, edit(kOff, "8 6 12", "8 4294967302 0"), 3, "is too large: only"},
      {off, edit(kOff, "8 6 12", "8.0 6 12"), 3, "'8.0' is not an integer"},
      {off, edit(kOff, "8 6 12", "7 6 12"), 11, "face of 0 corners"},
      {off, edit(kOff, "8 6 12", "9 6 12"), 17, "the file ends where a face is expected"},
      {off, edit(kOff, "8 6 12", "8 5 12"), 17, "more lines than the counts announce"},
      {off, edit(kOff, "8 6 12", "8 7 12"), 17, "the file ends where a face is expected"},
      {off, edit(kOff, "8 6 12", "8 0 12"), 12, "more lines than the counts announce"},
      {off, until(kOff, "0 1 1\n"), 11, "the file ends where a face is expected"},
      {off, edit(kOff, last, "4 3 0 4 8\n"), 17, "index 8 is too large: there are 8 points"},
      {off, edit(kOff, last, "4 3 0 4 -1\n"), 17, "index -1 is below 0"},
      {off, edit(kOff, last, "4 3 0 4 4294967299\n"), 17, "index 4294967299 is too large"},
      {off, edit(kOff, last, "4 3 0 4\n"), 17, "face of 4 corners on a line with 3"},
      {off, edit(kOff, last, "-4 3 0 4 7\n"), 17, "face of -4 corners"},
      {off, edit(kOff, last, "3 3 0 4\n"), 17, "triangle; every facet must be a quad"},
      {off, edit(kOff, last, "5 3 0 4 7 1\n"), 17, "pentagon; every facet must be a quad"},
      {off, edit(kOff, last, "2 3 0\n"), 17, "polygon; every facet must be a quad"},
      {off, edit(kOff, last, "4 3 0 3 0\n"), 17, "quad with a repeated vertex"},
      {off, edit(kOff, last, "4 3 0 4 7 red\n"), 17, "'red' is not a number"},
      {off, edit(kOff, last, "4 3 0 4 7 1 2 3 4 5\n"), 17, "more numbers than a colour has"},
      {off, edit(kOff, "1 1 0\n", "1 1\n"), 6, "fewer than 3 coordinates"},
      {off, edit(kOff, "1 1 0\n", "1 1 inf\n"), 6, "'inf' is not a finite number"},
      {off, edit(kOff, "1 1 0\n", "1 1 NaN\n"), 6, "'NaN' is not a finite number"},
      {off, edit(kOff, "1 1 0\n", "1 1 -1e999\n"), 6, "outside the range of double precision"},
      {off, edit(kOff, "1 1 0\n", "1 1 1,0\n"), 6, "'1,0' is not a number"},
      {off, edit(kOff, "a box", std::string("\0", 1)), 2, "NUL byte"},
  });
}

TEST(Malformed, Medit) {
  const std::string first = "1 4 3 2 0\n";
  expect_surfaces_refused({
      {medit, "MeshVersionFormatted 2\n", 1, "the file ends where a section or End is expected"},
      {medit, "MeshVersionFormatted 2\nDimension 3\nEnd\n", 0, "contains no quad"},
      {medit, edit(kMedit, "Formatted 1", "Formatted 99"), 1, "unsupported version 99"},
      {medit, edit(kMedit, "Formatted 1", "Unformatted 1"), 1, "save as ASCII"},
      {medit, edit(kMedit, "MeshVersionFormatted", "Mesh"), 1, "is expected, not 'Mesh'"},
      {medit, edit(kMedit, "Dimension\n3", "Dimension\n2"), 4, "Dimension 2; it must be 3"},
      {medit, edit(kMedit, "Dimension\n3", "\n"), 6, "Dimension is expected before 'Vertices'"},
      {medit, edit(kMedit, "Vertices\n8", "Vertices\n-8"), 7, "count -8 is negative"},
      {medit, edit(kMedit, "Vertices\n8", "Vertices\n2147483647"), 7, "is too large: only"},
      {medit, edit(kMedit, "Vertices\n8", "Vertices\n9223372036854775807"), 7, "is too large"},
      {medit, edit(kMedit, "Vertices\n8", "Vertices\n9223372036854775808"), 7, "is too large"},
      {medit, edit(kMedit, "Vertices\n8", "Vertices\n7"), 15, "unknown section '0'"},
      {medit, edit(kMedit, "Vertices\n8", "Vertices\n9"), 17, "'Edges' is not a number"},
      {medit, edit(kMedit, "1 1 0 1\n", "1 1e400 0 1\n"), 10, "outside the range"},
      {medit, edit(kMedit, "1 1 0 1\n", "1 infinity 0 1\n"), 10, "not a finite number"},
      {medit, edit(kMedit, "1 1 0 1\n", "1 1;0 0 1\n"), 10, "'1;0' is not a number"},
      {medit, edit(kMedit, "1 1 0 1\n", "1 1 0 1.5\n"), 10, "'1.5' is not an integer"},
      {medit, edit(kMedit, "Quadrilaterals\n6", "Quadrilaterals\n5"), 27, "unknown section '4'"},
      {medit, edit(kMedit, "Quadrilaterals\n6", "Quadrilaterals\n7"), 28, "'Corners' is not"},
      {medit, edit(kMedit, "Quadrilaterals\n6", "Quadrilaterals\n4000000000"), 21, "too large"},
      {medit, edit(kMedit, "Quadrilaterals\n6", "Quadrilaterals\n-1"), 21, "negative"},
      {medit, edit(kMedit, first, "0 4 3 2 0\n"), 22, "index 0 is below 1"},
      {medit, edit(kMedit, first, "-1 4 3 2 0\n"), 22, "index -1 is below 1"},
      {medit, edit(kMedit, first, "9 4 3 2 0\n"), 22, "index 9 is too large: there are 8 points"},
      {medit, edit(kMedit, first, "4294967298 4 3 2 0\n"), 22, "index 4294967298 is too large"},
      {medit, edit(kMedit, first, "2 4 3 2 0\n"), 22, "quad with a repeated vertex"},
      {medit, edit(kMedit, first, "1 4 3 zwei 0\n"), 22, "'zwei' is not an integer"},
      {medit, edit(kMedit, first, "1 4 3 2\n"), 23, "index 0 is below 1"},
      {medit, edit(kMedit, "1 2 7\n", "1 9 7\n"), 19, "index 9 is too large"},
      {medit, edit(kMedit, "Corners 2\n1\n2\n", "Triangles 1\n1 2 3 0\n"), 29,
       "triangle; every facet must be a quad"},
      {medit, edit(kMedit, "Corners 2\n1\n2\n", "Tetrahedra 1\n1 2 3 4 0\n"), 29,
       "tetrahedron; this is a volume mesh"},
      {medit, kHexMedit, 15, "hexahedron; this is a volume mesh"},
      {medit, edit(kMedit, "Corners 2", "Corners 3"), 31, "'Normals' is not a number"},
      {medit, edit(kMedit, "Corners 2", "Corners 9999999999"), 28, "is too large"},
      {medit, edit(kMedit, "Corners 2", "Wurst 2"), 28, "unknown section 'Wurst'"},
      {medit, edit(kMedit, "Corners 2", "Vertices 2"), 28, "second section 'Vertices'"},
      {medit, edit(kMedit, "Corners 2", std::string("Cor\0ners 2", 10)), 28, "NUL byte"},
      {medit, edit(kMedit, "End\n", ""), 33, "the file ends where a section or End is expected"},
      {medit, kMedit + "Vertices 0\n", 34, "text after the keyword End"},
  });
}

TEST(Malformed, Hexahedra) {
  const auto parse = io::parse_hexahedra;
  expect_all_refused(
      {
          {obj, kObj, 0, "the format .obj is not one for hexahedra (known: .vtk .vtu .mesh .msh)"},
          {off, kOff, 0, "the format .off is not one for hexahedra"},
          {medit, kMedit, 0, "contains no hexahedron"},
          {vtk, kVtkPoly, 0, "contains no hexahedron"},
          {medit, edit(kHexMedit, "Hexahedra 1\n1 2 3 4 5 6 7 8", "Tetrahedra 1\n1 2 3 4"), 15,
           "tetrahedron; every cell must be a hexahedron"},
          {medit, edit(kHexMedit, "5 6 7 8", "5 6 7 7"), 15, "hexahedron with a repeated vertex"},
          {medit, edit(kHexMedit, "5 6 7 8", "5 6 7 9"), 15, "index 9 is too large"},
          {vtk, edit(kHexVtk, "\n12\n", "\n13\n"), 15, "wedge with 8 vertices"},
          {vtk, edit(kHexVtk, "\n12\n", "\n42\n"), 15, "polyhedron; every cell must be"},
          {vtu, edit(kHexVtu, ">12<", ">25<"), 6, "quadratic hexahedron with 8 vertices"},
          {gmsh, edit(kHexGmsh4, "3 1 5 1", "3 1 6 1"), 27, "prism; every cell must be"},
          {gmsh, edit(kHexGmsh4, "6 7 8\n$EndE", "6 7 2\n$EndE"), 27, "repeated vertex"},
      },
      parse);
}

}  // namespace
