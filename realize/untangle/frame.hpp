#pragma once
/// \file
/// Coordinates of about unit size for any mesh. Private to realize/untangle.

#include <Eigen/Core>
#include <vector>

#include "realize/exact/sign.hpp"
#include "realize/untangle/problem.hpp"

namespace hexatlas::untangle {

/// x -> (2^-exponent x - centre) / unit and its inverse.
class Frame {
 public:
  /// So that the points listed have their centre at the origin and the greatest distance 1 from it,
  /// in the maximum norm. The frame is the identity up to translation if there is no distance.
  Frame(const std::vector<exact::Point3>& points, const std::vector<std::uint32_t>& listed);

  [[nodiscard]] Eigen::Vector3d inside(const exact::Point3& p) const;
  [[nodiscard]] exact::Point3 outside(const Eigen::Vector3d& x) const;

 private:
  int exponent_ = 0;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double unit_ = 1;
};

}  // namespace hexatlas::untangle
