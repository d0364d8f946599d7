#include "meshing/delaunay/inserter.hpp"

#include <algorithm>
#include <bit>

#include "enum/core/checks.hpp"
#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::delaunay {
namespace {

using exact::Sign;

/// The vertex opposite to facet j of four_facets.hpp.
constexpr unsigned opposite_of(unsigned facet) { return (facet + 3) & 3U; }
constexpr unsigned facet_opposite(unsigned vertex) { return (vertex + 1) & 3U; }

/// The vertices of facet j in an order that is right-handed with a point inside before them.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kInward{
    {{0, 2, 1}, {1, 2, 3}, {2, 0, 3}, {3, 0, 1}}};

constexpr std::size_t kAtOnce = 4096;   // cells taken from the common store
constexpr unsigned kMostOnHull = 1000;  // steps; more are a sign of a bad centre

}  // namespace

template <class Index>
Inserter<Index>::Inserter(Cells<Index>& cells, const Site* sites, Claim* claims)
    : cells_(cells), sites_(sites), signs_(four_facets()), locals_(claims), edges_(kEdges) {}

template <class Index>
void Inserter<Index>::use(const Site* sites, Claim* claims) noexcept {
  sites_ = sites;
  locals_.use(claims);
}

template <class Index>
void Inserter<Index>::begin(const std::array<Index, 4>& sites) {
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
  last_ = inner;
}

template <class Index>
Outcome Inserter<Index>::insert(Index site) {
  const Site& p = sites_[site];
  const Index start = located(p);
  if (start == kNone) return Outcome::postponed;
  const bool is_outside = cells_[start].ghost() < 4;
  twin_ = vertex_at(cells_[start], p);
  if (twin_ != kNone) return Outcome::duplicate;
  if (!dig(start, p)) {
    undo();
    return Outcome::postponed;
  }
  if (!is_confined_) make_room();
  if (!has_room()) {
    undo();
    return Outcome::no_room;
  }
  fill(site);
  if (is_outside) last_ = first_on_hull();  // the next one may be outside, too
  return Outcome::inserted;
}

/// Of the tetrahedra at a site that was outside.
template <class Index>
Index Inserter<Index>::first_on_hull() const noexcept {
  return *std::find_if(made().begin(), made().end(),
                       [&](Index cell) { return cells_[cell].ghost() < 4; });
}

template <class Index>
Index Inserter<Index>::located(const Site& place) {
  Index at = last_;
  if (const unsigned ghost = cells_[at].ghost(); ghost < 4) {
    if (const Index seen = visible_from(place); seen != kNone) return seen;
    at = cells_[at].neighbors[ghost] / 4;
  }
  unsigned entered = 4;  // the vertex opposite to the facet through which the walk came
  while (true) {
    const Tetrahedron& cell = cells_[at];
    unsigned ways = facets_towards(cell, entered, place);
    if (ways == 0) return last_ = at;
    if (is_confined_) ways &= facets_within(cell);
    if (ways == 0) return kNone;
    const Index to = cell.neighbors[opposite_of(static_cast<unsigned>(std::countr_zero(ways)))];
    at = to / 4;
    entered = static_cast<unsigned>(to % 4);
    if (cells_[at].vertices[entered] == kGhost) return at;
  }
}

/// From a facet of the hull over others: to one that the place lies strictly beyond, or kNone if it
/// meets none. As in space the walk goes through facets, those of the tetrahedra that join the
/// hull to the centre. These are left-handed, so every sign is turned round. Tetrahedra inside the
/// hull may be long and thin, and many of them on the way.
template <class Index>
Index Inserter<Index>::visible_from(const Site& p) const {
  Index at = last_;
  unsigned entered = 4;
  for (unsigned steps = 0; steps < kMostOnHull; ++steps) {
    const Tetrahedron& cell = cells_[at];
    const unsigned ghost = cell.ghost();
    FourSites corners{};
    for (unsigned i = 0; i < 4; ++i) corners[i] = i == ghost ? &centre_ : &sites_[cell.vertices[i]];
    const FacetSigns signs = signs_.beyond(corners, p);
    unsigned ways = 15U & ~(signs.positive | signs.undecided);
    if ((ways >> facet_opposite(ghost) & 1U) != 0) return at;
    if (entered < 4) ways &= ~(1U << facet_opposite(entered));
    if (is_confined_) ways &= facets_within(cell);
    if (ways == 0) return kNone;
    const Index to = cell.neighbors[opposite_of(static_cast<unsigned>(std::countr_zero(ways)))];
    at = to / 4;
    entered = static_cast<unsigned>(to % 4);
  }
  return kNone;
}

/// The facets, other than that entered through, that the place lies strictly beyond: at least one
/// if there are any.
template <class Index>
unsigned Inserter<Index>::facets_towards(const Tetrahedron& cell, unsigned entered,
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

/// The facets behind which the tetrahedron lies within the region. Requires that the cell does.
template <class Index>
unsigned Inserter<Index>::facets_within(const Tetrahedron& cell) const noexcept {
  unsigned within = 0;
  for (unsigned j = 0; j < 4; ++j) {
    const Index facet = cell.neighbors[opposite_of(j)];
    const Index apex = cells_[facet / 4].vertices[facet % 4];
    within |= static_cast<unsigned>(apex == kGhost || region_.has(sites_[apex])) << j;
  }
  return within;
}

template <class Index>
Index Inserter<Index>::vertex_at(const Tetrahedron& cell, const Site& place) const noexcept {
  for (const Index v : cell.vertices)
    if (sites_[v].is_at(place)) return v;
  return kNone;
}

template <class Index>
bool Inserter<Index>::is_beyond(const Tetrahedron& cell, unsigned vertex, const Site& p) const {
  std::array<exact::Point3, 4> points{};
  for (unsigned i = 0; i < 4; ++i) points[i] = (i == vertex ? p : sites_[cell.vertices[i]]).point();
  return exact::sign_of_orientation(points[0], points[1], points[2], points[3]) == Sign::negative;
}

/// Whether the place lies in the open ball of the tetrahedron, ties decided.
template <class Index>
bool Inserter<Index>::conflicts(const Tetrahedron& cell, const Site& p) const {
  std::array<exact::Point3, 4> points{};
  const unsigned ghost = cell.ghost();
  for (unsigned i = 0; i < 4; ++i) points[i] = (i == ghost ? p : sites_[cell.vertices[i]]).point();
  if (ghost == 4)
    return exact::sign_of_perturbed_in_sphere(points[0], points[1], points[2], points[3],
                                              p.point()) == Sign::positive;
  const Sign side = exact::sign_of_orientation(points[0], points[1], points[2], points[3]);
  if (side != Sign::zero) return side == Sign::positive;
  // In the plane of the hull's facet the ball of any tetrahedron below is the same disc. That
  // tetrahedron may be doomed already: then so is this one.
  const Tetrahedron& below = cells_[cell.neighbors[ghost] / 4];
  return below.is_marked() || conflicts(below, p);
}

template <class Index>
typename Inserter<Index>::Neighbors Inserter<Index>::neighbors_of(
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
    around.apexes[j] = &sites_[is_alive ? apex : Index{kGhost}];
    around.facets[j] = facet;
  }
  return around;
}

template <class Index>
bool Inserter<Index>::leaves_region(const Neighbors& around) const noexcept {
  const Site* const ghost = &sites_[kGhost];
  return std::any_of(around.apexes.begin(), around.apexes.end(),
                     [&](const Site* apex) { return apex != ghost && !region_.has(*apex); });
}

/// The neighbours, a bit for each facet, that are in conflict with the site.
template <class Index>
unsigned Inserter<Index>::conflicting(const Neighbors& around, const Site& p) const {
  const FacetSigns signs =
      signs_.conflict(around.corners, around.apexes, p, around.alive, short_below_);
  const unsigned rest = signs.undecided & around.alive;
  const unsigned inside = signs.positive & around.alive;
  return rest == 0 ? inside : inside | conflicting_exactly(around, rest, p);
}

/// Of the given ones.
template <class Index>
unsigned Inserter<Index>::conflicting_exactly(const Neighbors& around, unsigned facets,
                                              const Site& p) const {
  unsigned inside = 0;
  for (unsigned rest = facets; rest != 0; rest &= rest - 1) {
    const auto j = static_cast<unsigned>(std::countr_zero(rest));
    if (conflicts(cells_[around.facets[j] / 4], p)) inside |= 1U << j;
  }
  return inside;
}

/// Finds the cavity and marks its tetrahedra; false if it leaves the region.
template <class Index>
bool Inserter<Index>::dig(Index start, const Site& p) {
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
    if (is_confined_ && leaves_region(around)) return false;
    const unsigned inside = conflicting(around, p);
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

template <class Index>
void Inserter<Index>::undo() {
  for (std::size_t i = 0; i < doomed_count_; ++i)
    cells_[doomed_[i] / 4].vertices[0] &= ~Tetrahedron::kMark;
}

/// Sees to as many free cells as the new tetrahedra need besides those of the cavity, if there are.
template <class Index>
bool Inserter<Index>::has_room() {
  while (free_.size() + doomed_count_ < facet_count_) {
    const auto range = cells_.taken(kAtOnce);
    if (range.begin == range.end) return false;
    for (std::size_t c = range.end; c-- > range.begin;) free_.push_back(static_cast<Index>(c));
  }
  return true;
}

/// Sees to it that there are. If the system has no more, all is as before.
template <class Index>
void Inserter<Index>::make_room() {
  if (free_.size() + doomed_count_ >= facet_count_) return;
  try {
    cells_.reserve(cells_.size() + facet_count_);
  } catch (...) {
    undo();
    throw;
  }
}

template <class Index>
void Inserter<Index>::fill(Index site) {
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
  last_ = new_cells_[0];
  if (is_numbered)
    link();
  else
    link_by_sorting();
}

/// Before the cells of the cavity are used again.
template <class Index>
void Inserter<Index>::collect_facets() {
  if (facets_.size() < facet_count_) {
    facets_.resize(2 * facet_count_);
    new_cells_.resize(2 * facet_count_);
    numbers_.resize(2 * facet_count_);
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
template <class Index>
bool Inserter<Index>::number_vertices() {
  constexpr Index kVertex = ~Tetrahedron::kMark;
  locals_.clear();
  for (const Index v : cells_[doomed_[0] / 4].vertices)
    if (!locals_.add(v & kVertex)) return false;
  for (std::size_t i = 1; i < doomed_count_; ++i) {
    const Index apex = cells_[doomed_[i] / 4].vertices[doomed_[i] % 4];
    if (!locals_.add(apex & kVertex)) return false;
  }
  return true;
}

/// Tetrahedra with the new site at vertex 0 are neighbours across the edges of their facets.
template <class Index>
void Inserter<Index>::link() {
  constexpr unsigned kMost = LocalVertices<Index>::kMost;
  Index* const edges = edges_.data();
  for (std::size_t i = 0; i < facet_count_; ++i) {
    const auto& v = facets_[i].vertices;
    const unsigned a = locals_.number_of(v[0]), b = locals_.number_of(v[1]),
                   c = locals_.number_of(v[2]);
    const Index at = 4 * new_cells_[i];
    numbers_[i] = {a, b, c};
    edges[kMost * b + c] = at + 1;
    edges[kMost * c + a] = at + 2;
    edges[kMost * a + b] = at + 3;
  }
  for (std::size_t i = 0; i < facet_count_; ++i) {
    const auto [a, b, c] = numbers_[i];
    auto& neighbors = cells_[new_cells_[i]].neighbors;
    neighbors[1] = edges[kMost * c + b];
    neighbors[2] = edges[kMost * a + c];
    neighbors[3] = edges[kMost * b + a];
  }
}

/// For a cavity with many vertices: the two references at each edge, brought together.
template <class Index>
void Inserter<Index>::link_by_sorting() {
  far_edges_.clear();
  for (std::size_t i = 0; i < facet_count_; ++i)
    for (unsigned k = 0; k < 3; ++k) {
      const auto& v = facets_[i].vertices;
      const auto [low, high] = std::minmax(v[(k + 1) % 3], v[(k + 2) % 3]);
      far_edges_.push_back({low, high, static_cast<Index>(4 * new_cells_[i] + k + 1)});
    }
  std::sort(far_edges_.begin(), far_edges_.end());
  for (std::size_t i = 0; i < far_edges_.size(); i += 2) {
    const Index a = far_edges_[i][2], b = far_edges_[i + 1][2];
    cells_[a / 4].neighbors[a % 4] = b;
    cells_[b / 4].neighbors[b % 4] = a;
  }
}

template class Inserter<std::uint32_t>;
template class Inserter<std::uint64_t>;

}  // namespace hexatlas::delaunay
