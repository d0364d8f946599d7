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

  /// One byte for each vertex; their values do not matter. That of the ghost vertex is not used.
  explicit LocalVertices(std::uint8_t* bytes) : bytes_(bytes) { vertices_[0] = kGhost; }

  void use(std::uint8_t* bytes) noexcept { bytes_ = bytes; }
  void clear() noexcept { count_ = 1; }
  [[nodiscard]] bool has_room_for(unsigned more) const noexcept { return count_ + more <= kMost; }

  /// Requires room for one more.
  [[nodiscard]] unsigned number_of(Index v) noexcept {
    std::uint8_t& byte = v == kGhost ? ghost_byte_ : bytes_[v];
    const unsigned claimed = byte % kMost;
    const bool is_known = claimed < count_ && vertices_[claimed] == v;
    const unsigned number = is_known ? claimed : count_;
    vertices_[number] = v;
    byte = static_cast<std::uint8_t>(number);
    count_ += static_cast<unsigned>(!is_known);
    return number;
  }

 private:
  std::uint8_t* bytes_;
  std::uint8_t ghost_byte_ = 0;
  unsigned count_ = 1;
  std::array<Index, kMost> vertices_{};
};

}  // namespace hexatlas::delaunay
