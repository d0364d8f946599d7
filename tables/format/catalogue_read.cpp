#include <zstd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "enum/core/errors.hpp"
#include "tables/format/catalogue.hpp"
#include "tables/format/frame.hpp"
#include "tables/format/sha256.hpp"

namespace hexatlas::format {
namespace {

using certificate::Answer;
using certificate::Condition;
using complex::VertexSet;

constexpr std::size_t kMaxText = std::size_t{1} << 30U;

std::string decompressed(std::string_view bytes, const std::string& file) {
  if (!is_compressed(bytes)) return std::string(bytes);
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > kMaxText)
    throw core::InvalidInput(file, "no zstd frame of a known size up to 1 GiB");
  std::string text(size, '\0');
  if (!is_unpacked(bytes, text)) throw core::InvalidInput(file, "the zstd frame is damaged");
  return text;
}

/// Lines of words, with the number of the current line for messages.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw core::InvalidInput(file_, line_, reason);
  }
  void next() {
    ++line_;
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) fail("the file ends too early");
    start_ = at_;
    rest_ = text_.substr(at_, end - at_);
    at_ = end + 1;
    done_ = false;
  }
  [[nodiscard]] bool has_word() const { return !done_; }
  std::string_view word() {
    if (done_) fail("a word is missing");
    const std::size_t space = rest_.find(' ');
    const std::string_view result = rest_.substr(0, space);
    done_ = space == std::string_view::npos;
    if (!done_) rest_.remove_prefix(space + 1);
    if (result.empty()) fail("words are separated by one space");
    return result;
  }
  void expect(std::string_view wanted) {
    if (word() != wanted) fail("`" + std::string(wanted) + "` expected");
  }
  void expect_end() const {
    if (!done_) fail("too many words");
  }
  template <class Number>
  Number number(Number least, Number greatest) {
    return number_from(word(), least, greatest);
  }
  template <class Number>
  [[nodiscard]] Number number_from(std::string_view text, Number least, Number greatest) const {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < least ||
        value > greatest)
      fail("a number from " + std::to_string(least) + " to " + std::to_string(greatest) +
           " expected");
    return value;
  }
  bool yes_or_no() {
    const std::string_view text = word();
    if (text != "yes" && text != "no") fail("`yes` or `no` expected");
    return text == "yes";
  }
  [[nodiscard]] std::string_view before_line() const { return text_.substr(0, start_); }
  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }

 private:
  std::string_view text_;
  std::string file_;
  std::string_view rest_;
  std::size_t at_ = 0, start_ = 0, line_ = 0;
  bool done_ = true;
};

template <class Read>
auto line_with(Lines& lines, std::string_view key, Read&& read) {
  lines.next();
  lines.expect(key);
  auto value = read();
  lines.expect_end();
  return value;
}

std::uint8_t vertex_from(const Lines& lines, char digit, int vertices) {
  const std::size_t value = std::string_view("0123456789abcdef").find(digit);
  if (value >= static_cast<std::size_t>(vertices)) lines.fail("a vertex is out of range");
  return static_cast<std::uint8_t>(value);
}

complex::Cell cell_from(Lines& lines, int boundary_vertices) {
  std::vector<complex::CellFacet> facets;
  while (lines.has_word()) {
    const std::string_view text = lines.word();
    if (text.size() != 3 && text.size() != 4) lines.fail("a facet has three or four vertices");
    complex::CellFacet facet;
    facet.size = static_cast<std::uint8_t>(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
      facet.vertex[i] = vertex_from(lines, text[i], boundary_vertices);
    facets.push_back(facet);
  }
  auto cell = complex::cell_of(facets, boundary_vertices);
  if (const auto* broken = std::get_if<complex::BrokenLaw>(&cell)) lines.fail(broken->reason);
  if (std::get<complex::Cell>(cell).facets != facets)
    lines.fail("facets start with their least vertex and agree in orientation with the first");
  return std::get<complex::Cell>(std::move(cell));
}

VertexSet tetrahedron_from(const Lines& lines, std::string_view text, int vertices) {
  if (text.size() != 4) lines.fail("a tetrahedron has four vertices");
  unsigned set = 0;
  for (const char digit : text) {
    const unsigned bit = 1U << vertex_from(lines, digit, vertices);
    if (bit <= set) lines.fail("the vertices of a tetrahedron ascend");
    set |= bit;
  }
  return static_cast<VertexSet>(set);
}

constexpr std::int32_t kMaxLiteral = 1820;  // sets of four of sixteen vertices

certificate::Clause clause_from(Lines& lines) {
  certificate::Clause clause;
  for (;;) {
    const auto literal = lines.number<std::int32_t>(-kMaxLiteral, kMaxLiteral);
    if (literal == 0) return clause;
    clause.push_back(literal);
  }
}

template <class Term>
Term weighted_term(const Lines& lines, std::string_view first) {
  Term term;
  term.weight = lines.number_from<std::int64_t>(first, 1, (std::int64_t{1} << 40U) - 1);
  return term;
}

certificate::FinalPolynomial polynomial_from(Lines& lines) {
  certificate::FinalPolynomial polynomial{clause_from(lines), {}, {}};
  const auto small = [&lines](int least, int greatest) {
    return static_cast<std::uint8_t>(lines.number<int>(least, greatest));
  };
  while (lines.has_word()) {
    const std::string_view first = lines.word();
    if (first == "e") break;
    auto term = weighted_term<certificate::FinalPolynomialTerm>(lines, first);
    for (auto& v : term.common) v = small(0, 15);
    for (auto& v : term.others) v = small(0, 15);
    term.larger = small(1, 3);
    term.smaller = small(1, 3);
    polynomial.terms.push_back(term);
  }
  while (lines.has_word()) {
    auto term = weighted_term<certificate::EdgeTerm>(lines, lines.word());
    term.tail = small(0, 7);
    term.axis = small(0, 2);
    term.apex = small(0, 7);
    term.side = small(1, 2);
    term.larger = small(1, 2);
    polynomial.edge_terms.push_back(term);
  }
  return polynomial;
}

certificate::Lemma lemma_from(Lines& lines) {
  certificate::Lemma lemma{clause_from(lines), {}};
  constexpr auto kMax = std::numeric_limits<std::uint32_t>::max();
  while (const auto hint = lines.number<std::uint32_t>(0, kMax)) lemma.hints.push_back(hint);
  return lemma;
}

certificate::Refutation refutation_from(Lines& lines) {
  certificate::Refutation refutation;
  for (;;) {
    lines.next();
    const std::string_view kind = lines.word();
    if (kind == "c" && refutation.polynomials.empty() && refutation.lemmas.empty())
      refutation.premises.push_back(clause_from(lines));
    else if (kind == "f" && refutation.lemmas.empty())
      refutation.polynomials.push_back(polynomial_from(lines));
    else if (kind == "l")
      refutation.lemmas.push_back(lemma_from(lines));
    else if (kind == "qed")
      break;
    else
      lines.fail("`c`, `f`, `l`, in this order, or `qed` expected");
    lines.expect_end();
  }
  lines.expect_end();
  return refutation;
}

Answer answer_from(Lines& lines, int vertices) {
  const std::string_view kind = lines.word();
  if (kind == "open") return certificate::Open{};
  if (kind == "refuted") {
    lines.expect_end();
    return refutation_from(lines);
  }
  if (kind != "points") lines.fail("`points`, `refuted` or `open` expected");
  certificate::Realization points(static_cast<std::size_t>(vertices));
  constexpr std::int64_t kGreatest = certificate::kCoordinateBound - 1;
  for (auto& point : points)
    for (auto& coordinate : point) coordinate = lines.number<std::int64_t>(-kGreatest, kGreatest);
  return points;
}

CatalogueClass class_from(Lines& lines, std::size_t number, int vertices) {
  lines.expect(std::to_string(number));
  CatalogueClass entry;
  entry.triangulation.vertices = vertices;
  entry.automorphisms = lines.number<std::uint64_t>(1, std::numeric_limits<std::uint64_t>::max());
  std::string_view text = lines.word();
  entry.shelled = text != "unshelled";
  if (!entry.shelled) text = lines.word();
  entry.triangulation.tetrahedra.push_back(tetrahedron_from(lines, text, vertices));
  while (lines.has_word())
    entry.triangulation.tetrahedra.push_back(tetrahedron_from(lines, lines.word(), vertices));
  return entry;
}

Catalogue header_from(Lines& lines, std::size_t& classes) {
  constexpr auto kMax = std::numeric_limits<std::uint64_t>::max();
  const auto word = [&] { return std::string(lines.word()); };
  const auto natural = [&] { return lines.number<std::uint64_t>(0, kMax); };
  lines.next();
  for (const char* wanted : {"hexatlas", "catalogue", "1"}) lines.expect(wanted);
  lines.expect_end();
  if (line_with(lines, "definition", word) != definition_digest())
    lines.fail("the catalogue belongs to another definition");
  Catalogue catalogue;
  const std::string kind = line_with(lines, "kind", word);
  if (kind != "cell" && kind != "balls") lines.fail("`cell` or `balls` expected");
  catalogue.name = line_with(lines, "name", word);
  catalogue.vertices = line_with(
      lines, "vertices", [&] { return lines.number<int>(4, complex::kMaxTriangulationVertices); });
  catalogue.interior =
      line_with(lines, "interior", [&] { return lines.number<int>(0, catalogue.vertices - 4); });
  if (kind == "cell") {
    catalogue.boundary_tetrahedra =
        line_with(lines, "boundary-tetrahedra", [&] { return lines.yes_or_no(); });
    catalogue.cell = line_with(
        lines, "facets", [&] { return cell_from(lines, catalogue.vertices - catalogue.interior); });
    catalogue.symmetries = line_with(lines, "symmetries", natural);
  }
  classes = line_with(lines, "classes", natural);
  if (kind == "cell") catalogue.labelled = line_with(lines, "labelled", natural);
  catalogue.exhaustive = line_with(lines, "exhaustive", [&] { return lines.yes_or_no(); });
  return catalogue;
}

}  // namespace

Catalogue catalogue_from(std::string_view bytes, const std::string& file) {
  const std::string text = decompressed(bytes, file);
  Lines lines(text, file);
  std::size_t classes = 0;
  Catalogue catalogue = header_from(lines, classes);
  for (;;) {
    lines.next();
    const std::string_view key = lines.word();
    if (key == "end") break;
    if (key == "class") {
      catalogue.classes.push_back(
          class_from(lines, catalogue.classes.size() + 1, catalogue.vertices));
      continue;
    }
    const auto condition =
        std::find_if(certificate::kConditions.begin(), certificate::kConditions.end(),
                     [&](Condition c) { return certificate::name_of(c) == key; });
    if (condition == certificate::kConditions.end() || catalogue.classes.empty())
      lines.fail("`class`, a condition of a class, or `end` expected");
    auto& answers = catalogue.classes.back().answers;
    auto& answer = answers[static_cast<std::size_t>(*condition)];
    if (std::any_of(answers.begin() + static_cast<std::ptrdiff_t>(*condition), answers.end(),
                    [](const auto& later) { return later.has_value(); }))
      lines.fail("a condition comes twice or out of order");
    answer = answer_from(lines, catalogue.vertices);
    lines.expect_end();
  }
  const std::string digest = to_hex(sha256(std::array{lines.before_line()}));
  if (lines.word() != digest) lines.fail("the digest is not that of the lines above");
  lines.expect_end();
  if (!lines.at_end()) lines.fail("there is something after the end");
  if (catalogue.classes.size() != classes) lines.fail("the number of classes is another");
  return catalogue;
}

}  // namespace hexatlas::format
