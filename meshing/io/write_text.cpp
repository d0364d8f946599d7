// OBJ, OFF and MEDIT: lists of points and cells, one per line.
#include "meshing/io/text.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

void append_points(std::string& text, const CellsToWrite& cells, const char* before,
                   const char* after) {
  for (const mesh::Point& point : cells.points) {
    text += before;
    append(text, point);
    text += after;
  }
}

template <class Cells>
void append_cells(std::string& text, const Cells& cells, const char* before, unsigned base,
                  const char* after) {
  for (const auto& cell : cells) {
    text += before;
    append(text, cell, base);
    text += after;
  }
}

void append_count(std::string& text, const char* before, std::size_t count, const char* after) {
  text += before;
  append(text, std::uint64_t{count});
  text += after;
}

}  // namespace

std::string write_obj(const CellsToWrite& cells) {
  std::string text;
  append_points(text, cells, "v ", "\n");
  append_cells(text, cells.quads, "f ", 1, "\n");
  return text;
}

std::string write_off(const CellsToWrite& cells) {
  std::string text = "OFF\n";
  append_count(text, "", cells.points.size(), " ");
  append_count(text, "", cells.quads.size(), " 0\n");
  append_points(text, cells, "", "\n");
  append_cells(text, cells.quads, "4 ", 0, "\n");
  return text;
}

std::string write_medit(const CellsToWrite& cells) {
  // Version 2: coordinates in double precision. Each row ends with a reference, here 0.
  std::string text = "MeshVersionFormatted 2\nDimension 3\n";
  append_count(text, "Vertices\n", cells.points.size(), "\n");
  append_points(text, cells, "", " 0\n");
  if (!cells.quads.empty()) {
    append_count(text, "Quadrilaterals\n", cells.quads.size(), "\n");
    append_cells(text, cells.quads, "", 1, " 0\n");
  }
  if (!cells.hexahedra.empty()) {
    append_count(text, "Hexahedra\n", cells.hexahedra.size(), "\n");
    append_cells(text, cells.hexahedra, "", 1, " 0\n");
  }
  return text + "End\n";
}

}  // namespace hexatlas::io
