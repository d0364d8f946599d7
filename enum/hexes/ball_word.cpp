#include "enum/hexes/ball_word.hpp"

#include <algorithm>
#include <cstring>

namespace hexatlas::hexes {
namespace {

/// The corners of facet f = 2k + s, those whose bit k is s, in ascending order.
constexpr std::array<std::array<cells::CubeVertex, 4>, cells::kCubeFacets> kCornersOfFacet{{
    {0, 2, 4, 6},
    {1, 3, 5, 7},
    {0, 1, 4, 5},
    {2, 3, 6, 7},
    {0, 1, 2, 3},
    {4, 5, 6, 7},
}};

struct Start {
  std::uint8_t cell = 0;
  cells::CubeSymmetry turn = 0;
};

/// Facets as seen in a hexahedron that is turned.
unsigned turned(unsigned facets, cells::CubeSymmetry turn) noexcept {
  unsigned result = 0;
  for (unsigned f = 0; f < cells::kCubeFacets; ++f)
    result |= (facets >> cells::kCubeTables.facet[turn][f] & 1U) << f;
  return result;
}

/// The least word so far, and a walk that is compared with it letter by letter.
class Walker {
 public:
  explicit Walker(const SmallBall& ball) : ball_(ball) { least_.letters.fill(kUnset); }

  void try_start(Start start) {
    begin(start);
    const int order = walk();
    if (order < 0) automorphisms_ = 0;
    if (order <= 0) ++automorphisms_;
  }
  [[nodiscard]] CanonicalWord result() const noexcept { return {least_, automorphisms_}; }

 private:
  void begin(Start start) noexcept {
    number_.fill(kUnset);
    met_ = 1U << start.cell;
    order_[0] = start;
    met_count_ = 1;
    next_ = 0;
    letters_ = 0;
    is_less_ = false;
    for (const cells::CubeVertex corner : cells::kCubeTables.corner[start.turn])
      number_[ball_.cell(start.cell)[corner]] = next_++;
  }

  /// Negative, zero or positive: the word of this start is less than, equal to or greater than the
  /// least one so far, which it replaces if it is less.
  int walk() noexcept {
    for (std::size_t place = 0; place < met_count_; ++place)
      for (std::size_t f = 0; f < cells::kCubeFacets; ++f)
        if (!cross(place, f)) return 1;
    return is_less_ ? -1 : 0;
  }

  bool cross(std::size_t place, std::size_t f) noexcept {
    const Start from = order_[place];
    const auto to = ball_.neighbour(from.cell, cells::kCubeTables.facet[from.turn][f]);
    if (!to.exists() || (met_ >> to.cell & 1U) != 0) return true;
    met_ |= 1U << to.cell;
    const cells::CubeSymmetry turn = cells::kCubeTables.after[to.step][from.turn];
    order_[met_count_++] = {to.cell, turn};
    if (!put(static_cast<std::uint8_t>(cells::kCubeFacets * place + f))) return false;
    for (const cells::CubeVertex corner : kCornersOfFacet[f]) {
      std::uint8_t& number = number_[ball_.cell(to.cell)[cells::kCubeTables.corner[turn][corner]]];
      if (number == kUnset) number = next_++;
      if (!put(number)) return false;
    }
    return true;
  }

  /// False if the word becomes greater than the least one.
  bool put(std::uint8_t letter) noexcept {
    std::uint8_t& least = least_.letters[letters_++];
    if (!is_less_) {
      if (letter > least) return false;
      is_less_ = letter < least;
    }
    least = letter;
    return true;
  }

  static constexpr std::uint8_t kUnset = 0xFF;  ///< greater than any number or letter

  const SmallBall& ball_;
  Word least_;
  int automorphisms_ = 0;
  bool is_less_ = false;  ///< the walk has left the least word for a lesser one
  std::array<std::uint8_t, kMaxBallVertices> number_{};
  std::uint8_t next_ = 0;
  unsigned met_ = 0;
  std::array<Start, kMaxBallHexahedra> order_{};
  std::size_t met_count_ = 0, letters_ = 0;
};

}  // namespace

CanonicalWord canonical_word(const SmallBall& ball) {
  // Many turns of a hexahedron have fewer shared facets in front; they are left out unwalked.
  unsigned greatest = 0;
  std::array<Start, cells::kCubeSymmetries * kMaxBallHexahedra> starts{};
  std::size_t count = 0;
  for (std::size_t c = 0; c < ball.cells().size(); ++c)
    for (cells::CubeSymmetry turn = 0; turn < cells::kCubeSymmetries; ++turn) {
      const unsigned shared = turned(ball.shared_facets(c), turn);
      if (shared < greatest) continue;
      if (shared > greatest) count = 0;
      greatest = shared;
      starts[count++] = {static_cast<std::uint8_t>(c), turn};
    }
  Walker walker(ball);
  for (std::size_t i = 0; i < count; ++i) walker.try_start(starts[i]);
  return walker.result();
}

SmallBall ball_of(const Word& word, int hexahedra) {
  std::array<Corners, kMaxBallHexahedra> found{};
  found[0] = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto count = static_cast<std::size_t>(hexahedra);
  for (std::size_t c = 1; c < count; ++c) {
    const std::uint8_t* const letters = word.letters.data() + kLettersPerHexahedron * (c - 1);
    const std::size_t f = letters[0] % cells::kCubeFacets;
    const Corners& from = found[letters[0] / cells::kCubeFacets];
    const auto& far = kCornersOfFacet[f];
    const auto& near = kCornersOfFacet[f ^ 1U];
    for (std::size_t i = 0; i < 4; ++i) {
      found[c][far[i]] = letters[1 + i];
      found[c][near[i]] = from[far[i]];
    }
  }
  return SmallBall({found.data(), count});
}

}  // namespace hexatlas::hexes

std::size_t std::hash<hexatlas::hexes::Word>::operator()(
    const hexatlas::hexes::Word& word) const noexcept {
  std::uint64_t h = 0;
  for (std::size_t at = 0; at < word.letters.size(); at += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, word.letters.data() + at, sizeof eight);
    h = (h ^ eight) * 0x9E3779B97F4A7C15ULL;
    h ^= h >> 29U;
  }
  return static_cast<std::size_t>(h);
}
