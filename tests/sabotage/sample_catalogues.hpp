#pragma once
/// \file
/// Catalogues of small cells and of balls, by trying all sets of tetrahedra, with coordinates by
/// trying random points, and refutations by cases.

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tables/check/catalogue.hpp"
#include "tests/sabotage/catalogue_oracle.hpp"

namespace hexatlas::sabotage {

struct SampleCell {
  std::string name;
  SlowCell cell;
  int interior = 0;
};

inline SampleCell tetrahedron(int interior) {
  return {"tetrahedron", {4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}, interior};
}
inline SampleCell pyramid(int interior) {
  return {"pyramid", {5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}}, interior};
}
inline SampleCell prism() {
  return {"prism", {6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}}}, 0};
}
inline SampleCell octahedron() {
  return {
      "octahedron",
      {6, {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {0, 4, 3}, {0, 5, 2}, {1, 2, 5}, {1, 5, 3}, {0, 3, 5}}},
      0};
}
inline SampleCell hexahedron() {
  return {"hexahedron",
          {8, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}},
          0};
}

/// All balls with all of these vertices; in the cell, if there is one. All sets of tetrahedra are
/// tried, those with a triangle in three aside.
inline std::vector<Complex> all_balls(int vertices, const SlowCell* cell) {
  Complex candidates;
  for (const Simplex& t : subsets(first_numbers(vertices), 4)) {
    if (cell == nullptr || !has_boundary_tetrahedron({t}, *cell)) candidates.push_back(t);
  }
  std::vector<Complex> found;
  std::map<Simplex, int> uses;
  Complex chosen;
  std::size_t wanted = 0;  // boundary triangles in a cell
  if (cell != nullptr) {
    for (const auto& f : cell->facets) wanted += f.size() - 2;
  }
  // Only what has the Euler characteristic 1, and in a cell the right number of boundary triangles.
  const auto may_be_ball = [&] {
    std::array<std::size_t, 3> triangles = {0, 0, 0};  // by number of tetrahedra
    for (const auto& [triangle, count] : uses) ++triangles[static_cast<std::size_t>(count)];
    std::uint64_t edges = 0;
    for (const Simplex& t : chosen) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < i; ++j) edges |= std::uint64_t{1} << (8 * t[i] + t[j]);
      }
    }
    return triangles[1] + triangles[2] + static_cast<std::size_t>(vertices) ==
               static_cast<std::size_t>(std::popcount(edges)) + chosen.size() + 1 &&
           (cell == nullptr || triangles[1] == wanted);
  };
  const std::function<void(std::size_t)> decide = [&](std::size_t i) {
    if (i == candidates.size()) {
      if (may_be_ball() && uses_all(chosen, vertices) && is_ball(chosen) &&
          (cell == nullptr || bounds_cell(chosen, *cell))) {
        found.push_back(chosen);
      }
      return;
    }
    decide(i + 1);
    const Complex triangles = subsets(candidates[i], 3);
    const bool fits = std::all_of(triangles.begin(), triangles.end(),
                                  [&](const Simplex& t) { return uses[t] < 2; });
    if (!fits) return;
    chosen.push_back(candidates[i]);
    for (const Simplex& t : triangles) ++uses[t];
    decide(i + 1);
    for (const Simplex& t : triangles) --uses[t];
    chosen.pop_back();
  };
  decide(0);
  return found;
}

inline TextCatalogue empty_catalogue(const std::string& name, int vertices) {
  TextCatalogue c;
  c.definition = check::judged_definition_digest();
  c.name = name;
  c.vertices = vertices;
  return c;
}

/// Adds a class for each different form, in the order of the format, shelled.
inline void add_classes(TextCatalogue& c, const std::vector<Complex>& complexes, const Maps& maps) {
  std::map<std::pair<std::size_t, std::vector<int>>, TextClass> classes;
  for (Complex tetrahedra : complexes) {
    const SlowForm form = form_of(tetrahedra, maps);
    const std::pair key(tetrahedra.size(), form.least);
    if (classes.contains(key) || !find_slow_shelling(tetrahedra)) continue;
    classes[key] = {0, form.automorphisms, false, tetrahedra, {}};
  }
  for (const auto& [key, item] : classes) {
    c.list.push_back(item);
    c.list.back().number = static_cast<std::int64_t>(c.list.size());
    c.labelled += c.symmetries / item.automorphisms;
  }
  c.classes = static_cast<std::int64_t>(c.list.size());
}

/// With all triangulations of the cell without boundary tetrahedra. `members`, if wanted: their
/// number, interior vertices being distinguished.
inline TextCatalogue catalogue_of(const SampleCell& sample, std::size_t* members = nullptr) {
  const int vertices = sample.cell.boundary + sample.interior;
  TextCatalogue c = empty_catalogue(sample.name, vertices);
  c.interior = sample.interior;
  c.facets = sample.cell.facets;
  c.symmetries = static_cast<std::int64_t>(maps_of_cell(sample.cell, sample.cell.boundary).size());
  c.exhaustive = true;
  const std::vector<Complex> found = all_balls(vertices, &sample.cell);
  if (members != nullptr) *members = found.size();
  add_classes(c, found, maps_of_cell(sample.cell, vertices));
  return c;
}

inline TextCatalogue catalogue_of_balls(int vertices) {
  TextCatalogue c = empty_catalogue("balls", vertices);
  c.is_cell = false;
  c.exhaustive = true;
  add_classes(c, all_balls(vertices, nullptr), all_maps(vertices));
  const auto place = [&](const TextClass& item) {
    return std::pair(item.tetrahedra.size(), numbers_of(item.tetrahedra, first_numbers(vertices)));
  };
  std::sort(c.list.begin(), c.list.end(),
            [&](const TextClass& a, const TextClass& b) { return place(a) < place(b); });
  for (std::size_t i = 0; i < c.list.size(); ++i) {
    c.list[i].number = static_cast<std::int64_t>(i) + 1;
  }
  return c;
}

/// The cube cut into five tetrahedra, and in all ways into two prisms 013457 and 023467 with three
/// tetrahedra each; not all classes.
inline TextCatalogue catalogue_of_cubes() {
  const SampleCell cube = hexahedron();
  TextCatalogue c = empty_catalogue("hexahedron", 8);
  c.facets = cube.cell.facets;
  c.symmetries = 48;
  std::vector<Complex> found = {
      {{0, 1, 2, 4}, {1, 2, 3, 7}, {1, 2, 4, 7}, {1, 4, 5, 7}, {2, 4, 6, 7}}};
  const SlowCell prism_cell = prism().cell;
  const std::vector<Complex> prisms = all_balls(6, &prism_cell);
  const auto placed = [](Complex tetrahedra, const std::vector<int>& vertices) {
    for (Simplex& t : tetrahedra) {
      for (int& v : t) v = vertices[static_cast<std::size_t>(v)];
      t = sorted(t);
    }
    return tetrahedra;
  };
  for (const Complex& first : prisms) {
    for (const Complex& second : prisms) {
      Complex both = placed(first, {0, 1, 3, 4, 5, 7});
      for (const Simplex& t : placed(second, {0, 3, 2, 4, 7, 6})) both.push_back(t);
      if (both.size() == 6 && is_ball(both) && bounds_cell(both, cube.cell)) found.push_back(both);
    }
  }
  add_classes(c, found, maps_of_cell(cube.cell, 8));
  return c;
}

/// A chain of tetrahedra, each two neighbours with a common triangle, as a ball.
inline TextCatalogue chain(int vertices) {
  TextCatalogue c = empty_catalogue("chain", vertices);
  c.is_cell = false;
  c.classes = 1;
  c.list.resize(1);
  c.list[0].number = 1;
  for (int v = 0; v + 3 < vertices; ++v) {
    c.list[0].tetrahedra.push_back({v, v + 1, v + 2, v + 3});
  }
  c.list[0].automorphisms = form_of(c.list[0].tetrahedra, all_maps(vertices)).automorphisms;
  return c;
}

inline Points random_points(std::size_t count, std::int64_t bound, std::mt19937_64& random) {
  Points points(count);
  for (auto& p : points) {
    for (auto& x : p) {
      x = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
    }
  }
  return points;
}

/// Points that realize the class; none if `tries` random ones do not. In convex position if asked.
inline Points realization_of(const TextCatalogue& c, const TextClass& item, bool convex, int tries,
                             std::mt19937_64& random) {
  const SlowCell cell = c.cell();
  const Complex outward = c.is_cell ? outward_triangles(item.tetrahedra, cell) : Complex{};
  for (int i = 0; i < tries; ++i) {
    Points points = random_points(static_cast<std::size_t>(c.vertices), 9, random);
    const Int128 volume =
        c.is_cell ? enclosed_volume(points, outward) : six_volumes(points, item.tetrahedra[0]);
    if (volume < 0) {
      for (auto& p : points) p[0] = -p[0];
    }
    const Int128 filled = filled_volume(points, item.tetrahedra);
    if (c.is_cell && volume != filled && -volume != filled) continue;
    if (is_embedded(points, item.tetrahedra, c.is_cell ? &cell : nullptr) &&
        (!convex || is_in_convex_position(points))) {
      return points;
    }
  }
  return {};
}

/// A refutation by cases; none if there is none.
inline std::vector<std::string> refutation_of(const TextCatalogue& c, const TextClass& item,
                                              const std::string& condition) {
  const SlowCell cell = c.cell();
  const std::set<Clause> premises = all_premises(item.tetrahedra, static_cast<int>(c.vertices),
                                                 c.is_cell ? &cell : nullptr, condition);
  std::vector<Clause> clauses(premises.begin(), premises.end());
  std::stable_sort(clauses.begin(), clauses.end(),
                   [](const Clause& a, const Clause& b) { return a.size() < b.size(); });
  const auto text = CaseProof(clauses).lines();
  return text ? lines_of(*text) : std::vector<std::string>();
}

/// Asks for embedded and convex points of each class: the answer is points, a refutation or open.
inline void answer_conditions(TextCatalogue& c, std::mt19937_64& random) {
  for (TextClass& item : c.list) {
    for (const std::string condition : {"embedded", "convex"}) {
      TextProperty& property = item.properties.emplace_back();
      property.condition = condition;
      property.lines = refutation_of(c, item, condition);
      if (property.lines.empty()) {
        property.points = realization_of(c, item, condition == "convex", 20'000, random);
      }
      property.answer =
          !property.lines.empty() ? "refuted" : (property.points.empty() ? "open" : "points");
    }
  }
}

}  // namespace hexatlas::sabotage
