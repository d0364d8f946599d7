#pragma once
/// \file
/// Internal to the judge: the laws of a Delaunay triangulation, one function each, with what was
/// counted on the way. Each requires that the laws before it hold (delaunay_check.hpp).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tables/check/delaunay_check.hpp"
#include "tables/check/tetrahedron_facets.hpp"

namespace hexatlas::check {

struct DelaunayFailure {
  DelaunayLaw law;
  std::string reason;
};
using DelaunayFinding = std::optional<DelaunayFailure>;

/// An edge of the boundary: its two facets, the second one reached over the edge from the first.
struct HullEdge {
  FacetNumber facet;
  FacetNumber neighbour;
};

[[nodiscard]] DelaunayFinding check_corners(const TetrahedralMesh& mesh);
[[nodiscard]] DelaunayFinding check_positive(const TetrahedralMesh& mesh, Signs& signs);
/// kTwoTetrahedra and kOppositeSides.
[[nodiscard]] DelaunayFinding check_facets(const TetrahedralMesh& mesh, const Facets& facets);
[[nodiscard]] DelaunayFinding check_connected(const TetrahedralMesh& mesh, const Facets& facets);
/// Each edge of a boundary facet is in exactly two of them, which become `edges`, and the boundary
/// has the Euler characteristic 2.
[[nodiscard]] DelaunayFinding check_boundary_surface(const TetrahedralMesh& mesh,
                                                     const Facets& facets,
                                                     std::vector<HullEdge>& edges,
                                                     DelaunayVerdict& verdict);
[[nodiscard]] DelaunayFinding check_convex_edges(const TetrahedralMesh& mesh,
                                                 const std::vector<HullEdge>& edges, Signs& signs);
/// The tetrahedron with the least bounding box, from whose centroid the boundary is looked at.
[[nodiscard]] std::uint32_t base_tetrahedron(const TetrahedralMesh& mesh);
[[nodiscard]] DelaunayFinding check_no_folds(const TetrahedralMesh& mesh, const Facets& facets,
                                             std::uint32_t base, Signs& signs);
[[nodiscard]] DelaunayFinding check_covered_once(const TetrahedralMesh& mesh, std::uint32_t base,
                                                 Signs& signs);
[[nodiscard]] DelaunayFinding check_unused_points(const TetrahedralMesh& mesh,
                                                  DelaunayVerdict& verdict);
/// The weights of the points, or null, if there are none: then check_unused_points() holds instead.
using Weights = const std::vector<double>*;
[[nodiscard]] DelaunayFinding check_hidden_points(const TetrahedralMesh& mesh,
                                                  const std::vector<double>& weights, Signs& signs,
                                                  DelaunayVerdict& verdict);
/// The sign of the vertex, inside the sphere of the tetrahedron or outside.
[[nodiscard]] int side_of_sphere(const TetrahedralMesh& mesh, Weights weights,
                                 const Tetrahedron& cell, std::uint32_t vertex, Signs& signs);
[[nodiscard]] DelaunayFinding check_empty_spheres(const TetrahedralMesh& mesh, Weights weights,
                                                  const Facets& facets, Signs& signs,
                                                  DelaunayVerdict& verdict);
[[nodiscard]] std::vector<bool> used_points(const TetrahedralMesh& mesh);
[[nodiscard]] std::string name_of(const TetrahedralMesh& mesh, std::size_t tetrahedron);
[[nodiscard]] DelaunayFinding check_given_points(const TetrahedralMesh& mesh,
                                                 const std::vector<Point>& given);

}  // namespace hexatlas::check
