#include "meshing/quality/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace hexatlas::quality {
namespace {

constexpr std::uint32_t kLeafBoxes = 6;

void include(Box& box, const Box& other) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], other.low[k]);
    box.high[k] = std::max(box.high[k], other.high[k]);
  }
}

/// Halved first: a sum could overflow.
double centre(const Box& box, std::size_t axis) noexcept {
  return box.low[axis] / 2 + box.high[axis] / 2;
}

}  // namespace

Box box_of(std::span<const mesh::Point> points) noexcept {
  const mesh::Point& p = points.front();
  Box result{{p.x, p.y, p.z}, {p.x, p.y, p.z}};
  for (const mesh::Point& q : points.subspan(1))
    include(result, {{q.x, q.y, q.z}, {q.x, q.y, q.z}});
  return result;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes_.empty()) return;
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size()), 0, 0});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Node node = nodes_[n];
    bound(node);
    if (node.last - node.first > kLeafBoxes) {
      const std::uint32_t middle = node.first + (node.last - node.first) / 2;
      halve(node, middle);
      node.children = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({{}, node.first, middle, 0, 0});
      nodes_.push_back({{}, middle, node.last, 0, 0});
    }
    nodes_[n] = node;
  }
}

void BoxTree::bound(Node& node) const {
  node.box = boxes_[order_[node.first]];
  for (std::uint32_t k = node.first; k < node.last; ++k) {
    include(node.box, boxes_[order_[k]]);
    node.greatest = std::max(node.greatest, order_[k]);
  }
}

void BoxTree::halve(const Node& node, std::uint32_t middle) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  std::size_t longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = high[axis] = centre(boxes_[order_[node.first]], axis);
    for (std::uint32_t k = node.first; k < node.last; ++k) {
      low[axis] = std::min(low[axis], centre(boxes_[order_[k]], axis));
      high[axis] = std::max(high[axis], centre(boxes_[order_[k]], axis));
    }
    if (high[axis] / 2 - low[axis] / 2 > high[longest] / 2 - low[longest] / 2) longest = axis;
  }
  std::nth_element(order_.begin() + node.first, order_.begin() + middle, order_.begin() + node.last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double at_a = centre(boxes_[a], longest);
                     const double at_b = centre(boxes_[b], longest);
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
}

void BoxTree::later_meeting(std::uint32_t i, std::vector<std::uint32_t>& found) const {
  found.clear();
  std::array<std::uint32_t, 64> open{};  // of 2^32 boxes a halving leaves a leaf in 32 steps
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    if (node.greatest <= i || !node.box.meets(boxes_[i])) continue;
    if (node.children != 0) {
      open[count++] = node.children;
      open[count++] = node.children + 1;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.last; ++k)
      if (order_[k] > i && boxes_[order_[k]].meets(boxes_[i])) found.push_back(order_[k]);
  }
  std::sort(found.begin(), found.end());
}

}  // namespace hexatlas::quality
