#pragma once
/// \file
/// Closed surfaces of triangles, made by rule.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid_tests {

using mesh::Index;
using Place = std::array<int, 3>;

inline mesh::Facet triangle(Index a, Index b, Index c) { return {{a, b, c, 0}, 3, 0}; }

/// A generator of numbers from 0 to 1 that is the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// Which diagonals the squares get.
enum class Diagonals : std::uint8_t { alike, random };

/// The surface of the unit cubes of a box that are wanted, counter-clockwise from outside. Edges
/// where cubes meet only there are not separated.
inline mesh::FacetMesh surface_of_cubes(Place size, const std::function<bool(Place)>& is_wanted,
                                        Diagonals diagonals = Diagonals::alike) {
  const auto is_in = [&](Place c) {
    for (std::size_t k = 0; k < 3; ++k)
      if (c[k] < 0 || c[k] >= size[k]) return false;
    return is_wanted(c);
  };
  mesh::FacetMesh result;
  std::map<Place, Index> names;
  const auto vertex = [&](Place p) {
    const auto [it, is_new] = names.try_emplace(p, static_cast<Index>(result.points.size()));
    if (is_new)
      result.points.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return it->second;
  };
  Random random(1);
  const auto add = [&](Place cube, std::size_t axis, int side) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    std::array<Index, 4> quad{};
    constexpr std::array<std::array<int, 2>, 4> kCycle{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Place p = cube;
      p[axis] += side;
      p[u] += kCycle[i][side == 1 ? 0 : 1];
      p[v] += kCycle[i][side == 1 ? 1 : 0];
      quad[i] = vertex(p);
    }
    const std::size_t i = diagonals == Diagonals::random && random() < 0.5 ? 1 : 0;
    result.facets.push_back(triangle(quad[i], quad[i + 1], quad[(i + 2) % 4]));
    result.facets.push_back(triangle(quad[i], quad[(i + 2) % 4], quad[(i + 3) % 4]));
  };
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            Place next{x, y, z};
            next[axis] += 2 * side - 1;
            if (is_in({x, y, z}) && !is_in(next)) add({x, y, z}, axis, side);
          }
  return result;
}

/// Each point p put to a + b p.
inline mesh::FacetMesh moved(mesh::FacetMesh surface, double a, double b) {
  for (mesh::Point& p : surface.points) p = {a + b * p.x, a + b * p.y, a + b * p.z};
  return surface;
}

/// Turned around an axis that is none of the lattice.
inline mesh::FacetMesh turned(mesh::FacetMesh surface) {
  for (mesh::Point& p : surface.points) {
    p = {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
    p = {p.x, 5.0 / 13 * p.y - 12.0 / 13 * p.z, 12.0 / 13 * p.y + 5.0 / 13 * p.z};
  }
  return surface;
}

/// Quads of a grid that closes in the first direction, and in the second if `is_closed`; point
/// (i, j) has number i + around * j.
inline void append_grid(mesh::FacetMesh& surface, int around, int rows, bool is_closed) {
  const auto at = [&](int i, int j) {
    return static_cast<Index>(i % around + around * (j % rows));
  };
  for (int j = 0; j + (is_closed ? 0 : 1) < rows; ++j)
    for (int i = 0; i < around; ++i) {
      surface.facets.push_back(triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1)));
      surface.facets.push_back(triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1)));
    }
}

/// A torus around the z-axis.
inline mesh::FacetMesh torus(double great, double small, int around, int across) {
  mesh::FacetMesh result;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      const double s = 2 * std::numbers::pi * i / around;
      const double t = 2 * std::numbers::pi * j / across;
      const double r = great + small * std::cos(t);
      result.points.push_back({r * std::cos(s), r * std::sin(s), small * std::sin(t)});
    }
  append_grid(result, around, across, true);
  return result;
}

/// A sphere: the surface of a cube of n^3 cubes, put onto it.
inline mesh::FacetMesh sphere(double radius, int n) {
  mesh::FacetMesh result = surface_of_cubes({n, n, n}, [](Place) { return true; });
  for (mesh::Point& p : result.points) {
    const auto turn = [n](double x) { return std::tan((2 * x / n - 1) * std::numbers::pi / 4); };
    p = {turn(p.x), turn(p.y), turn(p.z)};
    const double s = radius / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    p = {s * p.x, s * p.y, s * p.z};
  }
  return result;
}

/// A cylinder around the z-axis, from 0 to `height`: a box of n * n * m cubes with the squares of
/// its top and bottom put onto discs.
inline mesh::FacetMesh cylinder(double radius, double height, int n, int m) {
  mesh::FacetMesh result = surface_of_cubes({n, n, m}, [](Place) { return true; });
  for (mesh::Point& p : result.points) {
    const double x = 2 * p.x / n - 1;
    const double y = 2 * p.y / n - 1;
    const double ring = std::max(std::abs(x), std::abs(y));  // of squares, made one of circles
    if (ring > 0) {
      const double angle =
          std::abs(x) >= std::abs(y)
              ? std::numbers::pi / 4 * y / x + (x < 0 ? std::numbers::pi : 0)
              : std::numbers::pi / 2 * (y < 0 ? -1 : 1) - std::numbers::pi / 4 * x / y;
      p.x = radius * ring * std::cos(angle);
      p.y = radius * ring * std::sin(angle);
    } else {
      p.x = p.y = 0;
    }
    p.z = height * p.z / m;
  }
  return result;
}

}  // namespace hexatlas::hybrid_tests
