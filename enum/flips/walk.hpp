#pragma once
/// \file
/// Random walks among the meshes of a boundary by exchanges that may break the strict rule.
///
/// Definition. Of the hexahedra that contain two certain vertices, join any two that share a facet
/// containing both. If k classes remain, the pair has k - 1 *faults*. A ball glued of hexahedra
/// obeys the strict rule if and only if it has no fault; the exchange of a ball G of it for a ball
/// B with the same boundary changes the number of faults by the scars that B has in common with
/// the rest of the mesh, less those that G has (docs/theory/proofs/front.md, section 8).
///
/// Faults are of this project.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {

/// A ball glued of hexahedra, right-handed if the canonical list of the quads of its boundary is
/// counter-clockwise from outside, and its number of faults: with none it obeys the strict rule.
/// Vertices 0 .. quads+1 are those of the boundary, in canonical labels.
struct FaultyMesh {
  complex::HexComplex mesh;
  int faults = 0;
};

/// The layers of balls that were asked for lately. For one thread.
class BallLayers {
 public:
  /// Requires that `balls`, which must outlive this, grew from the single hexahedron.
  explicit BallLayers(const Beam& balls) : balls_(balls) {}
  /// Valid until the next call.
  [[nodiscard]] const Layers& of(FrontId ball);

 private:
  const Beam& balls_;
  std::map<FrontId, Layers> known_;
};

/// What a walk pays: factors of the probability of an exchange.
class Climate {
 public:
  /// Factors below 1 for a further hexahedron and for a further fault.
  constexpr Climate(double per_hexahedron, double per_fault) noexcept {
    for (int i = -kLimit; i <= kLimit; ++i) {
      hexahedra_[static_cast<std::size_t>(i + kLimit)] = power(per_hexahedron, i);
      faults_[static_cast<std::size_t>(i + kLimit)] = power(per_fault, i);
    }
  }
  /// The factor for so many more of them; beyond 32 more or fewer that of 32.
  [[nodiscard]] constexpr double factor(int hexahedra, int faults) const noexcept {
    return hexahedra_[place_of(hexahedra)] * faults_[place_of(faults)];
  }

 private:
  static constexpr int kLimit = 32;
  static constexpr std::size_t place_of(int more) noexcept {
    return static_cast<std::size_t>(std::clamp(more, -kLimit, kLimit) + kLimit);
  }
  static constexpr double power(double base, int exponent) noexcept {
    double result = 1;
    for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) result *= base;
    return exponent < 0 ? 1 / result : result;
  }
  std::array<double, 2 * kLimit + 1> hexahedra_{}, faults_{};
};

/// A mesh that changes by one exchange after the other. Vertices 0 .. quads+1 are those of its
/// boundary and stay.
class Walk {
 public:
  /// What a leap exchanges a ball for: one that a step may put in, too, but not the ball itself.
  enum class Leap : std::uint8_t {
    any_other,    ///< with another number of hexahedra or other scars
    other_parity  ///< with a number of hexahedra of the other parity
  };

  /// Requires a ball glued of right-handed hexahedra, with such a boundary and so many faults, and
  /// that `balls`, which must outlive this, grew from the single hexahedron.
  Walk(complex::HexComplex mesh, int quads, const Beam& balls, std::uint64_t seed, int faults = 0);
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;
  Walk(Walk&&) = delete;
  Walk& operator=(Walk&&) = delete;
  ~Walk() = default;

  /// Grows a ball of a random size somewhere and exchanges it, or leaves it as it is: each way with
  /// a probability proportional to the climate's factor. Returns whether the mesh is another one.
  /// Exchanges after which two facets of the mesh would have the same vertices are left out.
  /// Cost: some ten microseconds. `layers`: of the same balls; the result does not depend on which
  /// of them it has at hand.
  bool step(const Climate& climate, BallLayers& layers);
  /// Exchanges a large ball, grown somewhere, for one of those that the climate weighs as above. So
  /// the walk may leave its dual class (enum/complex/dual_class.hpp), which a step hardly ever does
  /// and a change of parity always. Returns whether one was found in so many tries. Cost: some ten
  /// microseconds per try.
  bool leap(const Climate& climate, BallLayers& layers, int tries, Leap kind);

  [[nodiscard]] const complex::HexComplex& mesh() const noexcept { return mesh_; }
  /// A ball with as many faults; with none it obeys the strict rule.
  [[nodiscard]] int faults() const noexcept { return faults_; }

 private:
  bool exchange(const Climate& climate, BallLayers& layers, std::optional<Leap> leap);

  complex::HexComplex mesh_;
  int quads_;
  const Beam& balls_;
  core::Random random_;
  SubBall::Neighbours neighbours_;
  SubBall ball_;
  int faults_ = 0;
  std::vector<double> sums_;  ///< of weights, in one step
};

}  // namespace hexatlas::flips
