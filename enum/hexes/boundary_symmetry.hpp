#pragma once
/// \file
/// The automorphisms of a boundary, and which of the images of a mesh under them is searched for.
///
/// The *type* of a hexahedron on a quad of the boundary: its top vertices in the order of the
/// quad's corners, kInterior for those inside. Let q be the quad on which the search begins. A mesh
/// is kept if its type at q is the least of all its images; so each mesh has an image that is kept,
/// and a state is refuted as soon as a hexahedron on a quad of the orbit of q has an image with a
/// lesser type at q (docs/theory/proofs/hexahedral-search.md).

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "enum/hexes/partial_mesh.hpp"

namespace hexatlas::hexes {

class BoundarySymmetry {
 public:
  static constexpr Vertex kInterior = 0xFF;  ///< after all others
  using Type = std::array<Vertex, 4>;
  /// Image of each vertex of the boundary.
  using Map = std::array<Vertex, complex::kMaxVertices>;

  /// Requires a 3-connected quadrangulation. `first`: the quad q.
  BoundarySymmetry(const complex::Quadrangulation& boundary, int first);

  /// All automorphisms, mirror symmetries included; the identity is among them.
  [[nodiscard]] const std::vector<Map>& maps() const noexcept { return maps_; }
  [[nodiscard]] int first() const noexcept { return first_; }

  /// Whether the hexahedron, on each of its boundary quads in the orbit of q, has no image on q
  /// with a type less than `type`.
  [[nodiscard]] bool has_no_lesser_image(const Cell& cell, const PartialMesh& mesh,
                                         const Type& type) const noexcept;

 private:
  /// A map that takes a quad to q, and which corner of q each corner of it goes to.
  struct ToFirst {
    std::size_t map = 0;
    std::array<std::uint8_t, 4> corner{};
  };

  int first_, boundary_vertices_;
  std::vector<Map> maps_;
  std::vector<std::vector<ToFirst>> to_first_;  ///< of each quad
};

/// The type of a hexahedron on its bottom.
[[nodiscard]] BoundarySymmetry::Type type_on_bottom(const Cell& cell,
                                                    int boundary_vertices) noexcept;

}  // namespace hexatlas::hexes
