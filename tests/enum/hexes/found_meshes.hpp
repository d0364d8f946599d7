#pragma once
/// \file
/// What the tests of the search for hexahedral meshes share: meshes by sets, all meshes that it
/// finds.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "enum/hexes/search.hpp"
#include "enum/search/depth_first.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::support {

/// The quads of each hexahedron as sorted lists of vertices, the least over all numberings of the
/// interior vertices that follow the order of their sights.
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

/// What is seen of an interior vertex before it has a name: of each of its hexahedra the vertices
/// on the boundary.
using Sight = std::vector<std::vector<std::uint32_t>>;

inline Sight sight_of(std::uint32_t vertex, const std::vector<oracle::Cell>& cells,
                      std::uint32_t boundary_vertices) {
  Sight sight;
  for (const oracle::Cell& cell : cells) {
    if (std::find(cell.begin(), cell.end(), vertex) == cell.end()) continue;
    std::vector<std::uint32_t>& seen = sight.emplace_back();
    std::copy_if(cell.begin(), cell.end(), std::back_inserter(seen),
                 [=](std::uint32_t v) { return v < boundary_vertices; });
    std::sort(seen.begin(), seen.end());
  }
  std::sort(sight.begin(), sight.end());
  return sight;
}

/// The ends of the classes of equal sights; the interior vertices are put in their order.
inline std::vector<std::ptrdiff_t> sorted_by_sight(std::vector<std::uint32_t>& interior,
                                                   const std::vector<oracle::Cell>& cells,
                                                   std::uint32_t boundary_vertices) {
  std::vector<std::pair<Sight, std::uint32_t>> seen;
  for (const std::uint32_t v : interior)
    seen.emplace_back(sight_of(v, cells, boundary_vertices), v);
  std::sort(seen.begin(), seen.end());
  std::vector<std::ptrdiff_t> ends;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    interior[i] = seen[i].second;
    if (i + 1 == seen.size() || seen[i + 1].first != seen[i].first)
      ends.push_back(static_cast<std::ptrdiff_t>(i) + 1);
  }
  return ends;
}

/// False after the last of the orders that keep each class together.
inline bool next_order(std::vector<std::uint32_t>& interior,
                       const std::vector<std::ptrdiff_t>& ends) {
  std::ptrdiff_t begin = 0;
  for (const std::ptrdiff_t end : ends) {
    if (std::next_permutation(interior.begin() + begin, interior.begin() + end)) return true;
    begin = end;
  }
  return false;
}

inline Mesh named(const std::vector<oracle::Cell>& cells, std::uint32_t boundary_vertices) {
  std::uint32_t vertices = boundary_vertices;
  for (const oracle::Cell& cell : cells)
    for (const std::uint32_t v : cell) vertices = std::max(vertices, v + 1);
  std::vector<std::uint32_t> interior(vertices - boundary_vertices), name(vertices);
  std::iota(interior.begin(), interior.end(), boundary_vertices);
  std::iota(name.begin(), name.end(), 0U);
  const auto ends = sorted_by_sight(interior, cells, boundary_vertices);
  Mesh least, mesh(cells.size());
  do {
    for (std::size_t i = 0; i < interior.size(); ++i)
      name[interior[i]] = boundary_vertices + static_cast<std::uint32_t>(i);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      oracle::Cell cell = cells[i];
      for (std::uint32_t& v : cell) v = name[v];
      mesh[i] = quads_of(cell);
    }
    std::sort(mesh.begin(), mesh.end());
    if (least.empty() || mesh < least) least = mesh;
  } while (next_order(interior, ends));
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
