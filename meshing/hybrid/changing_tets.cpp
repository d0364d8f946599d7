#include "meshing/hybrid/changing_tets.hpp"

#include <algorithm>

#include "enum/core/checks.hpp"

namespace hexatlas::hybrid {
namespace {

std::array<Index, 3> triangle_of(const Tetrahedron& tetrahedron, unsigned facet) {
  std::array<Index, 3> triangle{};
  std::copy_if(tetrahedron.begin(), tetrahedron.end(), triangle.begin(),
               [apex = tetrahedron[facet]](Index v) { return v != apex; });
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

}  // namespace

ChangingTets::ChangingTets(const TetGraph& graph)
    : tets_(graph), owner_(graph.size(), kFree), regions_(graph.size()) {
  for (TetIndex t = 0; t < graph.size(); ++t) {
    regions_[t] = graph.region(t);
    for (unsigned facet = 0; facet < 4; ++facet)
      if (graph.colour(t, facet) != 0 && graph.across(t, facet) != TetGraph::kOutside)
        on_surfaces_.insert(triangle_of(graph[t], facet));
  }
}

bool ChangingTets::has_regions() const {
  return std::any_of(regions_.begin(), regions_.end(), [](auto region) { return region != 0; });
}

bool ChangingTets::has_to_stay(Side side) const {
  const TetIndex beyond = across(side);
  return beyond == TetGraph::kOutside || regions_[beyond] != regions_[side.tetrahedron] ||
         (!on_surfaces_.empty() &&
          on_surfaces_.contains(triangle_of(tets_[side.tetrahedron], side.facet)));
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
    const Tetrahedron& vertices = tets_[t];
    Index next = last;
    for (const Index v : vertices)
      if (v != p && v != r && v != last) next = v;
    answer.fan.tetrahedra.push_back(t);
    answer.fan.vertices.push_back(next);
    if (next == to) return answer;
    const Side side{t, static_cast<unsigned>(place_of(vertices, last))};
    t = has_to_stay(side) ? TetGraph::kOutside : across(side);
    last = next;
  }
}

void ChangingTets::replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh,
                           std::span<const Owner> owners) {
  core::expects(fresh.size() == owners.size(), "an owner for each tetrahedron");
  tets_.replace(old, fresh);
  for (const TetIndex t : old) owner_[t] = kGone;
  owner_.insert(owner_.end(), owners.begin(), owners.end());
  regions_.resize(owner_.size(), regions_[old.front()]);
}

}  // namespace hexatlas::hybrid
