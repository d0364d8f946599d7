#include "tables/check/jacobian.hpp"

#include <algorithm>

#include "tables/check/exact.hpp"

namespace hexatlas::check {

namespace {

/// Coefficient (i, j, k) at i + 3j + 9k, times a common positive factor.
template <class Number>
using Bernstein = std::array<Number, 27>;

constexpr std::array<unsigned, 3> kStride = {1, 3, 9};
constexpr std::array<std::size_t, 8> kCorners = {0, 2, 6, 8, 18, 20, 24, 26};

/// The Bernstein coefficients, times one, two, four or eight (times_eight). The derivative in one
/// direction has degree 1 in the two others, with differences of points as coefficients. The
/// product of two polynomials of degree 1 with coefficients f, g has the coefficients f0 g0, (f0 g1
/// + f1 g0) / 2, f1 g1. `of_edges` is the determinant of the three edges that begin in these
/// corners, one in each direction. Each sum has at most eight terms.
template <class Number, class OfEdges>
Bernstein<Number> sums_of(const OfEdges& of_edges) {
  Bernstein<Number> sums{};
  for (unsigned x2 = 0; x2 < 2; ++x2) {
    for (unsigned x3 = 0; x3 < 2; ++x3) {
      for (unsigned y1 = 0; y1 < 2; ++y1) {
        for (unsigned y3 = 0; y3 < 2; ++y3) {
          for (unsigned z1 = 0; z1 < 2; ++z1) {
            for (unsigned z2 = 0; z2 < 2; ++z2) {
              sums[(x2 + x3) + 3 * (y1 + y3) + 9 * (z1 + z2)] +=
                  of_edges(2 * y1 + 4 * z1, x2 + 4 * z2, x3 + 2 * y3);
            }
          }
        }
      }
    }
  }
  return sums;
}

template <class Number>
Bernstein<Number> times_eight(Bernstein<Number> sums) {
  for (unsigned at = 0; at < sums.size(); ++at) {
    for (const unsigned stride : kStride) {
      if (at / stride % 3 != 1) sums[at] *= 2;
    }
  }
  return sums;
}

/// Four times the coefficients on one half of the cube in one direction.
template <class Number>
Bernstein<Number> half_of(const Bernstein<Number>& whole, unsigned stride, bool upper) {
  Bernstein<Number> half{};
  for (unsigned at = 0; at < whole.size(); ++at) {
    if (at / stride % 3 != 0) continue;
    const Number& first = whole[upper ? at + 2 * stride : at];
    const Number& middle = whole[at + stride];
    const Number& last = whole[upper ? at : at + 2 * stride];
    half[upper ? at + 2 * stride : at] = 4 * first;
    half[at + stride] = 2 * (first + middle);
    half[upper ? at : at + 2 * stride] = first + 2 * middle + last;
  }
  return half;
}

template <class Number>
JacobianSign sign_of(const Bernstein<Number>& b) {
  if (std::any_of(kCorners.begin(), kCorners.end(), [&](std::size_t c) { return b[c] <= 0; })) {
    return JacobianSign::kNotPositive;
  }
  const bool positive = std::all_of(b.begin(), b.end(), [](const Number& v) { return v > 0; });
  return positive ? JacobianSign::kPositive : JacobianSign::kUnknown;
}

template <class Number>
JacobianSign sign_on_cube(const Bernstein<Number>& coefficients) {
  std::vector<Bernstein<Number>> level = {coefficients};
  std::size_t looked_at = 0;
  for (int depth = 0; depth <= kJacobianDepth; ++depth) {
    std::vector<Bernstein<Number>> open;
    for (const Bernstein<Number>& cube : level) {
      const JacobianSign sign = sign_of(cube);
      if (sign == JacobianSign::kNotPositive) return sign;
      if (sign == JacobianSign::kUnknown) open.push_back(cube);
    }
    if (open.empty()) return JacobianSign::kPositive;
    looked_at += level.size();
    if (depth == kJacobianDepth || looked_at + 8 * open.size() > kJacobianCubes) break;
    level.clear();
    for (const Bernstein<Number>& cube : open) {
      for (unsigned part = 0; part < 8; ++part) {
        Bernstein<Number> half = cube;
        for (unsigned axis = 0; axis < 3; ++axis) {
          half = half_of(half, kStride[axis], ((part >> axis) & 1U) != 0);
        }
        level.push_back(half);
      }
    }
  }
  return JacobianSign::kUnknown;
}

/// The sums of a hexahedron with these corners.
template <class Number>
Bernstein<Number> sums_of_corners(const std::array<Vector<Number>, 8>& p,
                                  std::array<Vector<Number>, 12>& edges) {
  // Edges in direction x at 0, in y at 4, in z at 8, by the number of their first corner.
  constexpr std::array<unsigned, 8> kPlaceX = {0, 0, 1, 0, 2, 0, 3, 0};
  constexpr std::array<unsigned, 8> kPlaceY = {4, 5, 0, 0, 6, 7, 0, 0};
  for (unsigned i = 0; i < 4; ++i) {
    edges[kPlaceX[2 * i]] = difference(p[2 * i + 1], p[2 * i]);
    const unsigned y = (i & 1U) + 4 * (i >> 1U);
    edges[kPlaceY[y]] = difference(p[y + 2], p[y]);
    edges[8 + i] = difference(p[i + 4], p[i]);
  }
  return sums_of<Number>([&](unsigned a, unsigned b, unsigned c) {
    return determinant<Number>(
        std::array<Vector<Number>, 3>{edges[kPlaceX[a]], edges[kPlaceY[b]], edges[8 + c]});
  });
}

/// Whether double precision shows all coefficients to be positive. A determinant is a sum of six
/// monomials with at most 8 factors 1 + d each (signs.cpp), a coefficient one of at most eight
/// determinants, which adds 7 factors: it errs by at most 48 * 15.01 u XYZ < 721 u XYZ, and the
/// threshold is 1024 u XYZ. Underflow and overflow are as there.
bool is_positive_in_double(const std::array<Point, 8>& points) {
  std::array<Vector<double>, 12> edges{};
  const Bernstein<double> sums = sums_of_corners<double>(points, edges);
  const Vector<double> bounds = bounds_of(edges);
  const double threshold = 0x1p-43 * (bounds[0] * bounds[1] * bounds[2]);
  return are_moderate(bounds) &&
         std::all_of(sums.begin(), sums.end(), [&](double sum) { return sum > threshold; });
}

}  // namespace

LatticePoint difference(const LatticePoint& a, const LatticePoint& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Wide determinant(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) noexcept {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return static_cast<Wide>(b[i]) * c[j] - static_cast<Wide>(b[j]) * c[i];
  };
  return a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1);
}

JacobianSign jacobian_sign(const std::vector<LatticePoint>& p) {
  return sign_on_cube(times_eight(sums_of<Wide>([&p](unsigned a, unsigned b, unsigned c) {
    return determinant(difference(p[a + 1], p[a]), difference(p[b + 2], p[b]),
                       difference(p[c + 4], p[c]));
  })));
}

JacobianSign jacobian_sign(const std::array<Point, 8>& points) {
  if (is_positive_in_double(points)) return JacobianSign::kPositive;
  std::array<const Point*, 8> addresses{};
  for (std::size_t i = 0; i < 8; ++i) addresses[i] = &points[i];
  std::array<Vector<mpz_class>, 12> edges;
  return sign_on_cube(times_eight(sums_of_corners<mpz_class>(as_integers(addresses), edges)));
}

}  // namespace hexatlas::check
