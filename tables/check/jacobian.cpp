#include "tables/check/jacobian.hpp"

#include <algorithm>

namespace hexatlas::check {

namespace {

/// Coefficient (i, j, k) at i + 3j + 9k, times a common positive factor.
using Bernstein = std::array<Wide, 27>;

constexpr std::array<unsigned, 3> kStride = {1, 3, 9};
constexpr std::array<std::size_t, 8> kCorners = {0, 2, 6, 8, 18, 20, 24, 26};

/// Eight times the Bernstein coefficients. The derivative in one direction has degree 1 in the two
/// others, with differences of points as coefficients. The product of two polynomials of degree 1
/// with coefficients f, g has the coefficients f0 g0, (f0 g1 + f1 g0) / 2, f1 g1.
Bernstein coefficients_of(const std::vector<LatticePoint>& p) {
  Bernstein sums{};
  for (unsigned x2 = 0; x2 < 2; ++x2) {
    for (unsigned x3 = 0; x3 < 2; ++x3) {
      for (unsigned y1 = 0; y1 < 2; ++y1) {
        for (unsigned y3 = 0; y3 < 2; ++y3) {
          for (unsigned z1 = 0; z1 < 2; ++z1) {
            for (unsigned z2 = 0; z2 < 2; ++z2) {
              const unsigned a = 2 * y1 + 4 * z1;
              const unsigned b = x2 + 4 * z2;
              const unsigned c = x3 + 2 * y3;
              sums[(x2 + x3) + 3 * (y1 + y3) + 9 * (z1 + z2)] +=
                  determinant(difference(p[a + 1], p[a]), difference(p[b + 2], p[b]),
                              difference(p[c + 4], p[c]));
            }
          }
        }
      }
    }
  }
  for (unsigned at = 0; at < sums.size(); ++at) {
    for (const unsigned stride : kStride) {
      if (at / stride % 3 != 1) sums[at] *= 2;
    }
  }
  return sums;
}

/// Four times the coefficients on one half of the cube in one direction.
Bernstein half_of(const Bernstein& whole, unsigned stride, bool upper) {
  Bernstein half{};
  for (unsigned at = 0; at < whole.size(); ++at) {
    if (at / stride % 3 != 0) continue;
    const Wide first = whole[upper ? at + 2 * stride : at];
    const Wide middle = whole[at + stride];
    const Wide last = whole[upper ? at : at + 2 * stride];
    half[upper ? at + 2 * stride : at] = 4 * first;
    half[at + stride] = 2 * (first + middle);
    half[upper ? at : at + 2 * stride] = first + 2 * middle + last;
  }
  return half;
}

JacobianSign sign_of(const Bernstein& b) {
  if (std::any_of(kCorners.begin(), kCorners.end(), [&](std::size_t c) { return b[c] <= 0; })) {
    return JacobianSign::kNotPositive;
  }
  const bool positive = std::all_of(b.begin(), b.end(), [](Wide value) { return value > 0; });
  return positive ? JacobianSign::kPositive : JacobianSign::kUnknown;
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

JacobianSign jacobian_sign(const std::vector<LatticePoint>& points) {
  std::vector<Bernstein> level = {coefficients_of(points)};
  std::size_t looked_at = 0;
  for (int depth = 0; depth <= kJacobianDepth; ++depth) {
    std::vector<Bernstein> open;
    for (const Bernstein& cube : level) {
      const JacobianSign sign = sign_of(cube);
      if (sign == JacobianSign::kNotPositive) return sign;
      if (sign == JacobianSign::kUnknown) open.push_back(cube);
    }
    if (open.empty()) return JacobianSign::kPositive;
    looked_at += level.size();
    if (depth == kJacobianDepth || looked_at + 8 * open.size() > kJacobianCubes) break;
    level.clear();
    for (const Bernstein& cube : open) {
      for (unsigned part = 0; part < 8; ++part) {
        Bernstein half = cube;
        for (unsigned axis = 0; axis < 3; ++axis) {
          half = half_of(half, kStride[axis], ((part >> axis) & 1U) != 0);
        }
        level.push_back(half);
      }
    }
  }
  return JacobianSign::kUnknown;
}

}  // namespace hexatlas::check
