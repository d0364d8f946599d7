#include "enum/quads/planar_map.hpp"

#include <vector>

#include "enum/core/checks.hpp"

namespace hexatlas::quads {

PlanarMap planar_map_of(const complex::Quadrangulation& q) noexcept {
  PlanarMap map;
  map.vertices = q.vertices();
  std::array<Dart, complex::kMaxDarts> name{};
  for (int i = 0; i < q.darts(); ++i) {
    const auto d = static_cast<Dart>(i);
    if (q.twin(d) < d) continue;
    name[d] = static_cast<Dart>(map.darts++);
    name[q.twin(d)] = static_cast<Dart>(map.darts++);
  }
  for (int i = 0; i < q.darts(); ++i) {
    const auto d = static_cast<Dart>(i);
    const Vertex v = q.origin(d);
    map.origin[name[d]] = v;
    map.ccw[name[d]] = name[q.turn_left(d)];
    map.cw[name[d]] = name[q.turn_right(d)];
    map.first[v] = name[d];
    ++map.degree[v];
  }
  return map;
}

complex::Quadrangulation quadrangulation_of(const PlanarMap& map) {
  constexpr int kNone = -1;
  std::array<int, complex::kMaxDarts> name{};
  name.fill(kNone);
  std::array<Vertex, complex::kMaxDarts> origin{};
  std::array<Dart, complex::kMaxDarts> twins{};
  int next = 0;
  for (int i = 0; i < map.darts; ++i) {
    auto d = static_cast<Dart>(i);
    for (; name[d] == kNone; d = map.along(d)) name[d] = next++;
  }
  for (int i = 0; i < map.darts; ++i) {
    const auto d = static_cast<Dart>(i);
    const auto renamed = static_cast<std::size_t>(name[d]);
    origin[renamed] = map.origin[d];
    twins[renamed] = static_cast<Dart>(name[twin(d)]);
  }
  const auto darts = static_cast<std::size_t>(map.darts);
  return complex::Quadrangulation::from_darts({origin.data(), darts}, {twins.data(), darts},
                                              map.vertices);
}

PlanarMap four_cycle() {
  const std::array<complex::QuadVertices, 2> quads{{{0, 1, 2, 3}, {3, 2, 1, 0}}};
  return planar_map_of(complex::Quadrangulation::from_quads(quads).value());
}

PlanarMap pseudo_double_wheel(int quads) {
  core::expects(quads >= 6 && quads % 2 == 0 && quads <= complex::kMaxQuads,
                "a pseudo-double wheel has an even number of quads, 6 or more");
  std::vector<complex::QuadVertices> list;
  const auto rim = [quads](int i) { return static_cast<Vertex>(i % quads); };
  for (int i = 0; i < quads; i += 2) {
    const auto inside = static_cast<Vertex>(quads);
    const auto outside = static_cast<Vertex>(quads + 1);
    list.push_back({inside, rim(i), rim(i + 1), rim(i + 2)});
    list.push_back({outside, rim(i + 3), rim(i + 2), rim(i + 1)});
  }
  return planar_map_of(complex::Quadrangulation::from_quads(list).value());
}

}  // namespace hexatlas::quads
