#pragma once
/// \file
/// What the tests of peeling share: all that can be seen of a peeling, and by brute force what may
/// be taken off next.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "enum/complex/quad_surface.hpp"
#include "enum/flips/angles.hpp"
#include "enum/flips/peeling.hpp"

namespace hexatlas::support {

using flips::Peeling;

inline Peeling peeling_of(const complex::QuadSphere& sphere) {
  return Peeling(sphere.quads, sphere.vertices());
}

/// All that can be seen. Of a dart that is gone nothing is said, and nothing is seen here.
struct Seen {
  std::uint32_t vertices = 0, quad_numbers = 0;
  std::size_t quads = 0;
  std::vector<complex::BoundaryQuad> cavity;
  std::vector<complex::Hexahedron> taken;
  std::vector<std::uint32_t> degrees;
  std::vector<std::array<std::uint32_t, 3>> darts;  ///< the live ones: number, origin, twin
  std::set<std::pair<std::uint32_t, std::uint32_t>> related;

  friend bool operator==(const Seen&, const Seen&) = default;
};

inline Seen seen(const Peeling& peeling) {
  Seen result{peeling.vertices(),
              peeling.quad_numbers(),
              peeling.quads(),
              peeling.cavity(),
              peeling.taken(),
              {},
              {},
              {}};
  for (std::uint32_t v = 0; v < peeling.vertices(); ++v) {
    result.degrees.push_back(peeling.degree(v));
    for (std::uint32_t u = 0; u < v; ++u)
      if (peeling.are_related(u, v)) result.related.emplace(u, v);
  }
  for (std::uint32_t d = 0; d < 4 * peeling.quad_numbers(); ++d)
    if (peeling.is_live(d / 4)) result.darts.push_back({d, peeling.origin(d), peeling.twin(d)});
  return result;
}

/// Each of these is what the others say: cavity, darts, twins, degrees, and related pairs from the
/// hexahedra taken off and the cavity's quads.
inline void expect_consistent(const Peeling& peeling) {
  const auto cavity = peeling.cavity();
  ASSERT_EQ(cavity.size(), peeling.quads());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> dart;
  std::vector<std::uint32_t> degree(peeling.vertices(), 0);
  std::set<std::pair<std::uint32_t, std::uint32_t>> related;
  std::size_t at = 0;
  for (std::uint32_t q = 0; q < peeling.quad_numbers(); ++q) {
    if (!peeling.is_live(q)) continue;
    const complex::BoundaryQuad& quad = cavity.at(at++);
    for (std::uint32_t i = 0; i < 4; ++i) {
      ASSERT_EQ(peeling.origin(4 * q + i), quad[i]);
      ASSERT_TRUE(dart.emplace(std::pair{quad[i], quad[(i + 1) % 4]}, 4 * q + i).second);
      ++degree[quad[i]];
      for (std::uint32_t k = 0; k < i; ++k) related.insert(std::minmax(quad[i], quad[k]));
    }
  }
  ASSERT_EQ(at, cavity.size());
  for (const auto& [ends, d] : dart) {
    const auto back = dart.find({ends.second, ends.first});
    ASSERT_NE(back, dart.end()) << "an edge with one quad";
    ASSERT_EQ(peeling.twin(d), back->second);
  }
  for (const auto& cell : peeling.taken())
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t k = 0; k < i; ++k) related.insert(std::minmax(cell[i], cell[k]));
  const Seen now = seen(peeling);
  ASSERT_EQ(now.degrees, degree);
  ASSERT_EQ(now.related, related);
}

inline void expect_same_at_twins(const Peeling& peeling, const flips::Angles& angles) {
  ASSERT_EQ(angles.size(), 4 * std::size_t{peeling.quad_numbers()});
  for (const std::uint32_t q : peeling.live_quads())
    for (Peeling::Dart d = 4 * q; d < 4 * q + 4; ++d) ASSERT_EQ(angles[d], angles[peeling.twin(d)]);
}

struct Choice {
  Peeling::Patch patch;
  Peeling::Prism prism;
  [[nodiscard]] int growth() const {  ///< of the number of quads
    int sides = 0;
    for (unsigned i = 0; i < 4; ++i) sides += patch.sides >> i & 1;
    return 4 - 2 * sides;
  }
};

/// All that may be taken off next: every live bottom, every set of sides.
inline std::vector<Choice> choices(const Peeling& peeling, int most_growth = 4) {
  std::vector<Choice> result;
  for (std::uint32_t q = 0; q < peeling.quad_numbers(); ++q)
    for (std::uint8_t sides = 0; sides < 16 && peeling.is_live(q); ++sides) {
      Choice choice{{q, sides}, {}};
      if (choice.growth() <= most_growth && peeling.may_take(choice.patch, choice.prism))
        result.push_back(choice);
    }
  return result;
}

}  // namespace hexatlas::support
