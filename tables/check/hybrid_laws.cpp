#include "tables/check/hybrid_laws.hpp"

#include <algorithm>

#include "tables/check/disjoint_sets.hpp"
#include "tables/check/incidence.hpp"

namespace hexatlas::check {

namespace {

std::string facet_text(const FacetCycle& cycle) {
  return (size_of(cycle) == 3 ? "triangle " : "quad ") +
         listed(std::span(cycle).first(size_of(cycle)));
}

/// The least vertex first, in the same direction.
FacetCycle least_first(FacetCycle cycle) {
  const auto end = cycle.begin() + static_cast<std::ptrdiff_t>(size_of(cycle));
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), end), end);
  return cycle;
}

FacetCycle reversed(FacetCycle cycle) {
  std::reverse(cycle.begin() + 1, cycle.begin() + static_cast<std::ptrdiff_t>(size_of(cycle)));
  return cycle;
}

/// A facet with its vertices in ascending order, by which facets of two cells find each other.
struct SortedFacet {
  FacetCycle vertices;
  FacetPlace place;
};

std::vector<SortedFacet> sorted_facets(const std::vector<HybridCell>& cells) {
  std::vector<SortedFacet> all;
  std::size_t count = 0;
  for (const HybridCell& cell : cells) count += facets_of(cell.shape).size();
  all.reserve(count);
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    for (std::uint8_t f = 0; f < facets_of(cells[c].shape).size(); ++f) {
      FacetCycle vertices = cycle_at(cells, {c, f});
      std::sort(vertices.begin(), vertices.end());
      all.push_back({vertices, {c, f}});
    }
  }
  std::sort(all.begin(), all.end(), [](const SortedFacet& a, const SortedFacet& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.place.cell < b.place.cell;
  });
  return all;
}

HybridFinding check_pair(const std::vector<HybridCell>& cells, FacetPlace a, FacetPlace b) {
  const FacetCycle first = least_first(cycle_at(cells, a));
  const FacetCycle second = least_first(cycle_at(cells, b));
  if (first == reversed(second)) return std::nullopt;
  const std::string both = name_of(cells[a.cell]) + " and " + name_of(cells[b.cell]);
  if (first == second) {
    return HybridFailure{HybridLaw::kOppositeSides,
                         both + " are on the same side of their " + facet_text(first)};
  }
  return HybridFailure{HybridLaw::kSameCycle,
                       both + " have quads of the same vertices in different cyclic orders, " +
                           facet_text(first) + " and " + facet_text(second)};
}

using Edge = std::array<std::uint32_t, 2>;

std::vector<Edge> edges_of_cells(const std::vector<HybridCell>& cells) {
  std::vector<Edge> edges;
  for (const HybridCell& cell : cells) {
    for (const EdgePlaces& edge : edges_of(cell.shape)) {
      const Edge ends = {cell.vertices[edge.v], cell.vertices[edge.w]};
      if (ends[0] < ends[1]) edges.push_back(ends);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// A cell at an edge (EdgePlaces), by the numbers of vertices.
struct Wedge {
  Edge edge;
  std::uint32_t from, to;
  std::uint32_t cell;
};

/// Those of each edge follow each other, the edge seen from its lesser end or from the greater one.
std::vector<Wedge> sorted_wedges(const std::vector<HybridCell>& cells, bool from_lesser_end) {
  std::vector<Wedge> wedges;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    const auto& v = cells[c].vertices;
    for (const EdgePlaces& edge : edges_of(cells[c].shape)) {
      if ((v[edge.v] < v[edge.w]) != from_lesser_end) continue;
      wedges.push_back({{v[edge.v], v[edge.w]}, v[edge.from], v[edge.to], c});
    }
  }
  std::sort(wedges.begin(), wedges.end(), [](const Wedge& a, const Wedge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.cell < b.cell;
  });
  return wedges;
}

/// Whether the half-plane from the edge through x is in the wedge, of which the first half-plane is
/// a part and the last one is not. The angle of the wedge is less than pi, as the cell is positive.
bool contains(const Wedge& wedge, std::uint32_t x, const std::vector<Point>& points, Signs& signs) {
  if (x == wedge.to) return false;
  const auto side_of = [&](std::uint32_t vertex) {
    return signs.orientation(points[wedge.edge[0]], points[wedge.edge[1]], points[vertex],
                             points[x]);
  };
  return side_of(wedge.from) >= 0 && side_of(wedge.to) < 0;
}

/// Whether each wedge begins where another one ends, in one cycle through all of them. Then each
/// half-plane is in as many of them as the cycle winds around the edge.
bool are_a_cycle(std::span<const Wedge> wedges) {
  std::vector<bool> passed(wedges.size(), false);
  std::size_t at = 0;
  for (std::size_t count = 0; count < wedges.size(); ++count) {
    passed[at] = true;
    std::size_t next = 0;
    while (next < wedges.size() && wedges[next].from != wedges[at].to) ++next;
    if (next == wedges.size() || (passed[next] && count + 1 < wedges.size())) return false;
    at = next;
  }
  return at == 0;
}

/// Two of the wedges around one edge that overlap at its end. Of two such wedges, one contains the
/// first half-plane of the other; in a cycle, one half-plane tells.
HybridFinding overlap_of(std::span<const Wedge> wedges, bool is_cycle,
                         const std::vector<HybridCell>& cells, const std::vector<Point>& points,
                         Signs& signs) {
  for (const Wedge& one : wedges) {
    for (const Wedge& other : wedges.first(is_cycle ? 1 : wedges.size())) {
      if (one.cell == other.cell || !contains(one, other.from, points, signs)) continue;
      return HybridFailure{HybridLaw::kAroundEdge,
                           name_of(cells[one.cell]) + " and " + name_of(cells[other.cell]) +
                               " overlap around their edge " + listed(one.edge)};
    }
  }
  return std::nullopt;
}

/// How often a cycle winds around its edge is the same from both ends.
HybridFinding check_at_ends(const std::vector<Wedge>& wedges, const std::vector<HybridCell>& cells,
                            const std::vector<Point>& points, Signs& signs, bool with_cycles) {
  for (std::size_t first = 0, end = 0; first < wedges.size(); first = end) {
    while (end < wedges.size() && wedges[end].edge == wedges[first].edge) ++end;
    const std::span around = std::span(wedges).subspan(first, end - first);
    const bool is_cycle = are_a_cycle(around);
    if (is_cycle && !with_cycles) continue;
    if (HybridFinding found = overlap_of(around, is_cycle, cells, points, signs)) return found;
  }
  return std::nullopt;
}

}  // namespace

FacetCycle cycle_at(const std::vector<HybridCell>& cells, FacetPlace place) {
  const HybridCell& cell = cells[place.cell];
  const FacetPlaces& facet = facets_of(cell.shape)[place.facet];
  FacetCycle cycle{kNoVertex, kNoVertex, kNoVertex, kNoVertex};
  for (std::size_t i = 0; i < facet.size; ++i) cycle[i] = cell.vertices[facet.at[i]];
  return cycle;
}

HybridFinding check_corners(const std::vector<HybridCell>& cells, std::uint64_t points) {
  if (cells.empty()) return HybridFailure{HybridLaw::kCorners, "there are no cells"};
  for (const HybridCell& cell : cells) {
    std::vector<std::uint32_t> sorted(cell.corners().begin(), cell.corners().end());
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= points) {
      return HybridFailure{HybridLaw::kCorners, name_of(cell) +
                                                    " has a vertex that is not among the " +
                                                    std::to_string(points) + " points"};
    }
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
      return HybridFailure{HybridLaw::kCorners, name_of(cell) + " has a vertex twice"};
    }
  }
  return std::nullopt;
}

HybridFinding check_positive(const std::vector<HybridCell>& cells, const std::vector<Point>& points,
                             Signs& signs, std::optional<std::uint32_t>& open) {
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    const JacobianSign sign = jacobian_sign(cells[c], points, signs);
    if (sign == JacobianSign::kUnknown && !open) open = c;
    if (sign != JacobianSign::kNotPositive) continue;
    return HybridFailure{HybridLaw::kPositive,
                         name_of(cells[c]) + " has no positive Jacobian determinant everywhere"};
  }
  return std::nullopt;
}

HybridFinding check_facets(const std::vector<HybridCell>& cells, HybridFacets& facets) {
  const std::vector<SortedFacet> all = sorted_facets(cells);
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    while (end < all.size() && all[end].vertices == all[i].vertices) ++end;
    if (end - i > 2) {
      return HybridFailure{HybridLaw::kTwoCells, facet_text(cycle_at(cells, all[i].place)) +
                                                     " lies in " + std::to_string(end - i) +
                                                     " cells"};
    }
    if (end - i == 1) {
      facets.boundary.push_back(all[i].place);
      continue;
    }
    const FacetPlace first = all[i].place;
    const FacetPlace second = all[i + 1].place;
    if (HybridFinding found = check_pair(cells, first, second)) return found;
    facets.interior.emplace_back(first, second);
  }
  return std::nullopt;
}

HybridFinding check_diagonals(const std::vector<HybridCell>& cells, const HybridFacets& facets) {
  const std::vector<Edge> edges = edges_of_cells(cells);
  const auto check = [&](FacetPlace place) -> HybridFinding {
    const FacetCycle cycle = cycle_at(cells, place);
    if (size_of(cycle) == 3) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [low, high] = std::minmax(cycle[i], cycle[i + 2]);
      const Edge diagonal = {low, high};
      if (!std::binary_search(edges.begin(), edges.end(), diagonal)) continue;
      return HybridFailure{HybridLaw::kDiagonal, "edge " + listed(diagonal) + " is a diagonal of " +
                                                     facet_text(cycle) + " of " +
                                                     name_of(cells[place.cell])};
    }
    return std::nullopt;
  };
  for (const auto& [first, second] : facets.interior) {
    if (HybridFinding found = check(first)) return found;
  }
  for (const FacetPlace place : facets.boundary) {
    if (HybridFinding found = check(place)) return found;
  }
  return std::nullopt;
}

HybridFinding check_around_edges(const std::vector<HybridCell>& cells,
                                 const std::vector<Point>& points, Signs& signs) {
  for (const bool from_lesser_end : {true, false})
    if (HybridFinding found = check_at_ends(sorted_wedges(cells, from_lesser_end), cells, points,
                                            signs, from_lesser_end))
      return found;
  return std::nullopt;
}

HybridFinding check_around_vertices(const std::vector<HybridCell>& cells,
                                    const HybridFacets& facets, std::uint64_t points) {
  std::vector<std::size_t> first_corner(cells.size() + 1, 0);
  std::vector<std::uint32_t> parts(points, 0);  // of the cells at a vertex
  for (std::size_t c = 0; c < cells.size(); ++c) {
    first_corner[c + 1] = first_corner[c] + cells[c].corners().size();
    for (const std::uint32_t vertex : cells[c].corners()) ++parts[vertex];
  }
  const auto corner_of = [&](std::uint32_t cell, std::uint32_t vertex) {
    const auto corners = cells[cell].corners();
    return first_corner[cell] +
           static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) -
                                    corners.begin());
  };
  DisjointSets sets(first_corner.back());
  for (const auto& [a, b] : facets.interior) {
    const FacetCycle cycle = cycle_at(cells, a);
    for (std::size_t i = 0; i < size_of(cycle); ++i) {
      if (sets.unite(corner_of(a.cell, cycle[i]), corner_of(b.cell, cycle[i]))) --parts[cycle[i]];
    }
  }
  for (const FacetPlace place : facets.boundary) {
    const FacetCycle cycle = cycle_at(cells, place);
    for (std::size_t i = 0; i < size_of(cycle); ++i) parts[cycle[i]] = 1;
  }
  const auto crowded =
      std::find_if(parts.begin(), parts.end(), [](std::uint32_t count) { return count > 1; });
  if (crowded == parts.end()) return std::nullopt;
  return HybridFailure{HybridLaw::kAroundVertex, "the cells at the inner vertex " +
                                                     std::to_string(crowded - parts.begin()) +
                                                     " form " + std::to_string(*crowded) +
                                                     " parts that share no facet there"};
}

std::vector<FacetCycle> boundary_of(const std::vector<HybridCell>& cells,
                                    const HybridFacets& facets) {
  std::vector<FacetCycle> cycles;
  cycles.reserve(facets.boundary.size());
  for (const FacetPlace place : facets.boundary) cycles.push_back(cycle_at(cells, place));
  return cycles;
}

}  // namespace hexatlas::check
