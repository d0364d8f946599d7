#pragma once
/// \file
/// 3-connected quadrangulations of any size, for the tests of meshers: random ones, all
/// small ones, and two kinds that are regular.
///
/// Random ones grow from the cube by two steps that keep them 3-connected, that is, without double
/// edges and without two quads that share two opposite vertices. A quad is replaced by a smaller
/// one and four around it. A vertex v is split along its edges to a and b, which are opposite in no
/// quad and not consecutive around v, nor from the other side: then both halves have three edges or
/// more, and between them lies a new quad v a w b.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "enum/complex/quad_surface.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/core/random.hpp"
#include "enum/quads/generate.hpp"

namespace hexatlas::support {

using complex::BoundaryQuad;
using complex::VertexId;

inline complex::QuadSphere sphere_of(const std::vector<BoundaryQuad>& quads, std::size_t points) {
  auto found = complex::sphere_of(quads, points);
  if (const auto* law = std::get_if<complex::BrokenLaw>(&found))
    throw std::logic_error("the quads of a test are no sphere: " + law->reason);
  return std::get<complex::QuadSphere>(std::move(found));
}

inline complex::QuadSphere sphere_of(const std::vector<BoundaryQuad>& quads) {
  return sphere_of(quads, quads.size() + 2);
}

inline complex::QuadSphere sphere_of(const complex::Quadrangulation& small) {
  std::vector<BoundaryQuad> quads;
  for (const auto& quad : small.list_of_quads())
    quads.push_back({quad[0], quad[1], quad[2], quad[3]});
  return sphere_of(quads);
}

class GrowingSphere {
 public:
  /// `inserted` of a hundred steps put a quad into a quad.
  GrowingSphere(std::uint64_t seed, std::size_t inserted) : random_(seed), inserted_(inserted) {
    for (const BoundaryQuad& quad :
         {BoundaryQuad{0, 3, 2, 1}, BoundaryQuad{4, 5, 6, 7}, BoundaryQuad{0, 1, 5, 4},
          BoundaryQuad{1, 2, 6, 5}, BoundaryQuad{2, 3, 7, 6}, BoundaryQuad{3, 0, 4, 7}})
      put(quads_.size(), quad);
  }
  [[nodiscard]] const std::vector<BoundaryQuad>& quads() const noexcept { return quads_; }

  /// One step that leaves at most `most` quads, or none if what was tried is not possible.
  void step(std::size_t most) {
    const std::size_t quad = random_.below(quads_.size());
    if (random_.below(100) < inserted_) {
      if (quads_.size() + 4 <= most) insert_into(quad);
    } else {
      split(quads_[quad][random_.below(4)], quad);
    }
  }

 private:
  using Pair = std::pair<VertexId, VertexId>;

  static std::array<Pair, 2> opposites(const BoundaryQuad& quad) {
    return {std::minmax(quad[0], quad[2]), std::minmax(quad[1], quad[3])};
  }
  void put(std::size_t place, const BoundaryQuad& quad) {
    if (place == quads_.size()) quads_.emplace_back();
    quads_[place] = quad;
    for (std::size_t i = 0; i < 4; ++i) left_of_[{quad[i], quad[(i + 1) % 4]}] = place;
    for (const Pair& pair : opposites(quad)) opposite_.insert(pair);
  }
  void take(std::size_t place) {
    const BoundaryQuad& quad = quads_[place];
    for (std::size_t i = 0; i < 4; ++i) left_of_.erase({quad[i], quad[(i + 1) % 4]});
    for (const Pair& pair : opposites(quad)) opposite_.erase(pair);
  }

  void insert_into(std::size_t place) {
    const BoundaryQuad outer = quads_[place];
    take(place);
    const BoundaryQuad inner{vertices_, vertices_ + 1, vertices_ + 2, vertices_ + 3};
    vertices_ += 4;
    put(place, inner);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      put(quads_.size(), {outer[i], outer[next], inner[next], inner[i]});
    }
  }

  /// The neighbours of v and the quads left of the edges to them, counter-clockwise.
  [[nodiscard]] std::vector<std::pair<VertexId, std::size_t>> around(VertexId v,
                                                                     std::size_t first) const {
    std::vector<std::pair<VertexId, std::size_t>> result;
    std::size_t place = first;
    do {
      const BoundaryQuad& quad = quads_[place];
      std::size_t at = 0;
      while (quad[at] != v) ++at;
      result.emplace_back(quad[(at + 1) % 4], place);
      place = left_of_.at({v, quad[(at + 3) % 4]});
    } while (place != first);
    return result;
  }

  void split(VertexId v, std::size_t place) {
    const auto ring = around(v, place);
    if (ring.size() < 4) return;
    const std::size_t from = random_.below(ring.size());
    const std::size_t moved = 2 + random_.below(ring.size() - 3);
    const VertexId a = ring[from].first;
    const VertexId b = ring[(from + moved) % ring.size()].first;
    if (opposite_.contains(std::minmax(a, b))) return;
    const VertexId w = vertices_++;
    for (std::size_t i = 0; i < moved; ++i) take(ring[(from + i) % ring.size()].second);
    for (std::size_t i = 0; i < moved; ++i) {
      const std::size_t quad = ring[(from + i) % ring.size()].second;
      BoundaryQuad renamed = quads_[quad];
      for (VertexId& u : renamed) u = u == v ? w : u;
      put(quad, renamed);
    }
    put(quads_.size(), {v, a, w, b});
  }

  core::Random random_;
  std::size_t inserted_;
  VertexId vertices_ = 8;
  std::vector<BoundaryQuad> quads_;
  std::map<Pair, std::size_t> left_of_;  ///< of each directed edge
  std::set<Pair> opposite_;
};

/// A random sphere of so many quads, 24 or more, the same for a seed. The more are inserted, the
/// more separating circles of four edges it has.
inline complex::QuadSphere random_sphere(std::size_t quads, std::uint64_t seed,
                                         std::size_t inserted = 30) {
  for (std::uint64_t attempt = 0; attempt < 20; ++attempt) {
    GrowingSphere sphere(seed + (attempt << 32U), inserted);
    for (std::size_t step = 0; step < 1000 * quads && sphere.quads().size() < quads; ++step)
      sphere.step(quads);
    if (sphere.quads().size() == quads) return sphere_of(sphere.quads());
  }
  throw std::logic_error("no random sphere of " + std::to_string(quads) + " quads");
}

/// The surface of a block of so many cubes along each axis.
inline complex::QuadSphere block(const std::array<VertexId, 3>& cubes) {
  std::map<std::array<VertexId, 3>, VertexId> number;
  const auto vertex = [&](const std::array<VertexId, 3>& place) {
    return number.try_emplace(place, static_cast<VertexId>(number.size())).first->second;
  };
  std::vector<BoundaryQuad> quads;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const VertexId side : {VertexId{0}, cubes[axis]})
      for (VertexId i = 0; i < cubes[(axis + 1) % 3]; ++i)
        for (VertexId j = 0; j < cubes[(axis + 2) % 3]; ++j) {
          BoundaryQuad quad{};
          for (std::size_t k = 0; k < 4; ++k) {
            std::array<VertexId, 3> place{};
            place[axis] = side;
            place[(axis + 1) % 3] = i + (k == 1 || k == 2 ? 1 : 0);
            place[(axis + 2) % 3] = j + (k >= 2 ? 1 : 0);
            quad[k] = vertex(place);
          }
          if (side == 0) std::swap(quad[1], quad[3]);
          quads.push_back(quad);
        }
  return sphere_of(quads);
}

/// All 3-connected ones with so many quads.
inline std::vector<complex::QuadSphere> small_spheres(int quads) {
  std::vector<complex::QuadSphere> result;
  quads::generate(
      quads::Class::three_connected, quads,
      [&](const complex::Quadrangulation& q, int, int) { result.push_back(sphere_of(q)); });
  return result;
}

/// The surface of n x n x n cubes: 6 n^2 quads.
inline complex::QuadSphere grid_cube(VertexId n) { return block({n, n, n}); }

/// The trapezohedron with two vertices of degree k: 2k quads.
inline complex::QuadSphere trapezohedron(VertexId k) {
  std::vector<BoundaryQuad> quads;
  const VertexId ring = 2 * k;
  for (VertexId i = 0; i < ring; i += 2) {
    quads.push_back({ring, i, i + 1, (i + 2) % ring});
    quads.push_back({ring + 1, (i + 3) % ring, (i + 2) % ring, i + 1});
  }
  return sphere_of(quads);
}

/// The surface of a disc swept upwards: the disc is a sphere without its first quad, whose four
/// sides become walls. Vertices of level 0 are those of the sphere; the quads at the bottom come
/// first, then those at the top.
class Tower {
 public:
  Tower(const complex::QuadSphere& end, VertexId height)
      : end_(end.quads.begin() + 1, end.quads.end()),
        corner_(end.quads.front()),
        vertices_(static_cast<VertexId>(end.vertices())) {
    std::vector<BoundaryQuad> quads;
    for (auto [a, b, c, d] : end_) quads.push_back({a, d, c, b});
    for (const auto& [a, b, c, d] : end_)
      quads.push_back({at(a, height), at(b, height), at(c, height), at(d, height)});
    for (VertexId z = 0; z < height; ++z)
      for (std::size_t i = 0; i < 4; ++i) {
        const VertexId a = corner_[i], b = corner_[(i + 1) % 4];
        quads.push_back({at(a, z + 1), at(b, z + 1), at(b, z), at(a, z)});
      }
    sphere_ = sphere_of(quads, (height + 1) * std::size_t{vertices_});
  }
  [[nodiscard]] const complex::QuadSphere& sphere() const { return sphere_; }
  [[nodiscard]] std::size_t quads_of_end() const { return end_.size(); }
  [[nodiscard]] std::size_t vertices_of_end() const { return vertices_; }
  /// Of a vertex of the sphere, whose labels leave out those that are inside.
  [[nodiscard]] VertexId level(VertexId v) const { return sphere_.point_of[v] / vertices_; }
  [[nodiscard]] VertexId below(VertexId v) const { return sphere_.point_of[v] % vertices_; }
  [[nodiscard]] bool is_rim(std::uint32_t quad) const { return quad >= 2 * end_.size(); }
  [[nodiscard]] bool is_corner(VertexId below) const {
    return std::find(corner_.begin(), corner_.end(), below) != corner_.end();
  }
  [[nodiscard]] std::size_t quads_at_corner(VertexId v) const {
    std::size_t result = 0;
    for (const BoundaryQuad& quad : end_)
      for (const VertexId u : quad) result += u == v ? 1 : 0;
    return result;
  }

 private:
  [[nodiscard]] VertexId at(VertexId v, VertexId level) const { return level * vertices_ + v; }

  std::vector<BoundaryQuad> end_;
  BoundaryQuad corner_;
  VertexId vertices_;
  complex::QuadSphere sphere_;
};

}  // namespace hexatlas::support
