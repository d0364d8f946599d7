#pragma once
/// \file
/// A mesh with some points free to move, and sums over its samples. Private to realize/untangle.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "enum/parallel/parallel_for.hpp"
#include "realize/untangle/samples.hpp"

namespace hexatlas::untangle {

using Points = Eigen::Matrix3Xd;    ///< one column per point
using Variables = Eigen::VectorXd;  ///< x, y, z of each free point
using Cell = std::array<std::uint32_t, 8>;

/// The free points of some hexahedra, and the hexahedra that contain one. Points keep their
/// numbers.
class Problem {
 public:
  /// Requires indices below points.cols() and one entry of `is_free` per point.
  Problem(Points points, const std::vector<Cell>& cells, const std::vector<std::uint8_t>& is_free);

  [[nodiscard]] std::size_t cells() const { return cells_.size(); }
  [[nodiscard]] const std::vector<Cell>& all_cells() const { return cells_; }
  [[nodiscard]] const std::vector<std::uint32_t>& free_points() const { return free_; }
  [[nodiscard]] std::size_t variables() const { return 3 * free_.size(); }

  /// The points, the free ones at x.
  [[nodiscard]] Points points_at(const Variables& x) const;
  [[nodiscard]] Variables variables_of(const Points& points) const;

  /// Looks at a cell at all samples that move, from now on, not only at its corners.
  void look_closely(std::size_t c) { masks_[c] = kAllSamples & seen_[c]; }
  void look_at_corners(std::size_t c) { masks_[c] = kCornerSamples & seen_[c]; }
  [[nodiscard]] bool is_looked_at_closely(std::size_t c) const {
    return (masks_[c] & ~kCornerSamples) != 0;
  }

  /// sum f(J) over the samples looked at; f(J, D) returns a value and sets D to the derivative of
  /// it by J. If a value is not finite, so is the sum, and the gradient is worth nothing.
  /// Deterministic for any number of threads. Cost: linear; 24 numbers per cell for the time of it.
  template <class F>
  double sum(const Variables& x, const F& f, int threads, Variables& gradient) const {
    const Points points = points_at(x);
    const std::size_t chunks = (cells_.size() + kChunk - 1) / kChunk;
    std::vector<double> values(chunks);
    scratch_.resize(24 * cells_.size());
    parallel::parallel_for(chunks > 1 ? threads : 1, chunks, [&](std::size_t chunk) {
      const std::size_t end = std::min(cells_.size(), (chunk + 1) * kChunk);
      for (std::size_t c = chunk * kChunk; c < end; ++c) values[chunk] += at_cell(points, c, f);
    });
    double total = 0;
    for (const double value : values) total += value;
    gather(threads, gradient);
    return total;
  }

  /// f(J) at each sample looked at; `f` may be called by one thread only.
  template <class F>
  void for_each_sample(const Variables& x, const F& f) const {
    const Points points = points_at(x);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t i = 0; i < kSamples; ++i)
        if ((masks_[c] >> i & 1U) != 0) f(c, i, matrix_at(points, cells_[c], i));
  }

  [[nodiscard]] static Eigen::Matrix3d matrix_at(const Points& points, const Cell& cell,
                                                 std::size_t sample) {
    Eigen::Matrix<double, 3, 8> corners;
    for (int v = 0; v < 8; ++v) corners.col(v) = points.col(cell[static_cast<std::size_t>(v)]);
    return corners * shape_gradients()[sample].transpose();
  }

 private:
  static constexpr std::size_t kChunk = 512;

  template <class F>
  double at_cell(const Points& points, std::size_t c, const F& f) const;
  void gather(int threads, Variables& gradient) const;

  Points points_;
  std::vector<Cell> cells_;
  std::vector<SampleMask> masks_;     ///< of a cell: the samples looked at
  std::vector<SampleMask> seen_;      ///< of a cell: the samples that depend on a free point
  std::vector<std::uint32_t> free_;
  std::vector<std::size_t> first_;   ///< of a free point: its first place in places_
  std::vector<std::size_t> places_;  ///< 8 * cell + corner
  mutable std::vector<double> scratch_;
};

template <class F>
double Problem::at_cell(const Points& points, std::size_t c, const F& f) const {
  const Cell& cell = cells_[c];
  Eigen::Matrix<double, 3, 8> corners;
  for (int v = 0; v < 8; ++v) corners.col(v) = points.col(cell[static_cast<std::size_t>(v)]);
  Eigen::Map<Eigen::Matrix<double, 3, 8>> gradient(scratch_.data() + 24 * c);
  gradient.setZero();
  double total = 0;
  Eigen::Matrix3d j;
  Eigen::Matrix3d d;
  for (std::size_t v = 0; v < 8; ++v) {
    if ((masks_[c] >> sample_of_corner(v) & 1U) == 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t bit = std::size_t{1} << axis;
      j.col(axis) = corners.col(static_cast<Eigen::Index>(v | bit)) -
                    corners.col(static_cast<Eigen::Index>(v & ~bit));
    }
    total += f(j, d);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t bit = std::size_t{1} << axis;
      gradient.col(static_cast<Eigen::Index>(v | bit)) += d.col(axis);
      gradient.col(static_cast<Eigen::Index>(v & ~bit)) -= d.col(axis);
    }
  }
  for (std::size_t i = 0; (masks_[c] & ~kCornerSamples) >> i != 0; ++i) {
    if (((masks_[c] & ~kCornerSamples) >> i & 1U) == 0) continue;
    j.noalias() = corners * shape_gradients()[i].transpose();
    total += f(j, d);
    gradient.noalias() += d * shape_gradients()[i];
  }
  return total;
}

}  // namespace hexatlas::untangle
