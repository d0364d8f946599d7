#pragma once
/// \file
/// Internal to the judge: the sign of the Jacobian determinant of a trilinear hexahedron, exactly.
///
/// The determinant is a polynomial of degree 2 in each of the three coordinates; its 27 Bernstein
/// coefficients bound it, and those at the corners are values. Where they do not decide, the cube
/// is halved in the three directions by de Casteljau's algorithm (G. Farin, "Curves and Surfaces
/// for CAGD"). All numbers are integers: eight times the coefficients are below 2^69 if the
/// coordinates are below 2^20 (a determinant of differences is below 6 * 2^63 < 2^66), and halving
/// multiplies the common denominator by 2^6. So 128 bits suffice for kJacobianDepth halvings: 69 +
/// 9 * 6 = 123. For coordinates in double precision they are integers of any length.

#include <array>
#include <cstdint>
#include <vector>

#include "tables/check/catalogue_read.hpp"
#include "tables/check/mesh.hpp"
#include "tables/check/wide.hpp"

namespace hexatlas::check {

[[nodiscard]] LatticePoint difference(const LatticePoint& a, const LatticePoint& b) noexcept;
/// Requires entries below 2^21.
[[nodiscard]] Wide determinant(const LatticePoint& a, const LatticePoint& b,
                               const LatticePoint& c) noexcept;

inline constexpr int kJacobianDepth = 9;
/// Cubes looked at before the judge gives up.
inline constexpr int kJacobianCubes = 100'000;

enum class JacobianSign : std::uint8_t { kPositive, kNotPositive, kUnknown };

/// kNotPositive: not positive at some point of the closed cube. Requires eight points, that of the
/// corner (x, y, z) at x + 2y + 4z, with coordinates below 2^20.
[[nodiscard]] JacobianSign jacobian_sign(const std::vector<LatticePoint>& points);

/// The same for finite points. Cost: a microsecond where double precision decides, about 50 us
/// where the coefficients do, some milliseconds for each thousand cubes looked at.
[[nodiscard]] JacobianSign jacobian_sign(const std::array<Point, 8>& points);

}  // namespace hexatlas::check
