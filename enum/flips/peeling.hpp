#pragma once
/// \file
/// Peeling: hexahedra taken off inwards from a quadrangulated sphere of any size, one by one.
///
/// What is left inside is the *cavity*. Its boundary changes by a flip (quad_flip.hpp) with each
/// hexahedron taken off, and what was taken off restricts what may follow by the pairs that it
/// relates (front.hpp). Where Front is a small value that searches copy, this is one state of any
/// size, changed in place and undone exactly: a flip and its undoing cost the same for 20 quads
/// and for 100,000.
///
/// Theorem (docs/theory/proofs/front.md, sections 1, 2 and 4). Let the sphere be 3-connected. The
/// hexahedra taken off and any ball that fills the cavity under the strict rule are together a
/// mesh of the sphere under the strict rule if and only if no pair of vertices is a scar of both.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/pair_set.hpp"

namespace hexatlas::flips {

class Peeling {
 public:
  using VertexId = complex::VertexId;
  using Dart = std::uint32_t;  ///< side i of quad q is dart 4 q + i; it leads from its origin
  static constexpr VertexId kNoVertex = ~VertexId{0};
  /// Other sides of the same quad.
  [[nodiscard]] static Dart next(Dart d) noexcept { return (d & ~3U) | ((d + 1) & 3U); }
  [[nodiscard]] static Dart prev(Dart d) noexcept { return (d & ~3U) | ((d + 3) & 3U); }
  [[nodiscard]] static Dart opposite(Dart d) noexcept { return d ^ 2U; }

  /// The quads taken away at once: a bottom, and those across some of its sides, one bit each.
  /// Bottom and sides name a patch as in flips::Flip.
  struct Patch {
    std::uint32_t bottom = 0;
    std::uint8_t sides = 0;
    friend bool operator==(const Patch&, const Patch&) = default;
  };
  /// The hexahedron below a patch: top[i] lies below bottom[i], inside; kNoVertex where it is new.
  struct Prism {
    std::array<VertexId, 4> bottom{}, top{};
  };

  /// Requires a sphere: coherently oriented quads, counter-clockwise seen from outside, over
  /// vertices 0 .. vertices-1 that are all used; 3-connected.
  Peeling(std::span<const complex::BoundaryQuad> sphere, std::size_t vertices);

  /// Quads of the cavity's boundary are numbered in the order in which they came up. The numbers of
  /// those that are gone are not used again unless the flip is undone.
  [[nodiscard]] std::size_t quads() const noexcept { return live_count_; }
  [[nodiscard]] std::uint32_t quad_numbers() const noexcept {
    return static_cast<std::uint32_t>(live_.size());
  }
  [[nodiscard]] bool is_live(std::uint32_t quad) const noexcept { return live_[quad] != 0; }
  [[nodiscard]] VertexId origin(Dart d) const noexcept { return origin_[d]; }
  [[nodiscard]] Dart twin(Dart d) const noexcept { return twin_[d]; }
  [[nodiscard]] std::uint32_t degree(VertexId v) const noexcept { return degree_[v]; }

  /// Whether the patch is one, and its hexahedron may be taken off under the strict rule.
  /// Requires a live bottom. Cost: at most 12 look-ups.
  [[nodiscard]] bool may_take(Patch patch, Prism& prism) const noexcept;
  /// Takes it off. Requires may_take(patch, prism). New quads get the numbers from the former
  /// quad_numbers() on. New vertices likewise from vertices() on.
  void take(Patch patch, const Prism& prism);
  /// Puts the hexahedron that was taken off last back. Requires that there is one.
  void put_back();

  /// The hexahedra taken off so far, on vertices 0 .. vertices()-1; the first are the sphere's.
  /// Right-handed, in the numbering of enum/cells/cube.hpp.
  [[nodiscard]] const std::vector<complex::Hexahedron>& taken() const noexcept { return cells_; }
  [[nodiscard]] std::uint32_t vertices() const noexcept {
    return static_cast<std::uint32_t>(degree_.size());
  }
  /// Whether some hexahedron taken off, or some quad of the cavity, has both vertices.
  [[nodiscard]] bool are_related(VertexId a, VertexId b) const noexcept {
    return related_.has(a, b);
  }

  /// The numbers of the cavity's quads, ascending.
  [[nodiscard]] std::vector<std::uint32_t> live_quads() const;
  /// These quads, each from its dart 0 on.
  [[nodiscard]] std::vector<complex::BoundaryQuad> cavity() const;

 private:
  struct Step {
    Patch patch;
    std::uint32_t vertices = 0;  ///< before
    std::size_t pairs = 0;       ///< before
  };
  [[nodiscard]] Dart across(Patch patch, unsigned side) const noexcept {
    return twin_[4 * patch.bottom + (side & 3U)];
  }
  void link(Dart a, Dart b) noexcept { twin_[a] = b, twin_[b] = a; }
  template <class Visit>
  void for_each_consumed(Patch patch, Visit&& visit) const;
  std::uint32_t new_quad(const std::array<VertexId, 4>& vertices);
  void insert_quads(Patch patch, const Prism& prism);
  void add_cell(const Prism& prism);
  VertexId new_vertex();

  std::vector<VertexId> origin_;  ///< of each dart
  std::vector<Dart> twin_;
  std::vector<std::uint8_t> live_;     ///< of each quad
  std::vector<std::uint32_t> degree_;  ///< of each vertex: the live quads at it
  std::vector<complex::Hexahedron> cells_;
  std::vector<Step> steps_;  ///< one for each cell
  complex::PairSet related_;
  std::vector<std::pair<VertexId, VertexId>> pairs_;  ///< added to related_ by cells
  std::size_t live_count_ = 0;
};

}  // namespace hexatlas::flips
