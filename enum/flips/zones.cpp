#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "enum/flips/pillow.hpp"
#include "enum/flips/reducing.hpp"

namespace hexatlas::flips {
namespace {

using Dart = Peeling::Dart;

constexpr Dart opposite(Dart d) { return (d & ~3U) | ((d + 2) & 3U); }
constexpr Dart next(Dart d) { return (d & ~3U) | ((d + 1) & 3U); }
constexpr Dart prev(Dart d) { return (d & ~3U) | ((d + 3) & 3U); }

/// The darts at which a curve comes into the quads of its zone, in order.
using Zone = std::vector<Dart>;

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
    const std::uint32_t quads = peeling_.quad_numbers();
    std::vector<std::array<bool, 2>> seen(quads, {false, false});
    for (std::uint32_t q = 0; q < quads; ++q)
      for (Dart d = 4 * q; peeling_.is_live(q) && d < 4 * q + 2; ++d) {
        if (seen[q][d % 2]) continue;
        std::optional<Zone> zone = zone_from(d, seen);
        if (!zone) continue;
        const std::size_t area = std::max(disc(*zone, true).size(), disc(*zone, false).size());
        const double cost = static_cast<double>(area) / static_cast<double>(zone->size());
        if (area > 0 && cost <= price_) result.push_back({cost, *std::move(zone)});
      }
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return result;
  }

  /// The zone that is entered at d; nullopt if it crosses itself. Marks what it went through.
  std::optional<Zone> zone_from(Dart d, std::vector<std::array<bool, 2>>& seen) {
    Zone zone;
    bool is_simple = true;
    quad_marks_.clear();
    for (Dart at = d; zone.empty() || at != d; at = peeling_.twin(opposite(at))) {
      seen[at / 4][at % 2] = true;
      is_simple = quad_marks_.add(at / 4) && is_simple;
      zone.push_back(at);
    }
    if (!is_simple) return std::nullopt;
    return zone;
  }

  /// The quads on one side of a simple zone, or none if they are more than half of the rest. So of
  /// the two sides one is empty, or both have as many.
  [[nodiscard]] std::vector<std::uint32_t> disc(const Zone& zone, bool left) {
    quad_marks_.clear();
    for (const Dart d : zone) quad_marks_.add(d / 4);
    std::vector<std::uint32_t> quads;
    const auto reach = [&](Dart rim) {
      if (quad_marks_.add(rim / 4)) quads.push_back(rim / 4);
    };
    for (const Dart d : zone) reach(peeling_.twin(left ? prev(d) : next(d)));
    const std::size_t most = (peeling_.quads() - zone.size()) / 2;
    for (std::size_t i = 0; i < quads.size() && quads.size() <= most; ++i)
      for (Dart d = 4 * quads[i]; d < 4 * quads[i] + 4; ++d) reach(peeling_.twin(d));
    if (quads.size() > most) quads.clear();
    return quads;
  }

  /// Layers taken off since took some of its quads away, but left the curve. A zone given up for
  /// that would let one be removed that encloses it, at the price of more hexahedra.
  bool remove(const Zone& former) {
    const auto start = std::find_if(former.begin(), former.end(),
                                    [this](Dart d) { return peeling_.is_live(d / 4); });
    if (start == former.end()) return false;
    std::vector<std::array<bool, 2>> unused(peeling_.quad_numbers());
    const std::optional<Zone> zone = zone_from(*start, unused);
    if (!zone) return false;
    for (const bool left : {true, false}) {
      const std::vector<std::uint32_t> quads = disc(*zone, left);
      const double cost = static_cast<double>(quads.size()) / static_cast<double>(zone->size());
      if (!quads.empty() && cost <= price_ && take_layer(peeling_, quads)) return true;
    }
    return false;
  }

  Peeling& peeling_;
  double price_;
  Marks quad_marks_;
};

}  // namespace

std::size_t remove_zones(Peeling& peeling, double price) {
  return ZoneRemover(peeling, price).run();
}

}  // namespace hexatlas::flips
