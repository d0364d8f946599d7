#include "enum/complex/quadrangulation.hpp"

#include <algorithm>
#include <bitset>
#include <numeric>
#include <string>
#include <variant>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::complex {
namespace {

std::string edge_name(int a, int b) { return std::to_string(a) + "-" + std::to_string(b); }

/// Matches darts by their ends.
std::variant<Quadrangulation, BrokenLaw> assemble(std::span<const QuadVertices> quads) {
  if (quads.empty() || quads.size() > kMaxQuads)
    return BrokenLaw{"the number of quads must be from 1 to 64, here it is " +
                     std::to_string(quads.size())};
  const int vertices = static_cast<int>(quads.size()) + 2;
  std::array<Vertex, kMaxDarts> origin{};
  std::array<Dart, kMaxDarts> twin{};
  std::array<std::array<Dart, kMaxVertices>, kMaxVertices> dart_between{};
  std::array<std::bitset<kMaxVertices>, kMaxVertices> known;
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (const Vertex v : quads[q])
      if (v >= vertices)
        return BrokenLaw{"a sphere of " + std::to_string(quads.size()) + " quads has " +
                             std::to_string(vertices) + " vertices, but vertex " +
                             std::to_string(v) + " occurs",
                         q};
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vertex a = quads[q][i];
      const Vertex b = quads[q][(i + 1) % 4];
      if (a == b) return BrokenLaw{"an edge joins a vertex to itself", q};
      if (known[a][b])
        return BrokenLaw{"edge " + edge_name(a, b) + " is used twice in the same direction", q};
      known[a].set(b);
      origin[4 * q + i] = a;
      dart_between[a][b] = static_cast<Dart>(4 * q + i);
    }
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vertex a = quads[q][i];
      const Vertex b = quads[q][(i + 1) % 4];
      if (!known[b][a]) return BrokenLaw{"edge " + edge_name(a, b) + " is in one quad only", q};
      twin[4 * q + i] = dart_between[b][a];
    }
  const std::size_t darts = 4 * quads.size();
  auto result = Quadrangulation::from_darts({origin.data(), darts}, {twin.data(), darts}, vertices);
  if (auto law = result.validate()) return *law;
  return result;
}

}  // namespace

Quadrangulation Quadrangulation::from_darts(std::span<const Vertex> origin,
                                            std::span<const Dart> twin, int vertices) {
  core::expects(origin.size() == twin.size() && origin.size() % 4 == 0 &&
                    origin.size() <= kMaxDarts && vertices >= 0 && vertices <= kMaxVertices,
                "darts come in fours, at most 256, with at most 66 vertices");
  Quadrangulation result;
  result.quads_ = static_cast<std::uint8_t>(origin.size() / 4);
  result.vertices_ = static_cast<std::uint8_t>(vertices);
  std::copy(origin.begin(), origin.end(), result.origin_.begin());
  std::copy(twin.begin(), twin.end(), result.twin_.begin());
  return result;
}

std::optional<Quadrangulation> Quadrangulation::from_quads(std::span<const QuadVertices> quads) {
  auto result = assemble(quads);
  if (const auto* q = std::get_if<Quadrangulation>(&result)) return *q;
  return std::nullopt;
}

Quadrangulation Quadrangulation::cube() {
  std::array<QuadVertices, cells::kCubeFacets> quads{};
  std::copy(cells::kFacetVertices.begin(), cells::kFacetVertices.end(), quads.begin());
  return from_quads(quads).value();
}

std::optional<BrokenLaw> broken_law(std::span<const QuadVertices> quads) {
  auto result = assemble(quads);
  if (const auto* law = std::get_if<BrokenLaw>(&result)) return *law;
  return std::nullopt;
}

std::vector<QuadVertices> Quadrangulation::list_of_quads() const {
  std::vector<QuadVertices> result;
  result.reserve(quads_);
  for (int q = 0; q < quads(); ++q) result.push_back(vertices_of(q));
  return result;
}

std::array<std::uint8_t, kMaxVertices> Quadrangulation::degrees() const noexcept {
  std::array<std::uint8_t, kMaxVertices> result{};
  for (int d = 0; d < darts(); ++d) ++result[origin_[d]];
  return result;
}

int Quadrangulation::irregularity() const noexcept {
  const auto degree = degrees();
  return std::accumulate(degree.begin(), degree.begin() + vertices_, 0,
                         [](int sum, int d) { return sum + (d - 4) * (d - 4); });
}

int Quadrangulation::simple_zones() const noexcept {
  // A curve passes a quad by its sides 0 and 2, or by 1 and 3.
  std::array<std::array<std::uint8_t, 2>, kMaxQuads> zone{};  // of each passage, from 1 on
  std::bitset<kMaxDarts + 1> crosses_itself;
  std::uint8_t zones = 0;
  for (int first = 0; first < darts(); ++first) {
    auto d = static_cast<Dart>(first);
    if (zone[quad_of(d)][d % 2] != 0) continue;
    ++zones;
    for (; zone[quad_of(d)][d % 2] == 0; d = twin_[opposite(d)]) {
      zone[quad_of(d)][d % 2] = zones;
      if (zone[quad_of(d)][(d + 1) % 2] == zones) crosses_itself.set(zones);
    }
  }
  return zones - static_cast<int>(crosses_itself.count());
}

std::optional<BrokenLaw> Quadrangulation::validate() const {
  if (quads_ == 0) return BrokenLaw{"there is no quad"};
  for (int i = 0; i < darts(); ++i) {
    const auto d = static_cast<Dart>(i);
    const auto cell = static_cast<std::size_t>(quad_of(d));
    if (origin_[d] >= vertices_) return BrokenLaw{"a vertex number is out of range", cell};
    if (twin_[d] >= darts() || twin_[d] == d || twin_[twin_[d]] != d)
      return BrokenLaw{"two quads disagree about the edge that they share", cell};
    if (origin_[next(d)] != origin_[twin_[d]])
      return BrokenLaw{"an edge does not join the same vertices in its two quads", cell};
  }
  std::bitset<kMaxDarts> met;
  std::bitset<kMaxVertices> reached;
  for (int i = 0; i < darts(); ++i) {
    if (met[i]) continue;
    const auto first = static_cast<Dart>(i);
    const Vertex v = origin_[first];
    if (reached[v])
      return BrokenLaw{"the link of vertex " + std::to_string(v) + " is not a circle",
                       quad_of(first)};
    reached.set(v);
    Dart d = first;
    do {
      met.set(d);
      d = turn_left(d);
    } while (d != first);
  }
  if (static_cast<int>(reached.count()) != vertices_) return BrokenLaw{"a vertex is in no quad"};
  std::bitset<kMaxQuads> connected;
  std::vector<Quad> todo{0};
  connected.set(0);
  while (!todo.empty()) {
    const Quad q = todo.back();
    todo.pop_back();
    for (int i = 0; i < 4; ++i) {
      const Quad other = quad_of(twin_[dart(q, i)]);
      if (!connected[other]) todo.push_back(other);
      connected.set(other);
    }
  }
  if (static_cast<int>(connected.count()) != quads_)
    return BrokenLaw{"the surface has several components"};
  if (vertices_ != quads_ + 2)  // V - E + F = V - 2n + n
    return BrokenLaw{"the Euler characteristic is " + std::to_string(vertices_ - quads_) +
                     ", a sphere has 2"};
  return std::nullopt;
}

bool Quadrangulation::is_three_connected() const noexcept {
  if (quads_ < 6) return false;
  std::array<std::bitset<kMaxVertices>, kMaxVertices> joined;
  for (int q = 0; q < quads(); ++q) {
    const QuadVertices v = vertices_of(q);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vertex a = v[i];
      const Vertex b = v[(i + 1) % 4];
      if (joined[a][b]) return false;  // each direction of an edge occurs once
      joined[a].set(b);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const Vertex a = v[i];
      const Vertex b = v[i + 2];
      if (a == b || joined[a][b]) return false;  // no edge joins them: the graph is bipartite
      joined[a].set(b);
      joined[b].set(a);
    }
  }
  return true;
}

bool operator==(const Quadrangulation& a, const Quadrangulation& b) noexcept {
  const auto darts = static_cast<std::ptrdiff_t>(a.darts());
  return a.quads_ == b.quads_ && a.vertices_ == b.vertices_ &&
         std::equal(a.origin_.begin(), a.origin_.begin() + darts, b.origin_.begin()) &&
         std::equal(a.twin_.begin(), a.twin_.begin() + darts, b.twin_.begin());
}

}  // namespace hexatlas::complex
