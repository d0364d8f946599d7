#include <nauty/nauty.h>

#include "enum/canon/nauty/triangulation_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "enum/core/checks.hpp"

namespace hexatlas::canon {
namespace {

static_assert(HAVE_TLS, "nauty must be built with thread-local storage");

/// What nauty reads and writes: kept from call to call, since the calls are short and many.
struct Workspace {
  std::vector<graph> rows, canonical_rows;
  std::vector<int> lab, ptn, orbits;
};

/// Vertices, then tetrahedra; within both, cells of equal degree, since nauty would otherwise begin
/// by finding just these.
void colour(const complex::Triangulation& triangulation, Workspace& work) {
  std::array<int, complex::kMaxTriangulationVertices> degree{};
  for (const complex::VertexSet tetrahedron : triangulation.tetrahedra)
    for (complex::VertexSet rest = tetrahedron; rest != 0; rest = complex::without_least(rest))
      ++degree[static_cast<std::size_t>(complex::least_vertex(rest))];
  const auto nodes = work.lab.size();
  const auto vertices = static_cast<std::size_t>(triangulation.vertices);
  for (std::size_t i = 0; i < nodes; ++i) work.lab[i] = static_cast<int>(i);
  std::fill(work.ptn.begin(), work.ptn.end(), 1);
  const auto degree_of = [&](int v) { return degree[static_cast<std::size_t>(v)]; };
  std::sort(work.lab.begin(), work.lab.begin() + triangulation.vertices,
            [&](int a, int b) { return degree_of(a) < degree_of(b); });
  for (std::size_t i = 0; i + 1 < vertices; ++i)
    if (degree_of(work.lab[i]) != degree_of(work.lab[i + 1])) work.ptn[i] = 0;
  work.ptn[vertices - 1] = 0;
  work.ptn[nodes - 1] = 0;
}

}  // namespace

TriangulationForm triangulation_form(const complex::Triangulation& triangulation) {
  core::expects(triangulation.vertices > 0 &&
                    triangulation.vertices <= complex::kMaxTriangulationVertices &&
                    !triangulation.tetrahedra.empty(),
                "a triangulation has tetrahedra and at most kMaxTriangulationVertices vertices");
  thread_local Workspace work;
  const auto vertices = static_cast<std::size_t>(triangulation.vertices);
  const std::size_t nodes = vertices + triangulation.tetrahedra.size();
  const auto words = static_cast<std::size_t>(SETWORDSNEEDED(nodes));
  work.rows.assign(nodes * words, 0);
  work.canonical_rows.resize(nodes * words);
  work.lab.resize(nodes);
  work.ptn.resize(nodes);
  work.orbits.resize(nodes);
  colour(triangulation, work);
  std::size_t node = vertices;
  for (const complex::VertexSet tetrahedron : triangulation.tetrahedra) {
    for (complex::VertexSet rest = tetrahedron; rest != 0; rest = complex::without_least(rest)) {
      const auto v = static_cast<std::size_t>(complex::least_vertex(rest));
      ADDONEEDGE(work.rows.data(), v, node, words);
    }
    ++node;
  }

  static DEFAULTOPTIONS_GRAPH(defaults);
  optionblk options = defaults;
  options.getcanon = TRUE;
  options.defaultptn = FALSE;
  statsblk stats{};
  densenauty(work.rows.data(), work.lab.data(), work.ptn.data(), work.orbits.data(), &options,
             &stats, static_cast<int>(words), static_cast<int>(nodes), work.canonical_rows.data());
  core::ensures(stats.errstatus == 0 && stats.grpsize2 == 0,
                "the group of a strongly connected triangulation is small");

  TriangulationForm form;
  form.automorphisms = static_cast<std::uint64_t>(std::llround(stats.grpsize1));
  for (std::size_t i = 0; i < vertices; ++i) {
    form.labels[static_cast<std::size_t>(work.lab[i])] = static_cast<std::uint8_t>(i);
    form.orbit[i] = static_cast<std::uint8_t>(work.orbits[i]);
  }
  form.canonical = complex::image_of(triangulation, form.labels);
  return form;
}

}  // namespace hexatlas::canon
