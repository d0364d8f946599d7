#pragma once
/// \file
/// A set of pairs of vertices: open addressing, 8 bytes per slot, at most two thirds of them used.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"

namespace hexatlas::hexahedrize {

class PairSet {
 public:
  [[nodiscard]] bool has(complex::VertexId a, complex::VertexId b) const noexcept {
    return slots_[place(key(a, b))] != kNone;
  }
  /// Requires different vertices.
  void insert(complex::VertexId a, complex::VertexId b) {
    if (3 * (size_ + 1) > 2 * slots_.size()) grow();
    put(key(a, b));
  }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  static constexpr std::uint64_t kNone = 0;  ///< no key: the vertices of a pair differ

  [[nodiscard]] static std::uint64_t key(complex::VertexId a, complex::VertexId b) noexcept {
    if (a > b) std::swap(a, b);
    return std::uint64_t{a} << 32U | b;
  }
  [[nodiscard]] std::size_t place(std::uint64_t key) const noexcept {
    std::size_t i = core::mixed(key) & (slots_.size() - 1);
    while (slots_[i] != kNone && slots_[i] != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void put(std::uint64_t key) {
    std::uint64_t& slot = slots_[place(key)];
    if (slot == kNone) ++size_;
    slot = key;
  }
  void grow() {
    std::vector<std::uint64_t> former(2 * slots_.size(), kNone);
    former.swap(slots_);
    size_ = 0;
    for (const std::uint64_t key : former)
      if (key != kNone) put(key);
  }

  std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(64, kNone);
  std::size_t size_ = 0;
};

}  // namespace hexatlas::hexahedrize
