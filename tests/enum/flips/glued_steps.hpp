#pragma once
/// \file
/// All ways to glue a hexahedron on, by names of vertices, and what takes one hexahedron to another
/// one: oracles of what is glued on symmetrically.

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include "enum/flips/symmetric_front.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::support {

/// Maps of the corners of a cube, bits being coordinates, that keep edges.
inline std::vector<std::array<std::size_t, 8>> corner_maps() {
  std::vector<std::array<std::size_t, 8>> result;
  std::array<std::size_t, 8> map{};
  std::iota(map.begin(), map.end(), 0U);
  do {
    bool keeps = true;
    for (std::size_t a = 0; a < 8 && keeps; ++a)
      for (std::size_t b = 0; b < a && keeps; ++b)
        keeps = std::has_single_bit(a ^ b) == std::has_single_bit(map[a] ^ map[b]);
    if (keeps) result.push_back(map);
  } while (std::next_permutation(map.begin(), map.end()));
  return result;
}

/// A front whose vertices have names, and a hexahedron by corner in these names.
struct Step {
  flips::Front front;
  std::vector<int> name;
  std::array<int, 8> cell{};
};

inline std::vector<Step> all_steps(const flips::Front& front, const std::vector<int>& name,
                                   int first_new) {
  std::vector<Step> result;
  for (const flips::Flip flip : candidate_flips(front.boundary, flips::kMaxFrontQuads)) {
    const auto prism = flips::prism_of(front.boundary, flip).value();
    if (!flips::may_glue(front, flip, prism) || !flips::is_preferred(front.boundary, flip))
      continue;
    const auto next = flips::glued(front, flip, prism);
    Step step{next.front, {}, {}};
    constexpr std::array<std::size_t, 4> kRound{0, 1, 3, 2};
    for (std::size_t i = 0; i < 4; ++i) {
      step.cell[kRound[i]] = name[prism.bottom[i]];
      step.cell[4 + kRound[i]] =
          prism.top[i] == flips::kNewVertex ? first_new + static_cast<int>(i) : name[prism.top[i]];
    }
    for (int v = 0; v < next.front.boundary.vertices(); ++v) {
      const complex::Vertex former = next.flipped.former[static_cast<std::size_t>(v)];
      step.name.push_back(former == flips::kNewVertex ? -1 : name[former]);
    }
    for (std::size_t i = 0; i < 4; ++i) step.name[next.flipped.top[i]] = step.cell[4 + kRound[i]];
    result.push_back(step);
  }
  return result;
}

/// The extension of the involution, given by name, that takes one hexahedron to the other, if any.
inline std::optional<std::map<int, int>> extension(const std::map<int, int>& image,
                                                   const std::array<int, 8>& cell,
                                                   const std::array<int, 8>& other) {
  static const auto kMaps = corner_maps();
  for (const auto& map : kMaps) {
    auto extended = image;
    bool fits = true;
    for (std::size_t c = 0; c < 8 && fits; ++c)
      fits = extended.emplace(cell[c], other[map[c]]).first->second == other[map[c]] &&
             extended.emplace(other[map[c]], cell[c]).first->second == cell[c];
    if (fits) return extended;
  }
  return std::nullopt;
}

inline void add_state(const Step& last, const std::map<int, int>& image, int max_quads,
                      std::set<flips::SymmetricState>& states) {
  if (last.front.boundary.quads() > max_quads) return;
  flips::SymmetricFront made{last.front, {}};
  for (std::size_t v = 0; v < last.name.size(); ++v) {
    const auto at = std::find(last.name.begin(), last.name.end(), image.at(last.name[v]));
    made.image[v] = static_cast<complex::Vertex>(at - last.name.begin());
  }
  states.insert(flips::canonical_state(made).state);
}

}  // namespace hexatlas::support
