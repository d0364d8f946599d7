#pragma once
/// \file
/// Private to meshing/delaunay: the signs that an insertion needs, four at once, in double
/// precision with a proven bound.
///
/// Definition. Facet j of a tetrahedron with vertices c[0..3] consists of c[j], c[j+1], c[j+2], the
/// indices modulo 4, and is opposite to c[j+3]. The tetrahedron is right-handed:
/// det(c[1] - c[0], c[2] - c[0], c[3] - c[0]) > 0.
///
/// Claims, for coordinates relative to p, with u = 2^-53 and D an upper bound on the computed
/// squared lengths of the points that take part.
/// (1) The computed 3 x 3 determinant errs by less than 2^-47 D^(3/2) + 2^-500.
/// (2) The computed 4 x 4 determinant with the squared lengths as last column errs by less than
///     2^-44 D^(5/2) + 2^-480.
/// A sign is taken for proven if the square of the value exceeds that of twice the first summand
/// plus 2^-900: either the second summand is below the first, or both are below 2^-479.
/// Proof. A computed difference of coordinates is the true one times 1 + d, |d| <= u, without
/// underflow, since a subnormal difference is exact. A squared length has in addition an error of
/// 3.01 u relative to itself, all its terms being of one sign; with the squared factors from the
/// differences, 5.02 u. The coordinates are at most (1 + 3u) D^(1/2).
/// (1) 6 products of three coordinates: 3.01 u from the differences, at most 3.01 u from the two
///     multiplications and the subtraction of each term, the subtraction acting on twice the
///     product, 2.01 u more, and two additions of sums of up to 6 products: below
///     6 (3.01 + 3.01 + 2.01 + 2.01) u D^(3/2) < 61 u D^(3/2) < 2^-47 D^(3/2).
/// (2) 24 products of three coordinates and one squared length. Differences and squared length
///     contribute 3.01 u + 5.02 u. A minor of two rows is a difference of two products: 3.02 u
///     relative to the sum of their absolute values. The product of two minors: 1.01 u more than
///     the sum of both, 7.1 u. The sum of six of them: at most 5.01 u relative to the sum of the
///     absolute values. In all below 24 (8.03 + 7.1 + 5.01) u < 484 u < 2^-44.
/// A fused multiplication and addition leaves out a rounding and makes no error larger. A product
/// that underflows errs by at most 2^-1075 more, and each of the at most 40 products that go into a
/// determinant is multiplied by at most three further factors, of at most max(1, 2 D) in all
/// but one, whose other is at most 2 D^(1/2): at most 2^-1066 max(1, D^(5/2)) together, which is
/// below 2^-480 or below the unused part of the first summand. Overflow makes an infinity or a NaN;
/// no comparison with it decides.

#include <array>
#include <cstdint>

#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// One bit for each facet: lane j is bit j.
struct FacetSigns {
  unsigned positive = 0;   ///< the sign is positive, proven
  unsigned undecided = 0;  ///< neither sign is proven; so for each facet with a point that is NaN
};

using FourSites = std::array<const Site*, 4>;

struct FourFacets {
  /// Positive: p lies strictly beyond facet j.
  FacetSigns (*beyond)(const FourSites& corners, const Site& p);
  /// apexes[j] is the vertex opposite to facet j of the tetrahedron on its other side. Positive:
  /// p lies strictly inside the sphere through that tetrahedron.
  FacetSigns (*conflict)(const FourSites& corners, const FourSites& apexes, const Site& p);
};

/// The fastest that this processor can.
[[nodiscard]] const FourFacets& four_facets() noexcept;

/// Built for a processor with AVX2 and FMA, or nullptr where the compiler has none.
[[nodiscard]] const FourFacets* four_facets_avx2() noexcept;
[[nodiscard]] const FourFacets& four_facets_plain() noexcept;

}  // namespace hexatlas::delaunay
