#pragma once
/// \file
/// A pyramid, a prism, the whole and a tetrahedron in the unit cube, with a facet among them, by
/// hand in each format: each right-handed, though they overlap.

#include <string>
#include <vector>

#include "tests/meshing/io/sample_points.hpp"

namespace hexatlas::io_tests {

inline const mesh::HybridMesh kFour{kPoints,
                                    {{0, 1, 3, 4}},
                                    {{0, 1, 3, 2, 4, 5, 7, 6}},
                                    {{0, 1, 2, 4, 5, 6}},
                                    {{0, 1, 2, 3, 4}, {4, 7, 6, 5, 0}}};

inline bool same(const mesh::HybridMesh& a, const mesh::HybridMesh& b) {
  return bits(a.points) == bits(b.points) && a.tetrahedra == b.tetrahedra &&
         a.hexahedra == b.hexahedra && a.prisms == b.prisms && a.pyramids == b.pyramids;
}

/// The corners of a wedge turn the other way.
inline const std::string kHybridVtk =
    "# vtk DataFile Version 3.0\nfour\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n" +
    kPointRows +
    "CELLS 6 37\n5 0 1 2 3 4\n6 0 2 1 4 6 5\n8 0 1 2 3 4 5 6 7\n3 0 1 2\n4 0 1 3 4\n"
    "5 4 7 6 5 0\nCELL_TYPES 6\n14\n13\n12\n5\n10\n14\n";

inline const std::string kHybridMedit = kMeditCube + R"(Triangles 1
1 2 3 7
Pyramids 2
1 2 3 4 5 1
5 8 7 6 1 1
Prisms 1
1 2 3 5 6 7 1
Hexahedra 1
1 2 3 4 5 6 7 8 1
Tetrahedra 1
1 2 4 5 1
End
)";

inline const std::string kGmshNodes2 = kTetGmsh2.substr(0, kTetGmsh2.find("$Elements"));

inline const std::string kHybridGmsh2 = kGmshNodes2 + R"($Elements
6
1 7 2 0 1 1 2 3 4 5
2 6 2 0 1 1 2 3 5 6 7
3 5 2 0 1 1 2 3 4 5 6 7 8
4 2 2 0 1 1 2 3
5 4 2 0 1 1 2 4 5
6 7 2 0 1 5 8 7 6 1
$EndElements
)";

inline const std::string kHybridGmsh4 = kHexGmsh4.substr(0, kHexGmsh4.find("$Elements")) +
                                        R"($Elements
5 6 1 6
3 1 7 2
1 1 2 3 4 5
6 5 8 7 6 1
3 1 6 1
2 1 2 3 5 6 7
2 9 2 1
4 1 2 3
3 1 5 1
3 1 2 3 4 5 6 7 8
3 2 4 1
5 1 2 4 5
$EndElements
)";

inline const std::string kHybridVtu = R"(<VTKFile type="UnstructuredGrid" version="0.1">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="6"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1
</DataArray></Points><Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 4
0 2 1 4 6 5
0 1 2 3 4 5 6 7
0 1 2
0 1 3 4
4 7 6 5 0</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">5 11 19 22 26 31</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">14 13 12 5 10 14</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
)";

inline std::vector<Sample> hybrid_samples() {
  return {
      {"vtk", FileFormat::vtk, kHybridVtk, {}},
      {"vtu", FileFormat::vtu, kHybridVtu, {}},
      {"medit", FileFormat::medit, kHybridMedit, {}},
      {"gmsh 2.2", FileFormat::gmsh, kHybridGmsh2, {}},
      {"gmsh 4.1", FileFormat::gmsh, kHybridGmsh4, {}},
  };
}

}  // namespace hexatlas::io_tests
