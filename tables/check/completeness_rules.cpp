#include "tables/check/completeness_rules.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

namespace hexatlas::check {

namespace {

constexpr unsigned kAllVertices = 0xff;

CubeSet set_of(unsigned bits) noexcept { return static_cast<CubeSet>(bits); }
CubeSet with(CubeSet set, unsigned vertex) noexcept { return set_of(set | 1U << vertex); }
CubeSet without(CubeSet set, unsigned vertex) noexcept { return set_of(set & ~(1U << vertex)); }

/// "The sign of the orientation of the candidate is +", and "... is -".
std::int32_t orientation_variable(std::size_t candidate, int sign) noexcept {
  const std::size_t first = kCubeFacets + (sign > 0 ? 1 : 2) * kCandidates;
  return static_cast<std::int32_t>(first + candidate) + 1;
}

/// "This diagonal cuts its facet": the variable says so of the diagonal at the least vertex.
/// Requires two opposite vertices of the facet.
std::int32_t diagonal_literal(unsigned facet, CubeSet diagonal) noexcept {
  const auto variable = static_cast<std::int32_t>(facet) + 1;
  const bool at_least = std::countr_zero(diagonal) == std::countr_zero(cube_facet(facet));
  return at_least ? variable : -variable;
}

/// "This triangle of the facet is a boundary triangle": its longest side cuts the facet.
std::int32_t boundary_literal(unsigned facet, CubeSet triangle) {
  const auto left_out =
      static_cast<unsigned>(std::countr_zero(set_of(cube_facet(facet) & ~triangle)));
  const unsigned opposite = left_out ^ 7U ^ 1U << facet / 2;
  return diagonal_literal(facet, without(triangle, opposite));
}

/// +1 if the vertices of a triangle of a facet, ascending, are counter-clockwise seen from outside.
int outward_sign(unsigned facet, CubeSet triangle) {
  const std::vector<unsigned> abc = cube_vertices(triangle);
  const unsigned k = facet / 2;
  const auto step = [&abc](unsigned to, unsigned axis) {
    return static_cast<int>(abc[to] >> axis & 1U) - static_cast<int>(abc[0] >> axis & 1U);
  };
  const unsigned u = (k + 1) % 3;
  const unsigned v = (k + 2) % 3;
  const int normal = step(1, u) * step(2, v) - step(1, v) * step(2, u);
  return facet % 2 == 1 ? normal : -normal;
}

/// The orientations of candidates at a triangle that induce the ascending order of its vertices on
/// it (sign +1), or the other one.
Literals at_side(CubeSet triangle, int sign) {
  Literals literals;
  for (unsigned v = 0; v < kCubeVertices; ++v) {
    const CubeSet tetrahedron = with(triangle, v);
    const auto candidate = candidate_index(tetrahedron);
    if (!candidate) continue;
    const int before = std::popcount(set_of(triangle & ((1U << v) - 1)));
    literals.push_back(orientation_variable(*candidate, before % 2 == 0 ? sign : -sign));
  }
  return literals;
}

class RuleWriter {
 public:
  std::vector<Literals> take() { return std::move(clauses_); }

  void orientations(std::size_t candidate) {
    const std::int32_t member = member_variable(candidate);
    const std::int32_t positive = orientation_variable(candidate, 1);
    const std::int32_t negative = orientation_variable(candidate, -1);
    add({-member, positive, negative});
    add({member, -positive});
    add({member, -negative});
    add({-positive, -negative});
  }

  void sides(CubeSet triangle) {
    const std::vector<unsigned> facets = facets_with(triangle);
    const int outward = facets.empty() ? 0 : outward_sign(facets[0], triangle);
    for (const int sign : {1, -1}) {
      const Literals here = at_side(triangle, sign);
      Literals opposite = at_side(triangle, -sign);
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) add({-here[j], -here[i]});
      }
      if (sign == outward) {
        const std::int32_t boundary = boundary_literal(facets[0], triangle);
        add_if(boundary, here);
        for (const std::int32_t wrong : opposite) add({-boundary, -wrong});
        opposite.push_back(boundary);
      }
      for (const std::int32_t literal : here) add_if(literal, opposite);
    }
  }

  /// Round a boundary edge there is no cycle, round an interior one not two.
  void cycles(CubeSet edge) {
    const CubeSet around = set_of(~edge & kAllVertices);
    const std::vector<unsigned> facets = facets_with(edge);
    const bool is_cube_edge = facets.size() == 2;
    for (const CubeSet cycle : cube_subsets(3)) {
      if ((cycle & ~around) != 0) continue;
      const CubeSet rest = set_of(around & ~cycle);
      const std::vector<CubeSet> triangle = joined(edge, pairs_in(cycle));
      if (!facets.empty()) add_cycle(triangle, edge, facets);
      if (is_cube_edge || cycle > rest) continue;
      std::vector<CubeSet> both = joined(edge, pairs_in(rest));
      both.insert(both.end(), triangle.begin(), triangle.end());
      add_not_all(both, {});
    }
    if (facets.empty()) return;
    for (const CubeSet cycle : cube_subsets(4)) {
      if ((cycle & ~around) != 0) continue;
      for (const std::vector<CubeSet>& sides : four_cycles(cycle)) {
        add_cycle(joined(edge, sides), edge, facets);
      }
    }
  }

  /// No sphere of four triangles in the link of a vertex.
  void link_spheres(unsigned vertex) {
    for (const CubeSet sphere : cube_subsets(4)) {
      if ((sphere >> vertex & 1U) != 0) continue;
      std::vector<CubeSet> tetrahedra;
      for (const unsigned v : cube_vertices(sphere)) {
        tetrahedra.push_back(with(without(sphere, v), vertex));
      }
      add_not_all(tetrahedra, {});
    }
  }

 private:
  static std::vector<CubeSet> pairs_in(CubeSet set) {
    std::vector<CubeSet> pairs = cube_subsets(2);
    std::erase_if(pairs, [set](CubeSet pair) { return (pair & ~set) != 0; });
    return pairs;
  }

  /// The three cycles through four vertices, each as its sides: all pairs but two disjoint ones.
  static std::vector<std::vector<CubeSet>> four_cycles(CubeSet set) {
    std::vector<std::vector<CubeSet>> cycles;
    for (const CubeSet pair : pairs_in(set)) {
      const CubeSet rest = set_of(set & ~pair);
      if (pair > rest) continue;
      cycles.push_back(pairs_in(set));
      std::erase_if(cycles.back(), [pair, rest](CubeSet p) { return p == pair || p == rest; });
    }
    return cycles;
  }

  static std::vector<CubeSet> joined(CubeSet edge, std::vector<CubeSet> pairs) {
    for (CubeSet& pair : pairs) pair = set_of(pair | edge);
    return pairs;
  }

  /// Requires an edge of the cube, which has two facets, or a diagonal, which has one.
  void add_cycle(const std::vector<CubeSet>& tetrahedra, CubeSet edge,
                 const std::vector<unsigned>& facets) {
    Literals unless;
    if (facets.size() == 1) unless.push_back(-diagonal_literal(facets[0], edge));
    add_not_all(tetrahedra, std::move(unless));
  }

  /// Nothing if one of the sets is no candidate, for then they are never all members.
  void add_not_all(const std::vector<CubeSet>& tetrahedra, Literals unless) {
    for (const CubeSet tetrahedron : tetrahedra) {
      const auto candidate = candidate_index(tetrahedron);
      if (!candidate) return;
      unless.push_back(-member_variable(*candidate));
    }
    add(std::move(unless));
  }

  void add_if(std::int32_t condition, Literals literals) {
    literals.push_back(-condition);
    add(std::move(literals));
  }

  void add(Literals clause) {
    std::sort(clause.begin(), clause.end(),
              [](std::int32_t a, std::int32_t b) { return std::abs(a) < std::abs(b); });
    clauses_.push_back(std::move(clause));
  }

  std::vector<Literals> clauses_;
};

}  // namespace

CubeSet cube_facet(unsigned facet) noexcept {
  CubeSet set = 0;
  for (unsigned v = 0; v < kCubeVertices; ++v) {
    if ((v >> facet / 2 & 1U) == facet % 2) set = with(set, v);
  }
  return set;
}

std::vector<unsigned> facets_with(CubeSet set) {
  std::vector<unsigned> facets;
  for (unsigned f = 0; f < kCubeFacets; ++f) {
    if ((set & ~cube_facet(f)) == 0) facets.push_back(f);
  }
  return facets;
}

std::vector<unsigned> cube_vertices(CubeSet set) {
  std::vector<unsigned> vertices;
  for (unsigned v = 0; v < kCubeVertices; ++v) {
    if ((set >> v & 1U) != 0) vertices.push_back(v);
  }
  return vertices;
}

std::vector<CubeSet> cube_subsets(int size) {
  std::vector<CubeSet> sets;
  for (unsigned bits = 0; bits <= kAllVertices; ++bits) {
    if (std::popcount(bits) == size) sets.push_back(set_of(bits));
  }
  return sets;
}

const std::array<CubeSet, kCandidates>& candidates() {
  static const std::array<CubeSet, kCandidates> all = [] {
    std::vector<CubeSet> sets = cube_subsets(4);
    std::erase_if(sets, [](CubeSet set) { return !facets_with(set).empty(); });
    std::array<CubeSet, kCandidates> found{};
    std::copy_n(sets.begin(), found.size(), found.begin());
    return found;
  }();
  return all;
}

std::optional<std::size_t> candidate_index(CubeSet tetrahedron) {
  const auto& all = candidates();
  const auto* const place = std::lower_bound(all.begin(), all.end(), tetrahedron);
  if (place == all.end() || *place != tetrahedron) return std::nullopt;
  return static_cast<std::size_t>(place - all.begin());
}

std::int32_t member_variable(std::size_t candidate) noexcept {
  return static_cast<std::int32_t>(kCubeFacets + candidate) + 1;
}

std::vector<Literals> rule_clauses() {
  RuleWriter writer;
  for (std::size_t i = 0; i < kCandidates; ++i) writer.orientations(i);
  for (const CubeSet triangle : cube_subsets(3)) writer.sides(triangle);
  for (const CubeSet edge : cube_subsets(2)) writer.cycles(edge);
  for (unsigned v = 0; v < kCubeVertices; ++v) writer.link_spheres(v);
  return writer.take();
}

}  // namespace hexatlas::check
