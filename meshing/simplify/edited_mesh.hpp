#pragma once
/// \file
/// A mesh in which hexahedra are exchanged one small set at a time, with who meets whom in it.

#include <cstdint>
#include <span>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::simplify {

/// Hexahedra of a mesh, and those that are to take their place. A vertex of the latter that the
/// mesh does not have, numbered from mesh().vertices on, is new.
struct Exchange {
  std::vector<std::uint32_t> cells;
  std::vector<complex::Hexahedron> instead;
};

class EditedMesh {
 public:
  /// Requires that quads are in at most two hexahedra.
  explicit EditedMesh(complex::HexComplex mesh);

  /// Hexahedra are numbered without gaps; of the vertices some may be in no hexahedron.
  [[nodiscard]] const complex::HexComplex& mesh() const noexcept { return mesh_; }
  [[nodiscard]] int size() const noexcept { return static_cast<int>(mesh_.hexahedra.size()); }
  [[nodiscard]] const flips::SubBall::Neighbours& neighbours() const noexcept {
    return neighbours_;
  }
  [[nodiscard]] const flips::SubBall::CellsAt& cells_at() const noexcept { return cells_at_; }

  /// Other hexahedra may get other numbers. Requires that the result obeys the strict rule.
  /// Cost: that of the hexahedra exchanged and of those that meet them, not of the mesh.
  void make(Exchange exchange);

 private:
  void take_new_vertices(std::vector<complex::Hexahedron>& cells);
  void put(std::uint32_t cell, const complex::Hexahedron& vertices);
  void take_out(std::uint32_t cell);
  void link(std::uint32_t cell);
  void move_last_to(std::uint32_t cell);

  complex::HexComplex mesh_;
  flips::SubBall::Neighbours neighbours_;
  flips::SubBall::CellsAt cells_at_;
  std::vector<complex::VertexId> unused_;  ///< vertices in no hexahedron
};

}  // namespace hexatlas::simplify
