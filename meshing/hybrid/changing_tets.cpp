#include "meshing/hybrid/changing_tets.hpp"

#include "enum/core/checks.hpp"

namespace hexatlas::hybrid {

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
    t = tets_.across(t, place_of(vertices, last));
    last = next;
  }
}

void ChangingTets::replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh,
                           std::span<const Owner> owners) {
  core::expects(fresh.size() == owners.size(), "an owner for each tetrahedron");
  tets_.replace(old, fresh);
  for (const TetIndex t : old) owner_[t] = kGone;
  owner_.insert(owner_.end(), owners.begin(), owners.end());
}

}  // namespace hexatlas::hybrid
