#pragma once
/// \file
/// The meshes of tables, replayed a second time for the tests of the judge, and judged by
/// slow_oracle.hpp.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/sabotage/slow_oracle.hpp"
#include "tests/sabotage/table_writer.hpp"

namespace hexatlas::check::sabotage {

/// A second replay of encoding 0, by edges: which quad follows the edge from a to b. Empty if a
/// step makes no sense.
inline std::vector<Hexahedron> second_replay(std::vector<Quad> quads, const std::string& payload) {
  std::vector<Hexahedron> cells;
  auto next = static_cast<std::uint32_t>(quads.size() + 2);
  std::string steps = payload.substr(1) + std::string("\0\x0f", 2);
  for (std::size_t s = 0; s < steps.size(); s += 2) {
    const auto place = static_cast<unsigned char>(steps[s]);
    const unsigned sides = static_cast<unsigned char>(steps[s + 1]);
    if (place >= quads.size() || sides > 15) return {};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::size_t>> at;
    for (std::size_t q = 0; q < quads.size(); ++q) {
      for (std::size_t i = 0; i < 4; ++i) at[{quads[q][i], quads[q][(i + 1) % 4]}] = {q, i};
    }
    const Quad b = quads[place];
    std::map<std::size_t, std::uint32_t> top;
    std::set<std::size_t> leaving = {place};
    for (std::size_t i = 0; i < 4; ++i) {
      if ((sides >> i & 1) == 0) continue;
      const auto found = at.find({b[(i + 1) % 4], b[i]});
      if (found == at.end()) return {};
      const auto [q, k] = found->second;
      leaving.insert(q);
      const bool first =
          top.emplace(i, quads[q][(k + 2) % 4]).first->second == quads[q][(k + 2) % 4];
      const std::size_t j = (i + 1) % 4;
      const bool second =
          top.emplace(j, quads[q][(k + 3) % 4]).first->second == quads[q][(k + 3) % 4];
      if (!first || !second) return {};
    }
    for (std::size_t j = 0; j < 4; ++j) {
      if (!top.contains(j)) top[j] = next++;
    }
    // b0 b3 b2 b1 is the bottom seen from above, counter-clockwise.
    cells.push_back({b[0], b[3], b[2], b[1], top[0], top[3], top[2], top[1]});
    std::vector<Quad> left;
    for (std::size_t q = 0; q < quads.size(); ++q) {
      if (!leaving.contains(q)) left.push_back(quads[q]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      if ((sides >> i & 1) == 0) left.push_back({b[i], b[j], top[j], top[i]});
    }
    left.push_back({top[0], top[1], top[2], top[3]});
    quads = left;
  }
  // The last step leaves the quad that it stands under, and its top, which is that quad reversed.
  if (quads.size() != 2) return {};
  return cells;
}

/// The hexahedra of an entry in either encoding. Empty if its payload makes no sense.
inline std::vector<Hexahedron> second_reading(const std::vector<Quad>& quads,
                                              const std::string& payload) {
  if (payload.empty() || payload.size() % 2 == 0) return {};
  if (payload[0] == 0) return second_replay(quads, payload);
  if (payload[0] != 1 || payload.size() % 16 != 1) return {};
  std::vector<Hexahedron> cells;
  for (std::size_t c = 1; c < payload.size(); c += 16) {
    Hexahedron& cell = cells.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t at = c + 2 * oracle::kBits[i];
      cell[i] = static_cast<unsigned char>(payload[at]) |
                static_cast<std::uint32_t>(static_cast<unsigned char>(payload[at + 1])) << 8;
    }
  }
  return cells;
}

/// Whether the payload is a mesh under the strict rule with the boundary of the key.
inline bool is_filling(const TableEntry& entry) {
  std::string reason;
  const auto quads = *decode_word(*word_of_key(entry.key, entry.quads), reason);
  const std::vector<Hexahedron> cells = second_reading(quads, entry.payload);
  return !cells.empty() && oracle::obeys_strict_rule(cells) && oracle::has_boundary(cells, quads);
}

/// The numbers of the index against the mesh.
inline bool has_true_numbers(const TableEntry& entry) {
  std::string reason;
  const auto quads = *decode_word(*word_of_key(entry.key, entry.quads), reason);
  const std::vector<Hexahedron> cells = second_reading(quads, entry.payload);
  oracle::VertexSet vertices;
  for (const Hexahedron& cell : cells) vertices.insert(cell.begin(), cell.end());
  return entry.hexahedra == cells.size() && entry.lower_bound >= 1 &&
         entry.lower_bound <= cells.size() &&
         vertices.size() == entry.quads + 2 + std::size_t{entry.interior};
}

}  // namespace hexatlas::check::sabotage
