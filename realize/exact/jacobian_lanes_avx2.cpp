#include "realize/exact/jacobian_lanes.hpp"

#if defined(__AVX2__)
#include "realize/exact/jacobian_lanes_body.hpp"
#endif

namespace hexatlas::exact {

FourJacobians four_jacobians_avx2() noexcept {
#if defined(__AVX2__)
  return judge;
#else
  return nullptr;
#endif
}

}  // namespace hexatlas::exact
