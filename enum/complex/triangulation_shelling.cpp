// Depth first with a memory of the sets of tetrahedra that lead nowhere: whether a set can be
// completed does not depend on the order in which it was reached.

#include <algorithm>
#include <bitset>
#include <limits>
#include <unordered_set>

#include "enum/complex/tetrahedra_at_triangles.hpp"
#include "enum/complex/triangulation.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::complex {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
/// A sphere with 16 vertices has at most 16 * 13 / 2 = 104 tetrahedra.
constexpr std::size_t kMaxTetrahedra = 128;
using TetrahedronSet = std::bitset<kMaxTetrahedra>;

class Sheller {
 public:
  Sheller(const Triangulation& triangulation, std::size_t budget)
      : budget_(budget), tetrahedra_(triangulation.tetrahedra) {
    neighbours_.assign(tetrahedra_.size(), {kNone, kNone, kNone, kNone});
    for (const TrianglePlace& place : tetrahedra_at_triangles(triangulation)) {
      core::expects(place.count <= 2, "search_shelling: a triangle lies in three tetrahedra");
      if (place.count < 2) {
        is_sphere_ = false;
        continue;
      }
      link(place.at[0], place.at[1], place.triangle);
      link(place.at[1], place.at[0], place.triangle);
    }
    for (const VertexSet tetrahedron : tetrahedra_) corners_.push_back(vertices_of(tetrahedron));
  }

  ShellingAnswer run() {
    for (std::size_t start = 0; start < tetrahedra_.size(); ++start) {
      add(start);
      if (extend()) return {ShellingSearch::found, order_};
      remove();
      if (steps_ > budget_) return {ShellingSearch::given_up, {}};
    }
    return {ShellingSearch::none, {}};
  }

 private:
  void link(std::size_t from, std::size_t to, VertexSet triangle) {
    const auto apex = static_cast<VertexSet>(tetrahedra_[from] & ~static_cast<unsigned>(triangle));
    const unsigned below = static_cast<unsigned>(tetrahedra_[from]) & (apex - 1U);
    neighbours_[from][static_cast<std::size_t>(std::popcount(below))] = to;
  }

  /// Triangles in common with the chosen ones if it may come next, else 0.
  [[nodiscard]] int common_triangles(std::size_t t) const {
    VertexSet apexes = 0;  // opposite to the common triangles
    for (std::size_t i = 0; i < 4; ++i)
      if (neighbours_[t][i] != kNone && chosen_[neighbours_[t][i]])
        apexes = static_cast<VertexSet>(apexes | bit_of(corners_[t][i]));
    const int common = std::popcount(static_cast<unsigned>(apexes));
    const auto first = static_cast<std::size_t>(apexes == 0 ? 0 : least_vertex(apexes));
    if (common == 1 && uses_of_edge_[first][first] != 0) return 0;
    if (common == 2) {
      const auto second = static_cast<std::size_t>(least_vertex(without_least(apexes)));
      if (uses_of_edge_[first][second] != 0) return 0;
    }
    const bool is_last = is_sphere_ && order_.size() + 1 == tetrahedra_.size();
    return common == 4 && !is_last ? 0 : common;
  }

  bool extend() {
    if (order_.size() == tetrahedra_.size()) return true;
    if (++steps_ > budget_ || dead_.contains(chosen_)) return false;
    for (int wanted = 4; wanted >= 1; --wanted)
      for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
        if (chosen_[t] || common_triangles(t) != wanted) continue;
        add(t);
        if (extend()) return true;
        remove();
        if (steps_ > budget_) return false;
      }
    dead_.insert(chosen_);
    return false;
  }

  void count(std::size_t t, int change) {
    for (const std::size_t a : corners_[t])
      for (const std::size_t b : corners_[t])
        if (a <= b) uses_of_edge_[a][b] += change;
  }
  void add(std::size_t t) {
    chosen_.set(t);
    order_.push_back(t);
    count(t, 1);
  }
  void remove() {
    count(order_.back(), -1);
    chosen_.reset(order_.back());
    order_.pop_back();
  }

  std::size_t budget_, steps_ = 0;
  bool is_sphere_ = true;
  const std::vector<VertexSet>& tetrahedra_;
  std::vector<std::array<std::uint8_t, 4>> corners_;
  std::vector<std::array<std::size_t, 4>> neighbours_;  ///< across the triangle opposite corner i
  TetrahedronSet chosen_;
  std::vector<std::size_t> order_;
  /// Chosen tetrahedra at the edge a < b; at the vertex a for a == b.
  std::array<std::array<int, kMaxTriangulationVertices>, kMaxTriangulationVertices> uses_of_edge_{};
  std::unordered_set<TetrahedronSet> dead_;
};

}  // namespace

ShellingAnswer search_shelling(const Triangulation& triangulation, std::size_t budget) {
  core::expects(triangulation.tetrahedra.size() <= kMaxTetrahedra,
                "search_shelling: at most 128 tetrahedra");
  return Sheller(triangulation, budget).run();
}

}  // namespace hexatlas::complex
