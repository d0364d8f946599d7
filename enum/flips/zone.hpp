#pragma once
/// \file
/// Zones of a cavity's boundary: the quads crossed by a closed curve that leaves each quad at the
/// side opposite to where it came in.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "enum/flips/peeling.hpp"
#include "enum/flips/pillow.hpp"

namespace hexatlas::flips {

/// The darts at which the curve comes into the quads, in order.
using Zone = std::vector<Peeling::Dart>;

/// The two sides of a zone.
enum class Side : std::uint8_t { left, right };

/// The side of a zone's quad that is on that side of the zone, by the dart at which the curve comes
/// in.
[[nodiscard]] inline Peeling::Dart rim(Peeling::Dart in, Side side) {
  return side == Side::left ? Peeling::prev(in) : Peeling::next(in);
}

/// Requires a live dart.
[[nodiscard]] inline Zone zone_from(const Peeling& peeling, Peeling::Dart start) {
  Zone zone;
  Peeling::Dart at = start;
  do {
    zone.push_back(at);
    at = peeling.twin(Peeling::opposite(at));
  } while (at != start);
  return zone;
}

/// The curve of a former zone as it is now, from the same side: layers taken off since may have
/// taken some of its quads away, but left the curve. Empty if no quad of it is left.
[[nodiscard]] inline Zone what_is_left_of(const Zone& former, const Peeling& peeling) {
  const auto start = std::find_if(former.begin(), former.end(),
                                  [&](Peeling::Dart d) { return peeling.is_live(d / 4); });
  return start == former.end() ? Zone{} : zone_from(peeling, *start);
}

/// Calls visit(zone) for each zone once; it must not change the peeling.
template <class Visit>
void for_each_zone(const Peeling& peeling, Visit&& visit) {
  std::vector<std::array<bool, 2>> seen(peeling.quad_numbers(), {false, false});
  for (const std::uint32_t q : peeling.live_quads())
    for (Peeling::Dart d = 4 * q; d < 4 * q + 2; ++d) {
      if (seen[q][d % 2]) continue;
      const Zone zone = zone_from(peeling, d);
      for (const Peeling::Dart at : zone) seen[at / 4][at % 2] = true;
      visit(zone);
    }
}

/// How many quads a zone crosses twice. Its quads are marked afterwards, and no others.
[[nodiscard]] inline std::size_t crossings_of(const Zone& zone, Marks& marks) {
  marks.clear();
  return static_cast<std::size_t>(
      std::count_if(zone.begin(), zone.end(), [&](Peeling::Dart d) { return !marks.add(d / 4); }));
}

}  // namespace hexatlas::flips
