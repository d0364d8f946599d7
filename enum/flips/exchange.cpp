#include "enum/flips/exchange.hpp"

#include <vector>

namespace hexatlas::flips {

using complex::HexComplex;
using complex::Vertex;
using complex::VertexId;

HexComplex exchanged(const HexComplex& mesh, std::span<const std::uint32_t> taken_out,
                     const Layers& layers, std::span<const VertexId> rim, bool is_mirrored) {
  std::vector<bool> is_out(mesh.hexahedra.size());
  for (const std::uint32_t cell : taken_out) is_out[cell] = true;
  HexComplex result{mesh.vertices, {}};
  for (std::size_t cell = 0; cell < mesh.hexahedra.size(); ++cell)
    if (!is_out[cell]) result.hexahedra.push_back(mesh.hexahedra[cell]);
  append_ball(result, layers, rim, is_mirrored);
  return result;
}

HexComplex exchanged(const HexComplex& mesh, const SubBall& ball, const Layers& layers,
                     const Fit& found) {
  const auto vertices = static_cast<std::size_t>(ball.front().boundary.vertices());
  std::vector<VertexId> rim(vertices);
  for (std::size_t v = 0; v < vertices; ++v) rim[found.label[v]] = ball.rim(static_cast<Vertex>(v));
  return exchanged(mesh, ball.cells(), layers, rim, found.is_mirrored);
}

}  // namespace hexatlas::flips
