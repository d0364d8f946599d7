#include <array>
#include <optional>
#include <utility>

#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

/// Sections of marks on vertices and cells: numbers per row.
constexpr std::array<std::pair<std::string_view, unsigned>, 14> kPassedOver = {
    {{"Corners", 1},
     {"Ridges", 1},
     {"RequiredVertices", 1},
     {"RequiredEdges", 1},
     {"RequiredTriangles", 1},
     {"RequiredQuadrilaterals", 1},
     {"Normals", 3},
     {"NormalAtVertices", 2},
     {"NormalAtTriangleVertices", 3},
     {"NormalAtQuadrilateralVertices", 3},
     {"Tangents", 3},
     {"TangentAtVertices", 2},
     {"TangentAtEdgeVertices", 3},
     {"TangentAtQuadrilateralVertices", 3}}};

constexpr std::array<std::pair<std::string_view, Shape>, 8> kCells = {
    {{"Edges", Shape::kLine},
     {"Triangles", Shape::kTriangle},
     {"Quadrilaterals", Shape::kQuad},
     {"Quads", Shape::kQuad},
     {"Tetrahedra", Shape::kTetrahedron},
     {"Hexahedra", Shape::kHexahedron},
     {"Prisms", Shape::kPrism},
     {"Pyramids", Shape::kPyramid}}};

std::optional<Shape> shape_of(std::string_view section) {
  for (const auto& [name, shape] : kCells) {
    if (name == section) return shape;
  }
  return std::nullopt;
}

/// Rows of vertices, counted from 1, and a reference.
void read_cells(Scanner& in, Shape shape, Draft& draft) {
  std::array<std::uint32_t, 8> corners{};
  const auto used = std::span(corners).first(corner_count(shape));
  const std::uint64_t count = in.count(2 * used.size());
  if (count != 0 && draft.refuses(shape)) in.fail("a cell is " + std::string(draft.refusal()));
  for (std::uint64_t cell = 0; cell < count; ++cell) {
    for (std::uint32_t& vertex : used) vertex = in.index(1, draft.points.size());
    static_cast<void>(in.integer());
    draft.add(shape, used);
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
    for (std::uint64_t i = 0; i < count * numbers; ++i) static_cast<void>(in.real());
    return;
  }
  in.fail("unknown or unsupported keyword " + in_quotes(keyword));
}

}  // namespace

Draft parse_medit(const std::string& name, std::string_view bytes, Wanted wanted) {
  Scanner in(name, bytes, '#');
  in.expect("MeshVersionFormatted");
  if (const std::uint64_t version = in.natural(); version < 1 || version > 4) {
    in.fail("unknown version");
  }
  in.expect("Dimension");
  in.expect("3");
  Draft draft(wanted);
  std::array<bool, kShapes> seen{};
  for (std::string_view keyword = in.word(); keyword != "End"; keyword = in.word()) {
    if (keyword == "Vertices") {
      read_vertices(in, draft.points);
    } else if (const std::optional<Shape> shape = shape_of(keyword)) {
      if (seen[static_cast<std::size_t>(*shape)]) in.fail("a section of cells occurs twice");
      seen[static_cast<std::size_t>(*shape)] = true;
      read_cells(in, *shape, draft);
    } else {
      pass_over(in, keyword);
    }
  }
  if (!in.at_end()) in.fail("something follows End");
  return draft;
}

}  // namespace hexatlas::check
