#pragma once
/// \file
/// Ranks over the field with two elements.

#include <cstddef>
#include <vector>

namespace hexatlas::core {

/// The rank of a matrix modulo 2. A row is the columns of its ones, ascending.
/// Cost: elimination of sparse rows, quadratic in their number at least.
[[nodiscard]] std::size_t rank_modulo_2(std::vector<std::vector<std::size_t>> rows);

}  // namespace hexatlas::core
