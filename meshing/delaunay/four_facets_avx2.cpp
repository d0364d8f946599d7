#include "meshing/delaunay/four_facets.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include "meshing/delaunay/four_facets_body.hpp"
#endif

namespace hexatlas::delaunay {

const FourFacets* four_facets_avx2() noexcept {
#if defined(__AVX2__) && defined(__FMA__)
  static constexpr FourFacets kFunctions{beyond, conflict_quickly, conflict_closely};
  return &kFunctions;
#else
  return nullptr;
#endif
}

}  // namespace hexatlas::delaunay
