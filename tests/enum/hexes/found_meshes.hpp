#pragma once
/// \file
/// What the tests of the search for hexahedral meshes share: meshes by sets, all meshes that it
/// finds.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <vector>

#include "enum/hexes/search.hpp"
#include "enum/search/depth_first.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::support {

/// The quads of each hexahedron as sorted lists of vertices, the least over all numberings of the
/// interior vertices.
using Quads = std::array<oracle::Cycle, 6>;
using Mesh = std::vector<Quads>;

inline Quads quads_of(const oracle::Cell& cell) {
  Quads result{};
  const auto quads = oracle::outer_quads(cell);
  std::copy(quads.begin(), quads.end(), result.begin());
  for (oracle::Cycle& quad : result) std::sort(quad.begin(), quad.end());
  std::sort(result.begin(), result.end());
  return result;
}

inline Mesh named(const std::vector<oracle::Cell>& cells, std::uint32_t boundary_vertices) {
  std::uint32_t vertices = boundary_vertices;
  for (const oracle::Cell& cell : cells)
    for (const std::uint32_t v : cell) vertices = std::max(vertices, v + 1);
  std::vector<std::uint32_t> name(vertices);
  std::iota(name.begin(), name.end(), 0U);
  Mesh least, mesh(cells.size());
  do {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      oracle::Cell cell = cells[i];
      for (std::uint32_t& v : cell) v = name[v];
      mesh[i] = quads_of(cell);
    }
    std::sort(mesh.begin(), mesh.end());
    if (least.empty() || mesh < least) least = mesh;
  } while (std::next_permutation(name.begin() + boundary_vertices, name.end()));
  return least;
}

struct FoundMeshes {
  std::set<Mesh> meshes;
  search::Counts counts;
};

inline FoundMeshes search_all(const complex::Quadrangulation& boundary,
                              const hexes::SearchLimits& limits, hexes::Prunings prunings = {},
                              const std::function<bool(const hexes::HexSearch&)>& is_wanted = {}) {
  hexes::HexSearch problem(boundary, limits, prunings);
  FoundMeshes found;
  const auto result = search::explore(problem, {}, {}, [&](const hexes::HexSearch& at) {
    if (is_wanted && !is_wanted(at)) return true;
    const auto mesh = hexes::complex_of(at.mesh());
    found.meshes.insert(named(mesh.hexahedra, static_cast<std::uint32_t>(boundary.vertices())));
    return true;
  });
  EXPECT_TRUE(result.is_proof());
  found.counts = result.counts;
  return found;
}

inline hexes::SearchLimits limits_for(const complex::Quadrangulation& boundary, int hexahedra,
                                      bool ball = false) {
  return {hexahedra, hexes::most_interior_vertices(boundary.quads(), hexahedra), ball};
}

inline std::vector<complex::Quadrangulation> three_connected(int max_quads) {
  std::vector<complex::Quadrangulation> result;
  auto level = four_cycle_class();
  for (int n = 3; n <= max_quads; ++n) {
    level = grown(level);
    for (const auto& [code, map] : level)
      if (n % 2 == 0 && oracle::is_three_connected(map)) result.push_back(quadrangulation(map));
  }
  return result;
}

}  // namespace hexatlas::support
