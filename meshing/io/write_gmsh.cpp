// Gmsh 2.2 and 4.1, ASCII. All cells of dimension 3 belong to volume 1, with version 4.1 those of
// each region to one of its own; all nodes to the first, all quads to surface 1. Tags are positions
// plus 1.
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

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

/// The regions as tags of volumes: themselves, but what Gmsh takes for no tag is the least number
/// left.
class Volumes {
 public:
  explicit Volumes(const CellsToWrite& cells) {
    for (const CellList& list : cells.lists)
      for (const std::uint32_t region : list.regions) tags_[region] = region;
    if (tags_.empty()) tags_[1] = 1;
    std::uint32_t next = 1;
    for (auto& [region, tag] : tags_) {
      if (region != 0 && region <= kMostTag) continue;
      while (tags_.contains(next)) ++next;
      tag = next++;
    }
  }
  [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& tags() const { return tags_; }
  [[nodiscard]] std::uint32_t tag(std::uint32_t region) const { return tags_.at(region); }
  [[nodiscard]] std::uint32_t first_tag() const { return tags_.begin()->second; }

 private:
  static constexpr std::uint32_t kMostTag = std::numeric_limits<std::int32_t>::max();
  std::map<std::uint32_t, std::uint32_t> tags_;  ///< by region
};

void put_entities(const CellsToWrite& cells, const Volumes& volumes, Output& out) {
  mesh::Point least, most;
  if (!cells.points.empty()) least = most = cells.points[0];
  for (const mesh::Point& point : cells.points) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y), std::min(least.z, point.z)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y), std::max(most.z, point.z)};
  }
  const bool has_surface = has_dimension(cells, 2), has_volume = has_dimension(cells, 3);
  out.put("$Entities\n0 0 ", has_surface ? "1 " : "0 ", has_volume ? volumes.tags().size() : 0,
          "\n");
  // tag, box, number of physical groups, number of bounding entities and these.
  if (has_surface) out.put("1 ", least, " ", most, " 0 0\n");
  if (has_volume)
    for (const auto& [region, tag] : volumes.tags())
      out.put(tag, " ", least, " ", most, has_surface ? " 0 1 1\n" : " 0 0\n");
  out.put("$EndEntities\n");
}

void put_nodes(const CellsToWrite& cells, const Volumes& volumes, Output& out) {
  const std::size_t count = cells.points.size();
  out.put("$Nodes\n1 ", count, " 1 ", count, "\n");
  if (has_dimension(cells, 3))
    out.put("3 ", volumes.first_tag());
  else
    out.put("2 1");
  out.put(" 0 ", count, "\n");
  for (std::uint64_t tag = 1; tag <= count; ++tag) out.put(tag, "\n");
  for (const mesh::Point& point : cells.points) out.put(point, "\n");
  out.put("$EndNodes\n");
}

/// The cells of a list in one entity.
struct Block {
  const CellList* list;
  std::uint32_t entity;
  std::vector<std::size_t> cells;
};

std::vector<Block> blocks_of(const CellsToWrite& cells, const Volumes& volumes) {
  std::vector<Block> blocks;
  for (const CellList& list : cells.lists) {
    std::map<std::uint32_t, std::vector<std::size_t>> by_region;
    for (std::size_t i = 0; i < list.size(); ++i)
      by_region[list.regions.empty() ? 1 : list.regions[i]].push_back(i);
    for (auto& [region, some] : by_region)
      blocks.push_back({&list, volumes.tag(region), std::move(some)});
  }
  return blocks;
}

void put_elements(const CellsToWrite& cells, const Volumes& volumes, Output& out) {
  const std::vector<Block> blocks = blocks_of(cells, volumes);
  const std::size_t count = cells.cell_count();
  out.put("$Elements\n", blocks.size(), " ", count, " 1 ", count, "\n");
  std::uint64_t tag = 0;
  for (const Block& block : blocks) {
    const CellList& list = *block.list;
    out.put(list.type.dimension, " ", block.entity, " ", list.type.gmsh, " ", block.cells.size(),
            "\n");
    for (const std::size_t i : block.cells) {
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
  const Volumes volumes(cells);
  put_entities(cells, volumes, out);
  put_nodes(cells, volumes, out);
  put_elements(cells, volumes, out);
}

}  // namespace hexatlas::io
