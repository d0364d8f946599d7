// Gmsh 2.2 and 4.1, ASCII. All nodes and hexahedra belong to volume 1, all quads to surface 1;
// tags are positions plus 1.
#include <algorithm>

#include "meshing/io/cell_types.hpp"
#include "meshing/io/text.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

void append_format(std::string& text, const char* version) {
  text += std::string("$MeshFormat\n") + version + " 0 8\n$EndMeshFormat\n";
}

std::string write_version_2(const CellsToWrite& cells) {
  std::string text;
  append_format(text, "2.2");
  text += "$Nodes\n" + std::to_string(cells.points.size()) + "\n";
  std::uint64_t tag = 0;
  for (const mesh::Point& point : cells.points) {
    append(text, ++tag);
    text += ' ';
    append(text, point);
    text += '\n';
  }
  text +=
      "$EndNodes\n$Elements\n" + std::to_string(cells.quads.size() + cells.hexahedra.size()) + "\n";
  tag = 0;
  const auto append_elements = [&](const auto& elements, int type) {
    for (const auto& element : elements) {
      append(text, ++tag);
      // Two tags: physical group 0 (none), elementary entity 1.
      text += " " + std::to_string(type) + " 2 0 1 ";
      append(text, element, 1);
      text += '\n';
    }
  };
  append_elements(cells.quads, kGmshQuad);
  append_elements(cells.hexahedra, kGmshHexahedron);
  return text + "$EndElements\n";
}

/// "minX minY minZ maxX maxY maxZ" of the points.
std::string bounding_box(std::span<const mesh::Point> points) {
  mesh::Point least, most;
  if (!points.empty()) least = most = points[0];
  for (const mesh::Point& point : points) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y), std::min(least.z, point.z)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y), std::max(most.z, point.z)};
  }
  std::string text;
  append(text, least);
  text += ' ';
  append(text, most);
  return text;
}

void append_entities(std::string& text, const CellsToWrite& cells) {
  const std::string box = bounding_box(cells.points);
  const bool has_surface = !cells.quads.empty(), has_volume = !cells.hexahedra.empty();
  text += std::string("$Entities\n0 0 ") + (has_surface ? "1 " : "0 ") + (has_volume ? "1" : "0") +
          "\n";
  // tag, box, number of physical groups, number of bounding entities and these.
  if (has_surface) text += "1 " + box + " 0 0\n";
  if (has_volume) text += "1 " + box + (has_surface ? " 0 1 1\n" : " 0 0\n");
  text += "$EndEntities\n";
}

void append_nodes(std::string& text, const CellsToWrite& cells) {
  const std::string count = std::to_string(cells.points.size());
  text += "$Nodes\n1 " + count + " 1 " + count + "\n";
  text += (cells.hexahedra.empty() ? "2 1 0 " : "3 1 0 ") + count + "\n";
  for (std::uint64_t tag = 1; tag <= cells.points.size(); ++tag) {
    append(text, tag);
    text += '\n';
  }
  for (const mesh::Point& point : cells.points) {
    append(text, point);
    text += '\n';
  }
  text += "$EndNodes\n";
}

void append_elements(std::string& text, const CellsToWrite& cells) {
  const std::string count = std::to_string(cells.quads.size() + cells.hexahedra.size());
  const int blocks = (cells.quads.empty() ? 0 : 1) + (cells.hexahedra.empty() ? 0 : 1);
  text += "$Elements\n" + std::to_string(blocks) + " " + count + " 1 " + count + "\n";
  std::uint64_t tag = 0;
  const auto append_block = [&](const auto& elements, int dimension, int type) {
    if (elements.empty()) return;
    text += std::to_string(dimension) + " 1 " + std::to_string(type) + " " +
            std::to_string(elements.size()) + "\n";
    for (const auto& element : elements) {
      append(text, ++tag);
      text += ' ';
      append(text, element, 1);
      text += '\n';
    }
  };
  append_block(cells.quads, 2, kGmshQuad);
  append_block(cells.hexahedra, 3, kGmshHexahedron);
  text += "$EndElements\n";
}

std::string write_version_4(const CellsToWrite& cells) {
  std::string text;
  append_format(text, "4.1");
  append_entities(text, cells);
  append_nodes(text, cells);
  append_elements(text, cells);
  return text;
}

}  // namespace

std::string write_gmsh(const CellsToWrite& cells, GmshVersion version) {
  return version == GmshVersion::v2_2 ? write_version_2(cells) : write_version_4(cells);
}

}  // namespace hexatlas::io
