#include "realize/exact/volume.hpp"

#include <limits>

#include "realize/exact/integers.hpp"

namespace hexatlas::exact {
namespace {

/// The exponent of the last bit that any coordinate uses.
int unit_exponent_of(std::span<const std::array<Point3, 3>> triangles) {
  int unit = std::numeric_limits<int>::max();
  for (const auto& triangle : triangles)
    for (const Point3& p : triangle)
      for (const double value : {p.x, p.y, p.z})
        if (value != 0) unit = std::min(unit, binary_parts(value).exponent);
  return unit;
}

}  // namespace

Sign sign_of_volume(std::span<const std::array<Point3, 3>> triangles) {
  for (const auto& triangle : triangles) expect_finite(triangle);
  const int unit = unit_exponent_of(triangles);
  const auto scaled = [&](const Point3& p) -> std::array<Integer, 3> {
    return {scaled_integer(p.x, unit), scaled_integer(p.y, unit), scaled_integer(p.z, unit)};
  };
  Integer volume = 0;
  for (const auto& triangle : triangles) {
    const auto a = scaled(triangle[0]);
    const auto b = scaled(triangle[1]);
    const auto c = scaled(triangle[2]);
    volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
              a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sign_of(volume);
}

}  // namespace hexatlas::exact
