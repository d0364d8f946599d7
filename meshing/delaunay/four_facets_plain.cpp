#include "meshing/delaunay/four_facets_body.hpp"

namespace hexatlas::delaunay {

const FourFacets& four_facets_plain() noexcept {
  static constexpr FourFacets kFunctions{beyond, conflict_quickly, conflict_closely};
  return kFunctions;
}

const FourFacets& four_facets() noexcept {
#if defined(__x86_64__)
  const FourFacets* fast = four_facets_avx2();
  if (fast != nullptr && __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0)
    return *fast;
#endif
  return four_facets_plain();
}

}  // namespace hexatlas::delaunay
