#pragma once
/// \file
/// Beam search over symmetric fronts: collars of a boundary that its involution takes to
/// themselves, grown inwards orbit by orbit (symmetric_front.hpp).
///
/// Level h holds the states reached with h hexahedra; an orbit has one or two, so a level has
/// states that come from each of the two before it. Of one level all states are there to be looked
/// at, then some are chosen and expanded: in each class (boundary and involution) those with the
/// fewest scars first, and the first ones of all classes before the second ones, as in beam.hpp.
/// If no limit was hit, the search was exhaustive: it saw the state of every symmetric collar that
/// orbits build while boundaries have at most max_quads quads after each orbit, with the least
/// number of hexahedra that leads to it.
/// Memory: about 240 bytes for each state of the two levels ahead and each one expanded.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/flips/beam.hpp"
#include "enum/flips/symmetric_front.hpp"

namespace hexatlas::flips {

class SymmetricBeam {
 public:
  struct Node {
    SymmetricState state;
    std::uint32_t parent = 0;  ///< among the nodes expanded; of the start: 0
    Orbit orbit;               ///< glued on front_of() the parent's state
  };

  /// Level 0 is the start alone. Requires options within their ranges, max_quads at most
  /// kMaxSymmetricQuads, and a symmetric front with a 3-connected boundary.
  /// Of the options use_dominance does nothing here; max_fronts counts states in memory.
  SymmetricBeam(const SymmetricFront& start, const BeamOptions& options);

  [[nodiscard]] int level() const noexcept { return level_; }
  /// The states of this level, none twice, and none that an earlier level expanded.
  [[nodiscard]] std::span<const Node> nodes() const noexcept { return open_[0].nodes(); }
  /// Expands those of them that are chosen, and goes on to the next level, which may have no
  /// states even though the one after it has some. Returns whether any are left.
  bool expand_level();
  /// Whether no limit was hit.
  [[nodiscard]] bool is_exhaustive() const noexcept { return !is_truncated_; }

  /// The hexahedra on the way from the start to a node of this level. Some numbers of vertices are
  /// left out.
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

  [[nodiscard]] std::vector<std::uint32_t> choose();
  void expand(std::uint32_t begin, std::uint32_t end);

  BeamOptions options_;
  SymmetricState start_;
  canon::Labelling start_label_{};
  bool start_is_mirrored_ = false;
  NodeSet expanded_;
  std::array<NodeSet, 3> open_;  ///< this level, the next, the one after it
  int level_ = 0;
  bool is_truncated_ = false;
};

}  // namespace hexatlas::flips
