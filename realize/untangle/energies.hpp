#pragma once
/// \file
/// Functions of the Jacobian matrix J at a sample, with derivatives. Private to realize/untangle.

#include <Eigen/Core>

namespace hexatlas::untangle {

/// The matrix of cofactors: the derivative of det J by J.
[[nodiscard]] Eigen::Matrix3d cofactors(const Eigen::Matrix3d& j);

/// det J over the product of the lengths of its columns; 0 if one of them is 0.
[[nodiscard]] double scaled_determinant(const Eigen::Matrix3d& j);

/// Definition. With chi(d) = (d + sqrt(epsilon^2 + d^2)) / 2, positive and close to d where d is
/// greater than epsilon, and d = det J,
///     f(J) = |J|^2 / chi(d)^(2/3) + lambda (1 + d^2) / chi(d):
/// shape and size, finite also for an inverted J. For epsilon -> 0 a barrier before d = 0.
/// Source. Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov, "Foldover-free maps in 50 lines
/// of code", ACM Transactions on Graphics 40 (2021).
struct Foldover {
  double epsilon = 1;
  double lambda = 1;
  double operator()(const Eigen::Matrix3d& j, Eigen::Matrix3d& derivative) const;
};

/// Definition. (m / s)^p + w f(J) / (3 + 2 lambda), for the scaled determinant s of J and Foldover
/// f with epsilon 0; infinite unless s > 0. For great p the sum over samples is governed by the
/// least s, and m is its value at the start. As s depends on the directions of the columns only,
/// edges would shrink to nothing without f.
struct ScaledPower {
  double reference = 1;  ///< m > 0
  double power = 2;
  double weight = 1e-3;
  double operator()(const Eigen::Matrix3d& j, Eigen::Matrix3d& derivative) const;
};

/// Definition. exp(p (m - s)) + w f(J) / (3 + 2 lambda), as above but finite for any s, with the
/// epsilon of `size` positive: raises the least s where it is negative.
struct ScaledExponential {
  double reference = 0;  ///< m
  double rate = 4;
  double weight = 1e-3;
  Foldover size;
  double operator()(const Eigen::Matrix3d& j, Eigen::Matrix3d& derivative) const;
};

}  // namespace hexatlas::untangle
