// The bounds of the first stage. u = 2^-53 bounds the relative error of one rounding.
//
// Claim. Let X, Y, Z bound the absolute values of the computed differences in each coordinate, all
// three between 2^-150 and 2^150. Then the computed orientation differs from the true one by less
// than 2^-47 fl(XYZ), the computed value of in_sphere by less than 2^-44 fl(XYZ (XX + YY + ZZ)).
//
// Proof. First without underflow. The value computed is the sum of the monomials of the true
// polynomial in the true differences, each multiplied by factors 1 + d or 1 / (1 + d), |d| <= u,
// one for each operation on its way to the result. Orientation: 3 differences, 1 product and 1 sum
// in a minor of two rows, 1 product and 2 sums, hence at most 8 factors; a monomial is at most
// XYZ (1 - u)^-3, and there are 6 of them: the error is at most 6 * 8.01 u XYZ < 48.1 u XYZ.
// Sphere: 5 differences, 2 operations in the minor, 3 in the determinant of three rows, 3 in the
// sum of squares, 1 product and 3 sums, hence at most 17 factors; there are 4 * 6 monomials in x y
// z, each times a sum of three squares: at most 24 * 17.01 u XYZ (XX + YY + ZZ) < 408.3 u (...).
// The bounds are 64 u and 512 u times a computed value that is less than the true one by at most
// nine roundings. Underflow: a difference has none (it is exact if it is subnormal). Each of the
// at most 40 products errs by at most h = 2^-1075, which is then multiplied by what the product is
// multiplied by: in relation to the bound by at most h over the product of the bounds of its
// factors, which is at least 2^-750. This is less than 2^-320 of the bound each time, and far below
// what is left between 408.3 u and 512 u, and between 48.1 u and 64 u. Nothing overflows, since
// 72 * 2^750 is finite. QED
//
// Orthospheres. Let also V bound the absolute values of the computed differences of weights, at
// most 2^300. Then the computed value differs from the true one by less than 2^-44 fl(XYZ (XX + YY
// + ZZ + V)). For the sum of squares less a difference of weights has one operation more, hence at
// most 18 factors; the monomials are 24 in x y z, each times a sum of three squares and a weight:
// at most 24 * 18.02 u XYZ (XX + YY + ZZ + V) < 432.5 u (...). Differences do not underflow, 96 *
// 2^750 is finite, and the rest is as above. QED
//
// The second stage: with entries of at most B bits, minors have 2 B + 1 and sums of squares
// 2 B + 2 bits, at most 63 for B = 30; orientations have 3 B + 3 bits; for spheres the sum is at
// most 4 * 6 * 3 * 2^(5B) < 2^(5B + 7), at most 127 bits for B = 24. Orientations with B = 31 need
// minors of at most 2 * 2^62 = 2^63, which entries below 2^31 do not reach.
#include "tables/check/signs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <functional>
#include <limits>

#include "tables/check/exact.hpp"
#include "tables/check/wide.hpp"

namespace hexatlas::check {

namespace {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the error bounds need IEEE double precision, each operation rounded once");

template <class Small>
Small square(const Vector<Small>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

template <class Small>
std::array<Small, 4> squares(const std::array<Vector<Small>, 4>& v) {
  return {square(v[0]), square(v[1]), square(v[2]), square(v[3])};
}

/// Minus the determinant of the rows (v, height), expanded by the last column.
template <class Large, class Small>
Large lifted_determinant(const std::array<Vector<Small>, 4>& v,
                         const std::array<Small, 4>& height) {
  const Small ab = minor_of(v[0], v[1]);
  const Small ac = minor_of(v[0], v[2]);
  const Small ad = minor_of(v[0], v[3]);
  const Small bc = minor_of(v[1], v[2]);
  const Small bd = minor_of(v[1], v[3]);
  const Small cd = minor_of(v[2], v[3]);
  const std::array<Large, 4> z = {Large(v[0][2]), Large(v[1][2]), Large(v[2][2]), Large(v[3][2])};
  const Large bcd = z[1] * cd - z[2] * bd + z[3] * bc;
  const Large acd = z[0] * cd - z[2] * ad + z[3] * ac;
  const Large abd = z[0] * bd - z[1] * ad + z[3] * ab;
  const Large abc = z[0] * bc - z[1] * ac + z[2] * ab;
  return (bcd * height[0] - acd * height[1]) + (abd * height[2] - abc * height[3]);
}

template <class Large, class Small>
Large sphere_determinant(const std::array<Vector<Small>, 4>& v) {
  return lifted_determinant<Large>(v, squares(v));
}

template <class Number>
int sign_of(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Whether to - from is exact, when `result` is its rounded value: then Knuth's TwoSum has no rest.
/// An overflow makes the rest no number, or infinite, and so not zero.
bool is_exact(double to, double from, double result) {
  const double from_part = to - result;
  const double to_part = result + from_part;
  return (to - to_part) + (from_part - from) == 0;
}

template <std::size_t kCount>
bool are_exact(const std::array<const Point*, kCount>& points, const Point& origin,
               const std::array<Vector<double>, kCount>& differences) {
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!is_exact((*points[i])[axis], origin[axis], differences[i][axis])) return false;
    }
  }
  return true;
}

/// The values as multiples of a power of two that they share; false if one needs more than `bits`
/// bits, which are at most 52.
template <std::size_t kCount>
bool as_words(const std::array<Vector<double>, kCount>& values, int bits,
              std::array<Vector<std::int64_t>, kCount>& words) {
  int unit = std::numeric_limits<int>::max();
  int end = std::numeric_limits<int>::min();
  for (const Vector<double>& v : values) {
    for (const double value : v) {
      const Parts parts = parts_of(value);
      if (parts.mantissa == 0) continue;
      unit = std::min(unit, parts.exponent + std::countr_zero(parts.mantissa));
      end = std::max(end, parts.exponent + static_cast<int>(std::bit_width(parts.mantissa)));
    }
  }
  if (end > std::numeric_limits<int>::min() && end - unit > bits) return false;
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Parts parts = parts_of(values[i][axis]);
      // The lowest bit that is set is not below the unit, so only zeros are shifted out; bits of a
      // subnormal number may lie above it.
      const int shift = parts.mantissa == 0 ? 0 : parts.exponent - unit;
      const auto size = static_cast<std::int64_t>(shift >= 0 ? parts.mantissa << shift
                                                             : parts.mantissa >> -shift);
      words[i][axis] = values[i][axis] < 0 ? -size : size;
    }
  }
  return true;
}

/// Differences of the first points from the last one.
template <std::size_t kCount>
std::array<Vector<mpz_class>, kCount> integer_differences(
    const std::array<const Point*, kCount + 1>& points) {
  const auto integers = as_integers(points);
  std::array<Vector<mpz_class>, kCount> differences;
  for (std::size_t i = 0; i < kCount; ++i) {
    differences[i] = difference(integers[i], integers[kCount]);
  }
  return differences;
}

}  // namespace

int Signs::orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const std::array<Vector<double>, 3> v = {difference(b, a), difference(c, a), difference(d, a)};
  const Vector<double> bounds = bounds_of(v);
  if (are_moderate(bounds)) {
    const double value = determinant<double>(v);
    if (std::abs(value) > 0x1p-47 * (bounds[0] * bounds[1] * bounds[2])) {
      ++counts_.by_double;
      return sign_of(value);
    }
  }
  std::array<Vector<std::int64_t>, 3> words{};
  if (are_exact<3>({&b, &c, &d}, a, v) && as_words(v, 31, words)) {
    ++counts_.by_words;
    return sign_of(determinant<Wide>(words));
  }
  ++counts_.by_integers;
  return sign_of(determinant<mpz_class>(integer_differences<3>({&b, &c, &d, &a})));
}

int Signs::in_sphere(const Point& a, const Point& b, const Point& c, const Point& d,
                     const Point& e) {
  const std::array<Vector<double>, 4> v = {difference(a, e), difference(b, e), difference(c, e),
                                           difference(d, e)};
  const Vector<double> bounds = bounds_of(v);
  if (are_moderate(bounds)) {
    const double value = sphere_determinant<double>(v);
    if (std::abs(value) > 0x1p-44 * (bounds[0] * bounds[1] * bounds[2] * square(bounds))) {
      ++counts_.by_double;
      return sign_of(value);
    }
  }
  std::array<Vector<std::int64_t>, 4> words{};
  if (are_exact<4>({&a, &b, &c, &d}, e, v) && as_words(v, 24, words)) {
    ++counts_.by_words;
    return sign_of(sphere_determinant<Wide>(words));
  }
  ++counts_.by_integers;
  return sign_of(sphere_determinant<mpz_class>(integer_differences<4>({&a, &b, &c, &d, &e})));
}

int Signs::in_orthosphere(const Point& a, const Point& b, const Point& c, const Point& d,
                          const Point& e, const std::array<double, 5>& weights) {
  if (std::adjacent_find(weights.begin(), weights.end(), std::not_equal_to<>()) == weights.end()) {
    return in_sphere(a, b, c, d, e);
  }
  const std::array<Vector<double>, 4> v = {difference(a, e), difference(b, e), difference(c, e),
                                           difference(d, e)};
  const Vector<double> bounds = bounds_of(v);
  std::array<double, 4> height = squares(v);
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = weights[i] - weights[4];
    height[i] -= weight;
    most = std::max(most, std::abs(weight));
  }
  if (are_moderate(bounds) && most <= 0x1p300) {
    const double value = lifted_determinant<double>(v, height);
    const double bound = 0x1p-44 * (bounds[0] * bounds[1] * bounds[2] * (square(bounds) + most));
    if (std::abs(value) > bound) {
      ++counts_.by_double;
      return sign_of(value);
    }
  }
  ++counts_.by_integers;
  const std::array<const Point*, 5> points = {&a, &b, &c, &d, &e};
  int unit = unit_of(points);
  for (const double weight : weights) {
    // Weights are multiples of the square of the unit.
    if (weight != 0) unit = std::min(unit, parts_of(weight).exponent >> 1);
  }
  const auto places = as_integers(points, unit);
  std::array<Vector<mpz_class>, 4> differences;
  for (std::size_t i = 0; i < 4; ++i) differences[i] = difference(places[i], places[4]);
  std::array<mpz_class, 4> heights = squares(differences);
  for (std::size_t i = 0; i < 4; ++i) {
    heights[i] += as_integer(weights[4], 2 * unit) - as_integer(weights[i], 2 * unit);
  }
  return sign_of(lifted_determinant<mpz_class>(differences, heights));
}

int Signs::orientation_of_centroid(const Point& a, const Point& b, const Point& c,
                                   std::span<const Point, 4> points) {
  // The centroid minus a is a quarter of the sum of the differences.
  const auto v =
      integer_differences<6>({&b, &c, &points[0], &points[1], &points[2], &points[3], &a});
  Vector<mpz_class> sum;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 2; i < 6; ++i) sum[axis] += v[i][axis];
  }
  ++counts_.by_integers;
  return sign_of(determinant<mpz_class>(std::array<Vector<mpz_class>, 3>{v[0], v[1], sum}));
}

}  // namespace hexatlas::check
