// Claim. Every defect of a file is refused with InvalidInput at its line; no prefix of a file is
// taken for another mesh.
// Oracle. Hand-made defects in the samples, with the line counted by hand; for prefixes, the mesh
// of the whole file.
#include <gtest/gtest.h>

#include <cctype>
#include <limits>
#include <stdexcept>

#include "enum/core/errors.hpp"
#include "tests/meshing/io/samples.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

/// The text with its first `from` replaced; the defect must find its place.
std::string edit(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("nothing to edit: " + from);
  return text.replace(at, from.size(), to);
}

/// The text up to and including the first `last`.
std::string until(const std::string& text, const std::string& last) {
  return text.substr(0, text.find(last) + last.size());
}

struct Malformed {
  FileFormat format;
  std::string bytes;
  std::size_t line;  ///< 0: none in the message
  std::string reason;
};

void expect_refused(const Malformed& bad, const std::string& message) {
  const std::string start = bad.line == 0 ? "f: " : "f:" + std::to_string(bad.line) + ": ";
  EXPECT_EQ(message.substr(0, start.size()), start) << message;
  EXPECT_NE(message.find(bad.reason), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

template <class Parse>
void expect_all_refused(const std::vector<Malformed>& table, const Parse& parse) {
  for (const Malformed& bad : table) {
    try {
      static_cast<void>(parse(bad.bytes, bad.format, "f"));
      ADD_FAILURE() << "accepted; expected: " << bad.line << ": " << bad.reason;
    } catch (const core::InvalidInput& error) {
      expect_refused(bad, error.what());
    }
  }
}

void expect_surfaces_refused(const std::vector<Malformed>& table) {
  expect_all_refused(table, io::parse_surface);
}

const std::string kGarbage(
    "\x7f"
    "ELF\x02\x01\x00\x00\x9a\xff\n\x03\x00\xfe",
    14);

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

TEST(Malformed, Vtk) {
  expect_surfaces_refused({
      {vtk, "# vtk DataFile Version 3.0\n", 1, "the file ends where ASCII is expected"},
      {vtk, edit(kVtkGrid, "# vtk", "# vtl"), 1, "'# vtk DataFile Version x.y' is expected"},
      {vtk, edit(kVtkGrid, "3.0", "99.0"), 1, "unsupported version '99.0'"},
      {vtk, edit(kVtkGrid, "ASCII", "BINARY"), 3, "save as ASCII"},
      {vtk, edit(kVtkGrid, "ASCII", "TEXT"), 3, "ASCII is expected, not 'TEXT'"},
      {vtk, edit(kVtkGrid, "DATASET", "DATA"), 4, "DATASET is expected"},
      {vtk, edit(kVtkGrid, "UNSTRUCTURED_GRID", "STRUCTURED_GRID"), 4, "'STRUCTURED_GRID'"},
      {vtk, edit(kVtkGrid, "POINTS 8", "POINTS -8"), 8, "count -8 is negative"},
      {vtk, edit(kVtkGrid, "POINTS 8", "POINTS 2147483647"), 8, "is too large: only"},
      {vtk, edit(kVtkGrid, "POINTS 8", "POINTS 9223372036854775808"), 8, "too large"},
      {vtk, edit(kVtkGrid, "POINTS 8", "POINTS 9"), 17, "'CELLS' is not a number"},
      {vtk, edit(kVtkGrid, "POINTS 8", "POINTS 7"), 16, "unknown section '0'"},
      {vtk, edit(kVtkGrid, "8 double", "8 string"), 8, "unknown type of numbers 'string'"},
      {vtk, edit(kVtkGrid, "1 1 0\n", "1 nan 0\n"), 11, "'nan' is not a finite number"},
      {vtk, edit(kVtkGrid, "1 1 0\n", "1 1e400 0\n"), 11, "outside the range"},
      {vtk, edit(kVtkGrid, "1 1 0\n", "1 1,0 0\n"), 11, "'1,0' is not a number"},
      {vtk, edit(kVtkGrid, "CELLS 8 35", "CELLS 7 35"), 24, "shorter than its announced size"},
      {vtk, edit(kVtkGrid, "CELLS 8 35", "CELLS 9 37"), 26, "'CELL_TYPES' is not an integer"},
      {vtk, edit(kVtkGrid, "CELLS 8 35", "CELLS 8 34"), 25, "exceeds the size of the list"},
      {vtk, edit(kVtkGrid, "CELLS 8 35", "CELLS 8 36"), 25, "shorter than its announced size"},
      {vtk, edit(kVtkGrid, "CELLS 8 35", "CELLS -8 35"), 17, "count -8 is negative"},
      {vtk, edit(kVtkGrid, "CELLS 8 35", "CELLS 4000000000 35"), 17, "is too large: only"},
      {vtk, edit(kVtkGrid, "4 0 3 2 1\n", "4 0 3 2 8\n"), 19, "index 8 is too large"},
      {vtk, edit(kVtkGrid, "4 0 3 2 1\n", "4 0 3 2 -1\n"), 19, "index -1 is below 0"},
      {vtk, edit(kVtkGrid, "4 0 3 2 1\n", "4 0 3 2 4294967296\n"), 19, "is too large"},
      {vtk, edit(kVtkGrid, "4 0 3 2 1\n", "4 0 3 2 0\n"), 19, "quad with a repeated vertex"},
      {vtk, edit(kVtkGrid, "4 0 3 2 1\n", "-1 0 3 2 1\n"), 19, "a cell of -1 vertices"},
      {vtk, edit(kVtkGrid, "2 0 1\n", "2 0 8\n"), 18, "index 8 is too large"},
      {vtk, edit(kVtkGrid, "CELL_TYPES 8\n3\n9", "CELL_TYPES 8\n3\n5"), 19,
       "triangle with 4 vertices"},
      {vtk, edit(kVtkGrid, "CELL_TYPES 8\n3\n9", "CELL_TYPES 8\n3\n10"), 19,
       "this is a volume mesh"},
      {vtk, edit(kVtkGrid, "CELL_TYPES 8\n3\n9", "CELL_TYPES 8\n3\n99"), 28,
       "cell of unknown type 99"},
      {vtk, edit(kVtkGrid, "CELL_TYPES 8", "CELL_TYPES 7"), 26, "7 cell types for 8 cells"},
      {vtk, edit(kVtkGrid, "CELL_TYPES 8", "CELL_KINDS 8"), 26, "unknown section 'CELL_KINDS'"},
      {vtk, until(kVtkGrid, "1 2\n"), 25, "the file ends where CELL_TYPES is expected"},
      {vtk, until(kVtkGrid, "0 1 1\n"), 0, "contains no quad"},
      {vtk, edit(kVtkGrid, "TIME 1 1", "TIME 1000000 1000000"), 6, "too large"},
      {vtk, edit(kVtkGrid, "an edge", std::string("\0", 1)), 2, "NUL byte"},
      {vtk, edit(kVtkPoly, "4 0 3 2 1\n", "3 0 3 2\n"), 15, "shorter than its announced size"},
      {vtk, edit(edit(kVtkPoly, "4 0 3 2 1\n", "3 0 3 2\n"), "6 30", "6 29"), 10,
       "triangle; every facet must be a quad"},
      {vtk, edit(kVtkPoly, "POLYGONS", "TRIANGLE_STRIPS"), 10, "triangle strip; every facet"},
      {vtk, edit(kVtk5, "0 4 8", "1 4 8"), 16, "offset 1 is not in order"},
      {vtk, edit(kVtk5, "4 8 12", "4 12 8"), 16, "offset 8 is not in order"},
      {vtk, edit(kVtk5, "20 24", "20 23"), 16, "the last offset is not the size"},
      {vtk, edit(kVtk5, "20 24", "20 25"), 16, "offset 25 is not in order"},
      {vtk, edit(kVtk5, "0 4 8", "0 3 8"), 18, "quad with 3 vertices"},
      {vtk, edit(kVtk5, "OFFSETS vtk", "OFFSET vtk"), 15, "OFFSETS is expected"},
      {vtk, edit(kVtk5, "0 3 2 1", "0 3 2 8"), 18, "index 8 is too large"},
  });
}

TEST(Malformed, Vtu) {
  const auto root = [](const std::string& attributes) {
    return edit(kVtuAscii, "version=\"0.1\" byte_order=\"LittleEndian\"", attributes);
  };
  const std::string points = "BgAAAAkJCQkJCQ==";
  expect_surfaces_refused({
      {vtu, "<?xml version=\"1.0\"?>\n", 1, "XML: No document element"},
      {vtu, "<html></html>\n", 1, "the element VTKFile is expected"},
      {vtu, until(kVtuAscii, "4 8 12"), 23, "XML: "},
      {vtu, edit(kVtuAscii, "</Points>", "</Point>"), 12, "XML: "},
      {vtu, edit(kVtuAscii, "UnstructuredGrid\"", "PolyData\""), 2, "'PolyData'"},
      {vtu, root("version=\"7.0\""), 2, "unsupported version '7.0'"},
      {vtu, root("byte_order=\"BigEndian\""), 2, "LittleEndian is expected"},
      {vtu, root("header_type=\"Int8\""), 2, "unknown header_type 'Int8'"},
      {vtu, root("compressor=\"vtkLZ4DataCompressor\""), 2, "use vtkZLibDataCompressor or none"},
      {vtu, edit(kVtuAscii, "<Cells>", "<Zellen></Zellen><!--"), 31, "XML: "},
      {vtu, edit(kVtuAscii, "Name=\"types\"", ""), 13, "Cells without the array types"},
      {vtu, edit(kVtuAscii, "NumberOfPoints=\"8\"", ""), 4, "Piece without NumberOfPoints"},
      {vtu, edit(kVtuAscii, "NumberOfPoints=\"8\"", "NumberOfPoints=\"7\""), 7, "21 are expected"},
      {vtu, edit(kVtuAscii, "NumberOfPoints=\"8\"", "NumberOfPoints=\"-8\""), 4, "out of range"},
      {vtu, edit(kVtuAscii, "NumberOfPoints=\"8\"", "NumberOfPoints=\"9223372036854775808\""), 4,
       "too large"},
      {vtu, edit(kVtuAscii, "NumberOfCells=\"6\"", "NumberOfCells=\"5\""), 22, "5 are expected"},
      {vtu, edit(kVtuAscii, "NumberOfCells=\"6\"", "NumberOfCells=\"7\""), 22, "7 are expected"},
      {vtu, edit(kVtuAscii, "NumberOfCells=\"6\"", "NumberOfCells=\"x\""), 4, "not an integer"},
      {vtu, edit(kVtuAscii, "Components=\"3\"", "Components=\"2\""), 7, "3 components"},
      {vtu, edit(kVtuAscii, "0 1 0 0", "0 1 nan 0"), 8, "'nan' is not a finite number"},
      {vtu, edit(kVtuAscii, "0 1 0 0", "0 1e999 0 0"), 8, "outside the range"},
      {vtu, edit(kVtuAscii, "0 1 0 0", "0 0,1 0 0"), 8, "'0,1' is not a number"},
      {vtu, edit(kVtuAscii, "1 2 6 5", "1 2 6 8"), 18, "index 8 is outside the list of 8 points"},
      {vtu, edit(kVtuAscii, "1 2 6 5", "1 2 6 -1"), 18, "index -1 is outside"},
      {vtu, edit(kVtuAscii, "1 2 6 5", "1 2 6 4294967298"), 18, "index 4294967298 is outside"},
      {vtu, edit(kVtuAscii, "1 2 6 5", "1 2 6 6"), 18, "quad with a repeated vertex"},
      {vtu, edit(kVtuAscii, "1 2 6 5", "1 2 6"), 18, "quad with a repeated vertex"},
      {vtu, edit(kVtuAscii, "1 2 6 5", "1 2 6 5 5"), 14,
       "the array of connectivity has 25 numbers; 24 are expected"},
      {vtu, edit(kVtuAscii, "3 0 4 7", "3 0 4 7 7"), 14, "24 are expected"},
      {vtu, edit(kVtuAscii, "4 8 12", "4 2 12"), 23, "offset 2 is not in order"},
      {vtu, edit(kVtuAscii, "9 9 9 9 9 9", "9 9 5 9 9 9"), 17, "triangle with 4 vertices"},
      {vtu, edit(kVtuAscii, "9 9 9 9 9 9", "9 9 10 9 9 9"), 17, "this is a volume mesh"},
      {vtu, edit(kVtuAscii, "9 9 9 9 9 9", "9 9 77 9 9 9"), 26, "cell of unknown type 77"},
      {vtu, edit(kVtuAscii, "4 8 12 16 20 24", "4 8 <!-- --> 12"), 23, "two pieces of text"},
      {vtu, edit(kVtuAscii, "4 8 12", std::string("4\0 8 12", 7)), 23, "NUL byte"},
      {vtu, edit(kVtuAscii, "format=\"ascii\"", "format=\"morse\""), 7, "unknown format 'morse'"},
      {vtu, edit(kVtuInline, "Float32", "Int32"), 4, "coordinates of type 'Int32'"},
      {vtu, edit(kVtuInline, "Float32", "Float64"), 4, "points has 12 numbers; 24 are expected"},
      {vtu, edit(kVtuInline, "UInt8", "Float32"), 13, "integers of type 'Float32'"},
      {vtu, edit(kVtuInline, "UInt8", "Int16"), 13,
       "the array of types has 3 numbers; 6 are expected"},
      {vtu, edit(kVtuInline, "UInt8", "Int32"), 13, "array ends within a number"},
      {vtu, edit(kVtuInline, points, "BgAAAAkJ!QkJCQ=="), 13, "'!' in base64 text"},
      {vtu, edit(kVtuInline, points, "BgAAAAkJCQkJC"), 13, "base64 text is cut"},
      {vtu, edit(kVtuInline, points, "BgAAAAkJ"), 13, "is cut"},
      {vtu, edit(kVtuInline, points, "BgAA"), 13, "is cut"},
      {vtu, edit(kVtuInline, points, ""), 13, "is cut"},
      {vtu, edit(kVtuInline, points, "/////wkJCQkJCQ=="), 13, "array of 4294967295 bytes is cut"},
      {vtu, edit(kVtuInline, points, "BwAAAAkJCQkJCQ=="), 13, "base64 text"},
      {vtu, edit(kVtuInline, points, "BQAAAAkJCQkJCQ=="), 13, "the array of types has 5 numbers"},
      {vtu, edit(kVtuInline, points, "BgAAAAk=CQkJCQ=="), 13, "base64 text ends before its array"},
      {vtu, edit(kVtuInline, "AAgD8A", "AAwH8A"), 4, "not a finite number"},
      {vtu, edit(kVtuCompressed, "eNrj5", "eNrj6"), 15, "compressed block is damaged"},
      {vtu, edit(kVtuCompressed, "AQAAAEAAAAAGAAAACwAAAA==", "AQAAAEAAAAAHAAAACwAAAA=="), 15,
       "compressed block is damaged"},
      {vtu, edit(kVtuCompressed, "AQAAAEAAAAAGAAAACwAAAA==", "AQAAAEAAAAD///8/CwAAAA=="), 15,
       "compressed block cannot have its size"},
      {vtu, edit(kVtuCompressed, "AQAAAEAAAAAGAAAACwAAAA==", "AQAAAEAAAAAGAAAA/////w=="), 15,
       "is cut"},
      {vtu, edit(kVtuCompressed, "AQAAAEAAAAAGAAAACwAAAA==", "/////0AAAAAGAAAACwAAAA=="), 15,
       "is cut"},
      {vtu, edit(vtu_raw(), "offset=\"0\"", "offset=\"1000000\""), 4, "outside the appended data"},
      {vtu, edit(vtu_raw(), "offset=\"0\"", "offset=\"-1\""), 4, "outside the appended data"},
      {vtu, edit(vtu_raw(), "offset=\"0\"", "offset=\"3\""), 4, "has 0 numbers"},
      {vtu, edit(vtu_raw(), "\"raw\"", "\"hex\""), 11, "unknown encoding 'hex'"},
      {vtu, edit(vtu_raw(), "\n_", "\n"), 11, "appended data must begin with '_'"},
      {vtu, edit(vtu_raw(), "</AppendedData>", ""), 11, "ends within the appended data"},
  });
}

TEST(Malformed, VtuOfManyTagsOrSharedArrays) {
  std::string nested;
  for (int i = 0; i < 100'001; ++i) nested += "<a>";
  expect_surfaces_refused({{vtu, nested, 0, "XML tags"}});
  // Pieces that share their arrays would multiply the file.
  const std::string raw = vtu_raw();
  const std::size_t begin = raw.find("<Piece"), end = raw.find("</UnstructuredGrid>");
  std::string shared = raw;
  for (int i = 0; i < 100; ++i) shared.insert(end, raw.substr(begin, end - begin));
  EXPECT_THROW(static_cast<void>(io::parse_surface(shared, vtu, "f")), core::InvalidInput);
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

TEST(Malformed, Gmsh2) {
  const std::string first = "3 3 2 0 1 10 8 7 20\n";
  expect_surfaces_refused({
      {gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", 0, "contains no quad"},
      {gmsh, edit(kGmsh2, "$MeshFormat", "$Mesh"), 1, "$MeshFormat is expected, not '$Mesh'"},
      {gmsh, edit(kGmsh2, "2.2 0", "1.0 0"), 2, "unsupported version '1.0'"},
      {gmsh, edit(kGmsh2, "2.2 0", "4.0 0"), 2, "unsupported version '4.0'"},
      {gmsh, edit(kGmsh2, "2.2 0", "2.2 2"), 2, "0 (ASCII) or 1 (binary) is expected"},
      {gmsh, edit(kGmsh2, "2.2 0 8", "2.2 0 4"), 2, "8 bytes"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n-8"), 9, "count -8 is negative"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n4294967304"), 9, "is too large: only"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n9"), 18, "'$EndNodes' is not an integer"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n7"), 17, "$EndNodes is expected, not '60'"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "7 1 nan 0\n"), 12, "'nan' is not a finite number"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "7 1 1e400 0\n"), 12, "outside the range"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "20 1 1 0\n"), 12, "second node with tag 20"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "0 1 1 0\n"), 12, "node tag 0 is not positive"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "-7 1 1 0\n"), 12, "node tag -7 is not positive"},
      {gmsh, edit(kGmsh2, "$Elements\n8", "$Elements\n7"), 28, "$EndElements is expected"},
      {gmsh, edit(kGmsh2, "$Elements\n8", "$Elements\n9"), 29, "'$EndElements' is not"},
      {gmsh, edit(kGmsh2, "$Elements\n8", "$Elements\n9223372036854775808"), 20, "too large"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 21\n"), 23, "there is no node with tag 21"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 0\n"), 23, "there is no node with tag 0"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 4294967306\n"), 23, "there is no node"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 7\n"), 23, "quad with a repeated vertex"},
      {gmsh, edit(kGmsh2, first, "3 3 -2 0 1 10 8 7 20\n"), 23, "count -2 is negative"},
      {gmsh, edit(kGmsh2, first, "3 2 2 0 1 10 8 7\n"), 23, "triangle; every facet must be a quad"},
      {gmsh, edit(kGmsh2, first, "3 10 0 10 8 7 20 30 40 60 10 8\n"), 23, "second-order quad"},
      {gmsh, edit(kGmsh2, first, "3 4 2 0 1 10 8 7 20\n"), 23, "this is a volume mesh"},
      {gmsh, edit(kGmsh2, first, "3 140 2 0 1 10 8 7 20\n"), 23, "element of unknown type 140"},
      {gmsh, edit(kGmsh2, "$EndNodes", "$EndNode"), 18, "$EndNodes is expected"},
      {gmsh, edit(kGmsh2, "$EndElements\n", ""), 28, "ends where $EndElements is expected"},
      {gmsh, edit(kGmsh2, "$PhysicalNames", "$Wurst"), 4, "unknown section '$Wurst'"},
      {gmsh, edit(kGmsh2, "$EndPhysicalNames", "$"), 4, "no '$EndPhysicalNames' follows"},
      {gmsh, kGmsh2.substr(0, kGmsh2.find("$Physical")) + kGmsh2.substr(kGmsh2.find("$Elements")),
       4, "$Elements before $Nodes"},
      {gmsh, kGmsh2 + "$Nodes\n0\n$EndNodes\n", 30, "second section $Nodes"},
      {gmsh, kGmsh2 + "$Elements\n0\n$EndElements\n", 30, "second section $Elements"},
      {gmsh, kGmsh2 + std::string("\0", 1), 30, "NUL byte"},
  });
}

TEST(Malformed, Gmsh4) {
  expect_surfaces_refused({
      {gmsh, edit(kGmsh4, "2 8 1 50", "3 8 1 50"), 28, "'$EndNodes' is not an integer"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "1 8 1 50"), 12, "fewer nodes in the blocks"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 7 1 50"), 13, "more objects in the blocks"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 9 1 50"), 27, "fewer nodes in the blocks"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 -8 1 50"), 9, "count -8 is negative"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 9223372036854775807 1 50"), 9, "is too large"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "1e9 8 1 50"), 9, "'1e9' is not an integer"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "2 1 1 4294967303"), 13, "is too large"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "2 1 1 -7"), 13, "count -7 is negative"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "2 1 2 7"), 13, "0 or 1 is expected"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "9 1 1 7"), 13, "entity of dimension 9"},
      {gmsh, edit(kGmsh4, "\n3\n4\n", "\n3\n3\n"), 16, "second node with tag 3"},
      {gmsh, edit(kGmsh4, "\n3\n4\n", "\n3\n0\n"), 16, "node tag 0 is not positive"},
      {gmsh, edit(kGmsh4, "1 1 0 0.5", "1 inf 0 0.5"), 22, "'inf' is not a finite number"},
      {gmsh, edit(kGmsh4, "2 7 1 7", "2 6 1 7"), 33, "more objects in the blocks"},
      {gmsh, edit(kGmsh4, "2 7 1 7", "2 8 1 7"), 39, "fewer elements in the blocks"},
      {gmsh, edit(kGmsh4, "2 7 1 7", "1 7 1 7"), 32, "fewer elements in the blocks"},
      {gmsh, edit(kGmsh4, "2 1 3 6", "2 1 2 6"), 34, "triangle; every facet must be a quad"},
      {gmsh, edit(kGmsh4, "2 1 3 6", "3 1 5 6"), 33, "is too large"},
      {gmsh, edit(kGmsh4, "2 1 3 6", "2 1 0 6"), 33, "element of unknown type 0"},
      {gmsh, edit(kGmsh4, "2 50 4 3 2", "2 50 4 3 9"), 34, "there is no node with tag 9"},
      {gmsh, edit(kGmsh4, "2 50 4 3 2", "2 50 4 3 -2"), 34, "there is no node with tag -2"},
      {gmsh, edit(kGmsh4, "2 50 4 3 2", "2 50 4 3 4"), 34, "quad with a repeated vertex"},
  });
}

TEST(Malformed, GmshBinary) {
  const std::string binary = gmsh2_binary();
  std::string big_endian = binary;
  std::swap(big_endian[20], big_endian[23]);
  std::string not_finite = gmsh4_binary();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  not_finite.replace(not_finite.find("$EndNodes") - 9, 8, packed(nan));
  expect_surfaces_refused({
      {gmsh, big_endian, 2, "big-endian"},
      {gmsh, not_finite, 5, "not a finite number"},
      {gmsh, edit(binary, "$Nodes\n8", "$Nodes\n9"), 7, "$EndNodes is expected"},
      {gmsh, edit(binary, "$Nodes\n8", "$Nodes\n800"), 6, "is too large"},
      {gmsh, edit(binary, "$Elements\n6", "$Elements\n5"), 10, "block of 6 elements"},
      {gmsh, edit(binary, "$Nodes\n8\n", "$Nodes\n8 x\n"), 6, "binary data are expected"},
  });
}

TEST(Malformed, Hexahedra) {
  const auto parse = io::parse_hexahedra;
  expect_all_refused(
      {
          {obj, kObj, 0, "a file of format .obj cannot hold hexahedra"},
          {off, kOff, 0, "a file of format .off cannot hold hexahedra"},
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

/// True if the cut leaves a proper prefix of the last word of the file.
bool is_in_last_word(const std::string& bytes, std::size_t cut) {
  const auto is_space = [&](std::size_t i) {
    return std::isspace(static_cast<unsigned char>(bytes[i])) != 0;
  };
  if (is_space(cut - 1) || is_space(cut)) return false;
  while (cut < bytes.size() && !is_space(cut)) ++cut;
  while (cut < bytes.size() && is_space(cut)) ++cut;
  return cut == bytes.size();
}

template <class Parse>
void expect_prefixes_refused(const Sample& sample, const Parse& parse) {
  SCOPED_TRACE(sample.name);
  const auto whole = parse(sample.bytes, sample.format, "f");
  const bool has_end_mark = sample.format != off && sample.format != vtk;
  for (std::size_t cut = 0; cut < sample.bytes.size(); ++cut) {
    try {
      const auto mesh = parse(sample.bytes.substr(0, cut), sample.format, "f");
      if (sample.format == obj) continue;  // has no counts: a cut cannot be told from an end
      if (!has_end_mark && is_in_last_word(sample.bytes, cut)) continue;
      EXPECT_TRUE(same(mesh, whole)) << "cut at byte " << cut;
    } catch (const core::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, 2), "f:");
    }
  }
}

TEST(Malformed, EveryPrefixIsRefusedOrTheSameMesh) {
  for (const Sample& sample : surface_samples()) expect_prefixes_refused(sample, io::parse_surface);
  for (const Sample& sample : hexahedra_samples())
    expect_prefixes_refused(sample, io::parse_hexahedra);
  const mesh::HexMesh cube = io::parse_hexahedra(kHexVtk, vtk, "f");
  for (const FileFormat format : {vtk, vtu, medit, gmsh})
    expect_prefixes_refused(Sample{"written", format, io::to_text(cube, format), {}},
                            io::parse_hexahedra);
}

}  // namespace
