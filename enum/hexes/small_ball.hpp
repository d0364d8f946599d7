#pragma once
/// \file
/// Balls of few hexahedra, in a form that is quick to copy: which hexahedra may be glued on, which
/// may be taken off.
///
/// Definition. A *patch* is a set of facets of the cube that is a disc and whose complement is a
/// disc. A hexahedron may be glued on a ball, along a patch of its boundary, if the result obeys
/// the strict rule (enum/complex/hex_complex.hpp); then it is a ball. Taking it off is the inverse.
///
/// Claim. Let R be a ball under the strict rule and C a hexahedron with a patch of facets on the
/// boundary of R. Their union is a ball under the strict rule that meets C in the patch only, if
/// and only if two vertices of C that some hexahedron of R contains lie in one facet of the patch
/// (docs/theory/proofs/front.md, section 1). Here R is whole, nothing is known of fronts.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/cells/cube_symmetries.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/hexes/partial_mesh.hpp"

namespace hexatlas::hexes {

inline constexpr int kMaxBallHexahedra = 12;
/// A shelling adds at most four vertices and four quads with each hexahedron.
inline constexpr int kMaxBallVertices = 4 * kMaxBallHexahedra + 4;
inline constexpr int kMaxBallQuads = 4 * kMaxBallHexahedra + 2;
static_assert(kMaxBallVertices <= 64, "a set of vertices is a word");

/// The vertices of a hexahedron by corner of the reference cube.
using Corners = std::array<Vertex, cells::kCubeVertices>;

/// The facet of one hexahedron that is glued to a facet of another one.
struct Joint {
  std::uint8_t facet = 0;
  std::uint8_t other = 0;  ///< the other hexahedron
  std::uint8_t other_facet = 0;
};

/// A hexahedron that may be glued on: its vertices, new ones numbered from vertices() on, and
/// what it is glued to.
struct Gluing {
  Corners cell{};
  std::array<Joint, 5> joints{};
  int joint_count = 0;
};

class SmallBall {
 public:
  /// The hexahedron beyond a facet, and the map from the corners of this one to those of that one
  /// that continues the axes across the facet.
  struct Neighbour {
    std::uint8_t cell = kNone;
    cells::CubeSymmetry step = 0;
    [[nodiscard]] bool exists() const noexcept { return cell != kNone; }
    static constexpr std::uint8_t kNone = 0xFF;
  };

  /// Facets with the same vertices are glued. Requires 1 to kMaxBallHexahedra hexahedra, right-
  /// handed, with vertices below kMaxBallVertices, that obey the strict rule.
  explicit SmallBall(std::span<const Corners> cells);

  [[nodiscard]] int size() const noexcept { return size_; }
  /// One more than the greatest vertex.
  [[nodiscard]] int vertices() const noexcept { return vertices_; }
  [[nodiscard]] const Corners& cell(std::size_t c) const noexcept { return cells_[c]; }
  [[nodiscard]] std::span<const Corners> cells() const noexcept {
    return {cells_.data(), static_cast<std::size_t>(size_)};
  }
  [[nodiscard]] Neighbour neighbour(std::size_t c, std::size_t facet) const noexcept {
    return neighbours_[c][facet];
  }
  /// The facets of a hexahedron that have a neighbour; bit f is facet f.
  [[nodiscard]] unsigned shared_facets(std::size_t c) const noexcept { return shared_[c]; }

  /// Requires an element of gluings(*this), size() < kMaxBallHexahedra.
  void glue(const Gluing& gluing);
  /// Requires size() >= 2; the ball that is left if is_removable(*this, c).
  [[nodiscard]] SmallBall without(std::size_t c) const;

 private:
  void join(std::size_t c, Joint joint);

  std::array<Corners, kMaxBallHexahedra> cells_{};
  std::array<std::array<Neighbour, cells::kCubeFacets>, kMaxBallHexahedra> neighbours_{};
  std::array<std::uint8_t, kMaxBallHexahedra> shared_{};
  int size_ = 0, vertices_ = 0;
};

/// All ways to glue a hexahedron on, one for each patch of the boundary that permits it.
/// Requires that each vertex below ball.vertices() is in a hexahedron.
/// Cost: some microseconds.
[[nodiscard]] std::vector<Gluing> gluings(const SmallBall& ball);

/// Whether hexahedron c meets the others in a patch and in nothing else, and the boundary of the
/// ball in the rim and the outside of the patch only. Then and only then the others are a ball on
/// which it can be glued. Requires a ball under the strict rule of at least two hexahedra.
[[nodiscard]] bool is_removable(const SmallBall& ball, std::size_t c);

/// As a complex. Requires that each vertex below ball.vertices() is in a hexahedron.
[[nodiscard]] complex::HexComplex complex_of(const SmallBall& ball);

}  // namespace hexatlas::hexes
