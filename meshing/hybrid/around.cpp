#include "meshing/hybrid/around.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace hexatlas::hybrid {

void Around::visit(Index a) {
  a_ = a;
  const auto neighbours = graph_->neighbours(a);
  first_after_ = static_cast<std::uint32_t>(
      std::upper_bound(neighbours.begin(), neighbours.end(), a) - neighbours.begin());
  gather_quads();
  gather_triangles();
}

void Around::gather_quads() {
  const auto neighbours = graph_->neighbours(a_);
  struct Pair {
    std::uint32_t x = 0, y = 0, first = 0, count = 0;
  };
  std::vector<Pair> pairs;
  row_.assign(neighbours.size() + 1, 0);
  fourths_.clear();
  for (std::uint32_t x = first_after_; x < neighbours.size(); ++x)
    for (const Corner& corner : corners_->at(a_, x)) {
      if (corner.z < a_) continue;
      if (pairs.empty() || pairs.back().x != corner.x || pairs.back().y != corner.y) {
        pairs.push_back({corner.x, corner.y, static_cast<std::uint32_t>(fourths_.size()), 0});
        ++row_[corner.x + 1];
        ++row_[corner.y + 1];
      }
      ++pairs.back().count;
      fourths_.push_back({corner.z, graph_->position(neighbours[corner.x], corner.z),
                          graph_->position(neighbours[corner.y], corner.z)});
    }
  for (std::size_t x = 0; x < neighbours.size(); ++x) row_[x + 1] += row_[x];
  partners_.resize(row_.back());
  std::vector<std::size_t> next(row_.begin(), row_.end() - 1);
  // Pairs ascend by x, then y: lesser partners of a row come before greater ones, each ascending.
  for (const Pair& p : pairs) partners_[next[p.y]++] = {p.x, p.first, p.count, true};
  for (const Pair& p : pairs) partners_[next[p.x]++] = {p.y, p.first, p.count, false};
}

void Around::gather_triangles() {
  triangles_.clear();
  for (const TetIndex t : graph_->star(a_)) {
    const Tetrahedron& tetrahedron = (*graph_)[t];
    for (unsigned i = 0; i < 4; ++i) {
      if (tetrahedron[i] != a_) continue;
      // Seen from its vertex i a facet is a right-handed tetrahedron's with that as fourth; as
      // first, the facet's other direction.
      const auto& [p, q, r] = kFacetFrom[i];
      const std::array<Index, 3> v{tetrahedron[p], tetrahedron[r], tetrahedron[q]};
      for (unsigned k = 0; k < 3; ++k)
        triangles_.push_back({v[k], v[(k + 1) % 3], v[(k + 2) % 3], t});
    }
  }
  std::sort(triangles_.begin(), triangles_.end(),
            [](const auto& s, const auto& t) { return s.p != t.p ? s.p < t.p : s.q < t.q; });
}

const Around::Beyond* Around::beyond(Index p, Index q) const noexcept {
  const auto it =
      std::lower_bound(triangles_.begin(), triangles_.end(), std::pair(p, q),
                       [](const Beyond& t, const auto& key) { return std::pair(t.p, t.q) < key; });
  return it == triangles_.end() || it->p != p || it->q != q ? nullptr : &*it;
}

}  // namespace hexatlas::hybrid
