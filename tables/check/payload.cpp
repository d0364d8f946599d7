#include "tables/check/payload.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "tables/check/incidence.hpp"
#include "tables/check/judge_cells.hpp"
#include "tables/check/table_layout.hpp"

namespace hexatlas::check {

namespace {

/// Corner x + 2 y + 4 z of b0 b1 b2 b3 t0 t1 t2 t3.
constexpr std::array<unsigned, 8> kStepCorners = {0, 2, 3, 1, 4, 6, 7, 5};

/// VTK order from the order x + 2 y + 4 z.
Hexahedron vtk_order(const std::array<std::uint32_t, 8>& by_bits) {
  Hexahedron cell{};
  for (std::size_t i = 0; i < 8; ++i) cell[i] = by_bits[kCornerBits[i]];
  return cell;
}

/// Replays the steps of encoding 0 on the list L of quads.
class Replay {
 public:
  Replay(std::span<const Quad> boundary, Filling& filling)
      : quads_(boundary.begin(), boundary.end()), filling_(filling) {}

  std::string step(std::size_t place, unsigned sides) {
    if (place >= quads_.size()) return "there is no quad at place " + std::to_string(place);
    if (sides >= 16) return "there are no sides " + std::to_string(sides);
    const Quad bottom = quads_[place];
    std::array<std::optional<std::uint32_t>, 4> top;
    std::vector<std::size_t> leaving = {place};
    for (std::size_t i = 0; i < 4; ++i) {
      if ((sides >> i & 1) == 0) continue;
      std::string broken = fix_side(bottom, i, top, leaving);
      if (!broken.empty()) return broken;
    }
    Quad above{};
    for (std::size_t j = 0; j < 4; ++j) {
      above[j] = top[j] ? *top[j] : static_cast<std::uint32_t>(filling_.vertex_count++);
    }
    take_off(bottom, above);
    replace(bottom, above, sides, std::move(leaving));
    return {};
  }

  /// The last hexahedron: as by a step (0, 15), which then has as the other quad of its top the one
  /// quad that is left of L.
  [[nodiscard]] std::string last() {
    if (quads_.size() != 6) {
      return "after the steps " + std::to_string(quads_.size()) + " quads are left instead of six";
    }
    const std::string broken = step(0, 15);
    if (!broken.empty()) return "the last six quads: " + broken;
    if (least_first(quads_.front()) != least_first(reversed(quads_.back()))) {
      return "the last six quads are not those of a cube";
    }
    return {};
  }

 private:
  /// The other quad of L at side i of the bottom, which fixes two vertices of the top.
  std::string fix_side(const Quad& bottom, std::size_t i,
                       std::array<std::optional<std::uint32_t>, 4>& top,
                       std::vector<std::size_t>& leaving) const {
    const std::uint32_t from = bottom[i];
    const std::uint32_t to = bottom[(i + 1) % 4];
    const auto refusal = [&](const char* why) {
      return "edge " + listed(std::array{from, to}) + " has " + why;
    };
    std::optional<std::size_t> found;
    Quad across{};
    for (std::size_t q = 0; q < quads_.size(); ++q) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (quads_[q][k] != to || quads_[q][(k + 1) % 4] != from) continue;
        if (found) return refusal("more than one quad across");
        found = q;
        across = quads_[q];
        std::rotate(across.begin(), across.begin() + static_cast<std::ptrdiff_t>(k), across.end());
      }
    }
    if (!found) return refusal("no quad across");
    if (std::find(leaving.begin(), leaving.end(), *found) != leaving.end()) {
      return refusal("a quad across that leaves already");
    }
    for (const auto& [corner, vertex] :
         {std::pair(i, across[2]), std::pair((i + 1) % 4, across[3])}) {
      if (top[corner] && *top[corner] != vertex) return "the sides of a step do not agree";
      top[corner] = vertex;
    }
    leaving.push_back(*found);
    return {};
  }

  void take_off(const Quad& bottom, const Quad& top) {
    std::array<std::uint32_t, 8> by_bits{};
    for (std::size_t j = 0; j < 4; ++j) {
      by_bits[kStepCorners[j]] = bottom[j];
      by_bits[kStepCorners[j + 4]] = top[j];
    }
    filling_.removal_order.push_back(static_cast<std::uint32_t>(filling_.cells.size()));
    filling_.cells.push_back(vtk_order(by_bits));
  }

  void replace(const Quad& bottom, const Quad& top, unsigned sides,
               std::vector<std::size_t> leaving) {
    std::sort(leaving.begin(), leaving.end());
    for (std::size_t i = leaving.size(); i-- > 0;) {
      quads_.erase(quads_.begin() + static_cast<std::ptrdiff_t>(leaving[i]));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      if ((sides >> i & 1) == 0) quads_.push_back({bottom[i], bottom[j], top[j], top[i]});
    }
    quads_.push_back(top);
  }

  std::vector<Quad> quads_;
  Filling& filling_;
};

std::string read_flips(std::string_view steps, std::span<const Quad> boundary,
                       std::uint32_t hexahedra, Filling& filling) {
  if (steps.size() != 2 * (std::uint64_t{hexahedra} - 1)) return "the payload has a wrong length";
  filling.vertex_count = boundary.size() + 2;
  Replay replay(boundary, filling);
  for (std::size_t i = 0; i < steps.size(); i += 2) {
    const std::string broken =
        replay.step(static_cast<unsigned char>(steps[i]), static_cast<unsigned char>(steps[i + 1]));
    if (!broken.empty()) return "step " + std::to_string(i / 2) + ": " + broken;
  }
  return replay.last();
}

std::string read_cells(std::string_view cells, std::uint32_t hexahedra, Filling& filling) {
  if (cells.size() != std::uint64_t{16} * hexahedra) return "the payload has a wrong length";
  for (std::uint64_t c = 0; c < hexahedra; ++c) {
    std::array<std::uint32_t, 8> by_bits{};
    for (std::uint64_t i = 0; i < 8; ++i) {
      by_bits[i] = static_cast<std::uint32_t>(number_at(cells, 16 * c + 2 * i, 2));
    }
    filling.cells.push_back(vtk_order(by_bits));
  }
  return {};
}

}  // namespace

std::string read_payload(std::string_view payload, std::span<const Quad> boundary,
                         std::uint32_t hexahedra, std::uint32_t interior, Filling& filling) {
  if (hexahedra == 0) return "there are no hexahedra";
  if (payload.empty()) return "the payload is empty";
  const unsigned encoding = static_cast<unsigned char>(payload[0]);
  std::string broken = "unknown encoding";
  if (encoding == 0) broken = read_flips(payload.substr(1), boundary, hexahedra, filling);
  if (encoding == 1) broken = read_cells(payload.substr(1), hexahedra, filling);
  if (!broken.empty()) return broken;
  const std::uint64_t vertices = boundary.size() + 2 + interior;
  if (encoding == 0 && filling.vertex_count != vertices) {
    return "the number of interior vertices is not that of the mesh";
  }
  filling.vertex_count = vertices;
  return {};
}

}  // namespace hexatlas::check
