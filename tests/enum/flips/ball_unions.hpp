#pragma once
/// \file
/// Two balls laid against each other along patches of their boundaries, dart by dart, for the tests
/// of cuts; judged by sets.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::support {

using complex::Dart;
using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;
using flips::Beam;

/// A ball whose vertices 0 .. quads+1 are those of its boundary.
struct Ball {
  std::vector<oracle::Cell> cells;
  std::uint32_t vertices = 0;
  canon::Code code;
  Quadrangulation boundary;
  std::set<std::pair<std::uint32_t, std::uint32_t>> related;  ///< pairs of boundary vertices
};

inline Ball ball_of(const Beam& beam, flips::FrontId id) {
  const auto mesh = flips::filling_of(beam, id).mesh;
  const auto code = beam.state(id).code;
  Ball ball{{mesh.hexahedra.begin(), mesh.hexahedra.end()},
            mesh.vertices,
            code,
            canon::decode(code).value(),
            {}};
  const auto rim = static_cast<std::uint32_t>(ball.boundary.vertices());
  for (const auto& cell : ball.cells)
    for (const auto u : cell)
      for (const auto v : cell)
        if (u < rim && v < rim) ball.related.emplace(u, v);
  return ball;
}

inline std::vector<Ball> all_balls(const Beam& beam) {
  std::vector<Ball> balls;
  for (const auto& code : beam.codes())
    for (const auto& record : beam.fronts_of(code)) balls.push_back(ball_of(beam, record.id));
  return balls;
}

/// A patch of the boundary of one ball laid on that of another quad by quad; the second ball is
/// turned inside out (mirrored), or the patches see each other from their two sides.
class Match {
 public:
  Match(const Ball& a, const Ball& b, bool mirrored) : a_(a), b_(b), mirrored_(mirrored) {
    image_.fill(kNone);
    on_b_.fill(kNone);
    to_b_.fill(kNone);
    to_a_.fill(kNone);
  }

  /// Lays the quad of dart d on that of dart e. Says no, and changes nothing, if a quad is taken or
  /// vertices do not fit.
  bool add(Dart d, Dart e) {
    if (image_[d] != kNone || on_b_[e] != kNone) return false;
    std::array<std::pair<Dart, Dart>, 4> sides;
    for (auto& side : sides) {
      side = {d, e};
      d = Quadrangulation::next(d);
      e = mirrored_ ? Quadrangulation::next(e) : Quadrangulation::prev(e);
    }
    for (const auto& side : sides) {
      const auto [u, v] = ends(side);
      if ((to_b_[u] != kNone && to_b_[u] != v) || (to_a_[v] != kNone && to_a_[v] != u))
        return false;
    }
    for (const auto& side : sides) {
      image_[side.first] = side.second;
      on_b_[side.second] = side.first;
      const auto [u, v] = ends(side);
      to_b_[u] = v;
      to_a_[v] = u;
    }
    patch_.push_back(Quadrangulation::quad_of(d));
    return true;
  }
  /// Lays on the quad across dart d of the patch what lies across the image of d.
  bool extend(Dart d) {
    return add(a_.boundary.twin(d), b_.boundary.twin(static_cast<Dart>(image_[d])));
  }

  [[nodiscard]] const std::vector<int>& patch() const { return patch_; }

  /// Edges of the circle and vertices inside, if the patch is a disc; nullopt otherwise. It is
  /// connected by edges, so Euler's count decides.
  [[nodiscard]] std::optional<std::pair<int, int>> disc() const {
    std::set<int> vertices;
    int circle = 0;
    for (const int quad : patch_)
      for (int side = 0; side < 4; ++side) {
        const Dart d = Quadrangulation::dart(quad, side);
        vertices.insert(a_.boundary.origin(d));
        circle += image_[a_.boundary.twin(d)] == kNone ? 1 : 0;
      }
    const int quads = static_cast<int>(patch_.size());
    const int edges = (4 * quads + circle) / 2;
    if (static_cast<int>(vertices.size()) - edges + quads != 1) return std::nullopt;
    return std::pair(circle, static_cast<int>(vertices.size()) - circle);
  }

  /// No pair of vertices of the disc that lies in no quad of it is related in both.
  [[nodiscard]] bool may_be_glued() const {
    std::set<std::pair<int, int>> in_quad;
    std::set<int> vertices;
    for (const int quad : patch_)
      for (const Vertex u : a_.boundary.vertices_of(quad)) {
        vertices.insert(u);
        for (const Vertex v : a_.boundary.vertices_of(quad)) in_quad.emplace(u, v);
      }
    for (const int u : vertices)
      for (const int v : vertices)
        if (!in_quad.contains({u, v}) &&
            a_.related.contains({static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v)}) &&
            b_.related.contains(
                {to_b_[static_cast<std::size_t>(u)], to_b_[static_cast<std::size_t>(v)]}))
          return false;
    return true;
  }

  [[nodiscard]] std::vector<oracle::Cell> cells() const {
    std::vector<oracle::Cell> result = a_.cells;
    for (oracle::Cell cell : b_.cells) {
      for (auto& v : cell) v = glued(v);
      result.push_back(cell);
    }
    return result;
  }

  /// The quads of the union's boundary, by darts.
  [[nodiscard]] int boundary_quads() const {
    return a_.boundary.quads() + b_.boundary.quads() - 2 * static_cast<int>(patch_.size());
  }

  /// nullopt if two edges of it have the same ends.
  [[nodiscard]] std::optional<Quadrangulation> boundary() const {
    std::vector<QuadVertices> quads;
    std::map<std::uint32_t, Vertex> number;
    const auto add_quad = [&](const std::array<std::uint32_t, 4>& wide) {
      QuadVertices quad{};
      for (std::size_t i = 0; i < 4; ++i)
        quad[i] = number.try_emplace(wide[i], static_cast<Vertex>(number.size())).first->second;
      quads.push_back(quad);
    };
    for (int q = 0; q < a_.boundary.quads(); ++q) {
      const QuadVertices v = a_.boundary.vertices_of(q);
      if (image_[Quadrangulation::dart(q, 0)] == kNone) add_quad({v[0], v[1], v[2], v[3]});
    }
    for (int q = 0; q < b_.boundary.quads(); ++q) {
      QuadVertices v = b_.boundary.vertices_of(q);
      if (mirrored_) std::reverse(v.begin(), v.end());
      if (on_b_[Quadrangulation::dart(q, 0)] == kNone)
        add_quad({glued(v[0]), glued(v[1]), glued(v[2]), glued(v[3])});
    }
    return Quadrangulation::from_quads(quads);
  }

 private:
  static constexpr std::uint16_t kNone = 0xFFFF;

  /// The origin of a dart, and the vertex that it is laid on with its image.
  [[nodiscard]] std::pair<Vertex, Vertex> ends(std::pair<Dart, Dart> side) const {
    const auto [d, e] = side;
    return {a_.boundary.origin(d), b_.boundary.origin(mirrored_ ? e : Quadrangulation::next(e))};
  }
  [[nodiscard]] std::uint32_t glued(std::uint32_t v) const {
    return v < to_a_.size() && to_a_[v] != kNone ? to_a_[v] : a_.vertices + v;
  }

  const Ball& a_;
  const Ball& b_;
  bool mirrored_;
  std::array<std::uint16_t, complex::kMaxDarts> image_{}, on_b_{};
  std::array<std::uint16_t, complex::kMaxVertices> to_b_{}, to_a_{};
  std::vector<int> patch_;
};

/// Sets take two edges, or two quads, with the same vertices for one: then Euler's count is wrong,
/// or the boundary has fewer quads than the pushout's.
inline bool is_strict_union(const Match& match) {
  const auto cells = match.cells();
  return oracle::obeys_strict_rule(cells) && oracle::euler_characteristic(cells) == 1 &&
         static_cast<int>(oracle::boundary(cells).size()) == match.boundary_quads();
}

/// A patch of at most this many quads, grown at random on both boundaries at once; half of them
/// around a vertex first, since long strips are hardly ever glued.
inline Match random_match(const Ball& a, const Ball& b, std::size_t quads,
                          support::Random& random) {
  Match match(a, b, random.coin());
  const auto dart_on = [&](const Ball& ball) {
    return static_cast<Dart>(random.below(static_cast<std::size_t>(ball.boundary.darts())));
  };
  Dart d = dart_on(a);
  (void)match.add(d, dart_on(b));
  if (random.coin())
    while (match.patch().size() < quads && match.extend(Quadrangulation::prev(d)))
      d = a.boundary.turn_left(d);
  for (int attempt = 0; attempt < 30 && match.patch().size() < quads; ++attempt) {
    const int quad = match.patch()[random.below(match.patch().size())];
    (void)match.extend(Quadrangulation::dart(quad, static_cast<int>(random.below(4))));
  }
  return match;
}

/// All patches of at most so many quads: the darts to extend by, from the first quad on.
struct Patch {
  int first = 0;
  std::vector<Dart> across;
};
inline std::vector<Patch> patches_of(const Quadrangulation& q, std::size_t quads) {
  std::vector<Patch> result;
  std::map<std::set<int>, Patch> level;
  for (int i = 0; i < q.quads(); ++i) level[{i}] = {i, {}};
  for (std::size_t size = 1; size <= quads; ++size) {
    std::map<std::set<int>, Patch> next;
    for (const auto& [set, patch] : level) {
      result.push_back(patch);
      for (const int quad : set)
        for (int side = 0; side < 4; ++side) {
          const Dart d = Quadrangulation::dart(quad, side);
          auto larger = set;
          if (!larger.insert(Quadrangulation::quad_of(q.twin(d))).second) continue;
          Patch extended = patch;
          extended.across.push_back(d);
          next.emplace(std::move(larger), std::move(extended));
        }
    }
    level = std::move(next);
  }
  return result;
}

/// Calls `visit` with each match of two balls along a disc within the limits.
template <typename Visit>
void for_each_match(const std::vector<Ball>& balls, int max_circle, int max_interior,
                    const Visit& visit) {
  const auto most = static_cast<std::size_t>(max_circle / 2 - 1 + max_interior);
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (const Patch& patch : patches_of(balls[i].boundary, most))
      for (std::size_t j = i; j < balls.size(); ++j)
        for (int e = 0; e < 2 * balls[j].boundary.darts(); ++e) {
          Match match(balls[i], balls[j], e % 2 == 1);
          (void)match.add(Quadrangulation::dart(patch.first, 0), static_cast<Dart>(e / 2));
          const bool fits = std::all_of(patch.across.begin(), patch.across.end(),
                                        [&](Dart d) { return match.extend(d); });
          const auto disc = fits ? match.disc() : std::nullopt;
          if (disc && disc->first <= max_circle && disc->second <= max_interior) visit(match);
        }
}

}  // namespace hexatlas::support
