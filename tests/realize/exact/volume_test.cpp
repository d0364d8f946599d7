// Claim. sign_of_volume() is the exact sign of the enclosed volume, however far from the origin
// and however small the body. Oracle. Integer coordinates and 128-bit integers; a cube's volume.
#include "realize/exact/volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "enum/core/errors.hpp"

namespace {

using namespace hexatlas::exact;
using Triangle = std::array<Point3, 3>;

/// The tetrahedron on four points, counter-clockwise from outside if they are positively oriented.
std::vector<Triangle> surface_of(const Point3& a, const Point3& b, const Point3& c,
                                 const Point3& d) {
  return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

__extension__ using Wide = __int128;

int oracle(const std::array<std::array<std::int64_t, 3>, 4>& p) {
  std::array<std::array<Wide, 3>, 3> e{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) e[i][k] = p[i + 1][k] - p[0][k];
  const Wide det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                   e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                   e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

TEST(Volume, OfTetrahedraOnIntegers) {
  std::mt19937_64 random(1);
  int zeros = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::int64_t shift = i % 3 == 0 ? 0 : std::int64_t{1} << (i % 50);
    std::array<std::array<std::int64_t, 3>, 4> p{};
    std::array<Point3, 4> q{};
    for (std::size_t v = 0; v < 4; ++v) {
      for (auto& x : p[v]) x = shift + static_cast<std::int64_t>(random() % 4);
      q[v] = {static_cast<double>(p[v][0]), static_cast<double>(p[v][1]),
              static_cast<double>(p[v][2])};
    }
    const int expected = oracle(p);
    zeros += expected == 0 ? 1 : 0;
    EXPECT_EQ(static_cast<int>(sign_of_volume(surface_of(q[0], q[1], q[2], q[3]))), expected);
  }
  EXPECT_GT(zeros, 100);
}

TEST(Volume, OfTinyAndHugeBodies) {
  for (const double scale : {5e-324, 1e-300, 1.0, 1e300}) {
    const Point3 o{0, 0, 0}, x{scale, 0, 0}, y{0, scale, 0}, z{0, 0, scale};
    EXPECT_EQ(sign_of_volume(surface_of(o, x, y, z)), Sign::positive) << scale;
    EXPECT_EQ(sign_of_volume(surface_of(o, y, x, z)), Sign::negative) << scale;
    EXPECT_EQ(sign_of_volume(surface_of(o, x, y, x)), Sign::zero) << scale;
  }
}

TEST(Volume, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)sign_of_volume(surface_of({nan, 0, 0}, {}, {}, {})),
               hexatlas::core::PreconditionViolated);
}

TEST(Volume, OfNothingIsZero) { EXPECT_EQ(sign_of_volume({}), Sign::zero); }

}  // namespace
