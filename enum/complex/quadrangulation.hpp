#pragma once
/// \file
/// Quadrangulations of the sphere with at most 64 quads, in the fixed-capacity form that
/// searches copy and change.
///
/// Representation. Quad q has the darts 4q .. 4q+3, counter-clockwise seen from outside; dart
/// d runs from origin(d) to origin(next(d)) and has its quad on the left. twin(d) is the other
/// dart of the same edge. Everything else is derived. Vertices are numbered 0 .. vertices()-1.
///
/// Laws (validate()): twin is an involution without fixed points that reverses edges; the darts
/// around a vertex form one circle; the surface is connected; Euler characteristic 2. Multiple
/// edges and vertices of degree 1 or 2 are allowed: a cell decomposition of the sphere, not
/// necessarily a simple graph.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/complex/broken_law.hpp"

namespace hexatlas::complex {

inline constexpr int kMaxQuads = 64;
inline constexpr int kMaxVertices = kMaxQuads + 2;  ///< Euler: n quads, 2n edges, n + 2 vertices
inline constexpr int kMaxDarts = 4 * kMaxQuads;

using Vertex = std::uint8_t;  ///< in [0, kMaxVertices)
using Dart = std::uint8_t;    ///< in [0, kMaxDarts)
using Quad = std::uint8_t;    ///< in [0, kMaxQuads)
using QuadVertices = std::array<Vertex, 4>;

class Quadrangulation {
 public:
  /// The quadrangulation with these quads, or nullopt if they break a law; broken_law() says
  /// which. Vertices must be 0 .. quads.size()+1. Edges are matched by their ends, so the
  /// graph must be simple. Cost: linear.
  [[nodiscard]] static std::optional<Quadrangulation> from_quads(
      std::span<const QuadVertices> quads);

  /// The quadrangulation with given darts; multiple edges are possible. Requires spans of equal
  /// length, a multiple of 4, at most kMaxDarts. The caller answers for the laws; see validate().
  [[nodiscard]] static Quadrangulation from_darts(std::span<const Vertex> origin,
                                                  std::span<const Dart> twin, int vertices);

  /// The surface of the reference cube, vertices and quads as in enum/cells/cube.hpp.
  [[nodiscard]] static Quadrangulation cube();

  [[nodiscard]] int quads() const noexcept { return quads_; }
  [[nodiscard]] int vertices() const noexcept { return vertices_; }
  [[nodiscard]] int darts() const noexcept { return 4 * quads_; }

  [[nodiscard]] Vertex origin(Dart d) const noexcept { return origin_[d]; }
  [[nodiscard]] Dart twin(Dart d) const noexcept { return twin_[d]; }
  [[nodiscard]] static constexpr Dart next(Dart d) noexcept {
    return static_cast<Dart>((d & ~3U) | ((d + 1U) & 3U));
  }
  [[nodiscard]] static constexpr Dart prev(Dart d) noexcept {
    return static_cast<Dart>((d & ~3U) | ((d + 3U) & 3U));
  }
  /// The dart at the opposite corner of the same quad.
  [[nodiscard]] static constexpr Dart opposite(Dart d) noexcept {
    return static_cast<Dart>(d ^ 2U);
  }
  [[nodiscard]] static constexpr Quad quad_of(Dart d) noexcept {
    return static_cast<Quad>(d >> 2U);
  }
  [[nodiscard]] static constexpr Dart dart(int quad, int side) noexcept {
    return static_cast<Dart>(4 * quad + side);
  }
  /// The next dart with the same origin, counter-clockwise; and clockwise.
  [[nodiscard]] Dart turn_left(Dart d) const noexcept { return twin_[prev(d)]; }
  [[nodiscard]] Dart turn_right(Dart d) const noexcept { return next(twin_[d]); }

  [[nodiscard]] QuadVertices vertices_of(int quad) const noexcept {
    const auto d = static_cast<std::size_t>(4 * quad);
    return {origin_[d], origin_[d + 1], origin_[d + 2], origin_[d + 3]};
  }
  [[nodiscard]] std::vector<QuadVertices> list_of_quads() const;
  [[nodiscard]] std::array<std::uint8_t, kMaxVertices> degrees() const noexcept;
  /// The sum over the vertices of (degree - 4)^2. Of a 3-connected quadrangulation with n quads it
  /// is at most 2 (n / 2 - 4)^2 + n, that of a trapezohedron (docs/theory/proofs/irregularity.md).
  [[nodiscard]] int irregularity() const noexcept;
  /// How many zones do not cross themselves. A zone is the quads that a closed curve crosses which
  /// leaves each quad at the side opposite to where it came in; it crosses itself at a quad that it
  /// passes both ways. Requires that the laws hold. Cost: linear.
  [[nodiscard]] int simple_zones() const noexcept;

  /// The first broken law, if any. Cost: linear.
  [[nodiscard]] std::optional<BrokenLaw> validate() const;

  /// Whether no two quads share two opposite vertices of one of them, no two edges have the
  /// same ends, and there are at least 6 quads. For a valid quadrangulation of the sphere this
  /// is 3-connectedness (docs/theory/proofs/three-connected.md) and necessary for a boundary
  /// under the strict rule. Cost: linear.
  [[nodiscard]] bool is_three_connected() const noexcept;

  friend bool operator==(const Quadrangulation& a, const Quadrangulation& b) noexcept;

  /// For the flips, which rewire darts: raw access. The laws are the caller's to keep.
  struct Editor;

 private:
  std::uint8_t quads_ = 0;
  std::uint8_t vertices_ = 0;
  std::array<Vertex, kMaxDarts> origin_{};
  std::array<Dart, kMaxDarts> twin_{};
};

struct Quadrangulation::Editor {
  Quadrangulation& q;
  void set_size(int quads, int vertices) const noexcept {
    q.quads_ = static_cast<std::uint8_t>(quads);
    q.vertices_ = static_cast<std::uint8_t>(vertices);
  }
  void set_origin(Dart d, Vertex v) const noexcept { q.origin_[d] = v; }
  void link(Dart d, Dart e) const noexcept {
    q.twin_[d] = e;
    q.twin_[e] = d;
  }
};

/// The first law that keeps these quads from being a simple quadrangulation of the sphere with
/// vertices 0 .. quads.size()+1.
[[nodiscard]] std::optional<BrokenLaw> broken_law(std::span<const QuadVertices> quads);

}  // namespace hexatlas::complex
