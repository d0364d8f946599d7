#pragma once
/// \file
/// Places for the free points of a hexahedral mesh: as many hexahedra as possible valid, and then
/// the least scaled Jacobian great.
///
/// Method. docs/theory/untangling.md. The free points start harmonic, or where the spacing of the
/// boundary puts them if all hexahedra are valid there; a regularized energy of the
/// Jacobian matrices is minimized while its regularization goes to zero (energies.hpp, with
/// source), which turns inverted corners over; where that does not suffice, from other starts.
/// Hexahedra that are not valid though their corners are positive are looked at in 27 points
/// instead of 8. Then a power mean of the scaled Jacobians with growing exponent is raised, without
/// losing a valid hexahedron.
///
/// Floating point proposes only: of the places found those are taken with the most hexahedra valid
/// by the exact test (realize/exact/jacobian.hpp), among them those with the greatest least scaled
/// Jacobian.
///
/// Deterministic: the same places for any number of threads, ends by counts and never by the clock.
/// Not promised: that a mesh that can be untangled is untangled, or that valid hexahedra do not
/// overlap.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "realize/exact/sign.hpp"

namespace hexatlas::untangle {

inline constexpr int kDefaultEffort = 10;
inline constexpr int kMaxEffort = 1000;

struct Options {
  /// The limit of work: `effort` million evaluations of the energy of one hexahedron, about as many
  /// seconds on one core; a first start, which is linear, comes before. Small meshes need less;
  /// those of more than 20,000 hexahedra are improved near bad hexahedra only. With 0 free points
  /// have their first places and no more.
  int effort = kDefaultEffort;
  int threads = 1;
  /// Begin with the places given instead of first ones.
  bool starts_as_given = false;
};

struct Mesh {
  std::vector<exact::Point3> points;
  std::vector<std::array<std::uint32_t, 8>> hexahedra;  ///< corner x + 2y + 4z
  std::vector<std::uint8_t> is_free;                    ///< 1: may be moved; one entry per point
};

/// The points; those that are not free, and those in no hexahedron, are the given ones bit for bit.
/// Requires finite coordinates (unless options say otherwise those of free points do not matter),
/// indices below the number of points, eight distinct ones in a hexahedron, 0 <= effort <=
/// kMaxEffort, and threads >= 1; else PreconditionViolated. If no point is fixed the places given
/// are the start, and the result has its centre and about its size. Coordinates of any size: they
/// are scaled first. Memory: about 1 kB per hexahedron.
[[nodiscard]] std::vector<exact::Point3> untangled(const Mesh& mesh, const Options& options);

}  // namespace hexatlas::untangle
