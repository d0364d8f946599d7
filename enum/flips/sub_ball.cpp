#include "enum/flips/sub_ball.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "enum/complex/facets.hpp"

namespace hexatlas::flips {
namespace {

using complex::Vertex;
using Corners = std::array<Vertex, 8>;

constexpr bool has(FacetSet set, unsigned facet) noexcept { return (set.bits >> facet & 1U) != 0; }

/// The facet other than `bottom` that contains both ends of an edge of it.
unsigned side_at(unsigned bottom, unsigned u, unsigned v) noexcept {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned facet = 2 * axis + (u >> axis & 1U);
    if ((u >> axis & 1U) == (v >> axis & 1U) && facet != bottom) return facet;
  }
  return bottom;
}

}  // namespace

std::optional<PlacedFlip> flip_of(const complex::Quadrangulation& boundary, const Corners& corner,
                                  FacetSet patch) {
  if (!kind_of(patch)) return std::nullopt;
  unsigned bottom = 0;  // a patch has a facet whose opposite one it does not have
  while (!has(patch, bottom) || has(patch, bottom ^ 1U)) ++bottom;
  VertexSet wanted = 0;
  for (const cells::CubeVertex c : cells::kFacetVertices[bottom]) {
    if (corner[c] == kNewVertex) return std::nullopt;
    wanted |= bit(corner[c]);
  }
  for (int q = 0; q < boundary.quads(); ++q) {
    const complex::QuadVertices b = boundary.vertices_of(q);
    if (set_of(b) != wanted) continue;
    PlacedFlip placed{{static_cast<complex::Quad>(q), 0}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = std::find(corner.begin(), corner.end(), b[i]) - corner.begin();
      placed.bottom[i] = static_cast<cells::CubeVertex>(at);
      placed.top[i] = static_cast<cells::CubeVertex>(placed.bottom[i] ^ 1U << bottom / 2);
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (has(patch, side_at(bottom, placed.bottom[i], placed.bottom[(i + 1) % 4])))
        placed.flip.sides = static_cast<std::uint8_t>(placed.flip.sides | 1U << i);
    return placed;
  }
  return std::nullopt;
}

SubBall::Neighbours SubBall::neighbours_of(const complex::HexComplex& mesh) {
  Neighbours result(mesh.hexahedra.size());
  for (auto& own : result) own.fill(kOutside);
  const std::vector<complex::Facet> facets = complex::sorted_facets(mesh);
  for (std::size_t i = 0; i + 1 < facets.size(); ++i) {
    if (facets[i].key != facets[i + 1].key) continue;
    result[facets[i].cell][facets[i].facet] = facets[i + 1].cell;
    result[facets[i + 1].cell][facets[i + 1].facet] = facets[i].cell;
  }
  return result;
}

SubBall::SubBall(const complex::HexComplex& mesh, const Neighbours& neighbours, std::uint32_t first)
    : mesh_(mesh), neighbours_(neighbours) {
  restart(first);
}

void SubBall::restart(std::uint32_t first) {
  for (int v = 0; v < (cells_.empty() ? 0 : front_.boundary.vertices()); ++v)
    on_rim_[rim_[static_cast<std::size_t>(v)]] = kNewVertex;
  for (auto* touched : {&cells_, &touching_}) {
    for (const std::uint32_t cell : *touched) {
      inside_[cell] = false;
      shared_[cell] = 0;
    }
    touched->clear();
  }
  inside_.resize(std::max(inside_.size(), mesh_.hexahedra.size()));
  shared_.resize(inside_.size());
  on_rim_.resize(std::max<std::size_t>(on_rim_.size(), mesh_.vertices), kNewVertex);
  front_ = single_hexahedron();
  take_in(first);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    rim_[corner] = mesh_.hexahedra[first][corner];
    on_rim_[rim_[corner]] = static_cast<Vertex>(corner);
  }
}

bool SubBall::grow(std::uint32_t cell) {
  FacetSet patch;
  for (unsigned f = 0; f < cells::kCubeFacets; ++f)
    if (neighbours_[cell][f] != kOutside && inside_[neighbours_[cell][f]])
      patch.bits = static_cast<std::uint8_t>(patch.bits | 1U << f);
  const int after = front_.boundary.quads() + 6 - 2 * patch.size();
  if (inside_[cell] || after < 6 || after > kMaxSearchQuads) return false;
  const complex::Hexahedron& vertices = mesh_.hexahedra[cell];
  Corners corner{};
  for (std::size_t i = 0; i < 8; ++i) corner[i] = on_rim_[vertices[i]];
  const auto placed = flip_of(front_.boundary, corner, patch);
  if (!placed) return false;
  const auto prism = prism_of(front_.boundary, placed->flip);
  if (!prism || !may_glue(front_, placed->flip, *prism)) return false;
  for (std::size_t i = 0; i < 4; ++i)  // a corner beyond the patch must be new
    if (corner[placed->top[i]] != prism->top[i]) return false;
  const Glued next = glued(front_, placed->flip, *prism);
  const auto former_rim = rim_;
  for (int v = 0; v < front_.boundary.vertices(); ++v)
    on_rim_[former_rim[static_cast<std::size_t>(v)]] = kNewVertex;
  for (std::size_t v = 0; v < static_cast<std::size_t>(next.front.boundary.vertices()); ++v)
    if (next.flipped.former[v] != kNewVertex) rim_[v] = former_rim[next.flipped.former[v]];
  for (std::size_t i = 0; i < 4; ++i) rim_[next.flipped.top[i]] = vertices[placed->top[i]];
  front_ = next.front;
  for (int v = 0; v < front_.boundary.vertices(); ++v)
    on_rim_[rim_[static_cast<std::size_t>(v)]] = static_cast<Vertex>(v);
  take_in(cell);
  return true;
}

void SubBall::take_in(std::uint32_t cell) {
  inside_[cell] = true;
  cells_.push_back(cell);
  std::erase(touching_, cell);
  for (const std::uint32_t other : neighbours_[cell])
    if (other != kOutside && !inside_[other] && shared_[other]++ == 0) touching_.push_back(other);
}

bool SubBall::grow_somewhere(core::Random& random, int weight) {
  std::vector<std::pair<int, std::uint32_t>> candidates;
  candidates.reserve(touching_.size());
  for (const std::uint32_t cell : touching_)
    candidates.emplace_back(weight * shared_[cell] + static_cast<int>(random.below(6)), cell);
  std::sort(candidates.rbegin(), candidates.rend());
  return std::any_of(candidates.begin(), candidates.end(),
                     [this](const auto& candidate) { return grow(candidate.second); });
}

/// Relates the boundary vertices of a hexahedron if it lies outside.
void SubBall::relate(std::uint32_t cell, Relation& related) const {
  if (inside_[cell]) return;
  VertexSet own = 0;
  for (const complex::VertexId v : mesh_.hexahedra[cell])
    if (on_rim_[v] != kNewVertex) own |= bit(on_rim_[v]);
  for (VertexSet rest = own; rest != 0; rest &= rest - 1)
    related[static_cast<std::size_t>(std::countr_zero(rest))] |= own;
}

Relation SubBall::related_outside() const {
  Relation related{};
  for (std::uint32_t cell = 0; cell < mesh_.hexahedra.size(); ++cell) relate(cell, related);
  return related;
}

Relation SubBall::related_outside(const CellsAt& cells_at) const {
  Relation related{};
  for (int v = 0; v < front_.boundary.vertices(); ++v)
    for (const std::uint32_t cell : cells_at[rim(static_cast<Vertex>(v))]) relate(cell, related);
  return related;
}

}  // namespace hexatlas::flips
