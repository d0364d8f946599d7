// Geomview OFF. Source: the Geomview manual, section "OFF Files". One vertex and one polygon per
// line, as all programs write it; colours at the end of a line are ignored.
#include <vector>

#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kLongestColour = 4;  // red, green, blue, alpha

void next_line(Scanner& scanner, Words& words, const char* expected) {
  if (!scanner.next_line(words)) scanner.fail_cut(expected);
}

void check_colour(const Scanner& scanner, const Words& words, std::size_t first) {
  if (words.size() > first + kLongestColour) scanner.fail("more numbers than a colour has");
  for (std::size_t i = first; i < words.size(); ++i) static_cast<void>(scanner.to_real(words[i]));
}

/// The words of the line with the counts, which may follow the keyword on its line.
void read_header(Scanner& scanner, Words& words) {
  next_line(scanner, words, "the keyword OFF");
  if (words[0] != "OFF" && words[0] != "COFF")
    scanner.fail("the keyword OFF or COFF is expected, not " + in_quotes(words[0]));
  if (words.size() > 1 && words[1] == "BINARY") scanner.fail("binary OFF; save as ASCII");
  words.erase(words.begin());
  if (words.empty()) next_line(scanner, words, "the counts");
  if (words.size() != 2 && words.size() != 3)
    scanner.fail("the numbers of vertices, faces and edges are expected");
}

void read_vertex(const Scanner& scanner, const Words& words, MeshBuilder& builder) {
  if (words.size() < 3) scanner.fail("vertex with fewer than 3 coordinates");
  check_colour(scanner, words, 3);
  builder.add_point(
      {scanner.to_real(words[0]), scanner.to_real(words[1]), scanner.to_real(words[2])},
      scanner.line());
}

void read_face(const Scanner& scanner, const Words& words, std::vector<mesh::Index>& corners,
               MeshBuilder& builder) {
  const std::int64_t size = scanner.to_integer(words[0]);
  if (size < 1 || static_cast<std::uint64_t>(size) > words.size() - 1)
    scanner.fail("face of " + std::to_string(size) + " corners on a line with " +
                 std::to_string(words.size() - 1) + " further numbers");
  const auto end = static_cast<std::size_t>(size) + 1;
  corners.clear();
  for (std::size_t i = 1; i < end; ++i)
    corners.push_back(scanner.to_index(scanner.to_integer(words[i]), 0));
  check_colour(scanner, words, end);
  builder.add_cell(polygon_type(corners.size()), corners, scanner.line());
}

}  // namespace

void read_off(std::string_view bytes, MeshBuilder& builder) {
  constexpr std::size_t kVertexBytes = 6;  // "0 0 0" and the end of the line
  constexpr std::size_t kFaceBytes = 4;    // "1 0" and the end of the line
  Scanner scanner(bytes, builder.file(), '#');
  scanner.refuse_nul();
  Words words;
  read_header(scanner, words);
  const std::size_t vertices = scanner.to_count(scanner.to_integer(words[0]), kVertexBytes);
  const std::size_t faces = scanner.to_count(scanner.to_integer(words[1]), kFaceBytes);
  // The number of edges is often given as 0: it is not used.
  if (words.size() == 3 && scanner.to_integer(words[2]) < 0)
    scanner.fail("the number of edges is negative");
  builder.reserve_points(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    next_line(scanner, words, "a vertex");
    read_vertex(scanner, words, builder);
  }
  builder.reserve_cells(kQuad, faces);
  std::vector<mesh::Index> corners;
  for (std::size_t i = 0; i < faces; ++i) {
    next_line(scanner, words, "a face");
    read_face(scanner, words, corners, builder);
  }
  if (scanner.next_line(words)) scanner.fail("more lines than the counts announce");
}

}  // namespace hexatlas::io
