#pragma once
/// \file
/// The cuts of one boundary within limits (cut.hpp), and the balls on either side of each: what
/// all unions of two balls are chosen from.

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/circles.hpp"
#include "enum/flips/cut.hpp"
#include "enum/flips/disc.hpp"
#include "enum/flips/front.hpp"
#include "enum/flips/meeting.hpp"

namespace hexatlas::flips {

/// Pairs of vertices of one disc.
using PairSet = std::bitset<kMaxDiscVertices*(kMaxDiscVertices - 1) / 2>;

/// In numbers of the cut: the vertices of the target come first, those inside the disc follow.
struct Cut {
  std::vector<bool> left;  ///< the quads of the target on one side
  Disc disc;
  int least = 0;  ///< no union has fewer hexahedra
};

/// One of the two balls of a cut: its boundary, and what its vertices are in the cut.
struct CutSide {
  std::vector<complex::Vertex> in_cut;
  canon::CanonicalFlags flags;
  complex::Quadrangulation boundary;
  Relation of_quads{};  ///< in numbers of the cut
  int least = 0;        ///< hexahedra of a ball with this boundary
};
using CutSides = std::array<CutSide, 2>;

/// A way to fill one side: a ball, turned, and the pairs of the disc that it relates.
struct TurnedBall {
  PairSet pairs;
  int hexahedra = 0;
  std::uint32_t ball = 0;  ///< its place in BallSource::balls_with()
  std::uint32_t flag = 0;
};

class CutList {
 public:
  /// Lists the cuts with unions of fewer than options.below hexahedra. `balls` must outlive this.
  /// Requires what best_cuts() requires.
  CutList(const BallSource& balls, const canon::Code& target, const CutOptions& options);

  [[nodiscard]] const std::vector<Cut>& cuts() const noexcept { return cuts_; }
  /// The sides of a listed cut.
  [[nodiscard]] CutSides sides_of(const Cut& cut) const;
  /// The pairs of vertices of the disc that lie in no quad of it. They are what PairSet counts.
  using Pairs = std::vector<std::pair<complex::Vertex, complex::Vertex>>;
  [[nodiscard]] static Pairs pairs_of(const Cut& cut);
  /// Whether quads of both sides relate one of the pairs: then all unions break the strict rule.
  [[nodiscard]] static bool related_by_quads(const CutSides& sides, const Pairs& pairs);
  /// All ways to fill a side with fewer than `below` hexahedra, fewest first.
  [[nodiscard]] std::vector<TurnedBall> turned(const CutSide& side, const Pairs& pairs, int below);
  /// The union: a mesh of the target, or of what looks like it where the strict rule is broken.
  [[nodiscard]] complex::HexComplex assembled(const CutSides& sides,
                                              const std::array<TurnedBall, 2>& chosen) const;

 private:
  void list_cuts(const Circle& circle);
  void list_cut(const std::vector<bool>& left, const Circle& rim, const Disc& disc);
  [[nodiscard]] std::optional<CutSides> sides_if_known(const Cut& cut) const;
  [[nodiscard]] std::optional<CutSide> side_if_known(
      const std::vector<complex::QuadVertices>& quads) const;
  const std::vector<KnownBall>& balls_with(const canon::Code& boundary);

  const BallSource& source_;
  complex::Quadrangulation q_;
  Graph graph_;
  CutOptions options_;
  std::vector<Cut> cuts_;
  std::unordered_map<canon::Code, std::vector<KnownBall>> known_;
};

}  // namespace hexatlas::flips
