#pragma once
/// \file
/// All hexahedral meshes with a given boundary within limits, up to its automorphisms.
///
/// Classes. Two meshes are of one class if an automorphism of the boundary, mirror symmetries
/// included, and a numbering of the interior vertices take one to the other. Each class is met
/// once, by the image whose path comes first (path_symmetry.hpp).

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/hexes/search.hpp"
#include "enum/search/estimate.hpp"
#include "enum/search/pool.hpp"

namespace hexatlas::hexes {

enum class Topology : std::uint8_t { ball, no_ball, undecided };

/// A mesh of a boundary, whose vertices come first, as they are numbered there.
struct Hexmesh {
  complex::HexComplex mesh;
  int automorphisms = 1;  ///< of the boundary that the mesh has too
  Topology topology = Topology::undecided;
};

using HexFrontier = search::Frontier<HexSearch::Choice, Hexmesh>;

/// What is searched for. The counting signature, nodes, belongs to all of this.
class HexmeshProblem {
 public:
  /// Requires a 3-connected boundary and limits within their ranges; limits.up_to_symmetry is set
  /// here.
  HexmeshProblem(const complex::Quadrangulation& boundary, const SearchLimits& limits);

  [[nodiscard]] const complex::Quadrangulation& boundary() const noexcept { return boundary_; }
  [[nodiscard]] const SearchLimits& limits() const noexcept { return limits_; }
  /// Order of the group of the boundary.
  [[nodiscard]] int symmetries() const noexcept { return symmetries_; }

  /// Part `index` of `parts` of a new search, from which its classes add up to those of the whole.
  [[nodiscard]] HexFrontier begin(std::size_t index = 0, std::size_t parts = 1) const;
  /// See search::explore_pending().
  void go_on(HexFrontier& frontier, const search::PoolOptions& options,
             const std::function<bool()>& after_round) const;
  /// Nodes of the whole search. Requires probes >= 2.
  [[nodiscard]] search::Estimate estimate(std::uint64_t probes, std::uint64_t seed,
                                          int threads) const;

 private:
  [[nodiscard]] std::optional<Hexmesh> collect(const HexSearch& found) const;

  complex::Quadrangulation boundary_;
  SearchLimits limits_;
  HexSearch
      start_;  ///< in its initial state: copied for each part, which is quicker than made anew
  int symmetries_;
};

/// Whether a mesh whose boundary is a sphere is a ball: by the laws and a shelling, or by what no
/// ball has, edges that do not join two colours or a first homology modulo 2. Requires a connected
/// mesh.
[[nodiscard]] Topology topology_of(const complex::HexComplex& mesh);

}  // namespace hexatlas::hexes
