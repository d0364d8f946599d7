// Tetrahedra in binary: docs/formats/hxtet.md.
#include "meshing/io/hxtet.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {

static_assert(sizeof(mesh::Point) == kHxtetPointBytes, "points are written as they lie in memory");

void write_hxtet(const CellsToWrite& cells, Output& out) {
  out.put(kHxtetMagic);
  out.put_binary(std::uint64_t{cells.points.size()});
  out.put_binary(std::uint64_t{cells.cell_count()});
  out.put_memory(cells.points);
  for (const CellList& list : cells.lists) out.put_memory(list.all_corners());
}

}  // namespace hexatlas::io
