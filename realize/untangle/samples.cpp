#include "realize/untangle/samples.hpp"

namespace hexatlas::untangle {
namespace {

/// The factor of phi_v along an axis, at half the position, and its derivative.
double factor(bool is_upper, std::size_t position) {
  const double at = 0.5 * static_cast<double>(position);
  return is_upper ? at : 1 - at;
}

Gradients gradients_at(std::array<std::size_t, 3> position) {
  Gradients result;
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double derivative = (v >> axis & 1U) != 0 ? 1 : -1;
      for (std::size_t other = 0; other < 3; ++other)
        if (other != axis) derivative *= factor((v >> other & 1U) != 0, position[other]);
      result(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(v)) = derivative;
    }
  return result;
}

}  // namespace

const std::array<Gradients, kSamples>& shape_gradients() {
  static const std::array<Gradients, kSamples> table = [] {
    std::array<Gradients, kSamples> result;
    for (std::size_t i = 0; i < kSamples; ++i) result[i] = gradients_at({i % 3, i / 3 % 3, i / 9});
    return result;
  }();
  return table;
}

SampleMask samples_that_see(std::uint8_t corners) {
  SampleMask mask = 0;
  for (std::size_t i = 0; i < kSamples; ++i)
    for (std::size_t v = 0; v < 8; ++v)
      if ((corners >> v & 1U) != 0 &&
          !shape_gradients()[i].col(static_cast<Eigen::Index>(v)).isZero())
        mask |= SampleMask{1} << i;
  return mask;
}

}  // namespace hexatlas::untangle
