#pragma once
/// \file
/// Private to meshing/delaunay: small numbers for the vertices of one cavity.

#include <cstdint>
#include <span>

#include "meshing/delaunay/cells.hpp"

namespace hexatlas::delaunay {

/// Numbers vertices from 1 on; the ghost vertex always has 0.
///
/// Method. A byte for each vertex: those of all vertices are cleared first, then numbers are given
/// where there is none yet. Without a branch, since whether a vertex is new cannot be foretold, and
/// without a list to confirm the numbers, as each would have to wait for the one before.
template <class Index>
class LocalVertices {
 public:
  static constexpr unsigned kMost = 64;

  /// One for each vertex; their values do not matter. That of the ghost vertex is not used. Not a
  /// type of characters, which might be anything's representation for all the compiler knows.
  enum class Claim : std::uint8_t {};

  explicit LocalVertices(Claim* claims) : claims_(claims) {}
  void use(Claim* claims) noexcept { claims_ = claims; }

  /// Forgets what was before; a vertex may come again. False if they are too many.
  [[nodiscard]] bool number(std::span<const Index> vertices) noexcept {
    for (const Index v : vertices)
      if (v != kGhost) claims_[v] = kNoNumber;
    unsigned count = 1;
    for (const Index v : vertices) {
      if (v == kGhost) continue;
      const Claim claim = claims_[v];
      const bool is_new = claim == kNoNumber;
      claims_[v] = is_new ? static_cast<Claim>(count) : claim;
      count += static_cast<unsigned>(is_new);
    }
    return count <= kMost;
  }
  /// Requires that it was numbered.
  [[nodiscard]] unsigned number_of(Index v) const noexcept {
    return v == kGhost ? 0U : static_cast<unsigned>(claims_[v]);
  }

 private:
  static constexpr Claim kNoNumber{255};

  Claim* claims_;
};

}  // namespace hexatlas::delaunay
