#pragma once
/// \file
/// planar_code, the exchange format of plantri and its relatives, for quadrangulations of the
/// sphere.
///
/// Definition. docs/formats/planar_code.md: for each graph one byte with the number of vertices,
/// then for each vertex its neighbours clockwise, from 1, closed by 0.

#include <functional>
#include <string>
#include <string_view>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::quads {

inline constexpr std::string_view kPlanarCodeHeader = ">>planar_code<<";

/// Appends one graph, each list from the least neighbour on. Requires a valid quadrangulation
/// without multiple edges.
void append_planar_code(const complex::Quadrangulation& q, std::string& bytes);

/// Visits the graphs of a file, with or without the header, in order; vertices keep their names,
/// less one, and what is clockwise in the file is clockwise seen from outside. `name` is the file
/// in messages. Throws InvalidInput with the number of the graph, from 1, if one is cut short or is
/// not a simple quadrangulation of the sphere with 2 .. complex::kMaxQuads quads; those before were
/// visited. Cost: linear, and O(vertices^2) per graph.
void for_each_in_planar_code(std::string_view bytes, const std::string& name,
                             const std::function<void(const complex::Quadrangulation&)>& visit);

}  // namespace hexatlas::quads
