#pragma once
/// \file
/// Boundaries put together from quads of other ones.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/quad_flip.hpp"

namespace hexatlas::flips {

/// A boundary in numbers of its own.
template <class Name>
struct NumberedBoundary {
  complex::Quadrangulation boundary;
  std::vector<Name> name;  ///< of each of its vertices
};

/// The boundary with these quads, in their order, its vertices numbered as they appear; nullopt if
/// they are not those of a 3-connected quadrangulation. Cost: linear in the quads and the greatest
/// name.
template <class Name>
[[nodiscard]] std::optional<NumberedBoundary<Name>> three_connected_boundary(
    const std::vector<std::array<Name, 4>>& quads) {
  std::size_t names = 0;
  for (const auto& quad : quads)
    for (const Name v : quad) names = std::max(names, std::size_t{v} + 1);
  std::vector<complex::Vertex> number(names, kNewVertex);
  NumberedBoundary<Name> result;
  std::vector<complex::QuadVertices> numbered(quads.size());
  for (std::size_t k = 0; k < quads.size(); ++k)
    for (std::size_t i = 0; i < 4; ++i) {
      const Name v = quads[k][i];
      if (number[v] == kNewVertex) {
        number[v] = static_cast<complex::Vertex>(result.name.size());
        result.name.push_back(v);
      }
      numbered[k][i] = number[v];
    }
  if (result.name.size() != quads.size() + 2) return std::nullopt;
  const auto boundary = complex::Quadrangulation::from_quads(numbered);
  if (!boundary || !boundary->is_three_connected()) return std::nullopt;
  result.boundary = *boundary;
  return result;
}

}  // namespace hexatlas::flips
