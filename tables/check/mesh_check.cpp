#include "tables/check/mesh_check.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <utility>

#include "tables/check/incidence.hpp"
#include "tables/check/jacobian.hpp"
#include "tables/check/judge_cells.hpp"

namespace hexatlas::check {

namespace {

std::vector<Quad> all_reversed(std::vector<Quad> quads) {
  for (Quad& quad : quads) quad = reversed(quad);
  return quads;
}

/// Each cycle in the direction in which the second vertex is less than the last one.
std::vector<Quad> unoriented(std::vector<Quad> quads) {
  for (Quad& quad : quads) {
    quad = least_first(quad);
    if (quad[1] > quad[3]) quad = reversed(quad);
  }
  return quads;
}

std::vector<Quad> sorted_sets(std::vector<Quad> quads) {
  for (Quad& quad : quads) std::sort(quad.begin(), quad.end());
  std::sort(quads.begin(), quads.end());
  return quads;
}

/// No edge is traversed twice in one direction.
bool is_coherent(const std::vector<Quad>& quads) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> traversed;
  for (const Quad& quad : quads) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!traversed.emplace(quad[i], quad[(i + 1) % 4]).second) return false;
    }
  }
  return true;
}

Finding check_surface_points(const Mesh& mesh, const Surface& surface) {
  if (mesh.points.size() < surface.points.size()) {
    return Failure{Law::kSurfacePoints, "the mesh has fewer points than the surface"};
  }
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    // Bit for bit: -0.0 is not 0.0.
    using Bits = std::array<std::uint64_t, 3>;
    if (std::bit_cast<Bits>(mesh.points[v]) != std::bit_cast<Bits>(surface.points[v])) {
      return Failure{Law::kSurfacePoints,
                     "point " + std::to_string(v) + " is not that of the surface"};
    }
  }
  return std::nullopt;
}

Finding check_surface_quads(const std::vector<Quad>& boundary, const Surface& surface,
                            Verdict& verdict) {
  std::vector<Quad> mine = sorted_cycles(boundary);
  std::vector<Quad> given = sorted_cycles(surface.quads);
  if (!is_coherent(surface.quads)) {
    verdict.boundary_unoriented = true;
    mine = sorted_cycles(unoriented(boundary));
    given = sorted_cycles(unoriented(surface.quads));
  }
  if (mine == given) return std::nullopt;
  if (!verdict.boundary_unoriented && sorted_cycles(all_reversed(boundary)) == given) {
    verdict.boundary_reversed = true;
    return std::nullopt;
  }
  return Failure{Law::kSurfaceQuads,
                 "of the quads of the surface and those of the mesh: " + difference(mine, given)};
}

/// Files list what has a name or a condition: parts of the boundary, interfaces.
Finding check_listed_quads(const Mesh& mesh) {
  if (mesh.quads.empty()) return std::nullopt;
  std::vector<Quad> all;
  all.reserve(kQuadCorners.size() * mesh.hexahedra.size());
  for (const Hexahedron& cell : mesh.hexahedra) {
    for (const auto& at : kQuadCorners) {
      all.push_back({cell[at[0]], cell[at[1]], cell[at[2]], cell[at[3]]});
    }
  }
  all = sorted_sets(std::move(all));
  for (const Quad& quad : sorted_sets(mesh.quads)) {
    if (std::binary_search(all.begin(), all.end(), quad)) continue;
    return Failure{Law::kListedQuads, "quad " + listed(quad) +
                                          " (as a set of vertices), which is listed with the "
                                          "mesh, is that of no hexahedron"};
  }
  return std::nullopt;
}

/// The points of the surface in no quad of it.
std::vector<bool> points_that_may_be_unused(const Mesh& mesh, const Surface* surface) {
  std::vector<bool> may(mesh.points.size(), false);
  if (surface == nullptr) return may;
  const std::size_t count = std::min(may.size(), surface->points.size());
  std::fill_n(may.begin(), count, true);
  for (const Quad& quad : surface->quads) {
    for (const std::uint32_t vertex : quad) {
      if (vertex < may.size()) may[vertex] = false;
    }
  }
  return may;
}

Finding check_boundary(const Mesh& mesh, const Surface* surface, const std::vector<Quad>& boundary,
                       Verdict& verdict) {
  if (Finding found = check_listed_quads(mesh)) return found;
  if (surface == nullptr) return std::nullopt;
  if (Finding found = check_surface_points(mesh, *surface)) return found;
  return check_surface_quads(boundary, *surface, verdict);
}

}  // namespace

Verdict check_mesh(const Mesh& mesh, const Surface* boundary) {
  std::vector<Quad> quads;
  Verdict verdict = judge_cells(mesh.hexahedra, mesh.points.size(),
                                points_that_may_be_unused(mesh, boundary), {}, quads);
  if (!verdict.accepted) return verdict;
  if (const Finding found = check_boundary(mesh, boundary, quads, verdict)) {
    verdict.accepted = false;
    verdict.broken = found->law;
    verdict.reason = found->reason;
  }
  return verdict;
}

ValidInSpace valid_in_space(const Mesh& mesh) {
  ValidInSpace counts;
  for (const Hexahedron& cell : mesh.hexahedra) {
    std::array<Point, 8> corners{};
    for (std::size_t i = 0; i < 8; ++i) corners[kCornerBits[i]] = mesh.points[cell[i]];
    const JacobianSign sign = jacobian_sign(corners);
    counts.valid += sign == JacobianSign::kPositive ? 1U : 0U;
    counts.undecided += sign == JacobianSign::kUnknown ? 1U : 0U;
  }
  return counts;
}

}  // namespace hexatlas::check
