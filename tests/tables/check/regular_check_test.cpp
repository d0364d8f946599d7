// Claim. The judge accepts regular triangulations of points with weights, ties or not, with hidden
// points and duplicates; it refuses all others; its signs are exact.
// Oracle. Brute force over all tetrahedra and points, with determinants of 128-bit integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <string>

#include "tables/check/delaunay_check.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/signs.hpp"
#include "tests/share.hpp"
#include "tests/tables/check/delaunay_examples.hpp"
#include "tests/tables/check/delaunay_oracle.hpp"

namespace hexatlas::check {
namespace {

using oracle::Lattice;
using oracle::Rows;
using oracle::Whole;
using Cells = std::vector<Tetrahedron>;

struct Cloud {
  std::vector<Lattice> at;
  std::vector<std::int64_t> weights;

  [[nodiscard]] Whole volume(const Tetrahedron& t) const {
    Rows<4> rows{};
    for (std::size_t k = 0; k < 4; ++k) rows[k] = {1, at[t[k]][0], at[t[k]][1], at[t[k]][2]};
    return oracle::determinant<4>(rows);
  }
  /// Positive if e is inside the orthosphere of t, which is positively oriented.
  [[nodiscard]] Whole power(const Tetrahedron& t, std::uint32_t e) const {
    Rows<5> rows{};
    for (std::size_t k = 0; k < 5; ++k) {
      const std::uint32_t v = k < 4 ? t[k] : e;
      const Whole x = at[v][0], y = at[v][1], z = at[v][2];
      rows[k] = {1, x, y, z, x * x + y * y + z * z - weights[v]};
    }
    return -oracle::determinant<5>(rows);
  }
  /// No point is inside the orthosphere of a tetrahedron.
  [[nodiscard]] bool fits(const Cells& cells) const {
    return std::all_of(cells.begin(), cells.end(), [&](const Tetrahedron& t) {
      for (std::uint32_t e = 0; e < at.size(); ++e)
        if (power(t, e) > 0) return false;
      return true;
    });
  }
  /// All tetrahedra with nothing in their orthospheres; none if there is a tie.
  [[nodiscard]] Cells regular() const {
    Cells cells;
    const auto n = static_cast<std::uint32_t>(at.size());
    for (std::uint32_t a = 0; a < n; ++a)
      for (std::uint32_t b = a + 1; b < n; ++b)
        for (std::uint32_t c = b + 1; c < n; ++c)
          for (std::uint32_t d = c + 1; d < n; ++d) {
            Tetrahedron t = {a, b, c, d};
            if (volume(t) == 0) continue;
            if (volume(t) < 0) std::swap(t[2], t[3]);
            bool is_empty = true;
            for (std::uint32_t e = 0; e < n && is_empty; ++e) {
              if (std::find(t.begin(), t.end(), e) != t.end()) continue;
              const Whole sign = power(t, e);
              is_empty = sign < 0;
              if (sign == 0) return {};
            }
            if (is_empty) cells.push_back(t);
          }
    return cells;
  }
  [[nodiscard]] std::vector<Point> points() const {
    std::vector<Point> result;
    for (const Lattice& p : at)
      result.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return result;
  }
  [[nodiscard]] DelaunayVerdict judged(const Cells& cells) const {
    return check_regular({points(), cells}, {points(), {weights.begin(), weights.end()}});
  }
};

Cloud random_cloud(std::mt19937& random, unsigned heaviest) {
  Cloud cloud;
  cloud.at = examples::random_points(random, 8 + random() % 6, 60).at;
  for (std::size_t i = 0; i < cloud.at.size(); ++i)
    cloud.weights.push_back(random() % 3 == 0 ? static_cast<int>(random() % heaviest)
                                              : -static_cast<int>(random() % 100));
  return cloud;
}

std::set<std::uint32_t> vertices_of(const Cells& cells) {
  std::set<std::uint32_t> result;
  for (const Tetrahedron& t : cells) result.insert(t.begin(), t.end());
  return result;
}

TEST(Orthospheres, AreThoseOfIntegersInEveryStage) {
  std::mt19937 random(11);
  SignCounts total;
  int zeros = 0;
  for (int round = 0; round < 3000; ++round) {
    Cloud cloud;
    const int range = round % 3 == 0 ? 3 : round % 3 == 1 ? 40 : 1000;
    cloud.at = examples::random_points(random, 5, static_cast<unsigned>(range)).at;
    for (const Lattice& p : cloud.at)
      cloud.weights.push_back(round % 2 == 0 ? static_cast<int>(random() % 99) - 40
                                             : p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 5 * p[1]);
    if (round % 4 == 1) ++cloud.weights[random() % 5];
    if (round % 5 == 0) cloud.weights = std::vector<std::int64_t>(5, round);
    const Whole value = cloud.power({0, 1, 2, 3}, 4);
    const int expected = value > 0 ? 1 : value < 0 ? -1 : 0;
    zeros += expected == 0;
    // Products overflow or underflow; weights alone do; nothing does.
    for (const double scale : {1.0, 0x1p-20, 0x1p-149, 0x1p-151, 0x1p-530, 0x1p150, 0x1p500}) {
      std::array<Point, 5> p{};
      std::array<double, 5> w{};
      for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t k = 0; k < 3; ++k) p[i][k] = static_cast<double>(cloud.at[i][k]) * scale;
        w[i] = static_cast<double>(cloud.weights[i]) * scale * scale;
      }
      Signs signs;
      ASSERT_EQ(signs.in_orthosphere(p[0], p[1], p[2], p[3], p[4], w), expected);
      std::swap(w[0], w[1]);
      ASSERT_EQ(signs.in_orthosphere(p[1], p[0], p[2], p[3], p[4], w), -expected);
      total.by_double += signs.counts().by_double;
      total.by_integers += signs.counts().by_integers;
    }
  }
  EXPECT_GT(zeros, 500);
  EXPECT_GT(total.by_double, 10000U);
  EXPECT_GT(total.by_integers, 5000U);
}

/// Great weights that are nearly those of one affine function: they cancel.
TEST(Orthospheres, SeeOneUnitAmongGreatWeights) {
  std::mt19937_64 random(14);
  int nearly = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto slope = [&] { return static_cast<std::int64_t>(random() >> 24U) - (1LL << 39U); };
    const Lattice slopes = {slope(), slope(), slope()};
    Cloud cloud;
    for (int i = 0; i < 5; ++i) {
      const Lattice p = {static_cast<std::int64_t>(random() % 1000),
                         static_cast<std::int64_t>(random() % 1000),
                         static_cast<std::int64_t>(random() % 1000)};
      cloud.at.push_back(p);
      cloud.weights.push_back(p[0] * (p[0] + slopes[0]) + p[1] * (p[1] + slopes[1]) +
                              p[2] * (p[2] + slopes[2]) + static_cast<int>(random() % 3) - 1);
    }
    const Whole value = cloud.power({0, 1, 2, 3}, 4);
    const std::vector<Point> p = cloud.points();
    const std::vector<std::int64_t>& w = cloud.weights;
    Signs signs;
    ASSERT_EQ(signs.in_orthosphere(
                  p[0], p[1], p[2], p[3], p[4],
                  {static_cast<double>(w[0]), static_cast<double>(w[1]), static_cast<double>(w[2]),
                   static_cast<double>(w[3]), static_cast<double>(w[4])}),
              value > 0   ? 1
              : value < 0 ? -1
                          : 0);
    nearly += signs.counts().by_integers == 1;
  }
  EXPECT_GT(nearly, 2000);
}

TEST(Orthospheres, SeeTheLastPlaceOfAWeight) {
  const Point o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, e{0.25, 0.25, 0.25};
  const auto sign = [&](double weight) {
    Signs signs;
    return signs.in_orthosphere(o, x, y, z, e, {0, 0, 0, 0, weight});
  };
  EXPECT_EQ(sign(-0.5625), 0);
  EXPECT_EQ(sign(std::nextafter(-0.5625, 0)), 1);
  EXPECT_EQ(sign(std::nextafter(-0.5625, -1)), -1);
  Signs signs;
  EXPECT_EQ(signs.in_orthosphere(o, x, y, z, o, {1e300, 0, 0, 0, std::nextafter(1e300, 0)}), -1);
  EXPECT_EQ(signs.in_orthosphere(o, x, y, z, o, {1e300, 0, 0, 0, std::nextafter(1e300, 1e301)}), 1);
  EXPECT_EQ(signs.in_orthosphere(o, x, y, z, o, {0, 5e-324, 5e-324, 7, 5e-324}), 1);
}

TEST(RegularCheck, AcceptsWhatBruteForceFinds) {
  std::mt19937 random(12);
  int accepted = 0;
  std::uint64_t hidden = 0;
  for (int round = 0; round < 300; ++round) {
    const Cloud cloud = random_cloud(random, round % 2 == 0 ? 3000 : 300);
    const Cells cells = cloud.regular();
    if (cells.empty()) continue;
    const DelaunayVerdict verdict = cloud.judged(cells);
    ASSERT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_EQ(verdict.duplicates, 0U);
    EXPECT_EQ(verdict.hidden, cloud.at.size() - vertices_of(cells).size());
    EXPECT_EQ(2 * verdict.facets, 4 * cells.size() + verdict.boundary_facets);
    hidden += verdict.hidden;
    ++accepted;
  }
  EXPECT_GT(accepted, 200);
  EXPECT_GT(hidden, 80U);
}

/// The tetrahedra stay, a weight changes: they fit still, or no longer.
TEST(RegularCheck, SaysWhatBruteForceSaysOfOtherWeights) {
  std::mt19937 random(13);
  int accepted = 0, not_hidden = 0, not_empty = 0;
  for (int round = 0; round < support::share_of(1500); ++round) {
    Cloud cloud = random_cloud(random, 2000);
    const Cells cells = cloud.regular();
    if (cells.empty()) continue;
    for (int changes = 0; changes < 3; ++changes) {
      cloud.weights[random() % cloud.weights.size()] += static_cast<int>(random() % 600) - 300;
      const DelaunayVerdict verdict = cloud.judged(cells);
      ASSERT_EQ(verdict.accepted, cloud.fits(cells)) << verdict.reason;
      accepted += verdict.accepted;
      not_hidden += verdict.broken == DelaunayLaw::kHiddenPoint;
      not_empty += verdict.broken == DelaunayLaw::kEmptySpheres;
      EXPECT_EQ(verdict.accepted + (verdict.broken == DelaunayLaw::kHiddenPoint) +
                    (verdict.broken == DelaunayLaw::kEmptySpheres),
                1);
    }
  }
  EXPECT_GT(accepted, support::share_of(500));
  EXPECT_GT(not_hidden, support::kSanitized ? 0 : 50);
  EXPECT_GT(not_empty, support::share_of(500));
}

/// Ties: all lifted to one hyperplane; any triangulation, with any points hidden, is regular.
TEST(RegularCheck, AcceptsTies) {
  Cloud cloud;
  cloud.at = examples::lattice(2).at;
  for (const Lattice& p : cloud.at)
    cloud.weights.push_back(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - p[2] + 3);
  EXPECT_TRUE(cloud.judged(examples::kuhn(2)).accepted);
  // The cube of the eight corners in five; all other points are hidden.
  const std::array<std::uint32_t, 8> corners = {0, 2, 6, 8, 18, 20, 24, 26};
  Cells five = examples::kFive;
  for (Tetrahedron& t : five)
    for (std::uint32_t& v : t) v = corners[v];
  const DelaunayVerdict verdict = cloud.judged(five);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.hidden, 19U);
  EXPECT_EQ(verdict.cospherical, 4U);
  for (std::size_t i = 0; i < 27; ++i) {
    Cloud other = cloud;
    const bool is_corner = std::find(corners.begin(), corners.end(), i) != corners.end();
    ++other.weights[i];
    if (!is_corner) {
      EXPECT_EQ(other.judged(five).broken, DelaunayLaw::kHiddenPoint) << i;
    }
    other.weights[i] -= 2;
    EXPECT_EQ(other.judged(five).accepted, !is_corner || other.fits(five)) << i;
    EXPECT_EQ(other.judged(examples::kuhn(2)).accepted, other.fits(examples::kuhn(2))) << i;
  }
}

TEST(RegularCheck, TellsDuplicatesFromHiddenPoints) {
  Cloud cloud;
  cloud.at = examples::lattice(1).at;
  cloud.weights = std::vector<std::int64_t>(8, 4);
  cloud.at.insert(cloud.at.end(), {{1, 0, 1}, {1, 0, 1}, {1, 0, 1}});
  cloud.weights.insert(cloud.weights.end(), {4, 3, 3});
  const DelaunayVerdict verdict = cloud.judged(examples::kFive);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.duplicates, 1U);
  EXPECT_EQ(verdict.hidden, 2U);
  cloud.weights.back() = 5;
  EXPECT_EQ(cloud.judged(examples::kFive).broken, DelaunayLaw::kHiddenPoint);
  cloud.weights.back() = -1000;
  cloud.at.back() = {2, 0, 0};
  const DelaunayVerdict outside = cloud.judged(examples::kFive);
  EXPECT_EQ(outside.broken, DelaunayLaw::kHiddenPoint);
  EXPECT_NE(outside.reason.find("point 10"), std::string::npos) << outside.reason;
  EXPECT_NE(outside.reason.find("outside of all"), std::string::npos) << outside.reason;
}

TEST(RegularCheck, WantsTheGivenPoints) {
  Cloud cloud;
  cloud.at = examples::lattice(1).at;
  cloud.weights = std::vector<std::int64_t>(8, 4);
  TetrahedralMesh mesh{cloud.points(), examples::kFive};
  WeightedPoints given{mesh.points, {0, 0, 0, 0, 0, 0, 0, 0}};
  EXPECT_TRUE(check_regular(mesh, given).accepted);
  given.points.push_back({0, 0, 0});
  given.weights.push_back(0);
  EXPECT_EQ(check_regular(mesh, given).broken, DelaunayLaw::kGivenPoints);
  given.points.resize(8);
  given.weights.resize(8);
  given.points[3][1] += 1;
  EXPECT_EQ(check_regular(mesh, given).broken, DelaunayLaw::kGivenPoints);
}

TEST(RegularCheck, ReadsWeights) {
  const std::vector<Point> points = {{0, -1.5, 2e-3}, {4, 5, 6}};
  const WeightedPoints text =
      parse_weighted_points("a.xyz", "# points\n0 -1.5 2e-3 -7 # first\n\n4 5 6 1e300");
  EXPECT_EQ(text.points, points);
  EXPECT_EQ(text.weights, (std::vector<double>{-7, 1e300}));
  std::array<double, 8> numbers = {0, -1.5, 2e-3, -7, 4, 5, 6, 1e300};
  const auto bytes = [&] {
    std::string result(sizeof numbers, '\0');
    std::memcpy(result.data(), numbers.data(), sizeof numbers);
    return result;
  };
  EXPECT_EQ(parse_weighted_points("a.bin", bytes()).points, points);
  EXPECT_EQ(parse_weighted_points("a.bin", bytes()).weights, text.weights);
  EXPECT_EQ(parse_weighted_points("pipe", "1 2 3 4").weights, (std::vector<double>{4}));
  EXPECT_THROW((void)parse_weighted_points("a.bin", bytes().substr(8)), Malformed);
  EXPECT_THROW((void)parse_weighted_points("a.xyz", "1 2 3\n"), Malformed);
  EXPECT_EQ(parse_weighted_points("a.xyz", "1 2 3 4 5 red\n").weights, std::vector<double>{4});
  EXPECT_THROW((void)parse_weighted_points("a.xyz", "1 2 3 inf\n"), Malformed);
  EXPECT_THROW((void)parse_weighted_points("a.ply", "ply\n"), Malformed);
  numbers[3] = std::nan("");
  EXPECT_THROW((void)parse_weighted_points("a.bin", bytes()), Malformed);
}

}  // namespace
}  // namespace hexatlas::check
