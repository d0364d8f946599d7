#include "enum/flips/quad_flip.hpp"

#include <algorithm>

#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::Dart;
using complex::Quad;
using complex::Quadrangulation;
using complex::Vertex;

constexpr int mod4(int i) noexcept { return i & 3; }

/// Dart of side quad i that runs along the bottom, from b_(i+1) to b_i.
Dart side_dart(const Quadrangulation& q, Flip flip, int i) noexcept {
  return q.twin(Quadrangulation::dart(flip.bottom, mod4(i)));
}

/// The darts outside the patch that face its border, by place in the hexahedron.
struct Border {
  std::array<Dart, 4> base{};     ///< faces b_i b_(i+1), for i not in sides
  std::array<Dart, 4> roof{};     ///< faces t_i t_(i+1), for i in sides
  std::array<Dart, 4> lateral{};  ///< faces b_i t_i, for exactly one of i - 1, i in sides
};

Border border_of(const Quadrangulation& q, Flip flip) noexcept {
  Border border;
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Dart side = side_dart(q, flip, i);
    if (!flip.has(static_cast<unsigned>(i))) {
      border.base[at] = side;
      continue;
    }
    border.roof[at] = q.twin(Quadrangulation::opposite(side));
    if (!flip.has(static_cast<unsigned>(i + 3)))
      border.lateral[at] = q.twin(Quadrangulation::next(side));
    if (!flip.has(static_cast<unsigned>(i + 1)))
      border.lateral[(at + 1) % 4] = q.twin(Quadrangulation::prev(side));
  }
  return border;
}

/// Slots for the new quads: those of the consumed ones first, then fresh ones.
struct Slots {
  std::array<Quad, 6> quad{};
  int count = 0;
};

Slots consumed_slots(const Quadrangulation& q, Flip flip) noexcept {
  Slots slots;
  slots.quad[static_cast<std::size_t>(slots.count++)] = flip.bottom;
  for (int i = 0; i < 4; ++i)
    if (flip.has(static_cast<unsigned>(i)))
      slots.quad[static_cast<std::size_t>(slots.count++)] =
          Quadrangulation::quad_of(side_dart(q, flip, i));
  return slots;
}

/// Renumbers quad `from` to the free number `to`.
void move_quad(Quadrangulation& q, int from, int to) {
  const Quadrangulation::Editor edit{q};
  for (int i = 0; i < 4; ++i) {
    const Dart d = Quadrangulation::dart(from, i);
    const Dart e = Quadrangulation::dart(to, i);
    edit.set_origin(e, q.origin(d));
    const Dart twin = q.twin(d);
    // A twin in the same quad (vertex of degree 1) moves along with it.
    edit.link(e,
              Quadrangulation::quad_of(twin) == from ? Quadrangulation::dart(to, twin & 3) : twin);
  }
}

/// Puts in the new quads: free sides in ascending order, then the top.
void insert_quads(Quadrangulation& q, Flip flip, const Border& border, const Slots& slots,
                  const complex::QuadVertices& b, const complex::QuadVertices& t) {
  const Quadrangulation::Editor edit{q};
  std::array<Quad, 4> wall{};
  int used = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (!flip.has(static_cast<unsigned>(i))) wall[i] = slots.quad[static_cast<std::size_t>(used++)];
  const Quad top = slots.quad[static_cast<std::size_t>(used)];
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const std::size_t after = (at + 1) % 4;
    const Dart roof = Quadrangulation::dart(top, i);
    edit.set_origin(roof, t[at]);
    if (flip.has(static_cast<unsigned>(i))) {
      edit.link(roof, border.roof[at]);
      continue;
    }
    const std::array<Vertex, 4> corners{b[at], b[after], t[after], t[at]};
    for (int k = 0; k < 4; ++k)
      edit.set_origin(Quadrangulation::dart(wall[at], k), corners[static_cast<std::size_t>(k)]);
    edit.link(Quadrangulation::dart(wall[at], 0), border.base[at]);
    edit.link(Quadrangulation::dart(wall[at], 2), roof);
    edit.link(Quadrangulation::dart(wall[at], 1), flip.has(static_cast<unsigned>(i + 1))
                                                      ? border.lateral[after]
                                                      : Quadrangulation::dart(wall[after], 3));
    if (flip.has(static_cast<unsigned>(i + 3)))
      edit.link(Quadrangulation::dart(wall[at], 3), border.lateral[at]);
  }
}

void rename_vertex(Quadrangulation& q, Dart at, Vertex name) {
  const Quadrangulation::Editor edit{q};
  Dart d = at;
  do {
    edit.set_origin(d, name);
    d = q.turn_left(d);
  } while (d != at);
}

/// Takes the greatest element out of the front of a short list; the others keep no order.
template <class T>
T take_greatest(std::span<T>& list) noexcept {
  std::iter_swap(std::max_element(list.begin(), list.end()), list.end() - 1);
  const T greatest = list.back();
  list = list.first(list.size() - 1);
  return greatest;
}

/// The last quads move into the numbers set free; `followed` is a quad whose number is kept
/// up to date.
void close_quad_holes(Quadrangulation& q, std::span<Quad> holes, Quad& followed) {
  int quads = q.quads();
  while (!holes.empty()) {
    const Quad hole = take_greatest(holes);
    if (hole != --quads) move_quad(q, quads, hole);
    if (followed == quads) followed = hole;
  }
  Quadrangulation::Editor{q}.set_size(quads, q.vertices());
}

/// The last vertices move into the numbers set free.
void close_vertex_holes(Flipped& result, std::span<Vertex> holes) {
  Quadrangulation& q = result.quadrangulation;
  int vertices = q.vertices();
  while (!holes.empty()) {
    const Vertex hole = take_greatest(holes);
    const auto last = static_cast<Vertex>(--vertices);
    if (hole == last) continue;
    for (int d = 0; d < q.darts(); ++d)
      if (q.origin(static_cast<Dart>(d)) == last) {
        rename_vertex(q, static_cast<Dart>(d), hole);
        break;
      }
    result.former[hole] = result.former[last];
    std::replace(result.top.begin(), result.top.end(), last, hole);
  }
  Quadrangulation::Editor{q}.set_size(q.quads(), vertices);
}

/// Vertices of the bottom that the flip buries: both sides at them are consumed.
bool is_buried(Flip flip, int i) noexcept {
  return flip.has(static_cast<unsigned>(i)) && flip.has(static_cast<unsigned>(i + 3));
}

}  // namespace

std::optional<Prism> prism_of(const Quadrangulation& q, Flip flip) noexcept {
  Prism prism;
  prism.bottom = q.vertices_of(flip.bottom);
  prism.top.fill(kNewVertex);
  for (int i = 0; i < 4; ++i) {
    if (!flip.has(static_cast<unsigned>(i))) continue;
    const Dart side = side_dart(q, flip, i);
    if (flip.has(static_cast<unsigned>(i + 3)) &&
        q.twin(Quadrangulation::next(side)) != Quadrangulation::prev(side_dart(q, flip, i + 3)))
      return std::nullopt;
    prism.top[static_cast<std::size_t>(i)] = q.origin(Quadrangulation::opposite(side));
    prism.top[static_cast<std::size_t>(mod4(i + 1))] = q.origin(Quadrangulation::prev(side));
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const bool known = prism.top[j] != kNewVertex;
      if (i < j && prism.bottom[i] == prism.bottom[j]) return std::nullopt;
      if (known && prism.bottom[i] == prism.top[j]) return std::nullopt;
      if (known && i < j && prism.top[i] == prism.top[j]) return std::nullopt;
    }
  return prism;
}

bool is_preferred(const Quadrangulation& q, Flip flip) noexcept {
  const auto side_quad = [&](int i) { return Quadrangulation::quad_of(side_dart(q, flip, i)); };
  switch (kind_of(flip)) {
    case FlipKind::k1to5:
    case FlipKind::k3to3_strip:
    case FlipKind::k5to1:
      return true;
    case FlipKind::k2to4:
    case FlipKind::k3to3_corner:
      for (int i = 0; i < 4; ++i)
        if (flip.has(static_cast<unsigned>(i)) && side_quad(i) < flip.bottom) return false;
      return true;
    case FlipKind::k4to2:  // the other bottom is opposite to the side left out
      for (int i = 0; i < 4; ++i)
        if (!flip.has(static_cast<unsigned>(i))) return flip.bottom < side_quad(i + 2);
  }
  return true;
}

Flipped flipped(const Quadrangulation& q, Flip flip, const Prism& prism) {
  const int removed = flip.consumed();
  const int after = q.quads() + 6 - 2 * removed;
  core::expects(after >= 6 && after <= complex::kMaxQuads, "the flipped quads do not fit");
  const Border border = border_of(q, flip);
  Slots slots = consumed_slots(q, flip);
  for (int fresh = q.quads(); slots.count < 6 - removed; ++fresh)
    slots.quad[static_cast<std::size_t>(slots.count++)] = static_cast<Quad>(fresh);

  Flipped result{.quadrangulation = q};
  for (int v = 0; v < q.vertices(); ++v)
    result.former[static_cast<std::size_t>(v)] = static_cast<Vertex>(v);
  Quadrangulation& made = result.quadrangulation;

  // New vertices take the numbers of buried ones first, then fresh ones.
  std::array<Vertex, 4> buried{};
  int buried_count = 0;
  for (int i = 0; i < 4; ++i)
    if (is_buried(flip, i))
      buried[static_cast<std::size_t>(buried_count++)] = prism.bottom[static_cast<std::size_t>(i)];
  int vertices = q.vertices();
  result.top = prism.top;
  for (Vertex& v : result.top) {
    if (v != kNewVertex) continue;
    v = buried_count > 0 ? buried[static_cast<std::size_t>(--buried_count)]
                         : static_cast<Vertex>(vertices++);
    result.former[v] = kNewVertex;
  }
  const Quadrangulation::Editor edit{made};
  edit.set_size(std::max(q.quads(), after), vertices);
  insert_quads(made, flip, border, slots, prism.bottom, result.top);

  Quad top_slot = slots.quad[static_cast<std::size_t>(5 - removed)];
  const std::span<Quad> holes(slots.quad.data() + (6 - removed), slots.quad.data() + slots.count);
  close_quad_holes(made, holes, top_slot);
  close_vertex_holes(result, {buried.data(), static_cast<std::size_t>(buried_count)});
  // Seen from the other side the top is the bottom, and the walls are its sides.
  result.inverse = {top_slot, static_cast<std::uint8_t>(~flip.sides & 15U)};
  core::check_law([&] { return !made.validate(); }, "a flip broke the quadrangulation");
  return result;
}

}  // namespace hexatlas::flips
