#pragma once
/// \file
/// Private to meshing/delaunay: from points to cells, by one thread or several.
///
/// Several threads: each round of points is cut into as many parts of the curve as there are
/// threads, and each thread inserts what it can without touching a vertex of another part. The rest
/// is tried again with other parts, and in the end by one thread: docs/theory/parallel-delaunay.md.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/common_unit.hpp"
#include "meshing/delaunay/curves.hpp"
#include "meshing/delaunay/inserter.hpp"
#include "meshing/delaunay/page_allocator.hpp"
#include "meshing/delaunay/page_buffer.hpp"
#include "meshing/delaunay/site.hpp"
#include "meshing/delaunay/triangulation.hpp"
#include "meshing/delaunay/worker.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::delaunay {

template <class Index, bool kIsWeighted>
class Builder {
 public:
  /// Requires finite coordinates and weights, threads >= 1; a weight for each point, or none if
  /// there are no weights.
  Builder(std::span<const mesh::Point> points, std::span<const double> weights, std::uint64_t seed,
          int threads);

  /// Of the affine hull: -1 if there is no point. There are cells only if it is 3.
  [[nodiscard]] int dimension() const noexcept { return dimension_; }
  [[nodiscard]] static constexpr bool is_weighted() noexcept { return kIsWeighted; }
  [[nodiscard]] const Cells<Index>& cells() const noexcept { return cells_; }
  /// The number of a site in the input; those added later follow.
  [[nodiscard]] mesh::Index point_of(Index site) const noexcept { return points_[site]; }
  [[nodiscard]] std::size_t points() const noexcept { return points_.size() - kFirstSite; }
  /// Points that are neither vertices nor duplicates. Requires dimension 3.
  [[nodiscard]] std::vector<mesh::Index> hidden() const;
  [[nodiscard]] std::size_t duplicates() const;
  [[nodiscard]] std::size_t bytes() const noexcept;

  struct Added {
    Outcome outcome = Outcome::inserted;
    Index vertex = kNone;  ///< its site, or that of which it is a duplicate, or kNone if hidden
  };
  /// A further point, as the last one. Requires dimension 3; finite coordinates and weight, 0 if
  /// there are no weights. Invalidates references to sites and cells.
  Added add(const mesh::Point& point, double weight);
  /// As Triangulation::refine.
  std::size_t refine(const Wish& wish, std::size_t most);
  [[nodiscard]] Inserter<Index, kIsWeighted>& inserter() noexcept { return inserters_.front(); }

  /// visit(cell, i) for each cell at the place of the point, which is its vertex i.
  template <class Visit>
  void for_each_around(mesh::Index point, Visit&& visit);

 private:
  [[nodiscard]] Site mean_of_some() const noexcept;
  [[nodiscard]] bool find_first_four(std::array<Index, 4>& first);
  void insert_rounds(std::span<const std::size_t> rounds, const std::array<Index, 4>& first);
  void insert_here(std::span<const Index> sites);
  void insert_in_parts(std::vector<Index> pending, std::size_t end);
  void use_curve(unsigned curve, std::size_t end);
  void sort_by_keys(std::vector<Index>& pending) const;
  [[nodiscard]] std::vector<Index> inserted(std::vector<Stretch<Index>> stretches,
                                            std::size_t worth_giving);
  void note_duplicate(Index site, Index twin);
  [[nodiscard]] std::vector<bool> vertices() const;
  [[nodiscard]] Index site_of(mesh::Index point);

  Cells<Index> cells_;
  PageBuffer<Site> sites_;
  std::vector<mesh::Index, PageAllocator<mesh::Index>> points_;
  std::vector<double> weights_;  ///< of sites, if they have any
  using Claim = typename StarLinks<Index>::Claim;
  std::vector<Claim, PageAllocator<Claim>> claims_;
  std::vector<Inserter<Index, kIsWeighted>> inserters_;
  std::vector<Index> sites_of_points_;          ///< filled when first asked for
  std::vector<std::pair<Index, Index>> twins_;  ///< if weighted: of duplicates, with a vertex once
  Curves curves_;
  unsigned curve_ = 0;  ///< that the keys of sites before the end of the present round are of
  CommonUnit unit_;
  std::size_t duplicates_ = 0;  ///< if not weighted, or flat
  int dimension_ = -1;
};

template <class Index, bool kIsWeighted>
template <class Visit>
void Builder<Index, kIsWeighted>::for_each_around(mesh::Index point, Visit&& visit) {
  const Site& place = sites_[site_of(point)];
  std::vector<Index> found{inserter().walk().located(place)};
  const Index vertex = inserter().vertex_at(cells_[found[0]], place);
  if (vertex == kNone) return;  // hidden
  std::unordered_set<Index> seen{found[0]};
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Cell<Index> cell = cells_[found[k]];
    const auto at = static_cast<unsigned>(
        std::find(cell.vertices.begin(), cell.vertices.end(), vertex) - cell.vertices.begin());
    visit(cell, at);
    for (unsigned i = 0; i < 4; ++i)
      if (i != at && seen.insert(cell.neighbors[i] / 4).second)
        found.push_back(cell.neighbors[i] / 4);
  }
}

}  // namespace hexatlas::delaunay
