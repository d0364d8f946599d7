// Claim. interior_angles() are those of blocks, of an L and of prisms, at any place and scale.
// meshes_by_sharp_zones() gives a swept body its layers, and one with recesses its cubes, and the
// judge accepts the mesh; it says nothing of a body without sharp edges. Layers with several rims
// are what recesses need; all that are taken leave a consistent peeling. Oracle. Angles by hand;
// bodies by construction.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/flips/facing.hpp"
#include "enum/flips/sharp_zones.hpp"
#include "meshing/hexahedrize/angles.hpp"
#include "tests/enum/flips/peelings.hpp"
#include "tests/meshing/hexahedrize/peeled.hpp"

namespace {

using namespace hexatlas;
using complex::BoundaryQuad;
using complex::QuadSphere;
using complex::VertexId;
using flips::Peeling;
using mesh::Point;
using support::table;

struct Body {
  QuadSphere sphere;
  std::vector<Point> points;  ///< of its vertices

  /// Of the points given, those of vertices of the sphere.
  Body(const std::vector<BoundaryQuad>& quads, const std::vector<Point>& of)
      : sphere(support::sphere_of(quads, of.size())) {
    for (const auto p : sphere.point_of) points.push_back(of[p]);
  }
};

/// A polygon of 2n corners around an axis, with n quads that meet in its middle at either end.
Body prism(VertexId n, VertexId height) {
  const VertexId ring = 2 * n, level = ring + 1;
  std::vector<Point> points;
  for (VertexId z = 0; z <= height; ++z) {
    for (VertexId i = 0; i < ring; ++i) {
      const double angle = std::numbers::pi * i / n;
      points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(z)});
    }
    points.push_back({0, 0, static_cast<double>(z)});
  }
  std::vector<BoundaryQuad> quads;
  const auto at = [&](VertexId z, VertexId i) { return z * level + i % ring; };
  for (VertexId i = 0; i < ring; i += 2) {
    quads.push_back({ring, at(0, i + 2), at(0, i + 1), at(0, i)});
    quads.push_back({height * level + ring, at(height, i), at(height, i + 1), at(height, i + 2)});
  }
  for (VertexId z = 0; z < height; ++z)
    for (VertexId i = 0; i < ring; ++i)
      quads.push_back({at(z, i), at(z, i + 1), at(z + 1, i + 1), at(z + 1, i)});
  return {quads, points};
}

/// Three cubes in an L.
Body ell() {
  std::vector<Point> points;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] :
         {std::pair{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}})
      points.push_back({static_cast<double>(x), static_cast<double>(y), z});
  std::vector<BoundaryQuad> quads{{0, 7, 4, 1}, {1, 4, 3, 2}, {7, 6, 5, 4}};
  for (const BoundaryQuad& quad : std::vector<BoundaryQuad>(quads)) {
    const auto& [a, b, c, d] = quad;
    quads.push_back({a + 8, d + 8, c + 8, b + 8});
  }
  for (VertexId i = 0; i < 8; ++i) quads.push_back({i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i});
  return {quads, points};
}

using Place = std::array<int, 3>;

/// Of cubes with these least corners.
Body of_cubes(const std::set<Place>& cubes) {
  std::map<Place, VertexId> number;
  std::vector<BoundaryQuad> quads;
  for (const Place& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Place beyond = cube;
        beyond[axis] += 2 * side - 1;
        if (cubes.contains(beyond)) continue;
        BoundaryQuad quad{};
        for (std::size_t i = 0; i < 4; ++i) {
          Place corner = cube;
          corner[axis] += side;
          corner[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
          corner[(axis + 2) % 3] += i >= 2 ? 1 : 0;
          quad[side == 1 ? i : 3 - i] =
              number.try_emplace(corner, static_cast<VertexId>(number.size())).first->second;
        }
        quads.push_back(quad);
      }
  std::vector<Point> points(number.size());
  for (const auto& [place, v] : number)
    points[v] = {static_cast<double>(place[0]), static_cast<double>(place[1]),
                 static_cast<double>(place[2])};
  return {quads, points};
}

/// A box of cubes, from a corner up to another, which it does not reach.
struct Box {
  Place low{}, high{};
};

std::set<Place> without(const Place& size, const std::vector<Box>& recesses) {
  std::set<Place> cubes;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) cubes.insert({x, y, z});
  for (const auto& [low, high] : recesses)
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z) cubes.erase({x, y, z});
  return cubes;
}

/// A pocket; two of different depths; one in the floor of another; from both sides; with a wider
/// place below; with a column in it; beside a boss; several with walls between them, and to the
/// outside, that are one cube thick, so that no layer around one ends well.
std::vector<std::set<Place>> bodies_with_recesses() {
  auto with_column = without({5, 5, 3}, {{{1, 1, 1}, {4, 4, 3}}});
  with_column.insert({{2, 2, 1}, {2, 2, 2}});
  auto with_boss = without({9, 5, 4}, {{{1, 1, 2}, {3, 3, 4}}});
  for (const int x : {5, 6})
    for (const int y : {2, 3}) with_boss.insert({x, y, 4});
  return {without({3, 3, 2}, {{{1, 1, 1}, {2, 2, 2}}}),
          without({7, 4, 4}, {{{1, 1, 2}, {3, 3, 4}}, {{4, 1, 1}, {6, 2, 4}}}),
          without({6, 5, 5}, {{{1, 1, 3}, {5, 4, 5}}, {{2, 2, 1}, {3, 3, 3}}}),
          without({4, 4, 6}, {{{1, 1, 4}, {3, 3, 6}}, {{1, 1, 0}, {3, 3, 3}}}),
          without({6, 6, 6}, {{{2, 2, 3}, {4, 4, 6}}, {{1, 1, 3}, {5, 5, 4}}}),
          with_column,
          with_boss,
          without({6, 8, 7}, {{{2, 0, 1}, {5, 1, 2}},
                              {{3, 0, 1}, {4, 2, 4}},
                              {{0, 1, 1}, {1, 5, 3}},
                              {{1, 1, 4}, {2, 5, 7}}})};
}

/// How often each angle occurs, in degrees.
std::map<long, std::size_t> angles_of(const Body& body) {
  const Peeling peeling(body.sphere.quads, body.sphere.vertices());
  std::map<long, std::size_t> count;
  for (const long angle : hexahedrize::interior_angles(peeling, body.points)) ++count[angle];
  return count;
}

/// Turned about two axes, stretched, and moved.
void move(std::vector<Point>& points, double scale, double away) {
  for (Point& p : points) {
    const double c = 0.6, s = 0.8;
    p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
    p = {scale * (p.x + away), scale * (p.y - away), scale * p.z};
  }
}

using Degrees = std::map<long, std::size_t>;

TEST(Angles, AreThoseOfBodies) {
  // Each edge from both sides.
  for (const double scale : {1.0, 1e-280, 1e280})
    for (const double away : {0.0, 100.0}) {
      Body body = ell();
      move(body.points, scale, away);
      EXPECT_EQ(angles_of(body), (Degrees{{90, 42}, {180, 12}, {270, 2}}));
      Body six = prism(3, 2);
      move(six.points, scale, away);
      EXPECT_EQ(angles_of(six), (Degrees{{90, 24}, {120, 24}, {180, 24}}));
    }
}

TEST(Angles, CountAsFlatWhereThereAreNone) {
  Body body = ell();
  for (Point& p : body.points) p = {1, 2, 3};
  EXPECT_EQ(angles_of(body), (Degrees{{180, 56}}));
}

/// The first one with at most so many hexahedra.
std::optional<hexahedrize::PeeledMesh> first_mesh(const Body& body,
                                                  std::size_t at_most = SIZE_MAX) {
  std::optional<hexahedrize::PeeledMesh> first;
  hexahedrize::meshes_by_sharp_zones(body.sphere, body.points, table(), {}, flips::kSharpAtRim,
                                     [&](const auto& mesh) {
                                       if (mesh.mesh.hexahedra.size() <= at_most) first = mesh;
                                       return first.has_value();
                                     });
  return first;
}

TEST(SharpZones, GiveSweptBodiesTheirLayers) {
  for (const VertexId n : {3U, 7U, 8U})
    for (const VertexId height : {1U, 2U, 7U}) {
      const Body body = prism(n, height);
      const auto made = first_mesh(body);
      ASSERT_TRUE(made);
      support::expect_accepted(made->mesh, body.sphere);
      EXPECT_EQ(made->mesh.hexahedra.size(), n * height);
      EXPECT_EQ(made->mesh.vertices, (2 * n + 1) * (height + 1));
      EXPECT_EQ(made->account.rest, hexahedrize::Rest::layer);
      EXPECT_EQ(made->account.cavity, 4 * n);
      EXPECT_EQ(made->account.peeled, n * (height - 1));
    }
}

TEST(SharpZones, GiveBodiesWithRecessesTheirCubes) {
  for (const auto& cubes : bodies_with_recesses()) {
    const Body body = of_cubes(cubes);
    const auto made = first_mesh(body, cubes.size());
    ASSERT_TRUE(made) << cubes.size();
    support::expect_accepted(made->mesh, body.sphere);
    EXPECT_EQ(made->mesh.hexahedra.size(), cubes.size());
  }
}

/// As those of cubes; the same at twins.
void expect_right_angles(const Peeling& peeling, const flips::Angles& angles) {
  support::expect_same_at_twins(peeling, angles);
  for (const std::uint32_t q : peeling.live_quads())
    for (Peeling::Dart d = 4 * q; d < 4 * q + 4; ++d)
      EXPECT_TRUE(angles[d] == 90 || angles[d] == 180 || angles[d] == 270) << angles[d];
}

TEST(SharpZones, MayEndAtSeveralZones) {
  // A block of 5 x 5 x 4 with two pockets of 3 x 1 x 2 and 3 x 1 x 1: two layers around them are
  // 2 x 25 - 9 cubes. Then the floors are a part of the top, and one zone is enough.
  const Body body = of_cubes(without({5, 5, 4}, {{{1, 1, 2}, {4, 2, 4}}, {{1, 3, 3}, {4, 4, 4}}}));
  Peeling peeling(body.sphere.quads, body.sphere.vertices());
  flips::Angles angles = hexahedrize::interior_angles(peeling, body.points);
  const auto remove = [&](flips::Rims rims) {
    const std::size_t removed =
        flips::remove_sharp_zones(peeling, angles, {.within = flips::kRightAtRim, .rims = rims});
    support::expect_consistent(peeling);
    expect_right_angles(peeling, angles);
    return removed;
  };
  EXPECT_EQ(remove(flips::Rims::several), 2U);
  EXPECT_EQ(peeling.taken().size(), 41U);
  EXPECT_EQ(peeling.quads(), 2U * 25 + 4 * 2 * 5);
  EXPECT_EQ(remove(flips::Rims::several), 0U);
  remove(flips::Rims::one);
  EXPECT_EQ(peeling.quads(), 6U);
}

TEST(SharpZones, OverhangsMayBeWallsOfRecesses) {
  // A block of 5 x 4 x 4 with a pocket of 3 x 2 x 2: first its walls, 2 x (3 + 2) x 2 cubes, then
  // the four columns at its corners, which leaves a plate of 5 x 4 x 2. In one of 7 x 6 x 5 nothing
  // is thin.
  for (const bool is_thin : {false, true}) {
    const Body body = of_cubes(is_thin ? without({5, 4, 4}, {{{1, 1, 2}, {4, 3, 4}}})
                                       : without({7, 6, 5}, {{{2, 2, 2}, {5, 4, 5}}}));
    Peeling peeling(body.sphere.quads, body.sphere.vertices());
    flips::Angles angles = hexahedrize::interior_angles(peeling, body.points);
    EXPECT_FALSE(flips::take_overhangs(peeling, angles));
    EXPECT_EQ(flips::take_overhangs(peeling, angles, flips::Extent::any), is_thin);
    EXPECT_EQ(peeling.taken().size(), is_thin ? 20U + 8 : 0U);
    EXPECT_TRUE(!is_thin || peeling.quads() == 2 * 20 + 2 * 2 * 9);
    support::expect_consistent(peeling);
    expect_right_angles(peeling, angles);
  }
}

TEST(SharpZones, SayNothingOfABodyWithout) {
  Body body = prism(3, 4);
  // All in one plane: each edge is flat, or has no angle.
  for (Point& p : body.points) p.z = 0;
  EXPECT_FALSE(first_mesh(body));
}

}  // namespace
