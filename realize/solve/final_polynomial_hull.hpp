#pragma once
/// \file
/// Which of many vectors add up to zero, as a proposal in floating point. Private to realize/solve.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexatlas::solve {

/// e_i + e_j - e_k - e_l for unit vectors e of the numbers i, j (plus) and k, l (minus).
struct FourTermVector {
  std::array<std::size_t, 2> plus{}, minus{};
};

/// Indices, ascending, of affinely independent vectors with the origin in their convex hull, none
/// of which can be left out; nullopt: the origin seems to lie outside the hull of all. Method: P.
/// Wolfe, "Finding the nearest point in a polytope", Math. Programming 11 (1976), in double
/// precision; it stops at the first hyperplane that separates the vectors from the origin.
/// Not promised: that the answer is right; rounding may mislead it either way.
/// Requires numbers below `dimension`. Cost: O(k^3 + vectors) per step, k <= dimension + 1 vectors
/// being active; some hundred steps.
[[nodiscard]] std::optional<std::vector<std::size_t>> propose_zero_combination(
    std::span<const FourTermVector> vectors, std::size_t dimension);

}  // namespace hexatlas::solve
