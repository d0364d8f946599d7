#pragma once
/// \file
/// A mesh on a sphere, as the judge of tables/check sees it, which shares no code with meshers.

#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quad_surface.hpp"
#include "tables/check/mesh_check.hpp"

namespace hexatlas::support {

inline check::Verdict judged(const complex::HexComplex& mesh, const complex::QuadSphere& sphere) {
  check::Mesh shown{std::vector<check::Point>(mesh.vertices), {}, {}};
  for (const auto& h : mesh.hexahedra)  // bottom and top quads, cyclically
    shown.hexahedra.push_back({h[0], h[1], h[3], h[2], h[4], h[5], h[7], h[6]});
  const check::Surface surface{std::vector<check::Point>(sphere.vertices()),
                               {sphere.quads.begin(), sphere.quads.end()}};
  return check::check_mesh(shown, &surface);
}

}  // namespace hexatlas::support
