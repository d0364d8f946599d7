#include "meshing/simplify/small_meshes.hpp"

#include <utility>

#include "enum/core/checks.hpp"
#include "enum/hexes/search.hpp"
#include "enum/search/depth_first.hpp"

namespace hexatlas::simplify {

SmallMeshes small_meshes(const complex::Quadrangulation& boundary, int max_hexahedra,
                         std::uint64_t max_nodes) {
  constexpr std::size_t kEnough = 256;  // meshes of one boundary
  core::expects(max_hexahedra <= kMaxSmallMesh, "a small mesh has at most 8 hexahedra");
  hexes::HexSearch problem(
      boundary, {.max_hexahedra = max_hexahedra,
                 .max_interior = hexes::most_interior_vertices(boundary.quads(), max_hexahedra),
                 .ball = true});
  SmallMeshes result;
  const auto explored =
      search::explore(problem, {}, {.nodes = max_nodes}, [&](const hexes::HexSearch& complete) {
        complex::HexComplex mesh = hexes::complex_of(complete.mesh());
        if (!complex::validate(mesh) && complex::shelling_of(mesh))
          result.meshes.push_back(std::move(mesh));
        return result.meshes.size() < kEnough;
      });
  result.is_all = explored.is_proof();
  return result;
}

}  // namespace hexatlas::simplify
