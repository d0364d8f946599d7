#include "meshing/simplify/cavity.hpp"

#include <algorithm>
#include <utility>

#include "enum/cells/cube.hpp"

namespace hexatlas::simplify {

using complex::VertexId;

Cavity::Cavity(const EditedMesh& mesh, KnownBalls& known, const Pairs* apart)
    : mesh_(mesh),
      known_(known),
      apart_(apart),
      ball_(mesh.mesh(), mesh.neighbours(), 0, flips::kMaxSearchQuads) {}

void Cavity::restart(core::Random& random) {
  weight_ = 1 << random.below(4);
  ball_.restart(static_cast<std::uint32_t>(random.below(mesh_.mesh().hexahedra.size())));
}

/// Of the pairs of boundary vertices those that may not be related inside, or are not by scars.
flips::Relation Cavity::related_outside() const {
  flips::Relation related = ball_.related_outside(mesh_.cells_at());
  if (apart_ == nullptr) return related;
  for (const auto& [a, b] : *apart_) {
    const complex::Vertex u = ball_.boundary_vertex(a);
    const complex::Vertex v = ball_.boundary_vertex(b);
    if (u == flips::kNewVertex || v == flips::kNewVertex) continue;
    related[u] |= flips::bit(v);
    related[v] |= flips::bit(u);
  }
  return related;
}

std::vector<Fit> Cavity::fits(int most) {
  const complex::Quadrangulation& boundary = ball_.front().boundary;
  canon::canonical_flags(boundary, flags_);
  const canon::Flag first = flags_.flags[0];
  own_ = ball_at(ball_, mesh_.mesh(), canon::labelling_from(boundary, first), first.mirrored);
  const std::vector<Ball>& known = known_.with(flags_.code, size());
  if (std::none_of(known.begin(), known.end(),
                   [most](const Ball& ball) { return ball.hexahedra() <= most; }))
    return {};
  const auto positions = flips::positions_of(boundary, flags_, related_outside());
  std::vector<Fit> result;
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (const Ball& ball : known) {
      const bool is_as_it_is = i == 0 && ball.shape == own_.shape;
      if (ball.hexahedra() <= most && !is_as_it_is &&
          ball.scars.is_disjoint_from(positions[i].scars))
        result.push_back({&ball, positions[i]});
    }
  return result;
}

Exchange Cavity::exchange_for(const Fit& fit) const {
  const auto rim = static_cast<std::size_t>(ball_.front().boundary.vertices());
  std::vector<VertexId> vertex(fit.ball->mesh.vertices);
  for (std::size_t v = 0; v < rim; ++v)
    vertex[fit.position.label[v]] = ball_.rim(static_cast<complex::Vertex>(v));
  for (std::size_t v = rim; v < vertex.size(); ++v)
    vertex[v] = static_cast<VertexId>(mesh_.mesh().vertices + v - rim);
  Exchange result{ball_.cells(), fit.ball->mesh.hexahedra};
  for (complex::Hexahedron& cell : result.instead) {
    for (VertexId& v : cell) v = vertex[v];
    if (fit.position.is_mirrored) cells::exchange_axes(cell);
  }
  return result;
}

void Cavity::remember(core::Random& random) {
  known_.add(flags_.code, std::move(own_), random.number());
}

}  // namespace hexatlas::simplify
