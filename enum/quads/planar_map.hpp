#pragma once
/// \file
/// A plane map that grows and shrinks in place: the working form of the generator.
///
/// Representation. Darts 2i and 2i + 1 are the two directions of edge i; around its origin a dart
/// has a counter-clockwise and a clockwise neighbour. Faces are implicit: `along` walks around the
/// face on the left. New vertices and edges have the greatest numbers, and taking back the last
/// expansion is exact.
///
/// The expansions are P0, P1 and P3 of [BrinkmannGreenbergGreenhillMcKayThomasWollan2005]; see
/// docs/theory/proofs/quadrangulation-generation.md for figures in words.

#include <array>
#include <cstdint>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::quads {

using complex::Dart;
using complex::Vertex;

[[nodiscard]] constexpr Dart twin(Dart d) noexcept { return static_cast<Dart>(d ^ 1U); }

struct PlanarMap {
  int vertices = 0;
  int darts = 0;  ///< four per quad
  std::array<Vertex, complex::kMaxDarts> origin{};
  std::array<Dart, complex::kMaxDarts> ccw{};
  std::array<Dart, complex::kMaxDarts> cw{};
  std::array<std::uint8_t, complex::kMaxVertices> degree{};
  std::array<Dart, complex::kMaxVertices> first{};  ///< some dart of the vertex

  [[nodiscard]] int quads() const noexcept { return darts / 4; }
  [[nodiscard]] Vertex head(Dart d) const noexcept { return origin[twin(d)]; }
  /// The next dart of the face on the left.
  [[nodiscard]] Dart along(Dart d) const noexcept { return cw[twin(d)]; }
  /// The dart at the opposite corner of the quad on the left.
  [[nodiscard]] Dart across(Dart d) const noexcept { return along(along(d)); }

  /// P0: a vertex of degree 2 in the quad left of p, joined to origin(p) and the opposite corner.
  /// Returns the dart from the new vertex to origin(p).
  Dart expand_p0(Dart p) noexcept {
    const Dart q = across(p);
    const Vertex x = new_vertex(2);
    const Dart s = new_edge();
    const Dart t = new_edge();
    insert_after(p, twin(s));
    insert_after(q, twin(t));
    origin[s] = origin[t] = x;
    ccw[s] = cw[s] = t;
    ccw[t] = cw[t] = s;
    first[x] = s;
    return s;
  }
  /// Takes back the last expansion, which was P0.
  void reduce_p0() noexcept {
    remove(static_cast<Dart>(darts - 1));
    remove(static_cast<Dart>(darts - 3));
    darts -= 4;
    --vertices;
  }

  /// P1: the edge of h, from c to e, is taken off c, and its free end becomes a vertex a of
  /// degree 3 joined to the neighbours b, d of c on both sides of h. Then h runs from a to e,
  /// ccw(h) from a to b, cw(h) from a to d, and (a, b, c, d) is a quad. Returns first[c] as it was.
  Dart expand_p1(Dart h) noexcept {
    const Dart to_b = ccw[h];
    const Dart to_d = cw[h];
    const Dart first_of_c = first[origin[h]];
    remove(h);
    first[origin[h]] = to_b;
    const Vertex a = new_vertex(3);
    const Dart x = new_edge();
    const Dart y = new_edge();
    insert_after(twin(to_b), twin(x));
    insert_before(twin(to_d), twin(y));
    origin[h] = origin[x] = origin[y] = a;
    ccw[h] = cw[y] = x;
    ccw[x] = cw[h] = y;
    ccw[y] = cw[x] = h;
    first[a] = h;
    return first_of_c;
  }
  /// Takes back the last expansion, which was P1 at h and returned `first_of_c`.
  void reduce_p1(Dart h, Dart first_of_c) noexcept {
    const Dart to_b = twin(along(ccw[h]));
    remove(static_cast<Dart>(darts - 1));
    remove(static_cast<Dart>(darts - 3));
    darts -= 4;
    --vertices;
    insert_before(to_b, h);
    first[origin[h]] = first_of_c;
  }

  /// P3: a quad inside the quad left of p, corner joined to corner. Returns a dart of the new inner
  /// quad, with it on the left, from the corner that is joined to origin(p).
  Dart expand_p3(Dart p) noexcept {
    std::array<Dart, 4> ring{};
    std::array<Dart, 4> spoke{};
    const Dart inner = static_cast<Dart>(darts);
    for (std::size_t i = 0; i < 4; ++i) {
      ring[i] = new_edge();
      spoke[i] = new_edge();
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Dart next = along(p);
      const Vertex x = new_vertex(3);
      insert_after(p, twin(spoke[i]));
      const Dart back = twin(ring[(i + 3) % 4]);
      origin[spoke[i]] = origin[ring[i]] = origin[back] = x;
      ccw[spoke[i]] = cw[back] = ring[i];
      ccw[ring[i]] = cw[spoke[i]] = back;
      ccw[back] = cw[ring[i]] = spoke[i];
      first[x] = spoke[i];
      p = next;
    }
    return inner;
  }
  /// Takes back the last expansion, which was P3.
  void reduce_p3() noexcept {
    for (int edge = 1; edge <= 4; ++edge) remove(static_cast<Dart>(darts - 4 * edge + 3));
    darts -= 16;
    vertices -= 4;
  }

 private:
  Vertex new_vertex(std::uint8_t of_degree) noexcept {
    degree[static_cast<std::size_t>(vertices)] = of_degree;
    return static_cast<Vertex>(vertices++);
  }
  Dart new_edge() noexcept {
    darts += 2;
    return static_cast<Dart>(darts - 2);
  }
  void insert_after(Dart at, Dart d) noexcept { insert_between(at, d, ccw[at]); }
  void insert_before(Dart at, Dart d) noexcept { insert_between(cw[at], d, at); }
  void insert_between(Dart right, Dart d, Dart left) noexcept {
    ccw[right] = d;
    cw[d] = right;
    ccw[d] = left;
    cw[left] = d;
    origin[d] = origin[right];
    ++degree[origin[d]];
  }
  void remove(Dart d) noexcept {
    ccw[cw[d]] = ccw[d];
    cw[ccw[d]] = cw[d];
    --degree[origin[d]];
  }
};

/// The map of a valid quadrangulation; vertices keep their names.
[[nodiscard]] PlanarMap planar_map_of(const complex::Quadrangulation& q) noexcept;

/// The quadrangulation of a map; vertices keep their names, quads come in order of their least
/// dart.
[[nodiscard]] complex::Quadrangulation quadrangulation_of(const PlanarMap& map);

/// The 4-cycle with its two quads.
[[nodiscard]] PlanarMap four_cycle();

/// The pseudo-double wheel: a cycle whose vertices are joined by turns to a vertex inside and to a
/// vertex outside. The cube is the one with 6 quads. Requires an even number of quads, 6 or more.
[[nodiscard]] PlanarMap pseudo_double_wheel(int quads);

}  // namespace hexatlas::quads
