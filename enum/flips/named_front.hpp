#pragma once
/// \file
/// Fronts whose vertices have names while an orbit or a crown is glued on: those of the front
/// before, and of new vertices. For the sources of this layer only.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "enum/core/checks.hpp"
#include "enum/flips/symmetric_front.hpp"

namespace hexatlas::flips {

inline constexpr OrbitVertex kUnknown = 0xFF;
inline constexpr std::size_t kNames = complex::kMaxVertices + kNewPerOrbit;
using Names = std::array<OrbitVertex, kNames>;  ///< something of each name

struct Named {
  Front front;
  std::array<OrbitVertex, complex::kMaxVertices> name{};
};

/// Each vertex by its own number.
inline Named named(const Front& front) {
  Named result{front};
  for (int v = 0; v < front.boundary.vertices(); ++v)
    result.name[static_cast<std::size_t>(v)] = static_cast<OrbitVertex>(v);
  return result;
}

/// The vertices that an involution takes these to.
[[nodiscard]] inline VertexSet image_of(VertexSet vertices,
                                        const canon::Labelling& image) noexcept {
  VertexSet result = 0;
  for (VertexSet left = vertices; left != 0; left &= left - 1)
    result |= bit(image[static_cast<std::size_t>(std::countr_zero(left))]);
  return result;
}

/// The hexahedron of a prism; top i has the name first_new + i if it is new.
inline OrbitCell named_cell(const Named& from, const Prism& prism, int first_new) {
  OrbitCell cell{};
  for (std::size_t i = 0; i < 4; ++i) {
    const complex::Vertex top = prism.top[i];
    cell[cells::kCornerOfPrism[i]] = from.name[prism.bottom[i]];
    cell[cells::kCornerOfPrism[4 + i]] =
        top == kNewVertex ? static_cast<OrbitVertex>(first_new + static_cast<int>(i))
                          : from.name[top];
  }
  return cell;
}

inline Named after_gluing(const Named& from, Flip flip, const Prism& prism, const OrbitCell& cell) {
  const Glued next = glued(from.front, flip, prism);
  Named result{next.front};
  for (int v = 0; v < result.front.boundary.vertices(); ++v) {
    const complex::Vertex former = next.flipped.former[static_cast<std::size_t>(v)];
    if (former != kNewVertex) result.name[static_cast<std::size_t>(v)] = from.name[former];
  }
  for (std::size_t i = 0; i < 4; ++i)
    result.name[next.flipped.top[i]] = cell[cells::kCornerOfPrism[4 + i]];
  return result;
}

/// What has been glued on, `image` being that of each name; without the orbit and its hexahedra.
inline GluedOrbit glued_with(const Named& last, const Names& image) {
  const auto vertices = static_cast<std::size_t>(last.front.boundary.vertices());
  Names place{};
  place.fill(kUnknown);
  for (std::size_t v = 0; v < vertices; ++v) place[last.name[v]] = static_cast<OrbitVertex>(v);
  GluedOrbit result{{}, {last.front}, last.name, {}};
  for (std::size_t v = 0; v < vertices; ++v) {
    result.made.image[v] = place[image[last.name[v]]];
    core::check_law([&] { return result.made.image[v] != kUnknown; },
                    "the image of a boundary vertex is on the boundary");
  }
  return result;
}

}  // namespace hexatlas::flips
