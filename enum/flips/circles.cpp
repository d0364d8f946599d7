#include "enum/flips/circles.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::Dart;
using complex::Quadrangulation;
using complex::Vertex;

class Paths {
 public:
  Paths(const Graph& graph, int vertices, int length)
      : graph_(graph), length_(static_cast<std::size_t>(length)) {
    for (int v = 0; v < vertices; ++v) {
      path_ = {static_cast<Vertex>(v)};
      extend(bit(static_cast<Vertex>(v)) * 2 - 1);
    }
  }
  [[nodiscard]] std::vector<Circle> closed() { return std::move(closed_); }

 private:
  /// `barred`: the vertices up to the first one, which is the least, and those of the path.
  void extend(VertexSet barred) {
    VertexSet candidates = graph_[path_.back()] & ~barred;
    if (path_.size() + 1 == length_) candidates &= graph_[path_.front()];
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto v = static_cast<Vertex>(std::countr_zero(candidates));
      path_.push_back(v);
      if (path_.size() < length_)
        extend(barred | bit(v));
      else if (path_[1] < v)
        closed_.push_back(path_);
      path_.pop_back();
    }
  }

  const Graph& graph_;
  std::size_t length_;
  Circle path_;
  std::vector<Circle> closed_;
};

}  // namespace

Graph graph_of(const Quadrangulation& q) {
  core::expects(q.quads() <= kMaxFrontQuads, "a graph has at most 64 vertices");
  Graph near{};
  for (int d = 0; d < q.darts(); ++d) {
    const auto dart = static_cast<Dart>(d);
    near[q.origin(dart)] |= bit(q.origin(Quadrangulation::next(dart)));
  }
  return near;
}

std::vector<Circle> circles(const Graph& graph, int vertices, int length) {
  core::expects(length >= 4 && length % 2 == 0, "a circle of a quadrangulation is even");
  return Paths(graph, vertices, length).closed();
}

/// The quads on the left of a circle.
std::vector<bool> left_of(const Quadrangulation& q, const Circle& circle) {
  const auto is_on_circle = [&](Dart d) {
    const auto at = std::find(circle.begin(), circle.end(), q.origin(d));
    const Vertex to = q.origin(Quadrangulation::next(d));
    return at != circle.end() && (at + 1 == circle.end() ? circle.front() : *(at + 1)) == to;
  };
  std::vector<bool> left(static_cast<std::size_t>(q.quads()));
  std::vector<int> pending;
  const auto reach = [&](Dart d) {
    const complex::Quad quad = Quadrangulation::quad_of(d);
    if (left[quad]) return;
    left[quad] = true;
    pending.push_back(quad);
  };
  for (int d = 0; d < q.darts(); ++d)
    if (is_on_circle(static_cast<Dart>(d))) reach(static_cast<Dart>(d));
  while (!pending.empty()) {
    const int quad = pending.back();
    pending.pop_back();
    for (int side = 0; side < 4; ++side) {
      const Dart d = Quadrangulation::dart(quad, side);
      if (!is_on_circle(d)) reach(q.twin(d));
    }
  }
  return left;
}

}  // namespace hexatlas::flips
