#include "enum/complex/spin_sphere.hpp"

#include <algorithm>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::complex {
namespace {

/// Equations over Z/2: of each row the sum of the unknowns whose bits are set is its last bit.
class Equations {
 public:
  explicit Equations(std::size_t unknowns) : unknowns_(unknowns), words_(unknowns / 64 + 1) {}

  [[nodiscard]] std::vector<std::uint64_t> row() const {
    return std::vector<std::uint64_t>(words_, 0);
  }
  void flip(std::vector<std::uint64_t>& row, std::size_t unknown) const {
    row[unknown / 64] ^= std::uint64_t{1} << unknown % 64;
  }
  void flip_sum(std::vector<std::uint64_t>& row) const { flip(row, unknowns_); }
  void add(std::vector<std::uint64_t> row) { rows_.push_back(std::move(row)); }

  /// A solution; InternalError if there is none.
  [[nodiscard]] std::vector<bool> solution() && {
    std::vector<std::size_t> pivot;
    for (std::size_t unknown = 0; unknown < unknowns_; ++unknown) {
      const std::size_t next = pivot.size();
      std::size_t at = next;
      while (at < rows_.size() && !has(rows_[at], unknown)) ++at;
      if (at == rows_.size()) continue;
      std::swap(rows_[next], rows_[at]);
      for (std::size_t r = 0; r < rows_.size(); ++r)
        if (r != next && has(rows_[r], unknown))
          for (std::size_t w = 0; w < words_; ++w) rows_[r][w] ^= rows_[next][w];
      pivot.push_back(unknown);
    }
    for (std::size_t r = pivot.size(); r < rows_.size(); ++r)
      core::ensures(!has(rows_[r], unknowns_), "a sphere has a spin structure");
    std::vector<bool> result(unknowns_);
    for (std::size_t r = 0; r < pivot.size(); ++r) result[pivot[r]] = has(rows_[r], unknowns_);
    return result;
  }

 private:
  static bool has(const std::vector<std::uint64_t>& row, std::size_t unknown) {
    return (row[unknown / 64] >> unknown % 64 & 1U) != 0;
  }
  std::size_t unknowns_, words_;
  std::vector<std::vector<std::uint64_t>> rows_;
};

/// From one corner of a hexahedron to an adjacent one.
AxisVector step_between(const Hexahedron& cell, VertexId from, VertexId to) {
  const auto a = static_cast<unsigned>(std::find(cell.begin(), cell.end(), from) - cell.begin());
  const auto b = static_cast<unsigned>(std::find(cell.begin(), cell.end(), to) - cell.begin());
  AxisVector result{};
  for (unsigned axis = 0; axis < 3; ++axis)
    result[axis] = static_cast<int>(b >> axis & 1U) - static_cast<int>(a >> axis & 1U);
  return result;
}

/// The mirror image with other vertices inside.
HexComplex mirrored_outside(const HexComplex& mesh, VertexId shared, VertexId first_new) {
  HexComplex result = mirrored(mesh);
  for (Hexahedron& cell : result.hexahedra)
    for (VertexId& v : cell)
      if (v >= shared) v += first_new - shared;
  return result;
}

int dot(const AxisVector& a, const AxisVector& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

/// Once around an edge.
struct SpinSphere::EdgeWalk {
  struct Step {
    std::uint32_t cell = 0, in = 0, out = 0;  ///< a hexahedron and its two facets at the edge
  };
  std::vector<Step> steps;
  Quaternion product, wanted;
};

SpinSphere::SpinSphere(const HexComplex& ball, const HexComplex& other, VertexId shared) {
  const HexComplex outside = mirrored_outside(other, shared, ball.vertices);
  std::vector<Hexahedron> cells = ball.hexahedra;
  cells.insert(cells.end(), outside.hexahedra.begin(), outside.hexahedra.end());
  across_.resize(cells.size());
  std::array<std::vector<Facet>, 2> boundary;
  for (std::size_t side = 0; side < 2; ++side) {
    const HexComplex& mesh = side == 0 ? ball : outside;
    const auto first = static_cast<std::uint32_t>(side == 0 ? 0 : ball.hexahedra.size());
    const std::vector<Facet> facets = sorted_facets(mesh);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      if (i + 1 == facets.size() || facets[i].key != facets[i + 1].key) {
        boundary[side].push_back(facets[i]);
        continue;
      }
      glue(cells, first + facets[i].cell, facets[i].facet, first + facets[i + 1].cell,
           facets[i + 1].facet);
      ++i;
    }
  }
  core::expects(boundary[0].size() == boundary[1].size(), "two balls have one boundary");
  for (std::size_t i = 0; i < boundary[0].size(); ++i) {
    const Facet &inner = boundary[0][i], &outer = boundary[1][i];
    core::expects(inner.key == outer.key && inner.key.back() < shared &&
                      are_opposite(inner.cycle, outer.cycle),
                  "two balls have one boundary");
    glue(cells, inner.cell, inner.facet,
         static_cast<std::uint32_t>(ball.hexahedra.size()) + outer.cell, outer.facet);
  }
  lift();
}

void SpinSphere::glue(const std::vector<Hexahedron>& cells, std::uint32_t cell, std::uint32_t facet,
                      std::uint32_t other_cell, std::uint32_t other_facet) {
  std::array<VertexId, 3> corner{};  // one and its two neighbours within the quad
  for (std::size_t i = 0; i < 3; ++i)
    corner[i] = cells[cell][cells::kFacetVertices[facet][std::array{0U, 1U, 3U}[i]]];
  std::array<AxisVector, 3> here{}, there{};
  for (std::size_t i = 0; i < 2; ++i) {
    here[i] = step_between(cells[cell], corner[0], corner[i + 1]);
    there[i] = step_between(cells[other_cell], corner[0], corner[i + 1]);
  }
  here[2] = cross(here[0], here[1]);
  there[2] = cross(there[0], there[1]);
  const auto image = [&](const AxisVector& v) {
    AxisVector result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) result[axis] += dot(v, here[i]) * there[i][axis];
    return result;
  };
  const Quaternion passage = rotation(image({1, 0, 0}), image({0, 1, 0}));
  across_[cell][facet] = {other_cell, other_facet, glued_, passage};
  across_[other_cell][other_facet] = {cell, facet, glued_, passage.inverse()};
  ++glued_;
}

/// Around the edge of two facets of a hexahedron, out by the second one until back by the first.
SpinSphere::EdgeWalk SpinSphere::around(std::uint32_t cell, std::uint32_t in,
                                        std::uint32_t out) const {
  const AxisVector axis = cross(normal_of(out), normal_of(in));
  EdgeWalk walk;
  std::uint32_t c = cell, came = in, goes = out;
  do {
    const Across& next = across_[c][goes];
    walk.steps.push_back({c, came, goes});
    walk.product = next.passage * walk.product;
    c = next.cell;
    // The edge is where the facet that we came by meets the one that the last one goes on in.
    goes = next.carried(came);
    came = next.facet;
  } while (c != cell || came != in || goes != out);
  const Quaternion back = quarter_turn(axis).inverse(), forth = quarter_turn(axis);
  for (std::size_t k = 4; k < walk.steps.size(); ++k) walk.wanted = back * walk.wanted;
  for (std::size_t k = walk.steps.size(); k < 4; ++k) walk.wanted = forth * walk.wanted;
  return walk;
}

void SpinSphere::lift() {
  Equations equations(quads());
  std::vector<std::array<std::array<bool, 6>, 6>> seen(cells());
  for (std::uint32_t cell = 0; cell < cells(); ++cell)
    for (std::uint32_t in = 0; in < 6; ++in)
      for (std::uint32_t out = 0; out < 6; ++out) {
        if (in / 2 == out / 2 || seen[cell][in][out]) continue;
        const EdgeWalk walk = around(cell, in, out);
        auto row = equations.row();
        for (const EdgeWalk::Step& step : walk.steps) {
          seen[step.cell][step.in][step.out] = seen[step.cell][step.out][step.in] = true;
          equations.flip(row, across_[step.cell][step.out].quad);
        }
        const bool is_opposite = walk.product == -walk.wanted;
        core::ensures(is_opposite || walk.product == walk.wanted,
                      "around an edge coordinates turn about it");
        if (is_opposite) equations.flip_sum(row);
        equations.add(std::move(row));
      }
  const std::vector<bool> is_other = std::move(equations).solution();
  for (auto& own : across_)
    for (Across& next : own)
      if (is_other[next.quad]) next.passage = -next.passage;
}

}  // namespace hexatlas::complex
