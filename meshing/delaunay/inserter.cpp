#include "meshing/delaunay/inserter.hpp"

#include <algorithm>
#include <bit>

#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::delaunay {
namespace {

using exact::Sign;

constexpr std::size_t kAtOnce = 4096;  // cells taken from the common store

/// Whether the filter for four facets is not at the end of its range (four_facets.hpp), where that
/// of realize/exact may still decide. Counts for time only.
bool is_of_moderate_size(const Site& a, const Site& p) {
  const double x = a.x - p.x, y = a.y - p.y, z = a.z - p.z;
  const double square = x * x + y * y + z * z;
  return square > 0x1p-100 && square < 0x1p98;
}

}  // namespace

template <class Index, bool kIsWeighted>
Inserter<Index, kIsWeighted>::Inserter(Cells<Index>& cells, const Site* sites, Claim* claims,
                                       const double* weights)
    : cells_(cells),
      sites_(sites),
      weights_(weights),
      signs_(four_facets()),
      walk_(cells, sites),
      links_(claims) {}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::use(const Site* sites, Claim* claims,
                                       const double* weights) noexcept {
  sites_ = sites;
  weights_ = weights;
  walk_.use(sites);
  links_.use(claims);
}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::begin(const std::array<Index, 4>& sites) {
  cells_.reserve(6);  // cell 0 is none
  const auto first = static_cast<Index>(cells_.taken(5).begin);
  // The last cell is the tetrahedron; the others have the ghost vertex in place of one vertex, and
  // two exchanged, since the ghost vertex lies on the other side.
  const Index inner = first + 4;
  cells_[inner].vertices = sites;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = (i + 1) % 4, k = (i + 2) % 4;
    Tetrahedron& outer = cells_[first + i];
    outer.vertices = sites;
    outer.vertices[i] = kGhost;
    std::swap(outer.vertices[j], outer.vertices[k]);
    outer.neighbors[i] = 4 * inner + i;
    cells_[inner].neighbors[i] = 4 * (first + i) + i;
  }
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned k = 0; k < 4; ++k) {
      // Facet k of outer cell i, without site v, is shared with the cell that lacks v.
      if (k == i) continue;
      const Index v = cells_[first + i].vertices[k];
      const auto lacks =
          static_cast<unsigned>(std::find(sites.begin(), sites.end(), v) - sites.begin());
      const auto& other = cells_[first + lacks].vertices;
      const auto at =
          static_cast<unsigned>(std::find(other.begin(), other.end(), sites[i]) - other.begin());
      cells_[first + i].neighbors[k] = 4 * (first + lacks) + at;
    }
  walk_.start_at(inner);
}

template <class Index, bool kIsWeighted>
Outcome Inserter<Index, kIsWeighted>::insert(Index site) {
  const Site& p = sites_[site];
  const Index start = walk_.located(p);
  if (start == kNone) return Outcome::postponed;
  const bool is_outside = cells_[start].ghost() < 4;
  twin_ = vertex_at(cells_[start], p);
  if constexpr (kIsWeighted) {
    if (twin_ != kNone && weights_[twin_] == weights_[site]) return Outcome::duplicate;
    if (!is_outside && !conflicts(cells_[start], p, Filtered::no)) return Outcome::hidden;
  } else {
    if (twin_ != kNone) return Outcome::duplicate;
  }
  if (!dig(start, p)) {
    undo();
    return Outcome::postponed;
  }
  if (!walk_.is_confined()) make_cells();
  if (!has_room()) {
    undo();
    return Outcome::no_room;
  }
  fill(site);
  if (is_outside) walk_.start_at(first_on_hull());  // the next one may be outside, too
  return Outcome::inserted;
}

/// Of the tetrahedra at a site that was outside.
template <class Index, bool kIsWeighted>
Index Inserter<Index, kIsWeighted>::first_on_hull() const noexcept {
  return *std::find_if(made().begin(), made().end(),
                       [&](Index cell) { return cells_[cell].ghost() < 4; });
}

template <class Index, bool kIsWeighted>
Index Inserter<Index, kIsWeighted>::vertex_at(const Tetrahedron& cell,
                                              const Site& place) const noexcept {
  for (const Index v : cell.vertices)
    if (sites_[v].is_at(place)) return v;
  return kNone;
}

/// Of a site, not of another place.
template <class Index, bool kIsWeighted>
exact::WeightedPoint3 Inserter<Index, kIsWeighted>::weighted(const Site& site) const noexcept {
  return {site.point(), weights_[&site - sites_]};
}

/// Whether the site lies in the open ball of the tetrahedron, ties decided. Requires that the ghost
/// vertex is none of its vertices.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::is_in_ball(const Tetrahedron& cell, const Site& p,
                                              Filtered filtered) const {
  const auto& [a, b, c, d] = cell.vertices;
  if constexpr (kIsWeighted) {
    return exact::sign_of_perturbed_in_orthosphere(weighted(sites_[a]), weighted(sites_[b]),
                                                   weighted(sites_[c]), weighted(sites_[d]),
                                                   weighted(p)) == Sign::positive;
  } else {
    const bool is_hopeless = filtered == Filtered::in_vain && is_of_moderate_size(sites_[a], p);
    const auto sign = is_hopeless ? exact::unfiltered_sign_of_perturbed_in_sphere
                                  : exact::sign_of_perturbed_in_sphere;
    return sign(sites_[a].point(), sites_[b].point(), sites_[c].point(), sites_[d].point(),
                p.point()) == Sign::positive;
  }
}

/// The same for any cell that is not marked; beyond a facet of the hull is inside.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::conflicts(const Tetrahedron& cell, const Site& p,
                                             Filtered filtered) const {
  const unsigned ghost = cell.ghost();
  if (ghost == 4) return is_in_ball(cell, p, filtered);
  std::array<exact::Point3, 4> points{};
  for (unsigned i = 0; i < 4; ++i) points[i] = (i == ghost ? p : sites_[cell.vertices[i]]).point();
  const Sign side = exact::sign_of_orientation(points[0], points[1], points[2], points[3]);
  if (side != Sign::zero) return side == Sign::positive;
  // In the plane of the hull's facet the ball of any tetrahedron below is the same disc. That
  // tetrahedron may be doomed already: then so is this one.
  const Tetrahedron& below = cells_[cell.neighbors[ghost] / 4];
  return below.is_marked() || conflicts(below, p, Filtered::no);
}

template <class Index, bool kIsWeighted>
unsigned Inserter<Index, kIsWeighted>::conflicting_exactly(const Tetrahedron& cell, unsigned which,
                                                           const Site& p) const {
  unsigned inside = 0;
  for (unsigned rest = which; rest != 0; rest &= rest - 1) {
    const auto j = static_cast<unsigned>(std::countr_zero(rest));
    if (conflicts(cells_[cell.neighbors[opposite_of(j)] / 4], p, Filtered::in_vain))
      inside |= 1U << j;
  }
  return inside;
}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::make_room() {
  const std::size_t room = 2 * (cavity_.room + 4);
  doomed_.resize(room);
  // Connected cells: each but one shares a facet with one before, so that 2 n + 2 are left.
  facets_.resize(2 * room + 8);
  new_cells_.resize(facets_.size());
  cavity_.room = room;
  cavity_.doomed = doomed_.data();
  cavity_.facets = facets_.data();
}

/// Finds the cavity and marks its tetrahedra; false if it leaves the region.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::dig(Index start, const Site& p) {
  cavity_.owner = this;
  cavity_.cells = cells_.data();
  cavity_.sites = sites_;
  cavity_.site = &p;
  cavity_.is_exact = kIsWeighted;
  cavity_.is_confined = walk_.is_confined();
  if (cavity_.is_confined) cavity_.region = walk_.region();
  if (cavity_.room == 0) make_room();
  doomed_[0] = 4 * start;
  cells_[start].vertices[0] |= Tetrahedron::kMark;
  return signs_.dig(cavity_);
}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::undo() {
  for (std::size_t i = 0; i < cavity_.doomed_count; ++i)
    cells_[doomed_[i] / 4].vertices[0] &= ~Tetrahedron::kMark;
}

/// Sees to as many free cells as the new tetrahedra need besides those of the cavity, if there are.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::has_room() {
  while (free_.size() + cavity_.doomed_count < cavity_.facet_count) {
    const auto range = cells_.taken(kAtOnce);
    if (range.begin == range.end) return false;
    for (std::size_t c = range.end; c-- > range.begin;) free_.push_back(static_cast<Index>(c));
  }
  return true;
}

/// Sees to it that there are. If the system has no more, all is as before.
template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::make_cells() {
  if (free_.size() + cavity_.doomed_count >= cavity_.facet_count) return;
  try {
    cells_.reserve(cells_.size() + cavity_.facet_count);
  } catch (...) {
    undo();
    throw;
  }
}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::fill(Index site) {
  const bool is_numbered = number_vertices();
  for (std::size_t i = 0; i < cavity_.doomed_count; ++i) {
    if (i < cavity_.facet_count) {
      new_cells_[i] = doomed_[i] / 4;
      continue;
    }
    cells_[doomed_[i] / 4].vertices[0] = kNone;
    free_.push_back(doomed_[i] / 4);
  }
  for (std::size_t i = cavity_.doomed_count; i < cavity_.facet_count; ++i) {
    new_cells_[i] = free_.back();
    free_.pop_back();
  }
  for (std::size_t i = 0; i < cavity_.facet_count; ++i) {
    const auto& [v, outer] = facets_[i];
    Tetrahedron& cell = cells_[new_cells_[i]];
    cell.vertices = {site, v[0], v[1], v[2]};
    cell.neighbors[0] = outer;
    cells_[outer / 4].neighbors[outer % 4] = 4 * new_cells_[i];
  }
  walk_.start_at(new_cells_[0]);
  const std::span<const Facet> all(facets_.data(), cavity_.facet_count);
  if (is_numbered)
    links_.link(cells_, all, new_cells_.data());
  else
    links_.link_by_sorting(cells_, all, new_cells_.data());
}

/// The vertices of the cavity: four, and one more at most for each further tetrahedron. Before the
/// cells are used again.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::number_vertices() {
  constexpr Index kVertex = ~Tetrahedron::kMark;
  if (vertices_.size() < cavity_.doomed_count + 3) vertices_.resize(2 * (cavity_.doomed_count + 3));
  Index* last = vertices_.data();
  for (const Index v : cells_[doomed_[0] / 4].vertices) *last++ = v & kVertex;
  for (std::size_t i = 1; i < cavity_.doomed_count; ++i)
    *last++ = cells_[doomed_[i] / 4].vertices[doomed_[i] % 4] & kVertex;
  return links_.number({vertices_.data(), last});
}

template class Inserter<std::uint32_t, false>;
template class Inserter<std::uint64_t, false>;
template class Inserter<std::uint32_t, true>;
template class Inserter<std::uint64_t, true>;

}  // namespace hexatlas::delaunay
