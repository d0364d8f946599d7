#include "meshing/hexahedrize/round_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hexatlas::hexahedrize {
namespace {

using Row = std::array<double, 3>;

Row row_of(const mesh::Point& p) { return {p.x, p.y, p.z}; }

/// The lower triangle whose product with its transpose is this matrix; nullopt if there is none.
std::optional<std::array<Row, 3>> cholesky(const std::array<Row, 3>& matrix) {
  constexpr double kLeast = 1e-14;  // of a variance where extents are 1: what rounding leaves
  std::array<Row, 3> lower{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      if (i == j && !(sum > kLeast)) return std::nullopt;
      lower[i][j] = i == j ? std::sqrt(sum) : sum / lower[j][j];
    }
  return lower;
}

}  // namespace

std::optional<RoundFrame> RoundFrame::of(std::span<const mesh::Point> points) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Row least{kInfinity, kInfinity, kInfinity}, most{-kInfinity, -kInfinity, -kInfinity};
  for (const mesh::Point& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], row_of(p)[i]);
      most[i] = std::max(most[i], row_of(p)[i]);
    }
  Row extent{};
  for (std::size_t i = 0; i < 3; ++i) {
    extent[i] = most[i] - least[i];
    if (!(extent[i] >= std::numeric_limits<double>::min()) || !std::isfinite(extent[i]))
      return std::nullopt;
  }
  const auto count = static_cast<double>(points.size());
  Row mean{};  // from the least corner, in extents
  std::array<Row, 3> products{};
  for (const mesh::Point& p : points) {
    Row at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = (row_of(p)[i] - least[i]) / extent[i];
    for (std::size_t i = 0; i < 3; ++i) {
      mean[i] += at[i] / count;
      for (std::size_t j = 0; j < 3; ++j) products[i][j] += at[i] * at[j] / count;
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) products[i][j] -= mean[i] * mean[j];
  const auto lower = cholesky(products);
  if (!lower) return std::nullopt;
  RoundFrame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    frame.mean_[i] = least[i] + mean[i] * extent[i];
    for (std::size_t j = 0; j < 3; ++j) frame.lower_[i][j] = extent[i] * (*lower)[i][j];
  }
  return frame;
}

mesh::Point RoundFrame::into(const mesh::Point& p) const {
  Row at = row_of(p);
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] -= mean_[i];
    for (std::size_t j = 0; j < i; ++j) at[i] -= lower_[i][j] * at[j];
    at[i] /= lower_[i][i];
  }
  return {at[0], at[1], at[2]};
}

mesh::Point RoundFrame::back(const mesh::Point& p) const {
  const Row at = row_of(p);
  Row result = mean_;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j) result[i] += lower_[i][j] * at[j];
  return {result[0], result[1], result[2]};
}

double RoundFrame::skewness() const {
  // The mean of the squares of the stretches, and their geometric mean, both to the power 3/2.
  double largest = 0;
  for (const Row& row : lower_)
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  double squares = 0;
  double determinant = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      squares += (lower_[i][j] / largest) * (lower_[i][j] / largest);
    determinant *= lower_[i][i] / largest;
  }
  return std::pow(squares / 3, 1.5) / determinant;
}

}  // namespace hexatlas::hexahedrize
