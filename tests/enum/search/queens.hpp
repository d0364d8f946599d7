#pragma once
/// \file
/// The n queens problem, to be searched.

#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace hexatlas::support {

using Rows = std::vector<int>;

struct Queens {
  using Choice = int;
  int size;
  Rows row{};

  [[nodiscard]] bool is_complete() const { return static_cast<int>(row.size()) == size; }
  [[nodiscard]] Rows choices() const {
    Rows all(static_cast<std::size_t>(size));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  bool apply(int r) {
    int distance = static_cast<int>(row.size());
    for (const int other : row) {
      if (other == r || std::abs(other - r) == distance) return false;
      --distance;
    }
    row.push_back(r);
    return true;
  }
  void undo() { row.pop_back(); }
};

}  // namespace hexatlas::support
