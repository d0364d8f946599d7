// Claim. The tetrahedra with no other point in their perturbed spheres triangulate the convex hull,
// however many points are cospherical. Theory: docs/theory/delaunay-ties.md.
// Oracle. Brute force over all tetrahedra of small lattice sets: every facet inside the hull is one
// of two tetrahedra on its two sides, those of one are in the boundary of the hull, and the volumes
// add up to that of the hull, which is found facet by facet.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "realize/exact/in_sphere.hpp"

namespace {

using namespace hexatlas;
using exact::Point3;
using exact::Sign;
using Lattice = std::array<std::int64_t, 3>;
using Points = std::vector<Lattice>;
using Tetrahedron = std::array<std::size_t, 4>;

Lattice minus(const Lattice& p, const Lattice& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
Lattice cross(const Lattice& p, const Lattice& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
std::int64_t dot(const Lattice& p, const Lattice& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
std::int64_t six_volumes(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& d) {
  return dot(cross(minus(b, a), minus(c, a)), minus(d, a));
}

Point3 real(const Lattice& p, double step) {
  return {step * static_cast<double>(p[0]), step * static_cast<double>(p[1]),
          step * static_cast<double>(p[2])};
}

/// The points in planes that have all points on one side, as sets, each with its inward normal.
std::map<std::set<std::size_t>, Lattice> hull_facets(const Points& points) {
  std::map<std::set<std::size_t>, Lattice> facets;
  const std::size_t n = points.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      for (std::size_t c = 0; c < n; ++c) {
        const Lattice normal = cross(minus(points[b], points[a]), minus(points[c], points[a]));
        if (dot(normal, normal) == 0) continue;
        std::set<std::size_t> on;
        bool is_supporting = true;
        for (std::size_t d = 0; d < n; ++d) {
          const std::int64_t height = dot(normal, minus(points[d], points[a]));
          if (height == 0) on.insert(d);
          is_supporting = is_supporting && height >= 0;
        }
        if (is_supporting) facets.emplace(on, normal);
      }
  return facets;
}

/// Cones from the first point over the triangles from one point of a facet to its edges.
std::int64_t six_volumes_of_hull(const Points& points) {
  std::int64_t sum = 0;
  for (const auto& [on, normal] : hull_facets(points))
    for (const std::size_t q : on)
      for (const std::size_t r : on) {
        const Lattice edge = minus(points[r], points[q]);
        const bool is_edge =
            q != r && std::all_of(on.begin(), on.end(), [&, &outwards = normal](std::size_t s) {
              const Lattice to = minus(points[s], points[q]);
              const std::int64_t side = dot(outwards, cross(edge, to));
              return side > 0 || (side == 0 && dot(to, minus(points[s], points[r])) <= 0);
            });
        if (is_edge)
          sum += std::abs(six_volumes(points[0], points[*on.begin()], points[q], points[r]));
      }
  return sum;
}

std::vector<Tetrahedron> delaunay(const Points& points, double step) {
  std::vector<Tetrahedron> result;
  const std::size_t n = points.size();
  for (std::size_t d = 3; d < n; ++d)
    for (std::size_t c = 2; c < d; ++c)
      for (std::size_t b = 1; b < c; ++b)
        for (std::size_t a = 0; a < b; ++a) {
          Tetrahedron t{a, b, c, d};
          const std::int64_t volume = six_volumes(points[a], points[b], points[c], points[d]);
          if (volume == 0) continue;
          if (volume < 0) std::swap(t[0], t[1]);
          bool is_empty = true;
          for (std::size_t e = 0; e < n && is_empty; ++e)
            if (std::find(t.begin(), t.end(), e) == t.end())
              is_empty =
                  exact::sign_of_perturbed_in_sphere(
                      real(points[t[0]], step), real(points[t[1]], step), real(points[t[2]], step),
                      real(points[t[3]], step), real(points[e], step)) == Sign::negative;
          if (is_empty) result.push_back(t);
        }
  return result;
}

void expect_triangulation_of_hull(const Points& points, const std::vector<Tetrahedron>& mesh) {
  std::int64_t volume = 0;
  std::map<std::set<std::size_t>, std::vector<std::size_t>> apices;
  std::set<std::size_t> vertices;
  for (const Tetrahedron& t : mesh) {
    volume += six_volumes(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    vertices.insert(t.begin(), t.end());
    for (const std::size_t apex : t) {
      std::set<std::size_t> facet(t.begin(), t.end());
      facet.erase(apex);
      apices[facet].push_back(apex);
    }
  }
  ASSERT_EQ(volume, six_volumes_of_hull(points));
  ASSERT_EQ(vertices.size(), points.size());
  const auto hull = hull_facets(points);
  for (const auto& [facet, sides] : apices) {
    ASSERT_LE(sides.size(), 2U);
    const bool is_in_hull = std::any_of(hull.begin(), hull.end(), [&, &f = facet](const auto& h) {
      return std::includes(h.first.begin(), h.first.end(), f.begin(), f.end());
    });
    ASSERT_EQ(sides.size(), is_in_hull ? 1U : 2U);
    if (is_in_hull) continue;
    const std::vector<std::size_t> f(facet.begin(), facet.end());
    const auto side = [&](std::size_t apex) {
      return six_volumes(points[f[0]], points[f[1]], points[f[2]], points[apex]) > 0;
    };
    ASSERT_NE(side(sides[0]), side(sides[1]));
  }
}

Points some_of(Points points, std::size_t count, std::mt19937_64& random) {
  std::shuffle(points.begin(), points.end(), random);
  points.resize(count);
  return points;
}

Points box(std::int64_t x, std::int64_t y, std::int64_t z) {
  Points points;
  for (std::int64_t i = 0; i < x; ++i)
    for (std::int64_t j = 0; j < y; ++j)
      for (std::int64_t k = 0; k < z; ++k) points.push_back({i, j, k});
  return points;
}

TEST(PerturbedDelaunay, TriangulatesTheHullOfLatticePoints) {
  std::mt19937_64 random(20261212);
  int solid = 0;
  for (int trial = 0; trial < 1200; ++trial) {
    const Points points = some_of(box(3, 3, 3), 5 + random() % 8, random);
    const auto mesh = delaunay(points, trial % 3 == 0 ? 0.01 : 1);
    if (six_volumes_of_hull(points) == 0) continue;
    expect_triangulation_of_hull(points, mesh);
    ++solid;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(solid, 900);
}

TEST(PerturbedDelaunay, TriangulatesWholeBoxes) {
  for (const Points& points : {box(2, 2, 2), box(2, 2, 3), box(2, 3, 3), box(3, 3, 3)})
    for (const double step : {1.0, 0x1p-1070, 0x1p900})
      expect_triangulation_of_hull(points, delaunay(points, step));
}

/// All points are on one sphere: the perturbation alone decides.
TEST(PerturbedDelaunay, TriangulatesTheHullOfCosphericalPoints) {
  std::mt19937_64 random(20261213);
  Points sphere;
  for (std::int64_t x = -5; x <= 5; ++x)
    for (std::int64_t y = -5; y <= 5; ++y)
      for (std::int64_t z = -5; z <= 5; ++z)
        if (x * x + y * y + z * z == 26) sphere.push_back({x, y, z});
  ASSERT_EQ(sphere.size(), 72U);
  for (int trial = 0; trial < 200; ++trial) {
    const Points points = some_of(sphere, 6 + random() % 7, random);
    expect_triangulation_of_hull(points, delaunay(points, 1));
    if (HasFatalFailure()) return;
  }
}

/// The mesh depends on the places of the points, not on their numbers.
TEST(PerturbedDelaunay, DoesNotDependOnTheNumbering) {
  std::mt19937_64 random(20261214);
  const auto places = [](const Points& points, const std::vector<Tetrahedron>& mesh) {
    std::set<std::set<Lattice>> result;
    for (const Tetrahedron& t : mesh)
      result.insert({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
    return result;
  };
  for (int trial = 0; trial < 100; ++trial) {
    const Points points = some_of(box(3, 3, 3), 10, random);
    const Points shuffled = some_of(points, points.size(), random);
    ASSERT_EQ(places(points, delaunay(points, 1)), places(shuffled, delaunay(shuffled, 1)));
  }
}

}  // namespace
