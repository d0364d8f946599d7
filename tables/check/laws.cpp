#include "tables/check/laws.hpp"

#include <algorithm>
#include <bit>

#include "tables/check/disjoint_sets.hpp"

namespace hexatlas::check {

namespace {

std::string hexahedra(std::uint32_t a, std::uint32_t b) {
  return "hexahedra " + std::to_string(a) + " and " + std::to_string(b);
}

/// Corners of two hexahedra that are the same vertices.
struct Shared {
  std::size_t count = 0;
  std::array<unsigned, 8> in_a = {};
  std::array<unsigned, 8> in_b = {};
};

Shared shared_corners(const Hexahedron& a, const Hexahedron& b) {
  Shared shared;
  for (unsigned i = 0; i < 8; ++i) {
    for (unsigned j = 0; j < 8; ++j) {
      if (a[i] != b[j]) continue;
      shared.in_a[shared.count] = i;
      shared.in_b[shared.count++] = j;
    }
  }
  return shared;
}

bool are_quad_corners(const std::array<unsigned, 8>& corners) {
  unsigned all = 7;
  unsigned any = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    all &= kCornerBits[corners[i]];
    any |= kCornerBits[corners[i]];
  }
  return std::popcount(all | (~any & 7U)) == 1;
}

bool same_cyclic_order(const Shared& shared) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (are_adjacent_corners(shared.in_a[i], shared.in_a[j]) !=
          are_adjacent_corners(shared.in_b[i], shared.in_b[j])) {
        return false;
      }
    }
  }
  return true;
}

/// What is wrong with the intersection of two hexahedra, or nothing.
std::string broken_meeting(const Shared& shared) {
  if (shared.count <= 1) return {};
  if (shared.count == 2) {
    const bool edge_of_a = are_adjacent_corners(shared.in_a[0], shared.in_a[1]);
    const bool edge_of_b = are_adjacent_corners(shared.in_b[0], shared.in_b[1]);
    return edge_of_a && edge_of_b ? "" : "two vertices that are not an edge of both";
  }
  if (shared.count == 4 && are_quad_corners(shared.in_a) && are_quad_corners(shared.in_b)) {
    return same_cyclic_order(shared) ? "" : "the vertices of a quad in two cyclic orders";
  }
  return std::to_string(shared.count) + " vertices that are not one quad of both";
}

/// What the hexahedra at one vertex say of another one.
struct Seen {
  std::uint32_t from = 0;  ///< the vertex and one more: what older ones said no longer counts
  bool is_edge = false;
  std::uint32_t diagonals = 0;
  std::uint32_t cell = 0;  ///< the first one with a diagonal
};

/// Whether the strict rule holds, without a look at each two hexahedra at a vertex, which are too
/// many where the vertex has a high degree. Two hexahedra that share three vertices share a
/// diagonal of the first, since three corners of a cube are never all adjacent; two that share two
/// vertices meet in an edge of both, or share a diagonal of one of them. So those that share a
/// diagonal of one are all that need a look, if no diagonal of one is an edge of another.
class StrictRule {
 public:
  explicit StrictRule(const Incidence& incidence)
      : incidence_(incidence), seen_(incidence.vertex_count) {}

  bool holds() {
    for (std::uint32_t v = 0; v < incidence_.vertex_count; ++v) {
      if (!holds_at(v)) return false;
    }
    return true;
  }

 private:
  bool holds_at(std::uint32_t v) {
    for (const std::uint32_t c : incidence_.cells_at[v]) {
      const Hexahedron& cell = incidence_.cells[c];
      for (const unsigned end : kCornerNeighbours[corner_at(cell, v)])
        of(cell[end], v).is_edge = true;
    }
    for (const std::uint32_t c : incidence_.cells_at[v]) {
      const Hexahedron& cell = incidence_.cells[c];
      for (const unsigned end : kCornerOpposites[corner_at(cell, v)]) {
        if (cell[end] > v && !may_be_diagonal(of(cell[end], v), c)) return false;
      }
    }
    return true;
  }

  Seen& of(std::uint32_t other, std::uint32_t v) {
    Seen& seen = seen_[other];
    if (seen.from != v + 1) seen = {.from = v + 1};
    return seen;
  }

  /// A diagonal of three hexahedra is refused, too: their quad lies in two.
  bool may_be_diagonal(Seen& seen, std::uint32_t c) {
    if (seen.is_edge || seen.diagonals == 2) return false;
    if (++seen.diagonals == 1) {
      seen.cell = c;
      return true;
    }
    return broken_meeting(shared_corners(incidence_.cells[seen.cell], incidence_.cells[c])).empty();
  }

  const Incidence& incidence_;
  std::vector<Seen> seen_;
};

}  // namespace

Finding check_corners(std::span<const Hexahedron> cells, std::uint64_t vertex_count) {
  if (cells.empty()) return Failure{Law::kCorners, "there are no hexahedra"};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Hexahedron sorted = cells[c];
    std::sort(sorted.begin(), sorted.end());
    const auto* const twice = std::adjacent_find(sorted.begin(), sorted.end());
    const std::string name = "hexahedron " + std::to_string(c);
    if (sorted.back() >= vertex_count) {
      return Failure{Law::kCorners, name + " has vertex " + std::to_string(sorted.back()) +
                                        ", which is not among the points"};
    }
    if (twice != sorted.end()) {
      return Failure{Law::kCorners, name + " has vertex " + std::to_string(*twice) + " twice"};
    }
  }
  return std::nullopt;
}

Finding check_two_hexahedra(const Incidence& incidence) {
  for (const Facet& facet : incidence.facets) {
    if (facet.uses <= 2) continue;
    return Failure{Law::kTwoHexahedra, "quad " + listed(incidence.quad_at(facet.place[0])) +
                                           " lies in " + std::to_string(facet.uses) + " hexahedra"};
  }
  return std::nullopt;
}

Finding check_strict_rule(const Incidence& incidence) {
  if (StrictRule(incidence).holds()) return std::nullopt;
  std::vector<std::uint32_t> seen_by(incidence.cells.size(), 0);
  for (std::uint32_t a = 0; a < incidence.cells.size(); ++a) {
    for (const std::uint32_t vertex : incidence.cells[a]) {
      for (const std::uint32_t b : incidence.cells_at[vertex]) {
        if (b <= a || seen_by[b] == a + 1) continue;
        seen_by[b] = a + 1;
        const Shared shared = shared_corners(incidence.cells[a], incidence.cells[b]);
        const std::string broken = broken_meeting(shared);
        if (broken.empty()) continue;
        std::vector<std::uint32_t> vertices;
        for (std::size_t i = 0; i < shared.count; ++i) {
          vertices.push_back(incidence.cells[a][shared.in_a[i]]);
        }
        return Failure{Law::kStrictRule,
                       hexahedra(a, b) + " share " + broken + ": " + listed(vertices)};
      }
    }
  }
  return std::nullopt;
}

Finding check_orientation(const Incidence& incidence) {
  for (const Facet& facet : incidence.facets) {
    if (facet.uses != 2) continue;
    const Quad a = incidence.quad_at(facet.place[0]);
    const Quad b = incidence.quad_at(facet.place[1]);
    const auto at = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
    if (b[(at + 3) % 4] == a[1]) continue;
    return Failure{Law::kOrientation, hexahedra(facet.place[0] / 6, facet.place[1] / 6) +
                                          " traverse quad " + listed(a) + " in the same direction"};
  }
  return std::nullopt;
}

Finding check_connected(const Incidence& incidence) {
  DisjointSets components(incidence.cells.size());
  for (std::size_t v = 0; v < incidence.vertex_count; ++v) {
    const auto cells = incidence.cells_at[v];
    for (std::size_t i = 1; i < cells.size(); ++i) components.unite(cells[0], cells[i]);
  }
  if (components.sets() == 1) return std::nullopt;
  return Failure{Law::kConnected,
                 "the mesh has " + std::to_string(components.sets()) + " components"};
}

Finding check_boundary_sphere(const Incidence& incidence) {
  const std::vector<Quad> quads = boundary_quads(incidence);
  const auto fail = [](const std::string& reason) {
    return Failure{Law::kBoundarySphere, "the boundary " + reason};
  };
  if (quads.empty()) return fail("is empty");
  struct EdgeOfQuad {
    std::uint64_t edge;  // pair_key() of its vertices
    std::size_t quad;
    auto operator<=>(const EdgeOfQuad&) const = default;
  };
  std::vector<EdgeOfQuad> sides;
  sides.reserve(4 * quads.size());
  for (std::size_t q = 0; q < quads.size(); ++q) {
    for (std::size_t i = 0; i < 4; ++i) {
      sides.push_back({pair_key(quads[q][i], quads[q][(i + 1) % 4]), q});
    }
  }
  std::sort(sides.begin(), sides.end());
  DisjointSets components(quads.size());
  std::size_t edges = 0;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end, ++edges) {
    while (end < sides.size() && sides[end].edge == sides[i].edge) ++end;
    if (end - i != 2) {
      return fail("has edge " + listed(pair_of(sides[i].edge)) + " in " + std::to_string(end - i) +
                  " quads");
    }
    components.unite(sides[i].quad, sides[i + 1].quad);
  }
  if (components.sets() != 1) {
    return fail("has " + std::to_string(components.sets()) + " components");
  }
  const auto vertices =
      std::count(incidence.on_boundary.begin(), incidence.on_boundary.end(), true);
  const auto euler =
      vertices - static_cast<std::ptrdiff_t>(edges) + static_cast<std::ptrdiff_t>(quads.size());
  if (euler != 2) return fail("has Euler characteristic " + std::to_string(euler));
  return std::nullopt;
}

}  // namespace hexatlas::check
