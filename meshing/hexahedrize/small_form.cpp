#include "meshing/hexahedrize/small_form.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "enum/cells/cube.hpp"

namespace hexatlas::hexahedrize {

std::optional<complex::Quadrangulation> small_form(const complex::QuadSphere& sphere) {
  if (sphere.quads.size() > complex::kMaxQuads) return std::nullopt;
  std::vector<complex::QuadVertices> quads;
  for (const auto& quad : sphere.quads) {
    complex::QuadVertices small{};
    std::transform(quad.begin(), quad.end(), small.begin(),
                   [](complex::VertexId v) { return static_cast<complex::Vertex>(v); });
    quads.push_back(small);
  }
  return complex::Quadrangulation::from_quads(quads);
}

complex::HexComplex carried_over(complex::HexComplex mesh, const canon::CanonicalForm& form,
                                 std::size_t boundary_vertices) {
  std::vector<complex::VertexId> vertex(mesh.vertices);
  for (std::uint32_t v = 0; v < mesh.vertices; ++v) vertex[v] = v;
  for (std::uint32_t v = 0; v < boundary_vertices; ++v) vertex[form.label[v]] = v;
  for (auto& cell : mesh.hexahedra) {
    for (auto& v : cell) v = vertex[v];
    if (form.is_mirrored) cells::exchange_axes(cell);  // a mirror image, right-handed again
  }
  return mesh;
}

}  // namespace hexatlas::hexahedrize
