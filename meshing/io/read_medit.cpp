// MEDIT .mesh, ASCII. Source: P. Frey, MEDIT: an interactive mesh visualization software, INRIA
// RT-0253 (2001), and the keywords of the library libMeshb. Vertices count from 1.
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

struct CellSection {
  std::string_view keyword;
  CellType type;
};

constexpr std::array kCellSections{
    CellSection{"Edges", {"edge", CellShape::low, 2}},
    CellSection{"Triangles", {"triangle", CellShape::surface, 3}},
    CellSection{kFileQuad.medit, kQuad},
    CellSection{"Quads", kQuad},
    CellSection{kFileTetrahedron.medit, kTetrahedron},
    CellSection{kFileHexahedron.medit, kHexahedron},
    CellSection{kFilePrism.medit, kPrism},
    CellSection{kFilePyramid.medit, kPyramid},
};

/// Sections skipped by their count: so many numbers per row.
struct SkippedSection {
  std::string_view keyword;
  std::size_t numbers;
};

constexpr std::array kSkippedSections{
    SkippedSection{"Corners", 1},
    SkippedSection{"Ridges", 1},
    SkippedSection{"RequiredVertices", 1},
    SkippedSection{"RequiredEdges", 1},
    SkippedSection{"RequiredTriangles", 1},
    SkippedSection{"RequiredQuadrilaterals", 1},
    SkippedSection{"Normals", 3},
    SkippedSection{"NormalAtVertices", 2},
    SkippedSection{"NormalAtTriangleVertices", 3},
    SkippedSection{"NormalAtQuadrilateralVertices", 3},
    SkippedSection{"Tangents", 3},
    SkippedSection{"TangentAtVertices", 2},
    SkippedSection{"TangentAtEdgeVertices", 3},
    SkippedSection{"VertexOnGeometricVertex", 2},
    SkippedSection{"VertexOnGeometricEdge", 3},
    SkippedSection{"VertexOnGeometricTriangle", 4},
    SkippedSection{"VertexOnGeometricQuadrilateral", 5},
    SkippedSection{"EdgeOnGeometricEdge", 2},
    SkippedSection{"SubDomainFromMesh", 4},
    SkippedSection{"SubDomainFromGeom", 4},
};

template <class Section, std::size_t N>
std::optional<Section> find_section(const std::array<Section, N>& sections,
                                    std::string_view keyword) {
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const Section& each) { return each.keyword == keyword; });
  if (found == sections.end()) return std::nullopt;
  return *found;
}

void read_header(Scanner& scanner) {
  const std::string_view keyword = scanner.word("MeshVersionFormatted");
  if (keyword == "MeshVersionUnformatted") scanner.fail("binary MEDIT file; save as ASCII");
  if (keyword != "MeshVersionFormatted")
    scanner.fail("MeshVersionFormatted is expected, not " + in_quotes(keyword));
  const std::int64_t version = scanner.integer("the version");
  if (version < 1 || version > 4) scanner.fail("unsupported version " + std::to_string(version));
}

void read_dimension(Scanner& scanner) {
  const std::int64_t dimension = scanner.integer("the dimension");
  if (dimension != 3) scanner.fail("Dimension " + std::to_string(dimension) + "; it must be 3");
}

void read_vertices(Scanner& scanner, MeshBuilder& builder) {
  constexpr std::size_t kVertexBytes = 8;  // "0 0 0 0" and a separator
  const std::size_t count = scanner.count("the number of vertices", kVertexBytes);
  builder.reserve_points(count);
  for (std::size_t i = 0; i < count; ++i) {
    mesh::Point point;
    for (double* coordinate : {&point.x, &point.y, &point.z})
      *coordinate = scanner.real("a coordinate");
    builder.add_point(point, scanner.line());
    static_cast<void>(scanner.integer("the reference of the vertex"));
  }
}

void read_cells(Scanner& scanner, const CellType& type, MeshBuilder& builder) {
  const auto vertices = static_cast<std::size_t>(type.vertices);
  const std::size_t count = scanner.count("the number of cells", 2 * (vertices + 1));
  builder.reserve_cells(type, count);
  std::array<mesh::Index, 8> corners{};
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t line = 0;
    for (std::size_t k = 0; k < vertices; ++k) {
      corners[k] = scanner.index(1);
      if (k == 0) line = scanner.line();
    }
    const std::int64_t reference = scanner.integer("the reference of the cell");
    builder.add_cell(type, std::span(corners).first(vertices), line, reference);
  }
}

void skip_section(Scanner& scanner, std::size_t numbers) {
  const std::size_t count = scanner.count("the number of rows", 2 * numbers);
  for (std::size_t i = 0; i < count * numbers; ++i) static_cast<void>(scanner.real("a number"));
}

}  // namespace

void read_medit(std::string_view bytes, MeshBuilder& builder) {
  Scanner scanner(bytes, builder.file(), '#');
  scanner.refuse_nul();
  read_header(scanner);
  std::set<std::string_view> seen;
  while (true) {
    const std::string_view keyword = scanner.word("a section or End");
    if (keyword == "End") break;
    if (!seen.insert(keyword).second) scanner.fail("second section " + in_quotes(keyword));
    if (keyword != "Dimension" && !seen.contains("Dimension"))
      scanner.fail("Dimension is expected before " + in_quotes(keyword));
    if (keyword == "Dimension") {
      read_dimension(scanner);
    } else if (keyword == "Vertices") {
      read_vertices(scanner, builder);
    } else if (const auto cells = find_section(kCellSections, keyword)) {
      read_cells(scanner, cells->type, builder);
    } else if (const auto skipped = find_section(kSkippedSections, keyword)) {
      skip_section(scanner, skipped->numbers);
    } else if (keyword == "AngleOfCornerBound") {
      static_cast<void>(scanner.real("an angle"));
    } else {
      scanner.fail("unknown section " + in_quotes(keyword));
    }
  }
  if (!scanner.at_end()) scanner.fail("text after the keyword End");
  if (builder.wanted() == Wanted::points && !seen.contains("Vertices"))
    scanner.fail("there is no section Vertices");
}

}  // namespace hexatlas::io
