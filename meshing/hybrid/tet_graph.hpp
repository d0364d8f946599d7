#pragma once
/// \file
/// A tetrahedral mesh with what surrounds each tetrahedron and each vertex.
///
/// Shapes. Facet i of a tetrahedron is the one opposite to its vertex i. `kOutside` stands for the
/// tetrahedron beyond a facet of the boundary. Vertices of no tetrahedron have no neighbours.
/// Cost: linear in the tetrahedra but for sorting around each vertex; some 90 bytes each.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "enum/complex/broken_law.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

using mesh::Index;
using TetIndex = std::uint32_t;
using Tetrahedron = std::array<Index, 4>;
using Triangle = std::array<Index, 3>;

/// What a file says beside the tetrahedra; empty where it says nothing.
struct Colours {
  std::span<const std::uint32_t> regions;  ///< one per tetrahedron, or none at all
  std::span<const Triangle> triangles;     ///< of surfaces; those of no tetrahedron are ignored
  std::span<const std::uint32_t> colours;  ///< one per triangle
};

class TetGraph {
 public:
  static constexpr TetIndex kOutside = 0xFFFF'FFFF;

  /// The graph, or the first law broken: at least one tetrahedron and fewer than 2^30; none has
  /// volume zero, all have the same orientation (if that is negative, all are turned over); no two
  /// have the same vertices or lie on the same side of a common facet. Signs are exact.
  /// Requires: indices below points.size(), four distinct ones each, finite coordinates, and
  /// colours as described.
  [[nodiscard]] static std::variant<TetGraph, complex::BrokenLaw> of(mesh::TetView mesh,
                                                                     const Colours& colours = {});

  [[nodiscard]] std::span<const mesh::Point> points() const noexcept { return points_; }
  [[nodiscard]] std::size_t size() const noexcept { return tetrahedra_.size(); }
  /// Whether all tetrahedra were given inside out.
  [[nodiscard]] bool is_turned_over() const noexcept { return is_turned_over_; }
  /// Right-handed.
  [[nodiscard]] const Tetrahedron& operator[](TetIndex t) const noexcept { return tetrahedra_[t]; }
  [[nodiscard]] TetIndex across(TetIndex t, unsigned facet) const noexcept {
    return across_[std::size_t{t} * 4 + facet];
  }
  [[nodiscard]] std::uint32_t region(TetIndex t) const noexcept {
    return regions_.empty() ? 0 : regions_[t];
  }
  /// Of the surface that the facet is on: 0 if it is on none, otherwise 1 + the given colour.
  [[nodiscard]] std::uint64_t colour(TetIndex t, unsigned facet) const noexcept {
    return colours_.empty() ? 0 : colours_[std::size_t{t} * 4 + facet];
  }

  /// Coloured triangles that are no facet of a tetrahedron.
  [[nodiscard]] std::size_t ignored_triangles() const noexcept { return ignored_triangles_; }

  /// The tetrahedra at a vertex, ascending.
  [[nodiscard]] std::span<const TetIndex> star(Index v) const noexcept {
    return row(star_, star_start_, v);
  }
  /// The vertices joined to it by edges, ascending.
  [[nodiscard]] std::span<const Index> neighbours(Index v) const noexcept {
    return row(neighbours_, neighbours_start_, v);
  }
  /// Where the neighbours of v begin in the list of all directed edges.
  [[nodiscard]] std::size_t first_edge(Index v) const noexcept { return neighbours_start_[v]; }
  [[nodiscard]] std::size_t directed_edges() const noexcept { return neighbours_.size(); }
  /// The position of w among neighbours(v). Requires that it is one.
  [[nodiscard]] std::uint32_t position(Index v, Index w) const noexcept;
  /// The same; nothing if it is none.
  [[nodiscard]] std::optional<std::uint32_t> find(Index v, Index w) const noexcept;

 private:
  template <class T>
  static std::span<const T> row(const std::vector<T>& all, const std::vector<std::size_t>& start,
                                Index v) noexcept {
    return std::span(all).subspan(start[v], start[v + 1] - start[v]);
  }

  std::optional<complex::BrokenLaw> orient();
  std::optional<complex::BrokenLaw> glue(const Colours& colours);
  void gather_stars();
  void gather_neighbours();

  std::span<const mesh::Point> points_;
  bool is_turned_over_ = false;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<TetIndex> across_;
  std::span<const std::uint32_t> regions_;
  std::vector<std::uint64_t> colours_;
  std::size_t ignored_triangles_ = 0;
  std::vector<std::size_t> star_start_;
  std::vector<TetIndex> star_;
  std::vector<std::size_t> neighbours_start_;
  std::vector<Index> neighbours_;
};

/// Facet i of (a, b, c, d), counter-clockwise seen from vertex i: with that vertex as fourth a
/// right-handed tetrahedron.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetFrom{
    {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

}  // namespace hexatlas::hybrid
