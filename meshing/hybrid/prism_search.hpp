#pragma once
/// \file
/// Private to meshing/hybrid: the prisms whose least vertex is given, and the pyramids over a
/// facet.

#include <array>
#include <cstdint>

#include "meshing/hybrid/around.hpp"
#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/corners.hpp"
#include "meshing/hybrid/filling.hpp"

namespace hexatlas::hybrid {

/// Letters: the triangle a b c, above it d e f; a is the least vertex, and b, c, d, seen from a,
/// are right-handed.
class PrismSearch {
 public:
  PrismSearch(const TetGraph& graph, const Corners& corners, double quality)
      : graph_(graph), corners_(corners), quality_(quality), filler_(graph) {}

  /// Appends the candidates at around.vertex().
  void visit(const Around& around, CandidateList<6>& found);

 private:
  /// The corner a: positions of its neighbours, and the quads there.
  struct Start {
    std::uint32_t b = 0, c = 0, d = 0;
    Partner bd{}, cd{};
    TetIndex inside = 0;
  };

  void over_triangle(const Around& around, const Around::Beyond& triangle, CandidateList<6>& found);
  void join(const Around& around, const Start& start, CandidateList<6>& found);
  void offer(const std::array<Index, 6>& cell, TetIndex start, CandidateList<6>& found);

  const TetGraph& graph_;
  const Corners& corners_;
  double quality_;
  Filler filler_;
};

/// The pyramids with two tetrahedra, the first of them given, and the common facet's vertices as
/// apex in turn.
class PyramidSearch {
 public:
  PyramidSearch(const TetGraph& graph, double quality)
      : graph_(graph), quality_(quality), filler_(graph) {}

  /// Appends the candidates over the facets of t with greater tetrahedra beyond.
  void visit(TetIndex t, CandidateList<5>& found);

 private:
  const TetGraph& graph_;
  double quality_;
  Filler filler_;
};

}  // namespace hexatlas::hybrid
