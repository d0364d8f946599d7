#pragma once
/// \file
/// Internal to the judge: the hexahedron without interior vertex as a formula. Its variables, and
/// clauses each of which holds in every triangulation.
///
/// Definition: docs/theory/triangulation-definition.txt. Cube: docs/theory/conventions.md. Formula,
/// order of its clauses and a proof for each family: docs/formats/completeness.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tables/check/lrat.hpp"

namespace hexatlas::check {

/// Vertices 0 .. 7 of the cube, bit v set if v is a member. Vertex v is x + 2 y + 4 z.
using CubeSet = std::uint16_t;

inline constexpr unsigned kCubeVertices = 8;
inline constexpr unsigned kCubeFacets = 6;
inline constexpr std::size_t kCandidates = 64;
inline constexpr std::size_t kRuleVariables = kCubeFacets + 3 * kCandidates;

/// The vertices v of the facet 2 k + s: those whose bit k is s.
[[nodiscard]] CubeSet cube_facet(unsigned facet) noexcept;
/// The facets that have all these vertices, ascending.
[[nodiscard]] std::vector<unsigned> facets_with(CubeSet set);
/// The members of a set, ascending.
[[nodiscard]] std::vector<unsigned> cube_vertices(CubeSet set);
/// All sets of `size` of the eight vertices, ascending.
[[nodiscard]] std::vector<CubeSet> cube_subsets(int size);

/// The 64 sets of four vertices that are not on one facet, ascending.
[[nodiscard]] const std::array<CubeSet, kCandidates>& candidates();
/// Place in candidates(); nullopt if it is none.
[[nodiscard]] std::optional<std::size_t> candidate_index(CubeSet tetrahedron);

/// The variable "tetrahedron i is a member".
[[nodiscard]] std::int32_t member_variable(std::size_t candidate) noexcept;

/// The clauses of families 1 to 4.
[[nodiscard]] std::vector<Literals> rule_clauses();

}  // namespace hexatlas::check
