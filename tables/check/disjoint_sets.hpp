#pragma once
/// \file
/// Internal to the judge: union of disjoint sets of numbers, by halving of paths.

#include <cstdint>
#include <numeric>
#include <vector>

namespace hexatlas::check {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) { reset(count); }

  void reset(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0U);
    sets_ = count;
  }
  [[nodiscard]] std::size_t sets() const { return sets_; }

  /// False if both were in one set already.
  bool unite(std::size_t a, std::size_t b) {
    const std::uint32_t root_a = root(a);
    const std::uint32_t root_b = root(b);
    if (root_a == root_b) return false;
    parent_[root_a] = root_b;
    --sets_;
    return true;
  }

 private:
  std::uint32_t root(std::size_t number) {
    auto at = static_cast<std::uint32_t>(number);
    while (parent_[at] != at) at = parent_[at] = parent_[parent_[at]];
    return at;
  }

  std::vector<std::uint32_t> parent_;
  std::size_t sets_ = 0;
};

}  // namespace hexatlas::check
