#include "meshing/delaunay/four_facets.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include "meshing/delaunay/digging_body.hpp"
#endif

namespace hexatlas::delaunay {

const FourFacets* four_facets_avx2() noexcept {
#if defined(__AVX2__) && defined(__FMA__)
  static constexpr FourFacets kFunctions{beyond,           conflict_quickly,   conflict_thoroughly,
                                         conflict_closely, dig<std::uint32_t>, dig<std::uint64_t>};
  return &kFunctions;
#else
  return nullptr;
#endif
}

}  // namespace hexatlas::delaunay
