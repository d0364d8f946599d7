#pragma once
/// \file
/// The faults of a mesh by sets: classes of hexahedra joined through facets, pair by pair.

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "enum/flips/faults.hpp"
#include "enum/flips/walk.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::support {

inline std::set<std::set<std::uint32_t>> facets_of(const oracle::Cell& cell) {
  std::set<std::set<std::uint32_t>> result;
  for (const auto& quad : oracle::boundary({cell})) result.emplace(quad.begin(), quad.end());
  return result;
}

/// How many classes of the cells with both vertices there are beyond the first.
inline int faults_of_pair(const std::vector<std::set<std::set<std::uint32_t>>>& facets,
                          const std::set<std::uint32_t>& pair, std::set<std::size_t> cells) {
  int classes = 0;
  for (; !cells.empty(); ++classes) {
    std::vector<std::size_t> reached{*cells.begin()};
    cells.erase(cells.begin());
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const auto& facet : facets[reached[i]]) {
        if (!std::includes(facet.begin(), facet.end(), pair.begin(), pair.end())) continue;
        for (std::size_t other = 0; other < facets.size(); ++other)
          if (facets[other].contains(facet) && cells.erase(other) > 0) reached.push_back(other);
      }
  }
  return classes - 1;
}

inline int faults_of(const std::vector<oracle::Cell>& cells) {
  std::vector<std::set<std::set<std::uint32_t>>> facets;
  std::map<std::set<std::uint32_t>, std::set<std::size_t>> with;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    facets.push_back(facets_of(cells[c]));
    for (const auto a : cells[c])
      for (const auto b : cells[c])
        if (a < b) with[{a, b}].insert(c);
  }
  int faults = 0;
  for (const auto& [pair, own] : with) faults += faults_of_pair(facets, pair, own);
  return faults;
}

/// Whether more than two of the cells have the same facet.
inline bool has_facet_thrice(const std::vector<oracle::Cell>& cells) {
  std::map<std::set<std::uint32_t>, int> number;
  for (const auto& cell : cells)
    for (const auto& facet : facets_of(cell))
      if (++number[facet] > 2) return true;
  return false;
}

/// Meshes of this boundary with so many faults at least, as many as they say, not too many.
inline void expect_faulty_meshes(const std::vector<flips::FaultyMesh>& meshes,
                                 const canon::Code& code, const flips::FaultyWanted& wanted,
                                 int least_faults = 1) {
  for (const auto& [mesh, faults] : meshes) {
    EXPECT_GE(faults, least_faults);
    const auto cells = cells_of(mesh);
    EXPECT_EQ(faults, faults_of(cells));
    EXPECT_LT(static_cast<int>(cells.size()) + wanted.price * faults, wanted.below);
    EXPECT_EQ(oracle::boundary(cells).size(), static_cast<std::size_t>(code.quads));
    EXPECT_EQ(fault_of_mesh(mesh, code).empty(), faults == 0);
  }
}

inline void expect_same(const std::vector<flips::FaultyMesh>& some,
                        const std::vector<flips::FaultyMesh>& others) {
  ASSERT_EQ(some.size(), others.size());
  for (std::size_t i = 0; i < some.size(); ++i)
    EXPECT_EQ(some[i].mesh.hexahedra, others[i].mesh.hexahedra);
}

/// That `find`, within `limits(below, count)`, keeps to these and knows the faults of what it finds
/// for boundaries with 16 and 18 quads, the same for any number of threads.
template <typename Options, typename Find>
void expect_faults_are_known(Options (*limits)(int, std::size_t), const Find& find,
                             int least_faults = 1) {
  const auto beam = grown(20, 10, 1'000, 24);
  std::size_t all = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads < 16 || code.quads > 18) continue;
    Options options = limits(*beam.first_level(code) + 1 + 12, 12);
    const std::vector<flips::FaultyMesh> meshes = find(beam, code, options);
    EXPECT_LE(meshes.size(), options.wanted.count);
    expect_faulty_meshes(meshes, code, options.wanted, least_faults);
    all += meshes.size();
    options.collars.threads = 3;
    expect_same(find(beam, code, options), meshes);
    if (all > 60) break;
  }
  EXPECT_GT(all, 60U);
}

/// The numbers of faults and of hexahedra that there are among the meshes.
using Kinds = std::set<std::pair<int, int>>;
inline Kinds kinds_of(const std::vector<flips::FaultyMesh>& meshes) {
  Kinds kinds;
  for (const auto& [mesh, faults] : meshes)
    kinds.emplace(faults, static_cast<int>(mesh.hexahedra.size()));
  return kinds;
}

}  // namespace hexatlas::support
