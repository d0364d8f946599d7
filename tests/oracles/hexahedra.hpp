#pragma once
/// \file
/// The strict rule by coordinates of corners: two hexahedra meet in a face of both, where a face is
/// the set of vertices got by fixing some coordinates; quads have the same edges in both.
/// Uses the numbering of enum/cells/cube.hpp only as bits: corner v = x + 2y + 4z.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace hexatlas::oracle {

using Cell = std::array<std::uint32_t, 8>;
using Face = std::set<std::uint32_t>;
using Cycle = std::array<std::uint32_t, 4>;

/// The least of its rotations.
inline Cycle rotated(Cycle cycle) {
  Cycle least = cycle;
  for (int i = 0; i < 3; ++i) {
    std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
    least = std::min(least, cycle);
  }
  return least;
}
inline Cycle reversed(Cycle cycle) {
  std::swap(cycle[1], cycle[3]);
  return rotated(cycle);
}

/// Quads counter-clockwise from outside: of axis k, the other two axes in cyclic order.
inline std::vector<Cycle> outer_quads(const Cell& cell) {
  std::vector<Cycle> quads;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned u = 1U << (k + 1) % 3;
    const unsigned v = 1U << (k + 2) % 3;
    const unsigned top = 1U << k;
    quads.push_back(rotated({cell[0], cell[v], cell[u | v], cell[u]}));
    quads.push_back(rotated({cell[top], cell[top | u], cell[top | u | v], cell[top | v]}));
  }
  return quads;
}

/// Vertices, edges and quads of a hexahedron, and the empty face.
inline std::set<Face> faces(const Cell& cell) {
  std::set<Face> result{{}};
  for (unsigned fixed = 1; fixed < 8; ++fixed)
    for (unsigned value = 0; value < 8; ++value) {
      Face face;
      for (unsigned v = 0; v < 8; ++v)
        if ((v & fixed) == (value & fixed)) face.insert(cell[v]);
      result.insert(face);
    }
  return result;
}

/// Of numbers of any type, as other tests' cells have them: corners as in Cell.
template <class Index>
std::size_t corner_of(const std::array<Index, 8>& cell, Index v) {
  return static_cast<std::size_t>(std::find(cell.begin(), cell.end(), v) - cell.begin());
}

template <class Index>
bool is_edge(const std::array<Index, 8>& cell, Index u, Index v) {
  return std::has_single_bit(corner_of(cell, u) ^ corner_of(cell, v));
}

/// Whether these vertices of the cell are as many as agree in the coordinates in which they agree.
template <class Index>
bool are_face_of(const std::array<Index, 8>& cell, const std::vector<Index>& vertices) {
  std::size_t in_all = 7;
  std::size_t in_some = 0;
  for (const Index v : vertices) {
    in_all &= corner_of(cell, v);
    in_some |= corner_of(cell, v);
  }
  return vertices.size() == std::size_t{1} << std::popcount(in_all ^ in_some);
}

/// Whether there is a face of both with all common vertices, and the same edges in both. Requires
/// that both have eight vertices.
template <class Index>
bool meet_strictly(const std::array<Index, 8>& a, const std::array<Index, 8>& b) {
  std::vector<Index> common;
  for (const Index v : b)
    if (std::find(a.begin(), a.end(), v) != a.end()) common.push_back(v);
  if (common.empty()) return true;
  if (!are_face_of(a, common) || !are_face_of(b, common)) return false;
  for (const Index u : common)
    for (const Index v : common)
      if (is_edge(a, u, v) != is_edge(b, u, v)) return false;
  return common.size() < 8;
}

inline bool is_simple(const Cell& cell) { return Face(cell.begin(), cell.end()).size() == 8; }

/// Any two hexahedra meet in a face of both, and no quad is in three.
inline bool obeys_strict_rule(const std::vector<Cell>& cells) {
  std::map<Face, int> count;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_simple(cells[i])) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (!meet_strictly(cells[i], cells[j])) return false;
    for (const Cycle& quad : outer_quads(cells[i]))
      if (++count[Face(quad.begin(), quad.end())] > 2) return false;
  }
  return true;
}

/// Quads in exactly one hexahedron, from their least vertices on.
inline std::set<Cycle> boundary(const std::vector<Cell>& cells) {
  std::map<Face, std::vector<Cycle>> at;
  for (const Cell& cell : cells)
    for (const Cycle& quad : outer_quads(cell)) at[Face(quad.begin(), quad.end())].push_back(quad);
  std::set<Cycle> result;
  for (const auto& [face, cycles] : at)
    if (cycles.size() == 1) result.insert(cycles[0]);
  return result;
}

/// The faces of a complex of all hexahedra listed, by Euler's count: V - E + F - H.
inline int euler_characteristic(const std::vector<Cell>& cells) {
  std::set<Face> all;
  for (const Cell& cell : cells)
    for (const Face& face : faces(cell))
      if (!face.empty()) all.insert(face);
  int sum = -static_cast<int>(cells.size());
  for (const Face& face : all) sum += face.size() == 2 ? -1 : 1;
  return sum;
}

/// Whether, taken in this order, each hexahedron meets those before it in a disc of facets whose
/// complement in its boundary is a disc: connected sets of facets with Euler characteristic 1.
inline bool is_shelling(const std::vector<Cell>& cells) {
  std::set<Face> present;
  const auto is_disc = [](const std::vector<Face>& quads, const Cell& cell) {
    if (quads.empty()) return false;
    std::set<Face> parts;
    for (const Face& face : faces(cell))
      for (const Face& quad : quads)
        if (!face.empty() && std::includes(quad.begin(), quad.end(), face.begin(), face.end()))
          parts.insert(face);
    int euler = 0;
    for (const Face& face : parts) euler += face.size() == 2 ? -1 : 1;
    std::vector<Face> todo{quads[0]};
    std::set<Face> reached{quads[0]};
    while (!todo.empty()) {
      const Face quad = todo.back();
      todo.pop_back();
      for (const Face& other : quads) {
        Face common;
        std::set_intersection(quad.begin(), quad.end(), other.begin(), other.end(),
                              std::inserter(common, common.end()));
        if (common.size() == 2 && reached.insert(other).second) todo.push_back(other);
      }
    }
    return euler == 1 && reached.size() == quads.size();
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::set<Face> own = faces(cells[i]);
    if (i > 0) {
      std::vector<Face> shared, free;
      for (const Face& face : own)
        if (face.size() == 4) (present.contains(face) ? shared : free).push_back(face);
      if (!is_disc(shared, cells[i]) || !is_disc(free, cells[i])) return false;
      for (const Face& face : own)
        if (!face.empty() && face.size() < 4 && present.contains(face) &&
            std::none_of(shared.begin(), shared.end(), [&](const Face& quad) {
              return std::includes(quad.begin(), quad.end(), face.begin(), face.end());
            }))
          return false;
    }
    present.insert(own.begin(), own.end());
  }
  return true;
}

/// An nx by ny by nz box of unit cubes; vertex (x, y, z) has number x + (nx+1)(y + (ny+1) z).
inline std::vector<Cell> grid(unsigned nx, unsigned ny, unsigned nz) {
  std::vector<Cell> cells;
  for (unsigned z = 0; z < nz; ++z)
    for (unsigned y = 0; y < ny; ++y)
      for (unsigned x = 0; x < nx; ++x) {
        Cell cell{};
        for (unsigned v = 0; v < 8; ++v)
          cell[v] =
              x + (v & 1U) + (nx + 1) * (y + (v >> 1U & 1U) + (ny + 1) * (z + (v >> 2U & 1U)));
        cells.push_back(cell);
      }
  return cells;
}

}  // namespace hexatlas::oracle
