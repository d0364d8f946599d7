#pragma once
/// \file
/// Private to meshing/delaunay: the signs that an insertion needs, four at once, in double
/// precision with a proven bound.
///
/// Definition. Facet j of a tetrahedron with vertices c[0..3] consists of c[j], c[j+1], c[j+2], the
/// indices modulo 4, and is opposite to c[j+3]. The tetrahedron is right-handed:
/// det(c[1] - c[0], c[2] - c[0], c[3] - c[0]) > 0.
///
/// Claims, for coordinates relative to p, with u = 2^-53, the computed squared lengths w of the
/// points that take part, and D the greatest of them.
/// (1) The computed 3 x 3 determinant errs by less than 2^-47 D^(3/2) + 2^-500. A sign is taken for
///     proven if the square of the value exceeds that of twice the first summand plus 2^-900:
///     either the second summand is below the first, or both are below 2^-479.
/// (2) Let B = w_a w_b w_c w_d D. If D < 2^100, a value of the 4 x 4 determinant with the squared
///     lengths as last column has the right sign if its square exceeds 2^-86 B + 2^-650.
/// (3) So it has if the square exceeds 2^-96 S^2 + 2^-650, where S is the computed sum of the
///     absolute values of its 24 products.
/// (4) Let all coordinates be multiples of g, a power of two from 2^-180 to 2^180. If D < 2^19 g^2
///     the 4 x 4 determinant and all that decides ties is exact.
/// (5) Let X, Y and Z be the greatest absolute values of the computed coordinates. If D < 2^100 the
///     sign of that determinant is right if its square exceeds 2^-86 (X Y Z D)^2 + 2^-650. For
///     tetrahedra that are flat and parallel to a plane of coordinates this is less than (2).
/// Proof. A computed difference of coordinates is the true one times 1 + d, |d| <= u, without
/// underflow, since a subnormal difference is exact. A squared length has in addition an error of
/// 3.01 u relative to itself, all its terms being of one sign; with the squared factors from the
/// differences, 5.02 u. The coordinates are at most (1 + 3u) w^(1/2), if w did not underflow.
/// (1) 6 products of three coordinates: 3.01 u from the differences, at most 3.01 u from the two
///     multiplications and the subtraction of each term, the subtraction acting on twice the
///     product, 2.01 u more, and two additions of sums of up to 6 products: below
///     6 (3.01 + 3.01 + 2.01 + 2.01) u D^(3/2) < 61 u D^(3/2) < 2^-47 D^(3/2).
/// (3) 24 products of three coordinates and one squared length. Differences and squared length
///     contribute 3.01 u + 5.02 u. A minor of two rows is a difference of two products: 3.02 u
///     relative to the sum of their absolute values. The product of two minors: 1.01 u more than
///     the sum of both, 7.1 u. The sum of six of them: at most 5.01 u relative to the sum of the
///     absolute values. In all 20.2 u relative to the latter, and so to S. Without underflow; with
///     that, (A + E)^2 <= 2 A^2 + 2 E^2 for the errors A and E < 2^-800 (below).
/// (2) A product is w_i times coordinates of the three others, at most (B)^(1/2) but for
///     roundings: in all below 24 * 20.2 u B^(1/2) < 485 u B^(1/2) < 2^-44.07 B^(1/2). Of that the
///     bound is twice 2^-44 B^(1/2), which leaves as much for E. If a w is below 2^-1060, then the
///     coordinates of that point are below 2^-529, those of others below 2^50.1, and the value is
///     below 24 * 2^-529 2^201 < 2^-323, so no sign is proven. Else a w errs by 2^-13 of
///     itself at most, by underflow.
/// (4) A difference that is not exact is at least 2^53 g, so that D is too great. Coordinates are
///     integers times g below 2^9.5, minors below 2^20 and 2^29.5, products of two 2^49.5, and the
///     sum of six of them below 2^52.1. Factors of heights are below 2^34. In x 2^22 + y 2^11 + z
///     the lesser summands differ by less than a unit of the greater ones.
/// (5) None of the 24 products of (3) exceeds X Y Z D, so the error is below 485 u X Y Z D as in
///     (2). If X, Y or Z is below 2^-531, the value is below 25 * 2^-531 2^50.1 2^50.1 2^100 <
///     2^-326, which proves no sign. Else its square errs by 2^-12 of itself at most, by underflow.
///     If D^2 or a product of squares underflows, (X Y Z D)^2 is below 2^-1020 2^300, and the
///     value's square below 2^-650.
/// A fused multiplication and addition leaves out a rounding and makes no error larger. A product
/// that underflows errs by at most 2^-1075 more, and each of the at most 40 products that go into a
/// determinant is multiplied by at most three further factors, of at most max(1, 2 D) in all
/// but one, whose other is at most 2 D^(1/2): at most 2^-1066 max(1, D^(5/2)) together: E. In (1)
/// it is below 2^-500 or below the unused part of the first summand. Overflow makes an infinity or
/// a NaN; no comparison with it decides.
///
/// The ghost vertex, at infinity, is a site that is not a number. In the 4 x 4 determinant its row
/// is (0, 0, 0, D): as the tie rule wants it, the place does not count beside the height. Any
/// greater height will do as well, if it counts in D.

#include <cstdint>

#include "meshing/delaunay/digging.hpp"
#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// One bit for each facet: lane j is bit j.
struct FacetSigns {
  unsigned positive = 0;   ///< the sign is positive, proven
  unsigned undecided = 0;  ///< neither sign is proven
};

struct FourFacets {
  /// Positive: p lies strictly beyond facet j.
  FacetSigns (*beyond)(const FourSites& corners, const Site& p);
  /// apexes[j] is the vertex opposite to facet j of the tetrahedron on its other side. Positive: p
  /// lies inside the sphere through that tetrahedron, ties decided as by
  /// exact::sign_of_perturbed_in_sphere(), or strictly beyond that facet of the hull.
  ///
  /// As dig() decides, by the same parts, with its plain filter; for tests.
  ///
  /// wanted: a bit for each facet that matters. short_below: 2^19 g^2, for which all coordinates
  /// are multiples of g as in (4), or a negative number. Ties are decided only if the squared
  /// distances from p are below; ties of facets of the hull never.
  [[nodiscard]] FacetSigns conflict(const FourSites& corners, const FourSites& apexes,
                                    const Site& p, unsigned wanted, double short_below) const {
    const FacetSigns signs = conflict_quickly(corners, apexes, p);
    if ((signs.undecided & wanted) == 0) return signs;
    const FacetSigns close = conflict_closely(corners, apexes, p, short_below);
    return {signs.positive | close.positive, signs.undecided & close.undecided};
  }

  /// By (2) alone; points in general position hardly ever need more.
  FacetSigns (*conflict_quickly)(const FourSites& corners, const FourSites& apexes, const Site& p);
  /// By (5) alone, with the ghost vertex.
  FacetSigns (*conflict_thoroughly)(const FourSites& corners, const FourSites& apexes,
                                    const Site& p);
  /// By (3) and (4), with the ghost vertex.
  FacetSigns (*conflict_closely)(const FourSites& corners, const FourSites& apexes, const Site& p,
                                 double short_below);

  /// Finds the cavity from its first cell, which is marked, and marks its cells, in the same order
  /// for all processors; false if it leaves the region. Decides as conflict() does.
  bool (*dig_short)(Digging<std::uint32_t>& cavity);
  bool (*dig_long)(Digging<std::uint64_t>& cavity);
  [[nodiscard]] bool dig(Digging<std::uint32_t>& cavity) const { return dig_short(cavity); }
  [[nodiscard]] bool dig(Digging<std::uint64_t>& cavity) const { return dig_long(cavity); }
};

/// The fastest that this processor can.
[[nodiscard]] const FourFacets& four_facets() noexcept;

/// Built for a processor with AVX2 and FMA, or nullptr where the compiler has none.
[[nodiscard]] const FourFacets* four_facets_avx2() noexcept;
/// The same for AVX-512 VL and DQ, and FMA.
[[nodiscard]] const FourFacets* four_facets_avx512() noexcept;
[[nodiscard]] const FourFacets& four_facets_plain() noexcept;

}  // namespace hexatlas::delaunay
