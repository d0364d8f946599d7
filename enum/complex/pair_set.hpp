#pragma once
/// \file
/// A set of pairs of vertices: open addressing, 8 bytes per slot, at most two thirds of them used.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"

namespace hexatlas::complex {

class PairSet {
 public:
  [[nodiscard]] bool has(VertexId a, VertexId b) const noexcept {
    return slots_[place(key(a, b))] != kNone;
  }
  /// Whether the pair is new. Requires different vertices.
  bool insert(VertexId a, VertexId b) {
    if (3 * (size_ + 1) > 2 * slots_.size()) grow();
    return put(key(a, b));
  }
  /// Requires has(a, b).
  void erase(VertexId a, VertexId b) noexcept {
    std::size_t hole = place(key(a, b));
    slots_[hole] = kNone;
    --size_;
    // Keys behind the hole that a search would no longer reach move into it.
    for (std::size_t i = next(hole); slots_[i] != kNone; i = next(i)) {
      const std::size_t home = core::mixed(slots_[i]) & (slots_.size() - 1);
      if (distance(home, i) < distance(hole, i)) continue;
      slots_[hole] = std::exchange(slots_[i], kNone);
      hole = i;
    }
  }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  static constexpr std::uint64_t kNone = 0;  ///< no key: the vertices of a pair differ

  [[nodiscard]] static std::uint64_t key(VertexId a, VertexId b) noexcept {
    if (a > b) std::swap(a, b);
    return std::uint64_t{a} << 32U | b;
  }
  [[nodiscard]] std::size_t place(std::uint64_t key) const noexcept {
    std::size_t i = core::mixed(key) & (slots_.size() - 1);
    while (slots_[i] != kNone && slots_[i] != key) i = next(i);
    return i;
  }
  [[nodiscard]] std::size_t next(std::size_t i) const noexcept {
    return (i + 1) & (slots_.size() - 1);
  }
  /// Steps from one slot on to another one, around the end.
  [[nodiscard]] std::size_t distance(std::size_t from, std::size_t to) const noexcept {
    return (to - from) & (slots_.size() - 1);
  }
  bool put(std::uint64_t key) {
    std::uint64_t& slot = slots_[place(key)];
    if (slot == key) return false;
    slot = key;
    ++size_;
    return true;
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

}  // namespace hexatlas::complex
