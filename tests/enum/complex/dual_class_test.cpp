// Claim. The dual class compares meshes of one boundary as a difference does, is the parity of
// their numbers of hexahedra modulo 2, changes by that of the parts where parts are exchanged, and
// does not see flips nor how a mesh is written down.
// Oracle. Laws that no single step of the computation knows of; the boundary of the 4-cube.
#include "enum/complex/dual_class.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::dual_class;
using complex::Hexahedron;
using complex::HexComplex;
using complex::VertexId;

/// Some meshes of one boundary.
struct Meshes {
  VertexId shared = 0;
  std::vector<HexComplex> meshes;
};

/// Of boundaries with meshes of either parity.
const std::vector<Meshes>& varied() {
  static const std::vector<Meshes> kAll = [] {
    const flips::Beam beam = support::grown(20, 10, 1'500, 47);
    std::vector<Meshes> result;
    for (const auto& code : beam.codes()) {
      const auto fronts = beam.fronts_of(code);
      const auto is_odd = [](const auto& front) { return front.level % 2 == 1; };
      if (std::none_of(fronts.begin(), fronts.end(), is_odd) ||
          std::all_of(fronts.begin(), fronts.end(), is_odd))
        continue;
      Meshes& own = result.emplace_back();
      own.shared = static_cast<VertexId>(code.quads + 2);
      for (const auto& front : fronts) own.meshes.push_back(flips::filling_of(beam, front.id).mesh);
    }
    return result;
  }();
  return kAll;
}

TEST(DualClass, IsADifferenceAndTheParity) {
  std::array<int, 8> met{};
  for (const auto& [shared, meshes] : varied()) {
    std::vector<std::vector<int>> d(meshes.size());
    for (std::size_t a = 0; a < meshes.size(); ++a)
      for (const HexComplex& b : meshes) {
        d[a].push_back(dual_class(meshes[a], b, shared));
        ++met[static_cast<std::size_t>(d[a].back())];
        EXPECT_EQ(d[a].back() % 2,
                  static_cast<int>((meshes[a].hexahedra.size() + b.hexahedra.size()) % 2));
      }
    for (std::size_t a = 0; a < meshes.size(); ++a) {
      EXPECT_EQ(d[a][a], 0);
      for (std::size_t b = 0; b < meshes.size(); ++b)
        for (std::size_t c = 0; c < meshes.size(); ++c) ASSERT_EQ((d[a][b] + d[b][c]) % 8, d[a][c]);
    }
  }
  EXPECT_GT(met[1], 50);
  EXPECT_GT(met[2], 5);  // not the parity alone
}

TEST(DualClass, ChangesItsSignInAMirror) {
  for (const auto& [shared, meshes] : varied())
    for (const HexComplex& mesh : meshes)
      EXPECT_EQ((dual_class(mesh, meshes[0], shared) +
                 dual_class(mirrored(mesh), mirrored(meshes[0]), shared)) %
                    8,
                0);
}

/// A quarter turn about an axis, or the axes exchanged in a circle.
Hexahedron turned(const Hexahedron& cell, bool about_z) {
  Hexahedron result{};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t x = corner & 1U, y = corner >> 1U & 1U, z = corner >> 2U;
    result[about_z ? 1 - y + 2 * x + 4 * z : y + 2 * z + 4 * x] = cell[corner];
  }
  return result;
}

/// Hexahedra in another order, each turned, vertices inside renamed.
HexComplex written_anew(HexComplex mesh, VertexId shared, support::Random& random) {
  std::vector<VertexId> inside(mesh.vertices - shared);
  std::iota(inside.begin(), inside.end(), shared);
  random.shuffle(inside);
  for (Hexahedron& cell : mesh.hexahedra) {
    for (VertexId& v : cell)
      if (v >= shared) v = inside[v - shared];
    for (std::size_t i = random.below(12); i > 0; --i) cell = turned(cell, random.coin());
  }
  random.shuffle(mesh.hexahedra);
  return mesh;
}

TEST(DualClass, IsThatOfTheMeshHoweverWritten) {
  support::Random random(8);
  for (const auto& [shared, meshes] : varied())
    for (const HexComplex& mesh : meshes)
      EXPECT_EQ(dual_class(mesh, meshes[0], shared),
                dual_class(written_anew(mesh, shared, random),
                           written_anew(meshes[0], shared, random), shared));
}

/// Hexahedra around the whole mesh, one on each quad. Boundary vertices keep their names outside.
HexComplex wrapped(const HexComplex& mesh, VertexId shared) {
  HexComplex result{mesh.vertices + shared, mesh.hexahedra};
  for (Hexahedron& cell : result.hexahedra)
    for (VertexId& v : cell) v += shared;
  for (const auto& quad : boundary_of(mesh)) {
    Hexahedron& cell = result.hexahedra.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      constexpr std::array<std::size_t, 4> kCorner{0, 1, 3, 2};
      cell[kCorner[i]] = quad[i] + shared;
      cell[kCorner[i] + 4] = quad[i];
    }
  }
  return result;
}

TEST(DualClass, OfPartsIsThatOfTheWhole) {
  for (const auto& [shared, meshes] : varied())
    for (const HexComplex& mesh : meshes) {
      const int of_parts = dual_class(mesh, meshes[0], shared);
      const HexComplex a = wrapped(mesh, shared), b = wrapped(meshes[0], shared);
      ASSERT_EQ(dual_class(a, b, shared), of_parts);
    }
}

/// Some of the eight cubes in the boundary of the 4-cube, right-handed in that sphere.
HexComplex cubes_of_tesseract(unsigned chosen) {
  HexComplex result{16, {}};
  for (unsigned axis = 0; axis < 4; ++axis)
    for (unsigned side = 0; side < 2; ++side) {
      if ((chosen >> (2 * axis + side) & 1U) == 0) continue;
      Hexahedron& cell = result.hexahedra.emplace_back();
      for (unsigned corner = 0; corner < 8; ++corner) {
        const unsigned below = corner & ((1U << axis) - 1);
        cell[corner] = below | side << axis | (corner & ~((1U << axis) - 1)) << 1U;
      }
      if ((axis + side) % 2 == 1) cells::exchange_axes(cell);
    }
  return result;
}

TEST(DualClass, DoesNotSeeFlips) {
  int flips = 0;
  for (unsigned chosen = 1; chosen < 255; ++chosen) {
    HexComplex ball = cubes_of_tesseract(chosen), other = cubes_of_tesseract(255 - chosen);
    std::vector<VertexId> on_boundary;
    for (const auto& quad : boundary_of(ball))
      for (const VertexId v : quad)
        if (std::find(on_boundary.begin(), on_boundary.end(), v) == on_boundary.end())
          on_boundary.push_back(v);
    ball = renumbered(ball, on_boundary);
    other = renumbered(mirrored(other), on_boundary);
    if (validate(ball) || validate(other)) continue;  // not two balls
    const auto shared = static_cast<VertexId>(on_boundary.size());
    EXPECT_EQ(dual_class(ball, other, shared), 0) << chosen;
    ++flips;
  }
  EXPECT_EQ(flips, 256 - 16);  // all but those with both or none of each pair of opposite cubes
}

TEST(DualClass, SpreadingPutsTheLeastOfEachClassFirst) {
  for (const auto& [shared, meshes] : varied()) {
    const auto spread = complex::spread_over_dual_classes(meshes, shared);
    ASSERT_EQ(spread.size(), meshes.size());
    std::array<std::size_t, 8> met{};
    std::pair<std::size_t, std::size_t> last{0, 0};
    for (const HexComplex& mesh : spread) {
      const auto own = static_cast<std::size_t>(dual_class(mesh, meshes[0], shared));
      const std::pair now(met[own]++, mesh.hexahedra.size());
      EXPECT_LE(last, now);
      last = now;
    }
    for (const HexComplex& mesh : meshes)
      EXPECT_LE(spread.front().hexahedra.size(), mesh.hexahedra.size());
  }
}

}  // namespace
