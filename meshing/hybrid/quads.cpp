#include "meshing/hybrid/quads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "enum/complex/union_find.hpp"
#include "enum/core/checks.hpp"
#include "meshing/quality/edge.hpp"
#include "meshing/quality/vector.hpp"

namespace hexatlas::hybrid {
namespace {

using mesh::Index;

/// An edge from v to w of a triangle whose third vertex is `apex`.
struct DirectedEdge {
  Index v = 0, w = 0, apex = 0;
  std::uint32_t triangle = 0;
  [[nodiscard]] auto key() const { return std::tuple(std::min(v, w), std::max(v, w), triangle); }
};

std::vector<DirectedEdge> edges_of(const mesh::FacetMesh& surface) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * surface.facets.size());
  for (std::size_t t = 0; t < surface.facets.size(); ++t) {
    const mesh::Facet& facet = surface.facets[t];
    core::expects(facet.size == 3, "triangles only");
    for (std::size_t i = 0; i < 3; ++i) {
      core::expects(facet.vertices[i] < surface.points.size(), "indices below points.size()");
      edges.push_back({facet.vertices[i], facet.vertices[(i + 1) % 3], facet.vertices[(i + 2) % 3],
                       static_cast<std::uint32_t>(t)});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const DirectedEdge& a, const DirectedEdge& b) { return a.key() < b.key(); });
  return edges;
}

/// `visit` gets the sides of each edge, one for each triangle at it.
template <class Visit>
void for_each_edge(const mesh::FacetMesh& surface, const Visit& visit) {
  const std::vector<DirectedEdge> edges = edges_of(surface);
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    const auto is_same = [&](const DirectedEdge& e) {
      return std::minmax(e.v, e.w) == std::minmax(edges[first].v, edges[first].w);
    };
    while (end < edges.size() && is_same(edges[end])) ++end;
    visit(std::span(edges).subspan(first, end - first));
  }
}

double quality_of(const std::vector<mesh::Point>& points, const std::array<Index, 4>& quad) {
  const auto edge = [&](std::size_t from, std::size_t to) {
    return quality::direction(points[quad[from % 4]], points[quad[to % 4]]);
  };
  const mesh::Point normal = quality::direction({}, quality::cross(edge(0, 2), edge(1, 3)));
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i)
    least = std::min(least, quality::determinant(edge(i, i + 1), edge(i, i + 3), normal));
  return least;
}

/// The angle between two triangles at their common edge from v to w, 0 if they lie in one plane.
double fold_of(const std::vector<mesh::Point>& points, const DirectedEdge& e,
               const DirectedEdge& f) {
  const auto normal = [&](const DirectedEdge& side) {
    const mesh::Point& v = points[side.v];
    return quality::direction({}, quality::cross(quality::direction(v, points[side.w]),
                                                 quality::direction(v, points[side.apex])));
  };
  const mesh::Point a = normal(e);
  const mesh::Point b = normal(f);
  if (a == mesh::Point{} || b == mesh::Point{}) return 0;
  constexpr double kDegrees = 180 / std::numbers::pi;
  const mesh::Point across = quality::cross(a, b);
  return kDegrees * std::atan2(std::sqrt(quality::dot(across, across)), quality::dot(a, b));
}

/// The fans of a surface: the triangles at a vertex that are joined by edges of two triangles. A
/// vertex has several if the surface is pinched there.
class Fans {
 public:
  explicit Fans(const mesh::FacetMesh& surface)
      : surface_(surface), corners_(3 * surface.facets.size()) {
    constexpr std::int64_t kFewest = 3;
    constexpr std::int64_t kPlenty = std::numeric_limits<std::int64_t>::max() / 2;
    rooms_.assign(3 * surface.facets.size(), -kFewest);
    std::vector<std::size_t> open;
    for_each_edge(surface, [&](std::span<const DirectedEdge> sides) {
      for (const Index v : {sides[0].v, sides[0].w}) {
        if (sides.size() == 2)
          corners_.unite(corner(sides[0].triangle, v), corner(sides[1].triangle, v));
        else
          for (const DirectedEdge& side : sides) open.push_back(corner(side.triangle, v));
      }
    });
    for (std::size_t c = 0; c < rooms_.size(); ++c) ++rooms_[corners_.find(c)];
    for (const std::size_t c : open) rooms_[corners_.find(c)] = kPlenty;
  }

  /// The fan of a triangle at one of its vertices.
  [[nodiscard]] std::size_t of(std::uint32_t triangle, Index v) {
    return corners_.find(corner(triangle, v));
  }
  /// How many of its edges each fan can lose so that three facets are left to it; those of one that
  /// is not closed are not counted.
  [[nodiscard]] const std::vector<std::int64_t>& rooms() const { return rooms_; }

 private:
  [[nodiscard]] std::size_t corner(std::uint32_t triangle, Index v) const {
    const auto& vertices = surface_.facets[triangle].vertices;
    return 3 * std::size_t{triangle} + (vertices[0] == v ? 0U : vertices[1] == v ? 1U : 2U);
  }

  const mesh::FacetMesh& surface_;
  complex::UnionFind corners_;
  std::vector<std::int64_t> rooms_;
};

/// A matching of triangles, improved by paths and squares, in which no fan loses more edges than it
/// has room for.
class Matching {
 public:
  Matching(const mesh::FacetMesh& surface, std::span<const QuadCandidate> candidates)
      : candidates_(candidates),
        start_(surface.facets.size() + 1),
        quad_of_(surface.facets.size(), kNone),
        fans_(candidates.size()) {
    Fans fans(surface);
    rooms_ = fans.rooms();
    for (std::size_t i = 0; i < candidates.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        fans_[i][k] = fans.of(candidates[i].triangles[0], candidates[i].diagonal[k]);
    for (const QuadCandidate& c : candidates)
      for (const std::uint32_t t : c.triangles) ++start_[t + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    at_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      for (const std::uint32_t t : candidates[i].triangles) at_[next[t]++] = i;
  }

  void greedy() {
    std::vector<std::size_t> order(candidates_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return candidates_[a].quality > candidates_[b].quality;
    });
    for (const std::size_t i : order)
      if (is_free(candidates_[i].triangles[0]) && is_free(candidates_[i].triangles[1]))
        (void)exchange({}, {&i, 1});
  }

  void improve() {
    constexpr int kMostRounds = 50;
    bool is_better = true;
    for (int round = 0; is_better && round < kMostRounds; ++round) {
      is_better = false;
      for (std::uint32_t t = 0; t < quad_of_.size(); ++t)
        is_better = (is_free(t) ? lengthen(t) : turn_square(quad_of_[t])) || is_better;
    }
  }

  [[nodiscard]] std::vector<std::size_t> chosen() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (quad_of_[candidates_[i].triangles[0]] == i) result.push_back(i);
    return result;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kMostVisited = 200;  ///< quads on the way from a free triangle

  [[nodiscard]] bool is_free(std::uint32_t t) const { return quad_of_[t] == kNone; }
  [[nodiscard]] std::span<const std::size_t> at(std::uint32_t t) const {
    return std::span(at_).subspan(start_[t], start_[t + 1] - start_[t]);
  }
  [[nodiscard]] std::uint32_t other(std::size_t quad, std::uint32_t t) const {
    const auto& [one, two] = candidates_[quad].triangles;
    return one == t ? two : one;
  }
  void put(std::size_t quad) {
    for (const std::uint32_t t : candidates_[quad].triangles) quad_of_[t] = quad;
    for (const std::size_t fan : fans_[quad]) --rooms_[fan];
  }
  void take(std::size_t quad) {
    for (const std::uint32_t t : candidates_[quad].triangles) quad_of_[t] = kNone;
    for (const std::size_t fan : fans_[quad]) ++rooms_[fan];
  }
  [[nodiscard]] bool has_room(std::size_t quad) const {
    const auto& [one, other] = fans_[quad];
    return rooms_[one] >= 0 && rooms_[other] >= 0;
  }

  /// Chosen quads for others on their triangles and free ones, unless a vertex has no room for
  /// these.
  bool exchange(std::span<const std::size_t> out, std::span<const std::size_t> in) {
    for (const std::size_t quad : out) take(quad);
    for (const std::size_t quad : in) put(quad);
    if (std::all_of(in.begin(), in.end(), [this](std::size_t quad) { return has_room(quad); }))
      return true;
    for (const std::size_t quad : in) take(quad);
    for (const std::size_t quad : out) put(quad);
    return false;
  }

  /// A path from a free triangle to another, of candidates that are chosen and not by turns:
  /// exchanged, there is one more quad. Breadth first; each chosen quad is entered once.
  bool lengthen(std::uint32_t free) {
    struct Step {
      std::uint32_t triangle;  ///< where a further candidate may begin
      std::size_t before;      ///< the step before
      std::size_t by, out;     ///< the candidate taken there, and the chosen quad it displaces
    };
    std::vector<Step> steps{{free, kNone, kNone, kNone}};
    for (std::size_t i = 0; i < steps.size() && steps.size() < kMostVisited; ++i)
      for (const std::size_t quad : at(steps[i].triangle)) {
        const std::uint32_t next = other(quad, steps[i].triangle);
        if (next == free || quad == steps[i].out) continue;
        const std::size_t out = quad_of_[next];
        if (out != kNone) {
          const bool is_seen =
              std::any_of(steps.begin(), steps.end(), [&](const Step& s) { return s.out == out; });
          if (!is_seen) steps.push_back({other(out, next), i, quad, out});
          continue;
        }
        std::vector<std::size_t> outs;
        std::vector<std::size_t> ins{quad};
        for (std::size_t s = i; s != 0; s = steps[s].before) {
          outs.push_back(steps[s].out);
          ins.push_back(steps[s].by);
        }
        if (exchange(outs, ins)) return true;
      }
    return false;
  }

  /// Two chosen quads whose triangles also form two others: the better two.
  bool turn_square(std::size_t quad) {
    const auto& [one, two] = candidates_[quad].triangles;
    for (const std::size_t left : at(one)) {
      const std::uint32_t far = other(left, one);
      const std::size_t opposite = quad_of_[far];
      if (left == quad || opposite == kNone || opposite == quad) continue;
      const std::uint32_t further = other(opposite, far);
      for (const std::size_t right : at(two)) {
        if (other(right, two) != further) continue;
        const double gain = candidates_[left].quality + candidates_[right].quality -
                            candidates_[quad].quality - candidates_[opposite].quality;
        if (!(gain > kLeastGain)) continue;
        if (exchange(std::array{quad, opposite}, std::array{left, right})) return true;
      }
    }
    return false;
  }

  static constexpr double kLeastGain = 1e-12;  ///< smaller ones may be rounding

  std::span<const QuadCandidate> candidates_;
  std::vector<std::size_t> start_;
  std::vector<std::size_t> at_;
  std::vector<std::size_t> quad_of_;
  std::vector<std::array<std::size_t, 2>> fans_;  ///< at the ends of the diagonal of each candidate
  std::vector<std::int64_t> rooms_;
};

}  // namespace

std::vector<QuadCandidate> quad_candidates(const mesh::FacetMesh& surface,
                                           const QuadLimits& limits) {
  core::expects(limits.quality >= 0 && limits.quality < 1, "a quality in [0, 1)");
  core::expects(limits.fold >= 0 && limits.fold <= 180, "a fold from 0 to 180 degrees");
  constexpr double kAllowance = 1e-9;  // of normals of triangles in one plane, in degrees, and more
  std::vector<QuadCandidate> result;
  for_each_edge(surface, [&](std::span<const DirectedEdge> sides) {
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        const DirectedEdge& e = sides[i];
        const DirectedEdge& f = sides[j];
        if (e.v != f.w || e.apex == f.apex || e.triangle == f.triangle) continue;
        if (surface.facets[e.triangle].colour != surface.facets[f.triangle].colour) continue;
        QuadCandidate quad{{e.v, f.apex, e.w, e.apex}, {e.v, e.w}, {e.triangle, f.triangle}, 0};
        quad.quality = quality_of(surface.points, quad.vertices);
        if (!(quad.quality > limits.quality) ||
            fold_of(surface.points, e, f) > limits.fold + kAllowance)
          continue;
        std::rotate(quad.vertices.begin(),
                    std::min_element(quad.vertices.begin(), quad.vertices.end()),
                    quad.vertices.end());
        result.push_back(quad);
      }
  });
  std::sort(result.begin(), result.end(), [](const QuadCandidate& a, const QuadCandidate& b) {
    return std::tie(a.vertices, a.triangles) < std::tie(b.vertices, b.triangles);
  });
  return result;
}

std::size_t incoherent_edges(const mesh::FacetMesh& surface) {
  std::size_t count = 0;
  for_each_edge(surface, [&](std::span<const DirectedEdge> sides) {
    if (sides.size() == 2 && sides[0].v == sides[1].v) ++count;
  });
  return count;
}

std::vector<std::size_t> quad_selection(const mesh::FacetMesh& surface,
                                        std::span<const QuadCandidate> candidates) {
  Matching matching(surface, candidates);
  matching.greedy();
  matching.improve();
  return matching.chosen();
}

mesh::FacetMesh with_quads(const mesh::FacetMesh& surface,
                           std::span<const QuadCandidate> candidates,
                           std::span<const std::size_t> chosen) {
  std::vector<std::uint8_t> is_used(surface.facets.size(), 0);
  for (const std::size_t i : chosen)
    for (const std::uint32_t t : candidates[i].triangles) is_used[t] = 1;
  mesh::FacetMesh result{surface.points, {}};
  for (std::size_t t = 0; t < surface.facets.size(); ++t)
    if (is_used[t] == 0) result.facets.push_back(surface.facets[t]);
  for (const std::size_t i : chosen)
    result.facets.push_back(
        {candidates[i].vertices, 4, 0, surface.facets[candidates[i].triangles[0]].colour});
  return result;
}

}  // namespace hexatlas::hybrid
