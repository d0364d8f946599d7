// Claim. The judge accepts hybrid meshes of boxes of lattice cubes, whatever their cells and in
// whatever order, and finds their boundary; it names the law that a mesh breaks; its signs of
// Jacobian determinants are exact; its readers agree with the files that the mesher writes.
// Oracle. hybrid_oracle.hpp; for each law a mesh made by hand that breaks it; determinants at all
// points of a grid; meshes compared with themselves after a way through files.
#include "tables/check/hybrid_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "meshing/io/mesh_files.hpp"
#include "tables/check/hybrid_cells.hpp"
#include "tables/check/malformed.hpp"
#include "tests/tables/check/hybrid_examples.hpp"
#include "tests/tables/check/hybrid_oracle.hpp"

namespace hexatlas::check {
namespace {

using examples::Example;
using examples::make_example;

std::string said(const HybridVerdict& verdict) {
  return std::string(name_of(verdict.broken)) + ": " + verdict.reason;
}

HybridLaw broken(const HybridMesh& mesh, const TetrahedralMesh* given = nullptr) {
  const HybridVerdict verdict = check_hybrid(mesh, given);
  EXPECT_EQ(verdict.accepted, verdict.broken == HybridLaw::kNone);
  EXPECT_EQ(verdict.accepted, verdict.reason.empty()) << verdict.reason;
  return verdict.broken;
}

examples::Lattice size_of_example(unsigned seed) {
  return {static_cast<int>(1 + seed % 3), static_cast<int>(1 + seed / 3 % 3),
          static_cast<int>(1 + seed / 9 % 2)};
}

/// The cell turned into itself by a rotation.
template <std::size_t kSize>
std::array<std::uint32_t, kSize> rotated(const std::array<std::uint32_t, kSize>& cell,
                                         unsigned turns) {
  std::array<std::uint32_t, kSize> c = cell;
  for (; turns > 0; --turns) {
    if constexpr (kSize == 4)
      c = turns % 2 == 0 ? std::array{c[1], c[2], c[0], c[3]} : std::array{c[1], c[0], c[3], c[2]};
    if constexpr (kSize == 5) c = {c[1], c[2], c[3], c[0], c[4]};
    if constexpr (kSize == 6)
      c = turns % 2 == 0 ? std::array{c[1], c[2], c[0], c[4], c[5], c[3]}
                         : std::array{c[3], c[5], c[4], c[0], c[2], c[1]};
    if constexpr (kSize == 8)
      c = turns % 2 == 0 ? std::array{c[1], c[2], c[3], c[0], c[5], c[6], c[7], c[4]}
                         : std::array{c[0], c[4], c[5], c[1], c[3], c[7], c[6], c[2]};
  }
  return c;
}

/// Cells turned and shuffled, points under other numbers.
HybridMesh disguised(HybridMesh mesh, std::mt19937& random) {
  std::vector<std::uint32_t> number(mesh.points.size());
  for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Point> points(mesh.points.size());
  for (std::size_t i = 0; i < number.size(); ++i) points[number[i]] = mesh.points[i];
  mesh.points = points;
  const auto disguise = [&](auto& cells) {
    for (auto& cell : cells) {
      cell = rotated(cell, static_cast<unsigned>(random() % 7));
      for (std::uint32_t& vertex : cell) vertex = number[vertex];
    }
    std::shuffle(cells.begin(), cells.end(), random);
  };
  disguise(mesh.tetrahedra);
  disguise(mesh.hexahedra);
  disguise(mesh.prisms);
  disguise(mesh.pyramids);
  return mesh;
}

TEST(HybridCheck, AcceptsBoxesOfCubes) {
  std::array<std::size_t, 4> seen{};
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto size = size_of_example(seed);
    const Example example = make_example(seed, size, static_cast<int>(seed % 3), seed % 4 == 0);
    ASSERT_TRUE(oracle::has_good_cells(example.mesh));
    for (const HybridMesh& mesh : {example.mesh, disguised(example.mesh, random)}) {
      const HybridVerdict alone = check_hybrid(mesh, nullptr);
      EXPECT_TRUE(alone.accepted) << said(alone);
      const HybridVerdict verdict = check_hybrid(mesh, &example.given);
      EXPECT_TRUE(verdict.accepted) << said(verdict);
      EXPECT_EQ(verdict.boundary_triangles + 2 * verdict.boundary_quads,
                static_cast<std::size_t>(
                    4 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0])));
      EXPECT_EQ(verdict.singular_boundary_edges, 0U);
      const bool is_flat = seed % 4 != 0 || seed % 3 == 0;
      if (is_flat) {
        EXPECT_EQ(verdict.warped_boundary_quads, 0U);
      }
      EXPECT_EQ(verdict.tetrahedra, mesh.tetrahedra.size());
      EXPECT_EQ(verdict.hexahedra, mesh.hexahedra.size());
      EXPECT_EQ(verdict.prisms, mesh.prisms.size());
      EXPECT_EQ(verdict.pyramids, mesh.pyramids.size());
      seen[0] += verdict.tetrahedra;
      seen[1] += verdict.hexahedra;
      seen[2] += verdict.prisms;
      seen[3] += verdict.pyramids;
    }
    EXPECT_TRUE(oracle::accepts(example.mesh, example.given));
    bool fits = true;
    const auto outside = oracle::boundary(example.mesh, fits);
    if (seed % 4 != 0) {
      EXPECT_EQ(oracle::volume(outside, example.mesh.points),
                72.0 * 4096 * size[0] * size[1] * size[2]);
    }
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 80U);
}

TEST(HybridCheck, PointsMayBeUnusedAndNumberedOtherwise) {
  Example example = make_example(5, {2, 2, 2}, 0);
  const std::uint64_t unused = check_hybrid(example.mesh, nullptr).unused_points;
  example.mesh.points.push_back({1, 2, 3});
  for (Point& p : example.given.points)
    for (double& x : p)
      if (x == 0) x = -0.0;
  const HybridVerdict verdict = check_hybrid(example.mesh, &example.given);
  EXPECT_TRUE(verdict.accepted) << said(verdict);
  EXPECT_EQ(verdict.unused_points, unused + 1);
}

const HybridMesh kCube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
    {},
    {{0, 1, 2, 3, 4, 5, 6, 7}},
    {},
    {}};

/// The cube with another cell on its top.
HybridMesh with_top(const std::vector<Point>& more) {
  HybridMesh mesh = kCube;
  mesh.points.insert(mesh.points.end(), more.begin(), more.end());
  return mesh;
}

TEST(HybridCheck, NamesTheLaw) {
  EXPECT_EQ(broken(kCube), HybridLaw::kNone);
  EXPECT_EQ(broken({}), HybridLaw::kCorners);
  HybridMesh mesh = kCube;
  mesh.hexahedra[0][3] = 8;
  EXPECT_EQ(broken(mesh), HybridLaw::kCorners);
  mesh.hexahedra[0][3] = 2;
  EXPECT_EQ(broken(mesh), HybridLaw::kCorners);
  mesh = kCube;
  std::swap(mesh.points[0], mesh.points[6]);
  EXPECT_EQ(broken(mesh), HybridLaw::kPositive);
  for (const HybridMesh& inverted : {HybridMesh{kCube.points, {{0, 3, 1, 4}}, {}, {}, {}},
                                     HybridMesh{kCube.points, {}, {}, {{0, 2, 1, 4, 6, 5}}, {}},
                                     HybridMesh{kCube.points, {}, {}, {}, {{3, 2, 1, 0, 4}}}})
    EXPECT_EQ(broken(inverted), HybridLaw::kPositive);

  const Point apex = {0.5, 0.5, 2};
  mesh = with_top({apex});
  mesh.pyramids = {{4, 5, 6, 7, 8}};
  EXPECT_EQ(broken(mesh), HybridLaw::kNone);
  mesh.pyramids = {{4, 5, 6, 7, 8}, {4, 5, 6, 7, 8}};
  EXPECT_EQ(broken(mesh), HybridLaw::kTwoCells);
  mesh = with_top({apex});
  mesh.tetrahedra = {{4, 5, 6, 8}, {4, 6, 7, 8}};
  EXPECT_EQ(broken(mesh), HybridLaw::kDiagonal);
  mesh.tetrahedra = {{4, 5, 7, 8}, {5, 6, 7, 8}};
  EXPECT_EQ(broken(mesh), HybridLaw::kDiagonal);
  // Only a vertex and an edge of a triangle are at the quad.
  mesh.tetrahedra = {{4, 5, 6, 8}};
  EXPECT_EQ(broken(mesh), HybridLaw::kDiagonal);
  mesh = with_top({{0.5, 0.5, -2}});
  mesh.pyramids = {{4, 7, 6, 5, 8}};
  EXPECT_EQ(broken(mesh), HybridLaw::kOppositeSides);

  // From far above and from far beside, four corners of a cube are squares of different cycles.
  mesh = {{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {0, 0, 9}, {9, 0, 0}}, {}, {}, {}, {}};
  const auto first_of = [&](std::uint32_t a) {
    for (const Pyramid& p : {Pyramid{0, 2, 1, 3, a}, Pyramid{0, 3, 1, 2, a}, Pyramid{0, 1, 3, 2, a},
                             Pyramid{0, 2, 3, 1, a}}) {
      if (oracle::least_jacobian(oracle::corners_of(mesh, {p.begin(), p.end()}), 2, 2) > 0)
        return p;
    }
    return Pyramid{};
  };
  mesh.pyramids = {first_of(4), first_of(5)};
  EXPECT_EQ(broken(mesh), HybridLaw::kSameCycle);
}

/// Prisms around an axis, each so many degrees wide, the last one joined to the first one if the
/// angles make up whole turns.
HybridMesh fan(int count, int degrees) {
  HybridMesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}, {}, {}, {}};
  const bool is_closed = count * degrees % 360 == 0;
  for (int i = 0; i < count + (is_closed ? 0 : 1); ++i) {
    const double angle = i * degrees * std::numbers::pi / 180;
    for (const double z : {0.0, 1.0}) mesh.points.push_back({std::cos(angle), std::sin(angle), z});
  }
  const auto outer = [&](int i) {
    return static_cast<std::uint32_t>(2 + 2 * (is_closed ? i % count : i));
  };
  for (int i = 0; i < count; ++i)
    mesh.prisms.push_back({0, outer(i), outer(i + 1), 1, outer(i) + 1, outer(i + 1) + 1});
  return mesh;
}

/// Five hexahedra around an axis, facet to facet, of so many degrees together at its ends.
HybridMesh twisted_fan(double below, double above) {
  constexpr std::uint32_t kCount = 5;
  HybridMesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}, {}, {}, {}};
  for (std::uint32_t i = 0; i <= 2 * kCount; ++i)  // an arm, and a corner between two of them
    for (const double z : {0.0, 1.0}) {
      const double whole = (z == 0 ? below : above) * std::numbers::pi / 180;
      const double angle = whole * (i / (2.0 * kCount) - 0.5);
      const double r = i % 2 == 0 ? 1 : 1.7 * std::cos(whole / (2 * kCount));
      mesh.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  for (std::uint32_t c = 0; c < kCount; ++c) {
    const std::uint32_t arm = 2 + 4 * c;
    mesh.hexahedra.push_back({0, arm, arm + 2, arm + 4, 1, arm + 1, arm + 3, arm + 5});
  }
  return mesh;
}

TEST(HybridCheck, OnceAroundEachEdge) {
  EXPECT_EQ(broken(fan(5, 72)), HybridLaw::kNone);
  EXPECT_EQ(broken(fan(3, 120)), HybridLaw::kNone);
  EXPECT_EQ(broken(fan(4, 72)), HybridLaw::kNone);
  EXPECT_EQ(broken(fan(5, 144)), HybridLaw::kAroundEdge);
  EXPECT_EQ(broken(fan(8, 135)), HybridLaw::kAroundEdge);
  EXPECT_EQ(broken(fan(3, 150)), HybridLaw::kAroundEdge);
  EXPECT_EQ(broken(fan(6, 61)), HybridLaw::kAroundEdge);
  // Two that begin, or end, in one half-plane without a facet in common; two that are side by side.
  const std::vector<Point> around{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {2, 0, 0},
                                  {1, 1, 0}, {2, 2, 0}, {0, 1, 0}};
  const auto two = [&](Tetrahedron a, Tetrahedron b) {
    return broken({around, {a, b}, {}, {}, {}});
  };
  EXPECT_EQ(two({0, 1, 2, 4}, {0, 1, 3, 6}), HybridLaw::kAroundEdge);
  EXPECT_EQ(two({0, 1, 2, 6}, {0, 1, 3, 4}), HybridLaw::kAroundEdge);
  EXPECT_EQ(two({0, 1, 2, 5}, {0, 1, 3, 4}), HybridLaw::kAroundEdge);
  EXPECT_EQ(two({0, 1, 2, 6}, {0, 1, 4, 6}), HybridLaw::kOppositeSides);
  EXPECT_EQ(two({0, 1, 2, 4}, {0, 1, 5, 6}), HybridLaw::kNone);
  // Hexahedra that twist, so that they are less than a turn at one end of the axis only.
  for (const bool is_wide_above : {true, false})
    EXPECT_EQ(broken(twisted_fan(is_wide_above ? 300 : 420, is_wide_above ? 420 : 300)),
              HybridLaw::kAroundEdge);
  EXPECT_EQ(broken(twisted_fan(300, 340)), HybridLaw::kNone);
  // Cut through the axis in tetrahedra and pyramids, the double fan is found as well.
  HybridMesh mesh = fan(5, 144);
  const auto top = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({0, 0, 3});
  for (const Prism& prism : mesh.prisms)
    mesh.tetrahedra.push_back({prism[3], prism[4], prism[5], top});
  mesh.prisms.clear();
  EXPECT_EQ(broken(mesh), HybridLaw::kAroundEdge);
}

TEST(HybridCheck, OnceAroundEachVertex) {
  // Two stars of eight tetrahedra, one in the other; then their centres are made one.
  HybridMesh mesh;
  for (const double r : {1.0, 2.0}) {
    const auto centre = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back({0, 0, 0});
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0}) {
        Point p{};
        p[axis] = sign * r;
        mesh.points.push_back(p);
      }
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const std::uint32_t x = centre + 1 + (octant & 1U), y = centre + 3 + (octant >> 1U & 1U);
      const std::uint32_t z = centre + 5 + (octant >> 2U);
      const bool is_even = (octant ^ octant >> 1U ^ octant >> 2U) % 2 == 0;
      mesh.tetrahedra.push_back({centre, is_even ? x : y, is_even ? y : x, z});
    }
  }
  // Nothing is known of parts that do not touch in a face.
  EXPECT_EQ(broken(mesh), HybridLaw::kNone);
  for (Tetrahedron& cell : mesh.tetrahedra) std::replace(cell.begin(), cell.end(), 7U, 0U);
  EXPECT_EQ(broken(mesh), HybridLaw::kAroundVertex);
}

TEST(HybridCheck, ComparesBoundaries) {
  const Example box = make_example(1, {2, 1, 1}, 0);
  const Example other = make_example(1, {2, 1, 2}, 0);
  EXPECT_EQ(broken(box.mesh, &box.given), HybridLaw::kNone);
  EXPECT_EQ(broken(box.mesh, &other.given), HybridLaw::kGivenBoundary);
  EXPECT_EQ(broken(other.mesh, &box.given), HybridLaw::kGivenBoundary);
  TetrahedralMesh part = box.given;
  part.tetrahedra.pop_back();
  EXPECT_EQ(broken(box.mesh, &part), HybridLaw::kGivenBoundary);
  TetrahedralMesh bad = box.given;
  std::swap(bad.tetrahedra[0][0], bad.tetrahedra[0][1]);
  EXPECT_EQ(broken(box.mesh, &bad), HybridLaw::kGivenMesh);
  EXPECT_NE(check_hybrid(box.mesh, &bad).reason.find("in the given mesh: tetrahedron 0"),
            std::string::npos);
  // Both ways to cut a quad do, but only whole.
  for (const auto& ways : {std::array<Tetrahedron, 2>{{{0, 1, 2, 4}, {0, 2, 3, 4}}},
                           std::array<Tetrahedron, 2>{{{0, 1, 3, 4}, {1, 2, 3, 4}}}}) {
    const HybridMesh pyramid{kCube.points, {}, {}, {}, {{0, 1, 2, 3, 4}}};
    const TetrahedralMesh two{kCube.points, {ways[0], ways[1]}};
    EXPECT_EQ(broken(pyramid, &two), HybridLaw::kNone);
    const TetrahedralMesh one{kCube.points, {ways[0]}};
    EXPECT_EQ(broken(pyramid, &one), HybridLaw::kGivenBoundary);
    EXPECT_EQ(broken({kCube.points, one.tetrahedra, {}, {}, {}}, &two), HybridLaw::kGivenBoundary);
  }
}

TEST(HybridCheck, CountsSingularEdges) {
  // Two cubes with one edge in common.
  HybridMesh mesh = kCube;
  for (std::size_t i = 0; i < 8; ++i)
    mesh.points.push_back({kCube.points[i][0] + 1, kCube.points[i][1] + 1, kCube.points[i][2]});
  mesh.hexahedra.push_back({2, 9, 10, 11, 6, 13, 14, 15});
  const HybridVerdict verdict = check_hybrid(mesh, nullptr);
  EXPECT_TRUE(verdict.accepted) << said(verdict);
  EXPECT_EQ(verdict.singular_boundary_edges, 1U);
  EXPECT_EQ(verdict.unused_points, 2U);
  EXPECT_EQ(verdict.boundary_quads, 12U);
}

TEST(HybridCheck, SaysUndecided) {
  // The top is the bottom times -2: the determinant is (1 - 3 w)^2, zero at a third of the height.
  HybridMesh mesh = kCube;
  for (std::size_t i = 4; i < 8; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis) mesh.points[i][axis] *= -2;
  const HybridVerdict verdict = check_hybrid(mesh, nullptr);
  EXPECT_FALSE(verdict.accepted);
  EXPECT_TRUE(verdict.undecided);
  EXPECT_EQ(verdict.broken, HybridLaw::kPositive);
  // At half of the height subdivision finds the zero.
  for (std::size_t i = 4; i < 8; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis) mesh.points[i][axis] /= 2;
  EXPECT_FALSE(check_hybrid(mesh, nullptr).undecided);
  EXPECT_EQ(broken(mesh), HybridLaw::kPositive);
}

JacobianSign judged_sign(const std::vector<Point>& points) {
  HybridCell cell;
  cell.shape = points.size() == 4   ? CellShape::kTetrahedron
               : points.size() == 5 ? CellShape::kPyramid
               : points.size() == 6 ? CellShape::kPrism
                                    : CellShape::kHexahedron;
  for (std::uint32_t i = 0; i < points.size(); ++i) cell.vertices[i] = i;
  Signs signs;
  return jacobian_sign(cell, points, signs);
}

TEST(HybridCells, SignsAgreeWithAGrid) {
  std::mt19937 random(7);
  const std::array<std::vector<Point>, 4> ideal{
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}},
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
       kCube.points}};
  std::array<std::array<int, 3>, 4> seen{};
  int tight = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::size_t shape = static_cast<std::size_t>(round) % 4;
    // A coarse lattice has many determinants that are zero somewhere.
    const int scale = round % 3 == 0 ? 2 : 8, noise = round % 3 == 0 ? 1 : 5;
    std::vector<Point> points = ideal[shape];
    for (Point& p : points)
      for (double& x : p)
        x = scale * x + static_cast<int>(random() % static_cast<unsigned>(2 * noise + 1)) - noise;
    const double least = oracle::least_jacobian(points, 8, shape == 3 ? 8 : 32);
    const JacobianSign sign = judged_sign(points);
    ++seen[shape][static_cast<std::size_t>(sign)];
    if (least <= 0) {
      ASSERT_NE(sign, JacobianSign::kPositive) << round;
      if (shape != 3) {
        ASSERT_EQ(sign, JacobianSign::kNotPositive);
      }
    } else if (sign == JacobianSign::kNotPositive) {
      ++tight;  // between points of the grid
      ASSERT_LT(least, 0.05 * scale * scale * scale) << round;
      ASSERT_GE(shape, 2U);
    }
    // A power of two, a shift, and numbers near the ends of double precision change no sign.
    for (const auto& [factor, shift] :
         std::vector<std::pair<double, double>>{{0x1p-20, 0x1p25}, {0x1p-1074, 0}, {0x1p900, 0}}) {
      std::vector<Point> moved = points;
      for (Point& p : moved)
        for (double& x : p) x = factor * x + shift;
      if (round % 8 < 4) {
        ASSERT_EQ(judged_sign(moved), sign) << round << " " << factor;
      }
    }
  }
  for (const auto& counts : seen) {
    EXPECT_GT(counts[static_cast<std::size_t>(JacobianSign::kPositive)], 100);
    EXPECT_GT(counts[static_cast<std::size_t>(JacobianSign::kNotPositive)], 100);
  }
  EXPECT_LT(tight, 60);
}

TEST(HybridCells, PrismsWithZeroBetweenCorners) {
  // Top and bottom triangle are equal but for a factor: the determinant is (1 - (1 - f) w)^2.
  const auto prism = [](double f, double lift) {
    return std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {f, lift, 1}, {0, f, 1}};
  };
  EXPECT_EQ(judged_sign(prism(1, 0)), JacobianSign::kPositive);
  EXPECT_EQ(judged_sign(prism(0x1p-60, 0)), JacobianSign::kPositive);
  EXPECT_EQ(judged_sign(prism(0, 0)), JacobianSign::kNotPositive);
  EXPECT_EQ(judged_sign(prism(-2, 0)), JacobianSign::kNotPositive);
  EXPECT_EQ(judged_sign(prism(-1, 0)), JacobianSign::kNotPositive);
  // det((1 - w) + w f, w lift; 0, (1 - w) + w f) has no other term in lift; with the third corner
  // moved against it the zero goes away: (1 - 3 w)^2 + lift^2 w^2.
  std::vector<Point> turned = prism(-2, 0x1p-30);
  turned[5][0] = -0x1p-30;
  EXPECT_EQ(judged_sign(turned), JacobianSign::kPositive);
  turned[5][0] = 0x1p-30;
  EXPECT_EQ(judged_sign(turned), JacobianSign::kNotPositive);
}

/// The mesh in the types of the mesher.
mesh::HybridMesh of_mesher(const HybridMesh& judge) {
  mesh::HybridMesh mesh;
  for (const Point& p : judge.points) mesh.points.push_back({p[0], p[1], p[2]});
  mesh.tetrahedra = judge.tetrahedra;
  for (const Hexahedron& h : judge.hexahedra)
    mesh.hexahedra.push_back({h[0], h[1], h[3], h[2], h[4], h[5], h[7], h[6]});
  mesh.prisms = judge.prisms;
  mesh.pyramids = judge.pyramids;
  return mesh;
}

TEST(HybridFiles, AreReadAsTheyWereWritten) {
  const HybridMesh mesh = make_example(3, {3, 3, 2}).mesh;
  for (const io::FileFormat format :
       {io::FileFormat::vtk, io::FileFormat::vtu, io::FileFormat::medit, io::FileFormat::gmsh}) {
    const std::string name = "mesh" + std::string(io::extension_of(format));
    const HybridMesh read = parse_hybrid(name, io::to_text(of_mesher(mesh), format));
    EXPECT_EQ(read.points, mesh.points) << name;
    EXPECT_EQ(read.tetrahedra, mesh.tetrahedra) << name;
    EXPECT_EQ(read.hexahedra, mesh.hexahedra) << name;
    EXPECT_EQ(read.prisms, mesh.prisms) << name;
    EXPECT_EQ(read.pyramids, mesh.pyramids) << name;
    // Where other cells are wanted they are refused, or passed over for their points.
    EXPECT_THROW(static_cast<void>(parse_tetrahedra(name, io::to_text(of_mesher(mesh), format))),
                 Malformed);
    EXPECT_THROW(static_cast<void>(parse_mesh(name, io::to_text(of_mesher(mesh), format))),
                 Malformed);
    EXPECT_EQ(parse_points(name, io::to_text(of_mesher(mesh), format)), mesh.points);
  }
  EXPECT_THROW(static_cast<void>(parse_hybrid("mesh.obj", "v 0 0 0\n")), Malformed);
  EXPECT_THROW(static_cast<void>(parse_hybrid("mesh.hxtet", std::string("HXTET\0\0\1", 8))),
               Malformed);
}

}  // namespace
}  // namespace hexatlas::check
