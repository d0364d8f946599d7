#pragma once
/// \file
/// Private to meshing/delaunay: small numbers for the vertices of one cavity.

#include <array>
#include <cstddef>
#include <cstdint>

#include "meshing/delaunay/cells.hpp"

namespace hexatlas::delaunay {

/// Gives each new vertex the next number, from 0 on; the ghost vertex always has 0.
///
/// Method. P. Briggs, L. Torczon, "An efficient representation for sparse sets" (1993): a byte for
/// each vertex, never cleared, is believed only if the list of numbered vertices confirms it.
/// Without a branch, since whether a vertex is new cannot be foretold.
template <class Index>
class LocalVertices {
 public:
  static constexpr unsigned kMost = 64;

  /// One for each vertex; their values do not matter. That of the ghost vertex is not used. Not a
  /// type of characters, which might be anything's representation for all the compiler knows.
  enum class Claim : std::uint8_t {};

  explicit LocalVertices(Claim* claims) : claims_(claims) { vertices_[0] = kGhost; }
  void use(Claim* claims) noexcept { claims_ = claims; }

  void clear() noexcept { count_ = 1; }
  [[nodiscard]] bool has_room_for(unsigned more) const noexcept { return count_ + more <= kMost; }

  /// The numbers of the vertices. Requires room for all.
  template <std::size_t kCount>
  [[nodiscard]] std::array<std::uint32_t, kCount> numbers_of(
      const std::array<Index, kCount>& vertices) noexcept {
    std::array<std::uint32_t, kCount> numbers{};
    unsigned count = count_;
    for (std::size_t i = 0; i < kCount; ++i) {
      const Index v = vertices[i];
      Claim* const claim = v == kGhost ? &ghost_claim_ : claims_ + v;
      const unsigned claimed = static_cast<unsigned>(*claim) % kMost;
      const bool is_known = (claimed < count) & (vertices_[claimed] == v);
      const unsigned number = is_known ? claimed : count;
      vertices_[number] = v;
      *claim = static_cast<Claim>(number);
      count += static_cast<unsigned>(!is_known);
      numbers[i] = number;
    }
    count_ = count;
    return numbers;
  }

 private:
  Claim* claims_;
  Claim ghost_claim_{};
  unsigned count_ = 1;
  std::array<Index, kMost> vertices_{};
};

}  // namespace hexatlas::delaunay
