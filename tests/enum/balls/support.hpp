#pragma once
/// \file
/// What the tests of triangulations share: random labels, and the forms of the oracle.

#include <algorithm>
#include <numeric>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "tests/enum/support.hpp"
#include "tests/oracles/three_manifolds.hpp"

namespace hexatlas::support {

inline oracle::Tetrahedra tetrahedra_of(const complex::Triangulation& triangulation) {
  oracle::Tetrahedra result;
  for (const complex::VertexSet set : triangulation.tetrahedra) {
    oracle::Tetrahedron t{};
    std::size_t n = 0;
    for (int v = 0; v < 16; ++v)
      if ((set >> static_cast<unsigned>(v) & 1U) != 0) t.at(n++) = v;
    result.push_back(t);
  }
  return result;
}

inline complex::Triangulation scrambled(const complex::Triangulation& triangulation,
                                        Random& random) {
  std::vector<std::uint8_t> names(static_cast<std::size_t>(triangulation.vertices));
  std::iota(names.begin(), names.end(), std::uint8_t{0});
  random.shuffle(names);
  complex::VertexMap map{};
  std::copy(names.begin(), names.end(), map.begin());
  return complex::image_of(triangulation, map);
}

}  // namespace hexatlas::support
