#pragma once
/// \file
/// A cavity of a mesh: a ball of hexahedra that grows, and the balls known that may take its place.
///
/// Claim. Let a mesh obey the strict rule, and its boundary be a sphere. After an exchange found
/// here it obeys the rule, has the same boundary, and is homeomorphic to what it was: no pair of
/// vertices on the boundary of the cavity is a scar both of the ball put in and of the hexahedra
/// around it (docs/theory/proofs/front.md, section 5).

#include <array>
#include <cstdint>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/scars.hpp"
#include "enum/flips/sub_ball.hpp"
#include "meshing/simplify/edited_mesh.hpp"
#include "meshing/simplify/known_balls.hpp"

namespace hexatlas::simplify {

/// A ball that may take the place of a cavity, and how it lies there.
struct Fit {
  const Ball* ball = nullptr;  ///< valid until the balls known are asked or added to
  flips::Position position;
};

class Cavity {
 public:
  using Pairs = std::vector<std::array<complex::VertexId, 2>>;

  /// All three outlive this. The mesh may change between one restart() and the next. Of the pairs
  /// `apart`, if there are any, no hexahedron may contain both.
  Cavity(const EditedMesh& mesh, KnownBalls& known, const Pairs* apart = nullptr);

  /// A single hexahedron, chosen at random, as is how round the cavity will grow.
  void restart(core::Random& random);
  /// Grows by one hexahedron; false if it cannot.
  bool grow(core::Random& random) { return ball_.grow_somewhere(random, weight_); }

  [[nodiscard]] int size() const noexcept { return static_cast<int>(ball_.cells().size()); }
  [[nodiscard]] int quads() const noexcept { return ball_.quads(); }
  [[nodiscard]] const flips::SubBall& ball() const noexcept { return ball_; }

  /// All balls known that fit and have at most `most` hexahedra, except the cavity as it is.
  /// Cost: some microseconds; the exhaustive search for small meshes at its first boundary.
  [[nodiscard]] std::vector<Fit> fits(int most);
  [[nodiscard]] Exchange exchange_for(const Fit& fit) const;
  /// Adds the cavity to the balls known. Requires that fits() was the last call.
  void remember(core::Random& random);

 private:
  [[nodiscard]] flips::Relation related_outside() const;

  const EditedMesh& mesh_;
  KnownBalls& known_;
  const Pairs* apart_;
  flips::SubBall ball_;
  canon::CanonicalFlags flags_;
  Ball own_;
  int weight_ = 1;  ///< of shared facets in its growth
};

}  // namespace hexatlas::simplify
