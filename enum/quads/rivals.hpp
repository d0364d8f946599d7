#pragma once
/// \file
/// Reductions of a map that refute an expansion of it before it is made.
///
/// A reduction that the expansion leaves alone is a reduction of the larger map too. If its rank
/// there is sure to be above that of the reduction which undoes the expansion, the larger map has
/// another parent. Only the first two degrees of a rank, its head, are compared: those of c and e
/// for P1, those of the two neighbours for P0. What follows about the larger map is argued in
/// docs/theory/proofs/quadrangulation-generation.md, section "Rivals".

#include <algorithm>
#include <array>
#include <cstddef>

#include "enum/quads/planar_map.hpp"
#include "enum/quads/reductions.hpp"

namespace hexatlas::quads {

/// The P1 reductions of a map, best heads first.
template <Class kClass>
class P1Rivals {
 public:
  explicit P1Rivals(const PlanarMap& map) noexcept {
    each_p1_site(map, [&](Dart r, const P1Site& site) noexcept {
      if (!is_p1_reduction<kClass>(map, site)) return true;
      const unsigned head = head_of(map.degree[site.c], map.degree[site.e]);
      rivals_[size_++] = {head, map.origin[r], site};
      return true;
    });
    std::sort(rivals_.begin(), rivals_.begin() + static_cast<std::ptrdiff_t>(size_),
              [](const Rival& a, const Rival& b) { return a.head > b.head; });
  }

  /// Whether some reduction of the map refutes P1 at h. Never true of an expansion that makes a
  /// map whose canonical reduction it is.
  [[nodiscard]] bool refute(const PlanarMap& map, Dart h) const noexcept {
    const Vertex c = map.origin[h];
    const Vertex b = map.head(map.ccw[h]);
    const Vertex d = map.head(map.cw[h]);
    const unsigned head = head_of(map.degree[c] - 1U, map.degree[map.head(h)]);
    for (std::size_t i = 0; i < size_ && rivals_[i].head > head; ++i)
      if (rivals_[i].is_left_alone(b, c, d)) return true;
    return false;
  }

 private:
  static constexpr unsigned head_of(unsigned c, unsigned e) noexcept { return c << 8U | e; }

  struct Rival {
    unsigned head = 0;
    Vertex a = 0;
    P1Site site{};

    [[nodiscard]] bool is_left_alone(Vertex b, Vertex c, Vertex d) const noexcept {
      if (a == b || a == d) return false;
      if (kClass == Class::three_connected && (site.c == b || site.c == d)) return false;
      return site.b != c && site.c != c && site.d != c && site.e != c && site.f != c && site.g != c;
    }
  };
  std::size_t size_ = 0;
  std::array<Rival, 3 * complex::kMaxVertices> rivals_{};  ///< the first size_ are set
};

/// The vertices of degree 2 of a map, best heads first.
class P0Rivals {
 public:
  explicit P0Rivals(const PlanarMap& map) noexcept {
    for (int v = 0; v < map.vertices; ++v) {
      const auto x = static_cast<Vertex>(v);
      if (map.degree[x] != 2) continue;
      const Dart s = map.first[x];
      rivals_[size_++] = {head_of(map.degree[map.head(s)], map.degree[map.head(map.ccw[s])]), x};
    }
    std::sort(rivals_.begin(), rivals_.begin() + static_cast<std::ptrdiff_t>(size_),
              [](const Rival& a, const Rival& b) { return a.head > b.head; });
  }

  /// Whether some reduction of the map refutes P0 at p.
  [[nodiscard]] bool refute(const PlanarMap& map, Dart p) const noexcept {
    const Vertex u = map.origin[p];
    const Vertex w = map.origin[map.across(p)];
    const unsigned head = head_of(map.degree[u] + 1U, map.degree[w] + 1U);
    for (std::size_t i = 0; i < size_ && rivals_[i].head > head; ++i)
      if (rivals_[i].x != u && rivals_[i].x != w) return true;
    return false;
  }

 private:
  static constexpr unsigned head_of(unsigned u, unsigned w) noexcept {
    return std::max(u, w) << 8U | std::min(u, w);
  }

  struct Rival {
    unsigned head = 0;
    Vertex x = 0;
  };
  std::size_t size_ = 0;
  std::array<Rival, complex::kMaxVertices> rivals_{};  ///< the first size_ are set
};

}  // namespace hexatlas::quads
