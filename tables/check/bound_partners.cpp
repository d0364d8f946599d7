#include "tables/check/bound_partners.hpp"

#include <algorithm>
#include <bit>

#include "tables/check/bound_rules.hpp"

namespace hexatlas::check {

namespace {

/// The vertices that v shares no hexahedron and no quad with, and that have open facets.
struct Strangers {
  VertexSet of_other_colour = 0;
  int of_same_colour = 0;
};

Strangers strangers_of(const BoundState& state, std::size_t v) {
  Strangers strangers;
  for (std::size_t u = 0; u < state.vertices(); ++u) {
    if (u == v || !state.is_free(u, v) || state.at(u).open_facets == 0) continue;
    if (state.is_dark(u) == state.is_dark(v)) {
      ++strangers.of_same_colour;
    } else {
      strangers.of_other_colour |= VertexSet{1} << u;
    }
  }
  return strangers;
}

/// Whether `edges` edges to come at v are possible.
bool has_partners(const BoundState& state, std::size_t v, int edges, VertexSet saturated,
                  const BoundNewVertices& may_come) {
  const bool is_saturated = (saturated >> v & 1U) != 0;
  if (is_saturated && edges > 0) return false;
  const Strangers strangers = strangers_of(state, v);
  const int links = state.at(v).open_facets;
  const int missing = 2 - euler_at(state, v);
  const int hexahedra = links - 2 * missing + 2 * edges;
  const int facets = links - 3 * missing + 3 * edges;
  const int ends = std::popcount(strangers.of_other_colour & ~saturated);
  const int others = std::popcount(strangers.of_other_colour);
  const std::size_t own = state.is_dark(v) ? 1 : 0;
  return std::max({0, is_saturated ? 0 : edges - ends, hexahedra + edges - others}) <=
             may_come.of_colour[1 - own] &&
         std::max(0, facets - strangers.of_same_colour) <= may_come.of_colour[own];
}

/// Edges to come at v, at least: an interior vertex is in four hexahedra.
int least_edges(const BoundState& state, std::size_t v) {
  if (!state.is_interior(v)) return 0;
  const VertexCounts& at = state.at(v);
  const int without = at.hexahedra + at.open_facets - 2 * (2 - euler_at(state, v));
  return std::max(0, (4 - without + 1) / 2);
}

}  // namespace

BoundPartners partners_of(const BoundState& state, const BoundNewVertices& may_come) {
  BoundPartners partners{false, state.saturated()};
  for (VertexSet before = ~partners.saturated; before != partners.saturated;) {
    before = partners.saturated;
    partners.are_too_few = false;
    for (std::size_t v = 0; v < state.vertices(); ++v) {
      if (state.at(v).open_facets == 0) continue;
      const int least = least_edges(state, v);
      if (!has_partners(state, v, least, before, may_come)) partners.are_too_few = true;
      if (least == 0 && !has_partners(state, v, 1, before, may_come))
        partners.saturated |= VertexSet{1} << v;
    }
  }
  return partners;
}

}  // namespace hexatlas::check
