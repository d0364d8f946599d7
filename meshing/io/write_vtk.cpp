// VTK legacy, version 3.0, ASCII, one point and one cell per line; and VTK XML, with arrays
// compressed by zlib in base64.
#include "meshing/io/cell_types.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/text.hpp"
#include "meshing/io/vtu_data.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

/// Calls visit(VTK type, corners) for each cell.
template <class Visit>
void for_each_cell(const CellsToWrite& cells, Visit&& visit) {
  for (const auto& quad : cells.quads) visit(kVtkQuad, std::span<const mesh::Index>(quad));
  for (const auto& hexahedron : cells.hexahedra)
    visit(kVtkHexahedron, std::span<const mesh::Index>(hexahedron));
}

using Corners = std::span<const mesh::Index>;

std::string data_array(const std::string& attributes, std::string_view bytes) {
  return "<DataArray " + attributes + " format=\"binary\">\n" + encode_array(bytes) +
         "\n</DataArray>\n";
}

std::string point_array(const CellsToWrite& cells) {
  std::string bytes;
  for (const mesh::Point& point : cells.points)
    for (const double coordinate : {point.x, point.y, point.z}) append_little(bytes, coordinate);
  return data_array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", bytes);
}

std::string cell_arrays(const CellsToWrite& cells) {
  std::string connectivity, offsets, types;
  std::int64_t end = 0;
  for_each_cell(cells, [&](int type, Corners corners) {
    for (const mesh::Index corner : corners) append_little<std::int64_t>(connectivity, corner);
    end += static_cast<std::int64_t>(corners.size());
    append_little(offsets, end);
    append_little(types, static_cast<std::uint8_t>(type));
  });
  return data_array("type=\"Int64\" Name=\"connectivity\"", connectivity) +
         data_array("type=\"Int64\" Name=\"offsets\"", offsets) +
         data_array("type=\"UInt8\" Name=\"types\"", types);
}

}  // namespace

std::string write_vtk(const CellsToWrite& cells) {
  const std::size_t count = cells.quads.size() + cells.hexahedra.size();
  std::string text =
      "# vtk DataFile Version 3.0\nhexatlas mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  text += "POINTS " + std::to_string(cells.points.size()) + " double\n";
  for (const mesh::Point& point : cells.points) {
    append(text, point);
    text += '\n';
  }
  text += "CELLS " + std::to_string(count) + " " +
          std::to_string(5 * cells.quads.size() + 9 * cells.hexahedra.size()) + "\n";
  for_each_cell(cells, [&](int, Corners corners) {
    append(text, std::uint64_t{corners.size()});
    text += ' ';
    append(text, corners, 0);
    text += '\n';
  });
  text += "CELL_TYPES " + std::to_string(count) + "\n";
  for_each_cell(cells, [&](int type, Corners) { text += std::to_string(type) + "\n"; });
  return text;
}

std::string write_vtu(const CellsToWrite& cells) {
  const std::size_t count = cells.quads.size() + cells.hexahedra.size();
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
         "<UnstructuredGrid>\n"
         "<Piece NumberOfPoints=\"" +
         std::to_string(cells.points.size()) + "\" NumberOfCells=\"" + std::to_string(count) +
         "\">\n<Points>\n" + point_array(cells) + "</Points>\n<Cells>\n" + cell_arrays(cells) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace hexatlas::io
