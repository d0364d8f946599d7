#include "tables/check/shelling.hpp"

#include <algorithm>
#include <bit>

#include "tables/check/triangulation_laws.hpp"

namespace hexatlas::check {

namespace {

/// The union of some tetrahedra, as the number of them that contain each set of vertices.
class Union {
 public:
  Union() : count_(std::size_t{1} << kMostCatalogueVertices, 0) {}

  void add(VertexBits tetrahedron) { change(tetrahedron, 1); }
  void remove(VertexBits tetrahedron) { change(tetrahedron, -1); }

  /// Number of triangles in which the tetrahedron meets the union; 0 if it has a vertex or an edge
  /// in the union outside them.
  [[nodiscard]] int common_triangles(VertexBits tetrahedron) const {
    int triangles = 0;
    unsigned outside = 0;  // vertices opposite to triangles of the union
    for (unsigned rest = tetrahedron; rest != 0; rest &= rest - 1) {
      const unsigned vertex = rest & (0U - rest);
      if (count_[tetrahedron & ~vertex] == 0) continue;
      ++triangles;
      outside |= vertex;
    }
    // A face lies in one of these triangles if it misses one of the vertices opposite to them.
    for (unsigned face = (tetrahedron - 1U) & tetrahedron; face != 0;
         face = (face - 1U) & tetrahedron) {
      if ((outside & ~face) == 0 && count_[face] != 0) return 0;
    }
    return triangles;
  }

 private:
  void change(VertexBits tetrahedron, int by) {
    for (unsigned face = tetrahedron; face != 0; face = (face - 1U) & tetrahedron) {
      count_[face] = static_cast<std::uint16_t>(count_[face] + by);
    }
  }

  std::vector<std::uint16_t> count_;
};

class ShellingSearch {
 public:
  ShellingSearch(const Tetrahedra& tetrahedra, std::uint64_t steps)
      : tetrahedra_(tetrahedra), used_(tetrahedra.size(), false), steps_(steps) {}

  [[nodiscard]] std::uint64_t steps_left() const { return steps_; }

  bool run() {
    for (std::size_t first = 0; first < tetrahedra_.size() && steps_ > 0; ++first) {
      if (descend(first, 1)) return true;
    }
    return false;
  }

 private:
  /// Uses one more tetrahedron, the `count`-th, and then all others if possible.
  bool descend(std::size_t index, std::size_t count) {
    if (count == tetrahedra_.size()) return true;
    used_[index] = true;
    union_.add(tetrahedra_[index]);
    bool done = false;
    for (std::size_t next = 0; next < tetrahedra_.size() && !done && steps_ > 0; ++next) {
      if (used_[next]) continue;
      --steps_;
      const int triangles = union_.common_triangles(tetrahedra_[next]);
      const int most = count + 1 == tetrahedra_.size() ? 4 : 3;
      if (triangles > 0 && triangles <= most) done = descend(next, count + 1);
    }
    used_[index] = false;
    union_.remove(tetrahedra_[index]);
    return done;
  }

  const Tetrahedra& tetrahedra_;
  std::vector<bool> used_;
  std::uint64_t steps_;
  Union union_;
};

bool has_shelling(const Tetrahedra& tetrahedra, std::uint64_t& steps_left) {
  const std::uint64_t steps = std::min(kShellingSteps, steps_left);
  ShellingSearch search(tetrahedra, steps);
  const bool found = search.run();
  steps_left -= steps - search.steps_left();
  return found;
}

}  // namespace

bool is_shelling(const Tetrahedra& order) {
  Union before;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int triangles = before.common_triangles(order[i]);
    if (i > 0 && (triangles < 1 || triangles > 3)) return false;
    before.add(order[i]);
  }
  return true;
}

bool find_ball_proof(const Tetrahedra& tetrahedra, std::uint64_t& steps_left) {
  const std::vector<VertexBits> boundary = boundary_triangles(tetrahedra);
  if (boundary.empty()) return false;
  if (has_shelling(tetrahedra, steps_left)) return true;
  unsigned used = 0;
  for (const VertexBits tetrahedron : tetrahedra) used |= tetrahedron;
  const unsigned apex = (used + 1U) & ~used;
  if (apex >= 1U << kMostCatalogueVertices) return false;
  Tetrahedra closed = tetrahedra;
  for (const VertexBits triangle : boundary) {
    closed.push_back(static_cast<VertexBits>(triangle | apex));
  }
  return !check_triangles(closed) && has_shelling(closed, steps_left);
}

}  // namespace hexatlas::check
