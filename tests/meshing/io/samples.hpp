#pragma once
/// \file
/// The boundary of the unit cube (its text in sample_surfaces.hpp) and the unit cube itself, by
/// hand in each format.

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "meshing/io/mesh_files.hpp"
#include "tests/meshing/io/sample_surfaces.hpp"

namespace hexatlas::io_tests {

using io::FileFormat;

/// The points of every sample, in this order.
inline const std::vector<mesh::Point> kPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                              {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline const std::vector<std::array<mesh::Index, 4>> kQuads{
    {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// Bit for bit, so that -0.0 and 0.0 differ.
inline std::vector<std::array<std::uint64_t, 3>> bits(const std::vector<mesh::Point>& points) {
  std::vector<std::array<std::uint64_t, 3>> all;
  for (const mesh::Point& p : points)
    all.push_back({std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                   std::bit_cast<std::uint64_t>(p.z)});
  return all;
}

inline bool same(const mesh::SurfaceMesh& a, const mesh::SurfaceMesh& b) {
  return bits(a.points) == bits(b.points) && a.quads == b.quads;
}

inline bool same(const mesh::HexMesh& a, const mesh::HexMesh& b) {
  return bits(a.points) == bits(b.points) && a.hexahedra == b.hexahedra;
}

inline bool same(const mesh::TetMesh& a, const mesh::TetMesh& b) {
  return bits(a.points) == bits(b.points) && a.tetrahedra == b.tetrahedra;
}

inline bool same(const std::vector<mesh::Point>& a, const std::vector<mesh::Point>& b) {
  return bits(a) == bits(b);
}

struct Sample {
  std::string name;
  FileFormat format;
  std::string bytes;
  std::vector<std::uint32_t> quad_line;  ///< of a surface; empty for hexahedra
};

template <class... Numbers>
std::string packed(Numbers... numbers) {
  std::string bytes;
  (bytes.append(std::bit_cast<std::array<char, sizeof numbers>>(numbers).data(), sizeof numbers),
   ...);
  return bytes;
}

inline std::string gmsh2_binary() {
  std::string bytes =
      "$MeshFormat\n2.2 1 8\n" + packed(std::int32_t{1}) + "\n$EndMeshFormat\n$Nodes\n8\n";
  for (std::int32_t i = 0; i < 8; ++i) {
    const mesh::Point& p = kPoints[static_cast<std::size_t>(i)];
    bytes += packed(i + 1, p.x, p.y, p.z);
  }
  bytes +=
      "\n$EndNodes\n$Elements\n6\n" + packed(std::int32_t{3}, std::int32_t{6}, std::int32_t{2});
  std::int32_t tag = 0;
  for (const auto& quad : kQuads) {
    bytes += packed(++tag, std::int32_t{0}, std::int32_t{1});
    for (const mesh::Index i : quad) bytes += packed(i + 1);
  }
  return bytes + "\n$EndElements\n";
}

inline std::string gmsh4_binary() {
  using Size = std::uint64_t;
  std::string bytes = "$MeshFormat\n4.1 1 8\n" + packed(std::int32_t{1}) +
                      "\n$EndMeshFormat\n$Nodes\n" + packed(Size{1}, Size{8}, Size{1}, Size{8}) +
                      packed(std::int32_t{2}, std::int32_t{1}, std::int32_t{0}, Size{8});
  for (Size tag = 1; tag <= 8; ++tag) bytes += packed(tag);
  for (const mesh::Point& p : kPoints) bytes += packed(p.x, p.y, p.z);
  bytes += "\n$EndNodes\n$Elements\n" + packed(Size{1}, Size{6}, Size{1}, Size{6}) +
           packed(std::int32_t{2}, std::int32_t{1}, std::int32_t{3}, Size{6});
  Size tag = 0;
  for (const auto& quad : kQuads) {
    bytes += packed(++tag);
    for (const mesh::Index i : quad) bytes += packed(Size{i} + 1);
  }
  return bytes + "\n$EndElements\n";
}

/// A VTK XML file with raw appended data; offsets after the header of each array.
inline std::string vtu_raw() {
  std::string points, connectivity, offsets;
  for (const mesh::Point& p : kPoints) points += packed(p.x, p.y, p.z);
  std::int64_t end = 0;
  for (const auto& quad : kQuads) {
    for (const mesh::Index i : quad) connectivity += packed(std::int64_t{i});
    offsets += packed(end += 4);
  }
  const std::string types(6, '\x09');
  std::string data;
  const auto array = [&](const std::string& attributes, const std::string& bytes) {
    const std::string element = "<DataArray " + attributes + " format=\"appended\" offset=\"" +
                                std::to_string(data.size()) + "\"/>\n";
    data += packed(std::uint64_t{bytes.size()}) + bytes;
    return element;
  };
  std::string text =
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid><Piece NumberOfPoints=\"8\" NumberOfCells=\"6\">\n<Points>\n";
  text += array("type=\"Float64\" NumberOfComponents=\"3\"", points) + "</Points>\n<Cells>\n";
  text += array("type=\"Int64\" Name=\"connectivity\"", connectivity);
  text += array("type=\"Int64\" Name=\"offsets\"", offsets);
  text += array("type=\"UInt8\" Name=\"types\"", types);
  return text + "</Cells></Piece></UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + data +
         "\n</AppendedData></VTKFile>\n";
}

inline std::vector<Sample> surface_samples() {
  return {
      {"obj", FileFormat::obj, kObj, {13, 14, 15, 16, 17, 18}},
      {"off", FileFormat::off, kOff, {12, 13, 14, 15, 16, 17}},
      {"vtk poly", FileFormat::vtk, kVtkPoly, {10, 11, 12, 13, 14, 15}},
      {"vtk grid", FileFormat::vtk, kVtkGrid, {19, 20, 21, 22, 23, 24}},
      {"vtk 5.1", FileFormat::vtk, kVtk5, {18, 18, 19, 20, 20, 21}},
      {"vtu ascii", FileFormat::vtu, kVtuAscii, {15, 16, 17, 18, 19, 20}},
      {"vtu inline", FileFormat::vtu, kVtuInline, {9, 9, 9, 9, 9, 9}},
      {"vtu compressed", FileFormat::vtu, kVtuCompressed, {9, 9, 9, 9, 9, 9}},
      {"vtu raw", FileFormat::vtu, vtu_raw(), {7, 7, 7, 7, 7, 7}},
      {"medit", FileFormat::medit, kMedit, {22, 23, 24, 25, 26, 27}},
      {"gmsh 2.2", FileFormat::gmsh, kGmsh2, {23, 24, 25, 26, 27, 28}},
      {"gmsh 4.1", FileFormat::gmsh, kGmsh4, {34, 35, 36, 37, 38, 39}},
      {"gmsh 2.2 binary", FileFormat::gmsh, gmsh2_binary(), {0, 0, 0, 0, 0, 0}},
      {"gmsh 4.1 binary", FileFormat::gmsh, gmsh4_binary(), {0, 0, 0, 0, 0, 0}},
  };
}

/// The head of a MEDIT file up to the corners of a cube.
inline const std::string kMeditCube = R"(MeshVersionFormatted 2
Dimension 3
Vertices 8
0 0 0 0
1 0 0 0
1 1 0 0
0 1 0 0
0 0 1 0
1 0 1 0
1 1 1 0
0 1 1 0
)";

inline const std::string kHexMedit = kMeditCube + R"(Quadrilaterals 1
1 4 3 2 5
Hexahedra 1
1 2 3 4 5 6 7 8 0
End
)";

inline const std::string kHexVtk = R"(# vtk DataFile Version 3.0
cube
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
CELLS 2 14
8 0 1 2 3 4 5 6 7
4 0 3 2 1
CELL_TYPES 2
12
9
)";

inline const std::string kHexVtu = R"(<VTKFile type="UnstructuredGrid" version="0.1">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1
</DataArray></Points><Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 4 5 6 7</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">12</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
)";

inline const std::string kHexGmsh2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
2
1 3 2 0 1 1 4 3 2
2 5 2 0 1 1 2 3 4 5 6 7 8
$EndElements
)";

inline const std::string kHexGmsh4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
1 8 1 8
3 1 0 8
1
2
3
4
5
6
7
8
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
$EndNodes
$Elements
1 1 1 1
3 1 5 1
1 1 2 3 4 5 6 7 8
$EndElements
)";

inline std::vector<Sample> hexahedra_samples() {
  return {
      {"medit", FileFormat::medit, kHexMedit, {}},   {"vtk", FileFormat::vtk, kHexVtk, {}},
      {"vtu", FileFormat::vtu, kHexVtu, {}},         {"gmsh 2.2", FileFormat::gmsh, kHexGmsh2, {}},
      {"gmsh 4.1", FileFormat::gmsh, kHexGmsh4, {}},
  };
}

}  // namespace hexatlas::io_tests
