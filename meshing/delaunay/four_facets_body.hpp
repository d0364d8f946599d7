// Private to meshing/delaunay: what four_facets_avx2.cpp and four_facets_plain.cpp compile, each
// for its processor, in an unnamed namespace. No function of the standard library: its code, made
// for one processor, could be linked into what runs on the other.

#include "meshing/delaunay/four_facets.hpp"

namespace hexatlas::delaunay {
namespace {
// NOLINTBEGIN(misc-definitions-in-headers): each includer is meant to have its own

using Lanes [[gnu::vector_size(32)]] = double;
using LaneBits [[gnu::vector_size(32)]] = long long;

// Squares of twice the first summands in four_facets.hpp.
constexpr double kOrientationBound = 0x1p-92;  // 2^-46 squared
constexpr double kSphereBound = 0x1p-86;       // 2^-43 squared
constexpr double kUnderflow = 0x1p-900;
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

/// The signs of the values, every other one turned round.
inline FacetSigns signs_of(const Lanes& value, const Lanes& squared_bound) {
  const LaneBits decided = value * value > squared_bound;
  const Lanes oriented = reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(value) ^ kOddLanes);
  return {mask_of(decided & (oriented > 0)), 15U & ~mask_of(decided)};
}

FacetSigns beyond(const FourSites& corners, const Site& p) {
  const Rows a = relative(corners, p), b = turned(a), c = turned(b);
  const Lanes yz = a.y * b.z - a.z * b.y;
  const Lanes zx = a.z * b.x - a.x * b.z;
  const Lanes xy = a.x * b.y - a.y * b.x;
  const Lanes value = yz * c.x + zx * c.y + xy * c.z;
  const Lanes most = greater(greater(a.w, b.w), c.w);
  return signs_of(value, kOrientationBound * (most * most * most) + kUnderflow);
}

FacetSigns conflict(const FourSites& corners, const FourSites& apexes, const Site& p) {
  const Rows a = relative(corners, p), b = turned(a), c = turned(b);
  const Rows d = relative(apexes, p);
  const Lanes xy = (a.x * b.y - a.y * b.x) * (c.z * d.w - c.w * d.z);
  const Lanes xz = (a.x * b.z - a.z * b.x) * (c.y * d.w - c.w * d.y);
  const Lanes xw = (a.x * b.w - a.w * b.x) * (c.y * d.z - c.z * d.y);
  const Lanes yz = (a.y * b.z - a.z * b.y) * (c.x * d.w - c.w * d.x);
  const Lanes yw = (a.y * b.w - a.w * b.y) * (c.x * d.z - c.z * d.x);
  const Lanes zw = (a.z * b.w - a.w * b.z) * (c.x * d.y - c.y * d.x);
  const Lanes value = ((xy - xz) + (xw + yz)) + (zw - yw);
  const Lanes most = greater(greater(a.w, b.w), greater(c.w, d.w));
  const Lanes squared = most * most;
  return signs_of(value, kSphereBound * (squared * squared * most) + kUnderflow);
}

// NOLINTEND(misc-definitions-in-headers)
}  // namespace
}  // namespace hexatlas::delaunay
