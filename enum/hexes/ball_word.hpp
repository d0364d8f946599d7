#pragma once
/// \file
/// Canonical words of small balls.
///
/// Definition. A *start* is a hexahedron and a symmetry of the cube that turns it. From a start a
/// ball is numbered breadth first: the corners of the first hexahedron in their turned order are
/// vertices 0 to 7; from each hexahedron in the order in which they were met its facets are crossed
/// in their turned order, the axes go on across a facet, and the four corners on the far side get
/// the next numbers unless they have one. The word has five letters for each hexahedron after the
/// first: 6 times the place of the hexahedron that it was met from plus the facet crossed, and the
/// numbers of the far corners. The *canonical word* is the least one over the starts whose own
/// shared facets, as a number, are greatest.
///
/// Claim. Two balls have equal canonical words if and only if they are isomorphic, mirror images
/// identified; the starts that attain it are as many as the automorphisms
/// (docs/theory/proofs/shellable-balls.md). Any complex would do whose hexahedra are joined by
/// chains of shared facets.
///
/// Source. The least word over all starts of a walk is L. Weinberg's idea for plane maps (IEEE
/// Trans. Circuit Theory 13, 1966); the walk is of this project.

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "enum/hexes/small_ball.hpp"

namespace hexatlas::hexes {

inline constexpr std::size_t kLettersPerHexahedron = 5;

/// 255 follows the last letter. Only words of as many hexahedra are compared.
struct Word {
  std::array<std::uint8_t, 56> letters{};
  friend auto operator<=>(const Word&, const Word&) = default;
};
static_assert(kLettersPerHexahedron * (kMaxBallHexahedra - 1) <= sizeof(Word));

struct CanonicalWord {
  Word word;
  int automorphisms = 0;  ///< mirror symmetries included
};

/// Cost: at most 48 walks around the ball for each hexahedron, most of them given up early;
/// some microseconds.
[[nodiscard]] CanonicalWord canonical_word(const SmallBall& ball);

/// A ball with this word, its hexahedra and vertices in the order of the word, right-handed.
/// Requires a canonical word of so many hexahedra.
[[nodiscard]] SmallBall ball_of(const Word& word, int hexahedra);

}  // namespace hexatlas::hexes

template <>
struct std::hash<hexatlas::hexes::Word> {
  [[nodiscard]] std::size_t operator()(const hexatlas::hexes::Word& word) const noexcept;
};
