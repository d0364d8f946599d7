#pragma once
/// \file
/// Determinants of three vectors, and a bound on their error in double precision.
/// Private to realize/exact.
///
/// Claim. Let the vectors be differences of finite doubles, computed in double precision, and let
/// X, Y, Z be upper bounds on the absolute values of the computed coordinates x, y, z. If
/// 2^-300 <= X, Y, Z <= 2^300, then a sum of N <= 8 determinants, computed by `determinant` and
/// added one by one, differs from its real value by at most N 2^-46 fl(fl(XY)Z).
///
/// Proof. u = 2^-53 and h = 2^-1075 are the greatest relative error and the greatest error by
/// underflow of one rounding to nearest; P = XYZ.
/// (1) A difference of doubles is exact if it is subnormal, so it has a relative error of at most u
///     and no error by underflow. A product of three true differences is that of the computed
///     ones divided by three factors 1 + d, |d| <= u: they differ by at most 3.01 u P. Six
///     such products: 18.06 u P.
/// (2) With the computed entries: a product yz has an error of at most u YZ + h; a difference of
///     two of them at most 2 (u YZ + h) + u (2 YZ (1 + u) + 2 h) <= 4.01 u YZ + 2.01 h.
///     Multiplied by x and rounded: at most X (4.01 u YZ + 2.01 h) + 2.01 u P + h
///     <= 6.02 u P + 2.01 X h + h. Three such terms: 18.06 u P + 6.03 X h + 3 h. Each term is at
///     most 2.01 P, so the two additions err by at most (4.02 + 6.04) u P = 10.06 u P.
/// (3) P >= 2^-900 and YZ >= 2^-600, so h <= 2^-175 P and X h <= 2^-475 P: the terms with h are
///     below 0.01 u P. In sum a determinant errs by at most 46.2 u P.
/// (4) A computed determinant is at most 6.04 P, and so adding N of them to zero one by one errs
///     by at most 6.05 u P (2 + ... + N) <= 3.03 N (N + 1) u P. The whole error is at most
///     N (46.2 + 3.03 (N + 1)) u P <= 73.5 N u P for N <= 8. Now fl(fl(XY)Z) >= (1 - u)^2 P and
///     N 2^-46 = 128 N u. Nothing overflows, since 49 P < 2^906.

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the error bound needs IEEE double precision, each operation rounded once");

template <class Number>
struct Vector3 {
  Number x, y, z;
};

/// The types of products of two, three and five numbers.
template <class Number>
struct Degrees {
  using Two = Number;
  using Three = Number;
  using Five = Number;
};

template <class Number>
[[nodiscard]] Vector3<Number> difference(const Vector3<Number>& to, const Vector3<Number>& from) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

template <class Number>
[[nodiscard]] Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Number>
[[nodiscard]] Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
[[nodiscard]] typename Degrees<Number>::Three determinant(const Vector3<Number>& a,
                                                          const Vector3<Number>& b,
                                                          const Vector3<Number>& c) {
  return a.x * (b.y * c.z - b.z * c.y) + b.x * (c.y * a.z - c.z * a.y) +
         c.x * (a.y * b.z - a.z * b.y);
}

/// Collects the computed differences and then judges sums of their determinants.
class DeterminantFilter {
 public:
  void include(const Vector3<double>& v) noexcept {
    x_ = std::max(x_, std::abs(v.x));
    y_ = std::max(y_, std::abs(v.y));
    z_ = std::max(z_, std::abs(v.z));
  }

  /// fl(fl(XY)Z) of the claim, between 2^-901 and 2^901, or nullopt if the claim does not apply.
  [[nodiscard]] std::optional<double> unit() const noexcept {
    if (!(std::min({x_, y_, z_}) >= kLeast && std::max({x_, y_, z_}) <= kGreatest))
      return std::nullopt;
    return x_ * y_ * z_;
  }

  /// The sign of a sum of `count` determinants whose computed value is `sum`, or nullopt.
  [[nodiscard]] std::optional<Sign> sign(double sum, int count) const noexcept {
    const std::optional<double> unit_or_none = unit();
    if (!unit_or_none) return std::nullopt;
    const double bound = kErrorPerDeterminant * count * *unit_or_none;
    if (sum > bound) return Sign::positive;
    if (sum < -bound) return Sign::negative;
    return std::nullopt;
  }

 private:
  static constexpr double kLeast = 0x1p-300;
  static constexpr double kGreatest = 0x1p300;
  static constexpr double kErrorPerDeterminant = 0x1p-46;

  double x_ = 0, y_ = 0, z_ = 0;
};

}  // namespace hexatlas::exact
