#pragma once
/// \file
/// The reductions of a map within a class, and their ranks.
///
/// A reduction is the inverse of an expansion whose result is in the class. It is named by a flag:
/// P0 by a dart from the vertex of degree 2, P1 by the dart from the vertex of degree 3 away from
/// the quad that is contracted, P3 by a dart of the inner quad on its left (mirrored: on its
/// right). The rank of a flag is made of degrees; the greatest rank is best. Isomorphisms keep
/// reductions and ranks, so the flags of best rank are a union of orbits.
///
/// Kinds come first: where there is a P0 reduction, P1 and P3 are not considered; where there is a
/// P1 reduction, P3 is not.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "enum/quads/generate.hpp"
#include "enum/quads/planar_map.hpp"
#include "enum/quads/symmetry.hpp"

namespace hexatlas::quads {

using Rank = std::uint64_t;  ///< bytes, most significant first

/// The rank of a reduction: of its two orientations, or of the better one.
struct Ranks {
  Rank plain = 0;
  Rank mirrored = 0;
  [[nodiscard]] Rank best() const noexcept { return std::max(plain, mirrored); }
};

/// Adds the flags of d whose rank is `rank`.
inline void add_flags(FlagList& flags, Dart d, const Ranks& ranks, Rank rank) noexcept {
  if (ranks.plain == rank) flags.push_back({d, false});
  if (ranks.mirrored == rank) flags.push_back({d, true});
}

// ------------------------------------------------------------------------------------ P1

/// The vertices around a P1 reduction, or around the expansion that it inverts: a has the
/// neighbours b, d, e; the quads there are (a, b, c, d), (a, e, f, b), (a, d, g, e).
struct P1Site {
  Dart from_c = 0;  ///< a dart of c
  Vertex b = 0, c = 0, d = 0, e = 0, f = 0, g = 0;
};

/// Requires that the origin of r has degree 3.
[[nodiscard]] inline P1Site p1_site(const PlanarMap& map, Dart r) noexcept {
  const Dart to_b = map.ccw[r];
  const Dart to_d = map.cw[r];
  const Dart b_to_c = map.along(to_b);
  return {.from_c = twin(b_to_c),
          .b = map.head(to_b),
          .c = map.head(b_to_c),
          .d = map.head(to_d),
          .e = map.head(r),
          .f = map.head(map.along(r)),
          .g = map.head(map.along(to_d))};
}

[[nodiscard]] constexpr Ranks p1_ranks(std::uint8_t b, std::uint8_t c, std::uint8_t d,
                                       std::uint8_t e, std::uint8_t f, std::uint8_t g) noexcept {
  const Rank head = Rank{c} << 40U | Rank{e} << 32U;
  return {head | Rank{b} << 24U | Rank{d} << 16U | Rank{f} << 8U | g,
          head | Rank{d} << 24U | Rank{b} << 16U | Rank{g} << 8U | f};
}

[[nodiscard]] inline Ranks p1_ranks(const PlanarMap& map, const P1Site& s) noexcept {
  const auto& degree = map.degree;
  return p1_ranks(degree[s.b], degree[s.c], degree[s.d], degree[s.e], degree[s.f], degree[s.g]);
}

/// Whether contracting (a, b, c, d) leaves a map of the class. Requires a map of the class; for
/// simple ones, that it has no vertex of degree 2 or that only double edges are of interest.
template <Class kClass>
[[nodiscard]] bool is_p1_reduction(const PlanarMap& map, const P1Site& s) noexcept {
  if (kClass != Class::simple && (map.degree[s.b] == 3 || map.degree[s.d] == 3)) return false;
  Dart q = s.from_c;
  do {
    if (map.head(q) == s.e) return false;  // a double edge
    if constexpr (kClass == Class::three_connected) {
      const Vertex opposite = map.head(map.along(q));
      if (opposite == s.f || opposite == s.g) return false;  // two quads with one diagonal
    }
    q = map.ccw[q];
  } while (q != s.from_c);
  return true;
}

/// Calls visit(r, site) for the three possible reductions of each vertex of degree 3, until it
/// returns false; whether it never did.
template <class Visit>
bool each_p1_site(const PlanarMap& map, Visit&& visit) noexcept {
  for (int v = 0; v < map.vertices; ++v) {
    if (map.degree[static_cast<std::size_t>(v)] != 3) continue;
    Dart r = map.first[static_cast<std::size_t>(v)];
    for (int i = 0; i < 3; ++i, r = map.ccw[r])
      if (!visit(r, p1_site(map, r))) return false;
  }
  return true;
}

/// Whether no P1 reduction ranks above that at `ours`; then all flags of its rank, its own first.
/// Returns the number of its own, 0 if it is not best.
template <Class kClass>
std::size_t best_p1_flags(const PlanarMap& map, Dart ours, FlagList& flags) noexcept {
  const Ranks our_ranks = p1_ranks(map, p1_site(map, ours));
  const Rank best = our_ranks.best();
  flags.clear();
  add_flags(flags, ours, our_ranks, best);
  const std::size_t number = flags.size();
  const bool is_best = each_p1_site(map, [&](Dart r, const P1Site& site) noexcept {
    const Ranks ranks = p1_ranks(map, site);
    if (ranks.best() < best || r == ours || !is_p1_reduction<kClass>(map, site)) return true;
    if (ranks.best() > best) return false;
    add_flags(flags, r, ranks, best);
    return true;
  });
  return is_best ? number : 0;
}

template <Class kClass>
[[nodiscard]] bool has_p1_reduction(const PlanarMap& map) noexcept {
  return !each_p1_site(
      map, [&](Dart, const P1Site& site) noexcept { return !is_p1_reduction<kClass>(map, site); });
}

// ------------------------------------------------------------------------------------ P0

/// The ranks of the flags of s, a dart from a vertex of degree 2.
[[nodiscard]] inline Ranks p0_ranks(const PlanarMap& map, Dart s) noexcept {
  const Dart t = map.ccw[s];
  const auto degree = [&map](Vertex v) noexcept { return Rank{map.degree[v]}; };
  const Rank head = degree(map.head(s)) << 24U | degree(map.head(t)) << 16U;
  const Rank left = degree(map.head(map.along(s)));
  const Rank right = degree(map.head(map.along(t)));
  return {head | left << 8U | right, head | right << 8U | left};
}

/// As best_p1_flags, for the vertex of degree 2 with the dart `ours`.
inline std::size_t best_p0_flags(const PlanarMap& map, Dart ours, FlagList& flags) noexcept {
  const auto ranks_of = [&map](Dart s) noexcept {
    return std::array<Ranks, 2>{p0_ranks(map, s), p0_ranks(map, map.ccw[s])};
  };
  const auto add = [&](Dart s, const std::array<Ranks, 2>& ranks, Rank rank) noexcept {
    add_flags(flags, s, ranks[0], rank);
    add_flags(flags, map.ccw[s], ranks[1], rank);
  };
  const auto our_ranks = ranks_of(ours);
  const Rank best = std::max(our_ranks[0].best(), our_ranks[1].best());
  flags.clear();
  add(ours, our_ranks, best);
  const std::size_t number = flags.size();
  for (int v = 0; v < map.vertices; ++v) {
    const Vertex vertex = static_cast<Vertex>(v);
    if (map.degree[vertex] != 2 || vertex == map.origin[ours]) continue;
    const Dart s = map.first[vertex];
    const auto ranks = ranks_of(s);
    const Rank rank = std::max(ranks[0].best(), ranks[1].best());
    if (rank > best) return 0;
    if (rank == best) add(s, ranks, best);
  }
  return number;
}

// ------------------------------------------------------------------------------------ P3

/// The corners of the quad around the inner quad left of r, that joined to origin(r) first.
/// Requires that the four corners of the inner quad have degree 3.
[[nodiscard]] inline std::array<Vertex, 4> p3_corners(const PlanarMap& map, Dart r) noexcept {
  std::array<Vertex, 4> corners{};
  for (Vertex& corner : corners) {
    corner = map.head(map.cw[r]);
    r = map.along(r);
  }
  return corners;
}

/// Whether the two vertices are opposite corners of a quad.
[[nodiscard]] inline bool is_diagonal(const PlanarMap& map, Vertex a, Vertex opposite) noexcept {
  const Dart start = map.first[a];
  Dart q = start;
  do {
    if (map.head(map.along(q)) == opposite) return true;
    q = map.ccw[q];
  } while (q != start);
  return false;
}

/// Whether taking out the quad left of r leaves a map of the class.
template <Class kClass>
[[nodiscard]] bool is_p3_reduction(const PlanarMap& map, Dart r) noexcept {
  Dart q = r;
  for (int i = 0; i < 4; ++i, q = map.along(q))
    if (map.degree[map.origin[q]] != 3) return false;
  const auto corners = p3_corners(map, r);
  for (const Vertex v : corners)
    if (map.degree[v] == 3) return false;
  return kClass != Class::three_connected ||
         (!is_diagonal(map, corners[0], corners[2]) && !is_diagonal(map, corners[1], corners[3]));
}

/// The rank of each of the 8 flags of the inner quad left of r, as Ranks of the four corners.
[[nodiscard]] inline std::array<Ranks, 4> p3_ranks(const PlanarMap& map, Dart r) noexcept {
  const auto corners = p3_corners(map, r);
  std::array<Ranks, 4> ranks;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      ranks[i].plain = ranks[i].plain << 8U | map.degree[corners[(i + k) % 4]];
      ranks[i].mirrored = ranks[i].mirrored << 8U | map.degree[corners[(i + 4 - k) % 4]];
    }
  return ranks;
}

/// As best_p1_flags, for the inner quad left of `ours`; P1 reductions are not looked at.
template <Class kClass>
std::size_t best_p3_flags(const PlanarMap& map, Dart ours, FlagList& flags) noexcept {
  const auto best_of = [](const std::array<Ranks, 4>& ranks) noexcept {
    Rank best = 0;
    for (const Ranks& r : ranks) best = std::max(best, r.best());
    return best;
  };
  const auto our_ranks = p3_ranks(map, ours);
  const Rank best = best_of(our_ranks);
  const auto add = [&](Dart r, const std::array<Ranks, 4>& ranks) noexcept {
    for (std::size_t i = 0; i < 4; ++i, r = map.along(r)) {
      if (ranks[i].plain == best) flags.push_back({r, false});
      // Mirrored, the quad is on the right of the dart from the same corner to the previous one.
      if (ranks[i].mirrored == best) flags.push_back({map.ccw[r], true});
    }
  };
  flags.clear();
  add(ours, our_ranks);
  const std::size_t number = flags.size();
  Dart least_of_ours = ours;
  for (Dart r = map.along(ours); r != ours; r = map.along(r))
    least_of_ours = std::min(least_of_ours, r);
  for (int i = 0; i < map.darts; ++i) {
    const auto r = static_cast<Dart>(i);
    const bool is_least = r < map.along(r) && r < map.across(r) && r < map.along(map.across(r));
    if (!is_least || r == least_of_ours || !is_p3_reduction<kClass>(map, r)) continue;
    const auto ranks = p3_ranks(map, r);
    if (best_of(ranks) > best) return 0;
    if (best_of(ranks) == best) add(r, ranks);
  }
  return number;
}

}  // namespace hexatlas::quads
