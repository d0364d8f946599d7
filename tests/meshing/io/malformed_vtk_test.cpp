// Claim. Every defect of a VTK file, legacy or XML, is refused with InvalidInput at its line.
// Oracle. Hand-made defects in the samples, with the line counted by hand.
#include "tests/meshing/io/malformed.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

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
      {vtu, edit(kVtuInline, "version=\"0.1\"", "byte_order=\"BigEndian\""), 4,
       "byte order 'BigEndian'; LittleEndian is expected"},
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

}  // namespace
