#pragma once
/// \file
/// Internal to the judge: exact signs of orientations and of spheres, of points with any finite
/// doubles as coordinates.
///
/// Three stages, each of which decides or passes on:
/// 1. double precision, if the computed value exceeds a bound of its error (signs.cpp has the
///    proof);
/// 2. integers of 64 and 128 bits, if the differences of coordinates are exact and, as multiples of
///    a power of two that they share, have at most 31 bits (orientations) or 24 bits (spheres), as
///    on lattices;
/// 3. integers of GMP.
///
/// Preconditions: finite coordinates and weights, round to nearest. Errors: none. Cost: some 20 ns
/// to 100 ns in the first two stages, microseconds in the third; it grows with the range of the
/// exponents.

#include <array>
#include <cstdint>
#include <span>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

/// How many signs each stage has decided.
struct SignCounts {
  std::uint64_t by_double = 0;
  std::uint64_t by_words = 0;
  std::uint64_t by_integers = 0;
};

/// The signs are -1, 0, 1.
class Signs {
 public:
  /// Of det(b - a, c - a, d - a).
  [[nodiscard]] int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

  /// Positive if e is strictly inside the sphere through a, b, c, d; zero if it is on it.
  /// Requires orientation(a, b, c, d) > 0.
  [[nodiscard]] int in_sphere(const Point& a, const Point& b, const Point& c, const Point& d,
                              const Point& e);

  /// The same with weights of a, b, c, d, e: positive if the power distance of e to the orthosphere
  /// of a, b, c, d is less than the weight of e, so that e is below the affine function with the
  /// values |p|^2 - weight at a, b, c, d; zero if it is on it. Without the second stage.
  [[nodiscard]] int in_orthosphere(const Point& a, const Point& b, const Point& c, const Point& d,
                                   const Point& e, const std::array<double, 5>& weights);

  /// orientation(a, b, c, m) with the centroid m of `points`. Always by GMP.
  [[nodiscard]] int orientation_of_centroid(const Point& a, const Point& b, const Point& c,
                                            std::span<const Point, 4> points);

  [[nodiscard]] const SignCounts& counts() const { return counts_; }

 private:
  SignCounts counts_;
};

}  // namespace hexatlas::check
