#pragma once
/// \file
/// Catalogues of triangulations as plain data, a writer, and a slow judge that reads a text by
/// writing it again: a text that is not what it is read as is no catalogue. Laws by
/// triangulation_oracle.hpp and refutation_oracle.hpp. A digest is taken from the judge's own
/// SHA-256, which has tests.

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tables/check/sha256.hpp"
#include "tests/sabotage/refutation_oracle.hpp"
#include "tests/sabotage/triangulation_oracle.hpp"

namespace hexatlas::sabotage {

struct TextProperty {
  std::string condition;
  std::string answer;  ///< points, refuted, open
  Points points;
  std::vector<std::string> lines;  ///< of a refutation, with qed
};

struct TextClass {
  std::int64_t number = 0;
  std::int64_t automorphisms = 0;
  bool unshelled = false;
  Complex tetrahedra;  ///< in the order of the line
  std::vector<TextProperty> properties;
};

struct TextCatalogue {
  std::string definition;
  bool is_cell = true;
  std::string name;
  std::int64_t vertices = 0;
  std::int64_t interior = 0;
  bool boundary_tetrahedra = false;
  std::vector<std::vector<int>> facets;
  std::int64_t symmetries = 0;
  std::int64_t classes = 0;
  std::int64_t labelled = 0;
  bool exhaustive = false;
  std::vector<TextClass> list;

  [[nodiscard]] SlowCell cell() const { return {static_cast<int>(vertices - interior), facets}; }
};

inline std::string digits(const std::vector<int>& vertices) {
  std::string text;
  for (const int v : vertices) text += "0123456789abcdef"[v];
  return text;
}

/// With the digest.
inline std::string sealed(const std::string& body) {
  return body + "end " + check::sha256_hex_of(body) + "\n";
}

/// Without the last line.
inline std::string body_of(const TextCatalogue& c) {
  std::ostringstream out;
  const auto yes = [](bool value) { return value ? "yes" : "no"; };
  out << "hexatlas catalogue 1\ndefinition " << c.definition << "\nkind "
      << (c.is_cell ? "cell" : "balls") << "\nname " << c.name << "\nvertices " << c.vertices
      << "\ninterior " << c.interior << '\n';
  if (c.is_cell) {
    out << "boundary-tetrahedra " << yes(c.boundary_tetrahedra) << "\nfacets";
    for (const auto& facet : c.facets) out << ' ' << digits(facet);
    out << "\nsymmetries " << c.symmetries << '\n';
  }
  out << "classes " << c.classes << '\n';
  if (c.is_cell) out << "labelled " << c.labelled << '\n';
  out << "exhaustive " << yes(c.exhaustive) << '\n';
  for (const TextClass& item : c.list) {
    out << "class " << item.number << ' ' << item.automorphisms;
    if (item.unshelled) out << " unshelled";
    for (const Simplex& t : item.tetrahedra) out << ' ' << digits(t);
    out << '\n';
    for (const TextProperty& property : item.properties) {
      out << property.condition << ' ' << property.answer;
      for (const auto& p : property.points) out << ' ' << p[0] << ' ' << p[1] << ' ' << p[2];
      out << '\n';
      for (const std::string& line : property.lines) out << line << '\n';
    }
  }
  return out.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

inline std::vector<int> undigits(const std::string& word) {
  std::vector<int> vertices;
  for (const char c : word) {
    vertices.push_back(static_cast<int>(std::string("0123456789abcdef").find(c)));
    if (vertices.back() < 0) throw std::invalid_argument("no digit");
  }
  return vertices;
}

/// Reads leniently; throws std::exception where that is impossible. `text` without its last line.
inline TextCatalogue lenient(const std::string& text) {
  TextCatalogue c;
  for (const std::string& line : lines_of(text)) {
    const std::vector<std::string> words = words_of(line);
    const std::string& first = words.at(0);
    const bool open_refutation = !c.list.empty() && !c.list.back().properties.empty() &&
                                 c.list.back().properties.back().answer == "refuted" &&
                                 (c.list.back().properties.back().lines.empty() ||
                                  c.list.back().properties.back().lines.back() != "qed");
    if (open_refutation) {
      c.list.back().properties.back().lines.push_back(line);
    } else if (first == "class") {
      TextClass& item = c.list.emplace_back();
      item.number = std::stoll(words.at(1));
      item.automorphisms = std::stoll(words.at(2));
      item.unshelled = words.at(3) == "unshelled";
      for (std::size_t i = item.unshelled ? 4 : 3; i < words.size(); ++i) {
        item.tetrahedra.push_back(undigits(words[i]));
      }
    } else if (first == "embedded" || first == "convex" || first == "jacobian") {
      TextProperty& property = c.list.at(c.list.size() - 1).properties.emplace_back();
      property.condition = first;
      property.answer = words.at(1);
      for (std::size_t i = 2; i < words.size(); i += 3) {
        property.points.push_back(
            {std::stoll(words.at(i)), std::stoll(words.at(i + 1)), std::stoll(words.at(i + 2))});
      }
    } else if (first == "facets") {
      for (std::size_t i = 1; i < words.size(); ++i) c.facets.push_back(undigits(words[i]));
    } else {
      const std::string& value = words.at(1);
      if (first == "definition") c.definition = value;
      if (first == "kind") c.is_cell = value == "cell";
      if (first == "name") c.name = value;
      if (first == "vertices") c.vertices = std::stoll(value);
      if (first == "interior") c.interior = std::stoll(value);
      if (first == "boundary-tetrahedra") c.boundary_tetrahedra = value == "yes";
      if (first == "symmetries") c.symmetries = std::stoll(value);
      if (first == "classes") c.classes = std::stoll(value);
      if (first == "labelled") c.labelled = std::stoll(value);
      if (first == "exhaustive") c.exhaustive = value == "yes";
    }
  }
  return c;
}

class CatalogueOracle {
 public:
  explicit CatalogueOracle(std::string definition) : definition_(std::move(definition)) {}

  /// Whether every statement of the file is true, the claim of exhaustiveness aside. Hints of
  /// refutations are not looked at, lemmas must follow by propagation.
  bool is_true(const std::string& text) {
    const std::size_t end = text.rfind("end ");
    if (end == std::string::npos) return false;
    const std::string body = text.substr(0, end);
    try {
      const TextCatalogue c = lenient(body);
      return sealed(body_of(c)) == text && is_true(c);
    } catch (const std::exception&) {
      return false;
    }
  }

 private:
  bool is_true(const TextCatalogue& c) {
    const SlowCell cell = c.cell();
    if (c.definition != definition_ || c.vertices < 4 || c.vertices > 8 || c.interior < 0) {
      return false;
    }
    const auto n = static_cast<int>(c.vertices);
    if (c.is_cell ? !is_cell(c.name, cell) : c.interior != 0) return false;
    if (std::any_of(c.name.begin(), c.name.end(), [](char x) {
          return std::string("abcdefghijklmnopqrstuvwxyz0123456789-").find(x) == std::string::npos;
        })) {
      return false;
    }
    const Maps& maps = maps_for(c.is_cell ? c.facets : std::vector<std::vector<int>>(), n);
    std::int64_t inner = 1;
    for (std::int64_t i = 2; i <= c.interior; ++i) inner *= i;
    if (c.is_cell && static_cast<std::int64_t>(maps.size()) != c.symmetries * inner) return false;
    std::int64_t labelled = 0;
    std::set<std::vector<int>> forms;
    std::pair<std::size_t, std::vector<int>> last;
    for (std::size_t i = 0; i < c.list.size(); ++i) {
      const TextClass& item = c.list[i];
      if (item.number != static_cast<std::int64_t>(i) + 1 || !is_triangulation(c, item, n)) {
        return false;
      }
      const SlowForm& form = cached_form(item.tetrahedra, maps);
      labelled += c.symmetries / form.automorphisms;
      const std::pair place(item.tetrahedra.size(),
                            c.is_cell ? form.least : numbers_of(item.tetrahedra, first_numbers(n)));
      if (form.automorphisms != item.automorphisms || !forms.insert(form.least).second ||
          place <= last) {
        return false;
      }
      last = place;
      if (!are_true(c, item, n)) return false;
    }
    return c.classes == static_cast<std::int64_t>(c.list.size()) &&
           (!c.is_cell || c.labelled == labelled);
  }

  /// A sphere: the facets, with all quads cut in some way, or with a new vertex in each quad.
  bool is_cell(const std::string& name, const SlowCell& cell) {
    Complex cones;
    std::multiset<Simplex> edges;
    int apex = 16;
    for (const auto& f : cell.facets) {
      if (f.size() != 3 && f.size() != 4) return false;
      for (std::size_t i = 0; i < f.size(); ++i) {
        const int next = f[(i + 1) % f.size()];
        edges.insert({f[i], next});
        cones.push_back(sorted({f[i], next, apex}));
      }
      ++apex;
    }
    for (const Simplex& edge : edges) {
      if (edge[0] == edge[1] || edges.count(edge) != 1 || edges.count({edge[1], edge[0]}) != 1 ||
          edge[0] >= cell.boundary) {
        return false;
      }
    }
    const auto used = static_cast<std::size_t>(cell.boundary) + cell.facets.size();
    if (cell.facets.size() < 4 || !is_sphere_or_disc(cones) || !boundary_of(cones).empty() ||
        face_counts(cones, 1).size() != used) {
      return false;
    }
    const std::map<std::string, std::vector<std::size_t>> known = {
        {"tetrahedron", {4, 4, 24}}, {"pyramid", {5, 5, 8}},     {"prism", {6, 5, 12}},
        {"octahedron", {6, 8, 48}},  {"hexahedron", {8, 6, 48}},
    };
    const auto found = known.find(name);
    if (found != known.end()) {
      const std::vector<std::size_t> own = {static_cast<std::size_t>(cell.boundary),
                                            cell.facets.size(),
                                            maps_for(cell.facets, cell.boundary).size()};
      if (own != found->second) return false;
    }
    return name != "hexahedron" ||
           std::all_of(cell.facets.begin(), cell.facets.end(),
                       [](const std::vector<int>& f) { return f[0] + f[2] == f[1] + f[3]; });
  }

  /// Those of the cell; without facets, all.
  const Maps& maps_for(std::vector<std::vector<int>> facets, int vertices) {
    facets.push_back({vertices});
    const auto [place, is_new] = maps_.try_emplace(facets);
    facets.pop_back();
    if (is_new) {
      place->second = facets.empty() ? all_maps(vertices) : maps_of_cell({0, facets}, vertices);
    }
    return place->second;
  }

  const SlowForm& cached_form(const Complex& tetrahedra, const Maps& maps) {
    const auto [place, is_new] = forms_.try_emplace({&maps, tetrahedra});
    if (is_new) place->second = form_of(tetrahedra, maps);
    return place->second;
  }

  static bool is_triangulation(const TextCatalogue& c, const TextClass& item, int n) {
    for (const Simplex& t : item.tetrahedra) {
      if (t.size() != 4 || t[3] >= n) return false;
      for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] >= t[i + 1]) return false;
      }
    }
    if (!is_ball(item.tetrahedra) || !uses_all(item.tetrahedra, n)) return false;
    if (item.unshelled) {
      const std::vector<int> numbers = numbers_of(item.tetrahedra, first_numbers(n));
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers_of({item.tetrahedra[i]}, first_numbers(n))[0] != numbers[i]) return false;
      }
    } else if (!is_slow_shelling(item.tetrahedra)) {
      return false;
    }
    return !c.is_cell ||
           (bounds_cell(item.tetrahedra, c.cell()) &&
            (c.boundary_tetrahedra || !has_boundary_tetrahedron(item.tetrahedra, c.cell())));
  }

  bool are_true(const TextCatalogue& c, const TextClass& item, int n) {
    const SlowCell cell = c.cell();
    const SlowCell* cell_or_none = c.is_cell ? &cell : nullptr;
    const std::vector<std::string> conditions = {"embedded", "convex", "jacobian"};
    std::size_t next = 0;
    for (const TextProperty& property : item.properties) {
      while (next < 3 && conditions[next] != property.condition) ++next;
      if (next++ == 3) return false;
      if (property.condition == "jacobian" && (c.name != "hexahedron" || c.interior != 0)) {
        return false;
      }
      if (property.answer == "points") {
        if (static_cast<int>(property.points.size()) != n ||
            !is_embedded(property.points, item.tetrahedra, cell_or_none)) {
          return false;
        }
        if (property.condition == "convex" && !is_in_convex_position(property.points)) return false;
        if (property.condition == "jacobian" &&
            !has_positive_jacobian_on_grid(property.points, 8)) {
          return false;
        }
      } else if (property.answer == "refuted") {
        std::vector<std::string> key = property.lines;
        key.push_back(property.condition + (c.is_cell ? " cell" : " balls"));
        for (const Simplex& t : item.tetrahedra) key.push_back(digits(t));
        for (const auto& facet : c.facets) key.push_back(digits(facet));
        const auto [place, is_new] = refuted_.try_emplace(key, false);
        if (is_new) {
          place->second =
              is_refuted(property.lines, n,
                         all_premises(item.tetrahedra, n, cell_or_none, property.condition));
        }
        if (!place->second) return false;
      } else if (property.answer != "open" || !property.points.empty()) {
        return false;
      }
    }
    return true;
  }

  static bool is_refuted(const std::vector<std::string>& lines, int vertices,
                         const std::set<Clause>& premises) {
    const std::string kinds = "cfl";  // in this order
    std::vector<Clause> clauses;
    std::size_t kind = 0;
    for (const std::string& line : lines) {
      const std::vector<std::string> words = words_of(line);
      if (line == "qed") return !clauses.empty() && clauses.back().empty();
      const std::size_t own = kinds.find(words.at(0));
      if (own == std::string::npos || own < kind || words[0].size() != 1) return false;
      kind = own;
      Clause clause;
      std::size_t i = 1;
      for (; words.at(i) != "0"; ++i) clause.push_back(std::stoi(words[i]));
      const std::vector<std::string> rest(words.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                          words.end());
      std::sort(clause.begin(), clause.end());
      if (words[0] == "c" && (!rest.empty() || !premises.contains(clause))) return false;
      if (words[0] == "f" && !is_final_polynomial(clause, rest, vertices)) return false;
      if (words[0] == "l" && !follows_by_propagation(clauses, clause)) return false;
      clauses.push_back(clause);
    }
    return false;
  }

  std::string definition_;
  std::map<std::vector<std::vector<int>>, Maps> maps_;
  std::map<std::pair<const Maps*, Complex>, SlowForm> forms_;
  std::map<std::vector<std::string>, bool> refuted_;
};

}  // namespace hexatlas::sabotage
