// OBJ, OFF and MEDIT: lists of points and cells, one per line.
#include <string>

#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

void put_points(Output& out, const CellsToWrite& cells, const char* before, const char* after) {
  for (const mesh::Point& point : cells.points) out.put(before, point, after);
}

void put_cells(Output& out, const CellList& list, const char* before, unsigned base,
               const char* after) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    out.put(before);
    out.put_indices(list[i], base);
    out.put(after);
  }
}

}  // namespace

void write_obj(const CellsToWrite& cells, Output& out) {
  put_points(out, cells, "v ", "\n");
  for (const CellList& list : cells.lists) put_cells(out, list, "f ", 1, "\n");
}

void write_off(const CellsToWrite& cells, Output& out) {
  out.put("OFF\n", cells.points.size(), " ", cells.cell_count(), " 0\n");
  put_points(out, cells, "", "\n");
  for (const CellList& list : cells.lists)
    put_cells(out, list, (std::to_string(list.corners_each()) + " ").c_str(), 0, "\n");
}

void write_medit(const CellsToWrite& cells, Output& out) {
  // Version 2: coordinates in double precision. Each row ends with a reference, 0 if there is none.
  out.put("MeshVersionFormatted 2\nDimension 3\nVertices\n", cells.points.size(), "\n");
  put_points(out, cells, "", " 0\n");
  for (const CellList& list : cells.lists) {
    out.put(list.type.medit, "\n", list.size(), "\n");
    for (std::size_t i = 0; i < list.size(); ++i) {
      out.put_indices(list[i], 1);
      out.put(" ", list.regions.empty() ? 0 : list.regions[i], "\n");
    }
  }
  out.put("End\n");
}

}  // namespace hexatlas::io
