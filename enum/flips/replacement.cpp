#include "enum/flips/replacement.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::Hexahedron;
using complex::HexComplex;
using complex::Vertex;
using complex::VertexId;

/// A ball of the beam that fits in place of a sub-ball, and how it is turned.
struct Fit {
  FrontId ball;
  canon::Labelling label{};  ///< canonical label of each boundary vertex of the sub-ball
  bool is_mirrored = false;
};

Scars scars_under(const Relation& related, const Relation& quads, int vertices,
                  const canon::Labelling& label) {
  Scars scars;
  for (int v = 0; v < vertices; ++v) {
    const auto a = static_cast<Vertex>(v);
    VertexSet later = related[a] & ~quads[a] & ~(bit(a) - 1);
    for (; later != 0; later &= later - 1)
      scars.add(label[a], label[static_cast<std::size_t>(std::countr_zero(later))]);
  }
  return scars;
}

/// The least ball of the beam that may replace the sub-ball, with at most `most` hexahedra;
/// of equal ones the one at place `turn` modulo their number.
std::optional<Fit> fit(const SubBall& ball, const Beam& balls, int most, std::uint64_t turn) {
  const complex::Quadrangulation& boundary = ball.front().boundary;
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  const auto number = balls.store().find(flags.code);
  if (!number) return std::nullopt;
  const auto& known = balls.store().family(*number).fronts;
  if (std::none_of(known.begin(), known.end(),
                   [&](const StoredFront& f) { return f.level + 1 <= most; }))
    return std::nullopt;
  const Relation quads = relation_of_quads(boundary);
  const Relation outside = ball.related_outside();
  std::vector<Fit> fits;
  for (int i = 0; i < flags.count; ++i) {
    const canon::Flag flag = flags.flags[static_cast<std::size_t>(i)];
    const canon::Labelling label = canon::labelling_from(boundary, flag);
    const Scars scars = scars_under(outside, quads, boundary.vertices(), label);
    for (std::uint32_t place = 0; place < known.size(); ++place) {
      const int hexahedra = known[place].level + 1;
      if (hexahedra > most || !known[place].scars.is_disjoint_from(scars)) continue;
      if (hexahedra < most) fits.clear();
      most = hexahedra;
      fits.push_back({{*number, place}, label, flag.mirrored});
    }
  }
  if (fits.empty()) return std::nullopt;
  return fits[turn % fits.size()];
}

/// The mesh with the sub-ball exchanged; vertices not numbered without gaps yet.
HexComplex exchanged(const HexComplex& mesh, const SubBall& ball, const Beam& balls,
                     const Fit& found) {
  const Layers layers = layers_along(balls, found.ball, Growth::outward);
  constexpr VertexId kInterior = 0xFFFFFFFF;
  std::vector<VertexId> number(layers.vertices, kInterior);
  for (int v = 0; v < ball.front().boundary.vertices(); ++v) {
    const auto own = static_cast<Vertex>(v);
    number[layers.rim[found.label[own]]] = ball.rim(own);
  }
  HexComplex result{mesh.vertices, {}};
  for (VertexId& n : number)
    if (n == kInterior) n = result.vertices++;
  for (std::uint32_t cell = 0; cell < mesh.hexahedra.size(); ++cell)
    if (!ball.contains(cell)) result.hexahedra.push_back(mesh.hexahedra[cell]);
  for (Hexahedron moved : layers.hexahedra) {
    for (VertexId& v : moved) v = number[v];
    if (layers.is_mirrored != found.is_mirrored) cells::exchange_axes(moved);
    result.hexahedra.push_back(moved);
  }
  return result;
}

/// Takes out vertex numbers that no hexahedron has; the boundary's stay.
HexComplex compacted(HexComplex mesh, int boundary_vertices) {
  constexpr VertexId kUnset = 0xFFFFFFFF;
  std::vector<VertexId> number(mesh.vertices, kUnset);
  std::iota(number.begin(), number.begin() + boundary_vertices, 0U);
  auto next = static_cast<VertexId>(boundary_vertices);
  for (Hexahedron& cell : mesh.hexahedra)
    for (VertexId& v : cell) {
      if (number[v] == kUnset) number[v] = next++;
      v = number[v];
    }
  mesh.vertices = next;
  return mesh;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] std::uint64_t number() { return engine_(); }
  [[nodiscard]] std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

 private:
  std::mt19937_64 engine_;
};

/// A hexahedron to grow by: of a few candidates at random the one with the most facets on the ball,
/// which keeps the boundary short. kOutside: none was found.
bool grow_somewhere(SubBall& ball, const SubBall::Neighbours& neighbours, Random& random) {
  std::vector<std::pair<int, std::uint32_t>> candidates;
  for (const std::uint32_t cell : ball.cells())
    for (const std::uint32_t other : neighbours[cell])
      if (other != SubBall::kOutside && !ball.contains(other)) {
        const int shared = static_cast<int>(
            std::count_if(neighbours[other].begin(), neighbours[other].end(),
                          [&](auto n) { return n != SubBall::kOutside && ball.contains(n); }));
        candidates.emplace_back(4 * shared + static_cast<int>(random.below(6)), other);
      }
  std::sort(candidates.rbegin(), candidates.rend());
  return std::any_of(candidates.begin(), candidates.end(),
                     [&](const auto& candidate) { return ball.grow(candidate.second); });
}

/// The same mesh with its hexahedra in an order in which they can be taken off, with boundaries of
/// at most kMaxSearchQuads quads; found by growing, from the last one on.
std::optional<HexComplex> in_shelling_order(const HexComplex& mesh, Random& random) {
  constexpr int kTries = 10;
  const SubBall::Neighbours neighbours = SubBall::neighbours_of(mesh);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    SubBall ball(mesh, neighbours, static_cast<std::uint32_t>(random.below(mesh.hexahedra.size())));
    while (grow_somewhere(ball, neighbours, random)) {
    }
    if (ball.cells().size() < mesh.hexahedra.size()) continue;
    HexComplex result{mesh.vertices, {}};
    for (const std::uint32_t cell : ball.cells()) result.hexahedra.push_back(mesh.hexahedra[cell]);
    std::reverse(result.hexahedra.begin(), result.hexahedra.end());
    return result;
  }
  return std::nullopt;
}

/// Grows one ball and makes the first exchange that helps; otherwise, where it can, one that
/// changes nothing in number.
std::optional<HexComplex> exchanged_somewhere(const HexComplex& mesh, int quads, const Beam& balls,
                                              Random& random) {
  const SubBall::Neighbours neighbours = SubBall::neighbours_of(mesh);
  SubBall ball(mesh, neighbours, static_cast<std::uint32_t>(random.below(mesh.hexahedra.size())));
  std::optional<HexComplex> sideways;
  while (grow_somewhere(ball, neighbours, random)) {
    const int size = static_cast<int>(ball.cells().size());
    const bool may_go_sideways = !sideways && random.below(8) == 0;
    const auto found = fit(ball, balls, may_go_sideways ? size : size - 1, random.number());
    if (!found) continue;
    auto made =
        in_shelling_order(compacted(exchanged(mesh, ball, balls, *found), quads + 2), random);
    if (!made) continue;
    if (made->hexahedra.size() < mesh.hexahedra.size()) return made;
    sideways = std::move(made);
  }
  return sideways;
}

/// The facets of a hexahedron that are quads of the boundary.
FacetSet facets_on(const complex::Quadrangulation& boundary, const std::array<Vertex, 8>& corner) {
  std::vector<VertexSet> quads;
  for (int q = 0; q < boundary.quads(); ++q) {
    const complex::QuadVertices v = boundary.vertices_of(q);
    quads.push_back(bit(v[0]) | bit(v[1]) | bit(v[2]) | bit(v[3]));
  }
  FacetSet result;
  for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
    VertexSet facet = 0;
    for (const cells::CubeVertex c : cells::kFacetVertices[f])
      if (corner[c] != kNewVertex) facet |= bit(corner[c]);
    if (std::find(quads.begin(), quads.end(), facet) != quads.end())
      result.bits = static_cast<std::uint8_t>(result.bits | 1U << f);
  }
  return result;
}

}  // namespace

std::optional<HexComplex> smaller_by_replacement(const HexComplex& mesh, int quads,
                                                 const Beam& balls,
                                                 const ReplacementOptions& options) {
  Random random(options.seed);
  HexComplex current = mesh;
  std::optional<HexComplex> best;
  for (int growth = 0; growth < options.growths; ++growth) {
    auto next = exchanged_somewhere(current, quads, balls, random);
    if (!next) continue;
    current = std::move(*next);
    const std::size_t least = best ? best->hexahedra.size() : mesh.hexahedra.size();
    if (current.hexahedra.size() < least) best = current;
  }
  return best;
}

FrontId add_ball(Beam& balls, const HexComplex& mesh, FrontOrigin origin) {
  const CanonicalState single = canonical_state(single_hexahedron());
  FrontId id{balls.store().find(single.state.code).value(), 0};
  core::expects(balls.level_of(id) == 0, "the beam grew from the single hexahedron");
  std::vector<VertexId> rim(8);
  for (std::size_t corner = 0; corner < 8; ++corner)
    rim[single.label[corner]] = mesh.hexahedra.back()[corner];
  for (std::size_t i = mesh.hexahedra.size() - 1; i-- > 0;) {
    const complex::Quadrangulation boundary = canon::decode(balls.state(id).code).value();
    const Hexahedron& cell = mesh.hexahedra[i];
    std::array<Vertex, 8> corner{};
    for (std::size_t c = 0; c < 8; ++c) {
      const auto at = std::find(rim.begin(), rim.end(), cell[c]);
      corner[c] = at == rim.end() ? kNewVertex : static_cast<Vertex>(at - rim.begin());
    }
    const auto placed = flip_of(boundary, corner, facets_on(boundary, corner));
    core::expects(placed.has_value(), "the hexahedra can be taken off in the order given");
    const auto prism = prism_of(boundary, placed->flip);
    core::expects(prism.has_value(), "the hexahedra can be taken off in the order given");
    const Flipped made = flipped(boundary, placed->flip, *prism);
    canon::Labelling label{};
    id = balls.add(id, placed->flip, origin, label);
    std::vector<VertexId> next(static_cast<std::size_t>(made.quadrangulation.vertices()));
    for (std::size_t v = 0; v < next.size(); ++v)
      if (made.former[v] != kNewVertex) next[label[v]] = rim[made.former[v]];
    for (std::size_t t = 0; t < 4; ++t) next[label[made.top[t]]] = cell[placed->top[t]];
    rim = std::move(next);
  }
  return id;
}

}  // namespace hexatlas::flips
