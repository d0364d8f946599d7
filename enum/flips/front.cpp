#include "enum/flips/front.hpp"

#include <bit>

#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;

/// For each corner of the bottom and of the top the vertices that share a consumed quad with it.
struct PatchRelation {
  std::array<VertexSet, 4> bottom{}, top{};
};

PatchRelation patch_relation(Flip flip, const Prism& prism) noexcept {
  PatchRelation result;
  result.bottom.fill(set_of(prism.bottom));
  for (std::size_t i = 0; i < 4; ++i) {
    if (!flip.has(static_cast<unsigned>(i))) continue;
    const std::size_t j = (i + 1) % 4;
    const VertexSet side = set_of({prism.bottom[i], prism.bottom[j], prism.top[j], prism.top[i]});
    for (const std::size_t k : {i, j}) {
      result.bottom[k] |= side;
      result.top[k] |= side;
    }
  }
  return result;
}

/// The new number of each vertex of a former front, kNewVertex if it has none. A flip leaves most
/// vertices theirs, so that sets are renumbered by what has moved.
struct Renumbering {
  std::array<Vertex, complex::kMaxVertices> number{};
  VertexSet kept = 0, moved = 0;

  Renumbering(const Flipped& made, int vertices) {
    number.fill(kNewVertex);
    for (int v = 0; v < vertices; ++v) {
      const Vertex former = made.former[static_cast<std::size_t>(v)];
      if (former == kNewVertex) continue;
      number[former] = static_cast<Vertex>(v);
      (former == v ? kept : moved) |= bit(former);
    }
  }
  [[nodiscard]] VertexSet image(VertexSet set) const noexcept {
    VertexSet result = set & kept;
    for (VertexSet left = set & moved; left != 0; left &= left - 1)
      result |= bit(number[static_cast<std::size_t>(std::countr_zero(left))]);
    return result;
  }
};

}  // namespace

Relation relation_of_quads(const Quadrangulation& q) {
  core::expects(q.quads() <= kMaxFrontQuads, "a front has at most 62 quads");
  Relation related{};
  for (int i = 0; i < q.quads(); ++i) relate(set_of(q.vertices_of(i)), related);
  return related;
}

Front single_hexahedron() {
  const Quadrangulation cube = Quadrangulation::cube();
  Front front{.boundary = cube};
  for (int v = 0; v < cube.vertices(); ++v) front.related[static_cast<std::size_t>(v)] = 0xFF;
  return front;
}

bool may_glue(const Front& front, Flip flip, const Prism& prism) noexcept {
  const VertexSet all = set_of(prism.bottom) | set_of(prism.top);
  const PatchRelation patch = patch_relation(flip, prism);
  for (std::size_t i = 0; i < 4; ++i) {
    if ((front.related[prism.bottom[i]] & all) != patch.bottom[i]) return false;
    const Vertex top = prism.top[i];
    if (top != kNewVertex && (front.related[top] & all) != patch.top[i]) return false;
  }
  return true;
}

std::uint16_t possible_sides(const Front& front, complex::Quad bottom) noexcept {
  const Quadrangulation& q = front.boundary;
  const QuadVertices b = q.vertices_of(bottom);
  unsigned allowed = 0;             // sides that some set may have
  std::array<unsigned, 4> needs{};  // sides that a set with this one must have, too
  unsigned joined = 0;              // bit i: sides i - 1 and i meet in an edge at b_i
  std::array<complex::Dart, 4> side{};
  for (int i = 0; i < 4; ++i)
    side[static_cast<std::size_t>(i)] = q.twin(Quadrangulation::dart(bottom, i));
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned after = (i + 1) % 4, before = (i + 3) % 4;
    const VertexSet left = front.related[q.origin(Quadrangulation::opposite(side[i]))];
    const VertexSet right = front.related[q.origin(Quadrangulation::prev(side[i]))];
    if (q.twin(Quadrangulation::next(side[i])) == Quadrangulation::prev(side[before]))
      joined |= 1U << i;
    // The top vertices over b_i and b_(i+1) share no quad of a patch with the corners across.
    if ((left & bit(b[(i + 2) % 4])) != 0 || (right & bit(b[before])) != 0) continue;
    allowed |= 1U << i;
    // They may share one with the other neighbours, if the side there belongs to the patch.
    if ((left & bit(b[before])) != 0) needs[i] |= 1U << before;
    if ((right & bit(b[(i + 2) % 4])) != 0) needs[i] |= 1U << after;
  }
  unsigned result = 0;
  for (unsigned sides = 0; sides < kSideSets; ++sides) {
    bool is_possible = (sides & ~allowed) == 0;
    for (unsigned i = 0; i < 4; ++i) {
      if ((sides >> i & 1U) == 0) continue;
      const bool has_before = (sides >> (i + 3) % 4 & 1U) != 0;
      is_possible =
          is_possible && (needs[i] & ~sides) == 0 && (!has_before || (joined >> i & 1U) != 0);
    }
    if (is_possible) result |= 1U << sides;
  }
  return static_cast<std::uint16_t>(result);
}

Glued glued(const Front& front, Flip flip, const Prism& prism) {
  Glued result{.front = {}, .flipped = flipped(front.boundary, flip, prism)};
  const Flipped& made = result.flipped;
  result.front.boundary = made.quadrangulation;
  const int vertices = made.quadrangulation.vertices();
  core::expects(made.quadrangulation.quads() <= kMaxFrontQuads, "a front has at most 62 quads");

  const Renumbering renumbering(made, vertices);
  VertexSet hexahedron = set_of(made.top);
  for (const Vertex b : prism.bottom)
    if (renumbering.number[b] != kNewVertex) hexahedron |= bit(renumbering.number[b]);
  for (int v = 0; v < vertices; ++v) {
    const Vertex former = made.former[static_cast<std::size_t>(v)];
    VertexSet set = former == kNewVertex ? 0 : renumbering.image(front.related[former]);
    if ((hexahedron & bit(static_cast<Vertex>(v))) != 0) set |= hexahedron;
    result.front.related[static_cast<std::size_t>(v)] = set;
  }
  return result;
}

Shelling::Shelling() {
  Step first{.front = single_hexahedron()};
  first.vertices = 8;
  Cell cell{};
  for (std::uint16_t v = 0; v < 8; ++v) cell[v] = first.label[v] = v;
  steps_.push_back(first);
  cells_.push_back(cell);
}

std::optional<Flip> Shelling::push(Flip flip) {
  const Step& before = steps_.back();
  const Quadrangulation& boundary = before.front.boundary;
  const int after = boundary.quads() + 6 - 2 * flip.consumed();
  if (flip.bottom >= boundary.quads() || after < 6 || after > kMaxFrontQuads) return std::nullopt;
  const auto prism = prism_of(boundary, flip);
  if (!prism || !may_glue(before.front, flip, *prism)) return std::nullopt;

  Glued result = glued(before.front, flip, *prism);
  Step step{.front = result.front};
  step.vertices = before.vertices;
  for (int v = 0; v < result.front.boundary.vertices(); ++v) {
    const auto at = static_cast<std::size_t>(v);
    const Vertex former = result.flipped.former[at];
    step.label[at] =
        former != kNewVertex ? before.label[former] : static_cast<std::uint16_t>(step.vertices++);
  }
  // The prism convention wants the hexahedron below its bottom quad; here it stands on it, so
  // the new quad on top, which faces outwards, takes the place of the bottom.
  Cell cell{};
  for (std::size_t i = 0; i < 4; ++i) {
    cell[cells::kCornerOfPrism[i]] = step.label[result.flipped.top[i]];
    cell[cells::kCornerOfPrism[4 + i]] = before.label[prism->bottom[i]];
  }
  steps_.push_back(step);
  cells_.push_back(cell);
  return result.flipped.inverse;
}

void Shelling::pop() {
  core::expects(steps_.size() > 1, "the first hexahedron stays");
  steps_.pop_back();
  cells_.pop_back();
}

}  // namespace hexatlas::flips
