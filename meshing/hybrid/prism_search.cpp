#include "meshing/hybrid/prism_search.hpp"

#include <algorithm>
#include <utility>

#include "meshing/quality/cells.hpp"

namespace hexatlas::hybrid {
namespace {

/// Of a determinant of directions.
constexpr double kRounding = 1e-12;

/// Appends the cell if its quality is above the threshold and it is valid.
template <std::size_t N, class Verdict>
void append_if_good(const TetGraph& graph, const std::array<Index, N>& cell, const Filling& filling,
                    double least, const Verdict& verdict, CandidateList<N>& found) {
  std::array<mesh::Point, N> corners{};
  std::transform(cell.begin(), cell.end(), corners.begin(),
                 [&graph](Index v) { return graph.points()[v]; });
  const double quality = quality::scaled_jacobian(corners);
  if (!quality::exceeds(corners, quality, least) ||
      verdict(corners).validity != quality::Validity::valid)
    return;
  found.cells.push_back({cell, quality, found.tetrahedra.size(), filling.inner, filling.flat});
  const auto all = filling.all();
  found.tetrahedra.insert(found.tetrahedra.end(), all.begin(), all.end());
}

}  // namespace

void PrismSearch::visit(const Around& around, CandidateList<6>& found) {
  for (const Around::Beyond& triangle : around.triangles())
    if (triangle.p > around.vertex() && triangle.q > around.vertex())
      over_triangle(around, triangle, found);
}

/// Every d on the positive side of the triangle with quads to both its other vertices.
void PrismSearch::over_triangle(const Around& around, const Around::Beyond& triangle,
                                CandidateList<6>& found) {
  const Index a = around.vertex();
  const std::uint32_t b = graph_.position(a, triangle.p);
  const std::uint32_t c = graph_.position(a, triangle.q);
  const auto at_b = around.partners(b);
  const auto at_c = around.partners(c);
  for (auto one = at_b.begin(), two = at_c.begin(); one != at_b.end() && two != at_c.end();) {
    if (one->y != two->y) {
      ++(one->y < two->y ? one : two);
      continue;
    }
    if (determinant(corners_.direction(a, b), corners_.direction(a, c),
                    corners_.direction(a, one->y)) > -kRounding)
      join(around, {b, c, one->y, *one, *two, triangle.tetrahedron}, found);
    ++one;
    ++two;
  }
}

void PrismSearch::join(const Around& around, const Start& start, CandidateList<6>& found) {
  const Index a = around.vertex();
  const auto neighbours = graph_.neighbours(a);
  const Index b = neighbours[start.b];
  const Index c = neighbours[start.c];
  const std::uint32_t c_at_b = graph_.position(b, c);
  for (const Fourth& e : around.fourths(start.bd)) {
    const std::uint32_t e_at_b = start.bd.is_swapped ? e.at_y : e.at_x;
    if (e.z == c) continue;
    const auto ends = corners_.between(b, c_at_b, e_at_b);
    for (const Fourth& f : around.fourths(start.cd)) {
      const auto end = std::lower_bound(ends.begin(), ends.end(), f.z,
                                        [](const Corner& x, Index z) { return x.z < z; });
      if (end == ends.end() || end->z != f.z || f.z == b || f.z == e.z) continue;
      offer({a, b, c, neighbours[start.d], e.z, f.z}, start.inside, found);
    }
  }
}

void PrismSearch::offer(const std::array<Index, 6>& cell, TetIndex start, CandidateList<6>& found) {
  if (const auto filling = filler_.filling(kPrismShape, cell, start))
    append_if_good(graph_, cell, *filling, quality_, quality::verdict_of_prism, found);
}

void PyramidSearch::visit(TetIndex t, CandidateList<5>& found) {
  for (unsigned facet = 0; facet < 4; ++facet) {
    const TetIndex other = graph_.across(t, facet);
    if (other == TetGraph::kOutside || other < t) continue;
    const Index u = graph_[t][facet];
    Index w = 0;
    for (unsigned i = 0; i < 4; ++i)
      if (graph_.across(other, i) == t) w = graph_[other][i];
    for (unsigned k = 0; k < 3; ++k) {
      // (x, y, z, u) is right-handed, and so is (y, u, z, x): apex x over the base y u z w.
      const Index x = graph_[t][kFacetFrom[facet][k]];
      std::array<Index, 5> cell{graph_[t][kFacetFrom[facet][(k + 1) % 3]], u,
                                graph_[t][kFacetFrom[facet][(k + 2) % 3]], w, x};
      std::rotate(cell.begin(), std::min_element(cell.begin(), cell.begin() + 4), cell.begin() + 4);
      if (const auto filling = filler_.filling(kPyramidShape, cell, t))
        append_if_good(graph_, cell, *filling, quality_, quality::verdict_of_pyramid, found);
    }
  }
}

}  // namespace hexatlas::hybrid
