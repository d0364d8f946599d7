#pragma once
/// \file
/// The balls that an exchange may put in, by the canonical code of their boundary.
///
/// They come from three sources: a table of meshes, the exhaustive search for small meshes
/// (small_meshes.hpp), and the balls seen inside the mesh that is being simplified. Of one boundary
/// several are kept: they differ in their scars, which decide where they fit, and in their inside,
/// which decides what can be done next.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/scars.hpp"
#include "enum/flips/sub_ball.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::simplify {

/// A ball whose vertices 0 .. quads+1 are those of its boundary in canonical labels, right-handed
/// if the canonical list of quads is counter-clockwise from outside.
struct Ball {
  complex::HexComplex mesh;
  flips::Scars scars;
  /// The same for balls that differ in the names of interior vertices only, and seldom for others.
  std::uint64_t shape = 0;

  [[nodiscard]] int hexahedra() const noexcept { return static_cast<int>(mesh.hexahedra.size()); }
};

/// Requires that the mesh is such a ball with this boundary.
[[nodiscard]] Ball ball_of(complex::HexComplex mesh, const complex::Quadrangulation& boundary);

/// The ball of a sub-ball of `mesh` in a position of its boundary.
[[nodiscard]] Ball ball_at(const flips::SubBall& sub_ball, const complex::HexComplex& mesh,
                           const canon::Labelling& label, bool is_mirrored);

class KnownBalls {
 public:
  /// `table` may be null; it outlives this.
  explicit KnownBalls(const format::Table* table) : table_(table) {}

  /// The balls known with this boundary, in a fixed order. The table is asked at the first time,
  /// the exhaustive search if a ball of `hexahedra` hexahedra may have a smaller rival that it can
  /// find. Valid until the next call of with() or add().
  [[nodiscard]] const std::vector<Ball>& with(const canon::Code& code, int hexahedra);

  /// Keeps a ball, unless its like is known or enough others are; of those, the one at place `turn`
  /// may give way to it. Requires that with() was called for the boundary before.
  void add(const canon::Code& code, Ball ball, std::uint64_t turn);

 private:
  struct Family {
    std::vector<Ball> balls;
    int searched = 0;                                ///< all with at most so many are known
    int given_up = std::numeric_limits<int>::max();  ///< a search for so many did not end
  };
  void search(const canon::Code& code, int hexahedra, Family& family);

  const format::Table* table_;
  std::unordered_map<canon::Code, Family> families_;
  std::size_t seen_hexahedra_ = 0;
  const std::vector<Ball> none_;
};

}  // namespace hexatlas::simplify
