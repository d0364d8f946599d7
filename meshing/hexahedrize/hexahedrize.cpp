#include "meshing/hexahedrize/hexahedrize.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/angles.hpp"
#include "meshing/hexahedrize/linear.hpp"
#include "meshing/hexahedrize/placing.hpp"
#include "meshing/hexahedrize/sides.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "meshing/quality/report.hpp"
#include "tables/fill/filled.hpp"

namespace hexatlas::hexahedrize {
namespace {

using complex::QuadSphere;
using mesh::Point;

/// Of the volume that the surface encloses.
exact::Sign sign_within(const QuadSphere& sphere, const std::vector<Point>& points) {
  std::vector<std::array<Point, 4>> quads(sphere.quads.size());
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) quads[q][i] = points[sphere.point_of[sphere.quads[q][i]]];
  return sign_of_volume(quads);
}

void turn_over(QuadSphere& sphere) {
  for (auto& quad : sphere.quads) std::swap(quad[1], quad[3]);
}

Hexahedrized with_coordinates(const complex::HexComplex& cells, const QuadSphere& sphere,
                              const std::vector<Point>& points, const Placing& placing) {
  Hexahedrized result;
  result.interior_vertices = cells.vertices - sphere.vertices();
  result.mesh.points = points;
  result.mesh.points.resize(points.size() + result.interior_vertices);
  const auto point_of = [&](complex::VertexId v) {
    return v < sphere.vertices() ? sphere.point_of[v]
                                 : static_cast<mesh::Index>(points.size() + v - sphere.vertices());
  };
  for (auto cell : cells.hexahedra) {
    std::transform(cell.begin(), cell.end(), cell.begin(), point_of);
    result.mesh.hexahedra.push_back(cell);
  }
  const int usual = result.mesh.hexahedra.size() <= kSmallMesh ? untangle::kDefaultEffort : 0;
  place_in_a_frame(result.mesh, points.size(),
                   {.effort = placing.effort.value_or(usual), .threads = placing.threads});
  return result;
}

SurfaceNotes turned_outwards(QuadSphere& sphere, const mesh::SurfaceMesh& surface,
                             const std::string& file) {
  const exact::Sign volume = sign_within(sphere, surface.points);
  const bool is_tie = 2 * sphere.reversed == sphere.quads.size();
  if (is_tie && volume == exact::Sign::zero)
    throw core::InvalidInput(file,
                             "half of the quads are oriented against the other half, and no volume "
                             "is enclosed that would tell which half is right");
  const bool faces_inwards = volume == exact::Sign::negative;
  if (faces_inwards) turn_over(sphere);
  return {sphere.unused_points, sphere.reversed, faces_inwards && !is_tie};
}

std::optional<complex::HexComplex> from_table(const format::Table* table,
                                              const canon::CanonicalForm& form,
                                              const QuadSphere& sphere) {
  const auto ordinal = table == nullptr ? std::nullopt : table->find(form.code);
  if (!ordinal) return std::nullopt;
  return carried_over(fill::mesh_in(*table, *ordinal, table->path()), form, sphere.vertices());
}

/// Of `used`, how often each of the sectors was used for so many quads.
ConstructionAccount account_of(const std::vector<std::size_t>& used, std::size_t quads,
                               std::span<const format::Sector> sectors) {
  ConstructionAccount account;
  for (std::size_t i = 0; i < used.size(); ++i)
    account.sectors.push_back({sectors[i].mesh.hexahedra.size(), used[i]});
  account.hexahedra_bound = hexahedra_bound(quads, sectors);
  return account;
}

}  // namespace

QuadSphere sphere_of(const mesh::SurfaceMesh& surface, const std::string& file) {
  auto result = complex::sphere_of(surface.quads, surface.points.size());
  if (const auto* law = std::get_if<complex::BrokenLaw>(&result)) {
    const bool has_line = law->cell && *law->cell < surface.quad_line.size();
    // A law broken at a quad names points; formats differ in the number of the first one.
    throw core::InvalidInput(file, has_line ? surface.quad_line[*law->cell] : 0,
                             law->reason + (law->cell ? " (points counted from 0)" : ""));
  }
  return std::get<QuadSphere>(std::move(result));
}

namespace {

/// The table's mesh and its code, if it has one.
std::optional<Hexahedrized> by_table(const QuadSphere& sphere, const mesh::SurfaceMesh& surface,
                                     const format::Table* table, const Placing& placing,
                                     std::string& code) {
  const auto boundary = small_form(sphere);
  if (!boundary) return std::nullopt;
  const canon::CanonicalForm form = canon::canonical_form(*boundary);
  code = canon::to_text(form.code);
  const auto cells = from_table(table, form, sphere);
  if (!cells) return std::nullopt;
  Hexahedrized made = with_coordinates(*cells, sphere, surface.points, placing);
  made.code = code;
  return made;
}

Hexahedrized with_account(const PeeledMesh& peeled, Method method, const QuadSphere& sphere,
                          const mesh::SurfaceMesh& surface, const Placing& placing) {
  Hexahedrized made = with_coordinates(peeled.mesh, sphere, surface.points, placing);
  made.method = method;
  made.peeling = peeled.account;
  return made;
}

Hexahedrized by_flips(const QuadSphere& sphere, const mesh::SurfaceMesh& surface,
                      const Means& means, const Placing& placing) {
  const PeeledMesh peeled = mesh_by_peeling(sphere, means.table, means.sectors, means.peeling);
  Hexahedrized made = with_account(peeled, Method::flips, sphere, surface, placing);
  if (peeled.account.rest == Rest::sectors)
    made.construction = account_of(peeled.used, peeled.account.cavity, means.sectors);
  return made;
}

/// Hexahedra with a scaled Jacobian below are poor; a layer that makes the least one so many times
/// as great is worth its hexahedra.
constexpr double kPoor = 0.2, kWorthALayer = 2;

/// A mesh, how many of its hexahedra are not proven valid, and its least scaled Jacobian.
struct Judged {
  explicit Judged(Hexahedrized of) : made(std::move(of)) {
    const quality::Report report = quality::report(made.mesh);
    not_valid = report.cells - report.valid;
    least = report.min_scaled_jacobian;
  }
  Hexahedrized made;
  std::size_t not_valid = 0;
  double least = 0;
};

/// In order: a later one counts if it has fewer hexahedra that are not valid; or as many and a
/// least scaled Jacobian that is positive and more than `times` that of the former, if given.
void keep_better(std::optional<Judged>& best, Hexahedrized other,
                 std::optional<double> times = {}) {
  Judged judged(std::move(other));
  const bool is_better = !best || judged.not_valid < best->not_valid ||
                         (times && judged.not_valid == best->not_valid &&
                          judged.least > std::max(0.0, *times * best->least));
  if (is_better) best = std::move(judged);
}

/// What meshes that are the same have in common, and others hardly: hexahedra, vertices, and the
/// hexahedra at each vertex of the boundary.
using Outline = std::vector<std::size_t>;

Outline outline_of(const complex::HexComplex& cells, const QuadSphere& sphere) {
  Outline outline(sphere.vertices() + 2, 0);
  for (const complex::Hexahedron& cell : cells.hexahedra)
    for (const complex::VertexId v : cell)
      if (v < sphere.vertices()) ++outline[v];
  outline[sphere.vertices()] = cells.hexahedra.size();
  outline.back() = cells.vertices;
  return outline;
}

/// Sharp zones first. Others, which go by their number of hexahedra, where these leave hexahedra
/// that are not valid: zones of a body with a gap go through the gap. Where the boundary is smooth
/// either have hexahedra with two sides nearly in one plane: unless a number of layers is asked
/// for, all is made with one layer as well then.
void by_zones(std::optional<Judged>& best, const QuadSphere& sphere,
              const mesh::SurfaceMesh& surface, const Means& means, const Placing& placing) {
  std::vector<Point> points;
  for (const mesh::Index p : sphere.point_of) points.push_back(surface.points[p]);
  PeelOptions options = means.peeling;
  std::optional<double> times;
  std::set<Outline> made;
  const auto keep = [&](const PeeledMesh& peeled) {
    if (made.insert(outline_of(peeled.mesh, sphere)).second)
      keep_better(best, with_account(peeled, Method::zones, sphere, surface, placing), times);
    return best->not_valid == 0;
  };
  const auto keep_by_number = [&] {
    if (const auto peeled = mesh_by_zones(sphere, *means.table, options)) keep(*peeled);
  };
  const auto keep_sharp = [&](int within) {
    meshes_by_sharp_zones(sphere, points, *means.table, options, within, keep);
  };
  const auto is_valid = [&] { return best && best->not_valid == 0; };
  keep_sharp(flips::kSharpAtRim);
  if (!is_valid()) keep_by_number();
  if (!is_valid()) keep_sharp(flips::kLeastAtRim);
  const bool is_by_zones = best && best->made.method == Method::zones;
  if (!is_by_zones || best->least >= kPoor || options.layers > 0) return;
  options.layers = 1;
  times = kWorthALayer;
  keep_sharp(flips::kSharpAtRim);
  keep_by_number();
}

/// By the first of the methods allowed that can; where hexahedra are not valid then, by zones if
/// these leave fewer, and what the table lacks by flips if these leave fewer still.
std::variant<Hexahedrized, Impossible, NotInTable> meshed(const QuadSphere& sphere,
                                                          const mesh::SurfaceMesh& surface,
                                                          const Means& means,
                                                          const Placing& placing) {
  const auto may = [&](Method method) {
    if (means.only) return *means.only == method;
    return means.peeling.layers == 0 || method == Method::zones || method == Method::flips;
  };
  const auto is_done = [&](const std::optional<Judged>& best) {
    return best && (means.only || best->not_valid == 0);
  };
  std::string code;
  std::optional<Judged> best;
  if (may(Method::table))
    if (auto made = by_table(sphere, surface, means.table, placing, code))
      best.emplace(*std::move(made));
  const bool is_in_table = best.has_value();
  if (!is_done(best) && may(Method::zones) && means.table != nullptr)
    by_zones(best, sphere, surface, means, placing);
  if (!is_in_table && !is_done(best) && may(Method::flips)) {
    Hexahedrized flips = by_flips(sphere, surface, means, placing);
    if (!best) return flips;
    keep_better(best, std::move(flips));
  }
  if (best) return std::move(best->made);
  if (!may(Method::construction)) return NotInTable{sphere.quads.size(), code};
  const LinearMesh linear = mesh_by_sectors(sphere, means.sectors);
  Hexahedrized made = with_coordinates(linear.mesh, sphere, surface.points, placing);
  made.method = Method::construction;
  made.construction = account_of(linear.used, sphere.quads.size(), means.sectors);
  return made;
}

}  // namespace

Answer hexahedrize(const mesh::SurfaceMesh& surface, const Means& means, const std::string& file,
                   const Placing& placing) {
  core::expects(means.table != nullptr || !means.sectors.empty(), "a table or sectors are given");
  QuadSphere sphere = sphere_of(surface, file);
  Answer answer;
  answer.notes = turned_outwards(sphere, surface, file);
  if (auto reason = complex::reason_against_filling(sphere)) {
    answer.outcome = Impossible{*std::move(reason)};
    return answer;
  }
  answer.outcome = meshed(sphere, surface, means, placing);
  return answer;
}

}  // namespace hexatlas::hexahedrize
