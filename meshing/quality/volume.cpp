#include "meshing/quality/volume.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

#include "enum/cells/cube.hpp"
#include "meshing/quality/edge.hpp"

namespace hexatlas::quality {
namespace {

using mesh::Point;
using Triangle = std::array<std::uint8_t, 3>;
using Quad = std::array<std::uint8_t, 4>;

/// Sides counter-clockwise from outside; those with vertex 0 that are triangles contribute nothing.
double enclosed(std::span<const Point> corners, std::span<const Triangle> triangles,
                std::span<const Quad> quads) {
  const auto six_cones = [corners](std::uint8_t a, std::uint8_t b, std::uint8_t c) {
    const auto at = [corners](std::uint8_t v) {
      return scaled_difference(corners[0], corners[v], 1);
    };
    return determinant(at(a), at(b), at(c));
  };
  double sixfold = 0;
  for (const auto& [a, b, c] : triangles) sixfold += six_cones(a, b, c);
  double twice = 0;
  for (const auto& [a, b, c, d] : quads)
    twice += six_cones(a, b, c) + six_cones(a, c, d) + six_cones(a, b, d) + six_cones(b, c, d);
  return (sixfold + twice / 2) / 6;
}

}  // namespace

double volume(const TetrahedronCorners& corners) {
  return enclosed(corners, std::array<Triangle, 1>{{{1, 2, 3}}}, {});
}

double volume(const PrismCorners& corners) {
  return enclosed(corners, std::array<Triangle, 1>{{{3, 4, 5}}},
                  std::array<Quad, 3>{{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}});
}

double volume(const PyramidCorners& corners) {
  return enclosed(corners, std::array<Triangle, 2>{{{1, 2, 4}, {2, 3, 4}}},
                  std::array<Quad, 1>{{{0, 3, 2, 1}}});
}

double volume(const Corners& corners) { return enclosed(corners, {}, cells::kFacetVertices); }

}  // namespace hexatlas::quality
