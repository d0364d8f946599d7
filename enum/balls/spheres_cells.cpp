#include "enum/balls/spheres_cells.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "enum/balls/map_code.hpp"
#include "enum/canon/nauty/triangulation_form.hpp"
#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::balls {
namespace {

using complex::bit_of;
using complex::Cell;
using complex::Triangulation;
using complex::VertexMap;
using complex::VertexSet;

/// A choice of diagonals, read from one of its darts.
struct Pattern {
  MapWalk::Code code{};
  std::array<std::uint8_t, complex::kMaxCellVertices> at{};
  std::vector<VertexMap> stabiliser;  ///< the symmetries of the cell that keep the diagonals
};

/// One pattern per orbit of choices of diagonals under the symmetries of the cell.
std::vector<Pattern> patterns_of(const Cell& cell, const std::vector<VertexMap>& symmetries) {
  std::set<Triangulation> seen;  // sets of triangles here
  std::vector<Pattern> result;
  for (const complex::CutSurface& surface : complex::cut_surfaces(cell)) {
    Triangulation triangles{cell.vertices, {}};
    for (const complex::OrientedTriangle& t : surface.triangles)
      triangles.tetrahedra.push_back(complex::set_of(t));
    std::sort(triangles.tetrahedra.begin(), triangles.tetrahedra.end());
    if (seen.contains(triangles)) continue;
    const SphereMap map = map_of(cell.vertices, surface.triangles);
    const MapWalk walk = map.walk(map.darts().front());
    result.push_back({walk.code, walk.at, {}});
    for (const VertexMap& symmetry : symmetries) {
      Triangulation image = complex::image_of(triangles, symmetry);
      if (image == triangles) result.back().stabiliser.push_back(symmetry);
      seen.insert(std::move(image));
    }
  }
  return result;
}

/// The symmetries of the cell times the permutations of the interior vertices.
std::vector<VertexMap> relabellings(const Cell& cell, const std::vector<VertexMap>& symmetries,
                                    int interior) {
  std::vector<std::uint8_t> order(static_cast<std::size_t>(interior));
  std::iota(order.begin(), order.end(), static_cast<std::uint8_t>(cell.vertices));
  std::vector<VertexMap> result;
  do {
    for (VertexMap map : symmetries) {
      std::copy(order.begin(), order.end(), map.begin() + cell.vertices);
      result.push_back(map);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

/// The least image and how many relabellings give it: the order of the stabiliser.
CellClass least_image(const Triangulation& triangulation, const std::vector<VertexMap>& maps) {
  CellClass best;
  std::vector<VertexSet> image(triangulation.tetrahedra.size());
  for (const VertexMap& map : maps) {
    std::transform(triangulation.tetrahedra.begin(), triangulation.tetrahedra.end(), image.begin(),
                   [&](VertexSet tetrahedron) { return complex::image_of(tetrahedron, map); });
    auto& least = best.triangulation.tetrahedra;
    // The first number of the sorted list decides most comparisons.
    if (!least.empty() && *std::min_element(image.begin(), image.end()) > least.front()) continue;
    std::sort(image.begin(), image.end());
    if (least.empty() || image < least) {
      least = image;
      best.automorphisms = 1;
    } else if (image == least) {
      ++best.automorphisms;
    }
  }
  best.triangulation.vertices = triangulation.vertices;
  return best;
}

/// The link of a vertex with the labels of the punctured sphere, coherently oriented. `sign` is
/// orientation_of(sphere).
SphereMap link_map(const Triangulation& sphere, const std::vector<int>& sign, int vertex,
                   const PuncturedSphere& rest) {
  SphereMap map(rest.boundary_vertices);
  for (std::size_t i = 0; i < sphere.tetrahedra.size(); ++i) {
    if ((sphere.tetrahedra[i] & bit_of(vertex)) == 0) continue;
    int orientation = sign[i];
    complex::OrientedTriangle triangle{};
    std::size_t corner = 0;
    std::size_t place = 0;
    for (const std::uint8_t v : complex::vertices_of(sphere.tetrahedra[i])) {
      // The facet opposite the vertex at an odd place is listed against the tetrahedron's sense.
      if (v != vertex)
        triangle[corner++] = rest.labels[v];
      else if (place % 2 == 1)
        orientation = -orientation;
      ++place;
    }
    if (orientation < 0) std::swap(triangle[1], triangle[2]);
    map.add(triangle);
  }
  return map;
}

/// What does not depend on the sphere.
struct Question {
  const Cell& cell;
  CellRules rules;
  std::vector<VertexMap> maps;
  std::vector<Pattern> patterns;

  [[nodiscard]] bool allows(const Triangulation& triangulation) const {
    if (rules.boundary_tetrahedra) return true;
    return std::none_of(
        cell.facets.begin(), cell.facets.end(), [&](const complex::CellFacet& facet) {
          return std::binary_search(triangulation.tetrahedra.begin(),
                                    triangulation.tetrahedra.end(), facet.vertices());
        });
  }
};

using Found = std::map<std::vector<VertexSet>, CellClass>;

VertexMap after(const VertexMap& first, const VertexMap& then) {
  VertexMap result{};
  std::transform(first.begin(), first.end(), result.begin(),
                 [&](std::uint8_t v) { return then[v]; });
  return result;
}

/// The ball as a triangulation of the cell, in all ways up to the symmetries of the cut cell.
void insert_ways(Found& found, const Question& question, const Triangulation& ball,
                 const SphereMap& link) {
  for (const SphereMap::Dart dart : link.darts()) {
    const MapWalk walk = link.walk(dart);
    for (const Pattern& pattern : question.patterns) {
      if (walk.code != pattern.code) continue;
      VertexMap labels{};
      std::iota(labels.begin(), labels.end(), std::uint8_t{0});
      for (std::size_t i = 0; i < static_cast<std::size_t>(link.vertices()); ++i)
        labels[walk.at[i]] = pattern.at[i];
      if (std::any_of(pattern.stabiliser.begin(), pattern.stabiliser.end(),
                      [&](const VertexMap& map) { return after(labels, map) < labels; }))
        continue;
      const Triangulation seen = complex::image_of(ball, labels);
      if (!question.allows(seen)) continue;
      CellClass least = least_image(seen, question.maps);
      found.try_emplace(least.triangulation.tetrahedra, std::move(least));
    }
  }
}

std::vector<CellClass> classes_in(const Triangulation& sphere, const Question& question) {
  const canon::TriangulationForm form = canon::triangulation_form(sphere);
  const auto sign = complex::orientation_of(sphere);
  core::ensures(sign.has_value(), "a sphere is orientable");
  Found found;
  for (int v = 0; v < sphere.vertices; ++v) {
    if (form.orbit[static_cast<std::size_t>(v)] != v) continue;
    const PuncturedSphere rest = punctured(sphere, v);
    if (rest.boundary_vertices == question.cell.vertices)
      insert_ways(found, question, rest.ball, link_map(sphere, *sign, v, rest));
  }
  std::vector<CellClass> result;
  for (auto& [list, entry] : found) result.push_back(std::move(entry));
  return result;
}

}  // namespace

CellClasses triangulations_from(const Spheres& list, const Cell& cell, CellRules rules,
                                int threads) {
  const int interior = list.vertices - 1 - cell.vertices;
  core::expects(interior >= 0, "spheres with more vertices than the cell");
  const std::vector<VertexMap> symmetries = complex::symmetries(cell);
  const Question question{cell, rules, relabellings(cell, symmetries, interior),
                          patterns_of(cell, symmetries)};
  std::vector<std::vector<CellClass>> found(list.found.size());
  parallel::parallel_for(threads, list.found.size(),
                         [&](std::size_t i) { found[i] = classes_in(list.found[i], question); });
  // A class determines its sphere, so no class comes from two of them.
  CellClasses result;
  for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(result.classes));
  std::sort(result.classes.begin(), result.classes.end(),
            [](const CellClass& a, const CellClass& b) {
              return is_before(a.triangulation, b.triangulation);
            });
  for (const CellClass& entry : result.classes)
    result.labelled += symmetries.size() / entry.automorphisms;
  return result;
}

}  // namespace hexatlas::balls
