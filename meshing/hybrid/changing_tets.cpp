#include "meshing/hybrid/changing_tets.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::hybrid {
namespace {

Triangle sorted_facet(const Tetrahedron& tetrahedron, unsigned facet) {
  Triangle result{};
  std::size_t count = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (i != facet) result[count++] = tetrahedron[i];
  std::sort(result.begin(), result.end());
  return result;
}

unsigned place_of(const Tetrahedron& tetrahedron, Index v) {
  return static_cast<unsigned>(std::find(tetrahedron.begin(), tetrahedron.end(), v) -
                               tetrahedron.begin());
}

}  // namespace

ChangingTets::ChangingTets(const TetGraph& graph) : owner_(graph.size(), kFree) {
  tetrahedra_.reserve(graph.size());
  across_.reserve(4 * graph.size());
  for (TetIndex t = 0; t < graph.size(); ++t) {
    tetrahedra_.push_back(graph[t]);
    for (unsigned facet = 0; facet < 4; ++facet) across_.push_back(graph.across(t, facet));
  }
}

ChangingTets::FanAnswer ChangingTets::fan(Index p, Index r, Index from, Index to,
                                          TetIndex first) const {
  FanAnswer answer;
  answer.fan.vertices.push_back(from);
  Index last = from;
  for (TetIndex t = first;;) {
    if (t == TetGraph::kOutside) {
      answer.obstacle = kGone;
      return answer;
    }
    if (owner_[t] != kFree) {
      answer.obstacle = owner_[t];
      return answer;
    }
    const Tetrahedron& vertices = tetrahedra_[t];
    Index next = last;
    for (const Index v : vertices)
      if (v != p && v != r && v != last) next = v;
    answer.fan.tetrahedra.push_back(t);
    answer.fan.vertices.push_back(next);
    if (next == to) return answer;
    t = across({t, place_of(vertices, last)});
    last = next;
  }
}

void ChangingTets::replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh,
                           std::span<const Owner> owners) {
  core::expects(fresh.size() == owners.size(), "an owner for each tetrahedron");
  std::map<Triangle, Side> open;
  const auto glue = [&](Side one, Side other) {
    for (const auto& [side, beyond] : {std::pair(one, other), std::pair(other, one)})
      if (side.tetrahedron != TetGraph::kOutside)
        across_[std::size_t{side.tetrahedron} * 4 + side.facet] = beyond.tetrahedron;
  };
  for (const TetIndex t : old) {
    for (unsigned facet = 0; facet < 4; ++facet) {
      const TetIndex beyond = across({t, facet});
      if (std::find(old.begin(), old.end(), beyond) != old.end()) continue;
      const Triangle triangle = sorted_facet(tetrahedra_[t], facet);
      Side side{beyond, 0};
      if (beyond != TetGraph::kOutside)
        for (unsigned i = 0; i < 4; ++i)
          if (sorted_facet(tetrahedra_[beyond], i) == triangle) side.facet = i;
      open.emplace(triangle, side);
    }
    owner_[t] = kGone;
  }
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const auto t = static_cast<TetIndex>(tetrahedra_.size());
    tetrahedra_.push_back(fresh[i]);
    across_.resize(across_.size() + 4, TetGraph::kOutside);
    owner_.push_back(owners[i]);
    for (unsigned facet = 0; facet < 4; ++facet) {
      const auto [it, is_new] = open.emplace(sorted_facet(fresh[i], facet), Side{t, facet});
      if (is_new) continue;
      glue({t, facet}, it->second);
      open.erase(it);
    }
  }
  core::ensures(open.empty(), "tetrahedra are replaced by such with the same boundary");
}

}  // namespace hexatlas::hybrid
