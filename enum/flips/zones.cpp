#include <algorithm>
#include <array>
#include <vector>

#include "enum/flips/pillow.hpp"
#include "enum/flips/reducing.hpp"
#include "enum/flips/zone.hpp"

namespace hexatlas::flips {
namespace {

using Dart = Peeling::Dart;

class ZoneRemover {
 public:
  ZoneRemover(Peeling& peeling, double price) : peeling_(peeling), price_(price) {}

  std::size_t run() {
    std::size_t removed = 0;
    for (std::size_t before = removed + 1; before != removed;) {
      before = removed;
      for (const Candidate& candidate : candidates())
        if (remove(candidate.zone)) ++removed;
    }
    return removed;
  }

 private:
  struct Candidate {
    double cost = 0;  ///< hexahedra per quad of the zone
    Zone zone;        ///< when it was found
  };

  [[nodiscard]] std::vector<Candidate> candidates() {
    std::vector<Candidate> result;
    for_each_zone(peeling_, [&](const Zone& zone) {
      const std::vector<std::uint32_t> quads = affordable_side(zone);
      if (!quads.empty()) result.push_back({cost_of(quads, zone), zone});
    });
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return result;
  }

  [[nodiscard]] static double cost_of(const std::vector<std::uint32_t>& quads, const Zone& zone) {
    return static_cast<double>(quads.size()) / static_cast<double>(zone.size());
  }

  /// The quads on that side of a zone which has fewer; left of it if both have as many. Empty if
  /// they are too many for the price, or the zone crosses itself. Both sides grow in turn until one
  /// is complete.
  [[nodiscard]] std::vector<std::uint32_t> affordable_side(const Zone& zone) {
    if (crossings_of(zone, quad_marks_) > 0) return {};
    struct Grown {
      std::vector<std::uint32_t> quads;
      std::size_t seen = 0;
      [[nodiscard]] bool is_beyond(double most) const {
        return static_cast<double>(quads.size()) > most;
      }
    };
    std::array<Grown, 2> sides;
    const auto reach = [&](Grown& side, Dart first) {
      if (quad_marks_.add(first / 4)) side.quads.push_back(first / 4);
    };
    for (const Dart d : zone) {
      reach(sides[0], peeling_.twin(rim(d, Side::left)));
      reach(sides[1], peeling_.twin(rim(d, Side::right)));
    }
    const double most = price_ * static_cast<double>(zone.size());
    for (std::size_t turn = 0;; ++turn) {
      Grown& side = sides[turn % 2];
      if (side.is_beyond(most)) {
        if (sides[(turn + 1) % 2].is_beyond(most)) return {};
        continue;
      }
      if (side.seen == side.quads.size()) return std::move(side.quads);
      const std::uint32_t quad = side.quads[side.seen++];
      for (Dart d = 4 * quad; d < 4 * quad + 4; ++d) reach(side, peeling_.twin(d));
    }
  }

  /// A zone given up for what layers took away since would let one be removed that encloses it, at
  /// the price of more hexahedra.
  bool remove(const Zone& former) {
    const Zone zone = what_is_left_of(former, peeling_);
    if (zone.empty()) return false;
    const std::vector<std::uint32_t> quads = affordable_side(zone);
    return !quads.empty() && take_layer(peeling_, quads).has_value();
  }

  Peeling& peeling_;
  double price_;
  Marks quad_marks_;
};

}  // namespace

std::size_t self_crossings(const Peeling& peeling) {
  Marks marks;
  std::size_t result = 0;
  for_each_zone(peeling, [&](const Zone& zone) { result += crossings_of(zone, marks); });
  return result;
}

std::size_t remove_zones(Peeling& peeling, double price) {
  return ZoneRemover(peeling, price).run();
}

}  // namespace hexatlas::flips
