#include "enum/flips/sharp_zones.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/complex/pair_set.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/pillow.hpp"
#include "enum/flips/zone.hpp"

namespace hexatlas::flips {
namespace {

using complex::Hexahedron;
using complex::PairSet;
using complex::VertexId;
using Dart = Peeling::Dart;

/// How far an angle of a hexahedron may be from a right one: at the rim of a disc, where what is
/// nearly right goes first, and between quads of a zone, where another zone would have it as well.
constexpr float kRightAtRim = 0.3F, kSharpAtRim = 0.6F, kAlongZone = 0.85F;

constexpr bool is_good(float angle, float within) { return std::abs(angle - 1) <= within; }
/// Two hexahedra share it. At a sharp fold both would be thin for their whole length.
constexpr bool is_good_fold(float angle) { return angle >= 1.4F && angle <= 2.6F; }
constexpr float kLeastLeft = 0.5F;  ///< of the cavity, across a zone

/// The two sides of a zone.
enum class Side : std::uint8_t { left, right };

/// The side of a zone's quad at which the disc begins, by the dart at which the curve comes in.
Dart rim(Dart in, Side side) { return side == Side::left ? Peeling::prev(in) : Peeling::next(in); }

/// And the vertex of the edge between two quads of the zone.
VertexId rim_vertex(const Peeling& peeling, Dart in, Side side) {
  return peeling.origin(side == Side::left ? in : Peeling::next(in));
}

class SharpZones {
 public:
  SharpZones(Peeling& peeling, Angles& angles) : peeling_(peeling), angles_(angles) {}

  std::size_t run() {
    std::size_t removed = 0;
    for (const float within : {kRightAtRim, kSharpAtRim}) {
      within_ = within;
      for (std::size_t before = removed + 1; before != removed;) {
        before = removed;
        for (const Candidate& candidate : candidates())
          if (remove(candidate)) ++removed;
      }
    }
    return removed;
  }

 private:
  struct Candidate {
    double cost = 0;  ///< hexahedra per quad of the zone
    Zone zone;        ///< when it was found
    Side side{};
  };

  [[nodiscard]] std::vector<Candidate> candidates() {
    std::vector<Candidate> result;
    for_each_zone(peeling_, [&](const Zone& zone) {
      for (const Side side : {Side::left, Side::right}) {
        const std::size_t quads = sharp_disc(zone, side).size();
        if (quads > 0)
          result.push_back(
              {static_cast<double>(quads) / static_cast<double>(zone.size()), zone, side});
      }
    });
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return result;
  }

  bool remove(const Candidate& candidate) {
    const Zone zone = what_is_left_of(candidate.zone, peeling_);
    if (zone.empty()) return false;
    const std::vector<std::uint32_t> quads = sharp_disc(zone, candidate.side);
    return !quads.empty() && take(quads);
  }

  /// The quads of the disc on that side of a zone; empty if the zone is not sharp there.
  [[nodiscard]] std::vector<std::uint32_t> sharp_disc(const Zone& zone, Side side) {
    const bool ends_well = std::all_of(zone.begin(), zone.end(), [&](Dart in) {
      const Dart edge = rim(in, side);
      return is_good(angles_[edge], within_) && angles_[Peeling::opposite(edge)] - 1 >= kLeastLeft;
    });
    if (!ends_well || crossings_of(zone, marks_) > 0) return {};
    std::vector<std::uint32_t> quads;
    const auto reach = [&](Dart d) {
      if (marks_.add(d / 4)) quads.push_back(d / 4);
    };
    for (const Dart in : zone) reach(peeling_.twin(rim(in, side)));
    for (std::size_t seen = 0; seen < quads.size();) {
      const std::uint32_t q = quads[seen++];
      for (Dart d = 4 * q; d < 4 * q + 4; ++d) reach(peeling_.twin(d));
    }
    if (!is_good_inside(zone, side, quads)) quads.clear();
    return quads;
  }

  /// Two hexahedra share the angle along an edge of the disc; along one between two quads of the
  /// zone, those of the disc's quads there do.
  [[nodiscard]] bool is_good_inside(const Zone& zone, Side side,
                                    const std::vector<std::uint32_t>& quads) {
    disc_.clear();
    for (const std::uint32_t q : quads) disc_.add(q);
    count_.resize(peeling_.vertices(), 0);
    bool is_good_there = true;
    for (const std::uint32_t q : quads)
      for (Dart d = 4 * q; d < 4 * q + 4; ++d) {
        ++count_[peeling_.origin(d)];
        if (disc_.has(peeling_.twin(d) / 4) && !is_good_fold(angles_[d])) is_good_there = false;
      }
    for (const Dart in : zone)
      if (!is_good(angles_[in] / static_cast<float>(count_[rim_vertex(peeling_, in, side)]),
                   kAlongZone))
        is_good_there = false;
    for (const std::uint32_t q : quads)
      for (Dart d = 4 * q; d < 4 * q + 4; ++d) count_[peeling_.origin(d)] = 0;
    return is_good_there;
  }

  /// Requires that disc_ holds them.
  bool take(const std::vector<std::uint32_t>& quads) {
    Angles below;
    for (const std::uint32_t q : quads)
      for (Dart d = 4 * q; d < 4 * q + 4; ++d) {
        const Dart beyond = peeling_.twin(d);
        below.push_back(disc_.has(beyond / 4) ? angles_[d]
                                              : angles_[Peeling::opposite(beyond)] - 1);
      }
    const std::optional<std::vector<std::uint32_t>> tops = take_layer(peeling_, quads);
    if (!tops) return false;
    angles_.resize(4 * std::size_t{peeling_.quad_numbers()});
    for (std::size_t i = 0; i < below.size(); ++i) {
      const Dart d = 4 * (*tops)[i / 4] + static_cast<Dart>(i % 4);
      angles_[d] = angles_[peeling_.twin(d)] = below[i];
    }
    return true;
  }

  Peeling& peeling_;
  Angles& angles_;
  float within_ = kRightAtRim;        ///< at the rim, now
  Marks marks_;                       ///< quads of a zone, then of its disc, too
  Marks disc_;                        ///< quads of the last sharp disc
  std::vector<std::uint32_t> count_;  ///< quads of a disc at a vertex; 0 in between
};

/// Pairs each quad on the left of a zone with one on the right, side by side.
class Opposites {
 public:
  Opposites(const Peeling& peeling, const Zone& zone) : peeling_(peeling) {
    for (const Dart in : zone) in_zone_.add(in / 4);
    for (const Dart in : zone)
      if (!meet(peeling.twin(rim(in, Side::left)), peeling.twin(rim(in, Side::right)))) return;
    while (!open_.empty()) {
      auto [a, b] = open_.front();
      open_.pop_front();
      for (int i = 0; i < 4; ++i, a = Peeling::next(a), b = Peeling::prev(b))
        if (!meet(peeling.twin(a), peeling.twin(b))) return;
    }
    is_whole_ = 2 * opposite_.size() + zone.size() == peeling.quads();
  }

  [[nodiscard]] bool are_all() const { return is_whole_; }

  /// One hexahedron for each pair.
  [[nodiscard]] std::vector<Hexahedron> hexahedra() const {
    std::vector<Hexahedron> result;
    for (const auto& [a, b] : list_) {
      Hexahedron cell{};
      Dart bottom = a, top = b;
      for (std::size_t i = 0; i < 4; ++i) {
        cell[cells::kCornerOfPrism[i]] = peeling_.origin(bottom);
        cell[cells::kCornerOfPrism[4 + i]] = peeling_.origin(Peeling::next(top));
        bottom = Peeling::next(bottom);
        top = Peeling::prev(top);
      }
      result.push_back(cell);
    }
    return result;
  }

 private:
  /// Edge a of a quad on the left lies opposite edge b of one on the right.
  bool meet(Dart a, Dart b) {
    if (in_zone_.has(a / 4) || in_zone_.has(b / 4)) return a / 4 == b / 4;
    if (a / 4 == b / 4) return false;
    const auto [at, is_new] = opposite_.try_emplace(a / 4, turned(a, b));
    if (!is_new) return at->second == turned(a, b);
    if (!is_taken_.add(b / 4)) return false;
    list_.emplace_back(a - a % 4, at->second);
    open_.emplace_back(a, b);
    return true;
  }

  /// What lies opposite the first side of a's quad.
  static Dart turned(Dart a, Dart b) {
    for (; a % 4 != 0; a = Peeling::prev(a)) b = Peeling::next(b);
    return b;
  }

  const Peeling& peeling_;
  Marks in_zone_, is_taken_;
  std::unordered_map<std::uint32_t, Dart> opposite_;  ///< of quads on the left: turned()
  std::vector<std::pair<Dart, Dart>> list_;           ///< the same in order, by first sides
  std::deque<std::pair<Dart, Dart>> open_;
  bool is_whole_ = false;
};

/// Whether what was taken off relates no two vertices of a hexahedron but those of quads.
bool fits(const Peeling& peeling, const std::vector<Hexahedron>& hexahedra) {
  PairSet in_quads;
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

}  // namespace

std::size_t remove_sharp_zones(Peeling& peeling, Angles& angles) {
  core::expects(angles.size() == 4 * std::size_t{peeling.quad_numbers()},
                "an angle for each side of a quad");
  return SharpZones(peeling, angles).run();
}

std::optional<std::vector<Hexahedron>> single_layer(const Peeling& peeling, const Angles& angles) {
  core::expects(angles.size() == 4 * std::size_t{peeling.quad_numbers()},
                "an angle for each side of a quad");
  std::optional<std::vector<Hexahedron>> best;
  Marks marks;
  for_each_zone(peeling, [&](const Zone& zone) {
    const std::size_t hexahedra = (peeling.quads() - zone.size()) / 2;
    if (best && best->size() <= hexahedra) return;
    const bool is_sharp = std::all_of(zone.begin(), zone.end(), [&](Dart in) {
      return is_good(angles[rim(in, Side::left)], kSharpAtRim) &&
             is_good(angles[rim(in, Side::right)], kSharpAtRim);
    });
    if (!is_sharp || crossings_of(zone, marks) > 0) return;
    const Opposites opposites(peeling, zone);
    if (!opposites.are_all()) return;
    std::vector<Hexahedron> found = opposites.hexahedra();
    if (fits(peeling, found)) best = std::move(found);
  });
  return best;
}

}  // namespace hexatlas::flips
