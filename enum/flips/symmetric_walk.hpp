#pragma once
/// \file
/// Random walks among the meshes of a boundary that have one of its involutions.
///
/// Definition. A *double exchange* exchanges a ball that shares no hexahedron with its image for
/// another one, and the image for the image of that. An *invariant exchange* exchanges a ball that
/// is its own image for one that has the involution, too (symmetric_balls.hpp). Both lead from
/// meshes with the involution to such meshes (docs/theory/proofs/symmetric.md).
///
/// Why. Meshes with a symmetry are few among all, and many of the least known ones are among them.
/// A step of such a walk does what two of the other walk do, which would have to be the right two.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/exchange.hpp"
#include "enum/flips/mesh_involution.hpp"
#include "enum/flips/sub_ball.hpp"
#include "enum/flips/symmetric_balls.hpp"
#include "enum/flips/walk.hpp"

namespace hexatlas::flips {

class SymmetricWalk {
 public:
  /// Requires what Walk requires, and that the involution extends to the mesh. `symmetric`: what
  /// invariant exchanges put in, if given; it and `balls` must outlive this.
  SymmetricWalk(complex::HexComplex mesh, int quads, const Involution& of_boundary,
                const Beam& balls, const SymmetricBalls* symmetric, std::uint64_t seed);
  SymmetricWalk(const SymmetricWalk&) = delete;
  SymmetricWalk& operator=(const SymmetricWalk&) = delete;
  SymmetricWalk(SymmetricWalk&&) = delete;
  SymmetricWalk& operator=(SymmetricWalk&&) = delete;
  ~SymmetricWalk() = default;

  /// Grows a ball somewhere, sometimes together with its image, and exchanges it, or leaves it as
  /// it is. The climate's factors are for a hexahedron and its image, or for two faults: a step
  /// that changes both sides pays once. Returns whether the mesh is another one.
  /// Cost: some ten microseconds, and 0.1 ms where something is exchanged.
  bool step(const Climate& climate, BallLayers& layers);

  [[nodiscard]] const complex::HexComplex& mesh() const noexcept { return mesh_; }
  [[nodiscard]] int faults() const noexcept { return faults_; }

 private:
  [[nodiscard]] bool is_own_image(std::uint32_t cell) const noexcept {
    return involution_.cell[cell] == cell;
  }
  bool grow_apart();
  bool double_exchange(const Climate& climate, BallLayers& layers);
  bool grow_own_image();
  [[nodiscard]] SymmetricFront cavity_of_ball() const;
  bool invariant_exchange(const Climate& climate);
  [[nodiscard]] complex::HexComplex doubly_exchanged(const Layers& layers, const Fit& fit) const;
  bool accept(complex::HexComplex made, int expected_faults, const Climate& climate);

  complex::HexComplex mesh_;
  int quads_;
  Involution of_boundary_;
  const Beam& balls_;
  const SymmetricBalls* symmetric_;
  core::Random random_;
  SubBall::Neighbours neighbours_;
  MeshInvolution involution_;
  SubBall ball_;
  int faults_ = 0;
  std::vector<double> sums_;  ///< of weights, in one step
};

}  // namespace hexatlas::flips
