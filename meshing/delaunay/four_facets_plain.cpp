#include "meshing/delaunay/digging_body.hpp"

namespace hexatlas::delaunay {

const FourFacets& four_facets_plain() noexcept {
  static constexpr FourFacets kFunctions{beyond,           conflict_quickly,   conflict_thoroughly,
                                         conflict_closely, dig<std::uint32_t>, dig<std::uint64_t>};
  return kFunctions;
}

const FourFacets& four_facets() noexcept {
#if defined(__x86_64__)
  const bool has_fma = __builtin_cpu_supports("fma") != 0;
  const FourFacets* fastest = four_facets_avx512();
  if (fastest != nullptr && has_fma && __builtin_cpu_supports("avx512vl") != 0 &&
      __builtin_cpu_supports("avx512dq") != 0)
    return *fastest;
  const FourFacets* fast = four_facets_avx2();
  if (fast != nullptr && has_fma && __builtin_cpu_supports("avx2") != 0) return *fast;
#endif
  return four_facets_plain();
}

}  // namespace hexatlas::delaunay
