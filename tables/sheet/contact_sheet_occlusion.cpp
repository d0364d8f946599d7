#include "tables/sheet/contact_sheet_occlusion.hpp"

#include <algorithm>

namespace hexatlas::sheet {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
struct Gap {
  Vec normal;  ///< from a to b
  double width = -std::numeric_limits<double>::infinity();
};

/// The widest gap between two tetrahedra, negative if they overlap, along normals of faces and of
/// pairs of edges; or the first one of at least `enough`.
Gap gap_between(const Corners& a, const Corners& b, double enough) {
  Gap best;
  const auto consider = [&](Vec normal) {
    const double size = length(normal);
    if (size < 1e-9 || best.width >= enough) return;
    normal = (1 / size) * normal;
    if (dot(normal, centroid(b) - centroid(a)) < 0) normal = -1 * normal;
    double top = -std::numeric_limits<double>::infinity();
    double bottom = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
      top = std::max(top, dot(normal, a[i]));
      bottom = std::min(bottom, dot(normal, b[i]));
    }
    if (bottom - top > best.width) best = {normal, bottom - top};
  };
  for (const Corners& t : {a, b})
    for (std::size_t i = 0; i < 4; ++i)
      consider(cross(t[(i + 1) % 4] - t[i], t[(i + 2) % 4] - t[i]));
  for (const auto& e : kEdges)
    for (const auto& f : kEdges) consider(cross(a[e[1]] - a[e[0]], b[f[1]] - b[f[0]]));
  return best;
}

Rectangle bounds(const Corners& corners) {
  Rectangle box;
  for (const Vec corner : corners) box.include(corner);
  return box;
}

/// The part of the segment a b behind a tetrahedron, empty if begin >= end. Points a + t (b - a)
/// + s z are in the tetrahedron, s >= 0, for the (t, s) of a convex polygon: a long rectangle,
/// clipped by the four faces.
std::pair<double, double> hidden_part(Vec a, Vec b, const Corners& piece) {
  struct Point {
    double t, s;
  };
  constexpr double kFar = 1e4;
  std::vector<Point> polygon{{0, 0}, {1, 0}, {1, kFar}, {0, kFar}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec on = piece[(k + 1) % 4];
    Vec inward = cross(piece[(k + 2) % 4] - on, piece[(k + 3) % 4] - on);
    if (dot(inward, piece[k] - on) < 0) inward = -1 * inward;
    const auto height = [&](Point p) {
      return dot(inward, a + p.t * (b - a) + Vec{0, 0, p.s} - on);
    };
    std::vector<Point> clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point p = polygon[i];
      const Point q = polygon[(i + 1) % polygon.size()];
      const double at_p = height(p);
      const double at_q = height(q);
      if (at_p >= 0) clipped.push_back(p);
      if ((at_p < 0) == (at_q < 0)) continue;
      const double r = at_p / (at_p - at_q);
      clipped.push_back({p.t + r * (q.t - p.t), p.s + r * (q.s - p.s)});
    }
    polygon = std::move(clipped);
  }
  std::pair<double, double> part{1, 0};
  for (const Point p : polygon) {
    part.first = std::min(part.first, p.t);
    part.second = std::max(part.second, p.t);
  }
  return part;
}

}  // namespace

bool are_apart(const Corners& a, const Corners& b) {
  constexpr double kTouch = -1e-7;
  return gap_between(a, b, kTouch).width >= kTouch;
}

SeparatingNormals separating_normals(const std::vector<Corners>& pieces) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  SeparatingNormals normals(pieces.size(), std::vector<Vec>(pieces.size()));
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.size(); ++j)
      normals[i][j] = gap_between(pieces[i], pieces[j], kNever).normal;
  return normals;
}

PaintersOrder painters_order(const std::vector<Corners>& pieces, const SeparatingNormals& normals,
                             Vec eye) {
  const std::size_t n = pieces.size();
  std::vector<Rectangle> boxes;
  boxes.reserve(n);
  for (const Corners& piece : pieces) boxes.push_back(bounds(piece));
  std::vector<std::vector<std::size_t>> before(n);
  std::vector<int> behind(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double side = dot(eye, normals[i][j]);
      if (!boxes[i].meets(boxes[j])) continue;
      const auto [far, near] = side > 0 ? std::pair(i, j) : std::pair(j, i);
      before[far].push_back(near);
      ++behind[near];
    }
  PaintersOrder answer;
  std::vector<bool> is_placed(n, false);
  while (answer.order.size() < n) {
    std::size_t next = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (is_placed[i]) continue;
      if (next == n || std::pair(behind[i], centroid(pieces[i]).z) <
                           std::pair(behind[next], centroid(pieces[next]).z))
        next = i;
    }
    if (behind[next] > 0) answer.is_sure = false;
    is_placed[next] = true;
    answer.order.push_back(next);
    for (const std::size_t near : before[next]) --behind[near];
  }
  return answer;
}

std::vector<std::pair<double, double>> visible_parts(Vec a, Vec b,
                                                     const std::vector<Corners>& pieces) {
  std::vector<std::pair<double, double>> hidden;
  for (const Corners& piece : pieces)
    if (const auto part = hidden_part(a, b, piece); part.first < part.second)
      hidden.push_back(part);
  std::sort(hidden.begin(), hidden.end());
  std::vector<std::pair<double, double>> visible;
  double from = 0;
  for (const auto& [begin, end] : hidden) {
    if (begin > from) visible.emplace_back(from, begin);
    from = std::max(from, end);
  }
  if (from < 1) visible.emplace_back(from, 1);
  return visible;
}

}  // namespace hexatlas::sheet
