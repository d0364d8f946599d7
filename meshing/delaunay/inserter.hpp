#pragma once
/// \file
/// Private to meshing/delaunay: one point after another into a Delaunay triangulation, or, with
/// weights, into a regular one.
///
/// Method. A. Bowyer, D. F. Watson (1981): the tetrahedra whose open circumscribed ball contains
/// the point, its cavity, give way to the tetrahedra that join the facets of the cavity's boundary
/// to the point. The cavity is connected, and found from the tetrahedron that contains the point,
/// to which a walk leads. Ties are decided as docs/theory/delaunay-ties.md says, so the
/// triangulation does not depend on the order of insertion.
///
/// With weights the ball is that of the orthosphere. A site that is not in conflict with the
/// tetrahedron that contains it is in no tetrahedron, now or later; sites inside of a cavity are in
/// none from then on.
///
/// Several threads. An inserter with a region removes only tetrahedra whose vertices, the ghost
/// vertex apart, all lie in the region, and looks at neighbours of such, or joins new ones to them.
/// A neighbour shares at least two vertices with it besides the ghost vertex, so that no inserter
/// of another region reaches it: docs/theory/parallel-delaunay.md.
///
/// Cost for points in a good order: about 20 tetrahedra of the cavity, 27 new ones.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/common_unit.hpp"
#include "meshing/delaunay/digging.hpp"
#include "meshing/delaunay/four_facets.hpp"
#include "meshing/delaunay/site.hpp"
#include "meshing/delaunay/star_links.hpp"
#include "meshing/delaunay/walk.hpp"
#include "realize/exact/in_orthosphere.hpp"

namespace hexatlas::delaunay {

enum class Outcome : std::uint8_t {
  inserted,
  duplicate,  ///< of a site that is a vertex already, with the same weight
  hidden,     ///< by others: in no tetrahedron
  postponed,  ///< its cavity leaves the region
  no_room     ///< for the new tetrahedra
};

/// As far apart as processors fetch memory, in pairs of lines: threads have one each.
inline constexpr std::size_t kApart = 128;

template <class Index, bool kIsWeighted>
class alignas(kApart) Inserter final : private Digging<Index>::Owner {
 public:
  using Claim = typename StarLinks<Index>::Claim;

  /// Claims and weights: one for each site. Weights may be null if there are none.
  Inserter(Cells<Index>& cells, const Site* sites, Claim* claims, const double* weights);

  /// The five tetrahedra on four sites and the ghost vertex. Requires: no cells; right-handed.
  void begin(const std::array<Index, 4>& sites);
  /// Leaves everything as it was unless it answers `inserted`. Requires begin(), by any inserter
  /// of these cells, and a start that is in use and within the region.
  Outcome insert(Index site);

  /// The next walk begins where it says, within its region if there is one.
  [[nodiscard]] Walk<Index>& walk() noexcept { return walk_; }
  /// Of all sites that are to be inserted.
  void use(const CommonUnit& unit) noexcept { cavity_.short_below = unit.short_below(); }
  /// Sites, claims and weights have moved; there may be more of them.
  void use(const Site* sites, Claim* claims, const double* weights) noexcept;

  /// After `duplicate`: the vertex at the same place.
  [[nodiscard]] Index twin() const noexcept { return twin_; }
  /// After `inserted`: the tetrahedra at the site.
  [[nodiscard]] std::span<const Index> made() const noexcept {
    return {new_cells_.data(), cavity_.facet_count};
  }

  /// The vertex of the cell that is at the place, or kNone.
  [[nodiscard]] Index vertex_at(const Cell<Index>& cell, const Site& place) const noexcept;

 private:
  using Tetrahedron = Cell<Index>;
  using Facet = CavityFacet<Index>;

  [[nodiscard]] bool dig(Index start, const Site& p);
  [[nodiscard]] unsigned conflicting_exactly(const Tetrahedron& cell, unsigned which,
                                             const Site& p) const override;
  void make_room() override;
  [[nodiscard]] bool has_room();
  void make_cells();
  void undo();
  void fill(Index site);
  [[nodiscard]] bool number_vertices();
  [[nodiscard]] Index first_on_hull() const noexcept;
  /// Whether the filter for four facets was asked before.
  enum class Filtered : std::uint8_t { no, in_vain };
  [[nodiscard]] bool conflicts(const Tetrahedron& cell, const Site& p, Filtered filtered) const;
  [[nodiscard]] bool is_in_ball(const Tetrahedron& cell, const Site& p, Filtered filtered) const;
  [[nodiscard]] exact::WeightedPoint3 weighted(const Site& site) const noexcept;

  Cells<Index>& cells_;
  const Site* sites_;
  const double* weights_;
  const FourFacets& signs_;
  Walk<Index> walk_;
  StarLinks<Index> links_;
  Digging<Index> cavity_;
  std::vector<Index> doomed_;  ///< of the cavity, as its facets
  std::vector<Facet> facets_;
  std::vector<Index> new_cells_;  ///< for each facet
  std::vector<Index> vertices_;   ///< of the cavity, each once or more
  std::vector<Index> free_;
  Index twin_ = kNone;
};

}  // namespace hexatlas::delaunay
