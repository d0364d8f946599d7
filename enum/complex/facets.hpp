#pragma once
/// \file
/// Facets of the hexahedra of a complex, sorted so that equal quads are neighbours.

#include <array>
#include <cstdint>
#include <vector>

#include "enum/complex/hex_complex.hpp"

namespace hexatlas::complex {

struct Facet {
  BoundaryQuad key{};    ///< the vertices, ascending
  BoundaryQuad cycle{};  ///< counter-clockwise from outside the hexahedron
  std::uint32_t cell = 0;
  std::uint32_t facet = 0;  ///< as in enum/cells/cube.hpp
};

/// All facets by (key, cell). Cost: O(H log H).
[[nodiscard]] std::vector<Facet> sorted_facets(const HexComplex& mesh);

/// Whether the second cycle is the first one reversed, up to rotation.
[[nodiscard]] bool are_opposite(const BoundaryQuad& a, const BoundaryQuad& b) noexcept;

/// The same cycle, starting at its least vertex.
[[nodiscard]] BoundaryQuad from_least(BoundaryQuad cycle) noexcept;

}  // namespace hexatlas::complex
