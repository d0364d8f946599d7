#include "realize/exact/jacobian_lanes_body.hpp"

namespace hexatlas::exact {

FourJacobians four_jacobians_plain() noexcept { return judge; }

FourJacobians four_jacobians() noexcept {
#if defined(__x86_64__)
  const FourJacobians fast = four_jacobians_avx2();
  if (fast != nullptr && __builtin_cpu_supports("avx2") != 0) return fast;
#endif
  return four_jacobians_plain();
}

}  // namespace hexatlas::exact
