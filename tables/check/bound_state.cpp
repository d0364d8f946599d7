#include "tables/check/bound_state.hpp"

namespace hexatlas::check {

namespace {

bool has(VertexSet set, std::size_t v) { return (set >> v & 1U) != 0; }

/// The same vertices around, whatever the first one and the direction.
bool are_one_circle(const BoundFacet& facet, const BoundCorners& corners) {
  if (facet.vertices != vertex_set(corners)) return false;
  for (unsigned i = 0; i < 4; ++i) {
    if (facet.corners[i] == corners[0]) return facet.corners[(i + 2) % 4] == corners[2];
  }
  return false;
}

}  // namespace

std::array<BoundCorners, 6> facets_of(const BoundHexahedron& h) {
  return {{{h[0], h[1], h[2], h[3]},
           {h[4], h[5], h[6], h[7]},
           {h[0], h[1], h[5], h[4]},
           {h[1], h[2], h[6], h[5]},
           {h[2], h[3], h[7], h[6]},
           {h[3], h[0], h[4], h[7]}}};
}

BoundState::BoundState(std::span<const Quad> quads, bool is_ball)
    : is_ball_(is_ball), boundary_vertices_(quads.size() + 2), vertices_(quads.size() + 2) {
  for (const Quad& quad : quads) {
    BoundCorners corners{};
    for (unsigned i = 0; i < 4; ++i) corners[i] = static_cast<std::uint8_t>(quad[i]);
    add_facet(corners);
  }
  colour_boundary();
}

std::vector<std::uint16_t> BoundState::open_facets() const {
  std::vector<std::uint16_t> open;
  open.reserve(open_count_);
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].is_open) open.push_back(static_cast<std::uint16_t>(f));
  }
  return open;
}

bool BoundState::may_be_edge(std::size_t u, std::size_t v) const noexcept {
  if (is_free(u, v)) return !has(saturated_, u) && !has(saturated_, v);
  // In a ball the hexahedra at an edge follow one another, so there is no place without an open
  // facet.
  return relation_[u][v] == PairRelation::kEdge && (!is_ball_ || open_at_edge_[u][v] > 0);
}

bool BoundState::may_be_diagonal(std::size_t u, std::size_t v) const noexcept {
  return is_free(u, v) || relation_[u][v] == PairRelation::kFacetDiagonal;
}

bool BoundState::may_be_facet(const BoundCorners& corners) const {
  for (unsigned i = 0; i < 2; ++i) {
    const std::size_t u = corners[i];
    const std::size_t v = corners[i + 2];
    if (relation_[u][v] != PairRelation::kFacetDiagonal) continue;
    const BoundFacet& facet = facet_of_diagonal(u, v);
    if (!facet.is_open || !are_one_circle(facet, corners)) return false;
  }
  return true;
}

/// Whether u corner v may be three vertices in a row of a facet of a hexahedron to come, as far as
/// the pair u v tells.
bool BoundState::may_bend(std::size_t u, std::size_t corner, std::size_t v) const {
  if (is_free(u, v)) return true;
  if (relation_[u][v] != PairRelation::kFacetDiagonal) return false;
  const BoundFacet& facet = facet_of_diagonal(u, v);
  return facet.is_open && has(facet.vertices, corner);
}

bool BoundState::may_be_above(std::size_t u, const BoundFacet& facet, unsigned i) const {
  const BoundCorners& corners = facet.corners;
  if (is_ball_ && (has(dark_, u) == has(dark_, corners[i]) || at_[u].open_facets == 0)) {
    return false;
  }
  return !has(facet.vertices, u) && may_be_edge(u, corners[i]) &&
         may_bend(u, corners[i], corners[(i + 1) % 4]) &&
         may_bend(u, corners[i], corners[(i + 3) % 4]) && is_free(u, corners[(i + 2) % 4]);
}

/// Chooses the four tops one after the other.
class BoundState::TopSearch {
 public:
  TopSearch(const BoundState& state, std::size_t facet, const BoundNewVertices& most)
      : state_(state), bottom_(state.facets_[facet].corners), most_(most) {
    for (std::size_t u = 0; u < state.vertices_; ++u) {
      for (unsigned i = 0; i < 4; ++i) {
        if (state.may_be_above(u, state.facets_[facet], i)) {
          above_[i].push_back(static_cast<std::uint8_t>(u));
        }
      }
    }
    if (most.all >= 0 && most.of_colour[0] >= 0 && most.of_colour[1] >= 0) choose(0, most);
  }
  [[nodiscard]] std::vector<BoundCorners> found() && { return std::move(found_); }

 private:
  // A new vertex has no relation to any other, so it is free for all questions to the state.
  void choose(unsigned i, BoundNewVertices left) {
    if (i == 4) {
      found_.push_back(tops_);
      return;
    }
    for (const std::uint8_t u : above_[i]) {
      tops_[i] = u;
      if (agrees(i)) choose(i + 1, left);
    }
    const std::size_t colour = state_.is_dark(bottom_[i]) ? 0 : 1;
    if (left.all == 0 || left.of_colour[colour] == 0 || has(state_.saturated_, bottom_[i])) return;
    tops_[i] = static_cast<std::uint8_t>(state_.vertices_ +
                                         static_cast<std::size_t>(most_.all - left.all));
    --left.all;
    --left.of_colour[colour];
    if (agrees(i)) choose(i + 1, left);
  }

  /// Whether top i agrees with those before it.
  [[nodiscard]] bool agrees(unsigned i) const {
    for (unsigned j = 0; j < i; ++j) {
      if (tops_[j] == tops_[i]) return false;
      if (i - j == 2) {
        if (!state_.may_be_diagonal(tops_[j], tops_[i])) return false;
      } else if (!state_.may_be_edge(tops_[j], tops_[i])) {
        return false;
      }
    }
    return (i == 0 || side_agrees(i - 1)) &&
           (i < 3 || (side_agrees(3) && state_.may_be_facet(tops_)));
  }

  [[nodiscard]] bool side_agrees(unsigned i) const {
    const unsigned next = (i + 1) % 4;
    return state_.may_be_facet({bottom_[i], bottom_[next], tops_[next], tops_[i]});
  }

  const BoundState& state_;
  BoundCorners bottom_;
  BoundNewVertices most_;
  std::array<std::vector<std::uint8_t>, 4> above_;
  BoundCorners tops_{};
  std::vector<BoundCorners> found_;
};

std::vector<BoundCorners> BoundState::tops_on(std::size_t facet,
                                              const BoundNewVertices& most) const {
  return TopSearch(*this, facet, most).found();
}

void BoundState::put(std::size_t facet, const BoundCorners& tops) {
  const BoundCorners b = facets_[facet].corners;
  PlacedHexahedron placed{{b[0], b[1], b[2], b[3], tops[0], tops[1], tops[2], tops[3]},
                          {},
                          vertices_,
                          facets_.size(),
                          related_.size()};
  for (unsigned i = 0; i < 4; ++i) {
    if (tops[i] < vertices_) continue;
    vertices_ = std::size_t{tops[i]} + 1;
    const VertexSet bit = VertexSet{1} << tops[i];
    dark_ = has(dark_, b[i]) ? dark_ & ~bit : dark_ | bit;
  }
  const std::array<BoundCorners, 6> facets = facets_of(placed.vertices);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const std::size_t u = facets[i][0];
    const std::size_t v = facets[i][2];
    if (is_free(u, v)) {
      placed.facets[i] = add_facet(facets[i]);
    } else {
      placed.facets[i] = facet_of_[u][v];
      set_open(placed.facets[i], false);
    }
  }
  for (unsigned i = 0; i < 4; ++i) {
    relate(b[i], tops[(i + 2) % 4], PairRelation::kBodyDiagonal, 0);
  }
  for (const std::uint8_t v : placed.vertices) ++at_[v].hexahedra;
  placed_.push_back(placed);
}

void BoundState::take_back() {
  const PlacedHexahedron& last = placed_.back();
  for (const std::uint8_t v : last.vertices) --at_[v].hexahedra;
  for (const std::uint16_t f : last.facets) {
    const bool was_there = f < last.old_facets;
    set_open(f, was_there);
    if (was_there) continue;
    for (const std::uint8_t v : facets_[f].corners) --at_[v].facets;
  }
  facets_.resize(last.old_facets);
  while (related_.size() > last.old_pairs) unrelate_last();
  vertices_ = last.old_vertices;
  placed_.pop_back();
}

std::uint16_t BoundState::add_facet(const BoundCorners& corners) {
  const std::size_t number = facets_.size();
  facets_.push_back({corners, vertex_set(corners), false});
  for (unsigned i = 0; i < 4; ++i) {
    ++at_[corners[i]].facets;
    relate(corners[i], corners[(i + 1) % 4], PairRelation::kEdge, 0);
  }
  relate(corners[0], corners[2], PairRelation::kFacetDiagonal, number);
  relate(corners[1], corners[3], PairRelation::kFacetDiagonal, number);
  set_open(number, true);
  return static_cast<std::uint16_t>(number);
}

void BoundState::set_open(std::size_t facet, bool is_open) {
  BoundFacet& changed = facets_[facet];
  if (changed.is_open == is_open) return;
  changed.is_open = is_open;
  open_count_ = is_open ? open_count_ + 1 : open_count_ - 1;
  for (unsigned i = 0; i < 4; ++i) {
    const std::size_t u = changed.corners[i];
    const std::size_t v = changed.corners[(i + 1) % 4];
    at_[u].open_facets += is_open ? 1 : -1;
    for (std::uint8_t* count : {&open_at_edge_[u][v], &open_at_edge_[v][u]}) {
      *count = static_cast<std::uint8_t>(is_open ? *count + 1 : *count - 1);
    }
  }
}

void BoundState::relate(std::size_t u, std::size_t v, PairRelation relation, std::size_t facet) {
  if (!is_free(u, v)) return;
  relation_[u][v] = relation_[v][u] = relation;
  facet_of_[u][v] = facet_of_[v][u] = static_cast<std::uint16_t>(facet);
  related_.emplace_back(static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(v));
  if (relation != PairRelation::kEdge) return;
  ++edges_;
  ++at_[u].edges;
  ++at_[v].edges;
}

void BoundState::unrelate_last() {
  const auto [u, v] = related_.back();
  related_.pop_back();
  if (relation_[u][v] == PairRelation::kEdge) {
    --edges_;
    --at_[u].edges;
    --at_[v].edges;
  }
  relation_[u][v] = relation_[v][u] = PairRelation::kFree;
}

void BoundState::colour_boundary() {
  std::vector<std::size_t> reached = {0};
  VertexSet seen = 1;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::size_t u = reached[i];
    for (std::size_t v = 0; v < boundary_vertices_; ++v) {
      if (relation_[u][v] != PairRelation::kEdge || has(seen, v)) continue;
      seen |= VertexSet{1} << v;
      if (!has(dark_, u)) dark_ |= VertexSet{1} << v;
      reached.push_back(v);
    }
  }
}

}  // namespace hexatlas::check
