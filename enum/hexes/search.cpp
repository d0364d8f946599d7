#include "enum/hexes/search.hpp"

#include <algorithm>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"
#include "enum/hexes/partners.hpp"

namespace hexatlas::hexes {

int most_interior_vertices(int boundary_quads, int hexahedra) noexcept {
  return std::max(0, 2 * hexahedra + 1 - boundary_quads / 2);
}

HexSearch::HexSearch(const complex::Quadrangulation& boundary, const SearchLimits& limits,
                     Prunings prunings)
    : limits_(limits),
      prunings_(prunings),
      mesh_(boundary, boundary.vertices() + limits.max_interior, limits.ball) {
  core::expects(limits.max_hexahedra >= 0 && limits.max_hexahedra <= kMaxHexahedra,
                "a search has at most 64 hexahedra");
  if (!open_level()) levels_.push_back({});
  if (limits.up_to_symmetry && first_quad() >= 0) symmetry_.emplace(boundary, first_quad());
}

/// By the last hexahedron alone.
bool HexSearch::is_refuted_by_last() {
  if (mesh_.cells().empty()) return false;
  if (limits_.ball && prunings_.links && closes_badly(mesh_)) return refute(Refutation::Rule::link);
  return symmetry_ &&
         !symmetry_->has_no_lesser_image(
             mesh_.cells().back(), mesh_,
             type_on_bottom(mesh_.cells().front(), mesh_.boundary_vertices())) &&
         refute(Refutation::Rule::symmetry);
}

/// Requires open facets. Otherwise says which vertices are saturated, also to the mesh.
bool HexSearch::is_refuted_by_partners(Level& level) {
  if (!limits_.ball || !prunings_.partners) return false;
  const Partners partners = partners_of(mesh_, mesh_.saturated());
  if (partners.are_too_few) return refute(Refutation::Rule::partners);
  level.saturated = partners.saturated;
  mesh_.saturate(level.saturated);
  return false;
}

/// Requires open facets. Otherwise says how many vertices the next hexahedron may bring.
bool HexSearch::is_refuted_by_budgets(int left, Level& level) {
  if ((prunings_.face_budget || left == 0) && exceeds_face_budget(mesh_, left))
    return refute(Refutation::Rule::face_budget);
  open_.list(mesh_);
  level.new_vertices = mesh_.vertices_left();
  if (!prunings_.corner_budget) return false;
  const int within = new_vertices_within(mesh_, open_, left, prunings_.ears);
  level.new_vertices = std::min(level.new_vertices, within);
  return within < 0 && refute(Refutation::Rule::corner_budget);
}

/// Chooses where the next hexahedron goes. False if no mesh within the limits follows.
bool HexSearch::open_level() {
  if (is_refuted_by_last()) return false;
  Level level;
  if (mesh_.open_count() > 0) {
    const int left = limits_.max_hexahedra - static_cast<int>(mesh_.cells().size());
    if (is_refuted_by_partners(level) || is_refuted_by_budgets(left, level)) return false;
    const Tightest next = tightest(mesh_, open_, level.new_vertices);
    if (prunings_.candidates && next.is_refuted) {
      refutation_.places.assign(1, mesh_.open().place_of(next.facet));
      refute(Refutation::Rule::no_candidate);
      return false;
    }
    if (prunings_.cover) refutation_.places = facets_apart(mesh_, open_, left);
    if (prunings_.cover && !refutation_.places.empty()) {
      refute(Refutation::Rule::facets_apart);
      return false;
    }
    level.bottom = next.facet;
    mesh_.begin(level.bottom);
  }
  levels_.push_back(level);
  return true;
}

HexSearch::Choices HexSearch::choices() const noexcept {
  if (!mesh_.has_begun()) return Choices(0);
  VertexSet tops = mesh_.next_tops();
  if (mesh_.vertices_left() > 0 && mesh_.new_tops() >= levels_.back().new_vertices)
    tops &= ~bit(static_cast<std::size_t>(mesh_.vertices()));
  return Choices(tops);
}

bool HexSearch::apply(Choice choice) {
  if (!mesh_.put(choice.top)) {
    refute(Refutation::Rule::tops);
    return false;
  }
  if (mesh_.has_begun() || open_level()) return true;
  mesh_.saturate(levels_.back().saturated);
  mesh_.take_off();
  return false;
}

void HexSearch::undo() noexcept {
  if (mesh_.has_just_completed()) {
    levels_.pop_back();
    mesh_.saturate(levels_.back().saturated);
  }
  mesh_.take_off();
}

complex::HexComplex complex_of(const PartialMesh& mesh) {
  complex::HexComplex result{static_cast<std::uint32_t>(mesh.vertices()), {}};
  for (const Cell& cell : mesh.cells()) {
    complex::Hexahedron hexahedron{};
    for (std::size_t i = 0; i < cell.size(); ++i) hexahedron[cells::kCornerOfPrism[i]] = cell[i];
    result.hexahedra.push_back(hexahedron);
  }
  return result;
}

}  // namespace hexatlas::hexes
