#pragma once
/// \file
/// Coordinates in which points are about as far apart in all directions.
///
/// Definition. With B the diagonal matrix of the extents of the points, and C = L L^T their
/// covariance after a division by these, x goes to (B L)^-1 (x - m), where m is the mean. So the
/// points have covariance 1 there. The map is affine and keeps orientations: a hexahedron is valid
/// in one frame if it is in the other, up to rounding.
///
/// In double precision, for points of which rounding is no matter.

#include <array>
#include <optional>
#include <span>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hexahedrize {

class RoundFrame {
 public:
  /// nullopt if the points are in a plane or nearly so, or too far apart for doubles.
  [[nodiscard]] static std::optional<RoundFrame> of(std::span<const mesh::Point> points);

  [[nodiscard]] mesh::Point into(const mesh::Point& p) const;
  [[nodiscard]] mesh::Point back(const mesh::Point& p) const;

  /// 1 if the map keeps shapes; about s^2 / 5 if one direction is s times as long as the others.
  [[nodiscard]] double skewness() const;

 private:
  using Row = std::array<double, 3>;
  Row mean_{};
  std::array<Row, 3> lower_{};  ///< B L
};

}  // namespace hexatlas::hexahedrize
