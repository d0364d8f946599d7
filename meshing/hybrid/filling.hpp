#pragma once
/// \file
/// The tetrahedra inside a cell whose vertices are vertices of the mesh.
///
/// Definition. A *face triangle* of a cell is three vertices of one of its faces. The filling from
/// a tetrahedron t is the set of tetrahedra that are joined to t by facets that are no face
/// triangles. It is accepted if its boundary consists of two triangles of each quad, which share
/// a diagonal, and of each triangular face. A tetrahedron beyond a face triangle with the four
/// vertices of that quad is *flat*: it belongs to the cell without being inside.
///
/// What this proves. The boundary is a triangulated sphere; if the mesh is embedded in space, the
/// filling is a ball, since a polyhedral sphere bounds one on its inner side.
///
/// Source: J. Pellerin, A. Johnen, K. Verhetsel, J.-F. Remacle, "Identifying combinations of
/// tetrahedra into hexahedra: a vertex based strategy", CAD 105 (2018), arXiv 1705.02451.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/cells/shapes.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

inline constexpr std::size_t kMostInside = 15;  ///< of inner and flat ones together

/// The faces of a cell, as far as a filling sees them.
struct CellShape {
  std::size_t fewest = 0;                    ///< inner tetrahedra
  std::size_t most = 0;                      ///< tetrahedra, flat ones included
  int triangles = 0;                         ///< on the boundary of a filling
  std::array<cells::ShapeFacet, 6> faces{};  ///< cyclic
  std::array<std::uint8_t, 6> sizes{};       ///< 3, 4, or 0 for none
  /// For sets of three and four vertices in one face that face, otherwise kNoFace.
  std::array<std::uint8_t, 256> face_of{};
};
inline constexpr std::uint8_t kNoFace = 0xFF;

extern const CellShape kHexahedronShape;  ///< numbering of enum/cells/cube.hpp
extern const CellShape kPrismShape;       ///< numbering of mesh::Prism
extern const CellShape kPyramidShape;     ///< numbering of mesh::Pyramid

/// Inner tetrahedra first, then flat ones.
struct Filling {
  std::array<TetIndex, kMostInside> tetrahedra{};
  std::uint8_t inner = 0;
  std::uint8_t flat = 0;

  [[nodiscard]] std::span<const TetIndex> inside() const noexcept {
    return std::span(tetrahedra).first(inner);
  }
  [[nodiscard]] std::span<const TetIndex> all() const noexcept {
    return std::span(tetrahedra).first(std::size_t{inner} + flat);
  }
};

/// Fills cells one after another; a thread has its own. Memory: a byte for each point.
class Filler {
 public:
  explicit Filler(const TetGraph& graph)
      : graph_(&graph), corner_of_(graph.points().size(), kNone) {}

  /// The filling from `start` if it is accepted, all its tetrahedra have one region, no facet
  /// between two of them is on a surface, the two triangles of each quad have one colour and are
  /// both or neither on the boundary of the mesh, and the numbers of tetrahedra are those of the
  /// shape.
  [[nodiscard]] std::optional<Filling> filling(const CellShape& shape,
                                               std::span<const Index> vertices, TetIndex start);

 private:
  static constexpr std::uint8_t kNone = 8;
  struct Work;

  [[nodiscard]] unsigned bit(Index v) const noexcept { return 1U << corner_of_[v]; }
  /// Below 256 if all are vertices of the cell.
  [[nodiscard]] unsigned set_of(const Tetrahedron& t) const noexcept {
    return bit(t[0]) | bit(t[1]) | bit(t[2]) | bit(t[3]);
  }
  bool visit(Work& work, TetIndex t) const;
  bool cross(Work& work, TetIndex t, unsigned facet) const;
  [[nodiscard]] bool are_alike(const Work& work, std::size_t face) const;
  [[nodiscard]] bool is_accepted(const Work& work) const;
  bool complete(Work& work) const;

  const TetGraph* graph_;
  std::vector<std::uint8_t> corner_of_;
};

}  // namespace hexatlas::hybrid
