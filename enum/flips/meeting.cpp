#include "enum/flips/meeting.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

using complex::Hexahedron;

/// Labels of the same canonical list, one per automorphism: label[v] is the image of v.
struct Automorphism {
  canon::Labelling label{};
  bool is_mirrored = false;
};

std::vector<Automorphism> automorphisms_of(const canon::Code& code) {
  const auto q = canon::decode(code).value();
  canon::CanonicalFlags flags;
  canon::canonical_flags(q, flags);
  std::vector<Automorphism> result;
  for (int i = 0; i < flags.count; ++i) {
    const canon::Flag flag = flags.flags[static_cast<std::size_t>(i)];
    result.push_back({canon::labelling_from(q, flag), flag.mirrored});
  }
  return result;
}

struct Meeting {
  canon::Code boundary;
  std::size_t ball = 0;  ///< its place among those of the boundary
  FrontId collar;
  Automorphism turn;
  int hexahedra = 0;
};

/// The balls of one class, in every position that the symmetries of their boundary allow.
struct Fillings {
  struct Position {
    Scars scars;
    std::uint32_t ball = 0;  ///< index into `balls`
    std::uint32_t turn = 0;  ///< index into `automorphisms`
  };
  std::vector<KnownBall> balls;
  std::vector<Automorphism> automorphisms;
  std::vector<Position> positions;  ///< in order of level
};

/// Looks the cavities of one level of collars up among the balls.
class Matcher {
 public:
  Matcher(const BallSource& balls, int below, int threads)
      : balls_(balls), below_(below), threads_(threads) {}

  /// Keeps the least meeting; of equal ones that of the first collar and its first position.
  void match_level(const Beam& collars) {
    const auto frontier = collars.frontier();
    for (const FrontId collar : frontier)
      add_class(collars.state(collar).code, collars.level_of(collar));
    constexpr std::size_t kCollarsPerChunk = 512;
    std::vector<std::optional<Meeting>> found((frontier.size() + kCollarsPerChunk - 1) /
                                              kCollarsPerChunk);
    parallel::parallel_for(threads_, found.size(), [&](std::size_t c) {
      const std::size_t begin = c * kCollarsPerChunk;
      const std::size_t count = std::min(kCollarsPerChunk, frontier.size() - begin);
      int below = below_;
      for (const FrontId collar : frontier.subspan(begin, count))
        if (const auto meeting = match(collars, collar, below)) {
          found[c] = meeting;
          below = meeting->hexahedra;
        }
    });
    for (const auto& meeting : found)
      if (meeting && meeting->hexahedra < below_) {
        best_ = meeting;
        below_ = meeting->hexahedra;
      }
  }
  [[nodiscard]] const std::optional<Meeting>& best() const noexcept { return best_; }
  [[nodiscard]] int below() const noexcept { return below_; }

 private:
  /// Where collars of so many hexahedra may meet a ball. Most classes have none, and leave nothing.
  void add_class(const canon::Code& code, int collar) {
    const auto least = balls_.least_with(code);
    if (!least || collar + *least >= below_) return;
    const auto [place, is_new] = known_.try_emplace(code);
    if (!is_new) return;
    Fillings& own = place->second;
    own.balls = balls_.balls_with(code);
    own.automorphisms = automorphisms_of(code);
    for (std::uint32_t ball = 0; ball < own.balls.size(); ++ball)
      for (std::uint32_t turn = 0; turn < own.automorphisms.size(); ++turn)
        own.positions.push_back(
            {own.balls[ball].scars.renamed(own.automorphisms[turn].label), ball, turn});
  }
  [[nodiscard]] std::optional<Meeting> match(const Beam& collars, FrontId collar, int below) const {
    const State cavity = collars.state(collar);
    const auto known = known_.find(cavity.code);
    if (known == known_.end()) return std::nullopt;
    const Fillings& own = known->second;
    for (const Fillings::Position& position : own.positions) {
      const int hexahedra = collars.level_of(collar) + own.balls[position.ball].hexahedra;
      if (hexahedra >= below) return std::nullopt;
      if (position.scars.is_disjoint_from(cavity.scars))
        return Meeting{cavity.code, position.ball, collar, own.automorphisms[position.turn],
                       hexahedra};
    }
    return std::nullopt;
  }

  const BallSource& balls_;
  int below_;
  int threads_;
  std::optional<Meeting> best_;
  std::unordered_map<canon::Code, Fillings> known_;
};

Filling assemble(const BallSource& balls, const Beam& collars, const Meeting& meeting) {
  const Layers collar = layers_along(collars, meeting.collar, Growth::inward);
  complex::HexComplex mesh{collar.vertices, collar.hexahedra};
  // Rim vertex v of the ball is rim vertex turn(v) of the collar.
  std::vector<complex::VertexId> rim(collar.rim.size());
  for (std::size_t v = 0; v < rim.size(); ++v) rim[v] = collar.rim[meeting.turn.label[v]];
  append_ball(mesh, balls.layers_of(meeting.boundary, meeting.ball), rim,
              collar.is_mirrored != meeting.turn.is_mirrored);
  const auto path = collars.path_to(meeting.collar);
  const State start = collars.state(path.empty() ? meeting.collar : path.front().from);
  return {complex::compacted(std::move(mesh), start.code.quads + 2)};
}

}  // namespace

Filling filling_of(const Beam& balls, FrontId id) {
  Layers layers = layers_along(balls, id, Growth::outward);
  if (layers.is_mirrored)
    for (Hexahedron& cell : layers.hexahedra) cells::exchange_axes(cell);
  std::reverse(layers.hexahedra.begin(), layers.hexahedra.end());
  return {complex::renumbered({layers.vertices, std::move(layers.hexahedra)}, layers.rim)};
}

std::optional<int> BeamBalls::least_with(const canon::Code& boundary) const {
  const auto level = beam_.first_level(boundary);
  if (!level) return std::nullopt;
  return *level + 1;
}

std::vector<KnownBall> BeamBalls::balls_with(const canon::Code& boundary) const {
  std::vector<KnownBall> result;
  for (const FrontRecord& front : beam_.fronts_of(boundary))
    result.push_back({front.level + 1, front.scars});
  return result;
}

Layers BeamBalls::layers_of(const canon::Code& boundary, std::size_t ball) const {
  return layers_along(beam_, beam_.fronts_of(boundary)[ball].id, Growth::outward);
}

Scars scars_of(const complex::HexComplex& mesh, const complex::Quadrangulation& boundary) {
  const auto on_boundary = static_cast<std::uint32_t>(boundary.vertices());
  Relation related{};
  for (const Hexahedron& cell : mesh.hexahedra)
    for (const std::uint32_t a : cell)
      for (const std::uint32_t b : cell)
        if (a < on_boundary && b < on_boundary) related[a] |= bit(static_cast<complex::Vertex>(b));
  canon::Labelling same{};
  std::iota(same.begin(), same.end(), complex::Vertex{0});
  return scars_of(related, relation_of_quads(boundary), boundary.vertices(), same);
}

std::optional<Filling> best_meeting(const BallSource& balls, const canon::Code& target,
                                    const MeetingOptions& options) {
  const auto boundary = canon::decode(target);
  core::expects(boundary && boundary->is_three_connected(),
                "only a 3-connected boundary has a filling");
  Beam collars(State{target, options.apart}, options.collars);
  Matcher matcher(balls, options.below, options.collars.threads);
  std::size_t size = 1;
  for (int depth = 0; depth <= options.max_collar && size > 0; ++depth) {
    if (depth > 0) size = collars.expand_level();
    if (depth + 1 >= matcher.below() || (options.first && matcher.best())) break;
    matcher.match_level(collars);
  }
  if (!matcher.best()) return std::nullopt;
  return assemble(balls, collars, *matcher.best());
}

}  // namespace hexatlas::flips
