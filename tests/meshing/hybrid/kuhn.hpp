#pragma once
/// \file
/// Lattices of cubes, each cut into six tetrahedra around its diagonal, and small Delaunay meshes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>

#include "meshing/delaunay/triangulation.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid_tests {

/// n^3 cubes; coordinates are multiples of `step`. Vertex (i (n+1) + j) (n+1) + k.
inline mesh::TetMesh kuhn(unsigned n, double step) {
  mesh::TetMesh mesh;
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned k = 0; k <= n; ++k) mesh.points.push_back({i * step, j * step, k * step});
  for (unsigned cube = 0; cube < n * n * n; ++cube) {
    std::array<unsigned, 3> axes{0, 1, 2};
    do {
      std::array<unsigned, 3> at{cube / (n * n), cube / n % n, cube % n};
      const auto number = [&] { return (at[0] * (n + 1) + at[1]) * (n + 1) + at[2]; };
      std::array<mesh::Index, 4> t{number()};
      for (unsigned s = 0; s < 3; ++s) {
        ++at[axes[s]];
        t[s + 1] = number();
      }
      const bool is_odd = (axes[0] > axes[1]) != ((axes[1] > axes[2]) != (axes[0] > axes[2]));
      if (is_odd) std::swap(t[2], t[3]);
      mesh.tetrahedra.push_back(t);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return mesh;
}

/// The Delaunay triangulation of random points with integer coordinates below `side`.
inline mesh::TetMesh random_delaunay(std::size_t points, unsigned side, std::mt19937_64& random) {
  mesh::TetMesh mesh;
  const auto coordinate = [&] { return static_cast<double>(random() % side); };
  while (mesh.points.size() < points) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const mesh::Point p{x, y, z};
    if (std::find(mesh.points.begin(), mesh.points.end(), p) == mesh.points.end())
      mesh.points.push_back(p);
  }
  mesh.tetrahedra = delaunay::Triangulation(mesh.points).tetrahedra();
  return mesh;
}

}  // namespace hexatlas::hybrid_tests
