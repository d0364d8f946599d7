#pragma once
/// \file
/// Private to meshing/delaunay: tetrahedra and their neighbours.
///
/// Cell 0 is none. Vertices are numbers of sites: site 0 is none; site 1 is the ghost vertex at
/// infinity, so that the tetrahedra are those of a 3-sphere. A tetrahedron with the ghost vertex is
/// a facet of the convex hull: it is right-handed if the ghost vertex is replaced by a point beyond
/// that facet.
///
/// A reference 4 c + i names the facet of tetrahedron c opposite to its vertex i. neighbors[i]
/// refers to the same facet in the tetrahedron on the other side.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>

#include "enum/core/errors.hpp"
#include "meshing/delaunay/page_buffer.hpp"

namespace hexatlas::delaunay {

inline constexpr unsigned kNone = 0;
inline constexpr unsigned kGhost = 1;
inline constexpr unsigned kFirstSite = 2;

template <class Index>
struct Cell {
  /// On the first vertex of a tetrahedron that is to go, while its cavity is dug.
  static constexpr Index kMark = Index{1} << (std::numeric_limits<Index>::digits - 1);

  std::array<Index, 4> vertices;   ///< the first is kNone if the cell is not in use
  std::array<Index, 4> neighbors;  ///< references

  [[nodiscard]] bool is_used() const noexcept { return vertices[0] != kNone; }
  [[nodiscard]] bool is_marked() const noexcept { return (vertices[0] & kMark) != 0; }
  /// The position of the ghost vertex, or 4.
  [[nodiscard]] unsigned ghost() const noexcept {
    unsigned i = 0;
    while (i < 4 && vertices[i] != kGhost) ++i;
    return i;
  }
  [[nodiscard]] bool is_tetrahedron() const noexcept { return is_used() && ghost() == 4; }
};

/// Cells in use, cells that are free, and room for more.
template <class Index>
class Cells {
 public:
  [[nodiscard]] Cell<Index>& operator[](Index c) noexcept { return cells_[c]; }
  [[nodiscard]] const Cell<Index>& operator[](Index c) const noexcept { return cells_[c]; }
  [[nodiscard]] Cell<Index>* data() noexcept { return cells_.data(); }

  /// Every cell that was ever handed out is below. Requires reserve().
  [[nodiscard]] std::size_t size() const noexcept {
    return std::min(size_.load(std::memory_order_relaxed), cells_.capacity());
  }
  /// Requires that no other thread is at work, as the cells may move.
  void reserve(std::size_t count) {
    if (count <= cells_.capacity()) return;
    if (cells_.capacity() > 0) size_ = size();
    if (count > kMost) throw core::ResourceFailure("more tetrahedra than can be numbered");
    cells_.resize(std::clamp(cells_.capacity() / 4 * 5, count, kMost));
  }
  [[nodiscard]] std::size_t bytes() const noexcept { return size() * sizeof(Cell<Index>); }

  struct Range {
    std::size_t begin = 0, end = 0;
  };
  /// New cells, `count` of them or fewer if there is no room; for any number of threads.
  [[nodiscard]] Range taken(std::size_t count) noexcept {
    const std::size_t begin = size_.fetch_add(count, std::memory_order_relaxed);
    const std::size_t most = cells_.capacity();
    return {std::min(begin, most), std::min(begin + count, most)};
  }

 private:
  static constexpr std::size_t kMost = std::numeric_limits<Index>::max() / 4;

  PageBuffer<Cell<Index>> cells_;
  std::atomic<std::size_t> size_{1};
};

}  // namespace hexatlas::delaunay
