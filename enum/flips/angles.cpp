#include "enum/flips/angles.hpp"

#include <cstddef>
#include <utility>

namespace hexatlas::flips {

bool take_layer(Peeling& peeling, std::span<const std::uint32_t> quads, Angles& angles) {
  using Dart = Peeling::Dart;
  expect_one_each(peeling, angles);
  Marks covered;
  for (const std::uint32_t q : quads) covered.add(q);
  std::vector<std::pair<Dart, std::int16_t>> across;  // of sides at the zone, what lies below them
  for (const std::uint32_t q : quads)
    for (Dart d = 4 * q; d < 4 * q + 4; ++d) {
      const Dart beyond = peeling.twin(d);
      if (!covered.has(beyond / 4))
        across.emplace_back(d, less_a_right_angle(angles[Peeling::opposite(beyond)]));
    }
  const auto layer = take_layer(peeling, quads);
  if (!layer) return false;
  angles.resize(4 * std::size_t{peeling.quad_numbers()});
  for (const auto& [d, angle] : across) angles[d] = angle;
  for (const LayerQuads& pair : *layer)
    for (Dart i = 0; i < 4; ++i) {
      const Dart d = 4 * pair.below + i;
      angles[d] = angles[peeling.twin(d)] = angles[4 * pair.above + i];
    }
  return true;
}

}  // namespace hexatlas::flips
