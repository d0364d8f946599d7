#pragma once
/// \file
/// The counts of quadrangulations by vertex splits, keyed by the canonical code.

#include <functional>
#include <map>

#include "tests/enum/support.hpp"

namespace hexatlas::counts {

struct Table {
  std::map<int, std::uint64_t> simple, rooted_simple, three_connected, rooted_three_connected;
};

using Visit = std::function<void(const complex::Quadrangulation&, const canon::Code&)>;

/// Sizes 2 .. max_quads; 3-connected ones, each of which is visited, from 6 on.
inline Table quadrangulations(int max_quads, const Visit& visit_three_connected) {
  Table table;
  auto level = support::four_cycle_class();
  for (int n = 2; n <= max_quads; ++n) {
    if (n > 2) level = support::grown(level);
    table.simple[n] = level.size();
    table.rooted_simple[n] = 0;
    if (n >= 6) table.three_connected[n] = table.rooted_three_connected[n] = 0;
    for (const auto& [code, map] : level) {
      const auto q = support::quadrangulation(map);
      const auto rooted =
          static_cast<std::uint64_t>(8 * n / canon::canonical_form(q).automorphisms);
      table.rooted_simple[n] += rooted;
      if (!q.is_three_connected()) continue;
      visit_three_connected(q, code);
      ++table.three_connected[n];
      table.rooted_three_connected[n] += rooted;
    }
  }
  return table;
}

}  // namespace hexatlas::counts
