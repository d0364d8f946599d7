#pragma once
/// \file
/// Where the Jacobian matrix of a trilinear hexahedron is looked at. Private to realize/untangle.
///
/// Definition. Sample r + 3s + 9t, with r, s, t in {0, 1, 2}, is the point (r, s, t) / 2 of the
/// unit cube. The derivative of the trilinear map there is J = sum p_v (grad phi_v)^T over the
/// corners p_v, with the shape functions phi_v; column k is the derivative along axis k. At a
/// corner it consists of the three edge vectors there, each in the direction of its axis.
///
/// The determinant has degree 2 in each coordinate, so that its 27 values at the samples determine
/// it (realize/exact/jacobian.hpp). That all are positive is necessary for a valid hexahedron, and
/// in practice nearly sufficient. Proposes, decides nothing.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hexatlas::untangle {

inline constexpr std::size_t kSamples = 27;

using SampleMask = std::uint32_t;  ///< bit i: sample i

/// grad phi_v at a sample, corner v in column v.
using Gradients = Eigen::Matrix<double, 3, 8>;
[[nodiscard]] const std::array<Gradients, kSamples>& shape_gradients();

/// The sample at corner v = x + 2y + 4z.
[[nodiscard]] constexpr std::size_t sample_of_corner(std::size_t v) noexcept {
  return 2 * (v & 1U) + 6 * (v >> 1U & 1U) + 18 * (v >> 2U & 1U);
}

[[nodiscard]] constexpr SampleMask corner_samples() noexcept {
  SampleMask mask = 0;
  for (std::size_t v = 0; v < 8; ++v) mask |= SampleMask{1} << sample_of_corner(v);
  return mask;
}

inline constexpr SampleMask kCornerSamples = corner_samples();
inline constexpr SampleMask kAllSamples = (SampleMask{1} << kSamples) - 1;

/// The samples whose matrix depends on one of the corners in `corners`, a set of bits.
[[nodiscard]] SampleMask samples_that_see(std::uint8_t corners);

}  // namespace hexatlas::untangle
