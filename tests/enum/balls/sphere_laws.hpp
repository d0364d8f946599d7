#pragma once
/// \file
/// Laws of lists of spheres that a fast and a long test check.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "enum/balls/spheres.hpp"
#include "enum/canon/nauty/triangulation_form.hpp"
#include "tests/enum/balls/support.hpp"

namespace hexatlas::support {

inline void expect_distinct_and_sorted(const balls::Spheres& list) {
  EXPECT_TRUE(std::is_sorted(list.found.begin(), list.found.end(), balls::is_before));
  EXPECT_EQ(std::adjacent_find(list.found.begin(), list.found.end()), list.found.end());
  for (const auto& sphere : list.found)
    EXPECT_EQ(canon::triangulation_form(sphere).canonical, sphere);
}

/// The numbers of labelled manifolds that the classes stand for are those of the oracle. All closed
/// 3-manifolds with at most eight vertices are spheres.
inline void expect_all_manifolds(int vertices) {
  // Pairs of tetrahedra with a common triangle in labelled manifolds: by manifold, then by pair.
  std::uint64_t factorial = 1;
  for (int i = 2; i <= vertices; ++i) factorial *= static_cast<std::uint64_t>(i);
  std::map<std::size_t, std::uint64_t> by_class;
  for (const auto& sphere : balls::spheres(vertices).found)
    by_class[sphere.tetrahedra.size()] +=
        factorial / canon::triangulation_form(sphere).automorphisms * 2U * sphere.tetrahedra.size();
  std::uint64_t fives = 1;
  for (int i = 0; i < 5; ++i)
    fives = fives * static_cast<std::uint64_t>(vertices - i) / static_cast<std::uint64_t>(i + 1);
  std::map<std::size_t, std::uint64_t> by_pair;
  const oracle::LabelledManifolds manifolds(vertices);
  for (const auto& [size, count] : manifolds.counts()) by_pair[size] = count * 10U * fives;
  EXPECT_EQ(by_class, by_pair);
}

}  // namespace hexatlas::support
