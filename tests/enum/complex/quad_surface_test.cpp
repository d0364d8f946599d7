// Claim. sphere_of() accepts spheres in any orientation of their quads and names what else a list
// of quads is; reason_against_filling() names what forbids every filling. Oracle. Surfaces whose
// kind is known from how they are made.
#include "enum/complex/quad_surface.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::BoundaryQuad;
using Quads = std::vector<BoundaryQuad>;

const Quads kCube{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};

std::string fault_of(const Quads& quads, std::size_t points = 100) {
  const auto answer = complex::sphere_of(quads, points);
  const auto* law = std::get_if<complex::BrokenLaw>(&answer);
  return law != nullptr ? law->reason : "none";
}

complex::QuadSphere sphere(const Quads& quads, std::size_t points) {
  return std::get<complex::QuadSphere>(complex::sphere_of(quads, points));
}

TEST(QuadSurface, NamesWhatIsNoSphere) {
  EXPECT_EQ(fault_of({}), "there is no quad");
  EXPECT_EQ(fault_of({{0, 1, 2, 1}}), "point 1 is repeated in a quad");
  Quads open = kCube;
  open.pop_back();
  EXPECT_NE(fault_of(open).find("is in one quad only: the surface is open"), std::string::npos);
  Quads fin = kCube;
  fin.push_back({0, 1, 8, 9});
  EXPECT_EQ(fault_of(fin), "edge 0-1 is in 3 quads: the surface is not a manifold");

  Quads touching = kCube;
  for (BoundaryQuad quad : kCube) {
    for (auto& v : quad) v = v == 0 ? 0 : v + 7;
    touching.push_back(quad);
  }
  EXPECT_EQ(fault_of(touching),
            "the quads at point 0 form several fans: the surface is not a manifold there");
  Quads apart = kCube;
  for (BoundaryQuad quad : kCube) {
    for (auto& v : quad) v += 8;
    apart.push_back(quad);
  }
  EXPECT_EQ(fault_of(apart), "the surface has 2 components");
}

TEST(QuadSurface, NamesTheGenus) {
  const auto torus = [](std::uint32_t m, std::uint32_t n) {
    Quads quads;
    for (std::uint32_t i = 0; i < m; ++i)
      for (std::uint32_t j = 0; j < n; ++j)
        quads.push_back(
            {i * n + j, (i + 1) % m * n + j, (i + 1) % m * n + (j + 1) % n, i * n + (j + 1) % n});
    return quads;
  };
  EXPECT_EQ(fault_of(torus(3, 3)),
            "the surface has genus 1, a ball is bounded by a sphere (genus 0)");
  EXPECT_EQ(fault_of(torus(5, 7)),
            "the surface has genus 1, a ball is bounded by a sphere (genus 0)");
}

TEST(QuadSurface, NamesWhatCannotBeOriented) {
  // The cube with opposite points identified: three quads on four points, a projective plane.
  EXPECT_EQ(fault_of({{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 1, 3}}), "the surface cannot be oriented");
  // A Klein bottle: a torus grid whose one direction is glued with a turn.
  Quads klein;
  const std::uint32_t m = 4, n = 5;
  const auto point = [&](std::uint32_t i, std::uint32_t j) {
    return i < m ? i * n + j % n : (2 * n - j) % n;
  };
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < n; ++j)
      klein.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
  EXPECT_EQ(fault_of(klein), "the surface cannot be oriented");
}

TEST(QuadSurface, TurnsTheMinorityOfQuads) {
  std::set<oracle::Cycle> outward;
  for (const auto& quad : kCube) outward.insert(oracle::rotated(quad));
  for (unsigned turned = 0; turned < 64; ++turned) {
    Quads quads = kCube;
    std::size_t count = 0;
    for (std::size_t q = 0; q < 6; ++q)
      if ((turned >> q & 1U) != 0) {
        std::swap(quads[q][1], quads[q][3]);
        ++count;
      }
    const auto result = sphere(quads, 8);
    const bool first_turned = (turned & 1U) != 0;
    const bool outside = count < 3 || (count == 3 && !first_turned);
    EXPECT_EQ(result.reversed, std::min(count, 6 - count));
    for (std::size_t q = 0; q < 6; ++q)
      EXPECT_EQ(outside ? oracle::rotated(result.quads[q]) : oracle::reversed(result.quads[q]),
                oracle::rotated(kCube[q]))
          << turned;
  }
}

TEST(QuadSurface, KeepsTrackOfPoints) {
  Quads quads = kCube;
  for (auto& quad : quads)
    for (auto& v : quad) v = 3 * v + 2;
  const auto result = sphere(quads, 30);
  EXPECT_EQ(result.vertices(), 8U);
  EXPECT_EQ(result.unused_points, 22U);
  EXPECT_EQ(result.reversed, 0U);
  for (std::uint32_t v = 0; v < 8; ++v) EXPECT_EQ(result.point_of[v], 3 * v + 2);
  EXPECT_EQ(result.quads, kCube);
}

std::string reason(const Quads& quads) {
  const auto result = complex::reason_against_filling(sphere(quads, 200));
  return result.value_or("none");
}

TEST(QuadSurface, ReasonsAgainstFillings) {
  EXPECT_EQ(reason(kCube), "none");
  EXPECT_EQ(reason({{0, 1, 2, 3}, {3, 2, 1, 0}}),
            "the boundary has 2 quads, fewer than a hexahedron");
  EXPECT_NE(reason({{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 4, 2, 1}}).find("3 quads, an odd number"),
            std::string::npos);
  // A cube with one quad cut into a small quad with 4 around it, twice: degree 3, yet 10 + 4 quads.
  Quads nested = kCube;
  nested.erase(nested.begin());
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::array<std::uint32_t, 4> outer{0, 2, 3, 1};
    nested.push_back({outer[i], outer[(i + 1) % 4], 8 + (i + 1) % 4, 8 + i});
  }
  nested.push_back({8, 9, 10, 11});
  EXPECT_EQ(nested.size(), 10U);
  EXPECT_EQ(reason(nested), "none");
  // A quad with a vertex of degree 2 inside.
  Quads folded = kCube;
  folded.erase(folded.begin());
  folded.push_back({0, 2, 3, 8});
  folded.push_back({0, 8, 3, 1});
  folded.push_back({8, 3, 9, 0});
  folded.erase(folded.end() - 2);
  folded.push_back({0, 9, 3, 1});
  EXPECT_EQ(folded.size(), 8U);
  EXPECT_NE(reason(folded).find("points 0-3 are opposite in two quads"), std::string::npos);
}

TEST(QuadSurface, ReasonsMatch3Connectedness) {
  // Over all simple quadrangulations with 6, 8 and 10 quads.
  auto level = support::four_cycle_class();
  for (int n = 3; n <= 10; ++n) {
    level = support::grown(level);
    for (const auto& [code, map] : level) {
      Quads quads;
      for (const auto& quad : oracle::quads_of(map))
        quads.push_back({quad[0], quad[1], quad[2], quad[3]});
      const bool possible = n % 2 == 0 && n >= 6 && oracle::is_three_connected(map);
      EXPECT_EQ(reason(quads) == "none", possible) << canon::to_text(code);
    }
  }
}

/// The surface of a cube cut into k by k squares on each side.
Quads surface_of_grid(std::uint32_t k, std::size_t& points) {
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  Quads quads;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::uint32_t side : {0U, k})
      for (std::uint32_t i = 0; i < k; ++i)
        for (std::uint32_t j = 0; j < k; ++j) {
          BoundaryQuad quad{};
          std::size_t at = 0;
          for (const auto& [di, dj] : {std::pair(0U, 0U), {1U, 0U}, {1U, 1U}, {0U, 1U}}) {
            std::array<std::uint32_t, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            quad[at++] =
                number.try_emplace(p, static_cast<std::uint32_t>(number.size())).first->second;
          }
          quads.push_back(quad);
        }
  points = number.size();
  return quads;
}

TEST(QuadSurface, LargeSpheresAreAccepted) {
  std::size_t points = 0;
  const Quads quads = surface_of_grid(50, points);
  ASSERT_EQ(quads.size(), 15'000U);
  EXPECT_EQ(points, 15'002U);
  const auto result = sphere(quads, points);
  EXPECT_EQ(result.vertices(), points);
  EXPECT_EQ(result.reversed, 7'500U) << "the sides at 0 face inwards, half of all quads";
  EXPECT_FALSE(complex::reason_against_filling(result));

  // 9 times the quads must not take 60 times as long.
  const auto seconds = [](const Quads& list, std::size_t n) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(complex::reason_against_filling(sphere(list, n)));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  std::size_t many_points = 0;
  const Quads many = surface_of_grid(150, many_points);
  EXPECT_LT(seconds(many, many_points), 60 * seconds(quads, points) + 0.5);
}

}  // namespace
