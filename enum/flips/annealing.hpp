#pragma once
/// \file
/// Meshes made smaller by exchanges that may break the strict rule for a while.
///
/// Definition. Of the hexahedra that contain two certain vertices, join any two that share a facet
/// containing both. If k classes remain, the pair has k - 1 *faults*. A ball glued of hexahedra
/// obeys the strict rule if and only if it has no fault; the exchange of a ball G of it for a ball
/// B with the same boundary changes the number of faults by the scars that B has in common with
/// the rest of the mesh, less those that G has (docs/theory/proofs/front.md, section 8).
///
/// Method. A random walk of exchanges in which a further hexahedron and a further fault each cost
/// a factor of the probability. Several walks at once, from cold ones, for which both cost much, to
/// hot ones, trade places.
///
/// Sources. Annealing: Kirkpatrick, Gelatt, Vecchi (Science 220, 1983); walks that trade places:
/// Swendsen, Wang (Phys. Rev. Lett. 57, 1986). Faults are of this project.

#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {

/// What a walk pays: factors below 1 of the probability of an exchange.
struct Climate {
  double per_hexahedron = 0;
  double per_fault = 0;
};

/// A mesh that changes by one exchange after the other. Vertices 0 .. quads+1 are those of its
/// boundary and stay.
class Walk {
 public:
  /// Requires a ball under the strict rule, right-handed, with such a boundary, and that `balls`,
  /// which must outlive this, grew from the single hexahedron.
  Walk(complex::HexComplex mesh, int quads, const Beam& balls, std::uint64_t seed);

  /// Grows a ball of a random size somewhere and exchanges it, or leaves it as it is: each way with
  /// a probability proportional to the climate's factors. Returns whether the mesh is another one.
  /// Exchanges after which two facets of the mesh would have the same vertices are left out.
  /// Cost: some ten microseconds.
  bool step(const Climate& climate);

  [[nodiscard]] const complex::HexComplex& mesh() const noexcept { return mesh_; }
  /// A ball with as many faults; with none it obeys the strict rule.
  [[nodiscard]] int faults() const noexcept { return faults_; }

 private:
  complex::HexComplex mesh_;
  int quads_;
  const Beam* balls_;
  core::Random random_;
  SubBall::Neighbours neighbours_;
  int faults_ = 0;
};

struct AnnealingOptions {
  int rounds = 200;  ///< of 500 steps of each of the 8 walks, after which neighbours may trade
  std::uint64_t seed = 1;
  int threads = 1;  ///< does not change the result
};

/// A mesh under the strict rule with the same boundary and fewer hexahedra, the least one seen, or
/// nullopt if none was. The vertices of the boundary, 0 .. quads+1, stay. Requires what Walk does.
/// Deterministic. Not promised: that the mesh has a shelling. Cost: about 0.1 s per round.
[[nodiscard]] std::optional<complex::HexComplex> smaller_by_annealing(
    const complex::HexComplex& mesh, int quads, const Beam& balls, const AnnealingOptions& options);

}  // namespace hexatlas::flips
