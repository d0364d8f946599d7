#pragma once
/// \file
/// Quadrangulations of a disc with few quads.

#include <vector>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::flips {

/// Quads, counter-clockwise, of a disc whose boundary is the circle 0, 1, ..., length-1,
/// counter-clockwise; vertices from `length` on are interior.
using Disc = std::vector<complex::QuadVertices>;

/// All quadrangulations of the disc with labelled boundary in which no two edges have the same
/// ends: each one once, whatever the numbers of its interior vertices. Two quads may share two
/// edges. Some discs in which two edges have the same ends come as well. Each has length/2 - 1 +
/// interior quads. Requires an even length of at least 4. Cost: exponential in both; meant for
/// length + interior up to about 12.
[[nodiscard]] std::vector<Disc> discs(int length, int interior);

}  // namespace hexatlas::flips
