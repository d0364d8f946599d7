#pragma once
/// \file
/// Closed 3-manifolds given by tetrahedra, slowly and obviously: what is one, all of them with few
/// vertices and labels, and a canonical form by walks. Uses nothing of hexatlas.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace hexatlas::oracle {

using Tetrahedron = std::array<int, 4>;  ///< ascending
using Tetrahedra = std::vector<Tetrahedron>;

inline std::set<int> vertex_set(const Tetrahedra& tetrahedra) {
  std::set<int> result;
  for (const auto& t : tetrahedra) result.insert(t.begin(), t.end());
  return result;
}

/// Whether these triangles, each ascending, form a connected surface with every edge in two of them
/// and Euler characteristic 2. (If so, all links of vertices being circles is left to check.)
inline bool is_sphere(const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::array<int, 2>, int> edges;
  std::map<int, std::map<int, std::vector<int>>> links;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& edge : {std::array{a, b}, std::array{a, c}, std::array{b, c}}) ++edges[edge];
    for (const auto& [v, x, y] : {std::array{a, b, c}, std::array{b, a, c}, std::array{c, a, b}}) {
      links[v][x].push_back(y);
      links[v][y].push_back(x);
    }
  }
  if (std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.second != 2; }))
    return false;
  // A link is a union of circles now; it is one if the turn meets all of its vertices.
  for (const auto& [v, link] : links) {
    std::set<int> met;
    for (int at = link.begin()->first; met.insert(at).second;) {
      const auto& next = link.at(at);
      at = met.contains(next[0]) ? next[1] : next[0];
    }
    if (met.size() != link.size()) return false;
  }
  std::set<int> reached{triangles.at(0)[0]};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [edge, count] : edges)
      if (reached.contains(edge[0]) || reached.contains(edge[1])) {
        reached.insert(edge[0]);
        reached.insert(edge[1]);
      }
  }
  const auto vertices = static_cast<int>(links.size());
  return reached.size() == links.size() &&
         vertices - static_cast<int>(edges.size()) + static_cast<int>(triangles.size()) == 2;
}

/// Closed and connected: every triangle in two tetrahedra, every link of a vertex a sphere. With at
/// most eight vertices it is a sphere then (A. Altshuler, L. Steinberg, 1974).
inline bool is_closed_manifold(const Tetrahedra& tetrahedra) {
  std::map<int, std::vector<std::array<int, 3>>> links;
  std::map<std::array<int, 3>, int> triangles;
  for (const auto& t : tetrahedra)
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<int, 3> facet{};
      std::size_t n = 0;
      for (std::size_t i = 0; i < 4; ++i)
        if (i != skip) facet[n++] = t[i];
      links[t[skip]].push_back(facet);
      ++triangles[facet];
    }
  if (tetrahedra.empty() ||
      std::any_of(triangles.begin(), triangles.end(), [](const auto& e) { return e.second != 2; }))
    return false;
  for (const auto& [v, link] : links)
    if (!is_sphere(link)) return false;
  // Links are connected, so the complex is connected if its graph is.
  std::set<int> reached{tetrahedra[0][0]};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& t : tetrahedra)
      if (std::any_of(t.begin(), t.end(), [&](int v) { return reached.contains(v); }))
        reached.insert(t.begin(), t.end());
  }
  return reached.size() == links.size();
}

struct WalkForm {
  Tetrahedra least;
  std::size_t automorphisms = 0;
  std::vector<int> orbit;  ///< least vertex of the orbit
};

/// The least image over all walks: a walk begins with a tetrahedron and an order of its vertices,
/// and numbers the vertices as it meets them across triangles. Requires chains of common triangles
/// between all tetrahedra, and the vertices 0, 1, ..
inline WalkForm walk_form(const Tetrahedra& tetrahedra) {
  std::map<std::array<int, 3>, std::vector<std::size_t>> at;
  const auto facet_without = [](const Tetrahedron& t, int vertex) {
    std::array<int, 3> facet{};
    std::copy_if(t.begin(), t.end(), facet.begin(), [&](int v) { return v != vertex; });
    return facet;
  };
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    for (const int v : tetrahedra[i]) at[facet_without(tetrahedra[i], v)].push_back(i);
  const std::size_t vertices = vertex_set(tetrahedra).size();
  WalkForm form;
  std::vector<std::vector<int>> numberings;  // those that give the least image
  for (std::size_t start = 0; start < tetrahedra.size(); ++start) {
    Tetrahedron order = tetrahedra[start];
    do {
      std::vector<int> met(order.begin(), order.end());
      std::vector<int> number(vertices, -1);
      for (int i = 0; i < 4; ++i) number[static_cast<std::size_t>(order[i])] = i;
      std::vector<std::size_t> walk{start};
      std::vector<bool> seen(tetrahedra.size(), false);
      seen[start] = true;
      for (std::size_t i = 0; i < walk.size(); ++i) {
        Tetrahedron here = tetrahedra[walk[i]];
        std::sort(here.begin(), here.end(), [&](int a, int b) {
          return number[static_cast<std::size_t>(a)] < number[static_cast<std::size_t>(b)];
        });
        for (const int v : here)
          for (const std::size_t next : at[facet_without(tetrahedra[walk[i]], v)]) {
            if (seen[next]) continue;
            seen[next] = true;
            walk.push_back(next);
            for (const int w : tetrahedra[next])
              if (number[static_cast<std::size_t>(w)] < 0) {
                number[static_cast<std::size_t>(w)] = static_cast<int>(met.size());
                met.push_back(w);
              }
          }
      }
      Tetrahedra image = tetrahedra;
      for (auto& t : image) {
        for (int& v : t) v = number[static_cast<std::size_t>(v)];
        std::sort(t.begin(), t.end());
      }
      std::sort(image.begin(), image.end());
      if (numberings.empty() || image < form.least) {
        form.least = image;
        numberings.clear();
      }
      if (image == form.least) numberings.push_back(met);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  form.automorphisms = numberings.size();
  form.orbit.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    int least = numberings[0][i];
    for (const auto& met : numberings) least = std::min(least, met[i]);
    form.orbit[static_cast<std::size_t>(numberings[0][i])] = least;
  }
  return form;
}

/// Counts, by number of tetrahedra, the closed 3-manifolds with the vertices 0 .. n-1 and their
/// labels that contain the tetrahedra 0 1 2 3 and 0 1 2 4: always covers the first triangle that is
/// in one tetrahedron only, in all ways. Each labelled manifold with t tetrahedra has 2 t
/// triangles, and each of the C(n,5) C(5,3) pairs of tetrahedra with a common triangle is in as
/// many of them.
class LabelledManifolds {
 public:
  explicit LabelledManifolds(int vertices) : vertices_(vertices) {
    for (const Tetrahedron& t : {Tetrahedron{0, 1, 2, 3}, Tetrahedron{0, 1, 2, 4}}) {
      add(t, 1);
      chosen_.push_back(t);
    }
    search();
  }
  [[nodiscard]] const std::map<std::size_t, std::uint64_t>& counts() const { return counts_; }

 private:
  void add(const Tetrahedron& t, int by) {
    for (std::size_t skip = 0; skip < 4; ++skip) degree_[triangle(t, skip)] += by;
    for (const int v : t) at_vertex_[static_cast<std::size_t>(v)] += by;
  }
  static unsigned triangle(const Tetrahedron& t, std::size_t skip) {
    unsigned set = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != skip) set |= 1U << static_cast<unsigned>(t[i]);
    return set;
  }
  void search() {
    const unsigned all = 1U << static_cast<unsigned>(vertices_);
    unsigned open = 0;
    while (open < all && degree_[open] != 1) ++open;
    if (open == all) {
      if (std::all_of(at_vertex_.begin(), at_vertex_.begin() + vertices_,
                      [](int n) { return n > 0; }) &&
          is_closed_manifold(chosen_))
        ++counts_[chosen_.size()];
      return;
    }
    for (int apex = 0; apex < vertices_; ++apex) {
      const unsigned bit = 1U << static_cast<unsigned>(apex);
      if ((open & bit) != 0) continue;
      Tetrahedron t{};
      std::size_t n = 0;
      for (int v = 0; v < vertices_; ++v)
        if (((open | bit) >> static_cast<unsigned>(v) & 1U) != 0) t[n++] = v;
      bool fits = true;
      for (std::size_t skip = 0; skip < 4; ++skip) fits = fits && degree_[triangle(t, skip)] < 2;
      if (!fits) continue;
      add(t, 1);
      chosen_.push_back(t);
      if (edges_are_open(t)) search();
      chosen_.pop_back();
      add(t, -1);
    }
  }
  /// No edge of t has a closed circle and something else as its link.
  [[nodiscard]] bool edges_are_open(const Tetrahedron& t) const {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        int around = 0;
        std::array<std::array<int, 2>, 9> link{};
        std::array<std::size_t, 9> degree{};
        const auto join = [&](int a, int b) {
          const auto v = static_cast<std::size_t>(a);
          link[v][degree[v]++] = b;
        };
        int start = 0;
        for (const auto& s : chosen_) {
          if (std::find(s.begin(), s.end(), t[i]) == s.end() ||
              std::find(s.begin(), s.end(), t[j]) == s.end())
            continue;
          ++around;
          std::array<int, 2> rest{};
          std::copy_if(s.begin(), s.end(), rest.begin(),
                       [&](int v) { return v != t[i] && v != t[j]; });
          join(rest[0], rest[1]);
          join(rest[1], rest[0]);
          start = rest[0];
        }
        int from = -1;
        int at = start;
        int length = 0;
        while (degree[static_cast<std::size_t>(at)] == 2 && (length == 0 || at != start)) {
          const auto& next = link[static_cast<std::size_t>(at)];
          const int to = next[0] == from ? next[1] : next[0];
          from = at;
          at = to;
          ++length;
        }
        const bool is_circle = length > 0 && at == start;
        if (is_circle && length != around) return false;
      }
    return true;
  }

  int vertices_;
  std::array<int, 1U << 9U> degree_{};
  std::array<int, 9> at_vertex_{};
  Tetrahedra chosen_;
  std::map<std::size_t, std::uint64_t> counts_;
};

}  // namespace hexatlas::oracle
