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

  /// Gives the vertex a number unless it has one; false if there are no more.
  [[nodiscard]] bool add(Index v) noexcept {
    if (v == kGhost) return true;
    if (count_ == kMost) return false;
    const auto claimed = static_cast<unsigned>(claims_[v]) % kMost;
    const bool is_known = (claimed < count_) & (vertices_[claimed] == v);
    const unsigned number = count_ ^ ((count_ ^ claimed) & (0U - static_cast<unsigned>(is_known)));
    vertices_[number] = v;
    claims_[v] = static_cast<Claim>(number);
    count_ += static_cast<unsigned>(!is_known);
    return true;
  }
  /// Requires that the vertex was added.
  [[nodiscard]] unsigned number_of(Index v) const noexcept {
    return v == kGhost ? 0U : static_cast<unsigned>(claims_[v]);
  }

 private:
  Claim* claims_;
  unsigned count_ = 1;
  std::array<Index, kMost> vertices_{};
};

}  // namespace hexatlas::delaunay
