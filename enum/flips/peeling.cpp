#include "enum/flips/peeling.hpp"

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::VertexId;

constexpr bool has(unsigned sides, unsigned side) { return (sides >> (side & 3U) & 1U) != 0; }

/// Corners of a prism: bottom 0 .. 3, top 4 .. 7.
struct OpenPairs {
  std::array<std::array<std::uint8_t, 2>, 12> pair{};
  unsigned count = 0;
};

constexpr bool share_quad(unsigned sides, unsigned a, unsigned b) {
  if (a < 4 && b < 4) return true;
  for (unsigned i = 0; i < 4; ++i) {
    if (!has(sides, i)) continue;
    const auto is_in = [i](unsigned corner) {
      return corner % 4 == i || corner % 4 == (i + 1) % 4;
    };
    if (is_in(a) && is_in(b)) return true;
  }
  return false;
}

/// For each set of sides, the corners on the patch that lie in no common quad of it.
constexpr std::array<OpenPairs, 16> kOpenPairs = [] {
  std::array<OpenPairs, 16> result{};
  for (unsigned sides = 0; sides < 16; ++sides) {
    const auto is_there = [sides](unsigned c) {
      return c < 4 || has(sides, c) || has(sides, c + 3);
    };
    OpenPairs& open = result[sides];
    for (unsigned a = 0; a < 8; ++a)
      for (unsigned b = 0; b < a; ++b)
        if (is_there(a) && is_there(b) && !share_quad(sides, a, b))
          open.pair[open.count++] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
  }
  return result;
}();

}  // namespace

Peeling::Peeling(std::span<const complex::BoundaryQuad> sphere, std::size_t vertices)
    : degree_(vertices, 0) {
  std::unordered_map<std::uint64_t, Dart> open;
  for (const complex::BoundaryQuad& quad : sphere) {
    const std::uint32_t q = new_quad(quad);
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId a = quad[i];
      const VertexId b = quad[(i + 1) % 4];
      const auto found = open.find(std::uint64_t{b} << 32U | a);
      if (found == open.end())
        open.emplace(std::uint64_t{a} << 32U | b, 4 * q + i);
      else
        link(4 * q + i, found->second);
      related_.insert(a, b);
    }
    related_.insert(quad[0], quad[2]);
    related_.insert(quad[1], quad[3]);
  }
}

bool Peeling::may_take(Patch patch, Prism& prism) const noexcept {
  const Dart first = 4 * patch.bottom;
  prism.top.fill(kNoVertex);
  for (unsigned i = 0; i < 4; ++i) prism.bottom[i] = origin_[first + i];
  for (unsigned i = 0; i < 4; ++i) {
    if (!has(patch.sides, i)) continue;
    const Dart side = twin_[first + i];
    prism.top[i] = origin_[opposite(side)];
    const bool has_before = has(patch.sides, i + 3);
    if (has_before && twin_[next(side)] != prev(across(patch, i + 3))) return false;
    if (!has(patch.sides, i + 1)) prism.top[(i + 1) % 4] = origin_[prev(side)];
  }
  const auto at = [&prism](std::uint8_t c) { return c < 4 ? prism.bottom[c] : prism.top[c - 4U]; };
  const OpenPairs& open = kOpenPairs[patch.sides];
  return std::none_of(open.pair.begin(), open.pair.begin() + open.count, [&](const auto& pair) {
    const VertexId a = at(pair[0]);
    const VertexId b = at(pair[1]);
    return a == b || related_.has(a, b);
  });
}

template <class Visit>
void Peeling::for_each_consumed(Patch patch, Visit&& visit) const {
  visit(patch.bottom);
  for (unsigned i = 0; i < 4; ++i)
    if (has(patch.sides, i)) visit(across(patch, i) / 4);
}

VertexId Peeling::new_vertex() {
  degree_.push_back(0);
  return static_cast<VertexId>(degree_.size() - 1);
}

std::uint32_t Peeling::new_quad(const std::array<VertexId, 4>& vertices) {
  const auto quad = static_cast<std::uint32_t>(live_.size());
  live_.push_back(1);
  ++live_count_;
  for (const VertexId v : vertices) {
    origin_.push_back(v);
    twin_.push_back(0);
    ++degree_[v];
  }
  return quad;
}

void Peeling::insert_quads(Patch patch, const Prism& prism) {
  const auto& [b, t] = prism;
  const std::uint32_t top = new_quad(t);
  std::array<std::uint32_t, 4> wall{};
  for (unsigned i = 0; i < 4; ++i)
    if (!has(patch.sides, i)) wall[i] = new_quad({b[i], b[(i + 1) % 4], t[(i + 1) % 4], t[i]});
  for (unsigned i = 0; i < 4; ++i) {
    const Dart side = across(patch, i);
    const Dart roof = 4 * top + i;
    if (has(patch.sides, i)) {
      link(roof, twin_[opposite(side)]);
      continue;
    }
    link(4 * wall[i], side);
    link(4 * wall[i] + 2, roof);
    const unsigned after = (i + 1) % 4;
    if (has(patch.sides, after))
      link(4 * wall[i] + 1, twin_[next(across(patch, after))]);
    else
      link(4 * wall[i] + 1, 4 * wall[after] + 3);
    const unsigned before = (i + 3) % 4;
    if (has(patch.sides, before)) link(4 * wall[i] + 3, twin_[prev(across(patch, before))]);
  }
}

void Peeling::add_cell(const Prism& prism) {
  complex::Hexahedron cell{};
  for (std::size_t i = 0; i < 4; ++i) {
    cell[cells::kCornerOfPrism[i]] = prism.bottom[i];
    cell[cells::kCornerOfPrism[4 + i]] = prism.top[i];
  }
  cells_.push_back(cell);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (related_.insert(cell[i], cell[j])) pairs_.emplace_back(cell[i], cell[j]);
}

void Peeling::take(Patch patch, const Prism& prism) {
  steps_.push_back({patch, vertices(), pairs_.size()});
  Prism complete = prism;
  for (VertexId& v : complete.top)
    if (v == kNoVertex) v = new_vertex();
  add_cell(complete);
  insert_quads(patch, complete);
  for_each_consumed(patch, [&](std::uint32_t quad) {
    live_[quad] = 0;
    --live_count_;
    for (unsigned i = 0; i < 4; ++i) --degree_[origin_[4 * quad + i]];
  });
}

void Peeling::put_back() {
  core::expects(!steps_.empty(), "a hexahedron was taken off");
  const Step step = steps_.back();
  steps_.pop_back();
  cells_.pop_back();
  for (; pairs_.size() > step.pairs; pairs_.pop_back())
    related_.erase(pairs_.back().first, pairs_.back().second);
  const auto consumed = 1U + static_cast<unsigned>(std::popcount(step.patch.sides));
  for (unsigned i = 0; i < 6 - consumed; ++i) {
    live_.pop_back();
    --live_count_;
    for (unsigned k = 0; k < 4; ++k) {
      --degree_[origin_.back()];
      origin_.pop_back();
      twin_.pop_back();
    }
  }
  degree_.resize(step.vertices);
  // The darts of consumed quads still know their twins.
  for_each_consumed(step.patch, [&](std::uint32_t quad) {
    live_[quad] = 1;
    ++live_count_;
    for (Dart d = 4 * quad; d < 4 * quad + 4; ++d) {
      ++degree_[origin_[d]];
      twin_[twin_[d]] = d;
    }
  });
}

std::vector<std::uint32_t> Peeling::live_quads() const {
  std::vector<std::uint32_t> result;
  result.reserve(live_count_);
  for (std::uint32_t q = 0; q < quad_numbers(); ++q)
    if (is_live(q)) result.push_back(q);
  return result;
}

std::vector<complex::BoundaryQuad> Peeling::cavity() const {
  std::vector<complex::BoundaryQuad> result;
  result.reserve(live_count_);
  for (const std::uint32_t q : live_quads()) {
    const Dart d = 4 * q;
    result.push_back({origin_[d], origin_[d + 1], origin_[d + 2], origin_[d + 3]});
  }
  return result;
}

}  // namespace hexatlas::flips
