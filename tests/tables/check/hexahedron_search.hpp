#pragma once
// All triangulations of the hexahedron with one fixed choice of diagonals, by a front that advances
// through the oriented triangles: a second road to the list, without a formula, symmetries or
// shellings.

#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace hexatlas::check::examples {

/// Facets of the cube, counter-clockwise from outside.
inline constexpr std::array<std::array<unsigned, 4>, 6> kCubeCycles = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

inline std::vector<unsigned> members_of(unsigned set) {
  std::vector<unsigned> result;
  for (unsigned v = 0; v < 8; ++v) {
    if ((set >> v & 1U) != 0) result.push_back(v);
  }
  return result;
}

/// Of the order of the numbers: 1 if it is an odd permutation of the ascending one.
template <std::size_t kSize>
unsigned parity_of(const std::array<unsigned, kSize>& numbers) {
  unsigned inversions = 0;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      inversions += static_cast<unsigned>(numbers[j] > numbers[i]);
  }
  return inversions % 2;
}

/// The diagonal of each facet, as a set of two vertices. Bit f of the choice: it joins the second
/// vertex of facet f to the fourth.
inline std::array<unsigned, 6> diagonals_of(unsigned choice) {
  std::array<unsigned, 6> diagonals{};
  for (unsigned f = 0; f < 6; ++f) {
    const unsigned s = choice >> f & 1U;
    diagonals[f] = 1U << kCubeCycles[f][s] | 1U << kCubeCycles[f][s + 2];
  }
  return diagonals;
}

/// Tetrahedra that obey the laws of triangles and edges, with the sign of the ascending order of
/// the vertices of each.
struct ClosedComplex {
  std::vector<std::uint16_t> tetrahedra;
  std::vector<int> signs;
};

/// Whether all vertex links are discs, for a closed complex: connected, of characteristic 1.
inline bool links_are_discs(const std::vector<std::uint16_t>& tetrahedra) {
  for (unsigned v = 0; v < 8; ++v) {
    std::vector<unsigned> link;
    for (const unsigned t : tetrahedra) {
      if ((t >> v & 1U) != 0) link.push_back(t & ~(1U << v));
    }
    if (link.empty()) return false;
    std::set<unsigned> edges;
    unsigned used = 0;
    unsigned reached = link[0];
    for (std::size_t round = 0; round < link.size(); ++round) {
      for (const unsigned t : link) {
        used |= t;
        for (const unsigned u : members_of(t)) edges.insert(t & ~(1U << u));
        if (std::popcount(t & reached) >= 2) reached |= t;
      }
    }
    const int characteristic =
        std::popcount(used) - static_cast<int>(edges.size()) + static_cast<int>(link.size());
    if (used != reached || characteristic != 1) return false;
  }
  return true;
}

/// Each triangle has two sides, both or none occupied at the end; the outside of the hexahedron
/// occupies one side of each boundary triangle.
class HexahedronSearch {
 public:
  explicit HexahedronSearch(unsigned choice) {
    for (unsigned f = 0; f < 6; ++f) {
      const auto& q = kCubeCycles[f];
      const unsigned s = choice >> f & 1U;
      for (const unsigned i : {s, s + 2}) {
        const Oriented inward = {q[i % 4], q[(i + 2) % 4], q[(i + 1) % 4]};
        turn(inward);
        for (const unsigned v : inward) boundary_edges_.insert(bits(inward) & ~(1U << v));
      }
    }
  }

  std::vector<ClosedComplex> run() {
    extend();
    return std::move(found_);
  }

 private:
  using Oriented = std::array<unsigned, 3>;

  static unsigned bits(const Oriented& abc) { return 1U << abc[0] | 1U << abc[1] | 1U << abc[2]; }
  void turn(const Oriented& abc) { sides_[bits(abc)] ^= 1U << parity_of(abc); }
  [[nodiscard]] bool is_free(const Oriented& abc) const {
    return (sides_[bits(abc)] >> parity_of(abc) & 1U) == 0;
  }

  /// The triangles of a tetrahedron, counter-clockwise from outside of it, if abc is one.
  static std::array<Oriented, 4> around(const Oriented& abc, unsigned d) {
    const auto [a, b, c] = abc;
    return {{{a, b, c}, {b, a, d}, {c, b, d}, {a, c, d}}};
  }

  static bool on_one_facet(unsigned set) {
    for (unsigned f = 0; f < 6; ++f) {
      unsigned facet = 0;
      for (const unsigned v : kCubeCycles[f]) facet |= 1U << v;
      if ((set & ~facet) == 0) return true;
    }
    return false;
  }

  /// False if there is a circle of tetrahedra at the edge and more, or if it is on the boundary.
  [[nodiscard]] bool can_be_good(unsigned edge) const {
    std::vector<unsigned> pairs;
    for (const unsigned t : now_.tetrahedra) {
      if ((edge & ~t) == 0) pairs.push_back(t & ~edge);
    }
    for (unsigned part : pairs) {
      int inside = 0;
      for (std::size_t round = 0; round < pairs.size(); ++round) {
        inside = 0;
        for (const unsigned pair : pairs) {
          if ((pair & part) == 0) continue;
          part |= pair;
          ++inside;
        }
      }
      const bool is_circle = inside == std::popcount(part);
      const bool is_all = inside == static_cast<int>(pairs.size());
      if (is_circle && (!is_all || boundary_edges_.count(edge) != 0)) return false;
    }
    return true;
  }

  [[nodiscard]] bool edges_can_be_good(unsigned tetrahedron) const {
    for (const unsigned a : members_of(tetrahedron)) {
      for (const unsigned b : members_of(tetrahedron)) {
        if (a < b && !can_be_good(1U << a | 1U << b)) return false;
      }
    }
    return true;
  }

  void extend() {
    unsigned open = 0;
    while (open < sides_.size() && (sides_[open] == 0 || sides_[open] == 3)) ++open;
    if (open == sides_.size()) {
      found_.push_back(now_);
      return;
    }
    if (now_.tetrahedra.size() == 15) return;
    const std::vector<unsigned> v = members_of(open);
    const Oriented abc =
        sides_[open] == 2 ? Oriented{v[0], v[1], v[2]} : Oriented{v[1], v[0], v[2]};
    for (unsigned d = 0; d < 8; ++d) {
      const unsigned tetrahedron = open | 1U << d;
      if (std::popcount(tetrahedron) != 4 || on_one_facet(tetrahedron)) continue;
      const auto triangles = around(abc, d);
      bool fits = true;
      for (const Oriented& triangle : triangles) fits = fits && is_free(triangle);
      if (!fits) continue;
      for (const Oriented& triangle : triangles) turn(triangle);
      now_.tetrahedra.push_back(static_cast<std::uint16_t>(tetrahedron));
      // The order abcd is negative if abc is counter-clockwise from outside.
      now_.signs.push_back(parity_of(std::array{abc[0], abc[1], abc[2], d}) == 1 ? 1 : -1);
      if (edges_can_be_good(tetrahedron)) extend();
      now_.tetrahedra.pop_back();
      now_.signs.pop_back();
      for (const Oriented& triangle : triangles) turn(triangle);
    }
  }

  std::array<unsigned, 256> sides_{};
  std::set<unsigned> boundary_edges_;
  ClosedComplex now_;
  std::vector<ClosedComplex> found_;
};

}  // namespace hexatlas::check::examples
