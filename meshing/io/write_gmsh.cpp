// Gmsh 2.2 and 4.1, ASCII. All nodes and cells of dimension 3 belong to volume 1, all quads to
// surface 1; tags are positions plus 1.
#include <algorithm>

#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

void put_format(Output& out, const char* version) {
  out.put("$MeshFormat\n", version, " 0 8\n$EndMeshFormat\n");
}

void write_version_2(const CellsToWrite& cells, Output& out) {
  put_format(out, "2.2");
  out.put("$Nodes\n", cells.points.size(), "\n");
  std::uint64_t tag = 0;
  for (const mesh::Point& point : cells.points) out.put(++tag, " ", point, "\n");
  out.put("$EndNodes\n$Elements\n", cells.cell_count(), "\n");
  tag = 0;
  for (const CellList& list : cells.lists)
    for (std::size_t i = 0; i < list.size(); ++i) {
      // Two tags: physical group 0 (none), elementary entity 1.
      out.put(++tag, " ", list.type.gmsh, " 2 0 1 ");
      out.put_indices(list[i], 1);
      out.put("\n");
    }
  out.put("$EndElements\n");
}

bool has_dimension(const CellsToWrite& cells, int dimension) {
  return std::any_of(cells.lists.begin(), cells.lists.end(),
                     [&](const CellList& list) { return list.type.dimension == dimension; });
}

void put_entities(const CellsToWrite& cells, Output& out) {
  mesh::Point least, most;
  if (!cells.points.empty()) least = most = cells.points[0];
  for (const mesh::Point& point : cells.points) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y), std::min(least.z, point.z)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y), std::max(most.z, point.z)};
  }
  const bool has_surface = has_dimension(cells, 2), has_volume = has_dimension(cells, 3);
  out.put("$Entities\n0 0 ", has_surface ? "1 " : "0 ", has_volume ? "1" : "0", "\n");
  // tag, box, number of physical groups, number of bounding entities and these.
  if (has_surface) out.put("1 ", least, " ", most, " 0 0\n");
  if (has_volume) out.put("1 ", least, " ", most, has_surface ? " 0 1 1\n" : " 0 0\n");
  out.put("$EndEntities\n");
}

void put_nodes(const CellsToWrite& cells, Output& out) {
  const std::size_t count = cells.points.size();
  out.put("$Nodes\n1 ", count, " 1 ", count, "\n");
  out.put(has_dimension(cells, 3) ? "3 1 0 " : "2 1 0 ", count, "\n");
  for (std::uint64_t tag = 1; tag <= count; ++tag) out.put(tag, "\n");
  for (const mesh::Point& point : cells.points) out.put(point, "\n");
  out.put("$EndNodes\n");
}

void put_elements(const CellsToWrite& cells, Output& out) {
  const std::size_t count = cells.cell_count();
  out.put("$Elements\n", cells.lists.size(), " ", count, " 1 ", count, "\n");
  std::uint64_t tag = 0;
  for (const CellList& list : cells.lists) {
    out.put(list.type.dimension, " 1 ", list.type.gmsh, " ", list.size(), "\n");
    for (std::size_t i = 0; i < list.size(); ++i) {
      out.put(++tag, " ");
      out.put_indices(list[i], 1);
      out.put("\n");
    }
  }
  out.put("$EndElements\n");
}

}  // namespace

void write_gmsh(const CellsToWrite& cells, GmshVersion version, Output& out) {
  if (version == GmshVersion::v2_2) return write_version_2(cells, out);
  put_format(out, "4.1");
  put_entities(cells, out);
  put_nodes(cells, out);
  put_elements(cells, out);
}

}  // namespace hexatlas::io
