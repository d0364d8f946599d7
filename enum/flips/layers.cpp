#include <numeric>

#include "enum/cells/cube.hpp"
#include "enum/flips/beam.hpp"

namespace hexatlas::flips {

Layers layers_along(const Beam& beam, FrontId id, Growth growth) {
  const auto path = beam.path_to(id);
  Layers result;
  const FrontId start = path.empty() ? id : path.front().from;
  const Front first = front_of(beam.state(start));
  result.vertices = static_cast<std::uint32_t>(first.boundary.vertices());
  result.rim.resize(result.vertices);
  std::iota(result.rim.begin(), result.rim.end(), 0U);
  if (growth == Growth::outward) {
    // The canonical list of the cube, decoded: bottom is its first quad.
    const auto prism = prism_of(first.boundary, {0, 15}).value();
    complex::Hexahedron cell{};
    for (std::size_t i = 0; i < 4; ++i) {
      cell[cells::kCornerOfPrism[i]] = prism.bottom[i];
      cell[cells::kCornerOfPrism[4 + i]] = prism.top[i];
    }
    result.hexahedra.push_back(cell);
  }
  for (const auto& [from, flip] : path) {
    const Front front = front_of(beam.state(from));
    const auto prism = prism_of(front.boundary, flip).value();
    const Glued next = glued(front, flip, prism);
    const CanonicalState canonical = canonical_state(next.front);
    std::vector<std::uint32_t> rim(static_cast<std::size_t>(next.front.boundary.vertices()));
    complex::Hexahedron cell{};
    for (std::size_t v = 0; v < rim.size(); ++v) {
      const complex::Vertex former = next.flipped.former[v];
      rim[canonical.label[v]] = former == kNewVertex ? result.vertices++ : result.rim[former];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t bottom = result.rim[prism.bottom[i]];
      const std::uint32_t top = rim[canonical.label[next.flipped.top[i]]];
      const bool inward = growth == Growth::inward;
      cell[cells::kCornerOfPrism[i]] = inward ? bottom : top;
      cell[cells::kCornerOfPrism[4 + i]] = inward ? top : bottom;
    }
    if (result.is_mirrored) cells::exchange_axes(cell);
    result.hexahedra.push_back(cell);
    result.rim = std::move(rim);
    result.is_mirrored = result.is_mirrored != canonical.is_mirrored;
  }
  return result;
}

void append_ball(complex::HexComplex& mesh, const Layers& ball,
                 std::span<const complex::VertexId> rim, bool is_mirrored) {
  constexpr complex::VertexId kInterior = 0xFFFFFFFF;
  std::vector<complex::VertexId> number(ball.vertices, kInterior);
  for (std::size_t v = 0; v < ball.rim.size(); ++v) number[ball.rim[v]] = rim[v];
  for (complex::VertexId& n : number)
    if (n == kInterior) n = mesh.vertices++;
  for (auto cell = ball.hexahedra.rbegin(); cell != ball.hexahedra.rend(); ++cell) {
    complex::Hexahedron moved = *cell;
    for (complex::VertexId& v : moved) v = number[v];
    if (ball.is_mirrored != is_mirrored) cells::exchange_axes(moved);
    mesh.hexahedra.push_back(moved);
  }
}

}  // namespace hexatlas::flips
