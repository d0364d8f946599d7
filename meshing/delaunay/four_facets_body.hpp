// Private to meshing/delaunay: what four_facets_plain.cpp and its like compile, each for its
// processor, in an unnamed namespace. No function from elsewhere that is not inlined when
// optimized: its code, made for one processor, could be linked into what runs on the other.

#include "meshing/delaunay/four_facets.hpp"

namespace hexatlas::delaunay {
namespace {
// NOLINTBEGIN(misc-definitions-in-headers): each includer is meant to have its own

using Lanes [[gnu::vector_size(32)]] = double;
using LaneBits [[gnu::vector_size(32)]] = long long;

// Squares of bounds in four_facets.hpp.
constexpr double kOrientationBound = 0x1p-92;
constexpr double kOrientationUnderflow = 0x1p-900;
constexpr double kSphereBound = 0x1p-86;
constexpr double kCloseBound = 0x1p-96;
constexpr double kSphereUnderflow = 0x1p-650;
constexpr double kGreatestSquare = 0x1p100;
constexpr LaneBits kOddLanes = {0, 1LL << 63, 0, 1LL << 63};  // NOLINT(*signed-bitwise)

struct Rows {
  Lanes x, y, z, w;
};

inline Lanes load(const Site* site) {
  Lanes lanes;
  __builtin_memcpy(&lanes, site, sizeof lanes);
  return lanes;
}

/// Coordinates relative to p and their squared lengths, a lane for each site.
inline Rows relative(const FourSites& sites, const Site& p) {
  const Lanes a = load(sites[0]), b = load(sites[1]), c = load(sites[2]), d = load(sites[3]);
  const Lanes ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes ab_y = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_y = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  Rows rows{};
  rows.x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5) - p.x;
  rows.y = __builtin_shufflevector(ab_y, cd_y, 0, 1, 4, 5) - p.y;
  rows.z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7) - p.z;
  rows.w = rows.x * rows.x + rows.y * rows.y + rows.z * rows.z;
  return rows;
}

inline Rows turned(const Rows& r) {
  return {
      __builtin_shufflevector(r.x, r.x, 1, 2, 3, 0), __builtin_shufflevector(r.y, r.y, 1, 2, 3, 0),
      __builtin_shufflevector(r.z, r.z, 1, 2, 3, 0), __builtin_shufflevector(r.w, r.w, 1, 2, 3, 0)};
}

inline Lanes greater(const Lanes& a, const Lanes& b) { return a > b ? a : b; }

inline unsigned mask_of(const LaneBits& bits) {
#ifdef __AVX2__
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Lanes>(bits)));
#else
  unsigned mask = 0;
  for (int i = 0; i < 4; ++i) mask |= bits[i] != 0 ? 1U << i : 0;
  return mask;
#endif
}

inline Lanes oriented(const Lanes& value) {
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(value) ^ kOddLanes);
}

/// The signs of the values, every other one turned round.
inline FacetSigns signs_of(const Lanes& value, const LaneBits& decided) {
  return {mask_of(decided & (oriented(value) > 0)), 15U & ~mask_of(decided)};
}

FacetSigns beyond(const FourSites& corners, const Site& p) {
  const Rows a = relative(corners, p), b = turned(a), c = turned(b);
  const Lanes yz = a.y * b.z - a.z * b.y;
  const Lanes zx = a.z * b.x - a.x * b.z;
  const Lanes xy = a.x * b.y - a.y * b.x;
  const Lanes value = yz * c.x + zx * c.y + xy * c.z;
  const Lanes most = greater(greater(a.w, b.w), c.w);
  return signs_of(value,
                  value * value > kOrientationBound * (most * most * most) + kOrientationUnderflow);
}

struct Minors {
  Lanes xy, xz, xw, yz, yw, zw;
};

inline Minors minors(const Rows& a, const Rows& b) {
  return {a.x * b.y - a.y * b.x, a.x * b.z - a.z * b.x, a.x * b.w - a.w * b.x,
          a.y * b.z - a.z * b.y, a.y * b.w - a.w * b.y, a.z * b.w - a.w * b.z};
}

/// With all signs positive.
inline Minors permanents(const Rows& a, const Rows& b) {
  return {a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x, a.x * b.w + a.w * b.x,
          a.y * b.z + a.z * b.y, a.y * b.w + a.w * b.y, a.z * b.w + a.w * b.z};
}

/// Of four rows, from the minors of the first and of the last two.
inline Lanes determinant(const Minors& ab, const Minors& cd) {
  return ((ab.xy * cd.zw - ab.xz * cd.yw) + (ab.xw * cd.yz + ab.yz * cd.xw)) +
         (ab.zw * cd.xy - ab.yw * cd.xz);
}
inline Lanes permanent(const Minors& ab, const Minors& cd) {
  return ((ab.xy * cd.zw + ab.xz * cd.yw) + (ab.xw * cd.yz + ab.yz * cd.xw)) +
         (ab.zw * cd.xy + ab.yw * cd.xz);
}

/// Of three rows, the places alone.
inline Lanes determinant(const Minors& ab, const Rows& c) {
  return ab.xy * c.z - ab.xz * c.y + ab.yz * c.x;
}

inline Lanes absolute(const Lanes& values) {
  constexpr LaneBits kSign = {~(1LL << 63), ~(1LL << 63), ~(1LL << 63), ~(1LL << 63)};
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(values) & kSign);
}
inline Rows absolute(const Rows& r) {
  return {absolute(r.x), absolute(r.y), absolute(r.z), absolute(r.w)};
}

inline LaneBits turned(const LaneBits& bits) {
  return __builtin_shufflevector(bits, bits, 1, 2, 3, 0);
}

inline Lanes greatest(const Lanes& values) {
  const Lanes pairs = greater(values, __builtin_shufflevector(values, values, 1, 0, 3, 2));
  return greater(pairs, __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1));
}

/// Which are not a number.
inline LaneBits is_ghost(const Rows& rows) { return ~(rows.x <= __builtin_inf()); }

/// Puts (0, 0, 0, height) in place of the ghost vertex.
inline void raise_ghosts(Rows& rows, const LaneBits& ghosts, const Lanes& height) {
  rows.x = ghosts ? Lanes{} : rows.x;
  rows.y = ghosts ? Lanes{} : rows.y;
  rows.z = ghosts ? Lanes{} : rows.z;
  rows.w = ghosts ? height : rows.w;
}

/// With the greatest squared length of all others as the height, which is returned.
inline Lanes raise_ghosts(Rows& a, Rows& d) {
  const LaneBits ghost_a = is_ghost(a), ghost_d = is_ghost(d);
  const Lanes height = greatest(greater(ghost_a ? Lanes{} : a.w, ghost_d ? Lanes{} : d.w));
  raise_ghosts(a, ghost_a, height);
  raise_ghosts(d, ghost_d, height);
  return height;
}

/// The factor of the height of the last of some points, in lexicographic order, that has one.
struct LastFactor {
  Lanes factor;
  Lanes place;
  void take(const Lanes& other, const Lanes& other_place) {
    const LaneBits is_later = (other != 0) & (other_place > place);
    factor = is_later ? other : factor;
    place = is_later ? other_place : place;
  }
};

/// Grows with the lexicographic order of integers below 2^10, and is one of less than 2^53.
inline Lanes place_of(const Rows& r) { return r.x * 0x1p22 + r.y * 0x1p11 + r.z; }

/// Whose sign is that of the perturbed determinant if the other is zero: of the height of a, b, c,
/// d, or p.
inline Lanes tie(const Rows& a, const Rows& b, const Rows& c, const Rows& d, const Minors& ab,
                 const Minors& cd) {
  const Lanes of_a = -determinant(cd, b), of_b = determinant(cd, a), of_c = -determinant(ab, d),
              of_d = determinant(ab, c);
  LastFactor last{-((of_a + of_b) + (of_c + of_d)), {}};
  last.place = last.factor != 0 ? Lanes{} : Lanes{} - __builtin_inf();
  last.take(of_a, place_of(a));
  last.take(of_b, place_of(b));
  last.take(of_c, place_of(c));
  last.take(of_d, place_of(d));
  return last.factor;
}

/// As conflict_quickly(), with the ghost vertex, the better bound, and short integers.
FacetSigns conflict_closely(const FourSites& corners, const FourSites& apexes, const Site& p,
                            double short_below) {
  Rows a = relative(corners, p), d = relative(apexes, p);
  const LaneBits ghost_a = is_ghost(a), ghost_b = turned(ghost_a),
                 has_ghost = ghost_a | ghost_b | turned(ghost_b) | is_ghost(d);
  const Lanes most = raise_ghosts(a, d);
  const Rows b = turned(a), c = turned(b);
  const Minors ab = minors(a, b), cd = minors(c, d);
  const Lanes value = determinant(ab, cd);
  if (most[0] < short_below) {
    const LaneBits is_zero = value == 0;
    if (mask_of(is_zero) == 0) return {mask_of(oriented(value) > 0), 0};
    const Lanes sign = is_zero ? (has_ghost ? Lanes{} : tie(a, b, c, d, ab, cd)) : value;
    return signs_of(sign, sign != 0);
  }
  const Lanes sum =
      permanent(permanents(absolute(a), absolute(b)), permanents(absolute(c), absolute(d)));
  return signs_of(value, (value * value > kCloseBound * (sum * sum) + kSphereUnderflow) &
                             (most < kGreatestSquare));
}

/// The greatest square of those in a facet and of that in d.
inline Lanes greatest_square(const Lanes& a, const Lanes& d) {
  const Lanes a2 = a * a, b2 = __builtin_shufflevector(a2, a2, 1, 2, 3, 0),
              c2 = __builtin_shufflevector(a2, a2, 2, 3, 0, 1);
  return greater(greater(a2, b2), greater(c2, d * d));
}

/// Which bound is asked, and whether the ghost vertex has a place.
enum class Filter : std::uint8_t { plain, thorough };

/// Of the corners, and the apexes: by (2), or with the ghost vertex by (5).
template <Filter kFilter>
[[gnu::always_inline]] inline FacetSigns filtered(Rows a, Rows d) {
  if constexpr (kFilter == Filter::thorough) raise_ghosts(a, d);
  const Rows b = turned(a), c = turned(b);
  // Term by term, so that few registers are in use.
  const Lanes xy = (a.x * b.y - a.y * b.x) * (c.z * d.w - c.w * d.z);
  const Lanes xz = (a.x * b.z - a.z * b.x) * (c.y * d.w - c.w * d.y);
  const Lanes xw = (a.x * b.w - a.w * b.x) * (c.y * d.z - c.z * d.y);
  const Lanes yz = (a.y * b.z - a.z * b.y) * (c.x * d.w - c.w * d.x);
  const Lanes yw = (a.y * b.w - a.w * b.y) * (c.x * d.z - c.z * d.x);
  const Lanes zw = (a.z * b.w - a.w * b.z) * (c.x * d.y - c.y * d.x);
  const Lanes value = ((xy - xz) + (xw + yz)) + (zw - yw);
  const Lanes most = greater(greater(a.w, b.w), greater(c.w, d.w));
  const Lanes size = kFilter == Filter::plain
                         ? (a.w * b.w) * (c.w * d.w) * most
                         : greatest_square(a.x, d.x) * greatest_square(a.y, d.y) *
                               greatest_square(a.z, d.z) * (most * most);
  const Lanes bound = kSphereBound * size + kSphereUnderflow;
  return signs_of(value, (value * value > bound) & (most < kGreatestSquare));
}

FacetSigns conflict_quickly(const FourSites& corners, const FourSites& apexes, const Site& p) {
  return filtered<Filter::plain>(relative(corners, p), relative(apexes, p));
}

FacetSigns conflict_thoroughly(const FourSites& corners, const FourSites& apexes, const Site& p) {
  return filtered<Filter::thorough>(relative(corners, p), relative(apexes, p));
}

// NOLINTEND(misc-definitions-in-headers)
}  // namespace
}  // namespace hexatlas::delaunay
