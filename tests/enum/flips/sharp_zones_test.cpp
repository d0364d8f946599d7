// Claim. Of a swept body, whatever quads its ends have, remove_sharp_zones() takes all layers but
// one, and single_layer() is the last one. take_overhangs() takes a plate on a neck up to the neck,
// or nothing. Where nothing is sharp nothing is taken. Whatever the angles say, only what may be
// taken is taken, they stay the same at twins, and a layer found fills the cavity. Oracle. Bodies
// by construction, layers by the levels of their vertices; complex::validate() and the consistency
// of peelings.
#include "enum/flips/sharp_zones.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/facing.hpp"
#include "tests/enum/flips/peelings.hpp"
#include "tests/enum/support.hpp"
#include "tests/meshing/hexahedrize/spheres.hpp"

namespace {

using namespace hexatlas;
using complex::Hexahedron;
using complex::QuadSphere;
using complex::VertexId;
using flips::Angles;
using flips::Peeling;
using support::expect_same_at_twins;
using support::peeling_of;
using support::Tower;

Angles all(const Peeling& peeling, std::int16_t angle) {
  return Angles(4 * std::size_t{peeling.quad_numbers()}, angle);
}

/// Right where a wall begins, flat elsewhere; at the four corners as many right angles as the end
/// has quads.
Angles angles_of(const Tower& tower, const Peeling& peeling) {
  Angles angles = all(peeling, 180);
  for (Peeling::Dart d = 0; d < angles.size(); ++d) {
    const VertexId a = peeling.origin(d), b = peeling.origin(Peeling::next(d));
    if (tower.level(a) != tower.level(b))
      angles[d] = static_cast<std::int16_t>(90 * tower.quads_at_corner(tower.below(a)));
    else if (tower.is_rim(d / 4) != tower.is_rim(peeling.twin(d) / 4))
      angles[d] = 90;
  }
  return angles;
}

/// Of block({5, 3, 2}): three times two faces.
int face_of(std::uint32_t quad) {
  int face = 0;
  for (const std::uint32_t quads : {6U, 6U, 10U, 10U, 15U, 15U}) {
    if (quad < quads) return face;
    quad -= quads;
    ++face;
  }
  return -1;
}

/// With the hexahedra of the cavity.
complex::HexComplex whole(const Peeling& peeling, const std::vector<Hexahedron>& rest) {
  complex::HexComplex mesh{peeling.vertices(), peeling.taken()};
  mesh.hexahedra.insert(mesh.hexahedra.end(), rest.begin(), rest.end());
  return mesh;
}

TEST(SharpZones, TakeTowersApart) {
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    for (const VertexId height : {1U, 2U, 5U}) {
      const Tower tower(support::random_sphere(24 + 6 * seed, seed, 20 + seed % 3 * 30), height);
      Peeling peeling = peeling_of(tower.sphere());
      Angles angles = angles_of(tower, peeling);
      EXPECT_EQ(flips::remove_sharp_zones(peeling, angles), height - 1);
      EXPECT_EQ(peeling.taken().size(), (height - 1) * tower.quads_of_end());
      support::expect_consistent(peeling);
      expect_same_at_twins(peeling, angles);
      const auto rest = flips::single_layer(peeling, angles);
      ASSERT_TRUE(rest);
      EXPECT_EQ(rest->size(), tower.quads_of_end());
      const complex::HexComplex mesh = whole(peeling, *rest);
      const auto fault = complex::validate(mesh);
      EXPECT_FALSE(fault) << fault->reason;
      EXPECT_TRUE(complex::has_boundary(mesh, tower.sphere().quads));
      EXPECT_EQ(mesh.vertices, (height + 1) * tower.vertices_of_end());
    }
}

TEST(SharpZones, GoInTheOrderAskedFor) {
  // The ends of a block have 6, 10 and 15 quads, for each quad of their zones 0.6, 0.71 and 0.94.
  for (const auto& [order, end] :
       {std::pair{flips::ZoneOrder::cheapest, 6U}, {flips::ZoneOrder::largest, 15U}}) {
    Peeling peeling = peeling_of(support::block({5, 3, 2}));
    Angles angles = all(peeling, 180);
    for (Peeling::Dart d = 0; d < angles.size(); ++d)
      if (face_of(d / 4) != face_of(peeling.twin(d) / 4)) angles[d] = 90;
    EXPECT_EQ(flips::remove_sharp_zones(peeling, angles, {flips::kRightAtRim, order}), 7U);
    EXPECT_EQ(peeling.quads(), 6U);
    // The first layer is below all quads of one face, so it has all its vertices twice.
    std::set<VertexId> of_layer;
    for (std::size_t i = 0; i < end; ++i)
      of_layer.insert(peeling.taken()[i].begin(), peeling.taken()[i].end());
    EXPECT_EQ(of_layer.size(), end == 6 ? 24U : 48U);
  }
}

TEST(SharpZones, TakeNothingWhereAllIsFlat) {
  for (const QuadSphere& sphere : {support::block({3, 2, 4}), support::random_sphere(60, 5)})
    for (const std::int16_t angle : std::array<std::int16_t, 3>{9, 180, 270}) {
      Peeling peeling = peeling_of(sphere);
      const auto before = support::seen(peeling);
      Angles angles = all(peeling, angle);
      EXPECT_EQ(flips::remove_sharp_zones(peeling, angles), 0U);
      EXPECT_EQ(support::seen(peeling), before);
      EXPECT_FALSE(flips::single_layer(peeling, angles));
    }
}

TEST(SharpZones, OneHexahedronIsALayer) {
  const Peeling peeling = peeling_of(support::grid_cube(1));
  const auto rest = flips::single_layer(peeling, all(peeling, 90));
  ASSERT_TRUE(rest);
  ASSERT_EQ(rest->size(), 1U);
  EXPECT_FALSE(complex::validate(whole(peeling, *rest)));
}

TEST(SharpZones, AnglesDecideOnlyWhatIsTried) {
  support::Random random(89);
  std::size_t removed = 0, layers = 0, strict = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const QuadSphere sphere = seed % 3 == 0   ? support::block({4, 3, 2})
                              : seed % 3 == 1 ? Tower(support::random_sphere(30, seed), 3).sphere()
                                              : support::random_sphere(40, seed, 80);
    Peeling peeling = peeling_of(sphere);
    Angles angles = all(peeling, 0);
    for (Peeling::Dart d = 0; d < angles.size(); ++d)
      angles[d] = angles[peeling.twin(d)] =
          static_cast<std::int16_t>(135 + 3 * random.below(seed % 2 == 0 ? 3 : 5));
    removed += flips::remove_sharp_zones(peeling, angles);
    flips::take_overhangs(peeling, angles);
    support::expect_consistent(peeling);
    expect_same_at_twins(peeling, angles);
    if (const auto rest = flips::single_layer(peeling, angles)) {
      ++layers;
      const complex::HexComplex mesh = whole(peeling, *rest);
      EXPECT_TRUE(complex::has_boundary(mesh, sphere.quads));
      // If it obeys the strict rule by itself, the whole does.
      if (!complex::validate(complex::renumbered({mesh.vertices, *rest}, {}))) {
        ++strict;
        const auto fault = complex::validate(mesh);
        EXPECT_FALSE(fault) << fault->reason;
      }
    }
  }
  EXPECT_GT(removed, 20U);
  EXPECT_GT(layers, 5U);
  EXPECT_GT(strict, 5U);
}

/// The quads within so many steps of one, none of which touches the rim; empty if one would.
std::vector<std::uint32_t> neck_of(const Tower& tower, const Peeling& peeling, std::uint32_t first,
                                   std::size_t most) {
  const auto is_inside = [&](std::uint32_t q) {
    for (Peeling::Dart d = 4 * q; d < 4 * q + 4; ++d)
      if (tower.is_corner(tower.below(peeling.origin(d)))) return false;
    return true;
  };
  std::vector<std::uint32_t> neck{first};
  for (std::size_t i = 0; i < neck.size() && neck.size() < most; ++i)
    for (Peeling::Dart d = 4 * neck[i]; d < 4 * neck[i] + 4; ++d) {
      const std::uint32_t q = peeling.twin(d) / 4;
      if (std::find(neck.begin(), neck.end(), q) == neck.end()) neck.push_back(q);
    }
  if (!std::all_of(neck.begin(), neck.end(), is_inside)) neck.clear();
  return neck;
}

TEST(SharpZones, OverhangsAreTakenUpToANeck) {
  support::Random random(97);
  std::size_t taken = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Tower tower(support::random_sphere(40 + seed, seed, 60), 1);
    Peeling peeling = peeling_of(tower.sphere());
    Angles angles = angles_of(tower, peeling);
    const auto ends = static_cast<std::uint32_t>(tower.quads_of_end());
    const auto neck = neck_of(tower, peeling, ends + static_cast<std::uint32_t>(random.below(ends)),
                              1 + random.below(8));
    const std::set<std::uint32_t> is_neck(neck.begin(), neck.end());
    for (const std::uint32_t q : neck)
      for (Peeling::Dart d = 4 * q; d < 4 * q + 4; ++d)
        if (!is_neck.contains(peeling.twin(d) / 4)) angles[d] = angles[peeling.twin(d)] = 270;
    const auto before = support::seen(peeling);
    const Angles given = angles;
    if (!flips::take_overhangs(peeling, angles)) {
      EXPECT_EQ(support::seen(peeling), before);
      EXPECT_EQ(angles, given);
      refused += neck.empty() ? 0 : 1;
      continue;
    }
    ++taken;
    support::expect_consistent(peeling);
    expect_same_at_twins(peeling, angles);
    // Each from the bottom to the top; what they leave is the neck, with walls around it.
    EXPECT_EQ(peeling.taken().size(), ends - neck.size());
    EXPECT_EQ(peeling.vertices(), before.vertices);
    for (const Hexahedron& cell : peeling.taken()) {
      std::multiset<VertexId> below;
      for (const VertexId v : cell) below.insert(tower.below(v));
      EXPECT_EQ(std::set(below.begin(), below.end()).size(), 4U);
      for (const VertexId v : cell) EXPECT_EQ(below.count(tower.below(v)), 2U);
    }
    for (const std::uint32_t q : neck) EXPECT_TRUE(peeling.is_live(q) && peeling.is_live(q - ends));
    for (const std::uint32_t q : peeling.live_quads())
      for (Peeling::Dart d = 4 * q; d < 4 * q + 4; ++d) EXPECT_GE(angles[d], 45);
  }
  EXPECT_GT(taken, 10U);
  EXPECT_LT(refused, taken);
}

/// A plate of 7 x 3 cubes on two necks of one cube each: what is between these has walls on two
/// sides at last, and cannot be taken off.
TEST(SharpZones, AnOverhangBetweenTwoNecksIsLeftWhole) {
  const std::array<VertexId, 3> cubes{7, 3, 1};
  Peeling peeling = peeling_of(support::block(cubes));
  const std::uint32_t bottom = 2 * 3 + 2 * 7;  // the quads along the first axis, then the second
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return bottom + 3 * x + y; };
  Angles angles = all(peeling, 180);
  for (Peeling::Dart d = 0; d < angles.size(); ++d) {
    const bool is_plate = d / 4 >= bottom, is_plate_beyond = peeling.twin(d) / 4 >= bottom;
    if (is_plate != is_plate_beyond) angles[d] = 90;
    if (!is_plate && !is_plate_beyond && d / 4 / 6 != peeling.twin(d) / 4 / 6) angles[d] = 90;
  }
  Angles one_neck = angles;
  for (const std::uint32_t x : {1U, 5U})
    for (Peeling::Dart d = 4 * at(x, 1); d < 4 * at(x, 1) + 4; ++d) {
      angles[d] = angles[peeling.twin(d)] = 270;
      if (x == 1) one_neck[d] = one_neck[peeling.twin(d)] = 270;
    }
  const auto before = support::seen(peeling);
  const Angles given = angles;
  EXPECT_FALSE(flips::take_overhangs(peeling, angles));
  EXPECT_EQ(support::seen(peeling), before);
  EXPECT_EQ(angles, given);
  EXPECT_TRUE(flips::take_overhangs(peeling, one_neck));
  EXPECT_EQ(peeling.taken().size(), 20U);
}

TEST(SharpZones, WantAnAngleForEachSide) {
  Peeling peeling = peeling_of(support::grid_cube(2));
  Angles few(5, 1);
  EXPECT_THROW(flips::remove_sharp_zones(peeling, few), core::PreconditionViolated);
  EXPECT_THROW(flips::take_overhangs(peeling, few), core::PreconditionViolated);
  EXPECT_THROW((void)flips::single_layer(peeling, few), core::PreconditionViolated);
}

}  // namespace
