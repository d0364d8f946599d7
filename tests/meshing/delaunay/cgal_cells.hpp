#pragma once
/// \file
/// The tetrahedra of CGAL's triangulations whose vertices carry numbers.

#include <algorithm>
#include <array>
#include <cstdint>

#include "tests/meshing/delaunay/oracle.hpp"

namespace hexatlas::delaunay_tests {

/// In the form of Triangulation::tetrahedra(). CGAL's cells are right-handed.
template <class Cgal>
Tetrahedra tetrahedra_of(const Cgal& cgal) {
  Tetrahedra result;
  for (const auto cell : cgal.finite_cell_handles()) {
    std::array<std::uint32_t, 4> t{};
    for (int i = 0; i < 4; ++i) t[static_cast<unsigned>(i)] = cell->vertex(i)->info();
    const auto least = static_cast<unsigned>(std::min_element(t.begin(), t.end()) - t.begin());
    t = {t[least], t[least ^ 1U], t[least ^ 2U], t[least ^ 3U]};
    std::rotate(t.begin() + 1, std::min_element(t.begin() + 1, t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace hexatlas::delaunay_tests
