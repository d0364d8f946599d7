#pragma once
/// \file
/// Beam search over symmetric fronts, by orbits (symmetric_front.hpp) and crowns (crown.hpp):
/// collars of a boundary that its involution takes to themselves, grown inwards, or balls with an
/// involution, grown outwards from small ones.
///
/// Level h holds the states reached with h hexahedra; an orbit has one or two, a crown
/// as many as the degree of its vertex, so a level has states that come from each of some before
/// it. Of one level all states are there to be looked at, then some are chosen and expanded: in
/// each class (boundary and involution) those with the fewest scars first, and the first ones of
/// all classes before the second ones, as in beam.hpp.
/// If no limit was hit, the search was exhaustive: it saw the state of everything that orbits and
/// crowns build on a start while boundaries have at most max_quads quads after each of them, with
/// the least number of hexahedra that leads to it.
/// Memory: about 240 bytes for each state of the levels ahead, two but for crowns, and each one
/// expanded.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/flips/beam.hpp"
#include "enum/flips/symmetric_front.hpp"

namespace hexatlas::flips {

/// What a symmetric beam begins with, at the level of its number of hexahedra. layers.rim gives the
/// mesh vertex of each boundary vertex of the front, which is mirrored as `layers` says.
struct SymmetricStart {
  SymmetricFront front;
  Layers layers;
};

/// How promising a node is: of two the one with the smaller number. kNoPromise: nothing is known.
using Promise = std::uint32_t;
inline constexpr Promise kNoPromise = ~Promise{0};

/// Whether collars are *wide*: with boundaries too long for the states of a Beam. They are grown by
/// a SymmetricBeam that begins with front_without_symmetry().
[[nodiscard]] constexpr bool are_wide(const BeamOptions& collars) noexcept {
  return collars.max_quads > kMaxStateQuads;
}

/// No hexahedra, the boundary being that of the front.
[[nodiscard]] SymmetricStart start_of_collars(const SymmetricFront& front);

/// All shellable balls of at most so many hexahedra whose state has an involution, with each one up
/// to conjugacy: the ones that reverse the orientation, or the half-turns. Cost: that of a search
/// without limits for all shellable balls, a hundredth of a second for 6 hexahedra, one for 9.
[[nodiscard]] std::vector<SymmetricStart> small_symmetric_balls(int max_hexahedra,
                                                                bool are_mirrored);

class SymmetricBeam {
 public:
  struct Node {
    SymmetricState state;
    std::uint32_t parent = 0;  ///< among the nodes expanded; of a start: its place among the starts
    Orbit orbit;  ///< or crown, glued on front_of() the parent's state; of a start: of size 0
    std::uint16_t level = 0;
    [[nodiscard]] bool is_start() const noexcept { return orbit.size == 0; }
  };

  /// At level 0, which the starts without hexahedra have. Requires options within their ranges,
  /// max_quads at most kMaxSymmetricQuads, and symmetric fronts with 3-connected boundaries.
  /// Of the options use_dominance does nothing here; max_fronts counts states in memory.
  SymmetricBeam(std::vector<SymmetricStart> starts, Growth growth, const BeamOptions& options);

  [[nodiscard]] int level() const noexcept { return level_; }
  /// The states of this level, none twice, and none that an earlier level expanded.
  [[nodiscard]] std::span<const Node> nodes() const noexcept { return open_[0].nodes(); }
  /// Expands those of them that are chosen, and goes on to the next level, which may have no
  /// states even though ones after it have some. Returns whether any are left.
  /// `promises`: of each of nodes(), or none. Then half of those chosen are the most promising
  /// ones, whatever their class, as far as there are any with a promise.
  bool expand_level(std::span<const Promise> promises = {});
  /// Whether no limit was hit.
  [[nodiscard]] bool is_exhaustive() const noexcept { return !is_truncated_; }
  /// Those expanded so far, in order of level.
  [[nodiscard]] std::span<const Node> expanded() const noexcept { return expanded_.nodes(); }

  /// The hexahedra of a start and on the way from there to a node, of this level or expanded. Some
  /// numbers of vertices are left out.
  [[nodiscard]] Layers layers_to(const Node& node) const;

 private:
  /// Nodes with distinct states.
  class NodeSet {
   public:
    [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return nodes_; }
    [[nodiscard]] bool contains(const SymmetricState& state) const noexcept;
    void insert(const Node& node);
    void remove_those_of(const NodeSet& other);

   private:
    [[nodiscard]] std::size_t slot_of(const SymmetricState& state) const noexcept;
    void make_slots(std::size_t count);
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> slots_;  ///< index plus 1, 0: free
  };

  [[nodiscard]] std::vector<std::uint32_t> choose(std::span<const Promise> promises);
  void expand(std::uint32_t begin, std::uint32_t end);
  [[nodiscard]] std::size_t states() const noexcept;  ///< in memory

  BeamOptions options_;
  Growth growth_;
  std::vector<Layers> starts_;  ///< with the canonical vertices on their rims
  NodeSet expanded_;
  std::vector<NodeSet> open_;  ///< this level, the next, and so on
  int level_ = 0;
  bool is_truncated_ = false;
};

}  // namespace hexatlas::flips
