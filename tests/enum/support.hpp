#pragma once
/// \file
/// What the tests of enum share: random numbers with a printed seed, relabelled copies, the
/// quadrangulations of the oracle as ours.

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/front.hpp"
#include "tests/oracles/hexahedra.hpp"
#include "tests/oracles/quadrangulations.hpp"

namespace hexatlas::support {

/// A small generator whose numbers are the same everywhere, unlike std::uniform_int_distribution.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] std::size_t below(std::size_t bound) { return engine_() % bound; }
  [[nodiscard]] bool coin() { return below(2) == 1; }
  template <class List>
  void shuffle(List& list) {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[below(i)]);
  }
  [[nodiscard]] std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
};

inline complex::Quadrangulation quadrangulation(const oracle::Rotations& map) {
  return complex::Quadrangulation::from_quads(oracle::quads_of(map)).value();
}

inline std::vector<oracle::Cell> cells_of(const complex::HexComplex& mesh) {
  return {mesh.hexahedra.begin(), mesh.hexahedra.end()};
}

inline complex::Quadrangulation boundary_of(const std::string& code) {
  return canon::decode(canon::from_text(code).value()).value();
}

/// Vertices renamed, quads in another order, each begun at another corner, mirrored or not.
inline complex::Quadrangulation scrambled(const complex::Quadrangulation& q, Random& random,
                                          bool mirrored) {
  std::vector<complex::Vertex> name(static_cast<std::size_t>(q.vertices()));
  std::iota(name.begin(), name.end(), complex::Vertex{0});
  random.shuffle(name);
  auto quads = q.list_of_quads();
  for (auto& quad : quads) {
    for (auto& v : quad) v = name[v];
    if (mirrored) std::reverse(quad.begin(), quad.end());
    std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(random.below(4)),
                quad.end());
  }
  random.shuffle(quads);
  return complex::Quadrangulation::from_quads(quads).value();
}

/// All simple quadrangulations with n quads, from those with n - 1, one per code.
using Classes = std::map<canon::Code, oracle::Rotations>;
inline Classes four_cycle_class() {
  const auto map = oracle::four_cycle();
  return {{canon::canonical_form(quadrangulation(map)).code, map}};
}
inline Classes grown(const Classes& level) {
  Classes next;
  for (const auto& [code, map] : level)
    for (auto& split : oracle::splits_of(map))
      next.emplace(canon::canonical_form(quadrangulation(split)).code, std::move(split));
  return next;
}

/// The cycles of the quads of a front, in mesh vertices or its own.
inline oracle::Cycle cycle(const complex::QuadVertices& v) {
  return oracle::rotated({v[0], v[1], v[2], v[3]});
}

inline std::vector<oracle::Cell> cells_of(const flips::Shelling& shelling) {
  std::vector<oracle::Cell> cells;
  for (const auto& cell : shelling.cells()) {
    oracle::Cell wide{};
    std::copy(cell.begin(), cell.end(), wide.begin());
    cells.push_back(wide);
  }
  return cells;
}

inline complex::HexComplex mesh_of(const std::vector<oracle::Cell>& cells) {
  std::uint32_t vertices = 0;
  for (const auto& cell : cells)
    for (const std::uint32_t v : cell) vertices = std::max(vertices, v + 1);
  return {vertices, {cells.begin(), cells.end()}};
}

/// Vertices renamed, hexahedra in another order, each turned by a random symmetry of the cube;
/// all mirrored or none.
inline complex::HexComplex scrambled(const complex::HexComplex& mesh, Random& random,
                                     bool mirrored) {
  std::vector<std::uint32_t> name(mesh.vertices);
  std::iota(name.begin(), name.end(), 0U);
  random.shuffle(name);
  complex::HexComplex result = mesh;
  for (auto& cell : result.hexahedra) {
    std::array<unsigned, 3> axis{0, 1, 2};
    random.shuffle(axis);
    unsigned flip = static_cast<unsigned>(random.below(8));
    // Odd permutations and odd numbers of reflections turn the orientation round.
    const bool odd = ((axis[0] > axis[1]) != (axis[0] > axis[2])) != (axis[1] > axis[2]);
    const bool odd_flip = ((flip ^ flip >> 1U ^ flip >> 2U) & 1U) != 0;
    if ((odd != odd_flip) != mirrored) flip ^= 1U;
    const auto old = cell;
    for (unsigned v = 0; v < 8; ++v) {
      unsigned image = flip;
      for (unsigned k = 0; k < 3; ++k)
        if ((v >> k & 1U) != 0) image ^= 1U << axis[k];
      cell[v] = name[old[image]];
    }
  }
  random.shuffle(result.hexahedra);
  return result;
}

/// All flips of a front that give a patch, glueable or not, with 6 .. max_quads quads after.
inline std::vector<flips::Flip> candidate_flips(const complex::Quadrangulation& q, int max_quads) {
  std::vector<flips::Flip> result;
  for (int bottom = 0; bottom < q.quads(); ++bottom)
    for (unsigned sides = 0; sides < flips::kSideSets; ++sides) {
      const flips::Flip flip{static_cast<complex::Quad>(bottom), static_cast<std::uint8_t>(sides)};
      const int after = q.quads() + 6 - 2 * flip.consumed();
      if (after >= 6 && after <= max_quads && flips::prism_of(q, flip)) result.push_back(flip);
    }
  return result;
}

/// A random shelling of this many hexahedra; fewer if it gets stuck.
inline flips::Shelling random_shelling(std::size_t hexahedra, int max_quads, Random& random) {
  flips::Shelling shelling;
  while (shelling.cells().size() < hexahedra) {
    auto flips = candidate_flips(shelling.front().boundary, max_quads);
    random.shuffle(flips);
    const bool pushed = std::any_of(flips.begin(), flips.end(), [&](flips::Flip flip) {
      return shelling.push(flip).has_value();
    });
    if (!pushed) break;
  }
  return shelling;
}

/// What is wrong with a mesh of a boundary in canonical labels; empty if nothing is: the strict
/// rule and the boundary by sets, the laws of a ball but for a shelling.
inline std::string fault_of_mesh(const complex::HexComplex& mesh, const canon::Code& code) {
  const std::vector<oracle::Cell> cells(mesh.hexahedra.begin(), mesh.hexahedra.end());
  if (!oracle::obeys_strict_rule(cells)) return "breaks the strict rule";
  std::set<oracle::Cycle> wanted;
  const auto boundary = canon::decode(code);
  if (!boundary) return "has no boundary to fill";
  for (const auto& quad : boundary->list_of_quads()) wanted.insert(cycle(quad));
  if (oracle::boundary(cells) != wanted) return "has another boundary";
  if (oracle::euler_characteristic(cells) != 1)
    return "has another Euler characteristic than a ball";
  if (const auto law = complex::validate(mesh)) return law->reason;
  return "";
}

/// As fault_of_mesh(), for meshes listed as a shelling backwards, which proves them balls.
inline std::string fault_of_filling(const complex::HexComplex& mesh, const canon::Code& code) {
  std::string fault = fault_of_mesh(mesh, code);
  if (!fault.empty()) return fault;
  std::vector<oracle::Cell> cells(mesh.hexahedra.rbegin(), mesh.hexahedra.rend());
  return oracle::is_shelling(cells) ? "" : "is not listed as a shelling backwards";
}

/// The boundary of so many hexahedra in a row.
inline canon::Code code_of_bar(int hexahedra) {
  std::vector<complex::QuadVertices> quads{{0, 3, 2, 1}};
  const auto at = [](int layer, int i) { return static_cast<complex::Vertex>(4 * layer + i % 4); };
  for (int layer = 0; layer < hexahedra; ++layer)
    for (int i = 0; i < 4; ++i)
      quads.push_back({at(layer, i), at(layer, i + 1), at(layer + 1, i + 1), at(layer + 1, i)});
  quads.push_back({at(hexahedra, 0), at(hexahedra, 1), at(hexahedra, 2), at(hexahedra, 3)});
  return canon::canonical_form(complex::Quadrangulation::from_quads(quads).value()).code;
}

/// The sum of (degree - 4)^2, the degree of a vertex being the number of its quads.
inline int irregularity_of(const complex::Quadrangulation& q) {
  std::map<complex::Vertex, int> degree;
  for (const auto& quad : q.list_of_quads())
    for (const complex::Vertex v : quad) ++degree[v];
  int sum = 0;
  for (const auto& [v, d] : degree) sum += (d - 4) * (d - 4);
  return sum;
}

/// Classes of edges under "opposite in a quad", less those that have two adjacent edges of a quad.
/// For simple graphs only: an edge is the pair of its ends.
inline int simple_zones_of(const complex::Quadrangulation& q) {
  using Edge = std::pair<complex::Vertex, complex::Vertex>;
  const auto edge = [](complex::Vertex a, complex::Vertex b) -> Edge { return std::minmax(a, b); };
  std::map<Edge, Edge> parent;
  const std::function<Edge(Edge)> root = [&](Edge e) {
    const auto at = parent.try_emplace(e, e).first;
    return at->second == e ? e : root(at->second);
  };
  for (const auto& [a, b, c, d] : q.list_of_quads()) {
    parent[root(edge(a, b))] = root(edge(c, d));
    parent[root(edge(b, c))] = root(edge(d, a));
  }
  std::set<Edge> simple;
  for (const auto& [e, to] : parent) simple.insert(root(e));
  for (const auto& [a, b, c, d] : q.list_of_quads())
    if (root(edge(a, b)) == root(edge(b, c))) simple.erase(root(edge(a, b)));
  return static_cast<int>(simple.size());
}

}  // namespace hexatlas::support
