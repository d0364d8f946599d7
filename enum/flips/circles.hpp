#pragma once
/// \file
/// Circles of edges of a quadrangulation.

#include <array>
#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/front.hpp"

namespace hexatlas::flips {

/// The vertices of a circle in order; the first is a neighbour of the last.
using Circle = std::vector<complex::Vertex>;

/// The neighbours of each vertex.
using Graph = std::array<VertexSet, kMaxFrontQuads + 2>;
[[nodiscard]] Graph graph_of(const complex::Quadrangulation& q);

/// The circles of a length without repeated vertices, each once, in one of its two directions, from
/// its least vertex. Requires an even length of at least 4.
/// Cost: that of all paths of this length.
[[nodiscard]] std::vector<Circle> circles(const Graph& graph, int vertices, int length);

/// Which quads lie on the left of a circle. Requires that consecutive vertices are neighbours and
/// that the graph is simple.
[[nodiscard]] std::vector<bool> left_of(const complex::Quadrangulation& q, const Circle& circle);

}  // namespace hexatlas::flips
