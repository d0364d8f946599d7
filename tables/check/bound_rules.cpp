#include "tables/check/bound_rules.hpp"

#include <algorithm>
#include <bit>
#include <bitset>
#include <optional>

#include "tables/check/disjoint_sets.hpp"

namespace hexatlas::check {

namespace {

/// Facet i of a state is bit i; a state has at most 62 quads and five more facets for each of 64
/// hexahedra.
using FacetBits = std::bitset<384>;

unsigned place_of(const BoundFacet& facet, std::size_t v) {
  unsigned i = 0;
  while (facet.corners[i] != v) ++i;
  return i;
}

struct CommonEdge {
  std::uint8_t u = 0;
  std::uint8_t v = 0;
};

bool are_neighbours(const BoundFacet& f, std::size_t u, std::size_t v) {
  return (place_of(f, u) + place_of(f, v)) % 2 == 1;
}

std::optional<CommonEdge> common_edge(const BoundFacet& f, const BoundFacet& g) {
  const VertexSet common = f.vertices & g.vertices;
  if (std::popcount(common) != 2) return std::nullopt;
  const auto u = static_cast<std::uint8_t>(std::countr_zero(common));
  const auto v = static_cast<std::uint8_t>(std::countr_zero(common & (common - 1)));
  if (!are_neighbours(f, u, v) || !are_neighbours(g, u, v)) return std::nullopt;
  return CommonEdge{u, v};
}

/// The neighbour of v in the facet that is not u, a neighbour too.
std::uint8_t other_neighbour(const BoundFacet& facet, std::size_t v, std::size_t u) {
  const unsigned i = place_of(facet, v);
  const std::uint8_t next = facet.corners[(i + 1) % 4];
  return next == u ? facet.corners[(i + 3) % 4] : next;
}

/// a b are opposite in the facet at v of a hexahedron to come.
bool may_be_opposite_at(const BoundState& state, std::size_t a, std::size_t b, std::size_t v) {
  if (state.relation(a, b) != PairRelation::kFacetDiagonal) return true;
  const BoundFacet& facet = state.facet_of_diagonal(a, b);
  return facet.is_open && (facet.vertices >> v & 1U) != 0;
}

bool fit_at_edge(const BoundState& state, const BoundFacet& f, const BoundFacet& g,
                 const CommonEdge& edge) {
  const auto [u, v] = edge;
  const std::uint8_t x = other_neighbour(f, v, u);
  const std::uint8_t y = other_neighbour(f, u, v);
  const std::uint8_t z = other_neighbour(g, v, u);
  const std::uint8_t w = other_neighbour(g, u, v);
  return state.may_be_above(z, f, place_of(f, v)) && state.may_be_above(w, f, place_of(f, u)) &&
         may_be_opposite_at(state, x, z, v) && may_be_opposite_at(state, y, w, u);
}

/// Whether one of the eight ways puts g above f.
bool may_be_opposite(const BoundState& state, const BoundFacet& f, const BoundFacet& g) {
  for (unsigned first = 0; first < 4; ++first) {
    for (const unsigned step : {1U, 3U}) {
      bool fits = true;
      for (unsigned i = 0; i < 4 && fits; ++i) {
        fits = state.may_be_above(g.corners[(first + step * i) % 4], f, i);
      }
      if (fits) return true;
    }
  }
  return false;
}

/// Two open facets, by their places, that fit across a common edge.
struct Ear {
  std::uint16_t f = 0;
  std::uint16_t g = 0;
  CommonEdge edge;
};

struct FacetPairs {
  std::vector<Ear> ears;
  int lone_misfits = 0;  ///< edges with two open facets only, which do not fit across it
};

FacetPairs pairs_of(const BoundState& state, const std::vector<std::uint16_t>& open) {
  FacetPairs pairs;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const BoundFacet& f = state.facets()[open[i]];
    for (std::size_t j = 0; j < i; ++j) {
      const BoundFacet& g = state.facets()[open[j]];
      const std::optional<CommonEdge> edge = common_edge(f, g);
      if (!edge) continue;
      if (fit_at_edge(state, f, g, *edge)) {
        pairs.ears.push_back({open[i], open[j], *edge});
      } else if (state.open_at_edge(edge->u, edge->v) == 2) {
        ++pairs.lone_misfits;
      }
    }
  }
  return pairs;
}

bool are_disjoint(const Ear& a, const Ear& b) {
  return a.f != b.f && a.f != b.g && a.g != b.f && a.g != b.g;
}

/// p of the format: the most parts of the link to come that are trees of triangles. Such a part is
/// one triangle, with three ears, or has two leaves, each of which is an ear of its own.
int most_tree_parts(const std::vector<Ear>& ears) {
  for (std::size_t i = 0; i < ears.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (are_disjoint(ears[i], ears[j])) return static_cast<int>(ears.size() / 2);
    }
  }
  // Ears that meet pairwise are three between three facets, or all have one facet in common.
  if (ears.size() != 3) return 0;
  const auto has_facet = [&ears](std::uint16_t f) {
    return std::all_of(ears.begin(), ears.end(),
                       [f](const Ear& ear) { return ear.f == f || ear.g == f; });
  };
  return has_facet(ears[0].f) || has_facet(ears[0].g) ? 0 : 1;
}

/// For each edge with open facets the places of these.
std::vector<std::vector<std::uint16_t>> open_edges(const BoundState& state,
                                                   const std::vector<std::uint16_t>& open) {
  std::vector<std::vector<std::uint16_t>> edges;
  std::array<std::array<std::uint16_t, kMostBoundVertices>, kMostBoundVertices> number{};  // from 1
  for (std::size_t i = 0; i < open.size(); ++i) {
    const BoundCorners& corners = state.facets()[open[i]].corners;
    for (unsigned j = 0; j < 4; ++j) {
      const auto [u, v] = std::minmax(corners[j], corners[(j + 1) % 4]);
      if (number[u][v] == 0) {
        edges.emplace_back();
        number[u][v] = static_cast<std::uint16_t>(edges.size());
      }
      edges[number[u][v] - 1U].push_back(static_cast<std::uint16_t>(i));
    }
  }
  return edges;
}

/// Modulo 2, by elimination.
int rank_of(std::vector<FacetBits> equations, std::size_t unknowns) {
  int rank = 0;
  for (std::size_t i = 0; i < unknowns; ++i) {
    const auto first = equations.begin() + rank;
    const auto pivot =
        std::find_if(first, equations.end(), [i](const FacetBits& bits) { return bits[i]; });
    if (pivot == equations.end()) continue;
    std::iter_swap(first, pivot);
    for (auto other = first + 1; other != equations.end(); ++other) {
      if ((*other)[i]) *other ^= *first;
    }
    ++rank;
  }
  return rank;
}

/// The dimension of the space of cycles of the graph with an edge for each open facet at v.
int cycles_at(const BoundState& state, const std::vector<std::uint16_t>& open, std::size_t v) {
  VertexSet neighbours = 0;
  std::vector<VertexSet> parts;
  for (const std::uint16_t number : open) {
    const BoundFacet& facet = state.facets()[number];
    if ((facet.vertices >> v & 1U) == 0) continue;
    const unsigned i = place_of(facet, v);
    VertexSet part = VertexSet{1} << facet.corners[(i + 1) % 4];
    part |= VertexSet{1} << facet.corners[(i + 3) % 4];
    neighbours |= part;
    std::erase_if(parts, [&part](VertexSet other) {
      const bool meets = (part & other) != 0;
      if (meets) part |= other;
      return meets;
    });
    parts.push_back(part);
  }
  return state.at(v).open_facets - std::popcount(neighbours) + static_cast<int>(parts.size());
}

/// s of the format.
int savings_at(const BoundState& state, const std::vector<std::uint16_t>& open, std::size_t v) {
  if (state.is_ball()) return 2 - euler_at(state, v);
  const int links = state.at(v).open_facets;
  return links < 6 ? links / 3 : std::min(links / 3, cycles_at(state, open, v));
}

int corners_due(const BoundState& state, const std::vector<std::uint16_t>& open,
                const std::vector<Ear>& ears) {
  int due = 0;
  std::vector<Ear> own;
  for (std::size_t v = 0; v < state.vertices(); ++v) {
    const VertexCounts& at = state.at(v);
    int due_here = 0;
    if (at.open_facets > 0) {
      own.clear();
      for (const Ear& ear : ears) {
        if (ear.edge.u == v || ear.edge.v == v) own.push_back(ear);
      }
      due_here = at.open_facets - 2 * std::min(savings_at(state, open, v), most_tree_parts(own));
    }
    due += state.is_interior(v) ? std::max(due_here, 4 - at.hexahedra) : due_here;
  }
  return due;
}

/// The greatest integer that is at most the fraction; the denominator is positive.
int floor_of(int numerator, int denominator) {
  const int quotient = numerator / denominator;
  return numerator % denominator < 0 ? quotient - 1 : quotient;
}

/// In every ball the numbers of new vertices of the two colours differ by `surplus`.
BoundNewVertices balanced(int all, int surplus) {
  const int dark = floor_of(all - surplus, 2);
  return {2 * dark + surplus, {dark + surplus, dark}};
}

}  // namespace

int euler_at(const BoundState& state, std::size_t v) {
  const VertexCounts& at = state.at(v);
  return at.edges - at.facets + at.hexahedra + (state.is_interior(v) ? 0 : 1);
}

bool fit_across(const BoundState& state, const BoundFacet& f, const BoundFacet& g) {
  const std::optional<CommonEdge> edge = common_edge(f, g);
  return edge && fit_at_edge(state, f, g, *edge);
}

bool are_apart(const BoundState& state, const BoundFacet& f, const BoundFacet& g) {
  if ((f.vertices & g.vertices) == 0) return !may_be_opposite(state, f, g);
  return !fit_across(state, f, g);
}

int cycle_dimension(const BoundState& state) {
  const std::vector<std::uint16_t> open = state.open_facets();
  const std::vector<std::vector<std::uint16_t>> edges = open_edges(state, open);
  if (std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.size() == 2; })) {
    // With a facet the set has all that are reached from it across edges.
    DisjointSets components(open.size());
    for (const auto& edge : edges) components.unite(edge[0], edge[1]);
    return static_cast<int>(components.sets());
  }
  std::vector<FacetBits> equations(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const std::uint16_t facet : edges[e]) equations[e].set(facet);
  }
  return static_cast<int>(open.size()) - rank_of(std::move(equations), open.size());
}

bool exceeds_face_budget(const BoundState& state, int left) {
  const auto open = static_cast<int>(state.open_count());
  return open > 4 * left + 2 * std::min(left, open / 6) ||
         open > 4 * left + 2 * cycle_dimension(state);
}

int room_of(const BoundState& state, int left) {
  const std::vector<std::uint16_t> open = state.open_facets();
  const FacetPairs pairs = pairs_of(state, open);
  const int by_corners = floor_of(8 * left - corners_due(state, open, pairs.ears), 4);
  if (!state.is_ball()) return by_corners;
  const auto size = [](std::size_t count) { return static_cast<int>(count); };
  const int euler = size(state.vertices()) - size(state.edges()) + size(state.facets().size()) -
                    size(state.hexahedra().size()) - 1;
  // Twice the numerator of the format, as the number of open facets may be odd.
  const int by_edges =
      floor_of(12 * left - size(open.size()) - 6 * euler - 2 * pairs.lone_misfits, 6);
  return std::min(by_corners, by_edges);
}

BoundNewVertices may_come(const BoundState& state, int interior) {
  const auto there = static_cast<int>(state.vertices() - state.boundary_vertices());
  if (!state.is_ball()) return {interior - there};
  // Half of the boundary's, and those inside, that are dark, less those that are light.
  int halves = 0;
  int inside = 0;
  for (std::size_t v = 0; v < state.vertices(); ++v) {
    (state.is_interior(v) ? inside : halves) += state.is_dark(v) ? 1 : -1;
  }
  const BoundNewVertices in_all = balanced(interior, halves / 2);
  const int dark = in_all.of_colour[1] - (there + inside) / 2;
  const int light = in_all.of_colour[0] - (there - inside) / 2;
  return {light + dark, {light, dark}};
}

BoundNewVertices within_room(const BoundState& state, int interior, int left) {
  BoundNewVertices may = may_come(state, interior);
  const int all = std::min(may.all, room_of(state, left));
  if (state.is_ball()) return balanced(all, may.of_colour[0] - may.of_colour[1]);
  may.all = all;
  return may;
}

bool is_negative(const BoundNewVertices& number) noexcept {
  return number.all < 0 || number.of_colour[0] < 0 || number.of_colour[1] < 0;
}

bool has_bad_link(const BoundState& state) {
  if (!state.is_ball() || state.hexahedra().empty()) return false;
  const BoundHexahedron& last = state.hexahedra().back().vertices;
  return std::any_of(last.begin(), last.end(), [&state](std::uint8_t v) {
    const int missing = 2 - euler_at(state, v);
    const int links = state.at(v).open_facets;
    return links == 0 ? missing != 0 : 3 * missing > links;
  });
}

}  // namespace hexatlas::check
