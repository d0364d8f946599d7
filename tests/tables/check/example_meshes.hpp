#pragma once
/// \file
/// Hexahedral meshes made of unit cubes of the integer lattice, with their boundary surfaces, for
/// the tests of the judge. What is boundary and what is interior is read off the lattice, not
/// computed by the judge.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check::examples {

using Place = std::array<int, 3>;
using Places = std::set<Place>;

struct Example {
  Mesh mesh;
  Surface surface;
};

inline Places box(int nx, int ny, int nz) {
  Places places;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z) places.insert({x, y, z});
    }
  }
  return places;
}

/// The corners of the unit cube at `place` in VTK order.
inline std::array<Place, 8> corners_of(const Place& place) {
  const auto [x, y, z] = place;
  return {{{x, y, z},
           {x + 1, y, z},
           {x + 1, y + 1, z},
           {x, y + 1, z},
           {x, y, z + 1},
           {x + 1, y, z + 1},
           {x + 1, y + 1, z + 1},
           {x, y + 1, z + 1}}};
}

/// Corners of the sides of a cube, counter-clockwise from outside, with the way to the next cube.
struct CubeSide {
  Place way;
  std::array<std::size_t, 4> corners;
};
inline constexpr std::array<CubeSide, 6> kCubeSides = {{{{0, 0, -1}, {0, 3, 2, 1}},
                                                        {{0, 0, 1}, {4, 5, 6, 7}},
                                                        {{0, -1, 0}, {0, 1, 5, 4}},
                                                        {{1, 0, 0}, {1, 2, 6, 5}},
                                                        {{0, 1, 0}, {2, 3, 7, 6}},
                                                        {{-1, 0, 0}, {3, 0, 4, 7}}}};

/// Whether all eight cubes around a lattice point are among the places.
inline bool is_inside(const Places& places, const Place& point) {
  for (int i = 0; i < 8; ++i) {
    if (!places.contains({point[0] - (i & 1), point[1] - (i >> 1 & 1), point[2] - (i >> 2 & 1)})) {
      return false;
    }
  }
  return true;
}

/// The cubes at the given places; boundary points first, each kind in lexicographic order. A tenth
/// of the lattice coordinate is no short binary fraction, so that coordinates have all their bits.
inline Example cubes(const Places& places) {
  std::array<std::set<Place>, 2> points;
  for (const Place& place : places) {
    for (const Place& point : corners_of(place)) {
      points[is_inside(places, point) ? 1 : 0].insert(point);
    }
  }
  Example example;
  std::map<Place, std::uint32_t> number;
  for (const auto& kind : points) {
    for (const Place& point : kind) {
      number.emplace(point, static_cast<std::uint32_t>(number.size()));
      example.mesh.points.push_back({point[0] * 0.1, point[1] * 0.1, point[2] * 0.1});
    }
  }
  example.surface.points.assign(
      example.mesh.points.begin(),
      example.mesh.points.begin() + static_cast<std::ptrdiff_t>(points[0].size()));
  for (const Place& place : places) {
    Hexahedron cell{};
    const auto corners = corners_of(place);
    for (std::size_t i = 0; i < 8; ++i) cell[i] = number.at(corners[i]);
    example.mesh.hexahedra.push_back(cell);
    for (const auto& [way, side] : kCubeSides) {
      if (places.contains({place[0] + way[0], place[1] + way[1], place[2] + way[2]})) continue;
      example.surface.quads.push_back({cell[side[0]], cell[side[1]], cell[side[2]], cell[side[3]]});
    }
  }
  return example;
}

/// A small cube inside a cube, and a hexahedron between each two opposite sides: 7 hexahedra,
/// 8 interior vertices, the boundary of a cube.
inline Example cube_in_cube() {
  Example example = cubes({{0, 0, 0}});
  const Hexahedron outer = example.mesh.hexahedra[0];
  Hexahedron inner = outer;
  for (std::uint32_t& vertex : inner) vertex += 8;
  for (std::size_t v = 0; v < 8; ++v) {
    Point point = example.mesh.points[v];
    for (double& x : point) x = 0.025 + x / 2;
    example.mesh.points.push_back(point);
  }
  example.mesh.hexahedra = {inner};
  for (const auto& [way, side] : kCubeSides) {
    Hexahedron cell{};
    for (std::size_t i = 0; i < 4; ++i) {
      cell[i] = inner[side[i]];
      cell[i + 4] = outer[side[i]];
    }
    example.mesh.hexahedra.push_back(cell);
  }
  return example;
}

/// Three hexahedra around an edge, as in a hexagonal prism.
inline Example three_around_an_edge() {
  Example example;
  const std::array<Point, 6> ring = {
      {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}}};
  for (const double z : {0.0, 1.0}) {
    example.mesh.points.push_back({0, 0, z});
    for (const Point& point : ring) example.mesh.points.push_back({point[0], point[1], z});
  }
  example.surface.points = example.mesh.points;
  const auto at = [](std::uint32_t i) { return 1 + i % 6; };  // of the ring; 7 more is above it
  for (std::uint32_t i = 0; i < 6; i += 2) {
    const Quad base = {0, at(i), at(i + 1), at(i + 2)};
    Hexahedron cell{};
    for (std::size_t j = 0; j < 4; ++j) {
      cell[j] = base[j];
      cell[j + 4] = base[j] + 7;
    }
    example.mesh.hexahedra.push_back(cell);
    example.surface.quads.push_back({base[0], base[3], base[2], base[1]});
    example.surface.quads.push_back({cell[4], cell[5], cell[6], cell[7]});
    for (std::size_t j = 1; j < 3; ++j) {
      example.surface.quads.push_back({base[j], base[j + 1], base[j + 1] + 7, base[j] + 7});
    }
  }
  return example;
}

}  // namespace hexatlas::check::examples
