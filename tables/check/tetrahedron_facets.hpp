#pragma once
/// \file
/// Internal to the judge: which tetrahedra share a facet.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

/// The places of the three vertices of the facet opposite vertex i, in the order in which they turn
/// counterclockwise seen from outside a tetrahedron that is positively oriented.
inline constexpr std::array<std::array<std::size_t, 3>, 4> kFacets = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Facet i of tetrahedron t is number 4 t + i.
using FacetNumber = std::uint32_t;
using Triangle = std::array<std::uint32_t, 3>;

[[nodiscard]] Triangle facet_of(std::span<const Tetrahedron> cells, FacetNumber facet);

/// The vertex of the tetrahedron of a facet that is opposite it.
[[nodiscard]] inline std::uint32_t apex_of(std::span<const Tetrahedron> cells, FacetNumber facet) {
  return cells[facet / 4][facet % 4];
}

struct Facets {
  std::vector<std::array<FacetNumber, 2>> interior;
  std::vector<FacetNumber> boundary;
  std::optional<FacetNumber> crowded;   ///< a facet of more than two tetrahedra, if there is one
  std::optional<FacetNumber> same_way;  ///< a facet that two traverse alike, if there is one
};

/// Of tetrahedra with four distinct vertices below `vertex_count` each. If one of the faults is
/// found, the lists end there. Requires fewer than 2^30 tetrahedra. Cost: O(T log d) for T
/// tetrahedra, if d facets at most have one vertex as their least; at the peak 40 bytes per
/// tetrahedron.
[[nodiscard]] Facets facets_of(std::span<const Tetrahedron> cells, std::uint64_t vertex_count);

}  // namespace hexatlas::check
