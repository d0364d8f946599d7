#pragma once
/// \file
/// Valid tables for the tests of the judge.

#include "tables/check/file_bytes.hpp"
#include "tables/check/table_layout.hpp"
#include "tables/check/zstd_frame.hpp"
#include "tests/sabotage/table_writer.hpp"

namespace hexatlas::check::sabotage {

struct SampleTable {
  std::vector<TableEntry> entries;
  std::vector<Name> names;
  std::size_t per_block = 1;
  std::uint32_t complete_through = 0;

  [[nodiscard]] std::string bytes(Parts& parts) const {
    return write_table(entries, names, per_block, complete_through, parts);
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

/// The entries with at most `most_quads` quads of the table in a file, which must be all there are, as a
/// table that claims so. Read as the specification says, without a look at what is not needed.
inline SampleTable complete_table(const std::string& path, std::uint32_t most_quads) {
  const std::string bytes = bytes_of_file(path);
  SampleTable table;
  table.per_block = 8;
  table.complete_through = most_quads;
  std::uint64_t at = number_at(bytes, 48, 8);
  for (std::uint64_t s = 0; s < number_at(bytes, 32, 4); ++s) {
    const auto quads = static_cast<unsigned>(number_at(bytes, 128 + 32 * s, 4));
    for (std::uint64_t i = 0; i < number_at(bytes, 128 + 32 * s + 16, 8); ++i) {
      const std::uint64_t key = (quads + 1) / 2;
      const auto field = [&](std::uint64_t f) {
        return static_cast<std::uint32_t>(number_at(bytes, at + key + 2 * f, 2));
      };
      if (quads > most_quads) continue;
      table.entries.push_back({quads, bytes.substr(at, key), field(0), field(1), field(2), ""});
      at += key + 8;
    }
  }
  const std::uint64_t per_block = number_at(bytes, 44, 4);
  const std::uint64_t directory = number_at(bytes, 56, 8);
  const std::uint64_t all = number_at(bytes, 24, 8);
  for (std::size_t first = 0; first < table.entries.size(); first += per_block) {
    const std::uint64_t block = directory + first / per_block * 16;
    std::string raw;
    const bool unpacked = unpack_frame(
        std::string_view(bytes).substr(number_at(bytes, block, 8), number_at(bytes, block + 8, 4)),
        number_at(bytes, block + 12, 4), raw);
    if (!unpacked) throw std::runtime_error("a block of the table cannot be unpacked");
    const std::size_t records = std::min<std::size_t>(per_block, all - first);
    std::size_t from = 4 * records;
    for (std::size_t r = 0; r < records && first + r < table.entries.size(); ++r) {
      const std::size_t length = number_at(raw, 4 * r, 4);
      table.entries[first + r].payload = raw.substr(from, length);
      from += length;
    }
  }
  return table;
}

}  // namespace hexatlas::check::sabotage
