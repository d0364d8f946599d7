#pragma once
/// \file
/// Private to the filling by lattices: a closed surface of triangles whose edges can be split and
/// whose flat diagonals can be exchanged.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <variant>
#include <vector>

#include "enum/complex/broken_law.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

class ClosedSurface {
 public:
  using Index = mesh::Index;
  using Triangle = std::array<Index, 3>;
  using Edge = std::array<Index, 2>;

  /// The surface on the points that its triangles use, in their order; or the first law broken.
  /// Requires finite coordinates and indices below points.size(); flatness as in LatticeOptions.
  [[nodiscard]] static std::variant<ClosedSurface, complex::BrokenLaw> of(
      const mesh::FacetMesh& surface, double flatness);

  [[nodiscard]] const std::vector<mesh::Point>& points() const noexcept { return points_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
  [[nodiscard]] const std::vector<std::uint32_t>& colours() const noexcept { return colours_; }
  [[nodiscard]] bool has_edge(Index a, Index b) const { return at_.contains(key(a, b)); }
  [[nodiscard]] bool has_triangle(Index a, Index b, Index c) const;
  /// Each once, in the order of the triangles.
  [[nodiscard]] std::vector<Edge> edges() const;
  /// The vertices opposite to an edge.
  [[nodiscard]] Edge opposite(Index a, Index b) const;

  /// Whether the two triangles at an edge are a flat, strictly convex quad, whose other diagonal is
  /// no edge. They have one colour.
  [[nodiscard]] bool can_exchange(Index a, Index b) const;
  /// Puts in the other diagonal. Requires can_exchange.
  void exchange(Index a, Index b);
  /// Exchanges diagonals of flat pairs until all such pairs are Delaunay. The answer is how many.
  std::size_t make_flat_parts_delaunay();
  /// Halves an edge and both its triangles.
  void split(Index a, Index b);

 private:
  using Pair = std::array<std::uint32_t, 2>;
  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

  static std::uint64_t key(Index a, Index b) noexcept {
    return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
  }
  explicit ClosedSurface(double flatness) : flatness_(flatness) {}
  [[nodiscard]] Index third(std::uint32_t triangle, Index a, Index b) const;
  [[nodiscard]] bool is_delaunay(Index a, Index b) const;
  void attach(std::uint32_t triangle);
  void colour();

  std::vector<mesh::Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> colours_;
  std::unordered_map<std::uint64_t, Pair> at_;
  double flatness_;
};

}  // namespace hexatlas::hybrid
