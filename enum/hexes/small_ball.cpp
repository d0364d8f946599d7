#include "enum/hexes/small_ball.hpp"

#include <algorithm>
#include <bit>
#include <optional>

#include "enum/core/checks.hpp"

namespace hexatlas::hexes {
namespace {

/// For each vertex those in one hexahedron with it, itself included; empty if it is in none.
using Relation = std::array<VertexSet, kMaxBallVertices>;

constexpr std::size_t kNoCell = SmallBall::Neighbour::kNone;

VertexSet set_of(const Corners& cell) noexcept {
  VertexSet set = 0;
  for (const Vertex v : cell) set |= bit(v);
  return set;
}

VertexSet facet_set(const Corners& cell, std::size_t facet) noexcept {
  VertexSet set = 0;
  for (const cells::CubeVertex corner : cells::kFacetVertices[facet]) set |= bit(cell[corner]);
  return set;
}

/// The relation of all hexahedra but one.
Relation relation_without(const SmallBall& ball, std::size_t left_out) noexcept {
  Relation related{};
  for (std::size_t c = 0; c < ball.cells().size(); ++c) {
    if (c == left_out) continue;
    const VertexSet set = set_of(ball.cell(c));
    for (const Vertex v : ball.cell(c)) related[v] |= set;
  }
  return related;
}

/// Whether facets of a cube, bit f for facet f, are a patch. They are if and only if some facet is
/// among them and its opposite is not: then they are that facet and some that touch it along
/// edges, and so are the others.
bool is_patch(unsigned facets) noexcept { return ((facets ^ facets >> 1U) & 0b01'01'01U) != 0; }

/// Whether two vertices of `cell` that are related lie in one of the facets, and no vertex outside
/// the facets is in a hexahedron.
bool meets_in(const Corners& cell, unsigned facets, const Relation& related) noexcept {
  std::array<VertexSet, cells::kCubeVertices> allowed{};
  for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
    if ((facets >> f & 1U) == 0) continue;
    const VertexSet set = facet_set(cell, f);
    for (const cells::CubeVertex corner : cells::kFacetVertices[f]) allowed[corner] |= set;
  }
  const VertexSet all = set_of(cell);
  for (std::size_t corner = 0; corner < cell.size(); ++corner)
    if ((related[cell[corner]] & all) != allowed[corner]) return false;
  return true;
}

/// Whether no edge or vertex inside the disc of these facets of `cell` is on the boundary. Where
/// two facets have no common edge, or three no common vertex, nothing is asked.
bool is_inside(const SmallBall& ball, const Corners& cell, unsigned facets) noexcept {
  VertexSet corners = 0;  // inside the disc
  std::array<VertexSet, cells::kCubeVertices * 3 / 2> edges{};
  std::size_t edge_count = 0;
  for (std::size_t f = 0; f < cells::kCubeFacets; ++f)
    for (std::size_t g = 0; g < f; ++g) {
      if ((facets >> f & facets >> g & 1U) == 0 || g == (f ^ 1U)) continue;
      edges[edge_count++] = facet_set(cell, f) & facet_set(cell, g);
      for (std::size_t e = 0; e < g; ++e)
        if ((facets >> e & 1U) != 0)
          corners |= facet_set(cell, e) & facet_set(cell, f) & facet_set(cell, g);
    }
  for (std::size_t c = 0; c < ball.cells().size(); ++c)
    for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
      if (ball.neighbour(c, f).exists()) continue;
      const VertexSet set = facet_set(ball.cell(c), f);
      if ((set & corners) != 0) return false;
      for (std::size_t i = 0; i < edge_count; ++i)
        if ((set & edges[i]) == edges[i]) return false;
    }
  return true;
}

/// The quads on the boundary, counter-clockwise from outside, and where they belong.
class Boundary {
 public:
  explicit Boundary(const SmallBall& ball) {
    for (std::size_t c = 0; c < ball.cells().size(); ++c)
      for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
        if (ball.neighbour(c, f).exists()) continue;
        const auto number = static_cast<std::uint8_t>(count_);
        Quad& quad = quads_[count_++];
        quad.cell = static_cast<std::uint8_t>(c);
        quad.facet = static_cast<std::uint8_t>(f);
        for (std::size_t i = 0; i < 4; ++i)
          quad.vertices[i] = ball.cell(c)[cells::kFacetVertices[f][i]];
        for (std::size_t i = 0; i < 4; ++i)
          left_of_[quad.vertices[i]][quad.vertices[(i + 1) % 4]] = number;
      }
  }

  struct Quad {
    Facet vertices{};
    std::uint8_t cell = 0, facet = 0;
  };

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] const Quad& quad(std::size_t q) const noexcept { return quads_[q]; }
  /// The quad beyond edge i of a quad.
  [[nodiscard]] std::size_t beyond(std::size_t q, std::size_t i) const noexcept {
    const Facet& at = quads_[q].vertices;
    return left_of_[at[(i + 1) % 4]][at[i]];
  }
  /// The vertex after v on a quad.
  [[nodiscard]] Vertex after(std::size_t q, Vertex v) const noexcept {
    const Facet& at = quads_[q].vertices;
    const auto place = static_cast<std::size_t>(std::find(at.begin(), at.end(), v) - at.begin());
    return at[(place + 1) % 4];
  }
  [[nodiscard]] Vertex before(std::size_t q, Vertex v) const noexcept {
    const Facet& at = quads_[q].vertices;
    const auto place = static_cast<std::size_t>(std::find(at.begin(), at.end(), v) - at.begin());
    return at[(place + 3) % 4];
  }

 private:
  std::array<Quad, kMaxBallQuads> quads_{};
  std::size_t count_ = 0;
  /// The quad with this edge, in its own direction: the graph of a boundary is simple.
  std::array<std::array<std::uint8_t, kMaxBallVertices>, kMaxBallVertices> left_of_{};
};

/// The hexahedron above a quad stands on it with facet 5, and its facet over edge i is this one.
constexpr std::size_t kBottomFacet = 5;
constexpr std::array<std::uint8_t, 4> kFacetOverEdge{0, 3, 1, 2};

/// The hexahedron on quad `bottom` that has the quads beyond the edges of `sides`, too; nothing if
/// these are no patch, if the patch has another name with a lower bottom, or if the strict rule
/// forbids it.
std::optional<Gluing> gluing_on(const SmallBall& ball, const Boundary& boundary,
                                const Relation& related, std::size_t bottom, unsigned sides) {
  const Boundary::Quad& below = boundary.quad(bottom);
  Gluing gluing;
  unsigned facets = 1U << kBottomFacet;
  gluing.joints[0] = {kBottomFacet, below.cell, below.facet};
  gluing.joint_count = 1;
  constexpr Vertex kUnset = 0xFF;
  Facet top{kUnset, kUnset, kUnset, kUnset};
  for (std::size_t i = 0; i < 4; ++i) {
    if ((sides >> i & 1U) == 0) continue;
    const std::size_t j = (i + 1) % 4;
    const std::size_t side = boundary.beyond(bottom, i);
    const bool is_bottom_too = (sides >> (i + 2) % 4 & 1U) == 0;
    if (is_bottom_too && side < bottom) return std::nullopt;
    const Vertex over_i = boundary.after(side, below.vertices[i]);
    const Vertex over_j = boundary.before(side, below.vertices[j]);
    if ((top[i] != kUnset && top[i] != over_i) || (top[j] != kUnset && top[j] != over_j))
      return std::nullopt;
    top[i] = over_i;
    top[j] = over_j;
    facets |= 1U << kFacetOverEdge[i];
    gluing.joints[static_cast<std::size_t>(gluing.joint_count++)] = {
        kFacetOverEdge[i], boundary.quad(side).cell, boundary.quad(side).facet};
  }
  int fresh = ball.vertices();
  for (std::size_t i = 0; i < 4; ++i) {
    if (top[i] == kUnset) top[i] = static_cast<Vertex>(fresh++);
    gluing.cell[cells::kCornerOfPrism[i]] = top[i];
    gluing.cell[cells::kCornerOfPrism[4 + i]] = below.vertices[i];
  }
  if (std::popcount(set_of(gluing.cell)) != cells::kCubeVertices) return std::nullopt;
  if (!meets_in(gluing.cell, facets, related)) return std::nullopt;
  return gluing;
}

}  // namespace

SmallBall::SmallBall(std::span<const Corners> cells) {
  core::expects(!cells.empty() && cells.size() <= kMaxBallHexahedra,
                "a small ball has 1 to 12 hexahedra");
  struct Open {
    VertexSet set = 0;
    std::uint8_t cell = 0, facet = 0;
  };
  std::array<Open, cells::kCubeFacets * kMaxBallHexahedra> open{};
  std::size_t open_count = 0;
  for (const Corners& cell : cells) {
    const auto c = static_cast<std::size_t>(size_++);
    cells_[c] = cell;
    for (const Vertex v : cell) vertices_ = std::max(vertices_, v + 1);
    for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
      const VertexSet set = facet_set(cell, f);
      const auto end = open.begin() + static_cast<std::ptrdiff_t>(open_count);
      const auto at = std::find_if(open.begin(), end, [&](const Open& o) { return o.set == set; });
      if (at == end) {
        open[open_count++] = {set, static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(f)};
      } else {
        join(c, {static_cast<std::uint8_t>(f), at->cell, at->facet});
        *at = open[--open_count];
      }
    }
  }
}

/// Facet 2k + s has as its axis the bit k of corners.
void SmallBall::join(std::size_t c, Joint joint) {
  const Corners& own = cells_[c];
  const Corners& other = cells_[joint.other];
  const unsigned own_axis = 1U << (joint.facet >> 1U);
  const unsigned other_axis = 1U << (joint.other_facet >> 1U);
  cells::CornerMap there{}, back{};
  for (const cells::CubeVertex corner : cells::kFacetVertices[joint.facet]) {
    const auto at =
        static_cast<unsigned>(std::find(other.begin(), other.end(), own[corner]) - other.begin());
    core::ensures(at < other.size(), "glued facets have the same vertices");
    there[corner] = static_cast<cells::CubeVertex>(at ^ other_axis);
    there[corner ^ own_axis] = static_cast<cells::CubeVertex>(at);
    back[at] = static_cast<cells::CubeVertex>(corner ^ own_axis);
    back[at ^ other_axis] = corner;
  }
  neighbours_[c][joint.facet] = {joint.other, cells::symmetry_of(there)};
  neighbours_[joint.other][joint.other_facet] = {static_cast<std::uint8_t>(c),
                                                 cells::symmetry_of(back)};
  shared_[c] = static_cast<std::uint8_t>(shared_[c] | 1U << joint.facet);
  shared_[joint.other] = static_cast<std::uint8_t>(shared_[joint.other] | 1U << joint.other_facet);
}

void SmallBall::glue(const Gluing& gluing) {
  core::expects(size_ < kMaxBallHexahedra, "a small ball has at most 12 hexahedra");
  const auto c = static_cast<std::size_t>(size_++);
  cells_[c] = gluing.cell;
  for (const Vertex v : gluing.cell) vertices_ = std::max(vertices_, v + 1);
  for (int i = 0; i < gluing.joint_count; ++i) join(c, gluing.joints[static_cast<std::size_t>(i)]);
}

SmallBall SmallBall::without(std::size_t c) const {
  std::array<Corners, kMaxBallHexahedra> rest{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells().size(); ++i)
    if (i != c) rest[count++] = cells_[i];
  return SmallBall({rest.data(), count});
}

std::vector<Gluing> gluings(const SmallBall& ball) {
  core::expects(ball.size() < kMaxBallHexahedra, "a small ball has at most 12 hexahedra");
  const Boundary boundary(ball);
  const Relation related = relation_without(ball, kNoCell);
  std::vector<Gluing> result;
  for (std::size_t bottom = 0; bottom < boundary.size(); ++bottom)
    for (unsigned sides = 0; sides < 16; ++sides)
      if (const auto gluing = gluing_on(ball, boundary, related, bottom, sides))
        result.push_back(*gluing);
  return result;
}

bool is_removable(const SmallBall& ball, std::size_t c) {
  const unsigned shared = ball.shared_facets(c);
  return is_patch(shared) && is_inside(ball, ball.cell(c), shared) &&
         meets_in(ball.cell(c), shared, relation_without(ball, c));
}

complex::HexComplex complex_of(const SmallBall& ball) {
  complex::HexComplex result{static_cast<std::uint32_t>(ball.vertices()), {}};
  for (const Corners& cell : ball.cells()) {
    complex::Hexahedron hexahedron{};
    std::copy(cell.begin(), cell.end(), hexahedron.begin());
    result.hexahedra.push_back(hexahedron);
  }
  return result;
}

}  // namespace hexatlas::hexes
