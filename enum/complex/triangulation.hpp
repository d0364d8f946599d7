#pragma once
/// \file
/// Simplicial complexes of dimension three given by their tetrahedra: triangulations of balls and
/// spheres on few vertices.
///
/// Shapes. A set of vertices is a word with a bit per vertex; a triangulation is a list of such
/// words with four bits each. Definition of a triangulation of a cell:
/// docs/theory/triangulation-definition.txt.

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hexatlas::complex {

inline constexpr int kMaxTriangulationVertices = 16;

/// Vertices 0 .. 15, bit v set if v is a member.
using VertexSet = std::uint16_t;

[[nodiscard]] constexpr VertexSet bit_of(int vertex) noexcept {
  return static_cast<VertexSet>(1U << static_cast<unsigned>(vertex));
}
[[nodiscard]] constexpr int least_vertex(VertexSet set) noexcept {
  return std::countr_zero(static_cast<unsigned>(set));
}
[[nodiscard]] constexpr VertexSet without_least(VertexSet set) noexcept {
  return static_cast<VertexSet>(set & (set - 1U));
}

/// The four members of a tetrahedron, ascending. Requires four members.
[[nodiscard]] std::array<std::uint8_t, 4> vertices_of(VertexSet tetrahedron);

struct Triangulation {
  int vertices = 0;
  std::vector<VertexSet> tetrahedra;  ///< ascending, unless a function says otherwise

  friend auto operator<=>(const Triangulation&, const Triangulation&) = default;
};

/// Image of each vertex.
using VertexMap = std::array<std::uint8_t, kMaxTriangulationVertices>;

[[nodiscard]] VertexSet image_of(VertexSet set, const VertexMap& map) noexcept;
/// Tetrahedra of the image, ascending.
[[nodiscard]] Triangulation image_of(const Triangulation& triangulation, const VertexMap& map);

/// The triangles in exactly one tetrahedron, ascending.
[[nodiscard]] std::vector<VertexSet> boundary_triangles(const Triangulation& triangulation);

/// +1 or -1 per tetrahedron, +1 for the first: if tetrahedra abcd, a < b < c < d, are oriented as
/// listed for +1 and opposite for -1, each triangle in two of them gets two opposite orientations.
/// nullopt: not orientable. Requires a strongly connected complex (any two tetrahedra joined by
/// a chain of common triangles) with at most two tetrahedra at a triangle.
[[nodiscard]] std::optional<std::vector<int>> orientation_of(const Triangulation& triangulation);

enum class ShellingSearch : std::uint8_t { found, none, given_up };

/// A shelling: an order of the tetrahedra in which each one after the first meets the union of
/// those before it in a pure two-dimensional complex, and only the last of a sphere in its whole
/// boundary. Order of tetrahedra by index.
struct ShellingAnswer {
  ShellingSearch outcome = ShellingSearch::none;
  std::vector<std::size_t> order;
};

/// Searches for a shelling, depth first, in at most `budget` steps. If found, the complex is a ball
/// or a sphere (Danaraj, Klee, "Which spheres are shellable?", 1978), provided each triangle lies
/// in at most two tetrahedra, which is required. `none` says that no order from any start works.
[[nodiscard]] ShellingAnswer search_shelling(const Triangulation& triangulation,
                                             std::size_t budget = 100'000);

/// Whether it is a ball or a sphere: proven so by a shelling of it or of the sphere obtained by a
/// cone over its boundary; proven not, by a broken local law or a homology group modulo 2 that is
/// not that of a sphere; or neither.
enum class Topology : std::uint8_t { ball, sphere, other, undecided };
[[nodiscard]] Topology topology_of(const Triangulation& triangulation);

}  // namespace hexatlas::complex
