#include "realize/untangle/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexatlas::untangle {
namespace {

constexpr double kGreatest = std::numeric_limits<double>::max();

Eigen::Vector3d scaled(const exact::Point3& p, int exponent) {
  return {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
}

}  // namespace

Frame::Frame(const std::vector<exact::Point3>& points, const std::vector<std::uint32_t>& listed) {
  double greatest = 0;
  for (const std::uint32_t v : listed)
    greatest =
        std::max({greatest, std::abs(points[v].x), std::abs(points[v].y), std::abs(points[v].z)});
  if (!(greatest > 0)) return;
  std::frexp(greatest, &exponent_);
  const double weight = 1 / static_cast<double>(listed.size());
  for (const std::uint32_t v : listed) centre_ += weight * scaled(points[v], exponent_);
  double size = 0;
  for (const std::uint32_t v : listed)
    size = std::max(size, (scaled(points[v], exponent_) - centre_).lpNorm<Eigen::Infinity>());
  if (size > 0) unit_ = size;
}

Eigen::Vector3d Frame::inside(const exact::Point3& p) const {
  return (scaled(p, exponent_) - centre_) / unit_;
}

exact::Point3 Frame::outside(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d p = centre_ + unit_ * x;
  const auto far = [this](double c) {
    return std::clamp(std::ldexp(c, exponent_), -kGreatest, kGreatest);
  };
  return {far(p(0)), far(p(1)), far(p(2))};
}

}  // namespace hexatlas::untangle
