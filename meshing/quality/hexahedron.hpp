#pragma once
/// \file
/// Validity and shape of one hexahedron.
///
/// Definition. A hexahedron is *valid* if the Jacobian determinant of its trilinear map is
/// positive on the closed cube. It is *inverted* if the determinant is not positive at a corner.
///
/// Method and source: realize/exact/jacobian.hpp. An answer `valid` or `invalid` is a proof; the
/// exact search for one ends after kSubdivisionDepth subdivisions.
///
/// Requires. Finite coordinates, else PreconditionViolated.
/// Not promised: that a map with positive Jacobian is injective (it is locally), or that cells
/// of a mesh do not overlap.

#include <array>
#include <cstdint>
#include <span>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::quality {

inline constexpr int kSubdivisionDepth = 4;

/// Corner x + 2y + 4z, as in enum/cells/cube.hpp.
using Corners = std::array<mesh::Point, 8>;

enum class Validity : std::uint8_t { valid, invalid, undecided };

struct Verdict {
  Validity validity = Validity::undecided;
  bool inverted = false;  ///< the determinant at some corner is <= 0
  bool exact = false;     ///< double precision did not suffice
};

[[nodiscard]] Verdict verdict_of_hexahedron(const Corners& corners);

/// The same of many hexahedra, faster for each. Requires. As many verdicts as hexahedra, else
/// PreconditionViolated.
void verdicts_of_hexahedra(std::span<const Corners> hexahedra, std::span<Verdict> verdicts);

[[nodiscard]] inline Validity validity_of_hexahedron(const Corners& corners) {
  return verdict_of_hexahedron(corners).validity;
}

/// The least, over the corners, of the determinant of the three edge vectors there divided by their
/// lengths, in [-1, 1]; a corner with an edge of length zero counts 0. Its sign is exact: positive
/// exactly if the cell is not inverted. Its size is a measure of shape in double precision that
/// proves nothing of the inside. No scale of the coordinates makes it overflow.
[[nodiscard]] double scaled_jacobian(const Corners& corners);

/// Whether the scaled Jacobian, computed as above, is in truth greater than the threshold: decided
/// exactly, so that no rounding, and no numbering of the corners, has a say.
/// Requires 0 <= threshold < 1.
[[nodiscard]] bool exceeds(const Corners& corners, double scaled_jacobian, double threshold);

}  // namespace hexatlas::quality
