#pragma once
/// \file
/// Rotations of the cube and their lifts: the binary octahedral group, exactly.
///
/// A rotation of the cube is covered by two unit quaternions that differ by sign. Up to a positive
/// factor each of these 48 has coprime integer components, and that is how they are kept: products
/// are exact, and equality is that of four integers.

#include <array>
#include <cstddef>
#include <numeric>

namespace hexatlas::complex {

/// A vector along an axis of a cube: +1 or -1 there, 0 elsewhere.
using AxisVector = std::array<int, 3>;

struct Quaternion {
  int w = 1, x = 0, y = 0, z = 0;  ///< coprime

  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
  [[nodiscard]] constexpr Quaternion operator-() const noexcept { return {-w, -x, -y, -z}; }
  [[nodiscard]] constexpr Quaternion inverse() const noexcept { return {w, -x, -y, -z}; }
  friend constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept {
    const Quaternion product{a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                             a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                             a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                             a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    const int common = std::gcd(std::gcd(product.w, product.x), std::gcd(product.y, product.z));
    return {product.w / common, product.x / common, product.y / common, product.z / common};
  }
};

/// A quarter of a turn about an axis, counter-clockwise seen from its end.
[[nodiscard]] constexpr Quaternion quarter_turn(const AxisVector& axis) noexcept {
  return {1, axis[0], axis[1], axis[2]};
}

/// Where a rotation of the cube takes a vector along an axis.
[[nodiscard]] constexpr AxisVector rotated(const Quaternion& q, const AxisVector& v) noexcept {
  const Quaternion image = q * Quaternion{0, v[0], v[1], v[2]} * q.inverse();
  return {image.x, image.y, image.z};
}

[[nodiscard]] constexpr AxisVector cross(const AxisVector& a, const AxisVector& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// One of the two lifts of the rotation that takes x to `x_image` and y to `y_image`, which are
/// perpendicular.
[[nodiscard]] constexpr Quaternion rotation(const AxisVector& x_image,
                                            const AxisVector& y_image) noexcept {
  constexpr AxisVector x{1, 0, 0}, y{0, 1, 0};
  Quaternion result;
  if (x_image == AxisVector{-1, 0, 0})
    result = {0, 0, 1, 0};
  else if (x_image != x)
    result = quarter_turn(cross(x, x_image));
  // Now x is where it belongs; turn about it.
  while (rotated(result, y) != y_image) result = quarter_turn(x_image) * result;
  return result;
}

}  // namespace hexatlas::complex
