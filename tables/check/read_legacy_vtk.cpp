#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

constexpr std::array<ShapeNumber, 8> kVtkShapes = {{{1, Shape::kVertex},
                                                    {3, Shape::kLine},
                                                    {5, Shape::kTriangle},
                                                    {9, Shape::kQuad},
                                                    {10, Shape::kTetrahedron},
                                                    {12, Shape::kHexahedron},
                                                    {13, Shape::kWedge},
                                                    {14, Shape::kPyramid}}};

constexpr std::uint64_t kTriangle = 5;
constexpr std::uint64_t kPolygon = 7;
constexpr std::uint64_t kPixel = 8;
constexpr std::uint64_t kQuad = 9;
constexpr std::uint64_t kVoxel = 11;
constexpr std::uint64_t kHexahedron = 12;

/// A type of numbers and how many bytes one of them takes.
struct NumberType {
  std::string_view name;
  std::uint64_t width;
};
constexpr std::array<NumberType, 8> kIntegers = {{{"int", 4},
                                                  {"unsigned_int", 4},
                                                  {"long", 8},
                                                  {"unsigned_long", 8},
                                                  {"vtkIdType", 4},
                                                  {"vtktypeint32", 4},
                                                  {"vtktypeint64", 8},
                                                  {"vtktypeuint64", 8}}};
/// Which only fields may have.
constexpr std::array<NumberType, 6> kOtherNumbers = {{{"char", 1},
                                                      {"unsigned_char", 1},
                                                      {"short", 2},
                                                      {"unsigned_short", 2},
                                                      {"float", 4},
                                                      {"double", 8}}};

/// The bits of a number, most significant byte first.
template <class Bits>
Bits big_endian(std::string_view bytes) {
  Bits bits = 0;
  for (const char byte : bytes.substr(0, sizeof bits)) {
    bits = static_cast<Bits>(bits << 8U | static_cast<unsigned char>(byte));
  }
  return bits;
}

/// The bytes of a section whose heading was read, to the end of its line.
std::string_view body(Scanner& in, std::uint64_t count, std::uint64_t width) {
  if (in.skip_line().find_first_not_of(" \t") != std::string_view::npos) {
    in.fail("words between a heading and its binary numbers");
  }
  return in.bytes(count * width);
}

template <class Bits>
std::vector<std::uint64_t> binary_naturals(Scanner& in, std::uint64_t count) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(count);
  std::string_view bytes = body(in, count, sizeof(Bits));
  for (; !bytes.empty(); bytes.remove_prefix(sizeof(Bits))) {
    const auto bits = big_endian<Bits>(bytes);
    if (bits > std::numeric_limits<Bits>::max() / 2) in.fail("a binary number is negative");
    numbers.push_back(bits);
  }
  return numbers;
}

template <class Bits, class Real>
void read_binary_points(Scanner& in, std::uint64_t count, Draft& draft) {
  std::string_view bytes = body(in, count, 3 * sizeof(Bits));
  for (std::uint64_t i = 0; i < count; ++i) {
    Point point{};
    for (double& value : point) {
      value = std::bit_cast<Real>(big_endian<Bits>(bytes));
      bytes.remove_prefix(sizeof(Bits));
      if (std::isfinite(value)) continue;
      in.fail("a coordinate of point " + std::to_string(i) + " is not finite");
    }
    draft.points.push_back(point);
  }
}

/// The same as read_rows(), in integers of four bytes.
void read_binary_rows(Scanner& in, VtkCells& cells) {
  const std::uint64_t rows = in.count(4);
  const auto numbers = binary_naturals<std::uint32_t>(in, in.count(4));
  std::size_t at = 0;
  for (std::uint64_t row = 0; row < rows; ++row) {
    if (at == numbers.size() || numbers[at] > numbers.size() - at - 1) {
      in.fail("the size of CELLS is wrong");
    }
    const auto corners = std::span(numbers).subspan(at + 1, numbers[at]);
    cells.connectivity.insert(cells.connectivity.end(), corners.begin(), corners.end());
    cells.offsets.push_back(cells.connectivity.size());
    at += corners.size() + 1;
  }
  if (at != numbers.size()) in.fail("the size of CELLS is wrong");
}

/// CELLS n size, then n rows "k i1 .. ik"; size counts all these numbers.
void read_rows(Scanner& in, VtkCells& cells) {
  const std::uint64_t rows = in.count(2);
  const std::uint64_t size = in.count(2);
  if (size < rows) in.fail("the size of CELLS is less than its number of cells");
  for (std::uint64_t row = 0; row < rows; ++row) {
    const std::uint64_t corner_count = in.count(2);
    for (std::uint64_t i = 0; i < corner_count; ++i) cells.connectivity.push_back(in.natural());
    cells.offsets.push_back(cells.connectivity.size());
  }
  if (cells.connectivity.size() + rows != size) in.fail("the size of CELLS is wrong");
}

template <std::size_t kTypes>
std::optional<std::uint64_t> width_of(const std::array<NumberType, kTypes>& types,
                                      std::string_view name) {
  for (const NumberType& type : types) {
    if (type.name == name) return type.width;
  }
  return std::nullopt;
}

/// CELLS n+1 size, OFFSETS type and n+1 numbers, CONNECTIVITY type and size numbers.
void read_offsets_and_connectivity(Scanner& in, bool binary, VtkCells& cells) {
  const auto read_numbers = [&in, binary](std::uint64_t count) {
    const std::string_view type = in.word();
    const std::optional<std::uint64_t> width = width_of(kIntegers, type);
    if (!width) in.fail("unknown type of integers " + in_quotes(type));
    if (binary) {
      return *width == 8 ? binary_naturals<std::uint64_t>(in, count)
                         : binary_naturals<std::uint32_t>(in, count);
    }
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(in.natural());
    return numbers;
  };
  const std::uint64_t offsets = in.count(2);
  const std::uint64_t size = in.count(2);
  if (offsets == 0) in.fail("CELLS needs at least one offset");
  in.expect("OFFSETS");
  cells.offsets = read_numbers(offsets);
  if (cells.offsets.back() != size) in.fail("the last offset is not the size of CONNECTIVITY");
  in.expect("CONNECTIVITY");
  cells.connectivity = read_numbers(size);
}

struct Sections {
  bool points = false;
  bool cells = false;
  bool types = false;
};

void once(Scanner& in, bool& seen, std::string_view keyword) {
  if (seen) in.fail(std::string(keyword) + " occurs twice");
  seen = true;
}

void read_points(Scanner& in, bool binary, Draft& draft) {
  const std::uint64_t count = in.count(6);
  const std::string_view type = in.word();
  if (type != "double" && type != "float") in.fail("points must be float or double");
  draft.points.reserve(count);
  if (binary && type == "double")
    return read_binary_points<std::uint64_t, double>(in, count, draft);
  if (binary) return read_binary_points<std::uint32_t, float>(in, count, draft);
  for (std::uint64_t i = 0; i < count; ++i) draft.points.push_back(in.point());
}

void read_types(Scanner& in, bool binary, VtkCells& cells) {
  const std::uint64_t count = in.count(2);
  if (binary) {
    cells.types = binary_naturals<std::uint32_t>(in, count);
  } else {
    for (std::uint64_t i = 0; i < count; ++i) cells.types.push_back(in.natural());
  }
}

void pass_over_information(Scanner& in) {
  in.skip_line();
  in.skip_paragraph();
}

/// Each in a line of its own; in a binary file, after its length, whose two highest bits say in how
/// many bytes it is.
void pass_over_strings(Scanner& in, std::uint64_t count, bool binary) {
  static_cast<void>(body(in, 0, 1));
  if (count > in.bytes_left()) in.fail("an array of strings ends too early");
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!binary) {
      static_cast<void>(in.skip_line());
      continue;
    }
    const auto first = static_cast<unsigned char>(in.bytes(1)[0]);
    std::uint64_t length = first & 0x3FU;
    const std::size_t more = std::array<std::size_t, 4>{7, 3, 1, 0}[first >> 6U];
    for (const char byte : in.bytes(more)) length = length << 8U | static_cast<unsigned char>(byte);
    static_cast<void>(in.bytes(length));
  }
}

/// FIELD name n, then n arrays "name components tuples type" with their numbers.
void pass_over_field(Scanner& in, bool binary) {
  static_cast<void>(in.word());
  const std::uint64_t arrays = in.count(8);
  for (std::uint64_t i = 0; i < arrays; ++i) {
    while (in.peek() == "METADATA") pass_over_information(in);
    static_cast<void>(in.word());
    const std::uint64_t components = in.count(1);
    const std::uint64_t numbers = components * in.count(1);
    const std::string_view type = in.word();
    if (type == "string") {
      pass_over_strings(in, numbers, binary);
      continue;
    }
    std::optional<std::uint64_t> width = width_of(kIntegers, type);
    if (!width) width = width_of(kOtherNumbers, type);
    if (!width) in.fail("unknown type of numbers " + in_quotes(type));
    if (binary) {
      static_cast<void>(body(in, numbers, *width));
    } else {
      for (std::uint64_t k = 0; k < numbers; ++k) static_cast<void>(in.real());
    }
  }
}

/// How the numbers are written, and of what.
struct Style {
  bool rows = true;  ///< of cells, as before version 5
  bool binary = false;
  bool polygons = false;  ///< POLYDATA: cells without types, in sections by dimension
};

void read_cells(Scanner& in, Style style, VtkCells& cells) {
  if (!style.rows) {
    read_offsets_and_connectivity(in, style.binary, cells);
  } else if (style.binary) {
    read_binary_rows(in, cells);
  } else {
    read_rows(in, cells);
  }
}

/// By their numbers of vertices; what is neither triangle nor quad has the type that is refused.
void give_types_to_polygons(VtkCells& cells) {
  for (std::size_t i = 1; i < cells.offsets.size(); ++i) {
    const std::uint64_t size = cells.offsets[i] - cells.offsets[i - 1];
    cells.types.push_back(size == 3 ? kTriangle : size == 4 ? kQuad : kPolygon);
  }
}

/// Whether it is one that POLYDATA has instead of cells with types.
bool read_section_of_polygons(Scanner& in, Style style, std::string_view keyword, Sections& seen,
                              VtkCells& cells) {
  if (!style.polygons) return false;
  if (keyword == "POLYGONS") {
    once(in, seen.cells, keyword);
    seen.types = true;
    read_cells(in, style, cells);
    give_types_to_polygons(cells);
    return true;
  }
  if (keyword != "VERTICES" && keyword != "LINES") return false;
  VtkCells no_part_of_a_surface;
  no_part_of_a_surface.offsets = {0};
  read_cells(in, style, no_part_of_a_surface);
  return true;
}

/// True when only attributes follow; they carry no part of the mesh.
bool read_section(Scanner& in, Style style, Sections& seen, Draft& draft, VtkCells& cells) {
  const std::string_view keyword = in.word();
  if (keyword == "POINTS") {
    once(in, seen.points, keyword);
    read_points(in, style.binary, draft);
  } else if (read_section_of_polygons(in, style, keyword, seen, cells)) {
    return false;
  } else if (keyword == "CELLS" && !style.polygons) {
    once(in, seen.cells, keyword);
    read_cells(in, style, cells);
  } else if (keyword == "CELL_TYPES" && !style.polygons) {
    once(in, seen.types, keyword);
    read_types(in, style.binary, cells);
  } else if (keyword == "METADATA") {
    pass_over_information(in);
  } else if (keyword == "FIELD") {
    pass_over_field(in, style.binary);
  } else if ((keyword == "CELL_DATA" || keyword == "POINT_DATA") && seen.cells && seen.types) {
    return true;
  } else {
    in.fail("unknown or misplaced keyword " + in_quotes(keyword));
  }
  return false;
}

}  // namespace

void add_vtk_cells(const VtkCells& cells, Draft& draft,
                   const std::function<void(const std::string&)>& fail) {
  if (cells.offsets.size() != cells.types.size() + 1) {
    fail("the number of cells is not the number of cell types");
  }
  if (cells.offsets.front() != 0) fail("the first cell does not start at 0");
  if (!std::is_sorted(cells.offsets.begin(), cells.offsets.end()) ||
      cells.offsets.back() != cells.connectivity.size()) {
    fail("the offsets of the cells do not fit the connectivity");
  }
  for (const std::uint64_t vertex : cells.connectivity) {
    if (vertex >= draft.points.size()) {
      fail("point " + std::to_string(vertex) + " is not among the " +
           std::to_string(draft.points.size()) + " points");
    }
  }
  for (std::size_t cell = 0; cell < cells.types.size(); ++cell) {
    // The types of boxes of a grid have the corners in another order.
    const bool is_pixel = cells.types[cell] == kPixel;
    const bool is_voxel = cells.types[cell] == kVoxel;
    const std::uint64_t type = is_pixel ? kQuad : is_voxel ? kHexahedron : cells.types[cell];
    const std::uint64_t size = cells.offsets[cell + 1] - cells.offsets[cell];
    const auto* const known =
        std::find_if(kVtkShapes.begin(), kVtkShapes.end(),
                     [type](const ShapeNumber& candidate) { return candidate.number == type; });
    if (known == kVtkShapes.end() || size != corner_count(known->shape) ||
        draft.refuses(known->shape)) {
      fail("cell " + std::to_string(cell) + " of VTK type " + std::to_string(cells.types[cell]) +
           " with " + std::to_string(size) + " vertices is " + draft.refusal());
    }
    std::array<std::uint32_t, 8> corners{};
    for (std::size_t i = 0; i < size; ++i) {
      corners[i] = static_cast<std::uint32_t>(cells.connectivity[cells.offsets[cell] + i]);
    }
    if (is_pixel || is_voxel) std::swap(corners[2], corners[3]);
    if (is_voxel) std::swap(corners[6], corners[7]);
    draft.add(known->shape, std::span(corners).first(size));
  }
}

Draft parse_legacy_vtk(const std::string& name, std::string_view bytes, Wanted wanted) {
  Scanner in(name, bytes);
  for (const std::string_view word : {"#", "vtk", "DataFile", "Version"}) in.expect(word);
  const std::string_view version = in.word();
  constexpr std::array<std::string_view, 5> kWithRows = {"2.0", "3.0", "4.0", "4.1", "4.2"};
  const bool rows = std::find(kWithRows.begin(), kWithRows.end(), version) != kWithRows.end();
  if (!rows && version != "5.1") in.fail("unknown version " + in_quotes(version));
  in.skip_line();
  in.skip_line();
  const bool binary = in.peek() == "BINARY";
  in.expect(binary ? "BINARY" : "ASCII");
  if (in.peek() == "FIELD") {
    in.expect("FIELD");
    pass_over_field(in, binary);
  }
  in.expect("DATASET");
  const bool polygons = in.peek() == "POLYDATA";
  in.expect(polygons ? "POLYDATA" : "UNSTRUCTURED_GRID");
  Draft draft(wanted);
  VtkCells cells;
  cells.offsets = {0};
  Sections seen;
  while (!in.at_end()) {
    if (read_section(in, {rows, binary, polygons}, seen, draft, cells)) break;
  }
  if (!seen.points || !seen.cells || !seen.types) {
    in.fail(polygons ? "POINTS and POLYGONS must both be present"
                     : "POINTS, CELLS and CELL_TYPES must all be present");
  }
  add_vtk_cells(cells, draft, [&in](const std::string& reason) { in.fail(reason); });
  return draft;
}

}  // namespace hexatlas::check
