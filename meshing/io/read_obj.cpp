// Wavefront OBJ. Source: the specification in the Advanced Visualizer manual, appendix B1. Vertices
// count from 1; a negative index counts back from the last vertex read so far. Faces may come
// before the vertices that they use.
#include <algorithm>
#include <array>
#include <vector>

#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

using Words = std::vector<std::string_view>;

/// Records of the specification that say nothing of polygons.
bool is_ignored(std::string_view keyword) {
  constexpr std::array<std::string_view, 40> kIgnored{
      "vt",        "vn",       "vp",    "deg",    "bmat",   "step",   "cstype", "p",
      "l",         "curv",     "curv2", "surf",   "parm",   "trim",   "hole",   "scrv",
      "sp",        "end",      "con",   "g",      "s",      "mg",     "o",      "bevel",
      "c_interp",  "d_interp", "lod",   "usemtl", "mtllib", "maplib", "usemap", "shadow_obj",
      "trace_obj", "ctech",    "stech", "call",   "csh",    "cdc",    "cdp",    "bzp"};
  return std::find(kIgnored.begin(), kIgnored.end(), keyword) != kIgnored.end();
}

void read_vertex(const Scanner& scanner, const Words& words, MeshBuilder& builder) {
  // x y z, then a weight, or a colour, or both.
  if (words.size() < 4 || words.size() > 8)
    scanner.fail("vertex with " + std::to_string(words.size() - 1) + " numbers");
  std::array<double, 7> numbers{};
  for (std::size_t i = 1; i < words.size(); ++i) numbers[i - 1] = scanner.to_real(words[i]);
  builder.add_point({numbers[0], numbers[1], numbers[2]}, scanner.line());
}

mesh::Index vertex_of(const Scanner& scanner, std::string_view word, std::size_t vertices_so_far) {
  const std::int64_t number = scanner.to_integer(word);
  if (number >= 0) return scanner.to_index(number, 1);
  if (number < -static_cast<std::int64_t>(vertices_so_far))
    scanner.fail("index " + std::to_string(number) + " counts back beyond the first of " +
                 std::to_string(vertices_so_far) + " vertices");
  return scanner.to_index(static_cast<std::int64_t>(vertices_so_far) + number, 0);
}

/// "v", "v/vt", "v//vn" or "v/vt/vn": the vertex.
mesh::Index read_corner(const Scanner& scanner, std::string_view corner,
                        std::size_t vertices_so_far) {
  const std::size_t slash = corner.find('/');
  const mesh::Index vertex = vertex_of(scanner, corner.substr(0, slash), vertices_so_far);
  if (slash == std::string_view::npos) return vertex;
  const std::string_view rest = corner.substr(slash + 1);
  const std::size_t second = rest.find('/');
  const bool has_normal = second != std::string_view::npos;
  const auto check = [&](std::string_view number) {
    if (scanner.to_integer(number) == 0) scanner.fail("index 0 in " + in_quotes(corner));
  };
  if (!has_normal || second > 0) check(rest.substr(0, second));
  if (has_normal) check(rest.substr(second + 1));
  return vertex;
}

}  // namespace

void read_obj(std::string_view bytes, MeshBuilder& builder) {
  Scanner scanner(bytes, builder.file(), '#');
  scanner.refuse_nul();
  Words words;
  std::vector<mesh::Index> corners;
  while (scanner.next_line(words)) {
    if (words[0] == "v") {
      read_vertex(scanner, words, builder);
    } else if (words[0] == "f") {
      corners.clear();
      for (std::size_t i = 1; i < words.size(); ++i)
        corners.push_back(read_corner(scanner, words[i], builder.point_count()));
      builder.add_cell(polygon_type(corners.size()), corners, scanner.line());
    } else if (!is_ignored(words[0])) {
      scanner.fail("unknown record " + in_quotes(words[0]));
    }
  }
}

}  // namespace hexatlas::io
