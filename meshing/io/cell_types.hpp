#pragma once
/// \file
/// Types of cells in mesh files, and the only place where a file's order of the corners of a
/// cell meets the project's (enum/cells/cube.hpp).
///
/// VTK, MEDIT and Gmsh list a hexahedron as its bottom quad, cyclically, then its top quad:
/// position i of the file is our corner kFileCorner[i]. Sources: the VTK file formats document,
/// the MEDIT report, the reference manual of Gmsh; confirmed with VTK and Gmsh themselves by
/// tests/meshing/io/peers_test.py.
///
/// Pyramids are as here in all formats, prisms in MEDIT and Gmsh: the first triangle turns
/// counterclockwise seen from the second one. VTK documents the opposite for its wedge ("a triangle
/// whose normal points outward"), and its faces, volumes and validity follow the document, though
/// the shape functions of the same class do not; Gmsh exchanges the corners when it writes .vtk. So
/// position i of a wedge is our corner kWedgeCorner[i]. A program that leaves that out writes
/// wedges that are left-handed prisms here. Confirmed by tests/meshing/io/hybrid_peers_test.py; for
/// MEDIT, which no installed program reads with prisms, by the facets that libMeshb's transmesh
/// gives them.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "enum/cells/cube.hpp"

namespace hexatlas::io {

inline constexpr std::array<cells::CubeVertex, cells::kCubeVertices> kFileCorner{0, 1, 3, 2,
                                                                                 4, 5, 7, 6};
inline constexpr std::array<std::size_t, 6> kWedgeCorner{0, 2, 1, 3, 5, 4};

enum class CellShape : std::uint8_t {
  low,          ///< points and edges: ignored everywhere
  quad,         ///< four corners in cyclic order
  pixel,        ///< four corners, x + 2y
  surface,      ///< any other cell of dimension 2
  tetrahedron,  ///< four corners, right-handed if det(b - a, c - a, d - a) > 0, as here
  hexahedron,   ///< eight corners in the order of kFileCorner
  voxel,        ///< eight corners, x + 2y + 4z
  prism,        ///< six corners, as mesh::Prism
  wedge,        ///< six corners in the order of kWedgeCorner
  pyramid,      ///< five corners, as mesh::Pyramid
  volume,       ///< any other cell of dimension 3
};

struct CellType {
  std::string_view name;
  CellShape shape;
  int vertices;  ///< 0: any number
};

inline constexpr CellType kTriangle{"triangle", CellShape::surface, 3};
inline constexpr CellType kQuad{"quad", CellShape::quad, 4};
inline constexpr CellType kTetrahedron{"tetrahedron", CellShape::tetrahedron, 4};
inline constexpr CellType kHexahedron{"hexahedron", CellShape::hexahedron, 8};
inline constexpr CellType kPrism{"prism", CellShape::prism, 6};
inline constexpr CellType kWedge{"wedge", CellShape::wedge, 6};
inline constexpr CellType kPyramid{"pyramid", CellShape::pyramid, 5};

/// What the formats call a type of cells that is written.
struct FileCell {
  CellType type;
  int dimension;
  int vtk;   ///< its number in VTK
  int gmsh;  ///< its number in Gmsh
  std::string_view medit;
};

inline constexpr FileCell kFileTriangle{kTriangle, 2, 5, 2, "Triangles"};
inline constexpr FileCell kFileQuad{kQuad, 2, 9, 3, "Quadrilaterals"};
inline constexpr FileCell kFileTetrahedron{kTetrahedron, 3, 10, 4, "Tetrahedra"};
inline constexpr FileCell kFileHexahedron{kHexahedron, 3, 12, 5, "Hexahedra"};
inline constexpr FileCell kFilePrism{kPrism, 3, 13, 6, "Prisms"};
inline constexpr FileCell kFilePyramid{kPyramid, 3, 14, 7, "Pyramids"};

/// The cell type with this number in VTK or Gmsh; none if unknown.
[[nodiscard]] std::optional<CellType> vtk_cell_type(std::int64_t number);
[[nodiscard]] std::optional<CellType> gmsh_cell_type(std::int64_t number);

/// The type of a polygon with this number of corners.
[[nodiscard]] CellType polygon_type(std::size_t corners);

}  // namespace hexatlas::io
