#include "realize/untangle/energies.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace hexatlas::untangle {
namespace {

/// The scaled determinant and what its derivative needs. Not a number if a column is zero.
struct Scaled {
  explicit Scaled(const Eigen::Matrix3d& j)
      : by_det(cofactors(j)),
        squares(j.colwise().squaredNorm()),
        lengths(std::sqrt(squares(0)) * std::sqrt(squares(1)) * std::sqrt(squares(2))),
        value(j.col(0).dot(by_det.col(0)) / lengths) {}
  [[nodiscard]] Eigen::Matrix3d derivative(const Eigen::Matrix3d& j) const {
    return by_det / lengths - value * (j.array().rowwise() / squares.array()).matrix();
  }
  Eigen::Matrix3d by_det;
  Eigen::RowVector3d squares;
  double lengths;
  double value;
};

}  // namespace

Eigen::Matrix3d cofactors(const Eigen::Matrix3d& j) {
  Eigen::Matrix3d result;
  result.col(0) = j.col(1).cross(j.col(2));
  result.col(1) = j.col(2).cross(j.col(0));
  result.col(2) = j.col(0).cross(j.col(1));
  return result;
}

double scaled_determinant(const Eigen::Matrix3d& j) {
  const double lengths = j.col(0).norm() * j.col(1).norm() * j.col(2).norm();
  return lengths > 0 ? j.col(0).dot(j.col(1).cross(j.col(2))) / lengths : 0;
}

double Foldover::operator()(const Eigen::Matrix3d& j, Eigen::Matrix3d& derivative) const {
  const Eigen::Matrix3d by_det = cofactors(j);
  const double det = j.col(0).dot(by_det.col(0));
  const double root = std::sqrt(epsilon * epsilon + det * det);
  // For det < 0 the sum would cancel: chi = epsilon^2 / (2 (root - det)).
  const double chi = det < 0 ? 0.5 * epsilon * epsilon / (root - det) : 0.5 * (det + root);
  const double chi_by_det = chi / root;
  const double trace = j.squaredNorm();
  const double power = std::pow(chi, -2.0 / 3);
  const double size = (1 + det * det) / chi;
  const double by_scalar = -2.0 / 3 * trace * power / chi * chi_by_det +
                           lambda * (2 * det / chi - size / chi * chi_by_det);
  derivative = 2 * power * j + by_scalar * by_det;
  return trace * power + lambda * size;
}

double ScaledPower::operator()(const Eigen::Matrix3d& j, Eigen::Matrix3d& derivative) const {
  const Scaled s(j);
  if (!(s.value > 0)) return std::numeric_limits<double>::infinity();
  const Foldover size{0, 1};
  const double share = weight / (3 + 2 * size.lambda);
  const double of_size = share * size(j, derivative);
  const double term = std::pow(reference / s.value, power);
  derivative = share * derivative - (power * term / s.value) * s.derivative(j);
  return term + of_size;
}

double ScaledExponential::operator()(const Eigen::Matrix3d& j, Eigen::Matrix3d& derivative) const {
  const Scaled s(j);
  const double share = weight / (3 + 2 * size.lambda);
  const double of_size = share * size(j, derivative);
  const double term = std::exp(rate * (reference - s.value));
  derivative = share * derivative - (rate * term) * s.derivative(j);
  return term + of_size;
}

}  // namespace hexatlas::untangle
