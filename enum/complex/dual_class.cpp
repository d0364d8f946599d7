#include "enum/complex/dual_class.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/complex/brown.hpp"
#include "enum/complex/spin_sphere.hpp"
#include "enum/complex/union_find.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::complex {
namespace {

constexpr std::uint32_t kNowhere = 0xFFFFFFFF;

/// The dual surface of a sphere: squares 3 * cell + axis, two sides in each quad of the sphere.
/// Vertices are the edges of the sphere.
class DualSurface {
 public:
  explicit DualSurface(const SpinSphere& sphere);

  /// Basis of the homology modulo 2 and the form on it.
  [[nodiscard]] QuadraticForm form() const;

 private:
  /// A side of a square: the facet of the hexahedron that it is in, and what is beyond.
  struct Exit {
    std::uint32_t square = 0;  ///< from this one
    std::uint32_t facet = 0;   ///< by this facet of its hexahedron
  };
  /// A side between two squares, or twice of one.
  struct Side {
    std::array<Exit, 2> exit{};
    std::array<std::uint32_t, 2> end{};  ///< its vertices
  };
  /// A closed path: leaves squares by exits, one after the other.
  using Cycle = std::vector<Exit>;

  [[nodiscard]] std::uint32_t beyond(const Exit& exit) const;
  [[nodiscard]] std::uint32_t side_at(std::uint32_t square, std::uint32_t facet) const {
    return side_at_[square][facet];
  }
  void number_vertices();
  void number_sides();
  void grow_forest();
  [[nodiscard]] std::vector<std::uint32_t> left_over() const;
  [[nodiscard]] Cycle cycle_through(std::uint32_t side) const;
  [[nodiscard]] int twists(const Cycle& cycle) const;
  [[nodiscard]] std::vector<bool> pushed(const Cycle& cycle) const;
  [[nodiscard]] Exit entered_by(const Exit& exit) const;
  [[nodiscard]] Exit entry(const Cycle& cycle, std::size_t i) const;

  const SpinSphere& sphere_;
  std::vector<std::array<std::uint32_t, 12>> vertex_;  ///< of each hexahedron's edges
  std::vector<std::array<std::uint32_t, 6>> side_at_;
  std::vector<Side> sides_;
  std::size_t vertices_ = 0;
  std::vector<Exit> to_parent_;  ///< of each square in the forest; square kNowhere at a root
  std::vector<std::uint32_t> depth_;
  std::vector<bool> in_forest_;  ///< of the sides
};

/// Number of the edge of a cube where two facets meet, 0 .. 11.
constexpr std::uint32_t edge_of(std::uint32_t f, std::uint32_t g) noexcept {
  const std::uint32_t axis = 3 - f / 2 - g / 2;
  const auto [low, high] = std::minmax(f, g);
  return 4 * axis + 2 * (low % 2) + high % 2;
}

DualSurface::DualSurface(const SpinSphere& sphere) : sphere_(sphere) {
  number_vertices();
  number_sides();
  grow_forest();
}

void DualSurface::number_vertices() {
  UnionFind edges(12 * sphere_.cells());
  for (std::uint32_t c = 0; c < sphere_.cells(); ++c)
    for (std::uint32_t f = 0; f < 6; ++f)
      for (std::uint32_t g = 0; g < 6; ++g) {
        if (f / 2 == g / 2) continue;
        const SpinSphere::Across& next = sphere_.across(c, f);
        edges.unite(12 * c + edge_of(f, g), 12 * next.cell + edge_of(next.facet, next.carried(g)));
      }
  std::vector<std::uint32_t> number(12 * sphere_.cells(), kNowhere);
  vertex_.resize(sphere_.cells());
  for (std::uint32_t c = 0; c < sphere_.cells(); ++c)
    for (std::uint32_t e = 0; e < 12; ++e) {
      std::uint32_t& own = number[edges.find(12 * c + e)];
      if (own == kNowhere) own = static_cast<std::uint32_t>(vertices_++);
      vertex_[c][e] = own;
    }
}

/// The exit seen from beyond.
DualSurface::Exit DualSurface::entered_by(const Exit& exit) const {
  const std::uint32_t cell = exit.square / 3, axis = exit.square % 3;
  const SpinSphere::Across& next = sphere_.across(cell, exit.facet);
  return {3 * next.cell + next.carried(2 * axis) / 2, next.facet};
}

/// How a cycle enters the square of its exit i, as an exit of that square.
DualSurface::Exit DualSurface::entry(const Cycle& cycle, std::size_t i) const {
  return entered_by(cycle[(i + cycle.size() - 1) % cycle.size()]);
}

std::uint32_t DualSurface::beyond(const Exit& exit) const { return entered_by(exit).square; }

void DualSurface::number_sides() {
  side_at_.resize(3 * sphere_.cells());
  for (auto& own : side_at_) own.fill(kNowhere);
  for (std::uint32_t square = 0; square < side_at_.size(); ++square)
    for (std::uint32_t f = 0; f < 6; ++f) {
      const std::uint32_t axis = square % 3;
      if (f / 2 == axis || side_at_[square][f] != kNowhere) continue;
      const Exit here{square, f}, there = entered_by(here);
      side_at_[square][f] = side_at_[there.square][there.facet] =
          static_cast<std::uint32_t>(sides_.size());
      const std::uint32_t across = 3 - axis - f / 2;  // the side runs along this axis
      const auto& vertex = vertex_[square / 3];
      sides_.push_back(
          {{here, there}, {vertex[edge_of(f, 2 * across)], vertex[edge_of(f, 2 * across + 1)]}});
    }
}

void DualSurface::grow_forest() {
  to_parent_.assign(side_at_.size(), {kNowhere, 0});
  depth_.assign(side_at_.size(), kNowhere);
  in_forest_.assign(sides_.size(), false);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t root = 0; root < side_at_.size(); ++root) {
    if (depth_[root] != kNowhere) continue;
    depth_[root] = 0;
    reached.assign(1, root);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (std::uint32_t f = 0; f < 6; ++f) {
        const std::uint32_t square = reached[i];
        if (f / 2 == square % 3) continue;
        const Exit there = entered_by({square, f});
        if (depth_[there.square] != kNowhere) continue;
        depth_[there.square] = depth_[square] + 1;
        to_parent_[there.square] = there;
        in_forest_[side_at(square, f)] = true;
        reached.push_back(there.square);
      }
  }
}

/// Sides neither in the forest of squares nor in one of vertices along the other sides: the cycles
/// through them are a basis.
std::vector<std::uint32_t> DualSurface::left_over() const {
  UnionFind joined(vertices_);
  std::vector<std::uint32_t> result;
  for (std::uint32_t s = 0; s < sides_.size(); ++s)
    if (!in_forest_[s] && !joined.unite(sides_[s].end[0], sides_[s].end[1])) result.push_back(s);
  return result;
}

/// Through a side once, then back in the forest.
DualSurface::Cycle DualSurface::cycle_through(std::uint32_t side) const {
  const Exit out = sides_[side].exit[0], in = sides_[side].exit[1];
  Cycle up{out}, down;  // from beyond the side to the common ancestor, and from there on, backwards
  std::uint32_t a = in.square, b = out.square;
  while (a != b) {
    if (depth_[a] >= depth_[b]) {
      up.push_back(to_parent_[a]);
      a = beyond(to_parent_[a]);
    } else {
      down.push_back(entered_by(to_parent_[b]));
      b = beyond(to_parent_[b]);
    }
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

/// The form at a cycle that meets no square twice. A frame travels along it: forwards, to the left
/// within the surface, perpendicular to the surface.
int DualSurface::twists(const Cycle& cycle) const {
  constexpr AxisVector kForwards{1, 0, 0};
  AxisVector up{};
  up[cycle.front().square % 3] = 1;
  // In by a facet is towards the opposite one.
  const AxisVector inwards =
      normal_of(cells::opposite(static_cast<cells::CubeFacet>(entry(cycle, 0).facet)));
  const Quaternion start = rotation(inwards, cross(up, inwards));
  Quaternion frame = start;
  for (const Exit& exit : cycle) {
    const AxisVector forwards = rotated(frame, kForwards), wanted = normal_of(exit.facet);
    if (forwards != wanted) frame = quarter_turn(cross(forwards, wanted)) * frame;
    frame = sphere_.across(exit.square / 3, exit.facet).passage * frame;
  }
  const Quaternion turn = start.inverse() * frame;
  if (turn == Quaternion{-1, 0, 0, 0}) return 0;
  if (turn == Quaternion{1, 0, 0, 0}) return 2;
  if (turn == Quaternion{0, 1, 0, 0}) return 1;
  core::ensures(turn == Quaternion{0, -1, 0, 0}, "a frame comes back, perhaps upside down");
  return 3;
}

/// The sides of a homologous path along sides: in each square along its border.
std::vector<bool> DualSurface::pushed(const Cycle& cycle) const {
  std::vector<bool> result(sides_.size());
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Exit& exit = cycle[i];
    const Exit in = entry(cycle, i);
    std::uint32_t at = sides_[side_at(in.square, in.facet)].end[0];
    const std::uint32_t to = sides_[side_at(exit.square, exit.facet)].end[0];
    // The four sides in cyclic order; from one vertex to the other the way round.
    const std::uint32_t axis = exit.square % 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::array<std::uint32_t, 4> facets{2 * u, 2 * v, 2 * u + 1, 2 * v + 1};
    const auto corner = [&](std::size_t k) {  // between facets k and k + 1
      return vertex_[exit.square / 3][edge_of(facets[k % 4], facets[(k + 1) % 4])];
    };
    // `at` is an end of the side that the path came by: at one of its two corners.
    const auto place = static_cast<std::size_t>(std::find(facets.begin(), facets.end(), in.facet) -
                                                facets.begin());
    std::size_t k = corner(place) == at ? place : place + 3;
    const auto last = static_cast<std::size_t>(std::find(facets.begin(), facets.end(), exit.facet) -
                                               facets.begin());
    const std::size_t goal = (corner(last) == to ? last : last + 3) % 4;
    for (; k % 4 != goal; ++k) {
      const std::uint32_t side = side_at(exit.square, facets[(k + 1) % 4]);
      result[side] = !result[side];
    }
  }
  return result;
}

QuadraticForm DualSurface::form() const {
  std::vector<Cycle> basis;
  for (const std::uint32_t side : left_over()) basis.push_back(cycle_through(side));
  QuadraticForm result;
  for (const Cycle& cycle : basis) {
    result.q.push_back(twists(cycle));
    const std::vector<bool> along = pushed(cycle);
    std::vector<bool> row;
    for (const Cycle& other : basis) {
      bool product = false;
      for (const Exit& exit : other) product = product != along[side_at(exit.square, exit.facet)];
      row.push_back(product);
    }
    result.product.push_back(std::move(row));
  }
  return result;
}

}  // namespace

int dual_class(const HexComplex& ball, const HexComplex& other, VertexId shared) {
  const SpinSphere sphere(ball, other, shared);
  return brown_invariant(DualSurface(sphere).form());
}

std::vector<HexComplex> spread_over_dual_classes(std::vector<HexComplex> meshes, VertexId shared) {
  std::stable_sort(meshes.begin(), meshes.end(), [](const HexComplex& a, const HexComplex& b) {
    return a.hexahedra.size() < b.hexahedra.size();
  });
  std::array<std::size_t, 8> met{};                        // how many of each class
  std::vector<std::pair<std::size_t, std::size_t>> order;  // rank within the class, place
  for (std::size_t i = 0; i < meshes.size(); ++i)
    order.emplace_back(met[static_cast<std::size_t>(dual_class(meshes[i], meshes[0], shared))]++,
                       i);
  std::sort(order.begin(), order.end());
  std::vector<HexComplex> result;
  result.reserve(order.size());
  for (const auto& [rank, place] : order) result.push_back(std::move(meshes[place]));
  return result;
}

}  // namespace hexatlas::complex
