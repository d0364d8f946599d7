// VTK legacy, version 3.0, ASCII, one point and one cell per line; and VTK XML, with arrays
// compressed by zlib in base64, or appended as they are.
#include <functional>
#include <limits>
#include <string>

#include "meshing/io/vtu_data.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

/// An array of a VTK XML file: its attributes, its size, and how its bytes come.
struct DataArray {
  std::string attributes;
  std::uint64_t bytes;
  std::function<void(Output&)> put;
};

DataArray point_array(const CellsToWrite& cells) {
  static_assert(sizeof(mesh::Point) == 3 * sizeof(double));
  return {"type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", cells.points.size_bytes(),
          [&](Output& out) { out.put_memory(cells.points); }};
}

std::size_t corner_count(const CellsToWrite& cells) {
  std::size_t count = 0;
  for (const CellList& list : cells.lists) count += list.all_corners().size();
  return count;
}

/// connectivity, offsets, types; `Integer` is the type of the first two.
template <class Integer>
std::vector<DataArray> cell_arrays(const CellsToWrite& cells, const std::string& type) {
  const auto put_corners = [&](Output& out) {
    for (const CellList& list : cells.lists)
      for (const mesh::Index corner : list.all_corners())
        out.put_binary(static_cast<Integer>(corner));
  };
  const auto put_offsets = [&](Output& out) {
    std::size_t end = 0;
    for (const CellList& list : cells.lists)
      for (std::size_t i = 0; i < list.size(); ++i)
        out.put_binary(static_cast<Integer>(end += list.corners_each()));
  };
  const auto put_types = [&](Output& out) {
    for (const CellList& list : cells.lists)
      for (std::size_t i = 0; i < list.size(); ++i)
        out.put_binary(static_cast<std::uint8_t>(list.type.vtk));
  };
  return {
      {"type=\"" + type + "\" Name=\"connectivity\"", sizeof(Integer) * corner_count(cells),
       put_corners},
      {"type=\"" + type + "\" Name=\"offsets\"", sizeof(Integer) * cells.cell_count(), put_offsets},
      {"type=\"UInt8\" Name=\"types\"", cells.cell_count(), put_types}};
}

/// The regions, if there are some.
std::vector<DataArray> field_arrays(const CellsToWrite& cells) {
  if (!cells.has_regions()) return {};
  return {{"type=\"UInt32\" Name=\"region\"", sizeof(std::uint32_t) * cells.cell_count(),
           [&](Output& out) {
             for (const CellList& list : cells.lists) out.put_memory(list.regions);
           }}};
}

/// Appended arrays take four bytes for an integer where these suffice.
std::vector<DataArray> cell_arrays(const CellsToWrite& cells, VtuArrays arrays) {
  constexpr auto kLargest = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  const bool is_narrow = arrays == VtuArrays::appended_raw && corner_count(cells) <= kLargest &&
                         cells.points.size() <= kLargest;
  return is_narrow ? cell_arrays<std::int32_t>(cells, "Int32")
                   : cell_arrays<std::int64_t>(cells, "Int64");
}

std::string bytes_of(const DataArray& array) {
  std::string bytes;
  bytes.reserve(array.bytes);
  const core::Sink collect = [&](std::string_view part) { bytes += part; };
  Output out(collect);
  array.put(out);
  out.flush();
  return bytes;
}

/// The elements of the arrays; moves `offset` over those that are to be appended.
void put_elements(const std::vector<DataArray>& list, VtuArrays arrays, std::uint64_t& offset,
                  Output& out) {
  for (const DataArray& array : list) {
    out.put("<DataArray ", array.attributes);
    if (arrays == VtuArrays::appended_raw) {
      out.put(" format=\"appended\" offset=\"", offset, "\"/>\n");
      offset += sizeof(std::uint64_t) + array.bytes;
    } else {
      out.put(" format=\"binary\">\n", encode_array(bytes_of(array)), "\n</DataArray>\n");
    }
  }
}

/// The number of bytes of each array and the bytes.
void put_appended(const std::vector<DataArray>& list, Output& out) {
  for (const DataArray& array : list) {
    out.put_binary(array.bytes);
    array.put(out);
  }
}

}  // namespace

std::size_t CellsToWrite::cell_count() const {
  std::size_t count = 0;
  for (const CellList& list : lists) count += list.size();
  return count;
}

void write_vtk(const CellsToWrite& cells, Output& out) {
  out.put("# vtk DataFile Version 3.0\nhexatlas mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n");
  out.put("POINTS ", cells.points.size(), " double\n");
  for (const mesh::Point& point : cells.points) out.put(point, "\n");
  const std::size_t count = cells.cell_count();
  out.put("CELLS ", count, " ", count + corner_count(cells), "\n");
  for (const CellList& list : cells.lists)
    for (std::size_t i = 0; i < list.size(); ++i) {
      out.put(list.corners_each(), " ");
      out.put_indices(list[i], 0);
      out.put("\n");
    }
  out.put("CELL_TYPES ", count, "\n");
  for (const CellList& list : cells.lists)
    for (std::size_t i = 0; i < list.size(); ++i) out.put(list.type.vtk, "\n");
  if (!cells.has_regions()) return;
  out.put("CELL_DATA ", count, "\nSCALARS region unsigned_int 1\nLOOKUP_TABLE default\n");
  for (const CellList& list : cells.lists)
    for (const std::uint32_t region : list.regions) out.put(region, "\n");
}

void write_vtu(const CellsToWrite& cells, VtuArrays arrays, Output& out) {
  const bool is_raw = arrays == VtuArrays::appended_raw;
  const std::vector<DataArray> of_points{point_array(cells)};
  const std::vector<DataArray> of_cells = cell_arrays(cells, arrays);
  const std::vector<DataArray> fields = field_arrays(cells);
  std::uint64_t offset = 0;
  out.put(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\"",
      is_raw ? "" : " compressor=\"vtkZLibDataCompressor\"",
      ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"", cells.points.size(), "\" NumberOfCells=\"",
      cells.cell_count(), "\">\n<Points>\n");
  put_elements(of_points, arrays, offset, out);
  out.put("</Points>\n<Cells>\n");
  put_elements(of_cells, arrays, offset, out);
  out.put("</Cells>\n");
  if (!fields.empty()) {
    out.put("<CellData Scalars=\"region\">\n");
    put_elements(fields, arrays, offset, out);
    out.put("</CellData>\n");
  }
  out.put("</Piece>\n</UnstructuredGrid>\n");
  if (is_raw) {
    out.put("<AppendedData encoding=\"raw\">\n_");
    put_appended(of_points, out);
    put_appended(of_cells, out);
    put_appended(fields, out);
    out.put("\n</AppendedData>\n");
  }
  out.put("</VTKFile>\n");
}

}  // namespace hexatlas::io
