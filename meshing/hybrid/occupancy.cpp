#include "meshing/hybrid/occupancy.hpp"

#include <algorithm>
#include <array>

#include "enum/cells/cube.hpp"
#include "enum/cells/shapes.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::hybrid {
namespace {

std::uint64_t key(Index v, Index w) {
  return std::uint64_t{std::min(v, w)} << 32U | std::max(v, w);
}

template <std::size_t N>
CellView view(const CandidateList<N>& list, Shape shape, std::size_t i) {
  const Candidate<N>& cell = list.cells[i];
  const auto all = list.all(i);
  return {shape, cell.vertices, all.first(cell.inner), all.subspan(cell.inner), cell.quality};
}

/// visit(one diagonal, the other) twice for each quad.
template <class Visit>
void for_each_diagonal(const CellView& cell, const Visit& visit) {
  for (const LocalQuad& quad : quads_of(cell.shape)) {
    const std::uint64_t one = key(cell.vertices[quad[0]], cell.vertices[quad[2]]);
    const std::uint64_t other = key(cell.vertices[quad[1]], cell.vertices[quad[3]]);
    visit(one, other);
    visit(other, one);
  }
}

template <class Visit>
void for_each_edge(const CellView& cell, const Visit& visit) {
  for (const LocalEdge& edge : edges_of(cell.shape))
    visit(key(cell.vertices[edge[0]], cell.vertices[edge[1]]));
}

enum class PairKind : std::uint8_t { inside, edge, diagonal };

/// Two vertices of a cell; of a diagonal, also the other one of the quad.
struct LocalPair {
  PairKind kind = PairKind::inside;
  LocalEdge crossing{};
};
using PairTable = std::array<std::array<LocalPair, 8>, 8>;

PairTable make_pairs(Shape shape) {
  PairTable table{};
  for (const auto& [i, j] : edges_of(shape)) table[i][j] = table[j][i] = {PairKind::edge, {}};
  for (const LocalQuad& q : quads_of(shape)) {
    table[q[0]][q[2]] = table[q[2]][q[0]] = {PairKind::diagonal, {q[1], q[3]}};
    table[q[1]][q[3]] = table[q[3]][q[1]] = {PairKind::diagonal, {q[0], q[2]}};
  }
  return table;
}

const PairTable& pairs_of(Shape shape) {
  static const std::array<PairTable, kShapes> kTables{
      make_pairs(Shape::hexahedron), make_pairs(Shape::prism), make_pairs(Shape::pyramid)};
  return kTables[static_cast<std::size_t>(shape)];
}

}  // namespace

std::span<const LocalEdge> edges_of(Shape shape) {
  switch (shape) {
    case Shape::hexahedron:
      return cells::kCubeEdges;
    case Shape::prism:
      return cells::kPrismEdges;
    case Shape::pyramid:
      return cells::kPyramidEdges;
  }
  throw core::InternalError("hybrid: unknown shape");
}

std::span<const LocalQuad> quads_of(Shape shape) {
  switch (shape) {
    case Shape::hexahedron:
      return cells::kFacetVertices;
    case Shape::prism:
      return std::span(cells::kPrismFacets).subspan(2);
    case Shape::pyramid:
      return std::span(cells::kPyramidFacets).first(1);
  }
  throw core::InternalError("hybrid: unknown shape");
}

CellView view_of(const Candidates& candidates, Cell cell) {
  switch (cell.shape) {
    case Shape::hexahedron:
      return view(candidates.hexahedra, cell.shape, cell.index);
    case Shape::prism:
      return view(candidates.prisms, cell.shape, cell.index);
    case Shape::pyramid:
      return view(candidates.pyramids, cell.shape, cell.index);
  }
  throw core::InternalError("hybrid: unknown shape");
}

bool are_compatible(const CellView& a, const CellView& b) {
  const auto meet = [](std::span<const TetIndex> one, std::span<const TetIndex> other) {
    return std::find_first_of(one.begin(), one.end(), other.begin(), other.end()) != one.end();
  };
  if (meet(a.inner, b.inner) || meet(a.inner, b.flat) || meet(a.flat, b.inner)) return false;
  constexpr std::uint8_t kNone = 8;
  std::array<std::uint8_t, 8> image{};  // of the vertices of a among those of b
  std::size_t common = 0;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const auto it = std::find(b.vertices.begin(), b.vertices.end(), a.vertices[i]);
    image[i] = it == b.vertices.end() ? kNone : static_cast<std::uint8_t>(it - b.vertices.begin());
    if (image[i] != kNone) ++common;
  }
  if (common < 2) return true;
  const PairTable& in_a = pairs_of(a.shape);
  const PairTable& in_b = pairs_of(b.shape);
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    for (std::size_t j = i + 1; j < a.vertices.size(); ++j) {
      if (image[i] == kNone || image[j] == kNone) continue;
      const LocalPair& one = in_a[i][j];
      const LocalPair& other = in_b[image[i]][image[j]];
      if (one.kind == PairKind::inside || other.kind == PairKind::inside) continue;
      if (one.kind != other.kind) return false;
      if (one.kind == PairKind::edge) continue;
      const std::uint8_t k = image[one.crossing[0]];
      const std::uint8_t l = image[one.crossing[1]];
      if (std::minmax(k, l) != std::minmax(other.crossing[0], other.crossing[1])) return false;
    }
  return true;
}

bool Occupancy::fits(const CellView& cell) const {
  for (const TetIndex t : cell.inner)
    if (owner_[t] != kFree || flats_[t] != 0) return false;
  for (const TetIndex t : cell.flat)
    if (owner_[t] != kFree) return false;
  return fits_pairs(cell);
}

bool Occupancy::fits_pairs(const CellView& cell) const {
  bool fits = true;
  for_each_edge(cell, [&](std::uint64_t edge) {
    if (!fits) return;
    const auto it = pairs_.find(edge);
    fits = it == pairs_.end() || it->second.diagonals == 0;
  });
  for_each_diagonal(cell, [&](std::uint64_t one, std::uint64_t other) {
    if (!fits) return;
    const auto it = pairs_.find(one);
    if (it == pairs_.end()) return;
    const Pair& pair = it->second;
    fits = pair.edges == 0 && (pair.diagonals == 0 || pair.other == other);
  });
  return fits;
}

void Occupancy::put(const CellView& cell, std::uint32_t name) {
  for (const TetIndex t : cell.inner) owner_[t] = name;
  for (const TetIndex t : cell.flat) ++flats_[t];
  for_each_edge(cell, [&](std::uint64_t edge) { ++pairs_[edge].edges; });
  for_each_diagonal(cell, [&](std::uint64_t one, std::uint64_t other) {
    Pair& pair = pairs_[one];
    ++pair.diagonals;
    pair.other = other;
  });
}

void Occupancy::take(const CellView& cell) {
  const auto drop = [&](std::uint64_t which, std::uint32_t Pair::*count) {
    const auto it = pairs_.find(which);
    core::ensures(it != pairs_.end() && it->second.*count > 0, "a cell that is in has its pairs");
    --(it->second.*count);
    if (it->second.edges == 0 && it->second.diagonals == 0) pairs_.erase(it);
  };
  for (const TetIndex t : cell.inner) owner_[t] = kFree;
  for (const TetIndex t : cell.flat) --flats_[t];
  for_each_edge(cell, [&](std::uint64_t edge) { drop(edge, &Pair::edges); });
  for_each_diagonal(cell, [&](std::uint64_t one, std::uint64_t) { drop(one, &Pair::diagonals); });
}

}  // namespace hexatlas::hybrid
