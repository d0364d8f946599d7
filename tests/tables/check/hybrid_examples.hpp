#pragma once
/// \file
/// Hybrid meshes of boxes of lattice cubes, made at random: a cube stays a hexahedron, becomes two
/// prisms, six tetrahedra around a diagonal, or the cone from its centre over its facets, each of
/// which is a quad or two triangles. With a tetrahedral mesh of the same box that has the same
/// triangles on the boundary.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check::examples {

using Lattice = std::array<int, 3>;

/// The corners of a lattice cube are numbered x + 2 y + 4 z; here its facets, counterclockwise seen
/// from outside, each with its least corner first.
inline constexpr std::array<std::array<int, 4>, 6> kCubeFacets = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

enum class Cut : std::uint8_t { kWhole, kFromLeast, kOther };

struct Example {
  HybridMesh mesh;
  TetrahedralMesh given;
};

class ExampleMaker {
 public:
  /// `noise`: how far inner lattice points are moved, of the 16 between two of them; `warps`: those
  /// of the boundary, too.
  ExampleMaker(unsigned seed, Lattice size, int noise, bool warps)
      : random_(seed), size_(size), noise_(noise), warps_(warps) {}

  Example make() {
    std::vector<Lattice> cubes;
    for (int z = 0; z < size_[2]; ++z)
      for (int y = 0; y < size_[1]; ++y)
        for (int x = 0; x < size_[0]; ++x) cubes.push_back({x, y, z});
    std::shuffle(cubes.begin(), cubes.end(), random_);
    std::vector<Lattice> cones;
    for (const Lattice& cube : cubes)
      if (!fill(cube)) cones.push_back(cube);
    for (const Lattice& cube : cones) {
      const std::uint32_t centre = point({2 * cube[0] + 1, 2 * cube[1] + 1, 2 * cube[2] + 1});
      for (int f = 0; f < 6; ++f) {
        const auto quad = facet(cube, f);
        if (cut(cube, f, below(3)) == Cut::kWhole)
          example_.mesh.pyramids.push_back({quad[0], quad[3], quad[2], quad[1], centre});
        else
          for (const auto& t : halves(quad, cut(cube, f, 0)))
            example_.mesh.tetrahedra.push_back({t[0], t[2], t[1], centre});
      }
    }
    for (const Lattice& cube : cubes) {
      const std::uint32_t centre = point({2 * cube[0] + 1, 2 * cube[1] + 1, 2 * cube[2] + 1});
      for (int f = 0; f < 6; ++f) {
        Cut& here = cuts_[key(cube, f)];
        if (here == Cut::kWhole) here = below(2) == 0 ? Cut::kFromLeast : Cut::kOther;
        for (const auto& t : halves(facet(cube, f), here))
          example_.given.tetrahedra.push_back({t[0], t[2], t[1], centre});
      }
    }
    example_.given.points = example_.mesh.points;
    return example_;
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  /// By twice its lattice coordinates.
  std::uint32_t point(Lattice at) {
    const auto [found, is_new] =
        numbers_.emplace(at, static_cast<std::uint32_t>(example_.mesh.points.size()));
    if (is_new) {
      bool is_inner = true;
      for (std::size_t i = 0; i < 3; ++i) is_inner = is_inner && at[i] > 0 && at[i] < 2 * size_[i];
      Point p{};
      for (std::size_t i = 0; i < 3; ++i)
        p[i] =
            8 * at[i] + (noise_ > 0 && (is_inner || warps_) ? below(2 * noise_ + 1) - noise_ : 0);
      example_.mesh.points.push_back(p);
    }
    return found->second;
  }

  std::array<std::uint32_t, 8> corners(Lattice cube) {
    std::array<std::uint32_t, 8> v{};
    for (int i = 0; i < 8; ++i)
      v[static_cast<std::size_t>(i)] = point(
          {2 * (cube[0] + (i & 1)), 2 * (cube[1] + (i >> 1 & 1)), 2 * (cube[2] + (i >> 2 & 1))});
    return v;
  }
  std::array<std::uint32_t, 4> facet(Lattice cube, int f) {
    const auto v = corners(cube);
    std::array<std::uint32_t, 4> quad{};
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = v[static_cast<std::size_t>(kCubeFacets[static_cast<std::size_t>(f)][i])];
    return quad;
  }
  /// Twice the middle of the facet.
  static Lattice key(Lattice cube, int f) {
    constexpr std::array<Lattice, 6> kMiddles = {
        {{1, 1, 0}, {1, 1, 2}, {1, 0, 1}, {1, 2, 1}, {0, 1, 1}, {2, 1, 1}}};
    const Lattice& middle = kMiddles[static_cast<std::size_t>(f)];
    return {2 * cube[0] + middle[0], 2 * cube[1] + middle[1], 2 * cube[2] + middle[2]};
  }
  Cut cut(Lattice cube, int f, int otherwise) {
    return cuts_.emplace(key(cube, f), static_cast<Cut>(otherwise)).first->second;
  }
  static std::array<std::array<std::uint32_t, 3>, 2> halves(const std::array<std::uint32_t, 4>& q,
                                                            Cut cut) {
    if (cut == Cut::kFromLeast) return {{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}};
    return {{{q[1], q[2], q[3]}, {q[1], q[3], q[0]}}};
  }

  /// Asks for these cuts of the six facets; false, and nothing changed, if one is otherwise.
  bool ask(Lattice cube, const std::array<Cut, 6>& wanted) {
    for (int f = 0; f < 6; ++f) {
      const auto found = cuts_.find(key(cube, f));
      if (found != cuts_.end() && found->second != wanted[static_cast<std::size_t>(f)])
        return false;
    }
    for (int f = 0; f < 6; ++f) cuts_[key(cube, f)] = wanted[static_cast<std::size_t>(f)];
    return true;
  }

  /// Anything but a cone; false if what was chosen does not fit.
  bool fill(Lattice cube) {
    const auto v = corners(cube);
    std::array<Cut, 6> wanted{};
    switch (below(4)) {
      case 0:
        if (!ask(cube, wanted)) return false;
        example_.mesh.hexahedra.push_back({v[0], v[1], v[3], v[2], v[4], v[5], v[7], v[6]});
        return true;
      case 1: {
        const int axis = below(3);  // the triangles are on the facets across this axis
        const bool least = below(2) == 0;
        for (int f = 0; f < 2; ++f)
          wanted[static_cast<std::size_t>(4 - 2 * axis + f)] =
              least ? Cut::kFromLeast : Cut::kOther;
        if (!ask(cube, wanted)) return false;
        add_prisms(v, axis, least);
        return true;
      }
      case 2: {
        wanted.fill(Cut::kFromLeast);
        if (!ask(cube, wanted)) return false;
        for (const auto& path : std::array<std::array<std::size_t, 2>, 6>{
                 {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}}})
          example_.mesh.tetrahedra.push_back({v[0], v[path[0]], v[path[1]], v[7]});
        return true;
      }
      default:
        return false;
    }
  }

  void add_prisms(const std::array<std::uint32_t, 8>& v, int axis, bool least) {
    const auto step = std::size_t{1} << axis;
    const auto a = std::size_t{1} << (axis + 1) % 3, b = std::size_t{1} << (axis + 2) % 3;
    // The square 0, a, a + b, b turns counterclockwise seen against the axis.
    const std::array<std::size_t, 4> q = {0, a, a + b, b};
    const std::size_t first = least ? 0 : 1;
    for (const std::size_t at : {first, first + 2}) {
      const std::size_t x = q[at % 4], y = q[(at + 1) % 4], z = q[(at + 2) % 4];
      example_.mesh.prisms.push_back({v[x], v[y], v[z], v[x + step], v[y + step], v[z + step]});
    }
  }

  std::mt19937 random_;
  Lattice size_;
  int noise_;
  bool warps_;
  Example example_;
  std::map<Lattice, std::uint32_t> numbers_;
  std::map<Lattice, Cut> cuts_;
};

inline Example make_example(unsigned seed, Lattice size, int noise = 2, bool warps = false) {
  return ExampleMaker(seed, size, noise, warps).make();
}

}  // namespace hexatlas::check::examples
