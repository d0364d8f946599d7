#include "enum/flips/sharp_zones.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "enum/flips/pillow.hpp"
#include "enum/flips/zone.hpp"

namespace hexatlas::flips {
namespace {

using Dart = Peeling::Dart;

class SharpZones {
 public:
  SharpZones(Peeling& peeling, Angles& angles, const SharpOptions& options)
      : peeling_(peeling), angles_(angles), options_(options) {}

  std::size_t run() {
    if (options_.only_one) {
      std::vector<Candidate> all = candidates();
      return std::any_of(all.begin(), all.end(), [this](Candidate& one) { return remove(one); });
    }
    std::size_t removed = 0;
    for (std::vector<Candidate> all = candidates(); !all.empty(); all = candidates()) {
      const std::size_t before = removed;
      while (!all.empty()) {
        std::erase_if(all, [this](Candidate& candidate) { return !remove(candidate); });
        removed += all.size();
      }
      if (removed == before) break;
    }
    return removed;
  }

 private:
  struct Candidate {
    double rank = 0;  ///< those with the least go first
    Zone zone;        ///< when it was found
    Side side{};
  };

  [[nodiscard]] std::vector<Candidate> candidates() {
    std::vector<Candidate> result;
    for_each_zone(peeling_, [&](const Zone& zone) {
      for (const Side side : {Side::left, Side::right}) {
        const auto quads = static_cast<double>(sharp_piece(zone, side).size());
        const bool is_cheapest = options_.order == ZoneOrder::cheapest;
        if (quads > 0)
          result.push_back(
              {is_cheapest ? quads / static_cast<double>(rim_quads_) : -quads, zone, side});
      }
    });
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& a, const Candidate& b) { return a.rank < b.rank; });
    return result;
  }

  /// Then it is the zone behind, where the one removed ended.
  bool remove(Candidate& candidate) {
    const Zone zone = what_is_left_of(candidate.zone, peeling_);
    if (zone.empty()) return false;
    const std::span<const std::uint32_t> quads = sharp_piece(zone, candidate.side);
    if (quads.empty()) return false;
    const Dart behind = peeling_.twin(Peeling::opposite(rim(zone.front(), candidate.side)));
    if (!take_layer(peeling_, quads, angles_)) return false;
    candidate.side = Side::left;
    candidate.zone = zone_from(peeling_, Peeling::next(behind));
    return true;
  }

  /// The quads on that side of a zone, up to the other zones where the piece has to end; empty if a
  /// zone is not sharp there, or these are not as many as are asked for. Valid until the next call.
  [[nodiscard]] std::span<const std::uint32_t> sharp_piece(const Zone& zone, Side side) {
    rim_.clear();
    covered_.clear();
    piece_.clear();
    rim_quads_ = 0;
    if (!add_rim(zone, side)) return {};
    for (std::size_t seen = 0; seen < piece_.size();) {
      const std::uint32_t q = piece_[seen++];
      for (Dart d = 4 * q; d < 4 * q + 4; ++d) {
        const Dart beyond = peeling_.twin(d);
        if (rim_.has(beyond / 4)) continue;
        if (is_good_fold(angles_[d])) {
          reach(beyond);
          continue;
        }
        const bool ends = options_.rims == Rims::several &&
                          add_rim(zone_from(peeling_, Peeling::next(beyond)), Side::left);
        if (!ends) return {};
      }
    }
    if (options_.rims == Rims::several && rim_quads_ == zone.size()) return {};
    return piece_;
  }

  /// Whether the piece may end at this zone: it is sharp there, and has no quad in common with the
  /// piece so far or its other rims.
  [[nodiscard]] bool add_rim(const Zone& zone, Side side) {
    const bool ends_well = std::all_of(zone.begin(), zone.end(), [&](Dart in) {
      const Dart edge = rim(in, side);
      return is_good(angles_[edge], options_.within) &&
             angles_[Peeling::opposite(edge)] - kRightAngle >= kLeastLeft;
    });
    if (!ends_well || crossings_of(zone, in_zone_) > 0 || !is_good_along(zone, side)) return false;
    for (const Dart in : zone)
      if (covered_.has(in / 4) || !rim_.add(in / 4)) return false;
    rim_quads_ += zone.size();
    return std::all_of(zone.begin(), zone.end(), [&](Dart in) {
      const Dart beside = peeling_.twin(rim(in, side));
      reach(beside);
      return !rim_.has(beside / 4);
    });
  }

  void reach(Dart d) {
    if (covered_.add(d / 4)) piece_.push_back(d / 4);
  }

  /// Along an edge between two quads of the zone the quads of the disc at its end share the angle.
  /// Requires that in_zone_ has the quads of the zone.
  [[nodiscard]] bool is_good_along(const Zone& zone, Side side) const {
    return std::all_of(zone.begin(), zone.end(), [&](Dart in) {
      const int quads = quads_at_end(in, side);
      return std::abs(angles_[in] - kRightAngle * quads) <= kAlongZone * quads;
    });
  }

  /// From the quad beside the zone around the vertex, until the zone comes again.
  [[nodiscard]] int quads_at_end(Dart in, Side side) const {
    int quads = 1;
    for (Dart at = peeling_.twin(rim(in, side));; ++quads) {
      at = peeling_.twin(side == Side::left ? Peeling::prev(at) : Peeling::next(at));
      if (in_zone_.has(at / 4)) return quads;
    }
  }

  Peeling& peeling_;
  Angles& angles_;
  SharpOptions options_;
  Marks in_zone_;                     ///< quads of the zone looked at
  Marks rim_;                         ///< quads of the zones where the piece ends
  Marks covered_;                     ///< quads of the piece
  std::vector<std::uint32_t> piece_;  ///< the same
  std::size_t rim_quads_ = 0;
};

}  // namespace

std::size_t remove_sharp_zones(Peeling& peeling, Angles& angles, const SharpOptions& options) {
  expect_one_each(peeling, angles);
  return SharpZones(peeling, angles, options).run();
}

}  // namespace hexatlas::flips
