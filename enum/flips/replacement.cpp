#include "enum/flips/replacement.hpp"

#include <algorithm>
#include <array>

#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/exchange.hpp"

namespace hexatlas::flips {
namespace {

using core::Random;

using complex::Hexahedron;
using complex::HexComplex;
using complex::Vertex;
using complex::VertexId;

/// A ball of the beam that may replace the sub-ball: the least one, if it has fewer hexahedra, or
/// any one with at most `most`. Of several the one at place `turn` modulo their number.
std::optional<Fit> fit(const SubBall& ball, const Beam& balls, int most, std::uint64_t turn) {
  const int size = static_cast<int>(ball.cells().size());
  const complex::Quadrangulation& boundary = ball.front().boundary;
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  const auto number = balls.store().find(flags.code);
  if (!number) return std::nullopt;
  const FrontStore::Family& family = balls.store().family(*number);
  if (family.level_floor + 1 > most) return std::nullopt;
  const auto& known = family.fronts;
  std::vector<Fit> fits;
  for (const Position& position : positions_of(boundary, flags, ball.related_outside()))
    for (std::uint32_t place = 0; place < known.size(); ++place) {
      const int hexahedra = known[place].level + 1;
      if (hexahedra > most || !known[place].scars.is_disjoint_from(position.scars)) continue;
      if (hexahedra < std::min(size, most)) {
        fits.clear();
        most = hexahedra;
      }
      fits.push_back({{*number, place}, position.label, position.is_mirrored});
    }
  if (fits.empty()) return std::nullopt;
  return fits[turn % fits.size()];
}

/// A mesh and who meets whom in it.
struct WorkedMesh {
  HexComplex mesh;
  SubBall::Neighbours neighbours = SubBall::neighbours_of(mesh);

  [[nodiscard]] SubBall ball_somewhere(Random& random, int max_quads) const {
    return {mesh, neighbours, static_cast<std::uint32_t>(random.below(mesh.hexahedra.size())),
            max_quads};
  }
};

/// The same mesh with its hexahedra in an order in which they can be taken off, with boundaries of
/// at most kMaxStateQuads quads; found by growing, from the last one on.
std::optional<HexComplex> in_shelling_order(const WorkedMesh& worked, int tries, Random& random) {
  for (int attempt = 0; attempt < tries; ++attempt) {
    SubBall ball = worked.ball_somewhere(random, kMaxStateQuads);
    while (ball.grow_somewhere(random)) {
    }
    if (ball.cells().size() < worked.mesh.hexahedra.size()) continue;
    HexComplex result{worked.mesh.vertices, {}};
    for (const std::uint32_t cell : ball.cells())
      result.hexahedra.push_back(worked.mesh.hexahedra[cell]);
    std::reverse(result.hexahedra.begin(), result.hexahedra.end());
    return result;
  }
  return std::nullopt;
}

/// Grows one ball and makes the first exchange that helps; otherwise, where it can, one that
/// adds at most so many hexahedra.
std::optional<HexComplex> exchanged_somewhere(const WorkedMesh& worked, int quads,
                                              const Beam& balls, bool keep_shellable, int more,
                                              Random& random) {
  constexpr int kTries = 10;
  const HexComplex& mesh = worked.mesh;
  SubBall ball = worked.ball_somewhere(random, widest_on_the_way(balls));
  std::optional<HexComplex> sideways;
  while (ball.grow_somewhere(random)) {
    const int size = static_cast<int>(ball.cells().size());
    const bool may_go_sideways = !sideways && random.below(8) == 0;
    const auto found = fit(ball, balls, may_go_sideways ? size + more : size - 1, random.number());
    if (!found) continue;
    const Layers layers = layers_along(balls, found->ball, Growth::outward);
    std::optional<HexComplex> made = compacted(exchanged(mesh, ball, layers, *found), quads + 2);
    if (keep_shellable) made = in_shelling_order({*std::move(made)}, kTries, random);
    if (!made) continue;
    if (made->hexahedra.size() < mesh.hexahedra.size()) return made;
    sideways = std::move(made);
  }
  return sideways;
}

/// How many hexahedra an exchange may add where `room` is left: mostly none.
int climb(int room, Random& random) {
  const std::size_t draw = random.below(8);
  return std::min(room, draw == 0 ? 2 : draw == 1 ? 1 : 0);
}

constexpr bool has(FacetSet set, unsigned facet) noexcept { return (set.bits >> facet & 1U) != 0; }

/// The facet other than `bottom` that contains both ends of an edge of it.
unsigned side_at(unsigned bottom, unsigned u, unsigned v) noexcept {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned facet = 2 * axis + (u >> axis & 1U);
    if ((u >> axis & 1U) == (v >> axis & 1U) && facet != bottom) return facet;
  }
  return bottom;
}

/// A flip that glues on a certain hexahedron, and the corners of it (enum/cells/cube.hpp) on its
/// top.
struct PlacedFlip {
  Flip flip;
  std::array<cells::CubeVertex, 4> top{};
};

/// The flip that glues a hexahedron on: `corner` has the boundary vertices at its corners,
/// kNewVertex at those not on the boundary; `patch` its facets on the boundary. nullopt if these
/// are no patch of `boundary`. Requires that no two quads of `boundary` have the same vertices.
std::optional<PlacedFlip> flip_of(const complex::Quadrangulation& boundary,
                                  const std::array<Vertex, 8>& corner, FacetSet patch) {
  if (!kind_of(patch)) return std::nullopt;
  unsigned bottom = 0;  // a patch has a facet whose opposite one it does not have
  while (!has(patch, bottom) || has(patch, bottom ^ 1U)) ++bottom;
  VertexSet wanted = 0;
  for (const cells::CubeVertex c : cells::kFacetVertices[bottom]) {
    if (corner[c] == kNewVertex) return std::nullopt;
    wanted |= bit(corner[c]);
  }
  for (int q = 0; q < boundary.quads(); ++q) {
    const complex::QuadVertices b = boundary.vertices_of(q);
    if (set_of(b) != wanted) continue;
    PlacedFlip placed{{static_cast<complex::Quad>(q), 0}};
    std::array<cells::CubeVertex, 4> foot{};  // of the bottom, in the order of its quad
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = std::find(corner.begin(), corner.end(), b[i]) - corner.begin();
      foot[i] = static_cast<cells::CubeVertex>(at);
      placed.top[i] = static_cast<cells::CubeVertex>(foot[i] ^ 1U << bottom / 2);
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (has(patch, side_at(bottom, foot[i], foot[(i + 1) % 4])))
        placed.flip.sides = static_cast<std::uint8_t>(placed.flip.sides | 1U << i);
    return placed;
  }
  return std::nullopt;
}

/// The facets of a hexahedron that are quads of the boundary.
FacetSet facets_on(const complex::Quadrangulation& boundary, const std::array<Vertex, 8>& corner) {
  std::vector<VertexSet> quads;
  quads.reserve(static_cast<std::size_t>(boundary.quads()));
  for (int q = 0; q < boundary.quads(); ++q) quads.push_back(set_of(boundary.vertices_of(q)));
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
  WorkedMesh current{mesh};
  std::optional<HexComplex> best;
  std::size_t least = mesh.hexahedra.size();
  int last = 0;  // growth that gave the best one, or that began with it again
  for (int growth = 0; growth < options.growths; ++growth) {
    const int room = static_cast<int>(least + options.uphill - current.mesh.hexahedra.size());
    const int more = options.uphill > 0 ? climb(room, random) : 0;
    auto next = exchanged_somewhere(current, quads, balls, options.keep_shellable, more, random);
    if (!next) continue;
    current = WorkedMesh{*std::move(next)};
    if (current.mesh.hexahedra.size() < least) {
      least = current.mesh.hexahedra.size();
      best = current.mesh;
      last = growth;
    } else if (options.uphill > 0 && growth - last > options.growths / 4) {
      current = WorkedMesh{best ? *best : mesh};
      last = growth;
    }
  }
  return best;
}

std::optional<HexComplex> in_shelling_order(const HexComplex& mesh, int tries, std::uint64_t seed) {
  Random random(seed);
  return in_shelling_order(WorkedMesh{mesh}, tries, random);
}

int widest_boundary(const HexComplex& mesh) {
  const std::vector<complex::Facet> facets = complex::sorted_facets(mesh);
  std::vector<int> consumed(mesh.hexahedra.size(), 0);  // quads that taking it off consumes
  int quads = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const bool is_inner = i + 1 < facets.size() && facets[i].key == facets[i + 1].key;
    if (!is_inner) ++quads;
    if (is_inner) ++i;  // on the boundary once the first of the two has been taken off
    ++consumed[facets[i].cell];
  }
  int widest = quads;
  for (std::size_t cell = 0; cell + 1 < consumed.size(); ++cell) {
    quads += 6 - 2 * consumed[cell];
    widest = std::max(widest, quads);
  }
  return widest;
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
