#pragma once
/// \file
/// Valid tables for the tests of the judge.

#include "tests/sabotage/table_writer.hpp"

namespace hexatlas::check::sabotage {

struct SampleTable {
  std::vector<TableEntry> entries;
  std::vector<Name> names;
  std::size_t per_block = 1;

  [[nodiscard]] std::string bytes(Parts& parts) const {
    return write_table(entries, names, per_block, parts);
  }
  [[nodiscard]] std::string bytes() const {
    Parts parts;
    return bytes(parts);
  }
};

/// The cube, two stacked cubes, the three meshes of three cubes, and larger boxes.
inline std::vector<examples::Example> sample_meshes() {
  using examples::box;
  using examples::cubes;
  return {cubes(box(1, 1, 1)),
          cubes(box(2, 1, 1)),
          cubes(box(3, 1, 1)),
          cubes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}),
          examples::three_around_an_edge(),
          cubes(box(2, 2, 1)),
          cubes(box(3, 2, 1)),
          cubes(box(2, 2, 2)),
          cubes(box(3, 3, 3))};
}

/// Encodings alternate; `first_flips` says which one comes first.
inline SampleTable sample_table(bool first_flips, std::size_t per_block) {
  SampleTable table;
  bool flips = first_flips;
  for (const auto& example : sample_meshes()) {
    table.entries.push_back(entry_of(example, flips));
    flips = !flips;
  }
  std::sort(table.entries.begin(), table.entries.end(), in_order);
  table.entries.front().lower_bound = table.entries.front().hexahedra;
  table.names = {{0, "cube"}, {8, "cube-27"}, {0, "hexahedron"}};
  table.per_block = per_block;
  return table;
}

/// One entry: a cube in a cube, 7 hexahedra and 8 interior vertices.
inline SampleTable nested_table(bool flips) {
  examples::Example example = examples::cube_in_cube();
  std::rotate(example.mesh.hexahedra.begin(), example.mesh.hexahedra.begin() + 1,
              example.mesh.hexahedra.end());  // the inner cube is taken off last
  SampleTable table;
  table.entries = {entry_of(example, flips)};
  table.per_block = 4;
  return table;
}

}  // namespace hexatlas::check::sabotage
