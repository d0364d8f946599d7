#pragma once
/// \file
/// Private to meshing/delaunay: how the cavity of a site is found.

#include <array>
#include <cstddef>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/region.hpp"
#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// Of the cavity's boundary: with a vertex inside before them, the vertices are right-handed.
template <class Index>
struct CavityFacet {
  std::array<Index, 3> vertices;
  Index outer;  ///< the same facet in the tetrahedron that stays
};

/// Which of two filters serves a cavity. The thorough one takes a little longer in each step, and
/// leaves fewer steps open among flat tetrahedra and along the hull. Signs do not depend on it.
class FilterChoice {
 public:
  /// That which has served better lately; now and then the other one, to see how it does.
  [[nodiscard]] bool takes_thorough() noexcept {
    const bool pays = open_[0] > open_[1] + open_[1] / 2 + kMemory;
    return pays != (++turn_ % kMemory == 0);
  }
  /// The steps that the filter left open in a cavity.
  void note(bool was_thorough, std::size_t steps) noexcept {
    std::size_t& open = open_[was_thorough ? 1 : 0];
    open += steps - open / kMemory;
  }

 private:
  static constexpr std::size_t kMemory = 32;  // cavities

  std::array<std::size_t, 2> open_{};  ///< mean number for a cavity, times kMemory
  std::size_t turn_ = 0;
};

/// From a tetrahedron in conflict with the site over facets to all others. This is the innermost
/// loop of all, so each processor has its own: FourFacets::dig().
template <class Index>
struct Digging {
  /// Is asked now and then.
  class Owner {
   public:
    Owner() = default;
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;
    Owner(Owner&&) noexcept = default;
    Owner& operator=(Owner&&) noexcept = default;
    virtual ~Owner() = default;

    /// The given neighbours of the cell, a bit for each facet of four_facets.hpp, that are in
    /// conflict with the site.
    [[nodiscard]] virtual unsigned conflicting_exactly(const Cell<Index>& cell, unsigned which,
                                                       const Site& p) const = 0;
    /// For four more cells, and as many facets as they can have.
    virtual void make_room() = 0;
  };

  Owner* owner = nullptr;
  Cell<Index>* cells = nullptr;
  const Site* sites = nullptr;
  const Site* site = nullptr;  ///< whose cavity it is
  double short_below = -1;     ///< as for FourFacets::conflict()
  bool is_exact = false;       ///< the filter is of no use
  bool is_confined = false;    ///< to the region
  Region region;
  FilterChoice choice;

  /// The cells of the cavity: references to the facets through which they were found, of the first
  /// one any.
  Index* doomed = nullptr;
  CavityFacet<Index>* facets = nullptr;
  std::size_t doomed_count = 0, facet_count = 0;
  std::size_t room = 0;  ///< for cells; they have at most two facets each, and two more
};

}  // namespace hexatlas::delaunay
