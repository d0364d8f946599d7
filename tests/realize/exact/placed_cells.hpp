#pragma once
/// \file
/// Cells for tests, made from other cells: any array of points with x, y and z.

#include <cmath>
#include <random>

namespace hexatlas::placed_cells {

/// Times 2^exponent.
template <class Cell>
Cell scaled(Cell cell, int exponent) {
  for (auto& p : cell)
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  return cell;
}

/// Times `side`, then each coordinate moved by an integer of at most `shift`.
template <class Cell>
Cell moved(Cell cell, int side, int shift, std::mt19937_64& random) {
  std::uniform_int_distribution<int> move(-shift, shift);
  for (auto& p : cell)
    p = {side * p.x + move(random), side * p.y + move(random), side * p.z + move(random)};
  return cell;
}

}  // namespace hexatlas::placed_cells
