#pragma once
/// \file
/// Internal to the judge: the laws of a hybrid mesh, one function each. Each requires that the laws
/// before it hold (hybrid_check.hpp).

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tables/check/hybrid_cells.hpp"
#include "tables/check/hybrid_check.hpp"

namespace hexatlas::check {

struct HybridFailure {
  HybridLaw law;
  std::string reason;
};
using HybridFinding = std::optional<HybridFailure>;

/// A facet of a cell.
struct FacetPlace {
  std::uint32_t cell;
  std::uint8_t facet;
};

/// Its vertices, counterclockwise seen from outside the cell; of a triangle the last is kNoVertex.
using FacetCycle = std::array<std::uint32_t, 4>;
inline constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

[[nodiscard]] FacetCycle cycle_at(const std::vector<HybridCell>& cells, FacetPlace place);
[[nodiscard]] inline std::size_t size_of(const FacetCycle& cycle) {
  return cycle[3] == kNoVertex ? 3 : 4;
}

/// The facets of a mesh by the number of cells in which they lie.
struct HybridFacets {
  std::vector<std::pair<FacetPlace, FacetPlace>> interior;
  std::vector<FacetPlace> boundary;
};

[[nodiscard]] HybridFinding check_corners(const std::vector<HybridCell>& cells,
                                          std::uint64_t points);
/// Goes through all cells, so that what is broken is told before what is not decided; the first
/// hexahedron that is not decided becomes `open`.
[[nodiscard]] HybridFinding check_positive(const std::vector<HybridCell>& cells,
                                           const std::vector<Point>& points, Signs& signs,
                                           std::optional<std::uint32_t>& open);
/// kTwoCells, kSameCycle and kOppositeSides; fills `facets`.
[[nodiscard]] HybridFinding check_facets(const std::vector<HybridCell>& cells,
                                         HybridFacets& facets);
[[nodiscard]] HybridFinding check_diagonals(const std::vector<HybridCell>& cells,
                                            const HybridFacets& facets);
[[nodiscard]] HybridFinding check_around_edges(const std::vector<HybridCell>& cells,
                                               const std::vector<Point>& points, Signs& signs);
[[nodiscard]] HybridFinding check_around_vertices(const std::vector<HybridCell>& cells,
                                                  const HybridFacets& facets, std::uint64_t points);

/// The boundary facets as cycles, from outside.
[[nodiscard]] std::vector<FacetCycle> boundary_of(const std::vector<HybridCell>& cells,
                                                  const HybridFacets& facets);

/// `triangles`: the boundary of the given mesh, all triangles, with its own points.
[[nodiscard]] HybridFinding check_given_boundary(const std::vector<FacetCycle>& boundary,
                                                 const std::vector<Point>& points,
                                                 const std::vector<FacetCycle>& triangles,
                                                 const std::vector<Point>& given_points);

}  // namespace hexatlas::check
