#pragma once
/// \file
/// Meshes made larger at random, with the boundary kept: what simplification is tried on.

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "meshing/simplify/cavity.hpp"
#include "meshing/simplify/edited_mesh.hpp"
#include "meshing/simplify/known_balls.hpp"

namespace hexatlas::support {

/// The cavity wrapped in a layer inside of its boundary: each vertex of the boundary is doubled,
/// each quad becomes a hexahedron between the two copies. It obeys the strict rule
/// (docs/theory/proofs/front.md, section 4).
inline simplify::Exchange wrapped(const complex::HexComplex& mesh, const flips::SubBall& ball) {
  simplify::Exchange result{ball.cells(), {}};
  complex::HexComplex inner{mesh.vertices, {}};
  for (const std::uint32_t cell : ball.cells()) inner.hexahedra.push_back(mesh.hexahedra[cell]);
  const auto quads = complex::boundary_of(inner);
  std::map<complex::VertexId, complex::VertexId> copy;
  for (const auto& quad : quads)
    for (const complex::VertexId v : quad)
      copy.try_emplace(v, static_cast<complex::VertexId>(mesh.vertices + copy.size()));
  result.instead = inner.hexahedra;
  for (auto& cell : result.instead)
    for (complex::VertexId& v : cell)
      if (const auto at = copy.find(v); at != copy.end()) v = at->second;
  for (const auto& q : quads) {  // counter-clockwise from outside: at the top, axes right-handed
    const auto c = [&](std::size_t i) { return copy.at(q[i]); };
    result.instead.push_back({c(0), c(1), c(3), c(2), q[0], q[1], q[3], q[2]});
  }
  return result;
}

/// The mesh with at least so many hexahedra: random cavities are wrapped, and in between others
/// exchanged for balls that were seen or are small, whatever their number of hexahedra, so that the
/// layers are no longer there as such. The vertices of the boundary, which come first, stay.
inline complex::HexComplex blown_up(const complex::HexComplex& mesh, int hexahedra,
                                    std::uint64_t seed, int mixing) {
  const auto kept = static_cast<int>(complex::boundary_of(mesh).size()) + 2;
  core::Random random(seed);
  simplify::KnownBalls known(nullptr);
  simplify::EditedMesh edited(mesh);
  simplify::Cavity cavity(edited, known);
  while (edited.size() < hexahedra) {
    cavity.restart(random);
    for (std::size_t left = random.below(16); left > 0 && cavity.grow(random);) --left;
    edited.make(wrapped(edited.mesh(), cavity.ball()));
    for (int step = 0; step < mixing; ++step) {
      cavity.restart(random);
      for (std::size_t left = 1 + random.below(12); left > 0 && cavity.grow(random);) --left;
      const auto fits = cavity.fits(cavity.size() + 2);
      if (!fits.empty())
        edited.make(cavity.exchange_for(fits[random.below(fits.size())]));
      else
        cavity.remember(random);
    }
  }
  return complex::compacted(edited.mesh(), kept);
}

}  // namespace hexatlas::support
