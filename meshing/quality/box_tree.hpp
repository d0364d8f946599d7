#pragma once
/// \file
/// Boxes with sides along the axes, and which of them meet.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::quality {

/// Closed, with exact bounds: comparisons of doubles are.
struct Box {
  std::array<double, 3> low{}, high{};
  [[nodiscard]] bool meets(const Box& other) const noexcept {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }
};

/// The least box of one point or more. Requires finite coordinates.
[[nodiscard]] Box box_of(std::span<const mesh::Point> points) noexcept;

/// A tree over a list of boxes, halved along the longest side of the box of their centres.
/// Cost: O(n log n) to build, 48 bytes per box twice over; a question visits the nodes whose boxes
/// meet the one that is asked for: near O(log n + answers) for facets of a surface.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Puts into `found` the numbers, ascending, of the boxes after box i that meet it.
  void later_meeting(std::uint32_t i, std::vector<std::uint32_t>& found) const;

 private:
  /// The boxes order_[first .. last), below the two nodes from `children` on; 0: a leaf.
  struct Node {
    Box box;
    std::uint32_t first = 0, last = 0, children = 0;
    std::uint32_t greatest = 0;  ///< number of a box below
  };
  void bound(Node& node) const;
  void halve(const Node& node, std::uint32_t middle);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace hexatlas::quality
