#pragma once
/// \file
/// The 48 symmetries of the reference cube as numbers, with tables of what they do.
///
/// Number 6 t + p stands for the map that permutes the axes by the p-th permutation and then takes
/// corner v to v ^ t.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "enum/cells/cube.hpp"

namespace hexatlas::cells {

inline constexpr int kCubeSymmetries = 48;

using CubeSymmetry = std::uint8_t;  ///< in [0, kCubeSymmetries); 0 is the identity

/// The axes to which axes 0, 1, 2 are taken.
inline constexpr std::array<std::array<std::uint8_t, 3>, 6> kAxisPermutations{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

using CornerMap = std::array<CubeVertex, kCubeVertices>;

[[nodiscard]] constexpr CornerMap corner_map(CubeSymmetry symmetry) noexcept {
  CornerMap map{};
  for (unsigned v = 0; v < map.size(); ++v) {
    unsigned image = symmetry / 6U;
    for (unsigned k = 0; k < 3; ++k)
      if ((v >> k & 1U) != 0) image ^= 1U << kAxisPermutations[symmetry % 6U][k];
    map[v] = static_cast<CubeVertex>(image);
  }
  return map;
}

/// The symmetry that is this map of corners. Requires that one is.
[[nodiscard]] constexpr CubeSymmetry symmetry_of(const CornerMap& map) noexcept {
  const auto first = static_cast<unsigned>(std::countr_zero(unsigned{map[1]} ^ map[0]));
  const auto second = static_cast<unsigned>(std::countr_zero(unsigned{map[2]} ^ map[0]));
  // Permutations come in pairs by the first axis; of a pair the one with the lower second is first.
  const unsigned later = second > 3 - first - second ? 1 : 0;
  return static_cast<CubeSymmetry>(6U * map[0] + 2 * first + later);
}

struct CubeTables {
  std::array<CornerMap, kCubeSymmetries> corner{};
  std::array<std::array<CubeFacet, kCubeFacets>, kCubeSymmetries> facet{};
  /// after[a][b] is b followed by a.
  std::array<std::array<CubeSymmetry, kCubeSymmetries>, kCubeSymmetries> after{};
};

[[nodiscard]] constexpr CubeTables cube_tables() noexcept {
  CubeTables tables;
  for (CubeSymmetry s = 0; s < kCubeSymmetries; ++s) {
    tables.corner[s] = corner_map(s);
    for (unsigned f = 0; f < kCubeFacets; ++f) {
      const unsigned axis = kAxisPermutations[s % 6U][f / 2];
      const unsigned side = (s / 6U >> axis & 1U) ^ (f & 1U);
      tables.facet[s][f] = static_cast<CubeFacet>(2 * axis + side);
    }
  }
  for (CubeSymmetry a = 0; a < kCubeSymmetries; ++a)
    for (CubeSymmetry b = 0; b < kCubeSymmetries; ++b) {
      CornerMap map{};
      for (std::size_t v = 0; v < map.size(); ++v) map[v] = tables.corner[a][tables.corner[b][v]];
      tables.after[a][b] = symmetry_of(map);
    }
  return tables;
}

inline constexpr CubeTables kCubeTables = cube_tables();

}  // namespace hexatlas::cells
