#include <array>
#include <utility>

#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

/// Sections of cells of dimension 0 and 1 and of marks on them: numbers per row.
constexpr std::array<std::pair<std::string_view, unsigned>, 6> kPassedOver = {
    {{"Edges", 3},
     {"Corners", 1},
     {"Ridges", 1},
     {"RequiredVertices", 1},
     {"RequiredEdges", 1},
     {"RequiredQuadrilaterals", 1}}};

/// Rows of `size` vertices, counted from 1, and a reference.
template <std::size_t size>
void read_cells(Scanner& in, std::uint64_t points,
                std::vector<std::array<std::uint32_t, size>>& cells) {
  if (!cells.empty()) in.fail("a section of cells occurs twice");
  const std::uint64_t count = in.count(2 * size);
  cells.resize(count);
  for (auto& cell : cells) {
    for (std::uint32_t& vertex : cell) vertex = in.index(1, points);
    static_cast<void>(in.integer());
  }
}

void read_vertices(Scanner& in, std::vector<Point>& points) {
  if (!points.empty()) in.fail("Vertices occurs twice");
  points.resize(in.count(8));
  for (Point& point : points) {
    point = in.point();
    static_cast<void>(in.integer());
  }
}

void pass_over(Scanner& in, std::string_view keyword) {
  for (const auto& [name, numbers] : kPassedOver) {
    if (name != keyword) continue;
    const std::uint64_t count = in.count(2 * numbers);
    for (std::uint64_t i = 0; i < count * numbers; ++i) static_cast<void>(in.integer());
    return;
  }
  in.fail("unknown or unsupported keyword " + in_quotes(keyword));
}

}  // namespace

Mesh parse_medit(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  in.expect("MeshVersionFormatted");
  if (const std::uint64_t version = in.natural(); version < 1 || version > 4) {
    in.fail("unknown version");
  }
  in.expect("Dimension");
  in.expect("3");
  Mesh mesh;
  for (std::string_view keyword = in.word(); keyword != "End"; keyword = in.word()) {
    if (keyword == "Vertices") {
      read_vertices(in, mesh.points);
    } else if (keyword == "Hexahedra") {
      read_cells(in, mesh.points.size(), mesh.hexahedra);
    } else if (keyword == "Quadrilaterals" || keyword == "Quads") {
      read_cells(in, mesh.points.size(), mesh.quads);
    } else {
      pass_over(in, keyword);
    }
  }
  if (!in.at_end()) in.fail("something follows End");
  return mesh;
}

}  // namespace hexatlas::check
