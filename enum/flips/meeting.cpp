#include "enum/flips/meeting.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "enum/core/checks.hpp"

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

void mirror(Hexahedron& cell) noexcept {
  std::swap(cell[1], cell[2]);
  std::swap(cell[5], cell[6]);
}

/// Renumbers the vertices: those listed in `first` get 0, 1, ...; the others follow in the order of
/// the cells.
complex::HexComplex renumbered(std::vector<Hexahedron> cells, std::uint32_t vertices,
                               const std::vector<std::uint32_t>& first) {
  constexpr std::uint32_t kUnset = 0xFFFFFFFF;
  std::vector<std::uint32_t> number(vertices, kUnset);
  std::uint32_t next = 0;
  for (const std::uint32_t v : first) number[v] = next++;
  for (Hexahedron& cell : cells)
    for (std::uint32_t& v : cell) {
      if (number[v] == kUnset) number[v] = next++;
      v = number[v];
    }
  return {next, std::move(cells)};
}

struct Meeting {
  FrontId ball;
  FrontId collar;
  Automorphism turn;
  int hexahedra = 0;
};

/// Looks the cavities of one level of collars up among the balls.
class Matcher {
 public:
  Matcher(const Beam& balls, int below) : balls_(balls), below_(below) {}

  void match(const Beam& collars, FrontId collar) {
    const State cavity = collars.state(collar);
    Fillings& known = fillings(cavity.code);
    for (const FrontRecord& ball : known.balls) {
      const int hexahedra = collars.level_of(collar) + ball.level + 1;
      if (hexahedra >= below_) return;  // balls come in order of level
      for (const Automorphism& turn : known.automorphisms)
        if (ball.scars.renamed(turn.label).is_disjoint_from(cavity.scars)) {
          best_ = Meeting{ball.id, collar, turn, hexahedra};
          below_ = hexahedra;
          return;
        }
    }
  }
  [[nodiscard]] const std::optional<Meeting>& best() const noexcept { return best_; }
  [[nodiscard]] int below() const noexcept { return below_; }

 private:
  struct Fillings {
    std::vector<FrontRecord> balls;
    std::vector<Automorphism> automorphisms;
  };
  Fillings& fillings(const canon::Code& code) {
    const auto [place, is_new] = known_.try_emplace(code);
    if (is_new) {
      place->second.balls = balls_.fronts_of(code);
      if (!place->second.balls.empty()) place->second.automorphisms = automorphisms_of(code);
    }
    return place->second;
  }

  const Beam& balls_;
  int below_;
  std::optional<Meeting> best_;
  std::unordered_map<canon::Code, Fillings> known_;
};

Filling assemble(const Beam& balls, const Beam& collars, const Meeting& meeting) {
  const Layers collar = layers_along(collars, meeting.collar, Growth::inward);
  Layers ball = layers_along(balls, meeting.ball, Growth::outward);
  // Rim vertex v of the ball is rim vertex turn(v) of the collar.
  constexpr std::uint32_t kInterior = 0xFFFFFFFF;
  std::vector<std::uint32_t> number(ball.vertices, kInterior);
  for (std::size_t v = 0; v < ball.rim.size(); ++v)
    number[ball.rim[v]] = collar.rim[meeting.turn.label[v]];
  std::uint32_t vertices = collar.vertices;
  for (std::uint32_t& n : number)
    if (n == kInterior) n = vertices++;
  const bool turned = (ball.is_mirrored != collar.is_mirrored) != meeting.turn.is_mirrored;
  std::vector<Hexahedron> cells = collar.hexahedra;
  std::reverse(ball.hexahedra.begin(), ball.hexahedra.end());  // the last one is taken off first
  for (Hexahedron moved : ball.hexahedra) {
    for (std::uint32_t& v : moved) v = number[v];
    if (turned) mirror(moved);
    cells.push_back(moved);
  }
  const auto path = collars.path_to(meeting.collar);
  const State start = collars.state(path.empty() ? meeting.collar : path.front().from);
  std::vector<std::uint32_t> boundary(static_cast<std::size_t>(start.code.quads) + 2);
  std::iota(boundary.begin(), boundary.end(), 0U);
  return {renumbered(std::move(cells), vertices, boundary)};
}

}  // namespace

Filling filling_of(const Beam& balls, FrontId id) {
  Layers layers = layers_along(balls, id, Growth::outward);
  if (layers.is_mirrored)
    for (Hexahedron& cell : layers.hexahedra) mirror(cell);
  std::reverse(layers.hexahedra.begin(), layers.hexahedra.end());
  return {renumbered(std::move(layers.hexahedra), layers.vertices, layers.rim)};
}

std::optional<Filling> best_meeting(const Beam& balls, const canon::Code& target,
                                    const MeetingOptions& options) {
  Beam collars(State{target, {}}, options.collars);
  Matcher matcher(balls, options.below);
  std::size_t size = 1;
  for (int depth = 0; depth <= options.max_collar && size > 0; ++depth) {
    if (depth > 0) size = collars.expand_level();
    if (depth + 1 >= matcher.below()) break;
    for (const FrontId collar : collars.frontier()) matcher.match(collars, collar);
  }
  if (!matcher.best()) return std::nullopt;
  return assemble(balls, collars, *matcher.best());
}

}  // namespace hexatlas::flips
