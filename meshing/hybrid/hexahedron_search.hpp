#pragma once
/// \file
/// Private to meshing/hybrid: the hexahedra whose least vertex is given.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/hybrid/around.hpp"
#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/corners.hpp"
#include "meshing/hybrid/filling.hpp"

namespace hexatlas::hybrid {

/// Letters: a b c d is the bottom, e f g h the top above it; a is the least vertex, b the least of
/// its three neighbours b, d, e, whose directions are right-handed.
class HexahedronSearch {
 public:
  HexahedronSearch(const TetGraph& graph, const Corners& corners, double quality)
      : graph_(graph),
        corners_(corners),
        least_(quality - kRounding),
        quality_(quality),
        filler_(graph) {}

  /// Appends the candidates at around.vertex(); the answer is the number of those left out because
  /// their validity is not known.
  std::size_t visit(const Around& around, CandidateList<8>& found);

 private:
  /// Of a scaled Jacobian as computed here against that of meshing/quality, which decides.
  static constexpr double kRounding = 1e-12;

  /// The corner a: its neighbours and the quads between each two of them.
  struct Start {
    std::uint32_t b = 0, d = 0, e = 0;  ///< positions among the neighbours of a
    Partner bd{}, be{}, de{};
  };
  /// The fourth vertex of a quad at a, with its position among the neighbours of two vertices.
  struct Side {
    Index vertex = 0;
    std::uint32_t at_first = 0, at_second = 0;
    bool is_open = true;  ///< whether there was a g at each corner looked at
    bool has_end = false;
  };
  using Ends = std::vector<std::span<const Corner>>;  ///< possible g for each pair of sides

  void start_at(const Around& around, std::uint32_t b);
  void join(const Around& around, const Start& start);
  bool gather_ends(Index a, const Start& start);
  void join_top(Index a, const Start& start);
  void propose(const std::array<Index, 8>& cell, const Side& c, const Side& f, const Side& h);
  std::size_t offer(const Around& around, CandidateList<8>& found);
  [[nodiscard]] std::optional<Filling> filling(const Around& around,
                                               const std::array<Index, 8>& cell);

  const TetGraph& graph_;
  const Corners& corners_;
  double least_;
  double quality_;
  Filler filler_;
  std::vector<Side> c_, f_, h_;
  Ends at_b_, at_d_, at_e_;
  std::vector<std::array<Index, 8>> proposals_;
};

}  // namespace hexatlas::hybrid
