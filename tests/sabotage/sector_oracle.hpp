#pragma once
/// \file
/// A slow reading of docs/formats/sectors.md, for tests: the surface written out quad by quad, each
/// law by going through all pairs, balls by collapses. And sectors to begin with: one of 30
/// hexahedra that has scars, from a file, and layers around it, which have none.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/bytes_of.hpp"
#include "tests/oracles/hexahedra.hpp"

namespace hexatlas::sabotage {

using SlowQuad = std::array<int, 4>;
using SlowHex = std::array<int, 8>;  ///< corner x + 2 y + 4 z

struct SlowSector {
  int vertices = 0;
  std::vector<SlowHex> cells;
};

/// Counter-clockwise from outside.
inline const std::vector<SlowQuad> kSectorQuads = {
    {0, 1, 2, 3},   {0, 3, 4, 5},                                         // base
    {0, 16, 7, 1},  {16, 17, 8, 7},   {17, 6, 15, 8},   {17, 16, 0, 6},   // wall 0
    {1, 7, 18, 2},  {7, 8, 19, 18},   {8, 15, 9, 19},   {9, 2, 18, 19},   // wall 1
    {2, 20, 10, 3}, {20, 21, 11, 10}, {21, 9, 15, 11},  {21, 20, 2, 9},   // wall 2
    {3, 10, 22, 4}, {10, 11, 23, 22}, {11, 15, 12, 23}, {12, 4, 22, 23},  // wall 3
    {4, 24, 13, 5}, {24, 25, 14, 13}, {25, 12, 15, 14}, {25, 24, 4, 12},  // wall 4
    {5, 13, 26, 0}, {13, 14, 27, 26}, {14, 15, 6, 27},  {6, 0, 26, 27}};  // wall 5

/// The same.
inline const std::vector<SlowQuad> kHexQuads = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

inline std::string text_of(const std::vector<SlowSector>& sectors) {
  std::ostringstream text;
  text << "hexatlas sectors 1\n";
  for (const SlowSector& sector : sectors) {
    text << "sector " << sector.cells.size() << " " << sector.vertices << "\n";
    for (const SlowHex& cell : sector.cells) {
      for (std::size_t i = 0; i < 8; ++i) text << cell[i] << (i < 7 ? " " : "\n");
    }
  }
  return text.str();
}

/// Nothing for bytes that are not of the format: words are read however they are separated, then
/// written as the format wants them; the bytes must be these.
inline std::optional<std::vector<SlowSector>> slow_read(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  for (int i = 0; i < 3; ++i) words >> word;
  std::vector<SlowSector> sectors;
  while (words >> word) {
    std::size_t hexahedra = 0;
    SlowSector sector;
    if (!(words >> hexahedra >> sector.vertices)) return std::nullopt;
    if (hexahedra < 1 || hexahedra > 1000) return std::nullopt;
    sector.cells.resize(hexahedra);
    if (sector.vertices <= 28 || sector.vertices > 8 * static_cast<int>(hexahedra)) {
      return std::nullopt;
    }
    for (SlowHex& cell : sector.cells) {
      for (int& v : cell) {
        if (!(words >> v) || v < 0 || v >= sector.vertices) return std::nullopt;
      }
    }
    sectors.push_back(std::move(sector));
  }
  if (sectors.empty() || text_of(sectors) != text) return std::nullopt;
  return sectors;
}

inline SlowQuad turned(SlowQuad quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  return quad;
}

/// Exactly the surface, and inside each quad in two hexahedra that traverse it in opposite ways.
inline bool has_slow_boundary(const SlowSector& sector) {
  std::map<std::set<int>, std::vector<SlowQuad>> uses;
  for (const SlowHex& cell : sector.cells) {
    for (const SlowQuad& side : kHexQuads) {
      SlowQuad quad{};
      for (std::size_t i = 0; i < 4; ++i) quad[i] = cell[static_cast<std::size_t>(side[i])];
      uses[{quad.begin(), quad.end()}].push_back(turned(quad));
    }
  }
  std::set<SlowQuad> boundary;
  for (const auto& [set, cycles] : uses) {
    if (cycles.size() == 1) boundary.insert(cycles[0]);
    if (cycles.size() > 2) return false;
    if (cycles.size() == 2) {
      const auto [a, b, c, d] = cycles[0];
      if (cycles[1] != turned({d, c, b, a})) return false;
    }
  }
  std::set<SlowQuad> surface;
  for (const SlowQuad& quad : kSectorQuads) surface.insert(turned(quad));
  return boundary == surface;
}

using Pairs = std::set<std::pair<int, int>>;

inline bool is_connected(const Pairs& edges) {
  if (edges.empty()) return false;
  std::set<int> reached = {edges.begin()->first};
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& [u, v] : edges) {
      if (reached.contains(u) != reached.contains(v)) {
        reached.insert({u, v});
        grows = true;
      }
    }
  }
  return std::all_of(edges.begin(), edges.end(),
                     [&](const auto& edge) { return reached.contains(edge.first); });
}

/// The triangles around a vertex are a disc, or a sphere if the vertex is interior.
inline bool has_slow_link(const SlowSector& sector, int vertex) {
  std::map<std::pair<int, int>, int> uses;
  std::map<int, Pairs> opposite;
  Pairs edges;
  int triangles = 0;
  for (const SlowHex& cell : sector.cells) {
    const auto at = std::find(cell.begin(), cell.end(), vertex);
    if (at == cell.end()) continue;
    const auto corner = static_cast<std::size_t>(at - cell.begin());
    std::array<int, 3> triangle = {cell[corner ^ 1U], cell[corner ^ 2U], cell[corner ^ 4U]};
    std::sort(triangle.begin(), triangle.end());
    const auto [u, v, w] = triangle;
    ++triangles;
    for (const auto& [edge, other] : {std::pair(std::pair(u, v), w), std::pair(std::pair(u, w), v),
                                      std::pair(std::pair(v, w), u)}) {
      ++uses[edge];
      edges.insert(edge);
      opposite[other].insert(edge);
    }
  }
  bool has_boundary = false;
  for (const auto& [edge, times] : uses) {
    if (times > 2) return false;
    if (times == 1) has_boundary = true;
  }
  for (const auto& [other, around] : opposite) {
    if (!is_connected(around)) return false;
  }
  const int euler = static_cast<int>(opposite.size()) - static_cast<int>(edges.size()) + triangles;
  return is_connected(edges) && has_boundary == (vertex < 28) && euler == (has_boundary ? 1 : 2);
}

/// The faces of all dimensions, and a search for a sequence of collapses to one vertex.
class SlowCollapse {
 public:
  explicit SlowCollapse(const SlowSector& sector) {
    for (const SlowHex& cell : sector.cells) {
      // A face: for each coordinate 0, 1 or both.
      std::map<std::array<int, 3>, int> at;
      for (int code = 0; code < 27; ++code) {
        const std::array<int, 3> face = {code % 3, code / 3 % 3, code / 9};
        at[face] = number_of(cell, face);
      }
      for (const auto& [face, number] : at) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (face[k] != 2) continue;
          std::array<int, 3> side = face;
          for (side[k] = 0; side[k] < 2; ++side[k]) {
            sides_[number].insert(at[side]);
            cofaces_[at[side]].insert(number);
          }
        }
      }
    }
  }

  bool succeeds() const {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      if (try_order(seed)) return true;
    }
    return false;
  }

 private:
  int number_of(const SlowHex& cell, const std::array<int, 3>& face) {
    std::set<int> vertices;
    for (std::size_t c = 0; c < 8; ++c) {
      bool is_in = true;
      for (std::size_t k = 0; k < 3; ++k) {
        is_in = is_in && (face[k] == 2 || face[k] == static_cast<int>(c >> k & 1U));
      }
      if (is_in) vertices.insert(cell[c]);
    }
    return numbers_.emplace(vertices, static_cast<int>(numbers_.size())).first->second;
  }

  bool try_order(std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    std::vector<std::vector<int>> faces(9);  // by number of vertices
    for (const auto& [vertices, number] : numbers_) faces[vertices.size()].push_back(number);
    std::map<int, std::set<int>> cofaces = cofaces_;
    std::set<int> gone;
    for (const std::size_t size : {4U, 2U, 1U}) {  // quads, edges, vertices
      std::shuffle(faces[size].begin(), faces[size].end(), random);
      for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (const int face : faces[size]) {
          if (gone.contains(face) || cofaces[face].size() != 1) continue;
          const int larger = *cofaces[face].begin();
          gone.insert({face, larger});
          for (const int whole : {face, larger}) {
            const auto sides = sides_.find(whole);
            if (sides == sides_.end()) continue;
            for (const int side : sides->second) cofaces[side].erase(whole);
          }
          goes_on = true;
        }
      }
    }
    return gone.size() + 1 == numbers_.size();
  }

  std::map<std::set<int>, int> numbers_;
  std::map<int, std::set<int>> sides_;    ///< of one dimension less
  std::map<int, std::set<int>> cofaces_;  ///< of one dimension more
};

inline bool is_slow_sector(const SlowSector& sector) {
  std::set<int> used;
  for (const SlowHex& cell : sector.cells) {
    if (std::set<int>(cell.begin(), cell.end()).size() != 8) return false;
    used.insert(cell.begin(), cell.end());
  }
  if (static_cast<int>(used.size()) != sector.vertices) return false;
  if (!has_slow_boundary(sector)) return false;
  for (std::size_t a = 0; a < sector.cells.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!oracle::meet_strictly(sector.cells[a], sector.cells[b])) return false;
    }
  }
  for (int v = 0; v < sector.vertices; ++v) {
    if (!has_slow_link(sector, v)) return false;
  }
  return SlowCollapse(sector).succeeds();
}

inline std::size_t slow_scars(const SlowSector& sector) {
  Pairs pairs;
  for (const SlowHex& cell : sector.cells) {
    for (const int u : cell) {
      for (const int v : cell) {
        if (u < v && v < 28) pairs.emplace(u, v);
      }
    }
  }
  const auto is_in_a_quad = [](const std::pair<int, int>& pair) {
    return std::any_of(kSectorQuads.begin(), kSectorQuads.end(), [&](const SlowQuad& quad) {
      return std::find(quad.begin(), quad.end(), pair.first) != quad.end() &&
             std::find(quad.begin(), quad.end(), pair.second) != quad.end();
    });
  };
  std::erase_if(pairs, is_in_a_quad);
  return pairs.size();
}

/// The least number of hexahedra of a sector without scars, 0 if the file breaks a law.
inline std::size_t slow_least(const std::vector<SlowSector>& sectors) {
  std::size_t least = 0;
  for (const SlowSector& sector : sectors) {
    if (slow_scars(sector) != 0) continue;
    least = least == 0 ? sector.cells.size() : std::min(least, sector.cells.size());
  }
  const auto all = [&](bool (*law)(const SlowSector&)) {
    return std::all_of(sectors.begin(), sectors.end(), law);
  };
  // The boundary first: almost all damages are seen there.
  return least != 0 && all(has_slow_boundary) && all(is_slow_sector) ? least : 0;
}

/// A hexahedron between each quad of the surface and an inner copy of it, which `inside` fills.
inline SlowSector layer_around(const SlowSector& inside) {
  SlowSector sector{inside.vertices + 28, {}};
  for (const auto& [a, b, c, d] : kSectorQuads) {
    sector.cells.push_back({a + 28, b + 28, d + 28, c + 28, a, b, d, c});
  }
  for (SlowHex cell : inside.cells) {
    for (int& v : cell) v += 28;
    sector.cells.push_back(cell);
  }
  return sector;
}

/// The only sector of that file: 30 hexahedra on 49 vertices, with scars.
inline SlowSector scarred_sector() {
  return slow_read(support::bytes_of(HEXATLAS_SOURCE_DIR "/tests/tables/check/scarred.hxs"))
      .value()
      .at(0);
}

}  // namespace hexatlas::sabotage
