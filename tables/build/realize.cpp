#include "tables/build/realize.hpp"

#include <algorithm>
#include <mutex>
#include <variant>

#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::build {
namespace {

using complex::set_of;
using complex::VertexSet;

/// The boundary of the triangulation, with the orientation of the cell.
complex::CutSurface boundary_in(const complex::Cell& cell,
                                const complex::Triangulation& triangulation) {
  const std::vector<VertexSet> boundary = complex::boundary_triangles(triangulation);
  for (const complex::CutSurface& surface : complex::cut_surfaces(cell))
    if (std::all_of(surface.triangles.begin(), surface.triangles.end(), [&](const auto& triangle) {
          return std::binary_search(boundary.begin(), boundary.end(), set_of(triangle));
        }))
      return surface;
  throw core::PreconditionViolated("realize: the boundary of a class is that of the cell");
}

/// The sign of the tetrahedron at a boundary triangle a b c, counter-clockwise from outside: that
/// of a b c d is negative.
int sign_at(const complex::OrientedTriangle& triangle, VertexSet tetrahedron) {
  const std::array<int, 4> listed{
      triangle[0], triangle[1], triangle[2],
      complex::least_vertex(static_cast<VertexSet>(tetrahedron & ~unsigned{set_of(triangle)}))};
  int sign = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (listed[i] > listed[j]) sign = -sign;
  return sign;
}

}  // namespace

std::vector<int> signs_of(const format::Catalogue& catalogue,
                          const complex::Triangulation& triangulation) {
  auto signs = complex::orientation_of(triangulation);
  core::expects(signs.has_value(), "realize: a class is orientable");
  if (!catalogue.cell) return *signs;
  const complex::OrientedTriangle triangle =
      boundary_in(*catalogue.cell, triangulation).triangles.front();
  const auto at =
      std::find_if(triangulation.tetrahedra.begin(), triangulation.tetrahedra.end(),
                   [&](VertexSet t) { return (t & set_of(triangle)) == set_of(triangle); });
  const auto index = static_cast<std::size_t>(at - triangulation.tetrahedra.begin());
  if ((*signs)[index] != sign_at(triangle, *at))
    for (int& sign : *signs) sign = -sign;
  return *signs;
}

void realize(format::Catalogue& catalogue, const RealizeOptions& options) {
  core::expects(options.condition != certificate::Condition::jacobian || is_hexahedron(catalogue),
                "realize: the Jacobian is that of the hexahedron");
  std::mutex mutex;
  std::size_t done = 0;
  parallel::parallel_for(options.threads, catalogue.classes.size(), [&](std::size_t i) {
    format::CatalogueClass& entry = catalogue.classes[i];
    auto& answer = entry.answers[static_cast<std::size_t>(options.condition)];
    if (!answer || std::holds_alternative<certificate::Open>(*answer)) {
      if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed))
        answer = certificate::Open{};
      else
        answer = solve::decide(entry.triangulation, signs_of(catalogue, entry.triangulation),
                               options.condition, options.effort);
    }
    if (!options.progress) return;
    const std::lock_guard lock(mutex);
    options.progress(++done, catalogue.classes.size());
  });
}

bool is_hexahedron(const format::Catalogue& catalogue) {
  return catalogue.cell && catalogue.interior == 0 &&
         catalogue.cell->facets == complex::cell_named("hexahedron")->facets;
}

AnswerCounts count_answers(const format::Catalogue& catalogue, certificate::Condition condition) {
  AnswerCounts counts;
  for (const format::CatalogueClass& entry : catalogue.classes) {
    const auto& answer = entry.answers[static_cast<std::size_t>(condition)];
    if (!answer) continue;
    counts.realizable += std::holds_alternative<certificate::Realization>(*answer) ? 1 : 0;
    counts.refuted += std::holds_alternative<certificate::Refutation>(*answer) ? 1 : 0;
    counts.open += std::holds_alternative<certificate::Open>(*answer) ? 1 : 0;
  }
  return counts;
}

}  // namespace hexatlas::build
