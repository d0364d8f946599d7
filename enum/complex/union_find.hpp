#pragma once
/// \file
/// Disjoint sets of the numbers 0 .. size-1.

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace hexatlas::complex {

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size), count_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t find(std::size_t i) noexcept {
    while (parent_[i] != i) i = std::exchange(parent_[i], parent_[parent_[i]]);
    return i;
  }
  /// True if they were in different sets.
  bool unite(std::size_t a, std::size_t b) noexcept {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent_[b] = a;
    --count_;
    return true;
  }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

 private:
  std::vector<std::size_t> parent_;
  std::size_t count_;
};

}  // namespace hexatlas::complex
