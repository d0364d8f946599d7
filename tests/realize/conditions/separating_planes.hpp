#pragma once
/// \file
/// Whether tetrahedra meet properly and points are extreme, by planes through three of the points:
/// an oracle that knows no Radon partitions. Points in general position.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"

namespace hexatlas::oracle {

__extension__ using Wide = __int128;

inline int side(const certificate::Realization& p, std::size_t a, std::size_t b, std::size_t c,
                std::size_t d) {
  Wide sum = 0;  // the 4x4 determinant with ones, by permutations of three differences
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const std::size_t m = (k + 2) % 3;
    sum += Wide{p[b][k] - p[a][k]} * (Wide{p[c][l] - p[a][l]} * (p[d][m] - p[a][m]) -
                                      Wide{p[c][m] - p[a][m]} * (p[d][l] - p[a][l]));
  }
  return (sum > 0) - (sum < 0);
}

inline bool in(complex::VertexSet set, std::size_t v) { return (set >> v & 1U) != 0; }

/// Some plane has the common face of s and t in it and the rest of them strictly on different
/// sides. The planes that do form an open cone, whose extreme members go through three points of s
/// and t.
inline bool meet_properly(complex::VertexSet s, complex::VertexSet t,
                          const certificate::Realization& p) {
  const auto all = static_cast<complex::VertexSet>(s | t);
  const auto common = static_cast<complex::VertexSet>(s & t);
  for (std::size_t a = 0; a < p.size(); ++a)
    for (std::size_t b = a + 1; b < p.size(); ++b)
      for (std::size_t c = b + 1; c < p.size(); ++c) {
        const auto plane = static_cast<complex::VertexSet>(1U << a | 1U << b | 1U << c);
        if ((plane & all) != plane || (common & plane) != common) continue;
        int least = 1;
        int most = -1;
        for (std::size_t d = 0; d < p.size(); ++d) {
          if (!in(all, d) || in(plane, d)) continue;
          const int towards_s = in(s, d) ? side(p, a, b, c, d) : -side(p, a, b, c, d);
          least = std::min(least, towards_s);
          most = std::max(most, towards_s);
        }
        if (least == most) return true;
      }
  return false;
}

inline bool all_meet_properly(const std::vector<complex::VertexSet>& tetrahedra,
                              const certificate::Realization& p) {
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!meet_properly(tetrahedra[i], tetrahedra[j], p)) return false;
  return true;
}

/// Each point is a corner of a triangle with all other points on one side.
inline bool in_convex_position(const certificate::Realization& p) {
  std::vector<bool> extreme(p.size(), false);
  for (std::size_t a = 0; a < p.size(); ++a)
    for (std::size_t b = a + 1; b < p.size(); ++b)
      for (std::size_t c = b + 1; c < p.size(); ++c) {
        int sum = 0;
        for (std::size_t d = 0; d < p.size(); ++d)
          if (d != a && d != b && d != c) sum += side(p, a, b, c, d);
        if (static_cast<std::size_t>(std::abs(sum)) + 3 == p.size())
          extreme[a] = extreme[b] = extreme[c] = true;
      }
  return std::find(extreme.begin(), extreme.end(), false) == extreme.end();
}

inline bool in_general_position(const certificate::Realization& p) {
  for (std::size_t a = 0; a < p.size(); ++a)
    for (std::size_t b = a + 1; b < p.size(); ++b)
      for (std::size_t c = b + 1; c < p.size(); ++c)
        for (std::size_t d = c + 1; d < p.size(); ++d)
          if (side(p, a, b, c, d) == 0) return false;
  return true;
}

}  // namespace hexatlas::oracle
