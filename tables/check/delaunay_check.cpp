#include "tables/check/delaunay_check.hpp"

#include <algorithm>
#include <array>

#include "tables/check/delaunay_laws.hpp"
#include "tables/check/disjoint_sets.hpp"
#include "tables/check/incidence.hpp"

namespace hexatlas::check {

namespace {

DelaunayFinding broken_law(const TetrahedralMesh& mesh, const std::vector<Point>* given,
                           Weights weights, Signs& signs, DelaunayVerdict& verdict) {
  DelaunayFinding found = check_corners(mesh);
  if (!found) found = check_positive(mesh, signs);
  if (found) return found;
  const Facets facets = facets_of(mesh.tetrahedra, mesh.points.size());
  std::vector<HullEdge> edges;
  found = check_facets(mesh, facets);
  if (!found) found = check_connected(mesh, facets);
  if (!found) found = check_boundary_surface(mesh, facets, edges, verdict);
  if (!found) found = check_convex_edges(mesh, edges, signs);
  if (found) return found;
  const std::uint32_t base = base_tetrahedron(mesh);
  found = check_no_folds(mesh, facets, base, signs);
  if (!found) found = check_covered_once(mesh, base, signs);
  if (!found && given != nullptr) found = check_given_points(mesh, *given);
  if (!found) {
    found = weights == nullptr ? check_unused_points(mesh, verdict)
                               : check_hidden_points(mesh, *weights, signs, verdict);
  }
  if (!found) found = check_empty_spheres(mesh, weights, facets, signs, verdict);
  verdict.facets = facets.interior.size() + facets.boundary.size();
  return found;
}

DelaunayVerdict judged(const TetrahedralMesh& mesh, const std::vector<Point>* given,
                       Weights weights) {
  DelaunayVerdict verdict;
  verdict.points = mesh.points.size();
  verdict.tetrahedra = mesh.tetrahedra.size();
  Signs signs;
  const DelaunayFinding found = broken_law(mesh, given, weights, signs, verdict);
  verdict.accepted = !found;
  if (found) {
    verdict.broken = found->law;
    verdict.reason = found->reason;
  }
  verdict.signs = signs.counts();
  return verdict;
}

}  // namespace

std::string name_of(const TetrahedralMesh& mesh, std::size_t tetrahedron) {
  return "tetrahedron " + std::to_string(tetrahedron) + " " + listed(mesh.tetrahedra[tetrahedron]);
}

std::vector<bool> used_points(const TetrahedralMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    for (const std::uint32_t vertex : cell) used[vertex] = true;
  }
  return used;
}

DelaunayFinding check_corners(const TetrahedralMesh& mesh) {
  if (mesh.tetrahedra.empty()) {
    return DelaunayFailure{DelaunayLaw::kCorners, "there are no tetrahedra"};
  }
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Tetrahedron sorted = mesh.tetrahedra[t];
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= mesh.points.size()) {
      return DelaunayFailure{DelaunayLaw::kCorners,
                             name_of(mesh, t) + " has a vertex that is not among the " +
                                 std::to_string(mesh.points.size()) + " points"};
    }
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
      return DelaunayFailure{DelaunayLaw::kCorners, name_of(mesh, t) + " has a vertex twice"};
    }
  }
  return std::nullopt;
}

DelaunayFinding check_positive(const TetrahedralMesh& mesh, Signs& signs) {
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const int sign = signs.orientation(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]],
                                       mesh.points[v[3]]);
    if (sign > 0) continue;
    return DelaunayFailure{DelaunayLaw::kPositive,
                           name_of(mesh, t) + (sign == 0 ? " is flat" : " is negatively oriented")};
  }
  return std::nullopt;
}

DelaunayFinding check_facets(const TetrahedralMesh& mesh, const Facets& facets) {
  if (facets.crowded) {
    return DelaunayFailure{DelaunayLaw::kTwoTetrahedra,
                           "facet " + listed(facet_of(mesh.tetrahedra, *facets.crowded)) +
                               " lies in more than two tetrahedra"};
  }
  if (facets.same_way) {
    return DelaunayFailure{DelaunayLaw::kOppositeSides,
                           "two tetrahedra are on the same side of their facet " +
                               listed(facet_of(mesh.tetrahedra, *facets.same_way))};
  }
  return std::nullopt;
}

DelaunayFinding check_connected(const TetrahedralMesh& mesh, const Facets& facets) {
  DisjointSets components(mesh.tetrahedra.size());
  for (const auto& [a, b] : facets.interior) components.unite(a / 4, b / 4);
  if (components.sets() == 1) return std::nullopt;
  return DelaunayFailure{
      DelaunayLaw::kConnected,
      "the mesh has " + std::to_string(components.sets()) + " components that share no facet"};
}

DelaunayFinding check_unused_points(const TetrahedralMesh& mesh, DelaunayVerdict& verdict) {
  const std::vector<bool> used = used_points(mesh);
  std::vector<std::uint32_t> unused;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) unused.push_back(v);
  }
  verdict.duplicates = unused.size();
  if (unused.empty()) return std::nullopt;

  std::vector<Point> places;
  places.reserve(unused.size());
  for (const std::uint32_t v : unused) places.push_back(mesh.points[v]);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto index_of = [&places](const Point& point) {
    return static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), point) -
                                    places.begin());
  };
  std::vector<bool> taken(places.size(), false);
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    const std::size_t at = index_of(mesh.points[v]);
    if (at < places.size() && places[at] == mesh.points[v]) taken[at] = true;
  }
  for (const std::uint32_t v : unused) {
    if (taken[index_of(mesh.points[v])]) continue;
    return DelaunayFailure{
        DelaunayLaw::kUnusedPoint,
        "point " + std::to_string(v) + " is in no tetrahedron and no vertex has its coordinates"};
  }
  return std::nullopt;
}

int side_of_sphere(const TetrahedralMesh& mesh, Weights weights, const Tetrahedron& cell,
                   std::uint32_t vertex, Signs& signs) {
  const auto& [a, b, c, d] = cell;
  const std::vector<Point>& p = mesh.points;
  if (weights == nullptr) return signs.in_sphere(p[a], p[b], p[c], p[d], p[vertex]);
  const std::vector<double>& w = *weights;
  return signs.in_orthosphere(p[a], p[b], p[c], p[d], p[vertex],
                              {w[a], w[b], w[c], w[d], w[vertex]});
}

DelaunayFinding check_empty_spheres(const TetrahedralMesh& mesh, Weights weights,
                                    const Facets& facets, Signs& signs, DelaunayVerdict& verdict) {
  for (const auto& [a, b] : facets.interior) {
    const std::uint32_t apex = apex_of(mesh.tetrahedra, b);
    const int sign = side_of_sphere(mesh, weights, mesh.tetrahedra[a / 4], apex, signs);
    if (sign == 0) ++verdict.cospherical;
    if (sign <= 0) continue;
    return DelaunayFailure{DelaunayLaw::kEmptySpheres, "point " + std::to_string(apex) +
                                                           " is inside the " +
                                                           (weights == nullptr ? "" : "ortho") +
                                                           "sphere of " + name_of(mesh, a / 4)};
  }
  return std::nullopt;
}

DelaunayFinding check_given_points(const TetrahedralMesh& mesh, const std::vector<Point>& given) {
  if (mesh.points.size() != given.size()) {
    return DelaunayFailure{DelaunayLaw::kGivenPoints,
                           "the mesh has " + std::to_string(mesh.points.size()) +
                               " points, given are " + std::to_string(given.size())};
  }
  const auto differs = std::mismatch(given.begin(), given.end(), mesh.points.begin());
  if (differs.first == given.end()) return std::nullopt;
  return DelaunayFailure{
      DelaunayLaw::kGivenPoints,
      "point " + std::to_string(differs.first - given.begin()) + " is not the given one"};
}

const char* name_of(DelaunayLaw law) {
  constexpr std::array<const char*, 14> kNames = {
      "none",         "corners",          "positive",     "two-tetrahedra", "opposite-sides",
      "connected",    "boundary-surface", "convex-edges", "no-folds",       "covered-once",
      "given-points", "unused-point",     "hidden-point", "empty-spheres"};
  return kNames[static_cast<std::size_t>(law)];
}

DelaunayVerdict check_delaunay(const TetrahedralMesh& mesh, const std::vector<Point>* given) {
  return judged(mesh, given, nullptr);
}

DelaunayVerdict check_regular(const TetrahedralMesh& mesh, const WeightedPoints& given) {
  return judged(mesh, &given.points, &given.weights);
}

}  // namespace hexatlas::check
