// Private to meshing/delaunay: the innermost loop, beside four_facets_body.hpp and as that one
// compiled for each processor.

#include <array>
#include <cstddef>
#include <cstdint>

#include "meshing/delaunay/digging.hpp"
#include "meshing/delaunay/four_facets_body.hpp"

namespace hexatlas::delaunay {
namespace {
// NOLINTBEGIN(misc-definitions-in-headers): each includer is meant to have its own

/// Of a tetrahedron of the cavity, by its facets. The vertex of a neighbour that is marked is one
/// of the cavity.
template <class Index>
struct Neighbors {
  FourSites corners{}, apexes{};
  std::array<Index, 4> firsts{};  ///< vertices, with marks
  unsigned alive = 0;             ///< the neighbours that are not marked, a bit for each
};

template <class Index>
inline Neighbors<Index> neighbors_of(const Cell<Index>& cell, const Digging<Index>& cavity) {
  constexpr Index kVertex = ~Cell<Index>::kMark;
  constexpr int kBits = 8 * sizeof(Index);
  Neighbors<Index> around;
  Index marks = 0;
  for (unsigned j = 4; j-- > 0;) {
    around.corners[j] = &cavity.sites[cell.vertices[j] & kVertex];
    const Index facet = cell.neighbors[(j + 3) & 3U];
    const Cell<Index>& other = cavity.cells[facet / 4];
    around.firsts[j] = other.vertices[0];
    around.apexes[j] = &cavity.sites[other.vertices[facet % 4] & kVertex];
    marks = 2 * marks + (other.vertices[0] >> (kBits - 1));
  }
  around.alive = 15U ^ static_cast<unsigned>(marks);
  return around;
}

/// The neighbours in conflict, where the filter leaves it open.
template <class Index>
[[gnu::noinline]] unsigned conflicting_closely(const Digging<Index>& cavity,
                                               const Cell<Index>& cell) {
  Neighbors<Index> around = neighbors_of(cell, cavity);
  if (cavity.is_exact) return cavity.owner->conflicting_exactly(cell, around.alive, *cavity.site);
  for (unsigned j = 0; j < 4; ++j)
    if ((around.alive >> j & 1U) == 0) around.apexes[j] = around.corners[1];  // no farther
  const FacetSigns signs =
      conflict_closely(around.corners, around.apexes, *cavity.site, cavity.short_below);
  const unsigned inside = signs.positive & around.alive, rest = signs.undecided & around.alive;
  return rest == 0 ? inside : inside | cavity.owner->conflicting_exactly(cell, rest, *cavity.site);
}

/// Whether one of the given neighbours, which the cavity is to have, does.
template <class Index>
[[gnu::noinline]] bool leaves_region(const Digging<Index>& cavity, const FourSites& apexes,
                                     unsigned inside) {
  for (unsigned j = 0; j < 4; ++j)
    if ((inside >> j & 1U) != 0 && apexes[j] != &cavity.sites[kGhost] &&
        !cavity.region.has(*apexes[j]))
      return true;
  return false;
}

/// Those of the cavity so far.
template <class Index>
struct Lists {
  Index* doomed;
  CavityFacet<Index>* facets;
  std::size_t doomed_count, facet_count;
};

/// The given neighbours of a tetrahedron of the cavity, and its given facets. Four are written in
/// any case, those that count first: which they are cannot be foretold.
template <class Index>
inline void append(Lists<Index>& lists, const Cell<Index>& cell, unsigned inside,
                   unsigned outside) {
  const auto& [a, b, c, d] = cell.vertices;
  const Index v = a & ~Cell<Index>::kMark;
  const auto& [of_a, of_b, of_c, of_d] = cell.neighbors;
  const std::array<CavityFacet<Index>, 4> facets{
      {{{v, c, b}, of_d}, {{b, c, d}, of_a}, {{c, v, d}, of_b}, {{d, v, b}, of_c}}};
  for (unsigned j = 0; j < 4; ++j) {
    lists.doomed[lists.doomed_count] = facets[j].outer;
    lists.doomed_count += inside >> j & 1U;
    lists.facets[lists.facet_count] = facets[j];
    lists.facet_count += outside >> j & 1U;
  }
}

#ifdef __AVX512VL__
/// The same by two instructions that bring together what counts.
inline void append(Lists<std::uint32_t>& lists, const Cell<std::uint32_t>& cell, unsigned inside,
                   unsigned outside) {
  using Four [[gnu::vector_size(16)]] = int;
  using Eight [[gnu::vector_size(32)]] = int;
  using Sixteen [[gnu::vector_size(64)]] = int;
  using Pairs [[gnu::vector_size(64)]] = long long;
  // Two bits for each.
  static constexpr std::array<std::uint8_t, 16> kTwice{0x00, 0x03, 0x0c, 0x0f, 0x30, 0x33,
                                                       0x3c, 0x3f, 0xc0, 0xc3, 0xcc, 0xcf,
                                                       0xf0, 0xf3, 0xfc, 0xff};
  constexpr Eight kUnmarked{0x7fffffff, -1, -1, -1, -1, -1, -1, -1};
  Eight all;
  static_assert(sizeof all == sizeof cell);
  __builtin_memcpy(&all, &cell, sizeof all);
  all &= kUnmarked;
  const Four neighbors = __builtin_shufflevector(all, all, 7, 4, 5, 6);
  const Four doomed =
      __builtin_ia32_compresssi128_mask(neighbors, Four{}, static_cast<std::uint8_t>(inside));
  __builtin_memcpy(lists.doomed + lists.doomed_count, &doomed, sizeof doomed);
  lists.doomed_count += static_cast<unsigned>(__builtin_popcount(inside));
  const Sixteen four_facets =
      __builtin_shufflevector(all, all, 0, 2, 1, 7, 1, 2, 3, 4, 2, 0, 3, 5, 3, 0, 1, 6);
  const Pairs facets = __builtin_ia32_compressdi512_mask(reinterpret_cast<Pairs>(four_facets),
                                                         Pairs{}, kTwice[outside]);
  __builtin_memcpy(lists.facets + lists.facet_count, &facets, sizeof facets);
  lists.facet_count += static_cast<unsigned>(__builtin_popcount(outside));
}
#endif

/// Those of the neighbours that are inside.
template <class Index>
inline void mark(Cell<Index>* cells, const Cell<Index>& cell, const Neighbors<Index>& around,
                 unsigned inside) {
  constexpr unsigned kLast = 8 * sizeof(Index) - 1;
  for (unsigned j = 0; j < 4; ++j)
    cells[cell.neighbors[(j + 3) & 3U] / 4].vertices[0] =
        around.firsts[j] | (static_cast<Index>(inside) << (kLast - j) & Cell<Index>::kMark);
}

/// The neighbours of a cell to come.
template <class Index>
inline void fetch(const Cell<Index>* cells, const Lists<Index>& lists, std::size_t& next) {
  for (const Index facet : cells[lists.doomed[next] / 4].neighbors)
    __builtin_prefetch(&cells[facet / 4]);
  next += static_cast<std::size_t>(next < lists.doomed_count);
}

template <Filter kFilter, class Index>
bool dig_by(Digging<Index>& cavity) {
  constexpr std::size_t kFirstSteps = 8, kBacklog = 3;
  const Site p = *cavity.site;
  const bool is_exact = cavity.is_exact, is_confined = cavity.is_confined;
  Lists<Index> lists{cavity.doomed, cavity.facets, 1, 0};
  bool is_within = true;
  std::size_t fetched = 1, open_steps = 0;
  for (std::size_t k = 0; k < lists.doomed_count; ++k) {
    if (lists.doomed_count + 4 >= cavity.room) {
      cavity.owner->make_room();
      lists.doomed = cavity.doomed;
      lists.facets = cavity.facets;
    }
    const Cell<Index>& cell = cavity.cells[lists.doomed[k] / 4];
    const Neighbors<Index> around = neighbors_of(cell, cavity);
    const FacetSigns signs =
        is_exact ? FacetSigns{0, 15}
                 : filtered<kFilter>(relative(around.corners, p), relative(around.apexes, p));
    unsigned inside = signs.positive & around.alive;
    if ((signs.undecided & around.alive) != 0) [[unlikely]] {
      inside = conflicting_closely(cavity, cell);
      ++open_steps;
    }
    if (is_confined && !cavity.region.has_all(around.apexes) &&
        leaves_region(cavity, around.apexes, inside)) {
      is_within = false;
      break;
    }
    append(lists, cell, inside, around.alive & ~inside);
    mark(cavity.cells, cell, around, inside);
    // What a later step looks at, as early as may be; if there is none, cell 0. One for each step
    // would be enough but for those steps in which the list grows.
    lists.doomed[lists.doomed_count] = 0;
    fetch(cavity.cells, lists, fetched);
    if (k < kFirstSteps || lists.doomed_count > fetched + kBacklog)
      fetch(cavity.cells, lists, fetched);
  }
  cavity.doomed_count = lists.doomed_count;
  cavity.facet_count = lists.facet_count;
  cavity.choice.note(kFilter == Filter::thorough, open_steps);
  return is_within;
}

template <class Index>
bool dig(Digging<Index>& cavity) {
  return cavity.choice.takes_thorough() ? dig_by<Filter::thorough>(cavity)
                                        : dig_by<Filter::plain>(cavity);
}

// NOLINTEND(misc-definitions-in-headers)
}  // namespace
}  // namespace hexatlas::delaunay
