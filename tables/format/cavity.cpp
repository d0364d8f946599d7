#include "tables/format/cavity.hpp"

#include <algorithm>

#include "enum/cells/cube.hpp"

namespace hexatlas::format {
namespace {

using complex::BoundaryQuad;
using complex::Hexahedron;
using complex::VertexId;

constexpr VertexId kUnset = 0xFFFFFFFF;

Hexahedron hexahedron_of(const BoundaryQuad& bottom, const BoundaryQuad& top) noexcept {
  Hexahedron cell{};
  for (std::size_t i = 0; i < 4; ++i) {
    cell[cells::kCornerOfPrism[i]] = bottom[i];
    cell[cells::kCornerOfPrism[4 + i]] = top[i];
  }
  return cell;
}

bool contains(const Hexahedron& cell, VertexId v) noexcept {
  return std::find(cell.begin(), cell.end(), v) != cell.end();
}

}  // namespace

Cavity::Cavity(const complex::Quadrangulation& boundary)
    : vertices_(static_cast<std::uint32_t>(boundary.vertices())) {
  quads_.reserve(2 * static_cast<std::size_t>(boundary.quads()));
  for (int q = 0; q < boundary.quads(); ++q) {
    const auto v = boundary.vertices_of(q);
    quads_.push_back({v[0], v[1], v[2], v[3]});
  }
}

std::optional<Cavity::Prism> Cavity::prism_of(Step step) const {
  if (step.bottom >= quads_.size() || step.sides > 15) return std::nullopt;
  Prism prism;
  prism.bottom = quads_[step.bottom];
  prism.top.fill(kUnset);
  prism.consumed.push_back(step.bottom);
  for (std::size_t i = 0; i < 4; ++i) {
    if ((step.sides >> i & 1U) == 0) continue;
    const std::size_t j = (i + 1) % 4;
    // The other quad at the edge runs from b_j to b_i, then to t_i, t_j.
    std::size_t place = 0;
    std::size_t at = 4;
    for (; place < quads_.size() && at == 4; ++place)
      for (std::size_t k = 0; k < 4; ++k)
        if (quads_[place][k] == prism.bottom[j] && quads_[place][(k + 1) % 4] == prism.bottom[i])
          at = k;
    if (at == 4) return std::nullopt;
    const BoundaryQuad& side = quads_[--place];
    for (const auto& [slot, value] :
         {std::pair(i, side[(at + 2) % 4]), std::pair(j, side[(at + 3) % 4])}) {
      if (prism.top[slot] != kUnset && prism.top[slot] != value) return std::nullopt;
      prism.top[slot] = value;
    }
    prism.consumed.push_back(place);
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      if (prism.top[j] == kUnset) continue;
      if (prism.top[j] == prism.bottom[i] || (i < j && prism.top[i] == prism.top[j]))
        return std::nullopt;
    }
  return prism;
}

std::optional<Hexahedron> Cavity::take_off(Step step) {
  auto prism = prism_of(step);
  if (!prism) return std::nullopt;
  for (VertexId& t : prism->top)
    if (t == kUnset) t = vertices_++;
  std::sort(prism->consumed.begin(), prism->consumed.end(), std::greater<>());
  for (const std::size_t place : prism->consumed)
    quads_.erase(quads_.begin() + static_cast<std::ptrdiff_t>(place));
  const auto& [b, t] = std::pair(prism->bottom, prism->top);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    if ((step.sides >> i & 1U) == 0) quads_.push_back({b[i], b[j], t[j], t[i]});
  }
  quads_.push_back(t);
  return hexahedron_of(b, t);
}

std::optional<Cavity::Step> Cavity::step_for(const Hexahedron& cell) const {
  std::vector<std::size_t> own;  // places of the quads of the hexahedron
  for (std::size_t place = 0; place < quads_.size(); ++place)
    if (std::all_of(quads_[place].begin(), quads_[place].end(),
                    [&](VertexId v) { return contains(cell, v); }))
      own.push_back(place);
  for (const std::size_t place : own) {
    Step step{static_cast<std::uint8_t>(place), 0};
    bool has_opposite = false;
    for (const std::size_t other : own) {
      if (other == place) continue;
      int common = 0;
      for (const VertexId v : quads_[other])
        common += static_cast<int>(std::count(quads_[place].begin(), quads_[place].end(), v));
      has_opposite = has_opposite || common == 0;
      for (std::size_t i = 0; i < 4 && common == 2; ++i) {
        const auto in = [&](VertexId v) {
          return std::find(quads_[other].begin(), quads_[other].end(), v) != quads_[other].end();
        };
        if (in(quads_[place][i]) && in(quads_[place][(i + 1) % 4]))
          step.sides = static_cast<std::uint8_t>(step.sides | 1U << i);
      }
    }
    if (has_opposite) continue;
    const auto prism = prism_of(step);
    if (!prism || prism->consumed.size() != own.size()) continue;
    const bool matches = std::all_of(prism->top.begin(), prism->top.end(),
                                     [&](VertexId t) { return t == kUnset || contains(cell, t); });
    if (matches) return step;
  }
  return std::nullopt;
}

std::optional<Hexahedron> Cavity::last() const {
  if (quads_.size() != 6) return std::nullopt;
  const auto prism = prism_of({0, 15});
  if (!prism) return std::nullopt;
  // The quad left over must be the top, seen from the other side.
  BoundaryQuad top = prism->top;
  std::reverse(top.begin(), top.end());
  for (std::size_t place = 1; place < 6; ++place) {
    if (std::count(prism->consumed.begin(), prism->consumed.end(), place) != 0) continue;
    BoundaryQuad rest = quads_[place];
    std::rotate(rest.begin(), std::find(rest.begin(), rest.end(), top[0]), rest.end());
    if (rest == top) return hexahedron_of(prism->bottom, prism->top);
  }
  return std::nullopt;
}

}  // namespace hexatlas::format
