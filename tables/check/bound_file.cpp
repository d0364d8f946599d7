#include "tables/check/bound_file.hpp"

#include "tables/check/bound_state.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/scanner.hpp"
#include "tables/check/text_lines.hpp"

namespace hexatlas::check {

namespace {

constexpr std::uint64_t kMostQuads = 64;
constexpr std::uint64_t kMostHexahedra = 64;

class BoundReader {
 public:
  BoundReader(std::string_view text, const std::string& name) : name_(name), lines_(name, text) {}

  BoundFile read() {
    header("hexatlas-bound", [](LineWords& line) { line.expect("2"); });
    header("boundary", [this](LineWords& line) { file_.code = line.word(); });
    std::uint64_t quads = 0;
    header("quads", [&quads](LineWords& line) { quads = number(line, kMostQuads); });
    for (std::uint64_t i = 0; i < quads; ++i) read_quad(quads + 2);
    header("kind", [this](LineWords& line) { file_.is_ball = choice(line, "any", "ball"); });
    header("hexahedra", [this](LineWords& line) {
      file_.hexahedra = static_cast<int>(number(line, kMostHexahedra));
    });
    header("interior", [this, quads](LineWords& line) {
      file_.interior = static_cast<int>(number(line, kMostBoundVertices));
      if (quads + 2 + static_cast<std::uint64_t>(file_.interior) > kMostBoundVertices) {
        line.fail("more vertices than the format knows");
      }
    });
    header("symmetry", [this](LineWords& line) { file_.has_symmetry = choice(line, "no", "yes"); });
    std::uint64_t bytes = 0;
    header("log", [&bytes](LineWords& line) { bytes = line.natural(); });
    file_.log = lines_.rest();
    if (file_.log.size() != bytes) {
      throw Malformed(name_, lines_.number(),
                      "the log has " + std::to_string(file_.log.size()) + " bytes");
    }
    return std::move(file_);
  }

 private:
  /// The next line must begin with `word` and have nothing after what `value` reads.
  template <class Value>
  void header(std::string_view word, const Value& value) {
    LineWords line = lines_.next();
    line.expect(word);
    value(line);
    line.expect_end();
  }

  static std::uint64_t number(LineWords& line, std::uint64_t most) {
    const std::uint64_t value = line.natural();
    if (value > most) line.fail("the number must be at most " + std::to_string(most));
    return value;
  }

  static bool choice(LineWords& line, std::string_view no, std::string_view yes) {
    const std::string_view word = line.word();
    if (word != no && word != yes) line.fail(in_quotes(word) + " is no known choice");
    return word == yes;
  }

  void read_quad(std::uint64_t vertices) {
    LineWords line = lines_.next();
    Quad& quad = file_.quads.emplace_back();
    for (std::uint32_t& vertex : quad) {
      vertex = static_cast<std::uint32_t>(number(line, vertices - 1));
    }
    line.expect_end();
  }

  const std::string& name_;
  TextLines lines_;
  BoundFile file_;
};

}  // namespace

BoundFile read_bound(std::string_view text, const std::string& name) {
  return BoundReader(text, name).read();
}

}  // namespace hexatlas::check
