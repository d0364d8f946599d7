#pragma once
/// \file
/// Quad flips: the moves on a quadrangulation that glue on one hexahedron.
///
/// Definition. A *patch* is a set D of cube facets such that D and its
/// complement are both disks. Flipping a copy of D inside a quadrangulation Q
/// replaces it by the complementary disk and keeps the boundary cycle fixed.
/// If Q bounds a complex of h hexahedra, the flipped Q bounds one of h + 1.
///
/// Source. Bern, Eppstein, Erickson, "Flipping cubical meshes", Engineering
/// with Computers 18 (2002); used for search by Verhetsel, Pellerin, Remacle,
/// "Finding hexahedrizations for small quadrangulations of the sphere",
/// ACM TOG 38(4) (2019).
///
/// Form. A patch of at most five facets contains a facet, the *bottom*, whose opposite facet,
/// the *top*, it does not contain. So a flip is a bottom quad and a set of its sides, across
/// which the patch continues; see Flip.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "enum/cells/cube.hpp"
#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::flips {

/// A set of cube facets; bit f is facet f. Only the low six bits are used.
struct FacetSet {
  std::uint8_t bits = 0;

  [[nodiscard]] constexpr int size() const noexcept { return std::popcount(bits); }
  [[nodiscard]] constexpr FacetSet complement() const noexcept {
    return {static_cast<std::uint8_t>(~bits & 0b11'11'11U)};
  }
  friend constexpr bool operator==(FacetSet, FacetSet) = default;
};

/// One kind per orbit of patches under the symmetries of the cube.
/// `k2to4` removes two quads and adds four. The inverse of k2to4 is k4to2;
/// k3to3_corner and k3to3_strip are their own inverses.
enum class FlipKind : std::uint8_t { k1to5, k2to4, k3to3_corner, k3to3_strip, k4to2, k5to1 };

/// The kind of flip that removes `patch`, or nullopt if `patch` is not a patch
/// (empty, everything, two opposite facets, or the four-facet annulus).
[[nodiscard]] constexpr std::optional<FlipKind> kind_of(FacetSet patch) noexcept {
  const auto is_spread = [](FacetSet s, int size) {  // `size` facets, no two opposite
    const bool opposite_pair = (s.bits & (s.bits >> 1U) & 0b01'01'01U) != 0;
    return s.size() == size && !opposite_pair;
  };
  const FacetSet rest = patch.complement();
  if (is_spread(patch, 1)) return FlipKind::k1to5;
  if (is_spread(patch, 2)) return FlipKind::k2to4;
  if (is_spread(patch, 3)) return FlipKind::k3to3_corner;
  if (patch.size() == 3) return FlipKind::k3to3_strip;
  if (is_spread(rest, 2)) return FlipKind::k4to2;
  if (is_spread(rest, 1)) return FlipKind::k5to1;
  return std::nullopt;
}

/// Bit i of `sides` is the quad across the edge b_i b_(i+1) of the bottom quad b0 b1 b2 b3.
/// A patch with several bottoms has several such names; is_preferred() selects one.
struct Flip {
  complex::Quad bottom = 0;
  std::uint8_t sides = 0;
  [[nodiscard]] constexpr bool has(unsigned side) const noexcept {
    return (sides >> (side & 3U) & 1U) != 0;
  }
  [[nodiscard]] constexpr int consumed() const noexcept { return 1 + std::popcount(sides); }
  friend constexpr bool operator==(Flip, Flip) = default;
};

inline constexpr int kSideSets = 16;

[[nodiscard]] constexpr FlipKind kind_of(Flip flip) noexcept {
  // Bottom is facet 0; sides 0..3 are facets 2, 4, 3, 5, so that sides i and i + 2 are opposite.
  constexpr std::array<unsigned, 4> kFacetOfSide{2, 4, 3, 5};
  unsigned bits = 1;
  for (unsigned i = 0; i < 4; ++i)
    if (flip.has(i)) bits |= 1U << kFacetOfSide[i];
  return kind_of(FacetSet{static_cast<std::uint8_t>(bits)}).value();
}

/// Marks a vertex of the glued hexahedron that is not on the quadrangulation yet.
inline constexpr complex::Vertex kNewVertex = 0xFF;

/// The hexahedron of a flip: top[j] lies above bottom[j], kNewVertex where no side fixes it.
struct Prism {
  complex::QuadVertices bottom{}, top{};
};

/// The hexahedron that the flip glues on, or nullopt if bottom and sides are no patch in `q`:
/// two adjacent sides without a common edge, or vertices that are not distinct.
[[nodiscard]] std::optional<Prism> prism_of(const complex::Quadrangulation& q, Flip flip) noexcept;

/// Whether the flip is the chosen name of its patch: no other bottom of it is a lower quad.
/// Requires that prism_of(q, flip) exists.
[[nodiscard]] bool is_preferred(const complex::Quadrangulation& q, Flip flip) noexcept;

/// The flipped quadrangulation and where its vertices come from.
struct Flipped {
  complex::Quadrangulation quadrangulation;
  /// For each new vertex number: the former one, or kNewVertex.
  std::array<complex::Vertex, complex::kMaxVertices> former{};
  complex::QuadVertices top{};  ///< the new numbers of top[0..3]
  Flip inverse{};               ///< the flip that takes the hexahedron off again
};

/// Flips. Requires that prism_of(q, flip) is `prism`, that a hexahedron's quads fit
/// (q.quads() + 6 - 2 * flip.consumed() at most 64), and that at least 6 quads remain.
/// Not promised: that the result is a simple graph; see Front for the strict rule.
/// Cost: O(1) plus a copy.
[[nodiscard]] Flipped flipped(const complex::Quadrangulation& q, Flip flip, const Prism& prism);

}  // namespace hexatlas::flips
