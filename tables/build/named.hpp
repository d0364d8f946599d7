#pragma once
/// \file
/// Celebrated boundaries by name, with the fewest hexahedra known in the literature. The codes are
/// those of the surfaces described; a test computes them from coordinates.

#include <array>
#include <string_view>

namespace hexatlas::build {

struct NamedBoundary {
  std::string_view name;
  std::string_view code;
  std::string_view description;
  int literature = 0;       ///< hexahedra of the smallest mesh published
  std::string_view source;  ///< where it was published; or why it is evident
};

inline constexpr std::string_view kBySight = "evident from the construction";
inline constexpr std::string_view kMidpoint = "midpoint subdivision: Li, McKeag and Armstrong 1995";

/// Ascending by name.
inline constexpr std::array<NamedBoundary, 9> kNamedBoundaries{{
    {"cube", "q1:08a5df", "the surface of one hexahedron", 1, kBySight},
    {"diced-prism", "q1:0220a2a5ca9777df7f",
     "a triangular prism, its triangles cut into 3 quads and its sides into 4", 6, kMidpoint},
    {"octagonal-spindle", "q1:088a577f",
     "eight quads around two poles, the tetragonal trapezohedron (Mitchell 1999)", 40,
     "Verhetsel, Pellerin and Remacle 2018"},
    {"rhombic-dodecahedron", "q1:088a2a5ddf7f",
     "twelve quads, boundary of four hexahedra: a tetrahedron whose triangles are cut into 3 quads",
     4, kMidpoint},
    {"schneiders-pyramid", "q1:02228a2a5777df7f",
     "a square pyramid, its base cut into 4 quads and each side into 3 (Schneiders 1996)", 36,
     "Xiang and Liu 2018"},
    {"subdivided-cube", "q1:0220a0a0a2a5e5e5f777df7f", "a cube, each side cut into 4 quads", 8,
     kMidpoint},
    {"three-around-an-edge", "q1:02228a5d777f",
     "three hexahedra around an edge: a square with one corner cut off, thickened to one layer", 3,
     kBySight},
    {"three-to-one", "q1:022222a575df7f",
     "a square with one edge cut into 3, made of 4 quads, thickened to one layer", 4, kBySight},
    {"two-cubes", "q1:022972977f", "two hexahedra glued along a quad", 2, kBySight},
}};

/// Null if the name is none of these.
[[nodiscard]] constexpr const NamedBoundary* named_boundary(std::string_view name) noexcept {
  for (const NamedBoundary& boundary : kNamedBoundaries)
    if (boundary.name == name) return &boundary;
  return nullptr;
}

/// The same by canonical code.
[[nodiscard]] constexpr const NamedBoundary* boundary_with_code(std::string_view code) noexcept {
  for (const NamedBoundary& boundary : kNamedBoundaries)
    if (boundary.code == code) return &boundary;
  return nullptr;
}

}  // namespace hexatlas::build
