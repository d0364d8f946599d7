#include "meshing/delaunay/inserter.hpp"

#include <algorithm>
#include <bit>

#include "enum/core/checks.hpp"
#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::delaunay {
namespace {

using exact::Sign;

/// The vertices of facet j in an order that is right-handed with a point inside before them.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kInward{
    {{0, 2, 1}, {1, 2, 3}, {2, 0, 3}, {3, 0, 1}}};

constexpr std::size_t kAtOnce = 4096;  // cells taken from the common store

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
  cells_.reserve(5);
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
    if (!is_outside && !conflicts(cells_[start], p)) return Outcome::hidden;
  } else {
    if (twin_ != kNone) return Outcome::duplicate;
  }
  if (!dig(start, p)) {
    undo();
    return Outcome::postponed;
  }
  if (!walk_.is_confined()) make_room();
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
bool Inserter<Index, kIsWeighted>::is_in_ball(const Tetrahedron& cell, const Site& p) const {
  const auto& [a, b, c, d] = cell.vertices;
  if constexpr (kIsWeighted)
    return exact::sign_of_perturbed_in_orthosphere(weighted(sites_[a]), weighted(sites_[b]),
                                                   weighted(sites_[c]), weighted(sites_[d]),
                                                   weighted(p)) == Sign::positive;
  else
    return exact::sign_of_perturbed_in_sphere(sites_[a].point(), sites_[b].point(),
                                              sites_[c].point(), sites_[d].point(),
                                              p.point()) == Sign::positive;
}

/// The same for any cell that is not marked; beyond a facet of the hull is inside.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::conflicts(const Tetrahedron& cell, const Site& p) const {
  const unsigned ghost = cell.ghost();
  if (ghost == 4) return is_in_ball(cell, p);
  std::array<exact::Point3, 4> points{};
  for (unsigned i = 0; i < 4; ++i) points[i] = (i == ghost ? p : sites_[cell.vertices[i]]).point();
  const Sign side = exact::sign_of_orientation(points[0], points[1], points[2], points[3]);
  if (side != Sign::zero) return side == Sign::positive;
  // In the plane of the hull's facet the ball of any tetrahedron below is the same disc. That
  // tetrahedron may be doomed already: then so is this one.
  const Tetrahedron& below = cells_[cell.neighbors[ghost] / 4];
  return below.is_marked() || conflicts(below, p);
}

template <class Index, bool kIsWeighted>
typename Inserter<Index, kIsWeighted>::Neighbors Inserter<Index, kIsWeighted>::neighbors_of(
    const Tetrahedron& cell) const noexcept {
  Neighbors around{};
  for (unsigned j = 0; j < 4; ++j) {
    const Index corner = cell.vertices[j];
    around.corners[j] = &sites_[j == 0 ? corner & ~Tetrahedron::kMark : corner];
    const Index facet = cell.neighbors[opposite_of(j)];
    const Tetrahedron& other = cells_[facet / 4];
    const bool is_alive = !other.is_marked();
    const Index apex = other.vertices[facet % 4];
    around.alive |= static_cast<unsigned>(is_alive) << j;
    around.apexes[j] = &sites_[is_alive ? apex : cell.vertices[1]];  // at hand, and in the region
    around.facets[j] = facet;
  }
  return around;
}

/// Whether one of the given neighbours, which the cavity is to have, does.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::leaves_region(const Neighbors& around,
                                                 unsigned inside) const noexcept {
  if (walk_.region().has_all(around.apexes)) return false;
  for (unsigned rest = inside; rest != 0; rest &= rest - 1) {
    const Site* const apex = around.apexes[static_cast<unsigned>(std::countr_zero(rest))];
    if (apex != &sites_[kGhost] && !walk_.region().has(*apex)) return true;
  }
  return false;
}

/// The neighbours, a bit for each facet, that are in conflict with the site.
template <class Index, bool kIsWeighted>
unsigned Inserter<Index, kIsWeighted>::conflicting(const Neighbors& around, const Site& p) const {
  if constexpr (kIsWeighted) {
    return conflicting_exactly(around, around.alive, p);
  } else {
    const FacetSigns signs =
        signs_.conflict(around.corners, around.apexes, p, around.alive, short_below_);
    const unsigned rest = signs.undecided & around.alive;
    const unsigned inside = signs.positive & around.alive;
    return rest == 0 ? inside : inside | conflicting_exactly(around, rest, p);
  }
}

/// Of the given ones.
template <class Index, bool kIsWeighted>
unsigned Inserter<Index, kIsWeighted>::conflicting_exactly(const Neighbors& around, unsigned facets,
                                                           const Site& p) const {
  unsigned inside = 0;
  for (unsigned rest = facets; rest != 0; rest &= rest - 1) {
    const auto j = static_cast<unsigned>(std::countr_zero(rest));
    if (conflicts(cells_[around.facets[j] / 4], p)) inside |= 1U << j;
  }
  return inside;
}

/// Finds the cavity and marks its tetrahedra; false if it leaves the region.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::dig(Index start, const Site& p) {
  constexpr Index kMark = Tetrahedron::kMark;
  const auto make_room = [](auto& list, std::size_t count) {
    if (list.size() < count) list.resize(2 * count);
  };
  make_room(doomed_, 4);
  doomed_[0] = 4 * start;
  doomed_count_ = 1;
  facet_count_ = 0;
  cells_[start].vertices[0] |= kMark;
  std::size_t fetched = 1;
  for (std::size_t k = 0; k < doomed_count_; ++k) {
    make_room(doomed_, doomed_count_ + 4);
    make_room(walls_, facet_count_ + 4);
    const Neighbors around = neighbors_of(cells_[doomed_[k] / 4]);
    const unsigned inside = conflicting(around, p);
    if (walk_.is_confined() && leaves_region(around, inside)) return false;
    const unsigned outside = around.alive & ~inside;
    // Written in any case, counted if it applies: which it is cannot be foretold.
    for (unsigned j = 0; j < 4; ++j) {
      const auto is_inside = static_cast<Index>(inside >> j & 1U);
      doomed_[doomed_count_] = around.facets[j];
      doomed_count_ += is_inside;
      cells_[around.facets[j] / 4].vertices[0] |= is_inside * kMark;
      walls_[facet_count_] = static_cast<std::uint32_t>(4 * k + j);
      facet_count_ += outside >> j & 1U;
    }
    // What a later step looks at, if there is one, as early as may be.
    for (const Index facet : cells_[doomed_[fetched] / 4].neighbors)
      __builtin_prefetch(&cells_[facet / 4]);
    fetched += static_cast<std::size_t>(fetched < doomed_count_);
  }
  return true;
}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::undo() {
  for (std::size_t i = 0; i < doomed_count_; ++i)
    cells_[doomed_[i] / 4].vertices[0] &= ~Tetrahedron::kMark;
}

/// Sees to as many free cells as the new tetrahedra need besides those of the cavity, if there are.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::has_room() {
  while (free_.size() + doomed_count_ < facet_count_) {
    const auto range = cells_.taken(kAtOnce);
    if (range.begin == range.end) return false;
    for (std::size_t c = range.end; c-- > range.begin;) free_.push_back(static_cast<Index>(c));
  }
  return true;
}

/// Sees to it that there are. If the system has no more, all is as before.
template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::make_room() {
  if (free_.size() + doomed_count_ >= facet_count_) return;
  try {
    cells_.reserve(cells_.size() + facet_count_);
  } catch (...) {
    undo();
    throw;
  }
}

template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::fill(Index site) {
  collect_facets();
  const bool is_numbered = number_vertices();
  for (std::size_t i = 0; i < doomed_count_; ++i) {
    if (i < facet_count_) {
      new_cells_[i] = doomed_[i] / 4;
      continue;
    }
    cells_[doomed_[i] / 4].vertices[0] = kNone;
    free_.push_back(doomed_[i] / 4);
  }
  for (std::size_t i = doomed_count_; i < facet_count_; ++i) {
    new_cells_[i] = free_.back();
    free_.pop_back();
  }
  for (std::size_t i = 0; i < facet_count_; ++i) {
    const auto& [v, outer] = facets_[i];
    Tetrahedron& cell = cells_[new_cells_[i]];
    cell.vertices = {site, v[0], v[1], v[2]};
    cell.neighbors[0] = outer;
    cells_[outer / 4].neighbors[outer % 4] = 4 * new_cells_[i];
  }
  walk_.start_at(new_cells_[0]);
  const std::span<const Facet> facets(facets_.data(), facet_count_);
  if (is_numbered)
    links_.link(cells_, facets, new_cells_.data());
  else
    links_.link_by_sorting(cells_, facets, new_cells_.data());
}

/// Before the cells of the cavity are used again.
template <class Index, bool kIsWeighted>
void Inserter<Index, kIsWeighted>::collect_facets() {
  if (facets_.size() < facet_count_) {
    facets_.resize(2 * facet_count_);
    new_cells_.resize(2 * facet_count_);
  }
  for (std::size_t i = 0; i < facet_count_; ++i) {
    const Tetrahedron& cell = cells_[doomed_[walls_[i] / 4] / 4];
    const unsigned facet = walls_[i] % 4;
    const auto [a, b, c] = kInward[facet];
    constexpr Index kVertex = ~Tetrahedron::kMark;
    facets_[i] = {
        {cell.vertices[a] & kVertex, cell.vertices[b] & kVertex, cell.vertices[c] & kVertex},
        cell.neighbors[opposite_of(facet)]};
  }
}

/// The vertices of the cavity: four, and one more at most for each further tetrahedron. Before the
/// cells are used again.
template <class Index, bool kIsWeighted>
bool Inserter<Index, kIsWeighted>::number_vertices() {
  constexpr Index kVertex = ~Tetrahedron::kMark;
  if (vertices_.size() < doomed_count_ + 3) vertices_.resize(2 * (doomed_count_ + 3));
  Index* last = vertices_.data();
  for (const Index v : cells_[doomed_[0] / 4].vertices) *last++ = v & kVertex;
  for (std::size_t i = 1; i < doomed_count_; ++i)
    *last++ = cells_[doomed_[i] / 4].vertices[doomed_[i] % 4] & kVertex;
  return links_.number({vertices_.data(), last});
}

template class Inserter<std::uint32_t, false>;
template class Inserter<std::uint64_t, false>;
template class Inserter<std::uint32_t, true>;
template class Inserter<std::uint64_t, true>;

}  // namespace hexatlas::delaunay
