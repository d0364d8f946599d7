#pragma once
/// \file
/// The 3-sphere of two balls of hexahedra with one boundary, and its spin structure.
///
/// Each hexahedron has the coordinates of its corners (enum/cells/cube.hpp). Through a facet they
/// go over into those of the hexahedron across by a rotation of the cube. The spin structure lifts
/// each of these rotations to a quaternion: once around an edge of k hexahedra the product is that
/// of a turn by 4 - k right angles about it, counted and not only modulo a full turn. Up to signs
/// of whole hexahedra the lift is unique (docs/theory/proofs/dual-class.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quaternion.hpp"

namespace hexatlas::complex {

/// Outwards, perpendicular to a facet.
[[nodiscard]] constexpr AxisVector normal_of(std::uint32_t facet) noexcept {
  AxisVector result{};
  result[facet / 2] = facet % 2 == 0 ? -1 : 1;
  return result;
}
/// The facet with this normal.
[[nodiscard]] constexpr std::uint32_t facet_towards(const AxisVector& normal) noexcept {
  std::uint32_t facet = 0;
  while (normal_of(facet) != normal) ++facet;
  return facet;
}

class SpinSphere {
 public:
  /// What is beyond a facet of a hexahedron.
  struct Across {
    std::uint32_t cell = 0;
    std::uint32_t facet = 0;  ///< the same quad, of that hexahedron
    std::uint32_t quad = 0;   ///< number of the quad, 0 .. quads()-1
    Quaternion passage;       ///< lifts the rotation that makes coordinates there of ours

    /// The facet there with the direction of one of ours.
    [[nodiscard]] std::uint32_t carried(std::uint32_t ours) const noexcept {
      return facet_towards(rotated(passage, normal_of(ours)));
    }
  };

  /// Requires two balls glued of right-handed hexahedra, each quad in at most two, with one
  /// boundary on the vertices 0 .. shared-1. They need not obey the strict rule.
  SpinSphere(const HexComplex& ball, const HexComplex& other, VertexId shared);

  [[nodiscard]] std::size_t cells() const noexcept { return across_.size(); }
  [[nodiscard]] std::size_t quads() const noexcept { return 3 * across_.size(); }
  [[nodiscard]] const Across& across(std::uint32_t cell, std::uint32_t facet) const noexcept {
    return across_[cell][facet];
  }

 private:
  struct EdgeWalk;
  void glue(const std::vector<Hexahedron>& cells, std::uint32_t cell, std::uint32_t facet,
            std::uint32_t other_cell, std::uint32_t other_facet);
  [[nodiscard]] EdgeWalk around(std::uint32_t cell, std::uint32_t in, std::uint32_t out) const;
  void lift();

  std::vector<std::array<Across, 6>> across_;
  std::uint32_t glued_ = 0;
};

}  // namespace hexatlas::complex
