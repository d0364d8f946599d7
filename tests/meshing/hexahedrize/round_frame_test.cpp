// Claim. A round frame takes points to ones of mean 0 and covariance 1 and back, keeps
// orientations, and says how far from round they were. Oracle. The definitions, on boxes of random
// points that were stretched and sheared.
#include "meshing/hexahedrize/round_frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace hexatlas {
namespace {

using hexahedrize::RoundFrame;
using Row = std::array<double, 3>;

std::vector<mesh::Point> points_in_a_box(const Row& sides, double shear, std::mt19937_64& random) {
  const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  std::vector<mesh::Point> points(500);
  for (mesh::Point& p : points) {
    p = {sides[0] * unit(), sides[1] * unit(), sides[2] * unit()};
    p.y += shear * p.x;
  }
  return points;
}

TEST(RoundFrame, MakesTheCovarianceOne) {
  std::mt19937_64 random(1);
  for (const Row& sides : {Row{1, 1, 1}, Row{1000, 1, 1}, Row{1, 1e-6, 1e9}, Row{1e-200, 1, 1e200}})
    for (const double shear : {0.0, 0.3, -100.0}) {
      const auto points = points_in_a_box(sides, shear * sides[1] / sides[0], random);
      const auto frame = RoundFrame::of(points);
      ASSERT_TRUE(frame.has_value());
      Row mean{};
      std::array<Row, 3> covariance{};
      for (const mesh::Point& point : points) {
        const mesh::Point p = frame->into(point);
        const Row at{p.x, p.y, p.z};
        for (std::size_t i = 0; i < 3; ++i) {
          mean[i] += at[i] / 500;
          for (std::size_t j = 0; j < 3; ++j) covariance[i][j] += at[i] * at[j] / 500;
        }
        const mesh::Point back = frame->back(p);
        EXPECT_NEAR(back.x / sides[0], point.x / sides[0], 1e-12);
        EXPECT_NEAR(back.y / sides[1], point.y / sides[1], 1e-10);
        EXPECT_NEAR(back.z / sides[2], point.z / sides[2], 1e-12);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(mean[i], 0, 1e-9);
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(covariance[i][j], i == j ? 1 : 0, 1e-8);
      }
      // Right-handed stays right-handed.
      const mesh::Point o = frame->into({0, 0, 0});
      EXPECT_GT(frame->into({sides[0], 0, 0}).x, o.x);
      EXPECT_GT(frame->into({0, sides[1], 0}).y, o.y);
      EXPECT_GT(frame->into({0, 0, sides[2]}).z, o.z);
    }
}

TEST(RoundFrame, TellsHowSkew) {
  std::mt19937_64 random(2);
  EXPECT_LT(RoundFrame::of(points_in_a_box({3, 3, 3}, 0, random))->skewness(), 1.1);
  EXPECT_LT(RoundFrame::of(points_in_a_box({3, 2, 2}, 0, random))->skewness(), 2);
  EXPECT_GT(RoundFrame::of(points_in_a_box({5, 1, 1}, 0, random))->skewness(), 2);
  EXPECT_GT(RoundFrame::of(points_in_a_box({1, 1, 1}, 30, random))->skewness(), 2);
}

TEST(RoundFrame, NeedsABody) {
  std::mt19937_64 random(3);
  EXPECT_FALSE(RoundFrame::of(points_in_a_box({1, 1, 0}, 0, random)).has_value());
  std::vector<mesh::Point> plane = points_in_a_box({1, 1, 1}, 0, random);
  for (mesh::Point& p : plane) p.z = p.x + p.y;
  EXPECT_FALSE(RoundFrame::of(plane).has_value());
  EXPECT_FALSE(RoundFrame::of({}).has_value());
  const std::vector<mesh::Point> far{{-1e308, 0, 0}, {1e308, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  EXPECT_FALSE(RoundFrame::of(far).has_value());
}

}  // namespace
}  // namespace hexatlas
