#pragma once
/// \file
/// In-sphere signs for tests: the determinant of five rows (1, x, y, z, height) by elimination
/// without fractions. Of the library only the door to GMP is used.

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "realize/exact/integers.hpp"

namespace hexatlas::in_sphere_oracle {

using Row = std::array<mpz_class, 5>;
using Rows = std::array<Row, 5>;
using Tuple = std::array<exact::Point3, 5>;

/// Bareiss: each division is exact.
inline int sign_of_determinant(Rows rows) {
  int sign = 1;
  mpz_class before = 1;
  for (std::size_t k = 0; k < 5; ++k) {
    std::size_t pivot = k;
    while (pivot < 5 && rows[pivot][k] == 0) ++pivot;
    if (pivot == 5) return 0;
    if (pivot != k) {
      std::swap(rows[pivot], rows[k]);
      sign = -sign;
    }
    for (std::size_t i = k + 1; i < 5; ++i)
      for (std::size_t j = 4; j > k; --j) {
        rows[i][j] = rows[i][j] * rows[k][k] - rows[i][k] * rows[k][j];
        mpz_divexact(rows[i][j].get_mpz_t(), rows[i][j].get_mpz_t(), before.get_mpz_t());
      }
    before = rows[k][k];
  }
  return sign * sgn(before);
}

using Weights = std::array<double, 5>;

/// Rows (1, p, |p|^2 - weight) times powers of a common denominator.
inline Rows rows_of(const Tuple& points, const Weights& weights = {}) {
  std::array<std::array<mpq_class, 3>, 5> real;
  mpz_class denominator = 1;
  for (std::size_t i = 0; i < 5; ++i) {
    real[i] = {mpq_class(points[i].x), mpq_class(points[i].y), mpq_class(points[i].z)};
    for (const mpq_class& c : real[i])
      if (c.get_den() > denominator) denominator = c.get_den();
  }
  // Denominators are powers of two.
  for (const double w : weights)
    while (denominator * denominator < mpq_class(w).get_den()) denominator *= 2;
  Rows rows;
  for (std::size_t i = 0; i < 5; ++i) {
    const mpq_class weight = mpq_class(weights[i]) * denominator * denominator;
    rows[i][0] = 1;
    rows[i][4] = -weight.get_num();
    for (std::size_t k = 0; k < 3; ++k) {
      rows[i][k + 1] = real[i][k].get_num() * (denominator / real[i][k].get_den());
      rows[i][4] += rows[i][k + 1] * rows[i][k + 1];
    }
  }
  return rows;
}

/// Positive if e is inside and a, b, c, d have positive orientation: opposite to the determinant.
inline int in_sphere(const Tuple& points, const Weights& weights = {}) {
  return -sign_of_determinant(rows_of(points, weights));
}

/// With real numbers instead of infinitesimals: the point of rank r is raised by 2^(256 (r - 6)).
/// Requires. Orientations below 2^255 in units of the last common bit.
inline int perturbed_in_sphere(const Tuple& points, const Weights& weights = {}) {
  Rows rows = rows_of(points, weights);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto place = [&](std::size_t j) {
      return std::tie(points[j].x, points[j].y, points[j].z);
    };
    unsigned rank = 0;
    for (std::size_t j = 0; j < 5; ++j) rank += place(j) < place(i) ? 1 : 0;
    rows[i][4] = (rows[i][4] << 256U * 6U) + (mpz_class(1) << 256U * rank);
  }
  return -sign_of_determinant(rows);
}

}  // namespace hexatlas::in_sphere_oracle
