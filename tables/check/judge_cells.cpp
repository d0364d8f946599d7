#include "tables/check/judge_cells.hpp"

#include <algorithm>

#include "tables/check/ball.hpp"
#include "tables/check/laws.hpp"

namespace hexatlas::check {

namespace {

constexpr std::uint64_t kMostVertices = std::uint64_t{1} << 31;

Finding check_used(const Incidence& incidence, const std::vector<bool>& may_be_unused) {
  for (std::size_t v = 0; v < incidence.vertex_count; ++v) {
    if (!incidence.cells_at[v].empty() || (!may_be_unused.empty() && may_be_unused[v])) continue;
    return Failure{Law::kUnusedPoint, "point " + std::to_string(v) + " is in no hexahedron"};
  }
  return std::nullopt;
}

enum class BallProof : std::uint8_t { none, collapse, shelling };

/// A mesh may be listed such that it can be taken off in this order down to a small rest, for which
/// a proof is found sooner. The rest may be no manifold; then less may have to be taken off. Of
/// rests that obey all laws, and for which there is none, no more are tried: the whole is still to
/// come.
BallProof proof_by_rest(const Incidence& incidence) {
  constexpr std::uint32_t kPutBack = 64;
  constexpr int kRests = 2;
  const std::uint32_t listed = listed_removals(incidence);
  int rests = 0;
  for (std::uint32_t back = 0; back < std::min(listed, kPutBack); ++back) {
    const auto cells = incidence.cells.subspan(listed - back);
    const Incidence rest = incidence_of(cells, incidence.vertex_count);
    if (check_connected(rest) || check_links(rest) || check_boundary_sphere(rest)) continue;
    if (find_shelling(rest)) return BallProof::shelling;
    if (find_collapse(rest)) return BallProof::collapse;
    if (++rests == kRests) break;
  }
  return BallProof::none;
}

/// "shelling", "collapse", or empty if neither was found.
std::string ball_proof(const Incidence& incidence) {
  const BallProof by_rest = proof_by_rest(incidence);
  if (by_rest == BallProof::shelling || find_shelling(incidence)) return "shelling";
  return by_rest == BallProof::collapse || find_collapse(incidence) ? "collapse" : "";
}

Finding check_ball(const Incidence& incidence, std::span<const std::uint32_t> removal_order,
                   Verdict& verdict) {
  if (!removal_order.empty()) {
    if (!is_removal_order(incidence, removal_order)) {
      return Failure{Law::kBall, "the stated order of the hexahedra is no shelling"};
    }
    verdict.ball_proof = "shelling";
  } else {
    verdict.ball_proof = ball_proof(incidence);
    verdict.undecided = verdict.ball_proof.empty();
    if (verdict.undecided) {
      return Failure{Law::kBall, "not shown to be a ball: no shelling and no collapse found"};
    }
  }
  verdict.is_ball = true;
  return std::nullopt;
}

void count_faces(const Incidence& incidence, Verdict& verdict) {
  verdict.edges = incidence.edges.size();
  verdict.quads = incidence.facets.size();
  for (std::size_t v = 0; v < incidence.vertex_count; ++v) {
    if (incidence.cells_at[v].empty()) continue;
    ++verdict.vertices;
    if (!incidence.on_boundary[v]) ++verdict.interior_vertices;
  }
  for (const Facet& facet : incidence.facets) {
    if (facet.uses == 1) ++verdict.boundary_quads;
  }
}

Finding first_broken(const Incidence& incidence, const std::vector<bool>& may_be_unused,
                     std::span<const std::uint32_t> removal_order, Verdict& verdict) {
  if (Finding found = check_used(incidence, may_be_unused)) return found;
  for (const auto& check : {check_two_hexahedra, check_strict_rule, check_orientation,
                            check_connected, check_links, check_boundary_sphere}) {
    if (Finding found = check(incidence)) return found;
  }
  return check_ball(incidence, removal_order, verdict);
}

}  // namespace

Verdict judge_cells(std::span<const Hexahedron> cells, std::uint64_t vertex_count,
                    const std::vector<bool>& may_be_unused,
                    std::span<const std::uint32_t> removal_order, std::vector<Quad>& boundary) {
  Verdict verdict;
  verdict.hexahedra = cells.size();
  Finding found = check_corners(cells, vertex_count);
  if (!found && vertex_count > kMostVertices) {
    found = Failure{Law::kUnusedPoint, "there are more points than can be used"};
  }
  if (!found) {
    const Incidence incidence = incidence_of(cells, static_cast<std::uint32_t>(vertex_count));
    count_faces(incidence, verdict);
    found = first_broken(incidence, may_be_unused, removal_order, verdict);
    if (!found) boundary = boundary_quads(incidence);
  }
  verdict.accepted = !found;
  if (found) {
    verdict.broken = found->law;
    verdict.reason = found->reason;
  }
  return verdict;
}

Quad least_first(const Quad& quad) {
  Quad result = quad;
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

std::vector<Quad> sorted_cycles(std::vector<Quad> quads) {
  for (Quad& quad : quads) quad = least_first(quad);
  std::sort(quads.begin(), quads.end());
  return quads;
}

Quad reversed(const Quad& quad) { return {quad[0], quad[3], quad[2], quad[1]}; }

std::string difference(const std::vector<Quad>& mesh, const std::vector<Quad>& surface) {
  const auto [in_mesh, in_surface] =
      std::mismatch(mesh.begin(), mesh.end(), surface.begin(), surface.end());
  const bool surface_first =
      in_mesh == mesh.end() || (in_surface != surface.end() && *in_surface < *in_mesh);
  return surface_first ? "quad " + listed(*in_surface) + " is not a boundary quad of the mesh"
                       : "boundary quad " + listed(*in_mesh) + " of the mesh is not among them";
}

}  // namespace hexatlas::check
