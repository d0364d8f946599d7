// The law of points with weights that are in no tetrahedron.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "tables/check/delaunay_laws.hpp"

namespace hexatlas::check {

namespace {

using Numbers = std::vector<std::uint32_t>;

/// Points in the order of a k-d tree: the middle one of each part divides it in two, in turn by x,
/// y and z (J. L. Bentley, "Multidimensional binary search trees used for associative searching",
/// 1975).
class PointTree {
 public:
  PointTree(const std::vector<Point>& points, Numbers numbers)
      : points_(points), numbers_(std::move(numbers)) {
    sort(0, numbers_.size(), 0);
  }

  /// visit(number) for each point in the closed box.
  template <class Visit>
  void for_each_in(const Point& low, const Point& high, const Visit& visit) const {
    search(0, numbers_.size(), 0, low, high, visit);
  }

 private:
  void sort(std::size_t begin, std::size_t end, std::size_t axis) {
    if (end - begin < 2) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) {
      return numbers_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return points_[a][axis] < points_[b][axis];
    });
    sort(begin, middle, (axis + 1) % 3);
    sort(middle + 1, end, (axis + 1) % 3);
  }

  template <class Visit>
  void search(std::size_t begin, std::size_t end, std::size_t axis, const Point& low,
              const Point& high, const Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Point& point = points_[numbers_[middle]];
    if (low[axis] <= point[axis]) search(begin, middle, (axis + 1) % 3, low, high, visit);
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      is_inside = is_inside && low[i] <= point[i] && point[i] <= high[i];
    }
    if (is_inside) visit(numbers_[middle]);
    if (point[axis] <= high[axis]) search(middle + 1, end, (axis + 1) % 3, low, high, visit);
  }

  const std::vector<Point>& points_;
  Numbers numbers_;
};

/// The points in no tetrahedron that have not both place and weight of a vertex.
Numbers hidden_points(const TetrahedralMesh& mesh, const std::vector<double>& weights,
                      DelaunayVerdict& verdict) {
  const std::vector<bool> used = used_points(mesh);
  Numbers order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t v) { return std::tie(mesh.points[v], weights[v]); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  Numbers hidden;
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    while (end < order.size() && key(order[end]) == key(order[i])) ++end;
    Numbers unused;
    for (std::size_t k = i; k < end; ++k) {
      if (!used[order[k]]) unused.push_back(order[k]);
    }
    if (unused.size() < end - i) {
      verdict.duplicates += unused.size();
    } else {
      hidden.insert(hidden.end(), unused.begin(), unused.end());
    }
  }
  verdict.hidden = hidden.size();
  return hidden;
}

bool contains(const TetrahedralMesh& mesh, std::uint32_t cell, const Point& point, Signs& signs) {
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Triangle facet = facet_of(mesh.tetrahedra, 4 * cell + i);
    if (signs.orientation(mesh.points[facet[0]], mesh.points[facet[1]], mesh.points[facet[2]],
                          point) > 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

DelaunayFinding check_hidden_points(const TetrahedralMesh& mesh, const std::vector<double>& weights,
                                    Signs& signs, DelaunayVerdict& verdict) {
  const Numbers hidden = hidden_points(mesh, weights, verdict);
  if (hidden.empty()) return std::nullopt;
  const PointTree tree(mesh.points, hidden);
  std::vector<bool> located(mesh.points.size(), false);
  DelaunayFinding found;
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size() && !found; ++t) {
    const Tetrahedron& cell = mesh.tetrahedra[t];
    Point low = mesh.points[cell[0]];
    Point high = low;
    for (const std::uint32_t vertex : cell) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], mesh.points[vertex][axis]);
        high[axis] = std::max(high[axis], mesh.points[vertex][axis]);
      }
    }
    tree.for_each_in(low, high, [&](std::uint32_t v) {
      if (found || located[v] || !contains(mesh, t, mesh.points[v], signs)) return;
      located[v] = true;
      if (side_of_sphere(mesh, &weights, cell, v, signs) <= 0) return;
      found = DelaunayFailure{DelaunayLaw::kHiddenPoint,
                              "point " + std::to_string(v) +
                                  " is in no tetrahedron, but inside the orthosphere of " +
                                  name_of(mesh, t) + ", in which it lies"};
    });
  }
  if (found) return found;
  for (const std::uint32_t v : hidden) {
    if (located[v]) continue;
    return DelaunayFailure{
        DelaunayLaw::kHiddenPoint,
        "point " + std::to_string(v) + " is in no tetrahedron, and lies outside of all"};
  }
  return std::nullopt;
}

}  // namespace hexatlas::check
