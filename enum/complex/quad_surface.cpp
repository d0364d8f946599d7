#include "enum/complex/quad_surface.hpp"

#include <algorithm>
#include <tuple>

#include "enum/complex/union_find.hpp"

namespace hexatlas::complex {
namespace {

struct Side {
  VertexId low = 0, high = 0;
  std::uint32_t quad = 0;
  bool ascending = false;  ///< the quad runs from low to high
};

std::string edge_name(VertexId a, VertexId b) {
  return std::to_string(a) + "-" + std::to_string(b);
}

std::optional<BrokenLaw> quads_law(std::span<const BoundaryQuad> quads) {
  if (quads.empty()) return BrokenLaw{"there is no quad"};
  for (std::size_t q = 0; q < quads.size(); ++q) {
    BoundaryQuad sorted = quads[q];
    std::sort(sorted.begin(), sorted.end());
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    if (repeated != sorted.end())
      return BrokenLaw{"point " + std::to_string(*repeated) + " is repeated in a quad", q};
  }
  return std::nullopt;
}

std::vector<Side> sorted_sides(std::span<const BoundaryQuad> quads) {
  std::vector<Side> sides;
  sides.reserve(4 * quads.size());
  for (std::uint32_t q = 0; q < quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId a = quads[q][i];
      const VertexId b = quads[q][(i + 1) % 4];
      sides.push_back({std::min(a, b), std::max(a, b), q, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.quad) < std::tie(b.low, b.high, b.quad);
  });
  return sides;
}

std::optional<BrokenLaw> edges_law(const std::vector<Side>& sides) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
      ++end;
    if (end - i == 1)
      return BrokenLaw{"edge " + edge_name(sides[i].low, sides[i].high) +
                           " is in one quad only: the surface is open",
                       sides[i].quad};
    if (end - i > 2)
      return BrokenLaw{"edge " + edge_name(sides[i].low, sides[i].high) + " is in " +
                           std::to_string(end - i) + " quads: the surface is not a manifold",
                       sides[i + 2].quad};
    i = end;
  }
  return std::nullopt;
}

/// Two quads around each corner share an edge there; all quads at a vertex must be one round.
std::optional<BrokenLaw> links_law(std::span<const BoundaryQuad> quads,
                                   const std::vector<Side>& sides, std::size_t points) {
  UnionFind corners(4 * quads.size());
  const auto corner = [&](const Side& side, VertexId v) {
    const auto& quad = quads[side.quad];
    return 4 * std::size_t{side.quad} +
           static_cast<std::size_t>(std::find(quad.begin(), quad.end(), v) - quad.begin());
  };
  for (std::size_t i = 0; i < sides.size(); i += 2)
    for (const VertexId v : {sides[i].low, sides[i].high})
      corners.unite(corner(sides[i], v), corner(sides[i + 1], v));
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> round(points, kNone);
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t root = corners.find(4 * q + i);
      std::size_t& known = round[quads[q][i]];
      if (known != kNone && known != root)
        return BrokenLaw{"the quads at point " + std::to_string(quads[q][i]) +
                             " form several fans: the surface is not a manifold there",
                         q};
      known = root;
    }
  return std::nullopt;
}

/// Nodes 2q and 2q + 1 stand for quad q as given and reversed.
std::optional<BrokenLaw> orient(std::vector<BoundaryQuad>& quads, const std::vector<Side>& sides,
                                std::size_t& reversed) {
  UnionFind sheets(quads.size());
  UnionFind oriented(2 * quads.size());
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const std::size_t a = sides[i].quad;
    const std::size_t b = sides[i + 1].quad;
    sheets.unite(a, b);
    const std::size_t differ = sides[i].ascending == sides[i + 1].ascending ? 1 : 0;
    oriented.unite(2 * a, 2 * b + differ);
    oriented.unite(2 * a + 1, 2 * b + 1 - differ);
  }
  if (sheets.count() != 1)
    return BrokenLaw{"the surface has " + std::to_string(sheets.count()) + " components"};
  if (oriented.count() != 2) return BrokenLaw{"the surface cannot be oriented"};
  const auto agrees = [&](std::size_t q) { return oriented.find(2 * q) == oriented.find(0); };
  std::size_t with_first = 0;
  for (std::size_t q = 0; q < quads.size(); ++q) with_first += agrees(q) ? 1 : 0;
  const bool first_wins = 2 * with_first >= quads.size();
  reversed = first_wins ? quads.size() - with_first : with_first;
  for (std::size_t q = 0; q < quads.size(); ++q)
    if (agrees(q) != first_wins) std::swap(quads[q][1], quads[q][3]);
  return std::nullopt;
}

}  // namespace

std::variant<QuadSphere, BrokenLaw> sphere_of(std::span<const BoundaryQuad> quads,
                                              std::size_t points) {
  if (auto law = quads_law(quads)) return *law;
  const std::vector<Side> sides = sorted_sides(quads);
  if (auto law = edges_law(sides)) return *law;
  if (auto law = links_law(quads, sides, points)) return *law;
  QuadSphere sphere;
  sphere.quads.assign(quads.begin(), quads.end());
  if (auto law = orient(sphere.quads, sides, sphere.reversed)) return *law;

  constexpr VertexId kUnused = 0xFFFFFFFF;
  std::vector<VertexId> vertex(points, kUnused);
  for (const auto& quad : quads)
    for (const VertexId p : quad) vertex[p] = 0;
  for (VertexId p = 0; p < points; ++p)
    if (vertex[p] != kUnused) {
      vertex[p] = static_cast<VertexId>(sphere.point_of.size());
      sphere.point_of.push_back(p);
    }
  sphere.unused_points = points - sphere.vertices();
  const auto euler = static_cast<std::ptrdiff_t>(sphere.vertices()) -
                     static_cast<std::ptrdiff_t>(quads.size());  // V - E + F, E = 2F
  if (euler != 2)
    return BrokenLaw{"the surface has genus " + std::to_string((2 - euler) / 2) +
                     ", a ball is bounded by a sphere (genus 0)"};
  for (auto& quad : sphere.quads)
    for (VertexId& p : quad) p = vertex[p];
  return sphere;
}

std::optional<std::string> reason_against_filling(const QuadSphere& sphere) {
  const std::size_t n = sphere.quads.size();
  if (n % 2 != 0)
    return "the boundary has " + std::to_string(n) +
           " quads, an odd number, and every hexahedral mesh has an even one";
  if (n < 6) return "the boundary has " + std::to_string(n) + " quads, fewer than a hexahedron";
  // No two edges join the same points, since each edge lies in two quads; so a boundary that is not
  // 3-connected has two vertices that are opposite in two quads.
  std::vector<std::array<VertexId, 2>> diagonals;
  for (const auto& quad : sphere.quads)
    for (std::size_t i = 0; i < 2; ++i)
      diagonals.push_back({std::min(quad[i], quad[i + 2]), std::max(quad[i], quad[i + 2])});
  std::sort(diagonals.begin(), diagonals.end());
  if (const auto twice = std::adjacent_find(diagonals.begin(), diagonals.end());
      twice != diagonals.end())
    return "the boundary is not 3-connected: points " +
           edge_name(sphere.point_of[(*twice)[0]], sphere.point_of[(*twice)[1]]) +
           " are opposite in two quads, which hexahedra that meet in one vertex, edge or quad "
           "cannot have (points counted from 0)";
  return std::nullopt;
}

}  // namespace hexatlas::complex
