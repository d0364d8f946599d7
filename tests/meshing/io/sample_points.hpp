#pragma once
/// \file
/// The corners of the unit cube as points alone, and two tetrahedra in them, by hand in each
/// format.

#include <array>
#include <string>
#include <vector>

#include "tests/meshing/io/samples.hpp"

namespace hexatlas::io_tests {

inline const std::string kXyz = R"(# the corners
0 0 0
1 0 0   # comments, and further columns, are ignored

1.0 1e0 0 255 red
0	1	0
0 0 +1
1 0 1
1 1 1 1 1 1
-0.0e5 1 1
)";

/// As kPoints but for one sign, which shows that signs of zero survive.
inline std::vector<mesh::Point> points_of_xyz() {
  std::vector<mesh::Point> points = kPoints;
  points[7].x = -0.0;
  return points;
}

inline const std::string kPlyAscii = R"(ply
format ascii 1.0
comment made by hand
element camera 1
property float view
property list uchar int ids
element vertex 8
property double x
property uchar red
property float y
property list uchar short tags
property int z
element face 1
property list uchar int vertex_index
end_header
0.5 3 7 8 9
0 255 0 0 0
1 255 0 2 5 6 0
1 255 1 0 0
0 255 1 0 0
0 255 0 0 1
1 255 0 1 9 1
1 255 1 0 1
0 255 1 0 1
4 0 3 2 1
)";

inline std::string ply_binary() {
  std::string bytes = kPlyAscii.substr(0, kPlyAscii.find("end_header\n"));
  bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
  bytes += "end_header\n" + packed(0.5F, std::uint8_t{2}, std::int32_t{7}, std::int32_t{8});
  std::uint8_t tags = 0;
  for (const mesh::Point& p : kPoints) {
    bytes += packed(p.x, std::uint8_t{255}, static_cast<float>(p.y), tags);
    for (std::int16_t i = 0; i < tags; ++i) bytes += packed(i);
    bytes += packed(static_cast<std::int32_t>(p.z));
    tags = static_cast<std::uint8_t>((tags + 1) % 3);
  }
  bytes += packed(std::uint8_t{4});
  for (const mesh::Index corner : kQuads[0]) bytes += packed(corner);
  return bytes;
}

inline std::string raw_points() {
  std::string bytes;
  for (const mesh::Point& p : kPoints) bytes += packed(p.x, p.y, p.z);
  return bytes;
}

inline const std::vector<std::array<mesh::Index, 4>> kTetrahedra{{0, 1, 3, 4}, {6, 4, 1, 3}};

inline std::string hxtet_bytes() {
  std::string bytes =
      std::string("HXTET\0\0\1", 8) + packed(std::uint64_t{8}, std::uint64_t{2}) + raw_points();
  for (const auto& tetrahedron : kTetrahedra)
    for (const mesh::Index corner : tetrahedron) bytes += packed(corner);
  return bytes;
}

inline const std::string kPointRows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";

inline const std::string kTetVtk =
    "# vtk DataFile Version 3.0\ntwo\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n" +
    kPointRows + "CELLS 3 14\n4 0 1 3 4\n3 0 1 2\n4 6 4 1 3\nCELL_TYPES 3\n10\n5\n10\n";

inline const std::string kTetMedit = kMeditCube + R"(Triangles 1
1 2 4 7
Tetrahedra 2
1 2 4 5 1
7 5 2 4 1
End
)";

inline const std::string kTetGmsh2 = R"($MeshFormat
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
3
1 4 2 0 1 1 2 4 5
2 2 2 0 1 1 2 4
3 4 2 0 1 7 5 2 4
$EndElements
)";

inline const std::string kTetVtu = R"(<VTKFile type="UnstructuredGrid" version="0.1">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="2"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1
</DataArray></Points><Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 3 4
6 4 1 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10 10</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
)";

inline std::vector<Sample> tetrahedra_samples() {
  return {
      {"vtk", FileFormat::vtk, kTetVtk, {}},
      {"vtu", FileFormat::vtu, kTetVtu, {}},
      {"medit", FileFormat::medit, kTetMedit, {}},
      {"gmsh 2.2", FileFormat::gmsh, kTetGmsh2, {}},
      {"hxtet", FileFormat::hxtet, hxtet_bytes(), {}},
  };
}

/// Files without cells; but for the sign of a zero their points are kPoints.
inline std::vector<Sample> points_samples() {
  return {
      {"xyz", FileFormat::xyz, kXyz, {}},
      {"raw", FileFormat::raw, raw_points(), {}},
      {"ply ascii", FileFormat::ply, kPlyAscii, {}},
      {"ply binary", FileFormat::ply, ply_binary(), {}},
      {"obj", FileFormat::obj, kObj.substr(0, kObj.find("\nf ")) + "\n", {}},
      {"off", FileFormat::off, "OFF\n8 0 0\n" + kPointRows, {}},
      {"vtk grid",
       FileFormat::vtk,
       "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" +
           kPointRows,
       {}},
      {"vtk poly",
       FileFormat::vtk,
       "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" + kPointRows +
           "VERTICES 1 9\n8 0 1 2 3 4 5 6 7\n",
       {}},
      {"vtu",
       FileFormat::vtu,
       "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid>\n"
       "<Piece NumberOfPoints=\"8\" NumberOfCells=\"0\"><Points>\n"
       "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n" +
           kPointRows + "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>\n",
       {}},
      {"medit", FileFormat::medit, kTetMedit.substr(0, kTetMedit.find("Triangles")) + "End\n", {}},
      {"gmsh", FileFormat::gmsh, kTetGmsh2.substr(0, kTetGmsh2.find("$Elements")), {}},
  };
}

}  // namespace hexatlas::io_tests
