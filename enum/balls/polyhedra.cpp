#include "enum/balls/polyhedra.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <variant>

#include "enum/balls/map_code.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::balls {
namespace {

using complex::bit_of;
using complex::Cell;
using complex::CellFacet;

using Facets = std::vector<CellFacet>;

/// One map per class, by number of quads and least code of a walk.
using Classes = std::map<std::pair<std::size_t, MapWalk::Code>, Facets>;

CellFacet triangle(std::uint8_t a, std::uint8_t b, std::uint8_t c) { return {{a, b, c, 0}, 3}; }

/// Adds the map, numbered and oriented by the walk with the least code, unless it is there.
void insert(Classes& classes, int vertices, const Facets& facets) {
  const SphereMap map = map_of(vertices, facets);
  MapWalk least;
  bool mirrored = false;
  least.code.fill(MapWalk::kEnd);
  for (const SphereMap::Dart dart : map.darts()) {
    const MapWalk walk = map.walk(dart);
    if (walk.code >= least.code) continue;
    least = walk;
    mirrored = dart.mirrored;
  }
  std::array<std::uint8_t, complex::kMaxCellVertices> number{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices); ++i)
    number[least.at[i]] = static_cast<std::uint8_t>(i);
  Facets renamed = facets;
  for (CellFacet& facet : renamed) {
    const auto end = facet.vertex.begin() + facet.size;
    for (auto v = facet.vertex.begin(); v != end; ++v) *v = number[*v];
    if (mirrored) std::reverse(facet.vertex.begin(), end);
    std::rotate(facet.vertex.begin(), std::min_element(facet.vertex.begin(), end), end);
  }
  std::sort(renamed.begin(), renamed.end());
  const auto quads =
      std::count_if(facets.begin(), facets.end(), [](const CellFacet& f) { return f.size == 4; });
  classes.try_emplace({static_cast<std::size_t>(quads), least.code}, std::move(renamed));
}

std::vector<Cell> cells_of(const Classes& classes, int vertices) {
  std::vector<Cell> result;
  for (const auto& [code, facets] : classes) {
    auto cell = complex::cell_of(facets, vertices);
    core::ensures(std::holds_alternative<Cell>(cell), "a polyhedron is a cell");
    result.push_back(std::get<Cell>(std::move(cell)));
  }
  return result;
}

/// Two triangles with a common edge: a b c and b a d.
struct Hinge {
  std::size_t left = 0, right = 0;  ///< indices of facets
  std::uint8_t a = 0, b = 0, c = 0, d = 0;
};

/// One per edge of a triangulated sphere.
std::vector<Hinge> hinges_of(const Facets& triangles) {
  std::vector<Hinge> result;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t g = f + 1; g < triangles.size(); ++g)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const auto& s = triangles[f].vertex;
          const auto& t = triangles[g].vertex;
          const std::uint8_t a = s[i];
          const std::uint8_t b = s[(i + 1) % 3];
          if (t[j] == b && t[(j + 1) % 3] == a)
            result.push_back({f, g, a, b, s[(i + 2) % 3], t[(j + 2) % 3]});
        }
  return result;
}

void insert_subdivisions(Classes& classes, int vertices, const Facets& triangles) {
  const auto apex = static_cast<std::uint8_t>(vertices);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto [a, b, c, unused] = triangles[f].vertex;
    Facets finer = triangles;
    finer[f] = triangle(a, b, apex);
    finer.push_back(triangle(b, c, apex));
    finer.push_back(triangle(c, a, apex));
    insert(classes, vertices + 1, finer);
  }
}

void insert_flips(Classes& classes, int vertices, const Facets& triangles) {
  const std::vector<Hinge> hinges = hinges_of(triangles);
  for (const Hinge& hinge : hinges) {
    const bool is_edge = std::any_of(hinges.begin(), hinges.end(), [&](const Hinge& other) {
      return (other.a == hinge.c && other.b == hinge.d) ||
             (other.a == hinge.d && other.b == hinge.c);
    });
    if (is_edge) continue;
    Facets flipped = triangles;
    flipped[hinge.left] = triangle(hinge.a, hinge.d, hinge.c);
    flipped[hinge.right] = triangle(hinge.b, hinge.c, hinge.d);
    insert(classes, vertices, flipped);
  }
}

Classes classes_of_triangulated_spheres(int vertices) {
  core::expects(vertices >= 4 && vertices <= kMaxPolyhedronVertices,
                "4 to kMaxPolyhedronVertices vertices");
  Classes level;
  insert(level, 4, {triangle(0, 1, 2), triangle(0, 2, 3), triangle(0, 3, 1), triangle(1, 3, 2)});
  for (int n = 4; n < vertices; ++n) {
    Classes next;
    for (const auto& [code, triangles] : level) insert_subdivisions(next, n, triangles);
    for (std::size_t before = 0; before != next.size();) {
      before = next.size();
      const Classes snapshot = next;
      for (const auto& [code, triangles] : snapshot) insert_flips(next, n + 1, triangles);
    }
    level = std::move(next);
  }
  return level;
}

/// Whether the graph of the edges is connected without any two of its vertices.
bool is_three_connected(int vertices, const Facets& facets) {
  std::array<unsigned, complex::kMaxCellVertices> neighbours{};
  for (const CellFacet& facet : facets)
    for (std::size_t i = 0; i < facet.size; ++i)
      neighbours[facet.vertex[i]] |= bit_of(facet.vertex[(i + 1) % facet.size]);
  const unsigned all = (1U << static_cast<unsigned>(vertices)) - 1U;
  for (int a = 0; a < vertices; ++a)
    for (int b = a + 1; b < vertices; ++b) {
      const unsigned rest = all & ~static_cast<unsigned>(bit_of(a) | bit_of(b));
      unsigned reached = rest & (~rest + 1U);
      for (unsigned before = 0; before != reached;) {
        before = reached;
        for (std::size_t v = 0; v < static_cast<std::size_t>(vertices); ++v)
          if ((reached >> v & 1U) != 0) reached |= neighbours[v] & rest;
      }
      if (reached != rest) return false;
    }
  return true;
}

/// All ways to make quads of disjoint pairs of triangles.
class Mergers {
 public:
  Mergers(Classes& classes, int vertices, const Facets& triangles)
      : classes_(classes),
        vertices_(vertices),
        triangles_(triangles),
        hinges_(hinges_of(triangles)) {}

  void insert_all() { from(0); }

 private:
  void from(std::size_t next) {
    if (next == hinges_.size()) {
      insert_chosen();
      return;
    }
    from(next + 1);
    const Hinge& hinge = hinges_[next];
    const bool is_free = std::none_of(chosen_.begin(), chosen_.end(), [&](const Hinge& other) {
      return other.left == hinge.left || other.left == hinge.right || other.right == hinge.left ||
             other.right == hinge.right;
    });
    if (!is_free) return;
    chosen_.push_back(hinge);
    from(next + 1);
    chosen_.pop_back();
  }
  void insert_chosen() const {
    Facets facets;
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      if (std::none_of(chosen_.begin(), chosen_.end(),
                       [&](const Hinge& hinge) { return hinge.left == f || hinge.right == f; }))
        facets.push_back(triangles_[f]);
    for (const Hinge& hinge : chosen_) facets.push_back({{hinge.a, hinge.d, hinge.b, hinge.c}, 4});
    if (is_three_connected(vertices_, facets)) insert(classes_, vertices_, facets);
  }

  Classes& classes_;
  int vertices_;
  const Facets& triangles_;
  std::vector<Hinge> hinges_;
  std::vector<Hinge> chosen_;
};

}  // namespace

std::vector<Cell> triangulated_spheres(int vertices) {
  return cells_of(classes_of_triangulated_spheres(vertices), vertices);
}

std::vector<Cell> polyhedra(int vertices) {
  Classes classes;
  for (const auto& [code, triangles] : classes_of_triangulated_spheres(vertices))
    Mergers(classes, vertices, triangles).insert_all();
  return cells_of(classes, vertices);
}

}  // namespace hexatlas::balls
