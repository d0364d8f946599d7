#include "realize/solve/final_polynomial_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexatlas::solve {
namespace {

// Vectors have length 2, so these are absolute bounds.
constexpr double kNoWeight = 1e-9;
constexpr double kNoDistance = 1e-10;
constexpr std::size_t kStepsPerDimension = 100;

using Vector = std::vector<double>;

double product(const FourTermVector& vector, const Vector& x) {
  return x[vector.plus[0]] + x[vector.plus[1]] - x[vector.minus[0]] - x[vector.minus[1]];
}

void add_multiple(double factor, const FourTermVector& vector, Vector& x) {
  for (const std::size_t i : vector.plus) x[i] += factor;
  for (const std::size_t i : vector.minus) x[i] -= factor;
}

/// The solution of a x = right for a symmetric positive definite matrix, by Cholesky's method; `a`
/// is overwritten. Empty if it is not positive definite.
Vector solved(std::vector<Vector>& a, Vector right) {
  const std::size_t size = right.size();
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      if (i == j && !(sum > 0)) return {};
      a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
    }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= a[i][k] * right[k];
    right[i] /= a[i][i];
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t k = i + 1; k < size; ++k) right[i] -= a[k][i] * right[k];
    right[i] /= a[i][i];
  }
  return right;
}

/// The nearest point to the origin in the hull of the active vectors, and its weights.
class NearestPoint {
 public:
  NearestPoint(std::span<const FourTermVector> vectors, std::size_t dimension)
      : vectors_(vectors), point_(dimension) {}

  [[nodiscard]] const std::vector<std::size_t>& active() const noexcept { return active_; }
  [[nodiscard]] const Vector& point() const noexcept { return point_; }

  [[nodiscard]] double squared_distance() const {
    double sum = 0;
    for (const double x : point_) sum += x * x;
    return sum;
  }

  /// Adds a vector and moves to the nearest point. False if rounding stops it.
  [[nodiscard]] bool include(std::size_t index) {
    if (std::find(active_.begin(), active_.end(), index) != active_.end()) return false;
    active_.push_back(index);
    weight_.push_back(active_.size() == 1 ? 1 : 0);
    while (true) {
      const Vector target = weights_in_affine_hull();
      if (target.empty()) return false;
      if (std::all_of(target.begin(), target.end(), [](double w) { return w > kNoWeight; })) {
        weight_ = target;
        update_point();
        return true;
      }
      move_towards(target);
      if (active_.empty()) return false;
    }
  }

 private:
  /// Weights of the point nearest to the origin in the affine hull: (G + 1) w = 1 up to scale,
  /// where G has the inner products of the active vectors and 1 has ones only.
  [[nodiscard]] Vector weights_in_affine_hull() const {
    const std::size_t size = active_.size();
    std::vector<Vector> matrix(size, Vector(size));
    for (std::size_t i = 0; i < size; ++i) {
      Vector dense(point_.size());
      add_multiple(1, vectors_[active_[i]], dense);
      for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = 1 + product(vectors_[active_[j]], dense);
    }
    Vector weights = solved(matrix, Vector(size, 1));
    double sum = 0;
    for (const double weight : weights) sum += weight;
    for (double& weight : weights) weight /= sum;
    return weights;
  }

  /// Goes towards the target until a weight is 0, and drops the vectors without weight.
  void move_towards(const Vector& target) {
    double step = 1;
    for (std::size_t i = 0; i < target.size(); ++i)
      if (target[i] <= kNoWeight && weight_[i] > target[i])
        step = std::min(step, weight_[i] / (weight_[i] - target[i]));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < target.size(); ++i) {
      const double weight = (1 - step) * weight_[i] + step * target[i];
      if (weight <= kNoWeight) continue;
      active_[kept] = active_[i];
      weight_[kept++] = weight;
    }
    active_.resize(kept);
    weight_.resize(kept);
  }

  void update_point() {
    std::fill(point_.begin(), point_.end(), 0);
    for (std::size_t i = 0; i < active_.size(); ++i)
      add_multiple(weight_[i], vectors_[active_[i]], point_);
  }

  std::span<const FourTermVector> vectors_;
  std::vector<std::size_t> active_;
  Vector weight_;  ///< of the active vectors
  Vector point_;
};

}  // namespace

std::optional<std::vector<std::size_t>> propose_zero_combination(
    std::span<const FourTermVector> vectors, std::size_t dimension) {
  if (vectors.empty()) return std::nullopt;
  NearestPoint nearest(vectors, dimension);
  if (!nearest.include(0)) return std::nullopt;
  for (std::size_t step = 0; step < kStepsPerDimension * dimension; ++step) {
    if (nearest.squared_distance() < kNoDistance) {
      std::vector<std::size_t> active = nearest.active();
      std::sort(active.begin(), active.end());
      return active;
    }
    double least = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      const double value = product(vectors[i], nearest.point());
      if (value < least) {
        least = value;
        next = i;
      }
    }
    if (least > 0 || !nearest.include(next)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace hexatlas::solve
