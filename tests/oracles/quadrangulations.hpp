#pragma once
/// \file
/// Simple quadrangulations of the sphere, slowly and obviously: as cyclic lists of neighbours.
/// Generation by vertex splits, the inverse of face contractions, from the 4-cycle: every simple
/// quadrangulation is reached (V. Batagelj, Proc. 10th Yugoslav Sem. Graph Theory, 1989; Brinkmann
/// et al., Discrete Math. 305 (2005), whose expansions P0 and P1 are such splits). Whether a list
/// is complete is in addition told by a formula, see rooted_simple(). Uses nothing of hexatlas.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace hexatlas::oracle {

using QuadList = std::vector<std::array<std::uint8_t, 4>>;

/// around[v]: the neighbours of v, counter-clockwise seen from outside.
using Rotations = std::vector<std::vector<int>>;

inline Rotations four_cycle() { return {{1, 3}, {2, 0}, {3, 1}, {0, 2}}; }

/// Each vertex v, cut along two of its edges va and vb, becomes v and w, both joined to a and b.
inline std::vector<Rotations> splits_of(const Rotations& map) {
  std::vector<Rotations> result;
  const int w = static_cast<int>(map.size());
  for (int v = 0; v < w; ++v) {
    const auto& around = map[v];
    const std::size_t degree = around.size();
    for (std::size_t i = 0; i < degree; ++i)
      for (std::size_t length = 1; length < degree; ++length) {
        // w takes around[i] .. around[i + length], v keeps the rest and both ends.
        const int a = around[i];
        const int b = around[(i + length) % degree];
        Rotations split = map;
        split.emplace_back();
        for (std::size_t k = 0; k <= length; ++k) split[w].push_back(around[(i + k) % degree]);
        split[v].clear();
        for (std::size_t k = length; k <= degree; ++k) split[v].push_back(around[(i + k) % degree]);
        for (std::size_t k = 1; k < length; ++k)
          std::replace(split[split[w][k]].begin(), split[split[w][k]].end(), v, w);
        // At a the new edge aw comes before av, at b after bv: w lies to the right of a-v there.
        auto& at_a = split[a];
        at_a.insert(std::find(at_a.begin(), at_a.end(), v), w);
        auto& at_b = split[b];
        at_b.insert(std::find(at_b.begin(), at_b.end(), v) + 1, w);
        result.push_back(std::move(split));
      }
  }
  return result;
}

/// The faces, each counter-clockwise from its first vertex; empty if one is no quad.
inline QuadList quads_of(const Rotations& map) {
  QuadList quads;
  std::set<std::pair<int, int>> met;
  for (int u = 0; u < static_cast<int>(map.size()); ++u)
    for (const int first : map[u]) {
      if (met.contains({u, first})) continue;
      std::vector<int> face;
      int a = u;
      int b = first;
      while (met.insert({a, b}).second) {
        face.push_back(a);
        const auto& around = map[b];
        const auto at = std::find(around.begin(), around.end(), a) - around.begin();
        const auto size = static_cast<std::ptrdiff_t>(around.size());
        a = std::exchange(b, around[(at + size - 1) % size]);
      }
      if (face.size() != 4) return {};
      quads.push_back({static_cast<std::uint8_t>(face[0]), static_cast<std::uint8_t>(face[1]),
                       static_cast<std::uint8_t>(face[2]), static_cast<std::uint8_t>(face[3])});
    }
  return quads;
}

/// Whether the graph stays connected when any two vertices are taken away.
inline bool is_three_connected(const Rotations& map) {
  const int n = static_cast<int>(map.size());
  if (n < 4) return false;
  for (int x = 0; x < n; ++x)
    for (int y = x + 1; y < n; ++y) {
      std::vector<bool> reached(map.size(), false);
      std::vector<int> todo;
      for (int v = 0; v < n && todo.empty(); ++v)
        if (v != x && v != y) todo.push_back(v);
      reached[todo[0]] = true;
      int count = 1;
      while (!todo.empty()) {
        const int v = todo.back();
        todo.pop_back();
        for (const int u : map[v])
          if (u != x && u != y && !reached[u]) {
            reached[u] = true;
            ++count;
            todo.push_back(u);
          }
      }
      if (count != n - 2) return false;
    }
  return true;
}

/// Automorphisms of the map, and those that keep the orientation: all images of one edge tried.
struct GroupOrders {
  int all = 0;
  int rotations = 0;
};
inline GroupOrders automorphisms(const Rotations& map) {
  GroupOrders orders;
  const auto step = [&](int v, int from, int by) {  // next neighbour after `from`, cyclically
    const auto& around = map[v];
    const auto size = static_cast<std::ptrdiff_t>(around.size());
    const auto at = std::find(around.begin(), around.end(), from) - around.begin();
    return around[(at + by + size) % size];
  };
  const auto extends = [&](int image0, int image1, int by) {
    std::map<std::pair<int, int>, std::pair<int, int>> image;  // of directed edges
    std::vector<std::pair<int, int>> todo{{0, map[0][0]}};
    image[todo[0]] = {image0, image1};
    std::vector<int> vertex(map.size(), -1);
    while (!todo.empty()) {
      const auto [a, b] = todo.back();
      todo.pop_back();
      const auto [c, d] = image[{a, b}];
      if (map[a].size() != map[c].size() || (vertex[a] != -1 && vertex[a] != c)) return false;
      vertex[a] = c;
      const std::pair<int, int> turned{a, step(a, b, 1)}, turned_image{c, step(c, d, by)};
      const std::pair<int, int> back{b, a}, back_image{d, c};
      for (const auto& [edge, wanted] :
           {std::pair(turned, turned_image), std::pair(back, back_image)}) {
        const auto [place, is_new] = image.try_emplace(edge, wanted);
        if (is_new)
          todo.push_back(edge);
        else if (place->second != wanted)
          return false;
      }
    }
    return std::set<int>(vertex.begin(), vertex.end()).size() == map.size();
  };
  for (int v = 0; v < static_cast<int>(map.size()); ++v)
    for (const int u : map[v])
      for (const int by : {1, -1})
        if (extends(v, u, by)) {
          ++orders.all;
          if (by == 1) ++orders.rotations;
        }
  return orders;
}

/// Sum of 8 n / |Aut| over the simple quadrangulations with n quads: 2 (3k)! / ((2k+1)! (k+1)!)
/// with k = n - 1 (W. T. Tutte, A census of planar maps, 1963: rooted non-separable maps).
inline std::uint64_t rooted_simple(std::uint64_t n) {
  const std::uint64_t k = n - 1;
  // 2 (3k)! / ((2k+1)! (k+1)!), by products that stay integral: binomial(3k, k) first.
  std::uint64_t binomial = 1;
  for (std::uint64_t i = 1; i <= k; ++i) binomial = binomial * (2 * k + i) / i;
  return 2 * binomial / ((2 * k + 1) * (k + 1));
}

/// The same over all quadrangulations, multiple edges allowed: 2 * 3^n (2n)! / (n! (n+2)!)
/// (Tutte 1963: rooted maps with n edges).
inline std::uint64_t rooted_all(std::uint64_t n) {
  std::uint64_t binomial = 1;  // binomial(2n, n)
  std::uint64_t power = 1;
  for (std::uint64_t i = 1; i <= n; ++i) {
    binomial = binomial * (n + i) / i;
    power *= 3;
  }
  return 2 * power * binomial / ((n + 1) * (n + 2));
}

inline std::uint64_t catalan(std::uint64_t n) {
  std::uint64_t binomial = 1;
  for (std::uint64_t i = 1; i <= n; ++i) binomial = binomial * (n + i) / i;
  return binomial / (n + 1);
}

}  // namespace hexatlas::oracle
