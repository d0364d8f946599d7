#pragma once
/// \file
/// Internal to the judge: all laws of a mesh that concern its hexahedra alone, shared by the judges
/// of meshes and of tables.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tables/check/mesh.hpp"
#include "tables/check/verdict.hpp"

namespace hexatlas::check {

/// Judges hexahedra on the vertices 0 .. vertex_count - 1; a vertex in none of them breaks
/// kUnusedPoint unless `may_be_unused` says otherwise (it has vertex_count elements, or none for
/// "no vertex may"). `removal_order`, if not empty, is a claimed shelling read backwards, and is
/// then the only proof of ball that is considered. Sets `boundary` to the boundary quads, counter-
/// clockwise from outside, if the verdict accepts.
[[nodiscard]] Verdict judge_cells(std::span<const Hexahedron> cells, std::uint64_t vertex_count,
                                  const std::vector<bool>& may_be_unused,
                                  std::span<const std::uint32_t> removal_order,
                                  std::vector<Quad>& boundary);

/// The same cycle with its least vertex first; two oriented cycles are equal up to rotation exactly
/// when these are equal.
[[nodiscard]] Quad least_first(const Quad& quad);
/// All cycles with their least vertices first, in ascending order.
[[nodiscard]] std::vector<Quad> sorted_cycles(std::vector<Quad> quads);
[[nodiscard]] Quad reversed(const Quad& quad);
/// A quad that is in one of two sorted lists and not in the other, and which list has it. The lists
/// must differ.
[[nodiscard]] std::string difference(const std::vector<Quad>& mesh,
                                     const std::vector<Quad>& surface);

}  // namespace hexatlas::check
