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
  const bool is_balanced = !limits.ball || !prunings.balance || mesh_.balance();
  if (!is_balanced) refute(Refutation::Rule::corner_budget);
  if (!is_balanced || !open_level()) levels_.push_back({});
  if (limits.up_to_symmetry && first_quad() >= 0) paths_.emplace(boundary, prunings.barred_tops);
}

/// By the last hexahedron alone.
bool HexSearch::is_refuted_by_last() {
  if (mesh_.cells().empty()) return false;
  if (limits_.ball && prunings_.links && closes_badly(mesh_)) return refute(Refutation::Rule::link);
  return paths_ && !paths_->follow(mesh_) && refute(Refutation::Rule::symmetry);
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
  level.new_vertices = mesh_.new_vertices();
  const bool counts_corners = prunings_.corner_budget && !is_ample(mesh_, left);
  if (counts_corners && limits_.ball && is_refuted_by_corners(left, false, level)) return true;
  if (counts_corners || mesh_.open_count() > left) open_.list(mesh_);
  if (counts_corners && !limits_.ball && is_refuted_by_corners(left, false, level)) return true;
  return counts_corners && prunings_.ears && is_refuted_by_corners(left, true, level);
}

bool HexSearch::is_refuted_by_corners(int left, bool ears, Level& level) {
  level.new_vertices = mesh_.new_vertices(new_vertices_within(mesh_, open_, left, ears));
  return level.new_vertices.are_negative() && refute(Refutation::Rule::corner_budget);
}

/// Requires that is_refuted_by_budgets() was asked.
bool HexSearch::is_refuted_by_facets_apart(int left) {
  if (!prunings_.cover || mesh_.open_count() <= left) return false;
  refutation_.places = facets_apart(open_, left);
  return !refutation_.places.empty() && refute(Refutation::Rule::facets_apart);
}

/// Chooses where the next hexahedron goes. False if no mesh within the limits follows.
bool HexSearch::open_level() {
  if (is_refuted_by_last()) return false;
  Level level;
  if (mesh_.open_count() > 0) {
    const int left = limits_.max_hexahedra - static_cast<int>(mesh_.cells().size());
    if (is_refuted_by_partners(level) || is_refuted_by_budgets(left, level)) return false;
    const Tightest next = tightest(mesh_, level.new_vertices);
    if (prunings_.candidates && next.is_refuted) {
      refutation_.places.assign(1, mesh_.open().place_of(next.facet));
      refute(Refutation::Rule::no_candidate);
      return false;
    }
    if (is_refuted_by_facets_apart(left)) return false;
    level.bottom = next.facet;
    mesh_.begin(level.bottom);
  }
  levels_.push_back(level);
  return true;
}

HexSearch::Choices HexSearch::choices() const noexcept {
  if (!mesh_.has_begun()) return Choices(0);
  return Choices(mesh_.next_tops(levels_.back().new_vertices));
}

bool HexSearch::apply(Choice choice) {
  mesh_.put(choice.top);
  if (mesh_.has_begun() || open_level()) return true;
  go_back();
  mesh_.take_off();
  return false;
}

/// What was found of the last hexahedron is forgotten; it is still there.
void HexSearch::go_back() noexcept {
  mesh_.saturate(levels_.back().saturated);
  if (paths_) paths_->go_back(mesh_, levels_.size() - 1);
}

void HexSearch::undo() noexcept {
  if (mesh_.has_just_completed()) {
    levels_.pop_back();
    go_back();
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
