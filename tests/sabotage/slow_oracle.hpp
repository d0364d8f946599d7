#pragma once
/// \file
/// A slow and obvious test whether hexahedra obey the strict rule and have a given boundary, by
/// sets of vertices and all pairs. It says which damages of a mesh are true ones: a mesh that fails
/// here must be refused by the judge. It does not decide whether a mesh is a ball.

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check::oracle {

using VertexSet = std::set<std::uint32_t>;

/// Corners x + 2 y + 4 z of the VTK corners.
inline constexpr std::array<unsigned, 8> kBits = {0, 1, 3, 2, 4, 5, 7, 6};

/// The faces of a hexahedron of all dimensions, as sets: a face fixes some coordinates.
inline std::set<VertexSet> faces(const Hexahedron& cell) {
  std::set<VertexSet> result = {{}};
  for (unsigned fixed = 0; fixed < 8; ++fixed) {
    for (unsigned value = 0; value < 8; ++value) {
      VertexSet face;
      for (std::size_t i = 0; i < 8; ++i) {
        if ((kBits[i] & fixed) == (value & fixed)) face.insert(cell[i]);
      }
      result.insert(face);
    }
  }
  return result;
}

/// A cycle from its least vertex on.
inline Quad cycle(Quad quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  return quad;
}

/// The six quads of a hexahedron, counter-clockwise from outside: for each axis and side, the
/// square of the other two axes, whose order gives the outer normal.
inline std::vector<Quad> outer_quads(const Hexahedron& cell) {
  std::array<std::uint32_t, 8> by_bits{};
  for (std::size_t i = 0; i < 8; ++i) by_bits[kBits[i]] = cell[i];
  std::vector<Quad> quads;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1U << (axis + 1) % 3;
    const unsigned v = 1U << (axis + 2) % 3;
    const unsigned high = 1U << axis;
    quads.push_back({by_bits[high], by_bits[high + u], by_bits[high + u + v], by_bits[high + v]});
    quads.push_back({by_bits[0], by_bits[v], by_bits[u + v], by_bits[u]});
  }
  return quads;
}

inline bool obeys_strict_rule(const std::vector<Hexahedron>& cells) {
  std::vector<std::set<VertexSet>> all;
  for (const Hexahedron& cell : cells) {
    if (VertexSet(cell.begin(), cell.end()).size() != 8) return false;
    all.push_back(faces(cell));
  }
  for (std::size_t a = 0; a < cells.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      VertexSet shared;
      for (const std::uint32_t vertex : cells[a]) {
        if (std::find(cells[b].begin(), cells[b].end(), vertex) != cells[b].end()) {
          shared.insert(vertex);
        }
      }
      if (shared.size() == 8 || !all[a].contains(shared) || !all[b].contains(shared)) return false;
    }
  }
  return true;
}

/// The quads that are in no two hexahedra are `boundary`, in the same orientation; each other one
/// is in two hexahedra, in opposite orientations.
inline bool has_boundary(const std::vector<Hexahedron>& cells, const std::vector<Quad>& boundary) {
  std::map<Quad, int> uses;
  for (const Hexahedron& cell : cells) {
    for (const Quad& quad : outer_quads(cell)) ++uses[cycle(quad)];
  }
  std::multiset<Quad> once;
  for (const auto& [quad, count] : uses) {
    if (count != 1) return false;
    if (!uses.contains(cycle({quad[0], quad[3], quad[2], quad[1]}))) once.insert(quad);
  }
  std::multiset<Quad> wanted;
  for (const Quad& quad : boundary) wanted.insert(cycle(quad));
  return once == wanted;
}

/// The mesh against its surface, in the orientation of the hexahedra or the other.
inline bool fits(const Mesh& mesh, const Surface& surface) {
  const std::size_t size = surface.points.size() * sizeof(Point);
  if (mesh.points.size() < surface.points.size() ||
      std::memcmp(mesh.points.data(), surface.points.data(), size) != 0) {
    return false;
  }
  std::vector<Quad> reversed = surface.quads;
  for (Quad& quad : reversed) std::reverse(quad.begin(), quad.end());
  return obeys_strict_rule(mesh.hexahedra) &&
         (has_boundary(mesh.hexahedra, surface.quads) || has_boundary(mesh.hexahedra, reversed));
}

}  // namespace hexatlas::check::oracle
