#include "enum/flips/facing.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <functional>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/complex/pair_set.hpp"
#include "enum/flips/pillow.hpp"
#include "enum/flips/zone.hpp"

namespace hexatlas::flips {
namespace {

using complex::Hexahedron;
using complex::VertexId;
using Dart = Peeling::Dart;

/// Of a layer: where one side bends outwards the other bends inwards, by about as much, and two
/// hexahedra share either angle.
constexpr int kParallel = 108, kLeastBend = 60;

/// Two quads, opposite each other in a hexahedron to be: side i of the one, counted from its dart
/// 0, faces that of the other which facing(i) gives.
struct FacingQuads {
  std::uint32_t left = 0;  ///< the quad
  Dart right_of_0 = 0;     ///< faces dart 0 of it

  [[nodiscard]] Dart side(unsigned i) const { return 4 * left + (i & 3U); }
  /// The other one is seen from the other side.
  [[nodiscard]] Dart facing(unsigned i) const {
    return (right_of_0 & ~3U) | ((right_of_0 - i) & 3U);
  }
};

/// What lies beyond two sides that face each other.
enum class Beyond : std::uint8_t {
  more,    ///< two quads that have to face each other as well
  end,     ///< nothing of this piece
  nothing  ///< that is allowed, so that there is no such piece
};
using BeyondSides = std::function<Beyond(Dart, Dart)>;

/// Sets that are emptied at no cost, for one zone after the other.
struct FacingMarks {
  Marks in_zone, is_right;
};

/// A piece: the quads beside a zone that face each other across it, those beyond them, and so on.
class Piece {
 public:
  Piece(const Peeling& peeling, FacingMarks& marks) : peeling_(peeling), marks_(marks) {}

  /// As far as `beyond` says. Those beside the zone come first. False if quads that have to do not
  /// face each other, or an end has the piece on both of its sides. Requires a zone that does not
  /// cross itself.
  bool find(std::span<const Dart> zone, const BeyondSides& beyond) {
    marks_.in_zone.clear();
    marks_.is_right.clear();
    for (const Dart in : zone) marks_.in_zone.add(in / 4);
    for (const Dart in : zone)
      if (!meet(peeling_.twin(rim(in, Side::left)), peeling_.twin(rim(in, Side::right))))
        return false;
    std::vector<std::uint32_t> outside;
    for (std::size_t seen = 0; seen < pairs_.size();) {
      const FacingQuads pair = pairs_[seen++];
      for (unsigned i = 0; i < 4; ++i) {
        const Dart a = pair.side(i), b = pair.facing(i);
        const bool is_at_zone = is_in_zone(peeling_.twin(a)) || is_in_zone(peeling_.twin(b));
        const Beyond what = is_at_zone ? Beyond::more : beyond(a, b);
        if (what == Beyond::nothing) return false;
        if (what == Beyond::more && !meet(peeling_.twin(a), peeling_.twin(b))) return false;
        if (what == Beyond::end)
          outside.insert(outside.end(), {peeling_.twin(a) / 4, peeling_.twin(b) / 4});
      }
    }
    has_end_ = !outside.empty();
    return std::none_of(outside.begin(), outside.end(), [&](std::uint32_t q) {
      return facing_.contains(q) || marks_.is_right.has(q);
    });
  }

  [[nodiscard]] const std::vector<FacingQuads>& pairs() const { return pairs_; }
  /// The pair that has this quad on the left.
  [[nodiscard]] std::optional<FacingQuads> pair_of(std::uint32_t left) const {
    const auto at = facing_.find(left);
    if (at == facing_.end()) return std::nullopt;
    return FacingQuads{left, at->second};
  }
  [[nodiscard]] bool has_end() const { return has_end_; }

 private:
  [[nodiscard]] bool is_in_zone(Dart d) const { return marks_.in_zone.has(d / 4); }

  /// Whether two edges may face each other, and so the quads that they belong to.
  bool meet(Dart a, Dart b) {
    if (is_in_zone(a) || is_in_zone(b)) return a / 4 == b / 4;
    if (a / 4 == b / 4) return false;
    FacingQuads pair{a / 4, b};
    pair.right_of_0 = pair.facing(4 - a % 4);
    const auto [at, is_new] = facing_.try_emplace(pair.left, pair.right_of_0);
    if (!is_new) return at->second == pair.right_of_0;
    if (facing_.contains(b / 4) || !marks_.is_right.add(b / 4) || marks_.is_right.has(pair.left))
      return false;
    pairs_.push_back(pair);
    return true;
  }

  const Peeling& peeling_;
  FacingMarks& marks_;
  std::unordered_map<std::uint32_t, Dart> facing_;  ///< of quads on the left: right_of_0
  std::vector<FacingQuads> pairs_;
  bool has_end_ = false;
};

std::vector<Hexahedron> hexahedra_between(const Peeling& peeling,
                                          const std::vector<FacingQuads>& pairs) {
  std::vector<Hexahedron> result;
  for (const FacingQuads& pair : pairs) {
    Hexahedron cell{};
    for (unsigned i = 0; i < 4; ++i) {
      cell[cells::kCornerOfPrism[i]] = peeling.origin(pair.side(i));
      cell[cells::kCornerOfPrism[4 + i]] = peeling.origin(Peeling::next(pair.facing(i)));
    }
    result.push_back(cell);
  }
  return result;
}

/// Whether what was taken off relates no two vertices of a hexahedron but those of quads.
bool fits(const Peeling& peeling, const std::vector<Hexahedron>& hexahedra) {
  complex::PairSet in_quads;
  for (const complex::BoundaryQuad& quad : peeling.cavity())
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < i; ++k) in_quads.insert(quad[k], quad[i]);
  for (const Hexahedron& cell : hexahedra)
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const VertexId a = cell[k], b = cell[i];
        if (a == b || (peeling.are_related(a, b) && !in_quads.has(a, b))) return false;
      }
  return true;
}

bool is_sharp_on_both_sides(Dart in, const Angles& angles) {
  return is_good(angles[rim(in, Side::left)], kLeastAtRim) &&
         is_good(angles[rim(in, Side::right)], kLeastAtRim);
}
bool is_sharp_on_both_sides(const Zone& zone, const Angles& angles) {
  return std::all_of(zone.begin(), zone.end(),
                     [&](Dart in) { return is_sharp_on_both_sides(in, angles); });
}

/// The longest runs of quads of a zone that are sharp on both sides, without those where not enough
/// is left of the cavity at an end. Requires that not all of the zone is sharp on both sides.
std::vector<Zone> sharp_runs(Zone zone, const Angles& angles) {
  const auto is_sharp = [&](Dart in) { return is_sharp_on_both_sides(in, angles); };
  std::rotate(zone.begin(), std::find_if_not(zone.begin(), zone.end(), is_sharp), zone.end());
  std::vector<Zone> result;
  for (auto at = zone.begin(); at != zone.end();) {
    const auto first = std::find_if(at, zone.end(), is_sharp);
    at = std::find_if_not(first, zone.end(), is_sharp);
    if (first == at) break;
    const int left = std::min(angles[*first], angles[Peeling::opposite(at[-1])]) - kRightAngle;
    if (left >= kLeastLeft) result.emplace_back(first, at);
  }
  return result;
}

/// Takes off the hexahedra between quads that face each other, from a zone inwards; and what is
/// known of the angles then. All or none.
class Overhang {
 public:
  Overhang(Peeling& peeling, Angles& angles, const Piece& piece)
      : peeling_(peeling), angles_(angles), piece_(piece) {}

  bool take() {
    const Angles before = angles_;
    const std::uint32_t first_wall = peeling_.quad_numbers();
    std::deque<std::uint32_t> open;
    for (const FacingQuads& pair : piece_.pairs()) open.push_back(pair.left);
    std::size_t taken = 0;
    while (!open.empty()) {
      const auto pair = piece_.pair_of(open.front());
      open.pop_front();
      if (!pair || !peeling_.is_live(pair->left)) continue;
      std::array<std::uint32_t, 4> beside{};
      for (unsigned i = 0; i < 4; ++i) beside[i] = peeling_.twin(pair->side(i)) / 4;
      if (!take(*pair)) continue;  // comes up again when one beside it is taken
      ++taken;
      open.insert(open.end(), beside.begin(), beside.end());
    }
    if (taken < piece_.pairs().size()) {
      for (; taken > 0; --taken) peeling_.put_back();
      angles_ = before;
      return false;
    }
    finish_walls(first_wall);
    return true;
  }

 private:
  /// The quad that is a side of the hexahedron already, if there is one.
  [[nodiscard]] std::optional<std::uint32_t> wall(const FacingQuads& pair, unsigned i) const {
    const Dart above = peeling_.twin(pair.side(i)), below = peeling_.twin(pair.facing(i));
    if (Peeling::opposite(above) != below) return std::nullopt;
    return above / 4;
  }

  /// From a wall that has none opposite, with all that is there.
  [[nodiscard]] std::optional<Peeling::Patch> patch_of(const FacingQuads& pair) const {
    std::vector<std::uint32_t> there{pair.left, pair.facing(0) / 4};
    std::optional<std::uint32_t> bottom;
    for (unsigned i = 0; i < 4; ++i) {
      const auto here = wall(pair, i);
      if (!here) continue;
      there.push_back(*here);
      if (!wall(pair, i + 2)) bottom = here;
    }
    if (!bottom) return std::nullopt;
    Peeling::Patch patch{*bottom, 0};
    for (unsigned i = 0; i < 4; ++i)
      if (std::find(there.begin(), there.end(), peeling_.twin(4 * *bottom + i) / 4) != there.end())
        patch.sides = static_cast<std::uint8_t>(patch.sides | 1U << i);
    return patch;
  }

  bool take(const FacingQuads& pair) {
    const auto patch = patch_of(pair);
    Peeling::Prism prism;
    if (!patch || !peeling_.may_take(*patch, prism)) return false;
    std::vector<std::pair<Dart, std::int16_t>> beyond;  // of sides that come up, the angle there
    const auto comes_up_at = [&](Dart d) {
      if (angles_[d] != kUnknown)
        beyond.emplace_back(peeling_.twin(d), less_a_right_angle(angles_[d]));
    };
    for (unsigned i = 0; i < 4; ++i) {
      ++quads_at_[peeling_.origin(pair.side(i))];
      ++quads_at_[peeling_.origin(pair.facing(i))];
      if (wall(pair, i)) continue;
      comes_up_at(pair.side(i));
      comes_up_at(pair.facing(i));
      // Walls beside it have an edge in common with it.
      if (wall(pair, i + 3)) comes_up_at(Peeling::prev(peeling_.twin(pair.side(i + 3))));
      if (wall(pair, i + 1)) comes_up_at(Peeling::next(peeling_.twin(pair.side(i + 1))));
    }
    peeling_.take(*patch, prism);
    angles_.resize(4 * std::size_t{peeling_.quad_numbers()}, kUnknown);
    for (const auto& [d, angle] : beyond) angles_[d] = angles_[peeling_.twin(d)] = angle;
    return true;
  }

  /// Between two walls that have come up there is what the hexahedra at that edge have left of a
  /// full turn.
  void finish_walls(std::uint32_t first_wall) {
    for (Dart d = 4 * first_wall; d < angles_.size(); ++d)
      if (peeling_.is_live(d / 4) && angles_[d] == kUnknown)
        angles_[d] = angles_[peeling_.twin(d)] = static_cast<std::int16_t>(
            std::max(kLeastLeft, kFullTurn - kRightAngle * quads_at_[peeling_.origin(d)]));
  }

  static constexpr std::int16_t kUnknown = std::numeric_limits<std::int16_t>::min();
  Peeling& peeling_;
  Angles& angles_;
  const Piece& piece_;
  std::unordered_map<VertexId, int> quads_at_;  ///< of pairs taken
};

}  // namespace

std::optional<std::vector<Hexahedron>> single_layer(const Peeling& peeling, const Angles& angles) {
  expect_one_each(peeling, angles);
  std::optional<std::vector<Hexahedron>> best;
  Marks crossed;
  FacingMarks marks;
  for_each_zone(peeling, [&](const Zone& zone) {
    const std::size_t hexahedra = (peeling.quads() - zone.size()) / 2;
    if (best && best->size() <= hexahedra) return;
    if (!is_sharp_on_both_sides(zone, angles) || crossings_of(zone, crossed) > 0) return;
    Piece piece(peeling, marks);
    const bool is_found = piece.find(zone, [&](Dart a, Dart b) {
      const bool is_parallel = std::abs(angles[a] + angles[b] - kFullTurn) <= kParallel;
      const bool is_bent = std::min(angles[a], angles[b]) < kLeastBend;
      return is_parallel && !is_bent ? Beyond::more : Beyond::nothing;
    });
    if (!is_found || piece.pairs().size() != hexahedra ||
        2 * hexahedra + zone.size() != peeling.quads())
      return;
    std::vector<Hexahedron> found = hexahedra_between(peeling, piece.pairs());
    if (fits(peeling, found)) best = std::move(found);
  });
  return best;
}

bool take_overhangs(Peeling& peeling, Angles& angles, Extent extent) {
  expect_one_each(peeling, angles);
  Marks crossed;
  FacingMarks marks;
  const auto take = [&](std::span<const Dart> zone) {
    Piece piece(peeling, marks);
    const bool is_found = piece.find(zone, [&](Dart a, Dart b) {
      if (is_good_fold(angles[a]) && is_good_fold(angles[b])) return Beyond::more;
      const bool is_left = std::min(angles[a], angles[b]) - kRightAngle >= kLeastLeft;
      return is_left ? Beyond::end : Beyond::nothing;
    });
    return is_found && piece.has_end() && Overhang(peeling, angles, piece).take();
  };
  std::vector<Zone> zones;
  for_each_zone(peeling, [&](const Zone& zone) {
    if (extent == Extent::any || is_sharp_on_both_sides(zone, angles)) zones.push_back(zone);
  });
  const auto take_one = [&](const Zone& zone) {
    if (zone.empty() || crossings_of(zone, crossed) > 0) return false;
    if (is_sharp_on_both_sides(zone, angles)) return take(zone);
    if (extent == Extent::all_around) return false;
    const std::vector<Zone> runs = sharp_runs(zone, angles);
    return std::any_of(runs.begin(), runs.end(), take);
  };
  bool is_any = false;
  for (const Zone& zone : zones)
    while (take_one(what_is_left_of(zone, peeling))) is_any = true;
  return is_any;
}

}  // namespace hexatlas::flips
