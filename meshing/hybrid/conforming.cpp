#include "meshing/hybrid/conforming.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "enum/core/checks.hpp"
#include "meshing/hybrid/changing_tets.hpp"
#include "meshing/hybrid/occupancy.hpp"
#include "meshing/quality/cells.hpp"
#include "meshing/quality/edge.hpp"
#include "meshing/quality/report.hpp"
#include "meshing/quality/vector.hpp"

namespace hexatlas::hybrid {
namespace {

using Quad = std::array<Index, 4>;

/// One attempt, with the cells that are left.
class Attempt {
 public:
  Attempt(const TetGraph& graph, const Candidates& candidates, std::span<const Cell> cells)
      : candidates_(candidates),
        cells_(cells),
        tets_(graph),
        points_(graph.points().begin(), graph.points().end()),
        given_points_(points_.size()),
        is_given_up_(cells.size(), 0) {
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      const CellView view = view_of(candidates, cells[c]);
      for (const TetIndex t : view.all()) tets_.own(t, c);
    }
  }

  /// Closes all quads that can be closed.
  void close_quads(const Progress& progress) {
    constexpr std::uint32_t kSeldom = 1024;
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      if (progress && c % kSeldom == 0) progress(c, cells_.size());
      for_each_open_quad(c, [&](const Quad& quad, const std::array<Side, 2>& outer) {
        if (is_given_up_[c] == 0) close(c, quad, outer);
      });
    }
  }

  [[nodiscard]] std::size_t count_open_quads() const {
    std::size_t count = 0;
    for (std::uint32_t c = 0; c < cells_.size(); ++c)
      for_each_open_quad(c, [&count](const Quad&, const std::array<Side, 2>&) { ++count; });
    return count;
  }

  /// Those not given up, in their order.
  [[nodiscard]] std::vector<Cell> left() const {
    std::vector<Cell> result;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (is_given_up_[c] == 0) result.push_back(cells_[c]);
    return result;
  }

  [[nodiscard]] Combined take() {
    Combined result;
    if (tets_.has_regions()) result.mesh.regions = regions();
    for (TetIndex t = 0; t < tets_.size(); ++t)
      if (tets_.owner(t) == ChangingTets::kFree) result.mesh.tetrahedra.push_back(tets_[t]);
    for (const Cell cell : cells_) {
      ++result.chosen[static_cast<std::size_t>(cell.shape)];
      switch (cell.shape) {
        case Shape::hexahedron:
          result.mesh.hexahedra.push_back(candidates_.hexahedra.cells[cell.index].vertices);
          break;
        case Shape::prism:
          result.mesh.prisms.push_back(candidates_.prisms.cells[cell.index].vertices);
          break;
        case Shape::pyramid:
          result.mesh.pyramids.push_back(candidates_.pyramids.cells[cell.index].vertices);
          break;
      }
    }
    result.inserted_pyramids = pyramids_.size();
    result.mesh.pyramids.insert(result.mesh.pyramids.end(), pyramids_.begin(), pyramids_.end());
    result.new_points = points_.size() - given_points_;
    result.mesh.points = std::move(points_);
    return result;
  }

 private:
  /// Of the cells in the order of a mesh.
  [[nodiscard]] std::vector<std::uint32_t> regions() const {
    std::vector<std::uint32_t> result;
    for (TetIndex t = 0; t < tets_.size(); ++t)
      if (tets_.owner(t) == ChangingTets::kFree) result.push_back(tets_.region(t));
    for (const Shape shape : {Shape::hexahedron, Shape::prism, Shape::pyramid})
      for (const Cell cell : cells_)
        if (cell.shape == shape)
          result.push_back(tets_.region(view_of(candidates_, cell).all().front()));
    result.insert(result.end(), regions_of_pyramids_.begin(), regions_of_pyramids_.end());
    return result;
  }

  /// visit(quad, the two sides of its outer triangles) for quads that meet free tetrahedra.
  template <class Visit>
  void for_each_open_quad(std::uint32_t c, const Visit& visit) const {
    const CellView view = view_of(candidates_, cells_[c]);
    for (const LocalQuad& local : quads_of(view.shape)) {
      Quad quad{};
      for (std::size_t i = 0; i < 4; ++i) quad[i] = view.vertices[local[i]];
      const auto outer = outer_sides(view.all(), quad);
      const TetIndex beyond = tets_.across(outer[0]);
      const TetIndex other = tets_.across(outer[1]);
      core::ensures((beyond == TetGraph::kOutside) == (other == TetGraph::kOutside),
                    "a quad is on the boundary or inside");
      if (beyond == TetGraph::kOutside || tets_.owner(beyond) < cells_.size()) continue;
      visit(quad, outer);
    }
  }

  /// The facets with three vertices of the quad beyond which is another's tetrahedron, or none.
  [[nodiscard]] std::array<Side, 2> outer_sides(std::span<const TetIndex> all,
                                                const Quad& quad) const {
    std::array<Side, 2> result{};
    std::size_t count = 0;
    for (const TetIndex t : all)
      for (unsigned facet = 0; facet < 4; ++facet) {
        const Side side{t, facet};
        const auto common =
            std::count_if(quad.begin(), quad.end(), [&](Index v) { return has(side, v); });
        if (common < 3 || std::find(all.begin(), all.end(), tets_.across(side)) != all.end())
          continue;
        core::ensures(count < 2, "a quad has two outer triangles");
        result[count++] = side;
      }
    core::ensures(count == 2, "a quad has two outer triangles");
    return result;
  }

  /// Whether the facet has this vertex.
  [[nodiscard]] bool has(Side side, Index v) const {
    const std::size_t place = place_of(tets_[side.tetrahedron], v);
    return place < 4 && place != side.facet;
  }

  /// The quad as p q r s such that its outer triangles are p q r and p r s, the first that of
  /// outer[0].
  [[nodiscard]] Quad from_diagonal(const Quad& quad, const std::array<Side, 2>& outer) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const Quad turned{quad[i], quad[(i + 1) % 4], quad[(i + 2) % 4], quad[(i + 3) % 4]};
      if (!has(outer[0], turned[3]) && !has(outer[1], turned[1])) return turned;
    }
    throw core::InternalError("the outer triangles of a quad share a diagonal");
  }

  void close(std::uint32_t c, const Quad& quad, const std::array<Side, 2>& outer) {
    const Quad q = from_diagonal(quad, outer);
    const auto answer = tets_.fan(q[0], q[2], q[1], q[3], tets_.across(outer[0]));
    if (answer.obstacle) {
      give_up_worse(c, *answer.obstacle);
      return;
    }
    const Fan& fan = answer.fan;
    if (fan.tetrahedra.size() == 2 && is_alone(fan) && put_pyramid_of(q, fan)) return;
    if (fan.tetrahedra.size() < 2 || !put_pyramid_at_point(q, fan)) is_given_up_[c] = 1;
  }

  void give_up_worse(std::uint32_t c, ChangingTets::Owner obstacle) {
    const auto rank = [this](std::uint32_t i) {
      return std::tuple(cells_[i].shape, -view_of(candidates_, cells_[i]).quality, i);
    };
    const bool is_obstacle_worse = obstacle < cells_.size() && rank(obstacle) > rank(c);
    is_given_up_[is_obstacle_worse ? obstacle : c] = 1;
  }

  /// Whether no facet of the two that are not on the quad, nor common, is on another cell.
  [[nodiscard]] bool is_alone(const Fan& fan) const {
    std::size_t cells = 0;
    for (const TetIndex t : fan.tetrahedra)
      for (unsigned facet = 0; facet < 4; ++facet) {
        const TetIndex beyond = tets_.across({t, facet});
        if (beyond != TetGraph::kOutside && tets_.owner(beyond) < cells_.size()) ++cells;
      }
    return cells == 2;
  }

  /// Base as seen from the apex outside of the cell.
  [[nodiscard]] static mesh::Pyramid pyramid_over(const Quad& q, Index apex) {
    return {q[0], q[1], q[2], q[3], apex};
  }

  template <std::size_t N>
  [[nodiscard]] std::array<mesh::Point, N> corners_of(const std::array<Index, N>& cell) const {
    return quality::corners_of(std::span<const mesh::Point>(points_), cell);
  }
  static bool is_valid(const quality::PyramidCorners& corners) {
    return quality::verdict_of_pyramid(corners).validity == quality::Validity::valid;
  }
  static bool is_valid(const quality::TetrahedronCorners& corners) {
    return quality::verdict_of_tetrahedron(corners).validity == quality::Validity::valid;
  }

  /// The shape of a tetrahedron or pyramid if it is valid, otherwise 0.
  template <std::size_t N>
  [[nodiscard]] double quality_of(const std::array<Index, N>& cell) const {
    const std::array<mesh::Point, N> corners = corners_of(cell);
    return is_valid(corners) ? quality::scaled_jacobian(corners) : 0;
  }

  bool put_pyramid_of(const Quad& q, const Fan& fan) {
    const mesh::Pyramid pyramid = pyramid_over(q, fan.vertices[1]);
    if (!(quality_of(pyramid) > 0)) return false;
    for (const TetIndex t : fan.tetrahedra) tets_.own(t, ChangingTets::kPyramid);
    pyramids_.push_back(pyramid);
    regions_of_pyramids_.push_back(tets_.region(fan.tetrahedra[0]));
    return true;
  }

  /// Tetrahedra that make room for an apex, and those between their outer facets and it.
  struct Cavity {
    std::vector<TetIndex> old;
    std::vector<Tetrahedron> fresh;
    double quality = 0;  ///< the least, that of the pyramid included
  };

  /// The fan, and what lies beyond facets that the apex does not see from inside; nothing if that
  /// is not free or too much, or if a vertex would get lost.
  [[nodiscard]] std::optional<Cavity> cavity(const Quad& q, const Fan& fan, Index apex) const {
    constexpr std::size_t kMost = 40;
    Cavity result{fan.tetrahedra, {}, quality_of(pyramid_over(q, apex))};
    if (!(result.quality > 0)) return std::nullopt;
    const auto is_in = [&result](TetIndex t) {
      return std::find(result.old.begin(), result.old.end(), t) != result.old.end();
    };
    for (std::size_t i = 0; i < result.old.size(); ++i)
      for (unsigned facet = 0; facet < 4; ++facet) {
        const TetIndex t = result.old[i];
        const TetIndex beyond = tets_.across({t, facet});
        if (is_in(beyond) || is_on(q, {t, facet})) continue;
        if (is_valid(corners_of(with_apex({t, facet}, apex)))) continue;
        if (tets_.has_to_stay({t, facet}) || tets_.owner(beyond) != ChangingTets::kFree ||
            result.old.size() == kMost)
          return std::nullopt;
        result.old.push_back(beyond);
      }
    for (const TetIndex t : result.old)
      for (unsigned facet = 0; facet < 4; ++facet) {
        if (is_in(tets_.across({t, facet}))) {
          if (tets_.has_to_stay({t, facet})) return std::nullopt;
          continue;
        }
        if (is_on(q, {t, facet})) continue;
        result.fresh.push_back(with_apex({t, facet}, apex));
        result.quality = std::min(result.quality, quality_of(result.fresh.back()));
      }
    if (!(result.quality > 0) || loses_a_vertex(result, q)) return std::nullopt;
    return result;
  }

  [[nodiscard]] Tetrahedron with_apex(Side side, Index apex) const {
    Tetrahedron result = tets_[side.tetrahedron];
    result[side.facet] = apex;
    return result;
  }

  /// Whether it is one of the two triangles at the diagonal.
  [[nodiscard]] bool is_on(const Quad& q, Side side) const {
    return has(side, q[0]) && has(side, q[2]) && (has(side, q[1]) || has(side, q[3]));
  }

  [[nodiscard]] bool loses_a_vertex(const Cavity& cavity, const Quad& q) const {
    for (const TetIndex t : cavity.old)
      for (const Index v : tets_[t]) {
        const auto has = [v](const Tetrahedron& f) {
          return std::find(f.begin(), f.end(), v) != f.end();
        };
        if (std::find(q.begin(), q.end(), v) == q.end() &&
            std::none_of(cavity.fresh.begin(), cavity.fresh.end(), has))
          return true;
      }
    return false;
  }

  bool put_pyramid_at_point(const Quad& q, const Fan& fan) {
    const auto apex = static_cast<Index>(points_.size());
    if (apex >= mesh::kMostPoints) return false;
    points_.emplace_back();
    mesh::Point best_place{};
    std::optional<Cavity> best;
    for (const mesh::Point& place : places(q, fan)) {
      points_.back() = place;
      auto found = cavity(q, fan, apex);
      if (!found || (best && found->quality <= best->quality)) continue;
      best = std::move(found);
      best_place = place;
    }
    if (!best) {
      points_.pop_back();
      return false;
    }
    points_.back() = best_place;
    std::vector<ChangingTets::Owner> owners(best->fresh.size(), ChangingTets::kFree);
    best->fresh.push_back({q[0], q[1], q[2], apex});
    best->fresh.push_back({q[0], q[2], q[3], apex});
    owners.resize(best->fresh.size(), ChangingTets::kPyramid);
    tets_.replace(best->old, best->fresh, owners);
    pyramids_.push_back(pyramid_over(q, apex));
    regions_of_pyramids_.push_back(tets_.region(fan.tetrahedra[0]));
    return true;
  }

  [[nodiscard]] mesh::Point middle(std::span<const Index> vertices) const {
    mesh::Point sum{};
    const double share = 1 / static_cast<double>(vertices.size());
    for (const Index v : vertices) {
      sum.x += share * points_[v].x;
      sum.y += share * points_[v].y;
      sum.z += share * points_[v].z;
    }
    return sum;
  }

  /// Places for an apex: from the middle of the diagonal towards that of the fan's other vertices,
  /// and above the middle of the quad.
  [[nodiscard]] std::vector<mesh::Point> places(const Quad& q, const Fan& fan) const {
    const auto between = [](const mesh::Point& a, const mesh::Point& b, double t) {
      return mesh::Point{(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, (1 - t) * a.z + t * b.z};
    };
    const mesh::Point near = middle(std::array{q[0], q[2]});
    const mesh::Point far = middle(std::span(fan.vertices).subspan(1, fan.vertices.size() - 2));
    std::vector<mesh::Point> result;
    for (const double t : {0.75, 0.5, 0.25, 0.125, 0x1p-4, 0x1p-6, 0x1p-8})
      result.push_back(between(near, far, t));
    const mesh::Point center = middle(q);
    const mesh::Point up = above(q);
    for (const double t : {0.7, 0.5, 0.35, 0.2, 0.1})
      result.push_back({center.x + t * up.x, center.y + t * up.y, center.z + t * up.z});
    std::erase_if(result, [](const mesh::Point& p) { return !mesh::is_finite(p); });
    return result;
  }

  /// Normal to both diagonals, outwards, as long as their mean.
  [[nodiscard]] mesh::Point above(const Quad& q) const {
    const mesh::Point normal =
        quality::direction({}, quality::cross(quality::direction(points_[q[0]], points_[q[2]]),
                                              quality::direction(points_[q[1]], points_[q[3]])));
    const double scale = quality::length(points_[q[0]], points_[q[2]], 0.5) +
                         quality::length(points_[q[1]], points_[q[3]], 0.5);
    return {scale * normal.x, scale * normal.y, scale * normal.z};
  }

  const Candidates& candidates_;
  std::span<const Cell> cells_;
  ChangingTets tets_;
  std::vector<mesh::Point> points_;
  std::size_t given_points_;
  std::vector<std::uint8_t> is_given_up_;
  std::vector<mesh::Pyramid> pyramids_;  ///< inserted
  std::vector<std::uint32_t> regions_of_pyramids_;
};

}  // namespace

Combined conforming_mesh(const TetGraph& graph, const Candidates& candidates,
                         std::span<const Cell> cells, const Progress& progress) {
  std::vector<Cell> kept(cells.begin(), cells.end());
  for (;;) {
    Attempt attempt(graph, candidates, kept);
    attempt.close_quads(progress);
    std::vector<Cell> left = attempt.left();
    if (left.size() == kept.size()) {
      Combined result = attempt.take();
      result.given_up = cells.size() - kept.size();
      return result;
    }
    kept = std::move(left);
  }
}

Combined plain_mesh(const TetGraph& graph, const Candidates& candidates,
                    std::span<const Cell> cells) {
  Attempt attempt(graph, candidates, cells);
  const std::size_t open = attempt.count_open_quads();
  Combined result = attempt.take();
  result.quads_on_triangles = open;
  return result;
}

}  // namespace hexatlas::hybrid
