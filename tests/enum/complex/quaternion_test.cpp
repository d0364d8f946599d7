// Claim. Lifts of the rotations of the cube multiply exactly: 48 of them, two for each rotation.
// Oracle. The group made by two quarter turns, element by element; matrices of determinant 1.
#include "enum/complex/quaternion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace {

using namespace hexatlas::complex;

constexpr std::array<AxisVector, 6> kAxes{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

/// All products of quarter turns about x and y.
std::vector<Quaternion> group() {
  std::vector<Quaternion> result{Quaternion{}};
  for (std::size_t i = 0; i < result.size(); ++i)
    for (const AxisVector& axis : {kAxes[0], kAxes[2]}) {
      const Quaternion next = quarter_turn(axis) * result[i];
      if (std::find(result.begin(), result.end(), next) == result.end()) result.push_back(next);
    }
  return result;
}

TEST(Quaternion, TheGroupHas48ElementsWithInverses) {
  const auto all = group();
  EXPECT_EQ(all.size(), 48U);
  for (const Quaternion& a : all) {
    EXPECT_EQ(a * a.inverse(), Quaternion{});
    EXPECT_NE(std::find(all.begin(), all.end(), -a), all.end());
  }
}

TEST(Quaternion, AFullTurnIsMinusOne) {
  for (const AxisVector& axis : kAxes) {
    const Quaternion quarter = quarter_turn(axis);
    EXPECT_EQ(quarter * quarter * quarter * quarter, -Quaternion{});
  }
}

TEST(Quaternion, ProductsRotateOneAfterTheOther) {
  const auto all = group();
  for (const Quaternion& a : all)
    for (const Quaternion& b : all)
      for (const AxisVector& v : kAxes) ASSERT_EQ(rotated(a * b, v), rotated(a, rotated(b, v)));
}

TEST(Quaternion, AQuarterTurnIsCounterClockwise) {
  for (const AxisVector& axis : kAxes)
    for (const AxisVector& v : kAxes) {
      if (cross(axis, v) == AxisVector{}) continue;
      EXPECT_EQ(rotated(quarter_turn(axis), v), cross(axis, v));
    }
}

TEST(Quaternion, RotationsAreFoundByTheirImages) {
  int found = 0;
  for (const AxisVector& x : kAxes)
    for (const AxisVector& y : kAxes) {
      if (cross(x, y) == AxisVector{}) continue;
      const Quaternion q = rotation(x, y);
      EXPECT_EQ(rotated(q, {1, 0, 0}), x);
      EXPECT_EQ(rotated(q, {0, 1, 0}), y);
      EXPECT_EQ(rotated(q, {0, 0, 1}), cross(x, y));
      ++found;
    }
  EXPECT_EQ(found, 24);
}

}  // namespace
