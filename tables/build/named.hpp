#pragma once
/// \file
/// Celebrated boundaries by name. The codes are those of the surfaces described; a test computes
/// them from coordinates.

#include <array>
#include <string_view>

namespace hexatlas::build {

struct NamedBoundary {
  std::string_view name;
  std::string_view code;
  std::string_view description;
};

inline constexpr std::array<NamedBoundary, 5> kNamedBoundaries{{
    {"cube", "q1:08a5df", "the surface of one hexahedron"},
    {"octagonal-spindle", "q1:088a577f",
     "eight quads around two poles, the tetragonal trapezohedron (Mitchell 1999)"},
    {"rhombic-dodecahedron", "q1:088a2a5ddf7f", "twelve quads, boundary of four hexahedra"},
    {"schneiders-pyramid", "q1:02228a2a5777df7f",
     "a square pyramid, its base cut into 4 quads and each side into 3 (Schneiders 1996)"},
    {"two-cubes", "q1:022972977f", "two hexahedra glued along a quad"},
}};

}  // namespace hexatlas::build
