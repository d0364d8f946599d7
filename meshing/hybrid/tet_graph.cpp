#include "meshing/hybrid/tet_graph.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "enum/core/checks.hpp"
#include "meshing/quality/edge.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::hybrid {
namespace {

using complex::BrokenLaw;

constexpr std::size_t kMostTetrahedra = std::size_t{1} << 30U;

using quality::exact_point;

Triangle sorted(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

std::string name_of(const Triangle& t) {
  return std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]);
}

/// A facet of a tetrahedron, or a coloured triangle, among those with the same least vertex.
struct Side {
  Index middle = 0, greatest = 0;
  std::uint32_t owner = 0;  ///< 4 t + facet; of a coloured triangle its number
  bool is_colour = false;
  bool is_even = false;  ///< the parity of its vertices as listed
};

bool comes_before(const Side& a, const Side& b) {
  if (a.middle != b.middle) return a.middle < b.middle;
  if (a.greatest != b.greatest) return a.greatest < b.greatest;
  if (a.is_colour != b.is_colour) return a.is_colour < b.is_colour;
  return a.owner < b.owner;
}

bool is_even(const Triangle& t) { return ((t[0] > t[1]) != (t[1] > t[2])) == (t[0] > t[2]); }

Triangle facet_of(const Tetrahedron& tetrahedron, unsigned facet) {
  const auto& corner = kFacetFrom[facet];
  return {tetrahedron[corner[0]], tetrahedron[corner[1]], tetrahedron[corner[2]]};
}

/// Start of each row and the end of the last, from the sizes of the rows.
std::vector<std::size_t> starts(const std::vector<std::uint32_t>& sizes) {
  std::vector<std::size_t> result(sizes.size() + 1);
  for (std::size_t i = 0; i < sizes.size(); ++i) result[i + 1] = result[i] + sizes[i];
  return result;
}

/// The sides in rows, one for each least vertex, each sorted.
struct Sides {
  std::vector<std::size_t> start;
  std::vector<Side> sides;
};

Sides sides_of(const std::vector<Tetrahedron>& tetrahedra, std::span<const Triangle> coloured,
               std::size_t points) {
  const auto for_each = [&](auto&& visit) {
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
      for (unsigned i = 0; i < 4; ++i)
        visit(facet_of(tetrahedra[t], i), static_cast<std::uint32_t>(4 * t + i), false);
    for (std::size_t c = 0; c < coloured.size(); ++c)
      visit(coloured[c], static_cast<std::uint32_t>(c), true);
  };
  std::vector<std::uint32_t> sizes(points);
  for_each([&sizes](const Triangle& t, std::uint32_t, bool) {
    ++sizes[*std::min_element(t.begin(), t.end())];
  });
  Sides result{starts(sizes), {}};
  result.sides.resize(result.start.back());
  std::vector<std::size_t> next(result.start.begin(), result.start.end() - 1);
  for_each([&](const Triangle& t, std::uint32_t owner, bool is_colour) {
    const Triangle s = sorted(t);
    result.sides[next[s[0]]++] = {s[1], s[2], owner, is_colour, is_even(t)};
  });
  for (std::size_t v = 0; v < points; ++v)
    std::sort(result.sides.begin() + static_cast<std::ptrdiff_t>(result.start[v]),
              result.sides.begin() + static_cast<std::ptrdiff_t>(result.start[v + 1]),
              comes_before);
  return result;
}

BrokenLaw at(std::size_t tetrahedron, const std::string& reason) { return {reason, tetrahedron}; }

/// The law that these sides of one triangle, none of them a colour, break.
std::optional<BrokenLaw> fault_of(std::span<const Side> sides, Index least,
                                  const std::vector<Tetrahedron>& tetrahedra) {
  if (sides.size() < 2) return std::nullopt;
  const Triangle triangle{least, sides[0].middle, sides[0].greatest};
  const auto apex = [&](const Side& side) { return tetrahedra[side.owner / 4][side.owner % 4]; };
  const std::size_t second = sides[1].owner / 4;
  const std::string both =
      "tetrahedra " + std::to_string(sides[0].owner / 4) + " and " + std::to_string(second);
  if (apex(sides[0]) == apex(sides[1])) return at(second, both + " have the same vertices");
  if (sides.size() > 2)
    return at(sides[2].owner / 4,
              "the triangle " + name_of(triangle) + " lies in more than two tetrahedra");
  if (sides[0].is_even == sides[1].is_even)
    return at(second,
              both + " overlap: they are on the same side of the triangle " + name_of(triangle));
  return std::nullopt;
}

}  // namespace

std::variant<TetGraph, BrokenLaw> TetGraph::of(mesh::TetView mesh, const Colours& colours) {
  core::expects(colours.regions.empty() || colours.regions.size() == mesh.tetrahedra.size(),
                "a region for each tetrahedron");
  core::expects(colours.triangles.size() == colours.colours.size(), "a colour for each triangle");
  if (mesh.tetrahedra.empty()) return BrokenLaw{"there are no tetrahedra"};
  if (mesh.tetrahedra.size() >= kMostTetrahedra)
    return BrokenLaw{"there are 2^30 tetrahedra or more"};
  TetGraph graph;
  graph.points_ = mesh.points;
  graph.regions_ = colours.regions;
  graph.tetrahedra_.assign(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  if (auto fault = graph.orient()) return *fault;
  if (auto fault = graph.glue(colours)) return *fault;
  graph.gather_stars();
  graph.gather_neighbours();
  return graph;
}

std::optional<BrokenLaw> TetGraph::orient() {
  std::size_t negative = 0;
  std::size_t first_negative = 0;
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    const auto& [a, b, c, d] = tetrahedra_[t];
    const exact::Sign sign =
        exact::sign_of_orientation(exact_point(points_[a]), exact_point(points_[b]),
                                   exact_point(points_[c]), exact_point(points_[d]));
    if (sign == exact::Sign::zero)
      return at(t, "tetrahedron " + std::to_string(t) + " has volume zero");
    if (sign == exact::Sign::negative && negative++ == 0) first_negative = t;
  }
  if (negative == 0) return std::nullopt;
  if (negative < tetrahedra_.size())
    return at(first_negative, "tetrahedron " + std::to_string(first_negative) +
                                  " is inverted: not all have the same orientation");
  for (Tetrahedron& t : tetrahedra_) std::swap(t[2], t[3]);
  is_turned_over_ = true;
  return std::nullopt;
}

std::optional<BrokenLaw> TetGraph::glue(const Colours& colours) {
  const Sides all = sides_of(tetrahedra_, colours.triangles, points_.size());
  across_.assign(4 * tetrahedra_.size(), kOutside);
  if (!colours.triangles.empty()) colours_.assign(4 * tetrahedra_.size(), 0);
  for (std::size_t v = 0; v + 1 < all.start.size(); ++v) {
    const auto row = std::span(all.sides).subspan(all.start[v], all.start[v + 1] - all.start[v]);
    for (std::size_t first = 0; first < row.size();) {
      const auto is_same = [&](const Side& s) {
        return s.middle == row[first].middle && s.greatest == row[first].greatest;
      };
      std::size_t facets = first;
      while (facets < row.size() && is_same(row[facets]) && !row[facets].is_colour) ++facets;
      std::size_t end = facets;
      while (end < row.size() && is_same(row[end])) ++end;
      const auto sides = row.subspan(first, facets - first);
      if (auto fault = fault_of(sides, static_cast<Index>(v), tetrahedra_)) return fault;
      if (sides.size() == 2) {
        across_[sides[0].owner] = sides[1].owner / 4;
        across_[sides[1].owner] = sides[0].owner / 4;
      }
      if (sides.empty()) ignored_triangles_ += end - facets;
      if (facets < end)
        for (const Side& side : sides)
          colours_[side.owner] = std::uint64_t{1} + colours.colours[row[facets].owner];
      first = end;
    }
  }
  return std::nullopt;
}

void TetGraph::gather_stars() {
  std::vector<std::uint32_t> sizes(points_.size());
  for (const Tetrahedron& t : tetrahedra_)
    for (const Index v : t) ++sizes[v];
  star_start_ = starts(sizes);
  star_.resize(star_start_.back());
  std::vector<std::size_t> next(star_start_.begin(), star_start_.end() - 1);
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
    for (const Index v : tetrahedra_[t]) star_[next[v]++] = static_cast<TetIndex>(t);
}

void TetGraph::gather_neighbours() {
  neighbours_start_.assign(1, 0);
  neighbours_start_.reserve(points_.size() + 1);
  std::vector<Index> around;
  for (std::size_t v = 0; v < points_.size(); ++v) {
    around.clear();
    for (const TetIndex t : star(static_cast<Index>(v)))
      for (const Index w : tetrahedra_[t])
        if (w != v) around.push_back(w);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    neighbours_.insert(neighbours_.end(), around.begin(), around.end());
    neighbours_start_.push_back(neighbours_.size());
  }
}

std::uint32_t TetGraph::position(Index v, Index w) const noexcept {
  const auto row = neighbours(v);
  return static_cast<std::uint32_t>(std::lower_bound(row.begin(), row.end(), w) - row.begin());
}

std::optional<std::uint32_t> TetGraph::find(Index v, Index w) const noexcept {
  const std::uint32_t at = position(v, w);
  const auto row = neighbours(v);
  if (at == row.size() || row[at] != w) return std::nullopt;
  return at;
}

}  // namespace hexatlas::hybrid
