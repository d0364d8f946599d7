#include "tables/format/catalogue.hpp"

#include <array>

#include "tables/format/sha256.hpp"

namespace hexatlas::format {
namespace {

using complex::VertexSet;

constexpr std::string_view kDigits = "0123456789abcdef";

void append_vertices(std::string& text, VertexSet set) {
  for (; set != 0; set = complex::without_least(set))
    text += kDigits[static_cast<std::size_t>(complex::least_vertex(set))];
}

void append_clause(std::string& text, const certificate::Clause& clause) {
  for (const certificate::Literal literal : clause) text += " " + std::to_string(literal);
  text += " 0";
}

void append_refutation(std::string& text, const certificate::Refutation& refutation) {
  for (const auto& premise : refutation.premises) {
    text += "c";
    append_clause(text, premise);
    text += "\n";
  }
  for (const auto& polynomial : refutation.polynomials) {
    text += "f";
    append_clause(text, polynomial.clause);
    for (const auto& term : polynomial.terms) {
      text += " " + std::to_string(term.weight);
      for (const auto vertex : term.common) text += " " + std::to_string(vertex);
      for (const auto vertex : term.others) text += " " + std::to_string(vertex);
      text += " " + std::to_string(term.larger) + " " + std::to_string(term.smaller);
    }
    if (!polynomial.edge_terms.empty()) text += " e";
    for (const auto& term : polynomial.edge_terms) {
      text += " " + std::to_string(term.weight);
      for (const int number : {term.tail, term.axis, term.apex, term.side, term.larger})
        text += " " + std::to_string(number);
    }
    text += "\n";
  }
  for (const auto& lemma : refutation.lemmas) {
    text += "l";
    append_clause(text, lemma.clause);
    for (const std::uint32_t hint : lemma.hints) text += " " + std::to_string(hint);
    text += " 0\n";
  }
  text += "qed\n";
}

struct AppendAnswer {
  std::string& text;
  void operator()(const certificate::Open&) const { text += " open\n"; }
  void operator()(const certificate::Realization& points) const {
    text += " points";
    for (const auto& point : points)
      for (const std::int64_t coordinate : point) text += " " + std::to_string(coordinate);
    text += "\n";
  }
  void operator()(const certificate::Refutation& refutation) const {
    text += " refuted\n";
    append_refutation(text, refutation);
  }
};

std::string header(const Catalogue& catalogue) {
  const auto yes_no = [](bool value) { return value ? "yes\n" : "no\n"; };
  std::string text = "hexatlas catalogue 1\ndefinition " + std::string(definition_digest()) +
                     "\nkind " + (catalogue.cell ? "cell" : "balls") + "\nname " + catalogue.name +
                     "\nvertices " + std::to_string(catalogue.vertices) + "\ninterior " +
                     std::to_string(catalogue.interior) + "\n";
  if (catalogue.cell) {
    text += "boundary-tetrahedra ";
    text += yes_no(catalogue.boundary_tetrahedra);
    text += "facets";
    for (const auto& facet : catalogue.cell->facets) {
      text += " ";
      for (std::size_t i = 0; i < facet.size; ++i) text += kDigits[facet.vertex[i]];
    }
    text += "\nsymmetries " + std::to_string(catalogue.symmetries) + "\n";
  }
  text += "classes " + std::to_string(catalogue.classes.size()) + "\n";
  if (catalogue.cell) text += "labelled " + std::to_string(catalogue.labelled) + "\n";
  text += "exhaustive ";
  return text + yes_no(catalogue.exhaustive);
}

}  // namespace

std::string_view definition_digest() {
  return "17153c2e79d354ff76005078f00c01b64715358ecdf9379c22a2df925e13e4ab";
}

std::string catalogue_bytes(const Catalogue& catalogue) {
  std::string text = header(catalogue);
  std::size_t number = 0;
  for (const CatalogueClass& entry : catalogue.classes) {
    text += "class " + std::to_string(++number) + " " + std::to_string(entry.automorphisms);
    if (!entry.shelled) text += " unshelled";
    for (const VertexSet tetrahedron : entry.triangulation.tetrahedra) {
      text += " ";
      append_vertices(text, tetrahedron);
    }
    text += "\n";
    for (const certificate::Condition condition : certificate::kConditions) {
      const auto& answer = entry.answers[static_cast<std::size_t>(condition)];
      if (!answer) continue;
      text += certificate::name_of(condition);
      std::visit(AppendAnswer{text}, *answer);
    }
  }
  return text + "end " + to_hex(sha256(std::array{std::string_view(text)})) + "\n";
}

}  // namespace hexatlas::format
