#include "meshing/hybrid/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/core/words.hpp"
#include "meshing/delaunay/triangulation.hpp"
#include "meshing/hybrid/lattice_points.hpp"
#include "meshing/hybrid/lattice_recovery.hpp"
#include "meshing/hybrid/lattice_surface.hpp"
#include "meshing/hybrid/lattice_tets.hpp"
#include "meshing/hybrid/lattice_vectors.hpp"

namespace hexatlas::hybrid {
namespace {

using complex::BrokenLaw;
using mesh::Index;

constexpr std::size_t kCorners = 8;

/// The corners of a box three times as wide as the least box of the points in each direction, and
/// at least as wide as that is anywhere.
std::array<mesh::Point, kCorners> corners_around(const std::vector<mesh::Point>& points) {
  mesh::Point low = points[0];
  mesh::Point high = points[0];
  for (const mesh::Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vector size = difference(high, low);
  const double margin = std::max({size.x, size.y, size.z});
  std::array<mesh::Point, kCorners> result{};
  for (std::size_t i = 0; i < kCorners; ++i)
    result[i] = {(i & 1U) != 0 ? high.x + margin : low.x - margin,
                 (i & 2U) != 0 ? high.y + margin : low.y - margin,
                 (i & 4U) != 0 ? high.z + margin : low.z - margin};
  return result;
}

/// Points of the surface, then of the lattice, then the corners around.
std::vector<mesh::Point> all_points(const std::vector<mesh::Point>& surface,
                                    const std::vector<mesh::Point>& lattice) {
  std::vector<mesh::Point> result = surface;
  result.insert(result.end(), lattice.begin(), lattice.end());
  const auto corners = corners_around(surface);
  result.insert(result.end(), corners.begin(), corners.end());
  return result;
}

/// One per facet, 4 t + the vertex opposite: whether it is a triangle of the surface.
std::vector<bool> surface_facets(const FlippedTets& tets, const ClosedSurface& surface) {
  std::vector<bool> result(4 * tets.size());
  for (const auto& triangle : surface.triangles()) {
    const auto t = tets.with(triangle);
    core::ensures(t.has_value(), "a recovered triangle is a facet");
    std::size_t facet = 0;
    while (std::find(triangle.begin(), triangle.end(), tets[*t][facet]) != triangle.end()) ++facet;
    const TetIndex beyond = tets.across(*t, facet);
    std::size_t other = 0;
    while (std::find(triangle.begin(), triangle.end(), tets[beyond][other]) != triangle.end())
      ++other;
    result[4 * std::size_t{*t} + facet] = true;
    result[4 * std::size_t{beyond} + other] = true;
  }
  return result;
}

enum class Side : std::uint8_t { unknown, outside, inside };

/// Of each tetrahedron, by the parity of the triangles between it and a corner around.
std::vector<Side> sides(const FlippedTets& tets, const std::vector<bool>& is_surface) {
  std::vector<Side> result(tets.size(), Side::unknown);
  const auto corner = static_cast<Index>(tets.points().size() - 1);
  std::vector<TetIndex> open{tets.star(corner).front()};
  result[open.front()] = Side::outside;
  while (!open.empty()) {
    const TetIndex t = open.back();
    open.pop_back();
    for (std::size_t facet = 0; facet < 4; ++facet) {
      const TetIndex beyond = tets.across(t, facet);
      if (beyond == FlippedTets::kOutside) continue;
      const bool is_inside = (result[t] == Side::inside) != is_surface[4 * std::size_t{t} + facet];
      const Side side = is_inside ? Side::inside : Side::outside;
      if (result[beyond] == Side::unknown) {
        result[beyond] = side;
        open.push_back(beyond);
      }
      core::ensures(result[beyond] == side, "a closed surface has two sides");
    }
  }
  return result;
}

class Filling {
 public:
  Filling(ClosedSurface surface, const LatticeOptions& options)
      : surface_(std::move(surface)), options_(options), given_(surface_.points().size()) {}

  std::variant<Filled, BrokenLaw> run() {
    result_.spacing = options_.spacing > 0 ? options_.spacing
                                           : usual_side(surface_.points(), surface_.triangles());
    auto lattice = lattice_points(surface_.points(), surface_.triangles(), result_.spacing,
                                  options_.clearance);
    if (const auto* fault = std::get_if<BrokenLaw>(&lattice)) return *fault;
    lattice_ = std::get<std::vector<mesh::Point>>(std::move(lattice));
    for (int round = 0; round <= options_.rounds; ++round) {
      if (!options_.keeps_diagonals)
        result_.exchanged_diagonals += surface_.make_flat_parts_delaunay();
      const std::vector<mesh::Point> points = all_points(surface_.points(), lattice_);
      FlippedTets tets = triangulated(points);
      if (!options_.keeps_diagonals) result_.exchanged_diagonals += adopt_diagonals(surface_, tets);
      missing_ = recover(tets, surface_);
      if (missing_.crossing) return *missing_.crossing;
      if (missing_.edges.empty() && missing_.triangles.empty()) {
        collect(tets);
        return std::move(result_);
      }
      if (round < options_.rounds) refine();
    }
    return not_recovered();
  }

 private:
  [[nodiscard]] FlippedTets triangulated(const std::vector<mesh::Point>& points) const {
    const delaunay::Triangulation delaunay(points, {.threads = options_.threads});
    return FlippedTets(points, delaunay.tetrahedra());
  }

  /// Points in the middle of missing edges and of the longest sides of missing triangles.
  void refine() {
    for (const auto& [a, b] : missing_.edges) surface_.split(a, b);
    for (const auto& triangle : missing_.triangles) {
      std::array<Index, 2> longest{};
      double length = -1;
      bool is_whole = true;  // none of its sides was split before
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = triangle[k];
        const Index b = triangle[(k + 1) % 3];
        is_whole = is_whole && surface_.has_edge(a, b);
        const double d = distance(surface_.points()[a], surface_.points()[b]);
        if (d > length) {
          length = d;
          longest = {a, b};
        }
      }
      if (is_whole) surface_.split(longest[0], longest[1]);
    }
  }

  [[nodiscard]] BrokenLaw not_recovered() const {
    const Index v = missing_.edges.empty() ? missing_.triangles[0][0] : missing_.edges[0][0];
    const mesh::Point& p = surface_.points()[v];
    return {"the surface could not be recovered in " + std::to_string(options_.rounds) +
            " rounds of adding points to it: " +
            std::to_string(missing_.edges.size() + missing_.triangles.size()) +
            " edges or triangles are missing, one of them near " + core::place(p.x, p.y, p.z) +
            "; it crosses itself there, has a sharp angle, or parts nearer to each other than "
            "its triangles are wide, which should be finer"};
  }

  void collect(const FlippedTets& tets) {
    const std::vector<bool> is_surface = surface_facets(tets, surface_);
    const std::vector<Side> side = sides(tets, is_surface);
    mesh::TetModel& model = result_.model;
    const std::size_t on_surface = surface_.points().size();
    constexpr Index kUnused = 0xFFFF'FFFF;
    std::vector<Index> renamed(tets.points().size(), kUnused);
    for (TetIndex t = 0; t < tets.size(); ++t)
      if (tets.is_there(t) && side[t] == Side::inside)
        for (const Index v : tets[t]) renamed[v] = 0;
    for (std::size_t v = 0; v < renamed.size(); ++v) {
      if (renamed[v] == kUnused) continue;
      renamed[v] = static_cast<Index>(model.mesh.points.size());
      model.mesh.points.push_back(tets.points()[v]);
    }
    result_.added_on_surface = on_surface - given_;
    result_.lattice_points = model.mesh.points.size() - on_surface;
    for (TetIndex t = 0; t < tets.size(); ++t) {
      if (!tets.is_there(t) || side[t] != Side::inside) continue;
      auto vertices = tets[t];
      for (Index& v : vertices) v = renamed[v];
      model.mesh.tetrahedra.push_back(vertices);
    }
    model.regions.assign(model.mesh.tetrahedra.size(), 0);
    model.colours = surface_.colours();
    for (const auto& triangle : surface_.triangles())
      model.triangles.push_back(outward(tets, side, triangle));
  }

  /// Counter-clockwise from outside; vertices of the surface have the same numbers everywhere.
  static std::array<Index, 3> outward(const FlippedTets& tets, const std::vector<Side>& side,
                                      std::array<Index, 3> triangle) {
    const TetIndex t = *tets.with(triangle);
    Index apex = 0;
    for (const Index v : tets[t])
      if (std::find(triangle.begin(), triangle.end(), v) == triangle.end()) apex = v;
    const bool sees_counter_clockwise =
        tets.orientation(triangle[0], triangle[1], triangle[2], apex) == exact::Sign::positive;
    if (sees_counter_clockwise == (side[t] == Side::inside)) std::swap(triangle[1], triangle[2]);
    return triangle;
  }

  ClosedSurface surface_;
  LatticeOptions options_;
  std::size_t given_;
  std::vector<mesh::Point> lattice_;
  Missing missing_;
  Filled result_;
};

void expect_sound(const LatticeOptions& options) {
  core::expects(std::isfinite(options.spacing) && options.spacing >= 0, "a spacing, or 0");
  core::expects(std::isfinite(options.clearance) && options.clearance > 0, "clearance > 0");
  core::expects(options.flatness >= 0, "flatness >= 0");
  core::expects(options.rounds >= 1 && options.threads >= 1, "rounds >= 1, threads >= 1");
}

/// Products of four coordinates are made, in double precision.
constexpr double kGreatest = 0x1p240;
constexpr double kLeast = 0x1p-240;

bool has_usual_size(const std::vector<mesh::Point>& points) {
  double greatest = 0;
  double widest = 0;
  for (const mesh::Point& p : points) {
    greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const Vector d = difference(p, points[0]);
    widest = std::max({widest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return greatest <= kGreatest && widest >= kLeast;
}

}  // namespace

std::variant<Filled, BrokenLaw> fill_with_lattice(const mesh::FacetMesh& surface,
                                                  const LatticeOptions& options) {
  expect_sound(options);
  auto closed = ClosedSurface::of(surface, options.flatness);
  if (const auto* fault = std::get_if<BrokenLaw>(&closed)) return *fault;
  if (!has_usual_size(std::get<ClosedSurface>(closed).points()))
    return BrokenLaw{"coordinates above 2^240 or a surface smaller than 2^-240: to be scaled"};
  return Filling(std::get<ClosedSurface>(std::move(closed)), options).run();
}

}  // namespace hexatlas::hybrid
