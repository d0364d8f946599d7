#pragma once
/// \file
/// Private to meshing/delaunay: one point after another into a Delaunay triangulation.
///
/// Method. A. Bowyer, D. F. Watson (1981): the tetrahedra whose open circumscribed ball contains
/// the point, its cavity, give way to the tetrahedra that join the facets of the cavity's boundary
/// to the point. The cavity is connected, and found from the tetrahedron that contains the point,
/// to which a walk leads. Ties are decided as docs/theory/delaunay-ties.md says, so the
/// triangulation does not depend on the order of insertion.
///
/// Several threads. An inserter with a region touches only tetrahedra whose vertices, the ghost
/// vertex apart, all lie in the region, and looks at neighbours of such. A neighbour shares at
/// least two vertices with it besides the ghost vertex, so that no inserter of another region
/// touches it: docs/theory/parallel-delaunay.md.
///
/// Cost for points in a good order: about 20 tetrahedra of the cavity, 27 new ones.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/common_unit.hpp"
#include "meshing/delaunay/four_facets.hpp"
#include "meshing/delaunay/local_vertices.hpp"
#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

enum class Outcome : std::uint8_t {
  inserted,
  duplicate,  ///< of a site that is a vertex already
  postponed,  ///< its cavity leaves the region
  no_room     ///< for the new tetrahedra
};

/// Keys from `first` on and below `end`; all others if `is_inverted`.
struct Region {
  std::uint64_t first = 0, end = ~std::uint64_t{0};
  bool is_inverted = false;
  [[nodiscard]] bool has(const Site& site) const noexcept {
    return (site.key >= first && site.key < end) != is_inverted;
  }
};

template <class Index>
class Inserter {
 public:
  using Claim = typename LocalVertices<Index>::Claim;

  /// Claims: one for each site.
  Inserter(Cells<Index>& cells, const Site* sites, Claim* claims);

  /// The five tetrahedra on four sites and the ghost vertex. Requires: no cells; right-handed.
  void begin(const std::array<Index, 4>& sites);
  /// Leaves everything as it was unless it answers `inserted`. Requires begin(), by any inserter
  /// of these cells, and a start that is in use and within the region.
  Outcome insert(Index site);

  /// Where the next walk begins.
  [[nodiscard]] Index start() const noexcept { return last_; }
  void start_at(Index cell) noexcept { last_ = cell; }
  void confine_to(const Region& region) noexcept {
    region_ = region;
    is_confined_ = true;
  }
  void release() noexcept { is_confined_ = false; }
  /// A place inside of the hull, more or less: the nearer to its middle, the shorter the walks over
  /// the hull. None need end if it is not.
  void look_from(const Site& centre) noexcept { centre_ = centre; }
  /// Of all sites that are to be inserted.
  void use(const CommonUnit& unit) noexcept { short_below_ = unit.short_below(); }
  /// Sites and claims have moved; there may be more of them.
  void use(const Site* sites, Claim* claims) noexcept;

  /// After `duplicate`: the vertex at the same place.
  [[nodiscard]] Index twin() const noexcept { return twin_; }
  /// After `inserted`: the tetrahedra at the site.
  [[nodiscard]] std::span<const Index> made() const noexcept {
    return {new_cells_.data(), facet_count_};
  }

  /// The tetrahedron that contains the place, or a facet of the hull that it lies strictly beyond;
  /// kNone if every way to it leaves the region; the next walk then begins where this one did.
  [[nodiscard]] Index located(const Site& place);
  /// The vertex of the cell that is at the place, or kNone.
  [[nodiscard]] Index vertex_at(const Cell<Index>& cell, const Site& place) const noexcept;

 private:
  using Tetrahedron = Cell<Index>;
  static constexpr std::size_t kEdges =
      std::size_t{LocalVertices<Index>::kMost} * LocalVertices<Index>::kMost;

  /// Of the cavity's boundary: with a vertex inside before them, the vertices are right-handed.
  struct Facet {
    std::array<Index, 3> vertices;
    Index outer;  ///< the same facet in the tetrahedron that stays
  };
  using Numbers = std::array<std::uint32_t, 3>;
  /// Of a tetrahedron of the cavity, by its facets.
  struct Neighbors {
    FourSites corners{}, apexes{};
    std::array<Index, 4> facets{};  ///< references to them in the neighbours
    unsigned alive = 0;             ///< the neighbours that are not marked, a bit for each
  };

  [[nodiscard]] bool dig(Index start, const Site& p);
  [[nodiscard]] Neighbors neighbors_of(const Tetrahedron& cell) const noexcept;
  [[nodiscard]] bool leaves_region(const Neighbors& around) const noexcept;
  [[nodiscard]] unsigned conflicting(const Neighbors& around, const Site& p) const;
  [[nodiscard]] unsigned conflicting_exactly(const Neighbors& around, unsigned facets,
                                             const Site& p) const;
  [[nodiscard]] bool has_room();
  void make_room();
  void undo();
  void fill(Index site);
  void collect_facets();
  [[nodiscard]] bool number_vertices();
  void link();
  void link_by_sorting();
  [[nodiscard]] Index first_on_hull() const noexcept;
  [[nodiscard]] Index visible_from(const Site& p) const;
  [[nodiscard]] unsigned facets_towards(const Tetrahedron& cell, unsigned entered,
                                        const Site& p) const;
  [[nodiscard]] unsigned facets_within(const Tetrahedron& cell) const noexcept;
  [[nodiscard]] bool is_beyond(const Tetrahedron& cell, unsigned vertex, const Site& p) const;
  [[nodiscard]] bool conflicts(const Tetrahedron& cell, const Site& p) const;

  Cells<Index>& cells_;
  const Site* sites_;
  const FourFacets& signs_;
  Region region_;
  bool is_confined_ = false;
  Site centre_;
  double short_below_ = -1;  ///< as for FourFacets::conflict()
  LocalVertices<Index> locals_;
  std::vector<Index> edges_;  ///< references, by two local numbers
  /// The cells of the cavity: references to the facets through which they were found, of the first
  /// one any.
  std::vector<Index> doomed_;
  std::size_t doomed_count_ = 0;
  std::vector<std::uint32_t>
      walls_;                  ///< of the cavity: 4 i + j for facet j of the cell of doomed_[i]
  std::vector<Facet> facets_;  ///< the same
  std::size_t facet_count_ = 0;
  std::vector<Index> new_cells_;  ///< for each facet
  std::vector<Numbers> numbers_;  ///< of the vertices of each facet
  std::vector<Index> free_;
  std::vector<std::array<Index, 3>> far_edges_;  ///< two vertices and a reference
  Index last_ = kNone;
  Index twin_ = kNone;
};

}  // namespace hexatlas::delaunay
