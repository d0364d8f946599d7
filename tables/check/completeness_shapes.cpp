#include "tables/check/completeness_shapes.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include "tables/check/disjoint_sets.hpp"
#include "tables/check/shelling.hpp"

namespace hexatlas::check {

namespace {

/// More than twice what any of the 6966 triangulations takes in ascending order.
constexpr std::uint64_t kBallSteps = 15'000;

CubeSet set_of(unsigned bits) noexcept { return static_cast<CubeSet>(bits); }

/// How many of the sets have each facet of a set (the set less one vertex).
std::map<CubeSet, int> facet_counts(std::span<const CubeSet> sets) {
  std::map<CubeSet, int> counts;
  for (const CubeSet set : sets) {
    for (const unsigned v : cube_vertices(set)) ++counts[set_of(set & ~(1U << v))];
  }
  return counts;
}

/// "" if the tetrahedra are different candidates.
std::string fault_of_members(std::span<const CubeSet> tetrahedra) {
  for (const CubeSet tetrahedron : tetrahedra) {
    if (!candidate_index(tetrahedron)) return "a set of vertices is no candidate";
    if (std::count(tetrahedra.begin(), tetrahedra.end(), tetrahedron) != 1) {
      return "a tetrahedron is given twice";
    }
  }
  return {};
}

/// "" if each triangle is in at most two tetrahedra, and those in one cut each facet in two.
std::string fault_of_triangles(std::span<const CubeSet> tetrahedra) {
  std::array<std::vector<CubeSet>, kCubeFacets> boundary;
  for (const auto& [triangle, count] : facet_counts(tetrahedra)) {
    if (count > 2) return "a triangle is in three tetrahedra";
    if (count == 2) continue;
    const std::vector<unsigned> facets = facets_with(triangle);
    if (facets.empty()) return "a triangle in one tetrahedron is on no facet";
    boundary[facets[0]].push_back(triangle);
  }
  for (const std::vector<CubeSet>& triangles : boundary) {
    // Two different triangles of a facet share a diagonal, which is on no other facet, or an edge.
    const bool cut =
        triangles.size() == 2 && facets_with(set_of(triangles[0] & triangles[1])).size() == 1;
    if (!cut) return "a facet is not cut in two by a diagonal";
  }
  return {};
}

/// Number of connected pieces that the edges form, without isolated vertices.
std::size_t pieces(const std::vector<CubeSet>& edges) {
  DisjointSets components(kCubeVertices);
  unsigned used = 0;
  for (const CubeSet edge : edges) {
    const std::vector<unsigned> ends = cube_vertices(edge);
    components.unite(ends[0], ends[1]);
    used |= edge;
  }
  return components.sets() - (kCubeVertices - static_cast<std::size_t>(std::popcount(used)));
}

/// "" if the triangles form a connected surface that is no part of a disc.
std::string fault_of_surface(const std::vector<CubeSet>& triangles) {
  const std::map<CubeSet, int> edges = facet_counts(triangles);
  std::vector<CubeSet> all_edges;
  std::vector<CubeSet> boundary;
  unsigned used = 0;
  for (const auto& [edge, count] : edges) {
    if (count > 2) return "an edge of the link is in three triangles";
    all_edges.push_back(edge);
    if (count == 1) boundary.push_back(edge);
    used |= edge;
  }
  for (const unsigned v : cube_vertices(set_of(used))) {
    std::vector<CubeSet> around;
    for (const CubeSet triangle : triangles) {
      if ((triangle >> v & 1U) != 0) around.push_back(set_of(triangle & ~(1U << v)));
    }
    // Two edges at most at each end: one piece is a path or a circle.
    if (pieces(around) != 1) return "the link is no surface";
  }
  if (pieces(all_edges) != 1) return "the link is not connected";
  const auto circles = static_cast<int>(pieces(boundary));
  const int characteristic =
      std::popcount(used) - static_cast<int>(edges.size()) + static_cast<int>(triangles.size());
  const bool planar = circles > 0 && characteristic == 2 - circles;
  return planar ? "the link may be part of a disc" : std::string();
}

}  // namespace

const std::vector<CubeSymmetry>& cube_symmetries() {
  static const std::vector<CubeSymmetry> all = [] {
    std::vector<CubeSymmetry> found;
    std::array<unsigned, 3> axes = {0, 1, 2};
    do {
      for (unsigned flip = 0; flip < kCubeVertices; ++flip) {
        CubeSymmetry& symmetry = found.emplace_back();
        for (unsigned v = 0; v < kCubeVertices; ++v) {
          unsigned image = flip;
          for (unsigned k = 0; k < axes.size(); ++k) image ^= (v >> k & 1U) << axes[k];
          symmetry[v] = static_cast<std::uint8_t>(image);
        }
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return found;
  }();
  return all;
}

CubeSet image_of(CubeSet set, const CubeSymmetry& symmetry) noexcept {
  unsigned image = 0;
  for (unsigned v = 0; v < kCubeVertices; ++v) {
    if ((set >> v & 1U) != 0) image |= 1U << symmetry[v];
  }
  return set_of(image);
}

std::string fault_of_triangulation(const std::vector<CubeSet>& tetrahedra) {
  if (tetrahedra.size() > kMostTetrahedra) return "more tetrahedra than a triangulation can have";
  if (std::string fault = fault_of_members(tetrahedra); !fault.empty()) return fault;
  if (std::string fault = fault_of_triangles(tetrahedra); !fault.empty()) return fault;
  // Each vertex is on a boundary triangle, hence in a tetrahedron.
  std::vector<CubeSet> ascending = tetrahedra;
  std::sort(ascending.begin(), ascending.end());
  std::uint64_t steps = kBallSteps;
  return find_ball_proof(ascending, steps) ? std::string() : "no proof found that it is a ball";
}

std::string fault_of_obstruction(unsigned vertex, std::span<const CubeSet> tetrahedra) {
  if (vertex >= kCubeVertices || tetrahedra.empty()) return "no vertex or no tetrahedra";
  if (std::string fault = fault_of_members(tetrahedra); !fault.empty()) return fault;
  std::vector<CubeSet> link;
  for (const CubeSet tetrahedron : tetrahedra) {
    if ((tetrahedron >> vertex & 1U) == 0) return "a tetrahedron without the vertex";
    link.push_back(set_of(tetrahedron & ~(1U << vertex)));
  }
  return fault_of_surface(link);
}

}  // namespace hexatlas::check
