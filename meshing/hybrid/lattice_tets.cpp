#include "meshing/hybrid/lattice_tets.hpp"

#include <algorithm>
#include <utility>

#include "meshing/quality/edge.hpp"

namespace hexatlas::hybrid {

FlippedTets::FlippedTets(std::span<const mesh::Point> points, std::vector<Tetrahedron> tetrahedra)
    : points_(points),
      tets_(std::move(tetrahedra)),
      is_gone_(tets_.size(), 0),
      at_(points.size(), kOutside),
      seen_(tets_.size(), 0) {
  for (TetIndex t = 0; t < tets_.size(); ++t)
    for (const Index v : tets_[t]) at_[v] = t;
}

exact::Sign FlippedTets::orientation(Index a, Index b, Index c, Index d) const {
  const auto at = [this](Index v) { return quality::exact_point(points_[v]); };
  return exact::sign_of_orientation(at(a), at(b), at(c), at(d));
}

std::span<const TetIndex> FlippedTets::star(Index v) const {
  ++question_;
  found_.assign(1, at_[v]);
  seen_[at_[v]] = question_;
  for (std::size_t next = 0; next < found_.size(); ++next) {
    const TetIndex t = found_[next];
    for (std::size_t i = 0; i < 4; ++i) {
      const TetIndex beyond = across(t, i);
      if (tets_[t][i] == v || beyond == kOutside || seen_[beyond] == question_) continue;
      seen_[beyond] = question_;
      found_.push_back(beyond);
    }
  }
  return found_;
}

std::optional<TetIndex> FlippedTets::with(std::span<const Index> vertices) const {
  for (const TetIndex t : star(vertices.front()))
    if (std::all_of(vertices.begin(), vertices.end(),
                    [&](Index v) { return place_of(tets_[t], v) < 4; }))
      return t;
  return std::nullopt;
}

std::optional<FlippedTets::Ring> FlippedTets::ring(Index a, Index b, TetIndex at) const {
  // With the vertices a b c d of a right-handed tetrahedron in an even order, d follows c.
  std::array<Index, 2> others{};
  std::size_t count = 0;
  for (const Index v : tets_[at])
    if (v != a && v != b) others[count++] = v;
  if (orientation(a, b, others[0], others[1]) == exact::Sign::negative)
    std::swap(others[0], others[1]);
  Ring result;
  const Index first = others[0];
  Index last = first;
  Index next = others[1];
  for (TetIndex t = at;;) {
    result.tetrahedra.push_back(t);
    result.vertices.push_back(last);
    t = across(t, place_of(tets_[t], last));
    if (t == kOutside) return std::nullopt;
    if (next == first) return result;
    Index after = next;
    for (const Index v : tets_[t])
      if (v != a && v != b && v != next) after = v;
    last = std::exchange(next, after);
  }
}

void FlippedTets::replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh) {
  const std::size_t first = tets_.size();
  tets_.replace(old, fresh);
  for (const TetIndex t : old) is_gone_[t] = 1;
  is_gone_.resize(tets_.size(), 0);
  seen_.resize(tets_.size(), 0);
  for (std::size_t t = first; t < tets_.size(); ++t)
    for (const Index v : tets_[static_cast<TetIndex>(t)]) at_[v] = static_cast<TetIndex>(t);
}

}  // namespace hexatlas::hybrid
