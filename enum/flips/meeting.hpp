#pragma once
/// \file
/// Meeting of two beams: meshes of a boundary put together from a ball and a collar.
///
/// A *collar* of a boundary Q is a set of hexahedra taken off inwards from Q; it leaves a cavity
/// with a boundary Q'. A ball with boundary Q' fills the cavity, and the union obeys the strict
/// rule if and only if the scars of the ball and of the collar on Q' are disjoint
/// (docs/theory/proofs/front.md). So a collar of d hexahedra and a ball of h make a mesh of Q
/// with d + h.

#include <cstdint>
#include <optional>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"

namespace hexatlas::flips {

class SymmetricBalls;

/// A mesh whose vertices 0 .. quads+1 are the boundary's in canonical labels, right-handed if the
/// canonical list of quads is counter-clockwise from outside. The hexahedra can be taken off in
/// the order given: a shelling backwards.
struct Filling {
  complex::HexComplex mesh;
};

/// The ball of one state of a beam that was grown from the single hexahedron.
[[nodiscard]] Filling filling_of(const Beam& balls, FrontId id);

/// A ball known with a certain boundary: what a meeting needs to know before it is made.
struct KnownBall {
  int hexahedra = 0;
  Scars scars;  ///< in canonical labels of the boundary
};

/// Where a meeting takes its balls from.
class BallSource {
 public:
  BallSource() = default;
  BallSource(const BallSource&) = delete;
  BallSource& operator=(const BallSource&) = delete;
  BallSource(BallSource&&) = delete;
  BallSource& operator=(BallSource&&) = delete;
  virtual ~BallSource() = default;
  /// The least number of hexahedra among the balls known with this boundary, if there are any.
  [[nodiscard]] virtual std::optional<int> least_with(const canon::Code& boundary) const = 0;
  /// The balls known with this boundary, fewest hexahedra first.
  [[nodiscard]] virtual std::vector<KnownBall> balls_with(const canon::Code& boundary) const = 0;
  /// One of them, by its place in balls_with().
  [[nodiscard]] virtual Layers layers_of(const canon::Code& boundary, std::size_t ball) const = 0;
};

/// The balls of a beam that was grown from the single hexahedron, which must outlive this.
class BeamBalls final : public BallSource {
 public:
  explicit BeamBalls(const Beam& beam) : beam_(beam) {}
  [[nodiscard]] std::optional<int> least_with(const canon::Code& boundary) const override;
  [[nodiscard]] std::vector<KnownBall> balls_with(const canon::Code& boundary) const override;
  [[nodiscard]] Layers layers_of(const canon::Code& boundary, std::size_t ball) const override;

 private:
  const Beam& beam_;
};

/// The scars of a mesh whose vertices 0 .. quads+1 are those of `boundary` in canonical labels.
[[nodiscard]] Scars scars_of(const complex::HexComplex& mesh,
                             const complex::Quadrangulation& boundary);

struct MeetingOptions {
  /// Limits of the collars' beam. Its boundaries may have up to kMaxSymmetricQuads quads: wide
  /// collars, of more than kMaxStateQuads, take three times the memory and know no dominance, but
  /// from the hardest boundaries hardly any narrower ones lead anywhere. Cavities that are filled
  /// have at most kMaxStateQuads.
  BeamOptions collars;
  int max_collar = 12;  ///< hexahedra
  int below = 1 << 14;  ///< only fillings with fewer hexahedra are of interest
  /// Not 0: half of the collars expanded are those that come to the fewest hexahedra with a known
  /// ball, each scar in common counting as so many. Of wide and symmetric collars only, and not of
  /// those for varied meetings.
  int guided = 0;
  bool first = false;  ///< be content with the least filling by the thinnest collars that have one
  /// Pairs of boundary vertices, in canonical labels, that no hexahedron may contain both of: what
  /// is to be glued on outside relates them, or may do so.
  Scars apart{};
};

/// The least filling of `target` among all meetings of a collar with a ball of `balls`, or
/// nullopt. Requires that `target` is the code of a 3-connected quadrangulation: the scars say
/// nothing of faults of the boundary itself.
/// Not promised: minimality beyond what the beam and the balls contain.
/// Deterministic for given options, for any number of threads.
[[nodiscard]] std::optional<Filling> best_meeting(const BallSource& balls,
                                                  const canon::Code& target,
                                                  const MeetingOptions& options);

/// The same with collars that an involution of the boundary takes to themselves
/// (symmetric_beam.hpp), for each involution in turn; the balls need no symmetry. nullopt for a
/// boundary without involutions, too. Boundaries may have up to kMaxSymmetricQuads quads here, and
/// more between the hexahedra of an orbit or a crown. Involutions that do not keep options.apart
/// are left out; options.first holds for each one by itself. Cavities are filled with these balls
/// and, unless nullptr, with symmetric ones, which may have longer boundaries.
[[nodiscard]] std::optional<Filling> best_symmetric_meeting(
    const BallSource& balls, const canon::Code& target, const MeetingOptions& options,
    const SymmetricBalls* symmetric_balls = nullptr);

/// Fillings of many kinds, to begin annealing with (annealing.hpp): of the meetings with collars of
/// each thickness, thin ones first, the least one with an even and the least one with an odd number
/// of hexahedra. Requires what best_meeting() does.
[[nodiscard]] std::vector<Filling> varied_meetings(const Beam& balls, const canon::Code& target,
                                                   const MeetingOptions& options);

/// The same with symmetric collars, as in best_symmetric_meeting().
[[nodiscard]] std::vector<Filling> varied_symmetric_meetings(const Beam& balls,
                                                             const canon::Code& target,
                                                             const MeetingOptions& options);

}  // namespace hexatlas::flips
