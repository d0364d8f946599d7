#include "meshing/hexahedrize/peel.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/angles.hpp"
#include "enum/flips/facing.hpp"
#include "enum/flips/peeling.hpp"
#include "enum/flips/pillow.hpp"
#include "enum/flips/sharp_zones.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hexahedrize/angles.hpp"
#include "meshing/hexahedrize/linear.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "tables/fill/query.hpp"

namespace hexatlas::hexahedrize {
namespace {

using complex::QuadSphere;
using complex::VertexId;
using flips::Peeling;

/// Hexahedra per quad by which the linear construction fills a cavity, about.
constexpr std::size_t kPerQuad = 16;
/// And by which a table fills a small one.
constexpr std::size_t kPerSmallQuad = 2;
/// Zones that cost more for each of their quads are left alone.
constexpr double kZonePrice = 0.9 * static_cast<double>(kPerQuad);

/// The quads of one hexahedron.
constexpr std::size_t kSingle = 6;

/// A search by way of the table is worth while for so few quads.
constexpr bool is_small(std::size_t quads) {
  return quads <= static_cast<std::size_t>(flips::kMaxSearchQuads);
}

/// A peeling and the hexahedra that a mesh by way of it will have, about.
struct Stage {
  Peeling peeling;
  std::size_t layers = 0;

  void take_layer() {
    core::expects(flips::take_layer(peeling, peeling.live_quads()).has_value(),
                  "a layer below all quads is allowed");
    ++layers;
  }
  void take_layer(flips::Angles& angles) {
    core::expects(flips::take_layer(peeling, peeling.live_quads(), angles),
                  "a layer below all quads is allowed");
    ++layers;
  }
  [[nodiscard]] std::size_t expected() const {
    const std::size_t quads = peeling.quads();
    return peeling.taken().size() + quads * (is_small(quads) ? kPerSmallQuad : kPerQuad);
  }
};

/// With layers below the whole boundary.
Stage begun(const QuadSphere& sphere, std::size_t layers) {
  Stage stage{Peeling(sphere.quads, sphere.vertices()), 0};
  while (stage.layers < layers) stage.take_layer();
  return stage;
}

/// Sequences that grow in between are many, so they come last, when few quads are left.
void reduce_all(Peeling& peeling, flips::ReducingOptions options) {
  for (const bool may_grow : {false, true}) {
    options.may_grow = may_grow;
    do {
      flips::reduce(peeling, options);
    } while (flips::remove_zones(peeling, kZonePrice) > 0);
  }
}

/// Rounds of reductions with layers between them, until the cavity is small or no longer gets
/// smaller. Of all rounds the one that lets expect the fewest hexahedra.
Stage peeled(const QuadSphere& sphere, flips::ReducingOptions options, std::size_t layers,
             std::size_t seed) {
  options.seed = seed;
  Stage best = begun(sphere, layers);
  reduce_all(best.peeling, options);
  for (Stage now = best; !is_small(now.peeling.quads());) {
    const std::size_t before = now.peeling.quads();
    now.take_layer();
    reduce_all(now.peeling, options);
    if (now.expected() < best.expected()) best = now;
    if (now.peeling.quads() >= before) break;
  }
  return best;
}

/// Of a vertex of the peeling.
VertexId label_in(const QuadSphere& cavity, VertexId v) {
  return static_cast<VertexId>(std::lower_bound(cavity.point_of.begin(), cavity.point_of.end(), v) -
                               cavity.point_of.begin());
}

/// The cavity as a sphere of its own; point_of are the vertices of the peeling.
QuadSphere cavity_of(const Peeling& peeling) {
  QuadSphere result;
  result.quads = peeling.cavity();
  for (const auto& quad : result.quads)
    result.point_of.insert(result.point_of.end(), quad.begin(), quad.end());
  std::sort(result.point_of.begin(), result.point_of.end());
  result.point_of.erase(std::unique(result.point_of.begin(), result.point_of.end()),
                        result.point_of.end());
  for (auto& quad : result.quads)
    for (VertexId& v : quad) v = label_in(result, v);
  return result;
}

/// Pairs of vertices of the cavity that the hexahedra taken off relate, in canonical labels.
flips::Scars scars_of(const Peeling& peeling, const QuadSphere& cavity,
                      const complex::Quadrangulation& boundary, const canon::Labelling& label) {
  const flips::Relation quads = flips::relation_of_quads(boundary);
  flips::Scars result;
  for (std::size_t a = 0; a < cavity.vertices(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if ((quads[a] >> b & 1U) == 0 && peeling.are_related(cavity.point_of[a], cavity.point_of[b]))
        result.add(label[a], label[b]);
  return result;
}

/// A mesh of the cavity in its own vertices that fits the hexahedra taken off; nullopt if none
/// was found.
std::optional<complex::HexComplex> from_table(const Peeling& peeling, const QuadSphere& cavity,
                                              const format::Table& table, int threads) {
  if (!is_small(cavity.quads.size())) return std::nullopt;
  const complex::Quadrangulation boundary = small_form(cavity).value();
  const canon::CanonicalForm form = canon::canonical_form(boundary);
  auto mesh = fill::fill_through(
      table, form.code,
      {.threads = threads, .apart = scars_of(peeling, cavity, boundary, form.label)});
  if (!mesh) return std::nullopt;
  return carried_over(std::move(*mesh), form, cavity.vertices());
}

/// The hexahedra taken off and those of the cavity.
PeeledMesh joined(const Stage& stage, const QuadSphere& cavity, const complex::HexComplex& rest) {
  PeeledMesh result;
  result.mesh.hexahedra = stage.peeling.taken();
  result.mesh.vertices = stage.peeling.vertices();
  result.account = {.peeled = result.mesh.hexahedra.size(),
                    .layers = stage.layers,
                    .cavity = cavity.quads.size()};
  const auto on_cavity = static_cast<VertexId>(cavity.vertices());
  for (complex::Hexahedron cell : rest.hexahedra) {
    for (VertexId& v : cell)
      v = v < on_cavity ? cavity.point_of[v] : result.mesh.vertices + v - on_cavity;
    result.mesh.hexahedra.push_back(cell);
  }
  result.mesh.vertices += rest.vertices - on_cavity;
  return result;
}

/// The same with a rest that comes from the table; nullopt if none was found.
std::optional<PeeledMesh> joined_by_table(const Stage& stage, const format::Table& table,
                                          int threads) {
  const QuadSphere cavity = cavity_of(stage.peeling);
  const auto rest = from_table(stage.peeling, cavity, table, threads);
  if (!rest) return std::nullopt;
  PeeledMesh result = joined(stage, cavity, *rest);
  result.account.rest = Rest::table;
  return result;
}

PeeledMesh completed(Stage stage, const format::Table* table,
                     std::span<const format::Sector> sectors, int threads) {
  if (table != nullptr && is_small(stage.peeling.quads())) {
    if (auto result = joined_by_table(stage, *table, threads)) return *std::move(result);
    stage.take_layer();  // nothing is forbidden then
    if (auto result = joined_by_table(stage, *table, threads)) return *std::move(result);
  }
  const QuadSphere cavity = cavity_of(stage.peeling);
  const auto apart = [&](VertexId a, VertexId b) {
    return stage.peeling.are_related(cavity.point_of[a], cavity.point_of[b]);
  };
  LinearMesh linear = mesh_by_sectors(cavity, sectors, apart);
  PeeledMesh result = joined(stage, cavity, linear.mesh);
  result.used = std::move(linear.used);
  return result;
}

/// The hexahedra taken off and a rest that is one layer; nullopt if it breaks the strict rule.
std::optional<PeeledMesh> joined_as_layer(const Stage& stage,
                                          std::vector<complex::Hexahedron> layer) {
  const QuadSphere cavity = cavity_of(stage.peeling);
  complex::HexComplex rest{static_cast<VertexId>(cavity.vertices()), std::move(layer)};
  for (complex::Hexahedron& cell : rest.hexahedra)
    for (VertexId& v : cell) v = label_in(cavity, v);
  if (complex::validate(rest) || !complex::has_boundary(rest, cavity.quads)) return std::nullopt;
  PeeledMesh result = joined(stage, cavity, rest);
  result.account.rest = Rest::layer;
  return result;
}

struct SharpOrder {
  flips::ZoneOrder zones{};
  bool overhangs_first = false;
  /// Layers around recesses, and overhangs of any extent, before any other layer: that could end at
  /// the floor or the wall of one, which angles do not tell.
  bool recesses_first = false;
};

std::vector<SharpOrder> sharp_orders() {
  std::vector<SharpOrder> result;
  for (const bool recesses_first : {false, true})
    for (const bool overhangs_first : {false, true})
      for (const auto zones : {flips::ZoneOrder::cheapest, flips::ZoneOrder::largest})
        result.push_back({zones, overhangs_first, recesses_first});
  return result;
}

/// Sharp zones and overhangs, until there is neither; the layer that is left, if it is one.
std::optional<std::vector<complex::Hexahedron>> take_all_sharp(Peeling& peeling,
                                                               flips::Angles angles, int within,
                                                               const SharpOrder& order) {
  const auto remove = [&](const flips::SharpOptions& options) {
    return flips::remove_sharp_zones(peeling, angles, options) > 0;
  };
  const auto overhangs = [&] {
    return flips::take_overhangs(
        peeling, angles, order.recesses_first ? flips::Extent::any : flips::Extent::all_around);
  };
  if (order.overhangs_first) overhangs();
  for (std::size_t before = peeling.quads() + 1; peeling.quads() < before;) {
    before = peeling.quads();
    for (const int at_most : {flips::kRightAtRim, flips::kSharpAtRim, within}) {
      const int now = std::min(at_most, within);
      if (order.recesses_first) {
        // Each takes hexahedra off, overhangs without new vertices: it ends.
        while (remove({now, order.zones, flips::Rims::several}) || overhangs() ||
               remove({now, order.zones, flips::Rims::one, true})) {
        }
      } else {
        remove({now, order.zones});
      }
      if (auto layer = flips::single_layer(peeling, angles)) return layer;
    }
    overhangs();
  }
  return std::nullopt;
}

/// With all zones that are left removed; nullopt if too much is left then.
std::optional<PeeledMesh> completed_by_zones(Stage stage, const format::Table& table,
                                             const PeelOptions& options) {
  if (!is_small(flips::self_crossings(stage.peeling))) return std::nullopt;
  flips::remove_zones(stage.peeling, std::numeric_limits<double>::infinity());
  return joined_by_table(stage, table, options.threads);
}

std::size_t tries_for(std::size_t quads, const PeelOptions& options) {
  if (options.tries > 0) return options.tries;
  return std::clamp<std::size_t>(20'000 / quads, 1, 50);
}

/// Those of all tries that let expect the fewest hexahedra, few enough to complete each.
std::vector<Stage> best_stages(const QuadSphere& sphere, const PeelOptions& options) {
  constexpr std::size_t kCompleted = 3;
  const std::size_t tries = tries_for(sphere.quads.size(), options);
  const auto at_once = static_cast<std::size_t>(options.threads);
  std::vector<Stage> best;
  for (std::size_t first = 0; first < tries; first += at_once) {
    std::vector<std::optional<Stage>> made(std::min(at_once, tries - first));
    parallel::parallel_for(options.threads, made.size(), [&](std::size_t i) {
      made[i] = peeled(sphere, options.reducing, options.layers, first + i);
    });
    for (std::optional<Stage>& stage : made) best.push_back(*std::move(stage));
    std::stable_sort(best.begin(), best.end(),
                     [](const Stage& a, const Stage& b) { return a.expected() < b.expected(); });
    if (best.size() > kCompleted) best.erase(best.begin() + kCompleted, best.end());
  }
  return best;
}

}  // namespace

std::optional<PeeledMesh> mesh_by_zones(const QuadSphere& sphere, const format::Table& table,
                                        const PeelOptions& options) {
  return completed_by_zones(begun(sphere, options.layers), table, options);
}

void meshes_by_sharp_zones(const QuadSphere& sphere, std::span<const mesh::Point> points,
                           const format::Table& table, const PeelOptions& options, int within,
                           const std::function<bool(const PeeledMesh&)>& is_enough) {
  Stage stage = begun(sphere, 0);
  flips::Angles angles = interior_angles(stage.peeling, points);
  while (stage.layers < options.layers) stage.take_layer(angles);
  const std::size_t in_layers = stage.peeling.taken().size();
  std::optional<Stage> first;
  bool is_any = false;
  for (const SharpOrder& order : sharp_orders()) {
    Stage now = stage;
    auto layer = take_all_sharp(now.peeling, angles, within, order);
    std::optional<PeeledMesh> mesh;
    if (now.peeling.quads() == kSingle)
      mesh = joined_by_table(now, table, options.threads);
    else if (layer)
      mesh = joined_as_layer(now, *std::move(layer));
    if (mesh && is_enough(*mesh)) return;
    is_any = is_any || mesh;
    if (!first) first = std::move(now);
  }
  if (is_any || first->peeling.taken().size() == in_layers) return;
  if (const auto mesh = completed_by_zones(*std::move(first), table, options)) is_enough(*mesh);
}

PeeledMesh mesh_by_peeling(const QuadSphere& sphere, const format::Table* table,
                           std::span<const format::Sector> sectors, const PeelOptions& options) {
  std::vector<Stage> stages = best_stages(sphere, options);
  if (options.layers == 0 && is_small(sphere.quads.size())) stages.push_back(begun(sphere, 0));
  std::optional<PeeledMesh> best;
  for (Stage& stage : stages) {
    PeeledMesh mesh = completed(std::move(stage), table, sectors, options.threads);
    if (!best || mesh.mesh.hexahedra.size() < best->mesh.hexahedra.size()) best = std::move(mesh);
  }
  return *std::move(best);
}

}  // namespace hexatlas::hexahedrize
