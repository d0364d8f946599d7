// Private to realize/exact: what jacobian_lanes_avx2.cpp and jacobian_lanes_plain.cpp compile, each
// for its processor, in an unnamed namespace. No function of the standard library: its code, made
// for one processor, could be linked into what runs on the other.

#include "realize/exact/jacobian_lanes.hpp"

namespace hexatlas::exact {
namespace {
// NOLINTBEGIN(misc-definitions-in-headers, modernize-avoid-c-arrays): see above

using Lanes [[gnu::vector_size(32)]] = double;
using LaneBits [[gnu::vector_size(32)]] = long long;

static_assert(sizeof(Point3) == 3 * sizeof(double), "the corners are 24 doubles in a row");

struct Vector {
  Lanes x, y, z;
};

inline Lanes load(const Point3* corners, int first) {
  Lanes lanes;
  __builtin_memcpy(&lanes, reinterpret_cast<const char*>(corners) + first * sizeof(double),
                   sizeof lanes);
  return lanes;
}

/// Doubles 4 i to 4 i + 3 of each hexahedron, a lane for each hexahedron.
inline void transpose(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d, Lanes* out) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  out[0] = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  out[2] = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  out[3] = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Lanes dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Lanes least(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
inline Lanes greatest(const Lanes& a, const Lanes& b) { return a > b ? a : b; }
inline Lanes magnitude(const Lanes& a) {
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(a) & 0x7FFF'FFFF'FFFF'FFFFLL);
}

inline unsigned mask_of(const LaneBits& bits) {
#ifdef __AVX2__
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Lanes>(bits)));
#else
  unsigned mask = 0;
  for (int i = 0; i < 4; ++i) mask |= bits[i] != 0 ? 1U << i : 0;
  return mask;
#endif
}

/// The edge vectors: a[j + 2k], b[i + 2k], c[i + 2j] of the derivation.
struct Edges {
  Vector a[4], b[4], c[4];
};

inline Edges edges_of(const Vector* p) {
  Edges e{};
  for (int o = 0; o < 4; ++o) {
    const int low = o & 1;
    const int high = o >> 1;
    e.a[o] = p[2 * low + 4 * high + 1] - p[2 * low + 4 * high];
    e.b[o] = p[low + 4 * high + 2] - p[low + 4 * high];
    e.c[o] = p[low + 2 * high + 4] - p[low + 2 * high];
  }
  return e;
}

/// The least S of each kind.
struct LeastSums {
  Lanes corner, edge, facet, inside;
};

inline LeastSums least_sums(const Edges& e) {
  Vector normal[8];  // dx/dr x dx/ds at corner i + 2j + 4k
  Lanes corner[8];
  for (int v = 0; v < 8; ++v) {
    const int i = v & 1, j = v >> 1 & 1, k = v >> 2;
    normal[v] = cross(e.a[j + 2 * k], e.b[i + 2 * k]);
    corner[v] = dot(normal[v], e.c[i + 2 * j]);
  }
  Lanes along_r[4], along_s[4], along_t[4];  // edges, by the same places as in Edges
  for (int o = 0; o < 4; ++o) {
    const int low = o & 1, high = o >> 1;
    const int r = 2 * low + 4 * high;  // the corner where the edge begins
    const int s = low + 4 * high;
    along_r[o] = dot(normal[r], e.c[1 + 2 * low]) + dot(normal[r + 1], e.c[2 * low]);
    along_s[o] = dot(normal[s], e.c[low + 2]) + dot(normal[s + 2], e.c[low]);
    along_t[o] = dot(cross(e.a[high], e.b[low + 2]) + cross(e.a[high + 2], e.b[low]), e.c[o]);
  }
  Lanes parallel_to_t[4];  // r = 0, r = 1, s = 0, s = 1
  for (int side = 0; side < 2; ++side) {
    const int i = side, j = 2 * side;
    parallel_to_t[side] = (along_s[i] + along_s[i + 2] + along_t[i] + along_t[i + 2]) -
                          (corner[i] + corner[i + 2] + corner[i + 4] + corner[i + 6]);
    parallel_to_t[2 + side] = (along_r[side] + along_r[side + 2] + along_t[j] + along_t[j + 1]) -
                              (corner[j] + corner[j + 1] + corner[j + 4] + corner[j + 5]);
  }
  LeastSums result{corner[0], along_r[0], parallel_to_t[0], {}};
  for (int k = 0; k < 2; ++k) {
    const Lanes across =
        (along_r[2 * k] + along_r[2 * k + 1] + along_s[2 * k] + along_s[2 * k + 1]) -
        (corner[4 * k] + corner[4 * k + 1] + corner[4 * k + 2] + corner[4 * k + 3]);
    result.facet = least(result.facet, across);
  }
  for (int v = 1; v < 8; ++v) result.corner = least(result.corner, corner[v]);
  for (int o = 0; o < 4; ++o) {
    result.edge = least(result.edge, least(along_r[o], least(along_s[o], along_t[o])));
    result.facet = least(result.facet, parallel_to_t[o]);
  }
  result.inside = (parallel_to_t[0] + parallel_to_t[1] + parallel_to_t[2] + parallel_to_t[3]) -
                  (along_t[0] + along_t[1] + along_t[2] + along_t[3]);
  return result;
}

/// Upper bounds on the absolute values of the components of edges; a NaN is overlooked.
inline Vector bounds_of(const Edges& e) {
  Vector bound{magnitude(e.a[0].x), magnitude(e.a[0].y), magnitude(e.a[0].z)};
  const auto include = [&bound](const Vector& v) {
    bound.x = greatest(bound.x, magnitude(v.x));
    bound.y = greatest(bound.y, magnitude(v.y));
    bound.z = greatest(bound.z, magnitude(v.z));
  };
  for (int o = 0; o < 4; ++o) {
    include(e.a[o]);
    include(e.b[o]);
    include(e.c[o]);
  }
  return bound;
}

LaneVerdicts judge(const Point3* a, const Point3* b, const Point3* c, const Point3* d) {
  Lanes rows[24];
  for (int i = 0; i < 24; i += 4)
    transpose(load(a, i), load(b, i), load(c, i), load(d, i), rows + i);
  Vector corners[8];
  for (int v = 0; v < 8; ++v) corners[v] = {rows[3 * v], rows[3 * v + 1], rows[3 * v + 2]};
  const Edges edges = edges_of(corners);
  const LeastSums sums = least_sums(edges);
  const Vector bound = bounds_of(edges);
  // Every corner ends one of these four edges. What is infinite or NaN times 0 is NaN.
  Lanes zero = edges.a[0].x * 0;
  for (const Vector& edge : edges.a) zero += (edge.x * 0 + edge.y * 0) + edge.z * 0;
  const LaneBits finite = zero == 0;
  const LaneBits in_range = (least(least(bound.x, bound.y), bound.z) >= 0x1p-300) &
                            (greatest(greatest(bound.x, bound.y), bound.z) <= 0x1p300);
  const Lanes unit = bound.x * bound.y * bound.z;
  const LaneBits positive = (sums.corner > 0x1p-47 * unit) & (sums.edge > 0x1p-46 * unit) &
                            (sums.facet > 0x1p-43 * unit) & (sums.inside > 0x1p-40 * unit);
  const LaneBits negative = sums.corner < -0x1p-47 * unit;
  return {mask_of(positive & in_range), mask_of(negative & in_range), 15U & ~mask_of(finite)};
}

// NOLINTEND(misc-definitions-in-headers, modernize-avoid-c-arrays)
}  // namespace
}  // namespace hexatlas::exact
