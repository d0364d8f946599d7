// The laws that make the tetrahedra cover the convex hull exactly once.
#include <algorithm>
#include <limits>

#include "tables/check/delaunay_laws.hpp"
#include "tables/check/incidence.hpp"

namespace hexatlas::check {

namespace {

struct Box {
  Point low;
  Point high;
};

Box box_of(const TetrahedralMesh& mesh, const Tetrahedron& cell) {
  Box box{mesh.points[cell[0]], mesh.points[cell[0]]};
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = mesh.points[cell[i]][axis];
      box.low[axis] = std::min(box.low[axis], value);
      box.high[axis] = std::max(box.high[axis], value);
    }
  }
  return box;
}

/// No point strictly inside `a` is in `b`.
bool are_apart(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (b.high[axis] <= a.low[axis] || a.high[axis] <= b.low[axis]) return true;
  }
  return false;
}

std::array<Point, 4> corners_of(const TetrahedralMesh& mesh, const Tetrahedron& cell) {
  return {mesh.points[cell[0]], mesh.points[cell[1]], mesh.points[cell[2]], mesh.points[cell[3]]};
}

/// The signs of the corners with respect to a facet, taken from outside: positive is visible.
struct Sides {
  bool inside = false;   ///< a corner is strictly inside
  bool outside = false;  ///< a corner is strictly outside
};

Sides sides_of(const TetrahedralMesh& mesh, const Triangle& facet,
               const std::array<Point, 4>& corners, Signs& signs) {
  Sides sides;
  for (const Point& corner : corners) {
    const int sign = signs.orientation(mesh.points[facet[0]], mesh.points[facet[1]],
                                       mesh.points[facet[2]], corner);
    sides.inside = sides.inside || sign < 0;
    sides.outside = sides.outside || sign > 0;
  }
  return sides;
}

/// Whether the centroid of the tetrahedron with these corners is strictly outside of `cell`. Mostly
/// a facet of the cell separates the two; only facets with corners on both sides need the centroid.
bool is_outside(const TetrahedralMesh& mesh, std::uint32_t cell,
                const std::array<Point, 4>& corners, Signs& signs) {
  std::array<bool, 4> divides{};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Sides sides = sides_of(mesh, facet_of(mesh.tetrahedra, 4 * cell + i), corners, signs);
    if (sides.outside && !sides.inside) return true;
    divides[i] = sides.outside;
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Triangle facet = facet_of(mesh.tetrahedra, 4 * cell + i);
    if (divides[i] && signs.orientation_of_centroid(mesh.points[facet[0]], mesh.points[facet[1]],
                                                    mesh.points[facet[2]], corners) > 0) {
      return true;
    }
  }
  return false;
}

}  // namespace

DelaunayFinding check_boundary_surface(const TetrahedralMesh& mesh, const Facets& facets,
                                       std::vector<HullEdge>& edges, DelaunayVerdict& verdict) {
  struct Side {
    std::array<std::uint32_t, 2> edge;
    FacetNumber facet;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(3 * facets.boundary.size());
  std::vector<bool> on_boundary(mesh.points.size(), false);
  for (const FacetNumber f : facets.boundary) {
    const Triangle corners = facet_of(mesh.tetrahedra, f);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      sides.push_back({{low, high}, f});
      on_boundary[corners[i]] = true;
    }
  }
  std::sort(sides.begin(), sides.end());
  edges.reserve(sides.size() / 2);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].edge == sides[i].edge) ++end;
    if (end - i != 2) {
      return DelaunayFailure{DelaunayLaw::kBoundarySurface,
                             "edge " + listed(sides[i].edge) + " lies in " +
                                 std::to_string(end - i) + " boundary facets"};
    }
    edges.push_back({sides[i].facet, sides[i + 1].facet});
  }
  verdict.boundary_facets = facets.boundary.size();
  verdict.boundary_vertices =
      static_cast<std::uint64_t>(std::count(on_boundary.begin(), on_boundary.end(), true));
  const auto euler = static_cast<std::int64_t>(verdict.boundary_vertices + facets.boundary.size()) -
                     static_cast<std::int64_t>(edges.size());
  if (euler == 2) return std::nullopt;
  return DelaunayFailure{DelaunayLaw::kBoundarySurface,
                         "the boundary has Euler characteristic " + std::to_string(euler)};
}

DelaunayFinding check_convex_edges(const TetrahedralMesh& mesh, const std::vector<HullEdge>& edges,
                                   Signs& signs) {
  for (const HullEdge& edge : edges) {
    const Triangle facet = facet_of(mesh.tetrahedra, edge.facet);
    const Triangle other = facet_of(mesh.tetrahedra, edge.neighbour);
    const auto* const apex = std::find_if(other.begin(), other.end(), [&](std::uint32_t vertex) {
      return std::find(facet.begin(), facet.end(), vertex) == facet.end();
    });
    // Two boundary facets with the same vertices would be one interior facet.
    if (signs.orientation(mesh.points[facet[0]], mesh.points[facet[1]], mesh.points[facet[2]],
                          mesh.points[*apex]) > 0) {
      return DelaunayFailure{DelaunayLaw::kConvexEdges,
                             "vertex " + std::to_string(*apex) + " of boundary facet " +
                                 listed(other) + " is outside its neighbour " + listed(facet)};
    }
  }
  return std::nullopt;
}

std::uint32_t base_tetrahedron(const TetrahedralMesh& mesh) {
  std::uint32_t base = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Box box = box_of(mesh, mesh.tetrahedra[t]);
    const double size =
        box.high[0] - box.low[0] + (box.high[1] - box.low[1]) + (box.high[2] - box.low[2]);
    if (size >= least) continue;
    least = size;
    base = t;
  }
  return base;
}

DelaunayFinding check_no_folds(const TetrahedralMesh& mesh, const Facets& facets,
                               std::uint32_t base, Signs& signs) {
  const std::array<Point, 4> corners = corners_of(mesh, mesh.tetrahedra[base]);
  for (const FacetNumber f : facets.boundary) {
    // If no corner is outside one is inside, since the four are not in one plane.
    const Triangle facet = facet_of(mesh.tetrahedra, f);
    if (!sides_of(mesh, facet, corners, signs).outside) continue;
    return DelaunayFailure{DelaunayLaw::kNoFolds,
                           "boundary facet " + listed(facet) + " is visible from tetrahedron " +
                               std::to_string(base) + " " + listed(mesh.tetrahedra[base])};
  }
  return std::nullopt;
}

DelaunayFinding check_covered_once(const TetrahedralMesh& mesh, std::uint32_t base, Signs& signs) {
  const std::array<Point, 4> corners = corners_of(mesh, mesh.tetrahedra[base]);
  const Box box = box_of(mesh, mesh.tetrahedra[base]);
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (t == base || are_apart(box, box_of(mesh, mesh.tetrahedra[t])) ||
        is_outside(mesh, t, corners, signs)) {
      continue;
    }
    return DelaunayFailure{DelaunayLaw::kCoveredOnce,
                           "the centroid of tetrahedron " + std::to_string(base) + " " +
                               listed(mesh.tetrahedra[base]) + " lies in tetrahedron " +
                               std::to_string(t) + " " + listed(mesh.tetrahedra[t])};
  }
  return std::nullopt;
}

}  // namespace hexatlas::check
