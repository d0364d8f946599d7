#include "tables/check/hybrid_check.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "tables/check/hybrid_laws.hpp"

namespace hexatlas::check {

namespace {

/// What the laws of one mesh left.
struct Judged {
  HybridFinding found;
  std::optional<std::string> open;  ///< a hexahedron that is not decided
  std::vector<FacetCycle> boundary;
};

Judged judged(const std::vector<HybridCell>& cells, const std::vector<Point>& points) {
  Judged result;
  Signs signs;
  std::optional<std::uint32_t> open;
  HybridFacets facets;
  HybridFinding& found = result.found;
  found = check_corners(cells, points.size());
  if (!found) found = check_positive(cells, points, signs, open);
  if (!found) found = check_facets(cells, facets);
  if (!found) found = check_diagonals(cells, facets);
  if (!found) found = check_around_edges(cells, points, signs);
  if (!found) found = check_around_vertices(cells, facets, points.size());
  if (found) return result;
  if (open) result.open = name_of(cells[*open]);
  result.boundary = boundary_of(cells, facets);
  return result;
}

Judged judged(const TetrahedralMesh& mesh) {
  return judged(cells_of(HybridMesh{{}, mesh.tetrahedra, {}, {}, {}}), mesh.points);
}

/// Tetrahedra that are inside out, all of them, are the same domain, so these are turned over.
HybridFinding check_given(const std::vector<FacetCycle>& boundary, const HybridMesh& mesh,
                          const TetrahedralMesh& given) {
  Judged tetrahedra = judged(given);
  if (tetrahedra.found && tetrahedra.found->law == HybridLaw::kPositive) {
    TetrahedralMesh turned = given;
    for (Tetrahedron& t : turned.tetrahedra) std::swap(t[2], t[3]);
    if (Judged other = judged(turned); !other.found) tetrahedra = std::move(other);
  }
  if (tetrahedra.found) {
    return HybridFailure{HybridLaw::kGivenMesh, "in the given mesh: " + tetrahedra.found->reason};
  }
  return check_given_boundary(boundary, mesh.points, tetrahedra.boundary, given.points);
}

std::uint64_t unused_points(const std::vector<HybridCell>& cells, std::uint64_t points) {
  std::vector<bool> used(points, false);
  for (const HybridCell& cell : cells) {
    for (const std::uint32_t vertex : cell.corners()) used[vertex] = true;
  }
  return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
}

void count_boundary(const std::vector<FacetCycle>& boundary, const std::vector<Point>& points,
                    HybridVerdict& verdict) {
  Signs signs;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> facets_at_edge;
  for (const FacetCycle& cycle : boundary) {
    const std::size_t size = size_of(cycle);
    ++(size == 3 ? verdict.boundary_triangles : verdict.boundary_quads);
    if (size == 4 && signs.orientation(points[cycle[0]], points[cycle[1]], points[cycle[2]],
                                       points[cycle[3]]) != 0) {
      ++verdict.warped_boundary_quads;
    }
    for (std::size_t i = 0; i < size; ++i) {
      ++facets_at_edge[std::minmax({cycle[i], cycle[(i + 1) % size]})];
    }
  }
  for (const auto& [edge, facets] : facets_at_edge) {
    if (facets > 2) ++verdict.singular_boundary_edges;
  }
}

}  // namespace

const char* name_of(HybridLaw law) {
  constexpr std::array<const char*, 11> kNames = {
      "none",     "corners",     "positive",      "two-cells",  "same-cycle",    "opposite-sides",
      "diagonal", "around-edge", "around-vertex", "given-mesh", "given-boundary"};
  return kNames[static_cast<std::size_t>(law)];
}

HybridVerdict check_hybrid(const HybridMesh& mesh, const TetrahedralMesh* given) {
  HybridVerdict verdict;
  verdict.points = mesh.points.size();
  verdict.tetrahedra = mesh.tetrahedra.size();
  verdict.hexahedra = mesh.hexahedra.size();
  verdict.prisms = mesh.prisms.size();
  verdict.pyramids = mesh.pyramids.size();
  const std::vector<HybridCell> cells = cells_of(mesh);
  Judged result = judged(cells, mesh.points);
  if (!result.found && given != nullptr) {
    result.found = check_given(result.boundary, mesh, *given);
  }
  if (!result.found && result.open) {
    verdict.undecided = true;
    result.found = HybridFailure{
        HybridLaw::kPositive,
        "it is not decided whether the Jacobian determinant is positive in " + *result.open};
  }
  verdict.accepted = !result.found;
  if (result.found) {
    verdict.broken = result.found->law;
    verdict.reason = result.found->reason;
    return verdict;
  }
  verdict.unused_points = unused_points(cells, mesh.points.size());
  count_boundary(result.boundary, mesh.points, verdict);
  return verdict;
}

}  // namespace hexatlas::check
