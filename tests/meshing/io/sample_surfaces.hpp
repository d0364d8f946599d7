#pragma once
/// \file
/// The boundary of the unit cube, written by hand as text in each format. The binary arrays of the
/// VTK XML samples were made with Python's struct, zlib and base64.

#include <string>

namespace hexatlas::io_tests {

inline const std::string kObj = R"(# a box
mtllib box.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
vt 0 0
vn 0 0 1
f 1 4 3 2
f 5/1 6/1 7/1 8/1
f 1//1 2//1 6//1 5//1
f 2/1/1 3/1/1 7/1/1 6/1/1
f -6 -5 -1 -2
f 4 1 5 8
)";

inline const std::string kOff = R"(OFF
# a box
8 6 12
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 0 3 2 1
4 4 5 6 7 255 0 0
4 0 1 5 4
4 1 2 6 5 # comment
4 2 3 7 6
4 3 0 4 7
)";

inline const std::string kVtkPoly = R"(# vtk DataFile Version 2.0
a box
ASCII
DATASET POLYDATA
POINTS 8 float
0 0 0 1 0 0 1 1 0
0 1 0 0 0 1 1 0 1
1 1 1 0 1 1
POLYGONS 6 30
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
CELL_DATA 6
SCALARS id int 1
LOOKUP_TABLE default
1 2 3 4 5 6
)";

inline const std::string kVtkGrid = R"(# vtk DataFile Version 3.0
a box with an edge and a vertex
ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 1
TIME 1 1 double
0.5
POINTS 8 double
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
CELLS 8 35
2 0 1
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
1 2
CELL_TYPES 8
3
9
9
9
9
9
9
1
)";

inline const std::string kVtk5 = R"(# vtk DataFile Version 5.1
a box
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
0 0 0 1 0 0 1 1 0
0 1 0 0 0 1 1 0 1
1 1 1 0 1 1
METADATA
INFORMATION 1
NAME L2_NORM_RANGE LOCATION vtkDataArray
DATA 2 0 1.7

CELLS 7 24
OFFSETS vtktypeint64
0 4 8 12 16 20 24
CONNECTIVITY vtktypeint32
0 3 2 1 4 5 6 7
0 1 5 4
1 2 6 5 2 3 7 6
3 0 4 7
CELL_TYPES 6
9
9
9
9
9
9

)";

inline const std::string kVtuAscii = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid>
<Piece NumberOfPoints="8" NumberOfCells="6">
<PointData></PointData>
<Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0
0 1 0 0 0 1 1 0 1
1 1 1 0 1 1
</DataArray>
</Points>
<Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">
0 3 2 1
4 5 6 7
0 1 5 4
1 2 6 5
2 3 7 6
3 0 4 7
</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">
4 8 12 16 20 24
</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">
9 9 9 9 9 9
</DataArray>
</Cells>
</Piece>
</UnstructuredGrid>
</VTKFile>
)";

inline const std::string kVtuInline =
    R"(<VTKFile type="UnstructuredGrid" version="0.1" header_type="UInt32">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="6">
<Points>
<DataArray type="Float32" NumberOfComponents="3" format="binary">
YAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAIA/AAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAgD8AAAAAAACAPwAAgD8AAIA/AACAPwAAAAAAAIA/AACAPw==
</DataArray>
</Points>
<Cells>
<DataArray type="Int32" Name="connectivity" format="binary">
YAAAAAAAAAADAAAAAgAAAAEAAAAEAAAABQAAAAYAAAAHAAAAAAAAAAEAAAAFAAAABAAAAAEAAAACAAAABgAAAAUAAAACAAAAAwAAAAcAAAAGAAAAAwAAAAAAAAAEAAAABwAAAA==
</DataArray>
<DataArray type="Int32" Name="offsets" format="binary">GAAAAAQAAAAIAAAADAAAABAAAAAUAAAAGAAAAA==</DataArray>
<DataArray type="UInt8" Name="types" format="binary">BgAAAAkJCQkJCQ==</DataArray>
</Cells>
</Piece></UnstructuredGrid></VTKFile>
)";

inline const std::string kVtuCompressed =
    R"(<VTKFile type="UnstructuredGrid" version="0.1" compressor="vtkZLibDataCompressor">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="6">
<Points>
<DataArray type="Float32" NumberOfComponents="3" format="binary">
AgAAAEAAAAAgAAAAFQAAABEAAAA=eNpjYEAGDfaobHQ+utoGewBwLgR7eNpjYACBBntUjBADAEBOBHs=
</DataArray>
</Points>
<Cells>
<DataArray type="Int32" Name="connectivity" format="binary">
AgAAAEAAAAAgAAAAKQAAABgAAAA=eNpjYGBgYAZiJiBmBGIWIGYFYjYgZmeAAEaoGAuUzQSVB4kBAAZwADV42mNiYGBgBmJ2IGaDskGABSoGAAJAACE=
</DataArray>
<DataArray type="Int32" Name="offsets" format="binary">
AQAAAEAAAAAYAAAAGAAAAA==eNpjYWBg4ABiHiAWAGIRIJYAYgADmABV
</DataArray>
<DataArray type="UInt8" Name="types" format="binary">
AQAAAEAAAAAGAAAACwAAAA==eNrj5AQBAADDADc=
</DataArray>
</Cells>
</Piece></UnstructuredGrid></VTKFile>
)";

inline const std::string kMedit = R"(MeshVersionFormatted 1

Dimension
3
# a box
Vertices
8
0 0 0 1
1 0 0 1
1 1 0 1
0 1 0 1
0 0 1 1
1 0 1 1
1 1 1 1
0 1 1 -1

Edges
1
1 2 7
Quadrilaterals
6
1 4 3 2 0
5 6 7 8 0
1 2 6 5 0
2 3 7 6 0
3 4 8 7 0
4 1 5 8 0
Corners 2
1
2
Normals
1
0 0 1
End
)";

inline const std::string kGmsh2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "box"
$EndPhysicalNames
$Nodes
8
10 0 0 0
20 1 0 0
7 1 1 0
8 0 1 0
30 0 0 1
40 1 0 1
4294967303 1 1 1
60 0 1 1
$EndNodes
$Elements
8
1 15 2 0 1 10
2 1 2 0 1 10 20
3 3 2 0 1 10 8 7 20
4 3 2 0 1 30 40 4294967303 60
5 3 2 0 1 10 20 40 30
6 3 2 0 1 20 7 4294967303 40
7 3 2 0 1 7 8 60 4294967303
8 3 0 8 10 30 60
$EndElements
)";

inline const std::string kGmsh4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 1 0
1 0 0 0 1 1 1 0 0
$EndEntities
$Nodes
2 8 1 50
0 1 0 1
50
0 0 0
2 1 1 7
2
3
4
5
6
7
8
1 0 0 0.5 0.5
1 1 0 0.5 0.5
0 1 0 0.5 0.5
0 0 1 0.5 0.5
1 0 1 0.5 0.5
1 1 1 0.5 0.5
0 1 1 0.5 0.5
$EndNodes
$Elements
2 7 1 7
0 1 15 1
1 50
2 1 3 6
2 50 4 3 2
3 5 6 7 8
4 50 2 6 5
5 2 3 7 6
6 3 4 8 7
7 4 50 5 8
$EndElements
)";

}  // namespace hexatlas::io_tests
