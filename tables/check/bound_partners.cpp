#include "tables/check/bound_partners.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "tables/check/bound_rules.hpp"

namespace hexatlas::check {

namespace {

/// What is known of a vertex with open facets, whatever is saturated.
struct Seeker {
  std::size_t vertex = 0;
  std::size_t colour = 0;
  int links = 0;
  int missing = 0;  ///< s of the format
  int least = 0;    ///< edges to come, at least: an interior vertex is in four hexahedra
  // Strangers: they share no hexahedron and no quad with it, and have open facets.
  VertexSet of_other_colour = 0;
  int of_same_colour = 0;
};

Seeker seeker_at(const BoundState& state, std::size_t v) {
  const VertexCounts& at = state.at(v);
  Seeker seeker{v, state.is_dark(v) ? 1U : 0U, at.open_facets, 2 - euler_at(state, v)};
  if (state.is_interior(v)) {
    const int without = at.hexahedra + at.open_facets - 2 * seeker.missing;
    seeker.least = std::max(0, (4 - without + 1) / 2);
  }
  for (std::size_t u = 0; u < state.vertices(); ++u) {
    if (u == v || !state.is_free(u, v) || state.at(u).open_facets == 0) continue;
    if (state.is_dark(u) == state.is_dark(v)) {
      ++seeker.of_same_colour;
    } else {
      seeker.of_other_colour |= VertexSet{1} << u;
    }
  }
  return seeker;
}

/// Whether so many edges to come are possible.
bool has_partners(const Seeker& seeker, int edges, VertexSet saturated,
                  const BoundNewVertices& may_come) {
  const bool is_saturated = (saturated >> seeker.vertex & 1U) != 0;
  if (is_saturated && edges > 0) return false;
  const int hexahedra = seeker.links - 2 * seeker.missing + 2 * edges;
  const int facets = seeker.links - 3 * seeker.missing + 3 * edges;
  const int ends = std::popcount(seeker.of_other_colour & ~saturated);
  const int others = std::popcount(seeker.of_other_colour);
  return std::max({0, is_saturated ? 0 : edges - ends, hexahedra + edges - others}) <=
             may_come.of_colour[1 - seeker.colour] &&
         std::max(0, facets - seeker.of_same_colour) <= may_come.of_colour[seeker.colour];
}

}  // namespace

BoundPartners partners_of(const BoundState& state, const BoundNewVertices& may_come) {
  std::vector<Seeker> seekers;
  for (std::size_t v = 0; v < state.vertices(); ++v) {
    if (state.at(v).open_facets > 0) seekers.push_back(seeker_at(state, v));
  }
  BoundPartners partners{false, state.saturated()};
  for (VertexSet before = ~partners.saturated; before != partners.saturated;) {
    before = partners.saturated;
    partners.are_too_few = false;
    for (const Seeker& seeker : seekers) {
      if (!has_partners(seeker, seeker.least, before, may_come)) partners.are_too_few = true;
      if (seeker.least == 0 && !has_partners(seeker, 1, before, may_come))
        partners.saturated |= VertexSet{1} << seeker.vertex;
    }
  }
  return partners;
}

}  // namespace hexatlas::check
