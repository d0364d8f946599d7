#pragma once
/// \file
/// Fronts with a symmetry of order two, and the gluing of whole orbits of hexahedra.
///
/// Definition. An *involution* of a boundary is an automorphism of order two: a half-turn, a
/// reflection, or the point reflection. A front with an involution is *symmetric* if the
/// involution takes related vertices to related ones. An *orbit* is a hexahedron together with its
/// image. It may be glued on if its hexahedra may, one after the other; the front is then
/// symmetric again, by the involution that extends the former one. The image of a hexahedron may be
/// the hexahedron itself, or have a facet in common with it that was not on the front.
///
/// Where the axis of a half-turn leads along edges, what is glued on are crowns (crown.hpp).
///
/// Why. Meshes with a symmetry are few among all meshes, and many of the least known ones have one.
/// The two hexahedra of an orbit are one step, so a symmetric search goes twice as deep as one of
/// single hexahedra, and each of its states stands for what would be a pair of choices
/// (docs/theory/proofs/symmetric.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::flips {

/// An automorphism of order two: image[v] for each vertex v.
struct Involution {
  canon::Labelling image{};
  bool is_mirrored = false;  ///< reverses orientation
};

/// The involutions of a boundary that take scars to scars, one of each conjugacy class of the group
/// of all automorphisms that do, in the order of its canonical flags. Requires a 3-connected
/// quadrangulation, and scars in its numbers.
[[nodiscard]] std::vector<Involution> involutions_of(const complex::Quadrangulation& boundary,
                                                     const Scars& scars = {});

struct SymmetricFront {
  Front front;
  canon::Labelling image{};
};

/// The boundary with these scars and one of involutions_of() both.
[[nodiscard]] SymmetricFront symmetric_front(const complex::Quadrangulation& boundary,
                                             const Scars& scars, const Involution& involution);
/// The same with each of these involutions.
[[nodiscard]] std::vector<SymmetricFront> symmetric_fronts(const complex::Quadrangulation& boundary,
                                                           const Scars& scars);

/// The boundary with these scars and the identity in place of an involution: each hexahedron is its
/// own image, and an orbit one step of a search without symmetry, through boundaries longer than
/// those of a State. Requires a 3-connected quadrangulation.
[[nodiscard]] SymmetricFront front_without_symmetry(const complex::Quadrangulation& boundary,
                                                    const Scars& scars);

/// Crowns (crown.hpp) are steps of the same searches, and what is said of an Orbit below covers
/// both. The hexahedra of one are at most so many.
inline constexpr int kMostInOrbit = 12;

/// A hexahedron and its image: the flips made one after the other, the second one in the boundary
/// that the first one leaves. Only the first if the hexahedron is its own image. Or a crown, by its
/// place among those of its front, from 1 on, without flips.
struct Orbit {
  std::array<Flip, 2> flip{};
  std::uint8_t size = 1;    ///< hexahedra
  std::uint16_t crown = 0;  ///< 0: none
  friend bool operator==(const Orbit&, const Orbit&) = default;
};

/// A vertex of the former front, or a new one, numbered from the number of its vertices on, with
/// gaps.
using OrbitVertex = std::uint8_t;
/// New vertices have fewer than so many numbers.
inline constexpr int kNewPerOrbit = 4 * kMostInOrbit;
using OrbitCell = std::array<OrbitVertex, cells::kCubeVertices>;

struct GluedOrbit {
  Orbit orbit;
  SymmetricFront made;
  std::array<OrbitVertex, complex::kMaxVertices> former{};  ///< of each vertex of `made`
  /// The hexahedra, by corner as in enum/cells/cube.hpp. Where quads are counter-clockwise from
  /// outside and the hexahedra lie inside, they are right-handed.
  std::array<OrbitCell, kMostInOrbit> cell{};
};

/// Calls visit(glued) for each orbit that may be glued on so that the boundary then has at least 6
/// and at most `max_quads` quads (between its two hexahedra at most four more), once, in a fixed
/// order. Requires that the front is symmetric, its boundary 3-connected, and max_quads <=
/// kMaxSymmetricQuads. Cost: some microseconds per orbit.
void for_each_glueable_orbit(const SymmetricFront& front, int max_quads,
                             const std::function<void(const GluedOrbit&)>& visit);

/// The one orbit of these flips, which for_each_glueable_orbit() visits with some `max_quads`, or
/// the one crown, of for_each_glueable_crown().
[[nodiscard]] GluedOrbit glued(const SymmetricFront& front, const Orbit& orbit);

/// A symmetric front up to isomorphism.
struct SymmetricState {
  using Scars = ScarSet<kMaxSymmetricQuads>;
  canon::Code code;
  std::array<complex::Vertex, kMaxSymmetricQuads + 2> image{};
  Scars scars;
  [[nodiscard]] std::uint64_t hash(std::uint64_t seed) const noexcept;
  /// That of its class, the boundary and the involution.
  [[nodiscard]] std::uint64_t hash_of_class() const noexcept;
  friend auto operator<=>(const SymmetricState&, const SymmetricState&) = default;
};

/// The state of the front alone; nullopt if its boundary has more than kMaxStateQuads quads.
[[nodiscard]] std::optional<State> state_without_symmetry(const SymmetricState& state);

/// The state of a front, with the labelling that yields it: of all labellings that attain the code,
/// the one with the least image, and of these with the least scars. Requires at most
/// kMaxSymmetricQuads quads.
struct CanonicalSymmetricState {
  SymmetricState state;
  canon::Labelling label{};
  bool is_mirrored = false;
};
[[nodiscard]] CanonicalSymmetricState canonical_state(const SymmetricFront& front);

/// The front of a state, its boundary being the canonical list of quads.
/// Requires that the code can be decoded.
[[nodiscard]] SymmetricFront front_of(const SymmetricState& state);

}  // namespace hexatlas::flips
