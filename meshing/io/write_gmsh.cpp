// Gmsh 2.2 and 4.1, ASCII. All cells of dimension 3 belong to volume 1, those of dimension 2 to
// surface 1; with version 4.1 those of each region to one of its own. All nodes belong to the first
// of the highest dimension. Tags are positions plus 1.
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

/// The regions of the cells of one dimension as tags of entities: themselves, but what Gmsh takes
/// for no tag is the least number left. None if there are no such cells.
class Entities {
 public:
  Entities(const CellsToWrite& cells, int dimension) {
    for (const CellList& list : cells.lists) {
      if (list.type.dimension != dimension) continue;
      if (list.regions.empty()) tags_[kOnly] = kOnly;
      for (const std::uint32_t region : list.regions) tags_[region] = region;
    }
    std::uint32_t next = 1;
    for (auto& [region, tag] : tags_) {
      if (region != 0 && region <= kMostTag) continue;
      while (tags_.contains(next)) ++next;
      tag = next++;
    }
  }
  static constexpr std::uint32_t kOnly = 1;  ///< of cells without regions
  /// By region.
  [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& tags() const { return tags_; }
  [[nodiscard]] std::uint32_t first_tag() const {
    return tags_.empty() ? kOnly : tags_.begin()->second;
  }

 private:
  static constexpr std::uint32_t kMostTag = std::numeric_limits<std::int32_t>::max();
  std::map<std::uint32_t, std::uint32_t> tags_;
};

/// Those of each dimension that cells have.
class AllEntities {
 public:
  explicit AllEntities(const CellsToWrite& cells) : surfaces(cells, 2), volumes(cells, 3) {}
  Entities surfaces, volumes;

  [[nodiscard]] const Entities& of(int dimension) const {
    return dimension == 3 ? volumes : surfaces;
  }
};

void put_entities(const CellsToWrite& cells, const AllEntities& entities, Output& out) {
  mesh::Point least, most;
  if (!cells.points.empty()) least = most = cells.points[0];
  for (const mesh::Point& point : cells.points) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y), std::min(least.z, point.z)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y), std::max(most.z, point.z)};
  }
  const auto& surfaces = entities.surfaces.tags();
  out.put("$Entities\n0 0 ", surfaces.size(), " ", entities.volumes.tags().size(), "\n");
  // tag, box, number of physical groups, number of bounding entities and these.
  for (const auto& [region, tag] : surfaces) out.put(tag, " ", least, " ", most, " 0 0\n");
  for (const auto& [region, tag] : entities.volumes.tags()) {
    out.put(tag, " ", least, " ", most, " 0 ", surfaces.size());
    for (const auto& [colour, surface] : surfaces) out.put(" ", surface);
    out.put("\n");
  }
  out.put("$EndEntities\n");
}

void put_nodes(const CellsToWrite& cells, const AllEntities& entities, Output& out) {
  const std::size_t count = cells.points.size();
  const int dimension = entities.volumes.tags().empty() ? 2 : 3;
  out.put("$Nodes\n1 ", count, " 1 ", count, "\n");
  out.put(dimension, " ", entities.of(dimension).first_tag(), " 0 ", count, "\n");
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

std::vector<Block> blocks_of(const CellsToWrite& cells, const AllEntities& entities) {
  std::vector<Block> blocks;
  for (const CellList& list : cells.lists) {
    std::map<std::uint32_t, std::vector<std::size_t>> by_region;
    for (std::size_t i = 0; i < list.size(); ++i)
      by_region[list.regions.empty() ? Entities::kOnly : list.regions[i]].push_back(i);
    for (auto& [region, some] : by_region)
      blocks.push_back(
          {&list, entities.of(list.type.dimension).tags().at(region), std::move(some)});
  }
  return blocks;
}

void put_elements(const CellsToWrite& cells, const AllEntities& entities, Output& out) {
  const std::vector<Block> blocks = blocks_of(cells, entities);
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
  const AllEntities entities(cells);
  put_entities(cells, entities, out);
  put_nodes(cells, entities, out);
  put_elements(cells, entities, out);
}

}  // namespace hexatlas::io
