#include "enum/flips/exchange.hpp"

#include <vector>

namespace hexatlas::flips {

using complex::HexComplex;
using complex::Vertex;
using complex::VertexId;

HexComplex exchanged(const HexComplex& mesh, const SubBall& ball, const Layers& layers,
                     const Fit& found) {
  HexComplex result{mesh.vertices, {}};
  for (std::uint32_t cell = 0; cell < mesh.hexahedra.size(); ++cell)
    if (!ball.contains(cell)) result.hexahedra.push_back(mesh.hexahedra[cell]);
  const auto vertices = static_cast<std::size_t>(ball.front().boundary.vertices());
  std::vector<VertexId> rim(vertices);
  for (std::size_t v = 0; v < vertices; ++v) rim[found.label[v]] = ball.rim(static_cast<Vertex>(v));
  append_ball(result, layers, rim, found.is_mirrored);
  return result;
}

}  // namespace hexatlas::flips
