#include "meshing/hexahedrize/placing.hpp"

#include <algorithm>
#include <vector>

#include "enum/core/checks.hpp"

namespace hexatlas::hexahedrize {

void place(mesh::HexMesh& mesh, std::size_t first_free, const untangle::Options& options) {
  core::expects(first_free <= mesh.points.size(), "place: more fixed points than points");
  untangle::Mesh given{{}, mesh.hexahedra, std::vector<std::uint8_t>(mesh.points.size(), 1)};
  for (const mesh::Point& p : mesh.points) given.points.push_back({p.x, p.y, p.z});
  std::fill_n(given.is_free.begin(), first_free, std::uint8_t{0});
  const std::vector<exact::Point3> placed = untangle::untangled(given, options);
  for (std::size_t v = first_free; v < placed.size(); ++v)
    mesh.points[v] = {placed[v].x, placed[v].y, placed[v].z};
}

}  // namespace hexatlas::hexahedrize
