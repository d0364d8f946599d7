#include <algorithm>
#include <array>

#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

constexpr std::uint64_t kVtkVertex = 1;
constexpr std::uint64_t kVtkLine = 3;
constexpr std::uint64_t kVtkQuad = 9;
constexpr std::uint64_t kVtkHexahedron = 12;

template <std::size_t size>
std::array<std::uint32_t, size> corners(const VtkCells& cells, std::size_t cell) {
  std::array<std::uint32_t, size> result{};
  for (std::size_t i = 0; i < size; ++i) {
    result[i] = static_cast<std::uint32_t>(cells.connectivity[cells.offsets[cell] + i]);
  }
  return result;
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

/// CELLS n+1 size, OFFSETS type and n+1 numbers, CONNECTIVITY type and size numbers.
void read_offsets_and_connectivity(Scanner& in, VtkCells& cells) {
  const auto read_type = [&in] {
    const std::string_view type = in.word();
    if (type != "vtktypeint64" && type != "vtktypeint32") {
      in.fail("unknown type of integers " + in_quotes(type));
    }
  };
  const std::uint64_t offsets = in.count(2);
  const std::uint64_t size = in.count(2);
  if (offsets == 0) in.fail("CELLS needs at least one offset");
  in.expect("OFFSETS");
  read_type();
  cells.offsets.clear();
  for (std::uint64_t i = 0; i < offsets; ++i) cells.offsets.push_back(in.natural());
  if (cells.offsets.back() != size) in.fail("the last offset is not the size of CONNECTIVITY");
  in.expect("CONNECTIVITY");
  read_type();
  for (std::uint64_t i = 0; i < size; ++i) cells.connectivity.push_back(in.natural());
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

void read_points(Scanner& in, Mesh& mesh) {
  const std::uint64_t count = in.count(6);
  const std::string_view type = in.word();
  if (type != "double" && type != "float") in.fail("points must be float or double");
  mesh.points.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) mesh.points.push_back(in.point());
}

/// True when only attributes follow; they carry no part of the mesh.
bool read_section(Scanner& in, bool rows, Sections& seen, Mesh& mesh, VtkCells& cells) {
  const std::string_view keyword = in.word();
  if (keyword == "POINTS") {
    once(in, seen.points, keyword);
    read_points(in, mesh);
  } else if (keyword == "CELLS") {
    once(in, seen.cells, keyword);
    rows ? read_rows(in, cells) : read_offsets_and_connectivity(in, cells);
  } else if (keyword == "CELL_TYPES") {
    once(in, seen.types, keyword);
    const std::uint64_t count = in.count(2);
    for (std::uint64_t i = 0; i < count; ++i) cells.types.push_back(in.natural());
  } else if (keyword == "METADATA") {
    in.skip_line();
    in.skip_paragraph();
  } else if ((keyword == "CELL_DATA" || keyword == "POINT_DATA") && seen.cells && seen.types) {
    return true;
  } else {
    in.fail("unknown or misplaced keyword " + in_quotes(keyword));
  }
  return false;
}

}  // namespace

void add_vtk_cells(const VtkCells& cells, Mesh& mesh,
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
    if (vertex >= mesh.points.size()) {
      fail("point " + std::to_string(vertex) + " is not among the " +
           std::to_string(mesh.points.size()) + " points");
    }
  }
  for (std::size_t cell = 0; cell < cells.types.size(); ++cell) {
    const std::uint64_t type = cells.types[cell];
    const std::uint64_t size = cells.offsets[cell + 1] - cells.offsets[cell];
    if (type == kVtkHexahedron && size == 8) {
      mesh.hexahedra.push_back(corners<8>(cells, cell));
    } else if (type == kVtkQuad && size == 4) {
      mesh.quads.push_back(corners<4>(cells, cell));
    } else if (!(type == kVtkLine && size == 2) && !(type == kVtkVertex && size == 1)) {
      fail("cell " + std::to_string(cell) + " of VTK type " + std::to_string(type) + " with " +
           std::to_string(size) + " vertices is neither a hexahedron nor a quad");
    }
  }
}

Mesh parse_legacy_vtk(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes);
  for (const std::string_view wanted : {"#", "vtk", "DataFile", "Version"}) in.expect(wanted);
  const std::string_view version = in.word();
  const bool rows = version == "2.0" || version == "3.0" || version == "4.2";
  if (!rows && version != "5.1") in.fail("unknown version " + in_quotes(version));
  in.skip_line();
  in.skip_line();
  for (const std::string_view wanted : {"ASCII", "DATASET", "UNSTRUCTURED_GRID"}) {
    in.expect(wanted);
  }
  Mesh mesh;
  VtkCells cells;
  cells.offsets = {0};
  Sections seen;
  while (!in.at_end()) {
    if (read_section(in, rows, seen, mesh, cells)) break;
  }
  if (!seen.points || !seen.cells || !seen.types) {
    in.fail("POINTS, CELLS and CELL_TYPES must all be present");
  }
  add_vtk_cells(cells, mesh, [&in](const std::string& reason) { in.fail(reason); });
  return mesh;
}

}  // namespace hexatlas::check
