#pragma once
/// \file
/// Private to meshing/delaunay: from tetrahedron to tetrahedron towards a place.
///
/// Method. Through any facet that the place lies strictly beyond. In a Delaunay triangulation, and
/// in a regular one, no tetrahedron is met twice: docs/theory/delaunay-ties.md. A walk that begins
/// at the hull first goes over the hull; why that is safe: docs/theory/parallel-delaunay.md.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/four_facets.hpp"
#include "meshing/delaunay/region.hpp"
#include "meshing/delaunay/site.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::delaunay {

/// The vertex opposite to facet j of four_facets.hpp.
[[nodiscard]] constexpr unsigned opposite_of(unsigned facet) { return (facet + 3) & 3U; }
[[nodiscard]] constexpr unsigned facet_opposite(unsigned vertex) { return (vertex + 1) & 3U; }

template <class Index>
class Walk {
 public:
  Walk(const Cells<Index>& cells, const Site* sites)
      : cells_(cells), sites_(sites), signs_(four_facets()) {}
  /// The sites have moved; there may be more of them.
  void use(const Site* sites) noexcept { sites_ = sites; }

  /// Where the next walk begins.
  [[nodiscard]] Index start() const noexcept { return last_; }
  void start_at(Index cell) noexcept { last_ = cell; }
  void confine_to(const Region& region) noexcept {
    region_ = region;
    is_confined_ = true;
  }
  void release() noexcept {
    region_ = {};
    is_confined_ = false;
  }
  [[nodiscard]] bool is_confined() const noexcept { return is_confined_; }
  /// Empty unless is_confined().
  [[nodiscard]] const Region& region() const noexcept { return region_; }
  /// A place inside of the hull, more or less: the nearer to its middle, the shorter the walks over
  /// the hull. None need end if it is not.
  void look_from(const Site& centre) noexcept { centre_ = centre; }

  /// The tetrahedron that contains the place, or a facet of the hull that it lies strictly beyond;
  /// kNone if every way to it leaves the region; the next walk then begins where this one did.
  [[nodiscard]] Index located(const Site& place);
  /// A cell within the region, near some of its sites, or kNone. No facet of the hull: a walk
  /// begins in the tetrahedron below, of which a vertex may lie outside. Changes where the walk
  /// begins.
  [[nodiscard]] Index cell_within(const Region& region, std::span<const Index> of_region);

 private:
  static constexpr unsigned kMostOnHull = 1000;  ///< steps; more are a sign of a bad centre

  [[nodiscard]] Index visible_from(const Site& p) const;
  [[nodiscard]] unsigned facets_towards(const Cell<Index>& cell, unsigned entered,
                                        const Site& p) const;
  [[nodiscard]] Index way_out(const Cell<Index>& cell, unsigned ways) const noexcept;
  [[nodiscard]] bool is_beyond(const Cell<Index>& cell, unsigned vertex, const Site& p) const;

  Site centre_;
  const Cells<Index>& cells_;
  const Site* sites_;
  const FourFacets& signs_;
  Region region_;
  Index last_ = kNone;
  bool is_confined_ = false;
};

template <class Index>
Index Walk<Index>::located(const Site& place) {
  Index at = last_;
  if (const unsigned ghost = cells_[at].ghost(); ghost < 4) {
    if (const Index seen = visible_from(place); seen != kNone) return seen;
    at = cells_[at].neighbors[ghost] / 4;
  }
  unsigned entered = 4;  // the vertex opposite to the facet through which the walk came
  while (true) {
    const Cell<Index>& cell = cells_[at];
    const unsigned ways = facets_towards(cell, entered, place);
    if (ways == 0) return last_ = at;
    const Index to = way_out(cell, ways);
    if (to == kNone) return kNone;
    at = to / 4;
    entered = static_cast<unsigned>(to % 4);
    if (cells_[at].vertices[entered] == kGhost) return at;
  }
}

template <class Index>
Index Walk<Index>::cell_within(const Region& region, std::span<const Index> of_region) {
  constexpr std::size_t kTries = 8;
  for (std::size_t i = 0; i < kTries && !of_region.empty(); ++i) {
    Index cell = located(sites_[of_region[i * of_region.size() / kTries]]);
    if (cell == kNone) continue;  // the walk is confined, and does not come there
    if (const unsigned ghost = cells_[cell].ghost(); ghost < 4)
      cell = cells_[cell].neighbors[ghost] / 4;
    const auto& vertices = cells_[cell].vertices;
    if (std::all_of(vertices.begin(), vertices.end(),
                    [&](Index v) { return v != kGhost && region.has(sites_[v]); }))
      return cell;
  }
  return kNone;
}

/// From a facet of the hull over others: to one that the place lies strictly beyond, or kNone if it
/// meets none. As in space the walk goes through facets, those of the tetrahedra that join the
/// hull to the centre. These are left-handed, so every sign is turned round. Tetrahedra inside the
/// hull may be long and thin, and many of them on the way.
template <class Index>
Index Walk<Index>::visible_from(const Site& p) const {
  Index at = last_;
  unsigned entered = 4;
  for (unsigned steps = 0; steps < kMostOnHull; ++steps) {
    const Cell<Index>& cell = cells_[at];
    const unsigned ghost = cell.ghost();
    FourSites corners{};
    for (unsigned i = 0; i < 4; ++i) corners[i] = i == ghost ? &centre_ : &sites_[cell.vertices[i]];
    const FacetSigns signs = signs_.beyond(corners, p);
    unsigned ways = 15U & ~(signs.positive | signs.undecided);
    if ((ways >> facet_opposite(ghost) & 1U) != 0) return at;
    if (entered < 4) ways &= ~(1U << facet_opposite(entered));
    const Index to = way_out(cell, ways);
    if (to == kNone) return kNone;
    at = to / 4;
    entered = static_cast<unsigned>(to % 4);
  }
  return kNone;
}

/// The facets, other than that entered through, that the place lies strictly beyond: at least one
/// if there are any.
template <class Index>
unsigned Walk<Index>::facets_towards(const Cell<Index>& cell, unsigned entered,
                                     const Site& p) const {
  FourSites corners{};
  for (unsigned i = 0; i < 4; ++i) corners[i] = &sites_[cell.vertices[i]];
  const FacetSigns signs = signs_.beyond(corners, p);
  const unsigned others = entered < 4 ? 15U & ~(1U << facet_opposite(entered)) : 15U;
  if (const unsigned beyond = signs.positive & others; beyond != 0) return beyond;
  for (unsigned rest = signs.undecided & others; rest != 0; rest &= rest - 1) {
    const auto facet = static_cast<unsigned>(std::countr_zero(rest));
    if (is_beyond(cell, opposite_of(facet), p)) return 1U << facet;
  }
  return 0;
}

/// Across the first of the facets behind which the tetrahedron lies within the region, if there is
/// one; kNone otherwise, as cell 0 is none. Requires that the cell lies within.
template <class Index>
Index Walk<Index>::way_out(const Cell<Index>& cell, unsigned ways) const noexcept {
  for (unsigned rest = ways; rest != 0; rest &= rest - 1) {
    const Index to = cell.neighbors[opposite_of(static_cast<unsigned>(std::countr_zero(rest)))];
    if (!is_confined_) return to;
    const Index apex = cells_[to / 4].vertices[to % 4];
    if (apex == kGhost || region_.has(sites_[apex])) return to;
  }
  return kNone;
}

template <class Index>
bool Walk<Index>::is_beyond(const Cell<Index>& cell, unsigned vertex, const Site& p) const {
  std::array<exact::Point3, 4> points{};
  for (unsigned i = 0; i < 4; ++i) points[i] = (i == vertex ? p : sites_[cell.vertices[i]]).point();
  return exact::sign_of_orientation(points[0], points[1], points[2], points[3]) ==
         exact::Sign::negative;
}

}  // namespace hexatlas::delaunay
