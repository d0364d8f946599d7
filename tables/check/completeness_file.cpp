#include <bit>
#include <set>
#include <utility>

#include "tables/check/catalogue.hpp"
#include "tables/check/catalogue_read.hpp"
#include "tables/check/completeness.hpp"
#include "tables/check/completeness_rules.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/scanner.hpp"
#include "tables/check/text_lines.hpp"
#include "tables/check/zstd_frame.hpp"

namespace hexatlas::check {

namespace {

std::string unpacked(std::string bytes, const std::string& name) {
  if (!begins_zstd_frame(bytes)) return bytes;
  std::string text;
  if (!unpack_frame(bytes, kMostText, text)) {
    throw Malformed(name, 0, "is not one Zstandard frame, or is too large");
  }
  return text;
}

/// One line, which begins with `word`; the reader reads the rest.
LineWords line_with(TextLines& lines, std::string_view word) {
  LineWords line = lines.next();
  line.expect(word);
  return line;
}

CubeSet read_tetrahedron(LineWords& line) {
  const std::string_view word = line.word();
  unsigned bits = 0;
  for (const char c : word) {
    const unsigned bit = c >= '0' && c <= '7' ? 1U << (c - '0') : 0;
    if (bit <= bits) line.fail(in_quotes(word) + " is no list of ascending vertices");
    bits |= bit;
  }
  if (std::popcount(bits) != 4) line.fail(in_quotes(word) + " is no tetrahedron");
  return static_cast<CubeSet>(bits);
}

struct Certificate {
  std::string definition;
  std::vector<Obstruction> obstructions;
  std::string_view proof;
  std::size_t proof_line = 0;
};

Certificate read_certificate(std::string_view text, const std::string& name) {
  TextLines lines(name, text);
  LineWords first = line_with(lines, "hexatlas");
  first.expect("completeness");
  first.expect("1");
  first.expect_end();
  Certificate result;
  LineWords definition = line_with(lines, "definition");
  result.definition = definition.word();
  definition.expect_end();
  LineWords count = line_with(lines, "obstructions");
  const std::uint64_t obstructions = count.natural();
  count.expect_end();
  while (lines.peek() == "obstruction") {
    LineWords line = line_with(lines, "obstruction");
    Obstruction& obstruction = result.obstructions.emplace_back();
    const std::uint64_t vertex = line.natural();
    if (vertex >= kCubeVertices) line.fail("the cube has no such vertex");
    obstruction.vertex = static_cast<unsigned>(vertex);
    while (!line.at_end()) obstruction.tetrahedra.push_back(read_tetrahedron(line));
  }
  if (result.obstructions.size() != obstructions) count.fail("wrong number of obstructions");
  line_with(lines, "proof").expect_end();
  result.proof = lines.rest();
  result.proof_line = lines.number();
  return result;
}

/// Whether the facets are those of the cube, each as a circle of its edges.
bool are_cube_facets(const std::vector<CellFacet>& facets) {
  std::set<unsigned> sets;
  for (const CellFacet& facet : facets) {
    unsigned set = 0;
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const unsigned step = static_cast<unsigned>(facet[i]) ^ facet[(i + 1) % facet.size()];
      if (!std::has_single_bit(step) || facet[i] >= kCubeVertices) return false;
      set |= 1U << facet[i];
    }
    if (std::popcount(set) != 4) return false;
    sets.insert(set);
  }
  // A circle of four different vertices of the cube is a facet.
  return facets.size() == kCubeFacets && sets.size() == kCubeFacets;
}

}  // namespace

CompletenessVerdict check_completeness_bytes(std::string catalogue,
                                             const std::string& catalogue_name,
                                             std::string certificate,
                                             const std::string& certificate_name) {
  const std::string text = unpacked(std::move(catalogue), catalogue_name);
  const CatalogueText listed = read_catalogue(text, catalogue_name);
  const std::string certified = unpacked(std::move(certificate), certificate_name);
  const Certificate found = read_certificate(certified, certificate_name);
  CompletenessVerdict verdict;
  if (!listed.is_cell || listed.interior != 0 || listed.boundary_tetrahedra ||
      !are_cube_facets(listed.facets)) {
    verdict.fault =
        "the catalogue is not of the hexahedron without interior vertex and without "
        "boundary tetrahedra";
    return verdict;
  }
  if (listed.definition != found.definition) {
    verdict.fault = "catalogue and certificate have different definitions";
    return verdict;
  }
  CompletenessInput input{{}, found.obstructions};
  for (const CatalogueClass& each : listed.list) input.classes.push_back(each.tetrahedra);
  return check_completeness(input, found.proof, certificate_name, found.proof_line);
}

std::string certificate_text(const std::string& definition,
                             const std::vector<Obstruction>& obstructions, std::string_view proof) {
  std::string text = "hexatlas completeness 1\ndefinition " + definition + "\nobstructions " +
                     std::to_string(obstructions.size()) + "\n";
  for (const Obstruction& obstruction : obstructions) {
    text += "obstruction " + std::to_string(obstruction.vertex);
    for (const std::uint16_t tetrahedron : obstruction.tetrahedra) {
      text += ' ';
      for (const unsigned v : cube_vertices(tetrahedron)) text += static_cast<char>('0' + v);
    }
    text += '\n';
  }
  text += "proof\n";
  return text.append(proof);
}

}  // namespace hexatlas::check
