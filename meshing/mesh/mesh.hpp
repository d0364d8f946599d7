#pragma once
/// \file
/// Meshes with coordinates: points and lists of cells. No connectivity is stored; the laws of
/// a surface are checked by enum/complex.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace hexatlas::mesh {

struct Point {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

[[nodiscard]] inline bool is_finite(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

using Index = std::uint32_t;  ///< of a point, from 0

/// Readers refuse more; the two largest values of Index name no point.
inline constexpr std::uint64_t kMostPoints = 0xFFFF'FFFE;

/// Each point with its weight, of the dimension of squared lengths.
struct WeightedPoints {
  std::vector<Point> points;
  std::vector<double> weights;
};

/// Quads as read from a file: any orientation, any topology, each index below points.size().
struct SurfaceMesh {
  std::vector<Point> points;
  std::vector<std::array<Index, 4>> quads;  ///< cyclic order
  std::vector<std::uint32_t> quad_line;     ///< line of the file, 0: unknown; one per quad
};

/// A triangle or a quad, in cyclic order; of a triangle the last index is 0 and without meaning.
struct Facet {
  std::array<Index, 4> vertices{};
  std::uint8_t size = 3;   ///< 3 or 4
  std::uint32_t line = 0;  ///< of the file, 0: unknown
  /// Of which part of the surface it is: the reference in .mesh, the entity in .msh, else 0.
  std::int64_t colour = 0;
};

/// Triangles and quads as read from a file: as SurfaceMesh otherwise.
struct FacetMesh {
  std::vector<Point> points;
  std::vector<Facet> facets;
};

/// Hexahedra in the numbering of enum/cells/cube.hpp: vertex x + 2y + 4z.
struct HexMesh {
  std::vector<Point> points;
  std::vector<std::array<Index, 8>> hexahedra;
};

/// The same with what a file says of them: to which region each belongs, and quads that it lists.
struct HexModel {
  HexMesh mesh;
  std::vector<std::uint32_t> regions;  ///< one per hexahedron, or none at all: one region
  std::vector<std::array<Index, 4>> quads;
};

/// Tetrahedra (a, b, c, d); right-handed ones have det(b - a, c - a, d - a) > 0. Whether they are,
/// say those who make them.
struct TetMesh {
  std::vector<Point> points;
  std::vector<std::array<Index, 4>> tetrahedra;
};

/// The same, kept elsewhere.
struct TetView {
  std::span<const Point> points;
  std::span<const std::array<Index, 4>> tetrahedra;
};

/// Tetrahedra with what hybrid meshing needs beside them: to which region each belongs, and
/// triangles with the surface (the colour) to which each belongs.
struct TetModel {
  TetMesh mesh;
  std::vector<std::uint32_t> regions;  ///< one per tetrahedron, or none at all: one region
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::uint32_t> colours;  ///< one per triangle
};

/// Bottom triangle 0 1 2, top triangle 3 4 5, i + 3 above i; a right-handed one has
/// det(p1 - p0, p2 - p0, p3 - p0) > 0.
using Prism = std::array<Index, 6>;

/// Base 0 1 2 3, cyclic, and apex 4; a right-handed one has det(p1 - p0, p3 - p0, p4 - p0) > 0.
using Pyramid = std::array<Index, 5>;

/// Cells of four shapes that share points; tetrahedra and hexahedra as in TetMesh and HexMesh.
struct HybridMesh {
  std::vector<Point> points;
  std::vector<std::array<Index, 4>> tetrahedra;
  std::vector<std::array<Index, 8>> hexahedra;
  std::vector<Prism> prisms;
  std::vector<Pyramid> pyramids;
  /// To which each cell belongs, tetrahedra first, then in the order above; or none at all: one
  /// region.
  std::vector<std::uint32_t> regions{};
};

}  // namespace hexatlas::mesh
