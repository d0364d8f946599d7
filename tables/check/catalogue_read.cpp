#include "tables/check/catalogue_read.hpp"

#include <algorithm>
#include <bit>

#include "tables/check/malformed.hpp"
#include "tables/check/scanner.hpp"
#include "tables/check/sha256.hpp"
#include "tables/check/text_lines.hpp"

namespace hexatlas::check {

namespace {

constexpr std::int64_t kCoordinateBound = std::int64_t{1} << 20;
constexpr int kLeastVertices = 4;
constexpr std::array<std::string_view, 3> kConditionWords = {"embedded", "convex", "jacobian"};

bool is_lower_hex(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

std::uint8_t hex_value(char c) {
  return static_cast<std::uint8_t>(c <= '9' ? c - '0' : c - 'a' + 10);
}

class CatalogueReader {
 public:
  CatalogueReader(std::string_view text, const std::string& file)
      : file_(file), text_(text), lines_(file, text) {}

  CatalogueText read() {
    read_header();
    while (lines_.peek() == "class") read_class();
    const std::size_t signed_bytes = text_.size() - lines_.rest().size();
    LineWords line = lines_.next();
    line.expect("end");
    const std::string digest = read_digest(line);
    line.expect_end();
    if (!lines_.at_end()) throw Malformed(file_, lines_.number(), "a line after the end");
    result_.digest_holds = digest == sha256_hex_of(text_.substr(0, signed_bytes));
    return std::move(result_);
  }

 private:
  void read_header() {
    LineWords first = lines_.next();
    first.expect("hexatlas");
    first.expect("catalogue");
    first.expect("1");
    first.expect_end();
    header("definition", [this](LineWords& line) { result_.definition = read_digest(line); });
    header("kind", [this](LineWords& line) { result_.is_cell = choice(line, "balls", "cell"); });
    header("name", [this](LineWords& line) { result_.name = read_name(line); });
    header("vertices", [this](LineWords& line) {
      result_.vertices = small_number(line, kLeastVertices, kMostCatalogueVertices);
    });
    header("interior", [this](LineWords& line) {
      const int most = result_.is_cell ? result_.vertices - kLeastVertices : 0;
      result_.interior = small_number(line, 0, most);
    });
    if (result_.is_cell) read_cell();
    header("classes", [this](LineWords& line) { result_.classes = line.natural(); });
    if (result_.is_cell) {
      header("labelled", [this](LineWords& line) { result_.labelled = line.natural(); });
    }
    header("exhaustive",
           [this](LineWords& line) { result_.exhaustive = choice(line, "no", "yes"); });
  }

  void read_cell() {
    header("boundary-tetrahedra",
           [this](LineWords& line) { result_.boundary_tetrahedra = choice(line, "no", "yes"); });
    header("facets", [this](LineWords& line) {
      while (!line.at_end()) result_.facets.push_back(read_facet(line));
    });
    header("symmetries", [this](LineWords& line) { result_.symmetries = line.natural(); });
  }

  /// The next line must begin with `word` and have nothing after what `value` reads.
  template <class Value>
  void header(std::string_view word, const Value& value) {
    LineWords line = lines_.next();
    line.expect(word);
    value(line);
    line.expect_end();
  }

  [[nodiscard]] static bool choice(LineWords& line, std::string_view no, std::string_view yes) {
    const std::string_view found = line.word();
    if (found != no && found != yes) {
      line.fail("expected '" + std::string(no) + "' or '" + std::string(yes) + "', found " +
                in_quotes(found));
    }
    return found == yes;
  }

  [[nodiscard]] static std::string read_digest(LineWords& line) {
    const std::string_view found = line.word();
    if (found.size() != 64 || !std::all_of(found.begin(), found.end(), is_lower_hex)) {
      line.fail("expected 64 lower-case hexadecimal digits, found " + in_quotes(found));
    }
    return std::string(found);
  }

  [[nodiscard]] static std::string read_name(LineWords& line) {
    const std::string_view found = line.word();
    const bool is_name = std::all_of(found.begin(), found.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
    if (!is_name) line.fail("the name " + in_quotes(found) + " is no word of [a-z0-9-]");
    return std::string(found);
  }

  [[nodiscard]] static int small_number(LineWords& line, int least, int most) {
    const std::uint64_t value = line.natural();
    if (value < static_cast<std::uint64_t>(least) || value > static_cast<std::uint64_t>(most)) {
      line.fail("the number " + std::to_string(value) + " is not among " + std::to_string(least) +
                " .. " + std::to_string(most));
    }
    return static_cast<int>(value);
  }

  [[nodiscard]] static std::uint8_t vertex(const LineWords& line, char digit, int bound) {
    if (!is_lower_hex(digit) || hex_value(digit) >= bound) {
      line.fail(in_quotes({&digit, 1}) + " is no vertex");
    }
    return hex_value(digit);
  }

  [[nodiscard]] CellFacet read_facet(LineWords& line) const {
    const std::string_view word = line.word();
    if (word.size() != 3 && word.size() != 4) {
      line.fail("the facet " + in_quotes(word) + " has not three or four vertices");
    }
    CellFacet facet;
    for (const char c : word) {
      facet.push_back(vertex(line, c, result_.vertices - result_.interior));
    }
    return facet;
  }

  [[nodiscard]] VertexBits tetrahedron(const LineWords& line, std::string_view word) const {
    if (word.size() != 4) line.fail(in_quotes(word) + " is no tetrahedron");
    unsigned bits = 0;
    for (const char c : word) {
      const unsigned bit = 1U << vertex(line, c, result_.vertices);
      if (bit <= bits) line.fail("the digits of " + in_quotes(word) + " do not ascend");
      bits |= bit;
    }
    return static_cast<VertexBits>(bits);
  }

  void read_class() {
    LineWords line = lines_.next();
    line.expect("class");
    CatalogueClass& item = result_.list.emplace_back();
    item.number = line.natural();
    item.automorphisms = line.natural();
    std::string_view word = line.word();
    item.shelled = word != "unshelled";
    if (!item.shelled) word = line.word();
    item.tetrahedra.push_back(tetrahedron(line, word));
    while (!line.at_end()) item.tetrahedra.push_back(tetrahedron(line, line.word()));
    if (!item.shelled && !std::is_sorted(item.tetrahedra.begin(), item.tetrahedra.end())) {
      line.fail("the tetrahedra of an unshelled ball must ascend");
    }
    for (std::size_t c = 0; c < kConditionWords.size(); ++c) {
      if (lines_.peek() == kConditionWords[c]) {
        read_property(item.properties.emplace_back(), static_cast<Condition>(c));
      }
    }
  }

  void read_property(Property& property, Condition condition) {
    LineWords line = lines_.next();
    property.condition = condition;
    if (condition == Condition::kJacobian &&
        (!result_.is_cell || result_.name != "hexahedron" || result_.interior != 0)) {
      line.fail("only the hexahedron without interior vertex has a Jacobian determinant");
    }
    line.expect(kConditionWords[static_cast<std::size_t>(condition)]);
    const std::string_view answer = line.word();
    if (answer == "points") {
      property.answer = Property::Answer::kPoints;
      for (int v = 0; v < result_.vertices; ++v) property.points.push_back(read_point(line));
    } else if (answer == "refuted") {
      property.answer = Property::Answer::kRefuted;
    } else if (answer != "open") {
      line.fail("expected 'points', 'refuted' or 'open', found " + in_quotes(answer));
    }
    line.expect_end();
    if (property.answer == Property::Answer::kRefuted) skip_refutation(property.refutation);
  }

  [[nodiscard]] static LatticePoint read_point(LineWords& line) {
    LatticePoint point{};
    for (std::int64_t& coordinate : point) {
      coordinate = line.integer();
      if (coordinate <= -kCoordinateBound || coordinate >= kCoordinateBound) {
        line.fail("the coordinate " + std::to_string(coordinate) + " is not below 2^20");
      }
    }
    return point;
  }

  void skip_refutation(RefutationText& refutation) {
    refutation.first = lines_.number();
    const std::string_view from = lines_.rest();
    while (lines_.peek() != "qed") {
      if (lines_.at_end()) throw Malformed(file_, lines_.number(), "a refutation without 'qed'");
      (void)lines_.next();
    }
    refutation.lines = from.substr(0, from.size() - lines_.rest().size());
    LineWords line = lines_.next();
    line.expect("qed");
    line.expect_end();
  }

  const std::string& file_;
  std::string_view text_;
  TextLines lines_;
  CatalogueText result_;
};

}  // namespace

CatalogueText read_catalogue(std::string_view text, const std::string& file) {
  return CatalogueReader(text, file).read();
}

}  // namespace hexatlas::check
