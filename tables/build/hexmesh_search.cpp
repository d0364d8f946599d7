#include "tables/build/hexmesh_search.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/core/errors.hpp"
#include "tables/format/frame.hpp"
#include "tables/format/sha256.hpp"

namespace hexatlas::build {
namespace {

constexpr std::string_view kFirstLine = "hexatlas-search 1";
/// Of the search tree: to be raised when HexSearch takes its choices in another order.
constexpr int kTreeVersion = 3;

std::string_view yes_or_no(bool value) { return value ? "yes" : "no"; }

/// What must be the same to go on.
std::vector<std::pair<std::string, std::string>> header_of(const HexmeshTask& task) {
  return {{"tree", std::to_string(kTreeVersion)},
          {"boundary", canon::to_text(canon::canonical_form(task.boundary).code)},
          {"kind", task.limits.ball ? "ball" : "any"},
          {"hexahedra", std::to_string(task.limits.max_hexahedra)},
          {"interior", std::to_string(task.limits.max_interior)},
          {"shard", std::to_string(task.part) + "/" + std::to_string(task.parts)}};
}

std::string digest_line(std::string_view text) {
  return "sha256 " + format::to_hex(format::sha256(std::array{text})) + "\n";
}

/// Lines of words and numbers.
class Lines {
 public:
  Lines(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw core::InvalidInput(name_, line_, reason);
  }
  [[nodiscard]] bool at_end() const { return text_.empty(); }
  std::string_view line() {
    ++line_;
    const std::size_t end = text_.find('\n');
    if (end == std::string_view::npos) fail("the file is cut short");
    const std::string_view result = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    return result;
  }
  /// The rest of a line after a word.
  std::string_view after(std::string_view word) {
    const std::string_view whole = line();
    if (!whole.starts_with(word) || whole.size() <= word.size() || whole[word.size()] != ' ')
      fail("a line with " + std::string(word) + " is expected");
    return whole.substr(word.size() + 1);
  }
  std::vector<std::uint64_t> numbers_after(std::string_view word, std::uint64_t most) {
    return numbers(after(word), most);
  }
  [[nodiscard]] std::vector<std::uint64_t> numbers(std::string_view words,
                                                   std::uint64_t most) const {
    std::vector<std::uint64_t> result;
    while (!words.empty()) {
      std::uint64_t value = 0;
      const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
      if (error != std::errc() || value > most)
        fail("a number is expected, at most " + std::to_string(most));
      result.push_back(value);
      words.remove_prefix(static_cast<std::size_t>(end - words.data()));
      if (words.starts_with(' ')) words.remove_prefix(1);
    }
    return result;
  }
  std::uint64_t number_after(std::string_view word) {
    const auto values = numbers_after(word, ~std::uint64_t{0});
    if (values.size() != 1) fail("one number is expected");
    return values.front();
  }

 private:
  std::string_view text_;
  std::string name_;
  int line_ = 0;
};

void expect(Lines& lines, const std::string& word, const std::string& value) {
  const std::string_view saved = lines.after(word);
  if (saved != value)
    lines.fail("a search with " + word + " " + std::string(saved) + ", not " + value);
}

std::string line_of(const hexes::Hexmesh& found) {
  std::string text = "mesh " + std::to_string(found.mesh.vertices) + " " +
                     std::to_string(found.automorphisms) + " " +
                     std::to_string(static_cast<int>(found.topology));
  for (const complex::Hexahedron& cell : found.mesh.hexahedra)
    for (const complex::VertexId v : cell) text += " " + std::to_string(v);
  return text + "\n";
}

/// A mesh of the search whose boundary has so many symmetries.
hexes::Hexmesh mesh_from(Lines& lines, const HexmeshTask& task, std::uint64_t symmetries) {
  const auto values =
      lines.numbers_after("mesh", std::max<std::uint64_t>(hexes::kMaxMeshVertices, symmetries));
  if (values.size() < 3 || (values.size() - 3) % 8 != 0 || values[2] > 2)
    lines.fail("a mesh has vertices, automorphisms, topology and eight numbers per hexahedron");
  const auto least = static_cast<std::uint64_t>(task.boundary.vertices());
  if (values[0] < least || values[0] > hexes::kMaxMeshVertices || values[1] == 0 ||
      symmetries % values[1] != 0 ||
      std::any_of(values.begin() + 3, values.end(), [&](auto v) { return v >= values[0]; }))
    lines.fail("no mesh of this search");
  hexes::Hexmesh found;
  found.mesh.vertices = static_cast<std::uint32_t>(values[0]);
  found.automorphisms = static_cast<int>(values[1]);
  found.topology = static_cast<hexes::Topology>(values[2]);
  for (std::size_t at = 3; at < values.size(); at += 8) {
    complex::Hexahedron& cell = found.mesh.hexahedra.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) cell[i] = static_cast<complex::VertexId>(values[at + i]);
  }
  return found;
}

/// Whether the choices of a root are there, all but the last one accepted.
bool is_node(hexes::HexSearch& search, const search::Root<hexes::HexSearch::Choice>& root) {
  std::size_t applied = 0;
  bool is_one = true;
  for (; is_one && applied < root.size(); ++applied) {
    is_one = false;
    for (const hexes::HexSearch::Choice choice : search.choices())
      is_one = is_one || choice == root[applied];
    if (applied + 1 == root.size()) break;
    is_one = is_one && search.apply(root[applied]);
    if (!is_one) break;
  }
  for (; applied > 0; --applied) search.undo();
  return is_one;
}

}  // namespace

std::string to_text(const HexmeshTask& task, const hexes::HexFrontier& frontier) {
  std::string text(kFirstLine);
  text += '\n';
  for (const auto& [word, value] : header_of(task))
    text.append(word).append(" ").append(value).append("\n");
  text += "nodes " + std::to_string(frontier.counts.nodes) + "\n";
  text += "met " + std::to_string(frontier.counts.solutions) + "\n";
  text += "meshes " + std::to_string(frontier.found.size()) + "\n";
  for (const hexes::Hexmesh& found : frontier.found) text += line_of(found);
  text += "pending " + std::to_string(frontier.pending.size()) + "\n";
  for (const auto& root : frontier.pending) {
    text += "root";
    for (const hexes::HexSearch::Choice choice : root) text += " " + std::to_string(choice.top);
    text += root.empty() ? " \n" : "\n";
  }
  return text + digest_line(text);
}

hexes::HexFrontier frontier_from(std::string_view text, const HexmeshTask& task,
                                 const std::string& name) {
  Lines lines(text, name);
  if (text.find('\n') == std::string_view::npos || lines.line() != kFirstLine)
    throw core::InvalidInput(name, "is no saved search of this kind");
  const std::size_t end = text.rfind("sha256 ");
  if (end == std::string_view::npos || digest_line(text.substr(0, end)) != text.substr(end))
    throw core::InvalidInput(name, "a saved search that is damaged");
  for (const auto& [word, value] : header_of(task)) expect(lines, word, value);
  hexes::HexFrontier frontier;
  frontier.counts.nodes = lines.number_after("nodes");
  frontier.counts.solutions = lines.number_after("met");
  const auto symmetries =
      static_cast<std::uint64_t>(canon::canonical_form(task.boundary).automorphisms);
  for (auto left = lines.number_after("meshes"); left > 0; --left)
    frontier.found.push_back(mesh_from(lines, task, symmetries));
  frontier.pending.clear();
  hexes::SearchLimits limits = task.limits;
  limits.up_to_symmetry = true;
  hexes::HexSearch search(task.boundary, limits);
  for (auto left = lines.number_after("pending"); left > 0; --left) {
    search::Root<hexes::HexSearch::Choice> root;
    for (const std::uint64_t top : lines.numbers_after("root", hexes::kMaxMeshVertices - 1))
      root.push_back({static_cast<hexes::Vertex>(top)});
    if (!is_node(search, root)) lines.fail("no node of this search");
    frontier.pending.push_back(std::move(root));
  }
  (void)lines.line();  // the digest
  if (!lines.at_end()) lines.fail("more roots than said");
  return frontier;
}

std::string bound_certificate(const complex::Quadrangulation& boundary,
                              const hexes::SearchLimits& limits, const hexes::BoundLog& log) {
  std::string text = "hexatlas-bound 2\nboundary " +
                     canon::to_text(canon::canonical_form(boundary).code) + "\nquads " +
                     std::to_string(boundary.quads()) + "\n";
  for (const auto& quad : boundary.list_of_quads()) {
    for (std::size_t i = 0; i < 4; ++i) text += (i == 0 ? "" : " ") + std::to_string(quad[i]);
    text += "\n";
  }
  text += "kind " + std::string(limits.ball ? "ball" : "any") + "\nhexahedra " +
          std::to_string(limits.max_hexahedra) + "\ninterior " +
          std::to_string(limits.max_interior) + "\nsymmetry " +
          std::string(yes_or_no(limits.up_to_symmetry)) + "\nlog " +
          std::to_string(log.bytes.size()) + "\n";
  return format::compressed(text + log.bytes);
}

}  // namespace hexatlas::build
