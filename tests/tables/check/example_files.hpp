#pragma once
/// \file
/// Writers of mesh files for the tests of the judge's readers: small, one function per format, from
/// the descriptions of the formats. They write the points, the hexahedra and the listed quads.

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check::examples {

inline std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

inline std::string coordinates(const Point& point) {
  return decimal(point[0]) + " " + decimal(point[1]) + " " + decimal(point[2]);
}

template <typename Cell>
std::string numbers(const Cell& cell, std::uint32_t first) {
  std::string text;
  for (const std::uint32_t vertex : cell) {
    text += (text.empty() ? "" : " ") + std::to_string(vertex + first);
  }
  return text;
}

/// All cells, hexahedra first: one row each, made by `row(type, corners, cell, place)`.
template <typename Row>
std::string rows(const Mesh& mesh, std::uint32_t first, Row row) {
  std::string text;
  std::size_t place = 0;
  for (const auto& cell : mesh.hexahedra) text += row(12, 8, numbers(cell, first), place++);
  for (const auto& quad : mesh.quads) text += row(9, 4, numbers(quad, first), place++);
  return text;
}

inline std::string points_by_line(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points) text += coordinates(point) + "\n";
  return text;
}

inline std::string count(std::size_t number) { return std::to_string(number); }

inline std::string vtk_2(const Mesh& mesh) {
  const std::size_t cells = mesh.hexahedra.size() + mesh.quads.size();
  const std::size_t size = 9 * mesh.hexahedra.size() + 5 * mesh.quads.size();
  return "# vtk DataFile Version 2.0\na title\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
         count(mesh.points.size()) + " double\n" + points_by_line(mesh.points) + "CELLS " +
         count(cells) + " " + count(size) + "\n" +
         rows(mesh, 0,
              [](int, int corners, const std::string& cell, std::size_t) {
                return std::to_string(corners) + " " + cell + "\n";
              }) +
         "CELL_TYPES " + count(cells) + "\n" +
         rows(mesh, 0, [](int type, int, const std::string&, std::size_t) {
           return std::to_string(type) + "\n";
         });
}

inline std::string offsets(const Mesh& mesh) {
  std::size_t end = 0;
  return rows(mesh, 0, [&end](int, int corners, const std::string&, std::size_t) {
    end += static_cast<std::size_t>(corners);
    return count(end) + "\n";
  });
}

inline std::string connectivity(const Mesh& mesh) {
  return rows(mesh, 0, [](int, int, const std::string& cell, std::size_t) { return cell + "\n"; });
}

inline std::string types(const Mesh& mesh) {
  return rows(mesh, 0, [](int type, int, const std::string&, std::size_t) {
    return std::to_string(type) + "\n";
  });
}

inline std::string vtk_51(const Mesh& mesh) {
  const std::size_t cells = mesh.hexahedra.size() + mesh.quads.size();
  const std::size_t size = 8 * mesh.hexahedra.size() + 4 * mesh.quads.size();
  return "# vtk DataFile Version 5.1\na title\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
         count(mesh.points.size()) + " double\n" + points_by_line(mesh.points) + "CELLS " +
         count(cells + 1) + " " + count(size) + "\nOFFSETS vtktypeint64\n0\n" + offsets(mesh) +
         "CONNECTIVITY vtktypeint64\n" + connectivity(mesh) + "CELL_TYPES " + count(cells) + "\n" +
         types(mesh);
}

/// VTK's XML with the four arrays as given: the attributes of the format, and the content.
struct VtuArrays {
  std::string root_attributes;
  std::array<std::string, 4> formats;   ///< points, connectivity, offsets, types
  std::array<std::string, 4> contents;  ///< the same
  std::string appended;                 ///< the whole element, or empty
};

inline std::string vtu(const Mesh& mesh, const VtuArrays& arrays) {
  const auto array = [&arrays](std::size_t i, const std::string& attributes) {
    return "<DataArray " + attributes + " " + arrays.formats[i] + ">\n" + arrays.contents[i] +
           "\n</DataArray>\n";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\"" +
         arrays.root_attributes + ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         count(mesh.points.size()) + "\" NumberOfCells=\"" +
         count(mesh.hexahedra.size() + mesh.quads.size()) + "\">\n<Points>\n" +
         array(0, "type=\"Float64\" NumberOfComponents=\"3\"") + "</Points>\n<Cells>\n" +
         array(1, "type=\"Int32\" Name=\"connectivity\"") +
         array(2, "type=\"Int64\" Name=\"offsets\"") + array(3, "type=\"UInt8\" Name=\"types\"") +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n" + arrays.appended + "</VTKFile>\n";
}

inline std::string vtu_ascii(const Mesh& mesh) {
  const std::string ascii = "format=\"ascii\"";
  return vtu(mesh, {"",
                    {ascii, ascii, ascii, ascii},
                    {points_by_line(mesh.points), connectivity(mesh), offsets(mesh), types(mesh)},
                    ""});
}

template <typename Value>
void append_value(std::string& bytes, Value value) {
  bytes.append(sizeof value, '\0');
  std::memcpy(bytes.data() + bytes.size() - sizeof value, &value, sizeof value);
}

/// The four arrays as bytes.
inline std::array<std::string, 4> binary_arrays(const Mesh& mesh) {
  std::array<std::string, 4> arrays;
  std::int64_t end = 0;
  const auto add = [&](const auto& cell, std::uint8_t type) {
    for (const std::uint32_t v : cell) append_value(arrays[1], static_cast<std::int32_t>(v));
    end += static_cast<std::int64_t>(cell.size());
    append_value(arrays[2], end);
    append_value(arrays[3], type);
  };
  for (const Point& point : mesh.points) {
    for (const double x : point) append_value(arrays[0], x);
  }
  for (const auto& cell : mesh.hexahedra) add(cell, 12);
  for (const auto& quad : mesh.quads) add(quad, 9);
  return arrays;
}

/// Appended raw data without compression, words of 8 bytes.
inline std::string vtu_appended_raw(const Mesh& mesh) {
  VtuArrays arrays{" header_type=\"UInt64\"", {}, {}, ""};
  std::string data;
  const auto bytes = binary_arrays(mesh);
  for (std::size_t i = 0; i < 4; ++i) {
    arrays.formats[i] = "format=\"appended\" offset=\"" + count(data.size()) + "\"";
    append_value(data, static_cast<std::uint64_t>(bytes[i].size()));
    data += bytes[i];
  }
  arrays.appended = "<AppendedData encoding=\"raw\">\n_" + data + "\n</AppendedData>\n";
  return vtu(mesh, arrays);
}

inline std::string base64(const std::string& bytes) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * j) & 63];
    }
  }
  return text;
}

/// Inline base64 without compression, words of 4 bytes.
inline std::string vtu_base64(const Mesh& mesh) {
  VtuArrays arrays{"", {}, {}, ""};
  const auto bytes = binary_arrays(mesh);
  for (std::size_t i = 0; i < 4; ++i) {
    std::string data;
    append_value(data, static_cast<std::uint32_t>(bytes[i].size()));
    arrays.formats[i] = "format=\"binary\"";
    arrays.contents[i] = base64(data + bytes[i]);
  }
  return vtu(mesh, arrays);
}

inline std::string medit(const Mesh& mesh) {
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" + count(mesh.points.size());
  for (const Point& point : mesh.points) text += "\n" + coordinates(point) + " 0";
  text += "\nHexahedra # eight vertices and a reference\n" + count(mesh.hexahedra.size());
  for (const auto& cell : mesh.hexahedra) text += "\n" + numbers(cell, 1) + " 7";
  if (!mesh.quads.empty()) text += "\nQuadrilaterals\n" + count(mesh.quads.size());
  for (const auto& quad : mesh.quads) text += "\n" + numbers(quad, 1) + " -1";
  return text + "\nEnd\n";
}

inline std::string gmsh_22(const Mesh& mesh) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + count(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    text += "\n" + count(v + 1) + " " + coordinates(mesh.points[v]);
  }
  return text + "\n$EndNodes\n$Elements\n" + count(mesh.hexahedra.size() + mesh.quads.size()) +
         "\n" +
         rows(mesh, 1,
              [](int type, int, const std::string& cell, std::size_t place) {
                return count(place + 1) + (type == 12 ? " 5" : " 3") + " 2 0 1 " + cell + "\n";
              }) +
         "$EndElements\n";
}

inline std::string gmsh_41(const Mesh& mesh) {
  const std::string points = count(mesh.points.size());
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + points + " 1 " + points +
                     "\n3 1 0 " + points + "\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) text += count(v + 1) + "\n";
  text += points_by_line(mesh.points) + "$EndNodes\n$Elements\n";
  const std::string cells = count(mesh.hexahedra.size() + mesh.quads.size());
  text += (mesh.quads.empty() ? "1 " : "2 ") + cells + " 1 " + cells;
  return text +
         rows(mesh, 1,
              [&mesh](int type, int, const std::string& cell, std::size_t place) {
                std::string row = "\n";
                if (place == 0) row += "3 1 5 " + count(mesh.hexahedra.size()) + "\n";
                if (type == 9 && place == mesh.hexahedra.size()) {
                  row += "2 1 3 " + count(mesh.quads.size()) + "\n";
                }
                return row + count(place + 1) + " " + cell;
              }) +
         "\n$EndElements\n";
}

inline std::string obj(const Surface& surface) {
  std::string text = "# a surface\n";
  for (const Point& point : surface.points) text += "v " + coordinates(point) + "\n";
  for (const Quad& quad : surface.quads) text += "f " + numbers(quad, 1) + "\n";
  return text;
}

inline std::string off(const Surface& surface) {
  std::string text =
      "OFF\n" + count(surface.points.size()) + " " + count(surface.quads.size()) + " 0\n";
  text += points_by_line(surface.points);
  for (const Quad& quad : surface.quads) text += "4 " + numbers(quad, 0) + "\n";
  return text;
}

struct MeshFormat {
  const char* name;
  std::string (*write)(const Mesh&);
};
inline constexpr std::array<MeshFormat, 8> kMeshFormats = {{{"v2.vtk", vtk_2},
                                                            {"v51.vtk", vtk_51},
                                                            {"ascii.vtu", vtu_ascii},
                                                            {"base64.vtu", vtu_base64},
                                                            {"raw.vtu", vtu_appended_raw},
                                                            {"medit.mesh", medit},
                                                            {"v22.msh", gmsh_22},
                                                            {"v41.msh", gmsh_41}}};

}  // namespace hexatlas::check::examples
