#include "enum/flips/sharp_zones.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "enum/flips/facing.hpp"
#include "enum/flips/pillow.hpp"
#include "enum/flips/zone.hpp"

namespace hexatlas::flips {
namespace {

using complex::VertexId;
using Dart = Peeling::Dart;

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
    return !quads.empty() && take_layer(peeling_, quads, angles_).has_value();
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

  Peeling& peeling_;
  Angles& angles_;
  float within_ = kRightAtRim;        ///< at the rim, now
  Marks marks_;                       ///< quads of a zone, then of its disc, too
  Marks disc_;                        ///< quads of a disc
  std::vector<std::uint32_t> count_;  ///< quads of a disc at a vertex; 0 in between
};

}  // namespace

std::optional<std::vector<std::uint32_t>> take_layer(Peeling& peeling,
                                                     std::span<const std::uint32_t> quads,
                                                     Angles& angles) {
  expect_one_each(peeling, angles);
  Marks covered;
  for (const std::uint32_t q : quads) covered.add(q);
  Angles below;
  for (const std::uint32_t q : quads)
    for (Dart d = 4 * q; d < 4 * q + 4; ++d) {
      const Dart beyond = peeling.twin(d);
      below.push_back(covered.has(beyond / 4) ? angles[d] : angles[Peeling::opposite(beyond)] - 1);
    }
  auto tops = take_layer(peeling, quads);
  if (!tops) return std::nullopt;
  angles.resize(4 * std::size_t{peeling.quad_numbers()});
  for (std::size_t i = 0; i < below.size(); ++i) {
    const Dart d = 4 * (*tops)[i / 4] + static_cast<Dart>(i % 4);
    angles[d] = angles[peeling.twin(d)] = below[i];
  }
  return tops;
}

std::size_t remove_sharp_zones(Peeling& peeling, Angles& angles) {
  expect_one_each(peeling, angles);
  return SharpZones(peeling, angles).run();
}

}  // namespace hexatlas::flips
