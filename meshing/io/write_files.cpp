// The half of mesh_files.hpp that writes.
#include <algorithm>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "meshing/io/cell_types.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

using mesh::Index;
using Hexahedron = std::array<Index, 8>;

/// How a format is written where there is a choice.
struct Manner {
  GmshVersion gmsh = GmshVersion::v4_1;
  VtuArrays vtu = VtuArrays::zlib_base64;
};

void check(const CellsToWrite& cells) {
  for (const mesh::Point& point : cells.points)
    core::expects(mesh::is_finite(point), "writing a mesh: coordinates are finite");
  for (const CellList& list : cells.lists)
    for (const Index index : list.all_corners())
      core::expects(index < cells.points.size(), "writing a mesh: indices are below points.size()");
}

void put(const CellsToWrite& cells, FileFormat format, const Manner& manner, Output& out) {
  switch (format) {
    case FileFormat::obj:
      return write_obj(cells, out);
    case FileFormat::off:
      return write_off(cells, out);
    case FileFormat::vtk:
      return write_vtk(cells, out);
    case FileFormat::vtu:
      return write_vtu(cells, manner.vtu, out);
    case FileFormat::medit:
      return write_medit(cells, out);
    case FileFormat::gmsh:
      return write_gmsh(cells, manner.gmsh, out);
    case FileFormat::hxtet:
      return write_hxtet(cells, out);
    case FileFormat::xyz:
    case FileFormat::raw:
    case FileFormat::ply:
      break;
  }
  throw core::PreconditionViolated("writing a mesh: the format holds its cells");
}

/// Gives the file to the sink, block by block.
void write(const CellsToWrite& cells, FileFormat format, const Manner& manner,
           const core::Sink& sink) {
  Output out(sink);
  put(cells, format, manner, out);
  out.flush();
}

std::string to_text(const CellsToWrite& cells, FileFormat format, const Manner& manner) {
  check(cells);
  std::string text;
  write(cells, format, manner, [&](std::string_view block) { text += block; });
  return text;
}

void write_file(const std::string& path, const CellsToWrite& cells, FileFormat format,
                const Manner& manner) {
  check(cells);
  core::write_file_in_parts(path,
                            [&](const core::Sink& sink) { write(cells, format, manner, sink); });
}

bool is_of_vtk(FileFormat format) { return format == FileFormat::vtk || format == FileFormat::vtu; }

/// Position i has the corner order[i].
template <std::size_t N, class Order>
std::vector<std::array<Index, N>> ordered(const std::vector<std::array<Index, N>>& cells,
                                          const Order& order) {
  std::vector<std::array<Index, N>> all(cells.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    std::transform(order.begin(), order.end(), all[i].begin(),
                   [&](std::size_t corner) { return cells[i][corner]; });
  return all;
}

/// The corners of hexahedra in the order of files.
std::vector<Hexahedron> in_file_order(const std::vector<Hexahedron>& hexahedra) {
  return ordered(hexahedra, kFileCorner);
}

/// The cells that a format lists in another order of corners.
struct Ordered {
  std::vector<Hexahedron> hexahedra;
  std::vector<mesh::Prism> prisms;  ///< empty unless the format is one of VTK

  Ordered(const mesh::HybridMesh& mesh, FileFormat format)
      : hexahedra(in_file_order(mesh.hexahedra)),
        prisms(is_of_vtk(format) ? ordered(mesh.prisms, kWedgeCorner)
                                 : std::vector<mesh::Prism>{}) {}
};

/// `ordered`: in_file_order() of the hexahedra; it outlives the result.
CellsToWrite cells_of(const mesh::HexMesh& mesh, const std::vector<Hexahedron>& ordered,
                      FileFormat format, const WriteOptions& options) {
  CellsToWrite cells{mesh.points, {}};
  if (!is_of_vtk(format)) cells.add(kFileQuad, std::span(options.boundary));
  cells.add(kFileHexahedron, std::span(ordered));
  return cells;
}

/// The facets by their number of vertices.
struct Facets {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::array<Index, 4>> quads;
  std::vector<std::uint32_t> colours;  ///< of the triangles, then of the quads; none if all are 0

  explicit Facets(const mesh::FacetMesh& mesh) {
    std::vector<std::uint32_t> of_quads;
    for (const mesh::Facet& facet : mesh.facets) {
      const auto& v = facet.vertices;
      if (facet.size == 3)
        triangles.push_back({v[0], v[1], v[2]});
      else
        quads.push_back(v);
      (facet.size == 3 ? colours : of_quads).push_back(static_cast<std::uint32_t>(facet.colour));
      core::expects(std::cmp_equal(facet.colour, static_cast<std::uint32_t>(facet.colour)),
                    "writing a mesh: colours are from 0 to 2^32 - 1");
    }
    colours.insert(colours.end(), of_quads.begin(), of_quads.end());
    if (std::all_of(colours.begin(), colours.end(), [](std::uint32_t c) { return c == 0; }))
      colours.clear();
  }
};

/// Adds cells with the first of the regions, if there are some, and leaves the others.
template <std::size_t N>
void add(CellsToWrite& cells, const FileCell& type, const std::vector<std::array<Index, N>>& some,
         std::span<const std::uint32_t>& regions) {
  const auto first = regions.first(regions.empty() ? 0 : some.size());
  cells.add(type, std::span(some), first);
  regions = regions.subspan(first.size());
}

/// Both arguments outlive the result.
CellsToWrite cells_of(const mesh::FacetMesh& mesh, const Facets& facets) {
  CellsToWrite cells{mesh.points, {}};
  std::span<const std::uint32_t> colours(facets.colours);
  add(cells, kFileTriangle, facets.triangles, colours);
  add(cells, kFileQuad, facets.quads, colours);
  return cells;
}

CellsToWrite cells_of(const mesh::TetView& mesh) {
  CellsToWrite cells{mesh.points, {}};
  cells.add(kFileTetrahedron, mesh.tetrahedra);
  return cells;
}

/// Both arguments outlive the result.
CellsToWrite cells_of(const mesh::HybridMesh& mesh, const Ordered& in_order) {
  CellsToWrite cells{mesh.points, {}};
  core::expects(mesh.regions.empty() ||
                    mesh.regions.size() == mesh.tetrahedra.size() + mesh.hexahedra.size() +
                                               mesh.prisms.size() + mesh.pyramids.size(),
                "writing a mesh: a region for each cell");
  std::span<const std::uint32_t> regions(mesh.regions);
  add(cells, kFileTetrahedron, mesh.tetrahedra, regions);
  add(cells, kFileHexahedron, in_order.hexahedra, regions);
  add(cells, kFilePrism, in_order.prisms.empty() ? mesh.prisms : in_order.prisms, regions);
  add(cells, kFilePyramid, mesh.pyramids, regions);
  return cells;
}

/// Compression would take most of the time that millions of cells need.
constexpr Manner kLargeManner{GmshVersion::v4_1, VtuArrays::appended_raw};

FileFormat format_to_write(const std::string& path, std::optional<FileFormat> format,
                           Content content) {
  if (path == "-" && !format)
    throw core::InvalidInput("standard output", "a format is needed, since there is no extension");
  const FileFormat known = format ? *format : format_of_path(path, content);
  expect_holds(known, content, path);
  return known;
}

void expect_mesh_writable(const std::string& path, std::optional<FileFormat> format,
                          Content content) {
  static_cast<void>(format_to_write(path, format, content));
  core::expect_writable(path);
}

}  // namespace

std::string to_text(const mesh::HexMesh& mesh, FileFormat format, const WriteOptions& options) {
  core::expects(holds_hexahedra(format), "to_text: the format holds hexahedra");
  const std::vector<Hexahedron> ordered = in_file_order(mesh.hexahedra);
  return to_text(cells_of(mesh, ordered, format, options), format, {options.gmsh});
}

std::string to_text(const mesh::SurfaceMesh& mesh, FileFormat format, GmshVersion gmsh) {
  core::expects(holds(format, Content::surface), "to_text: the format holds surfaces");
  CellsToWrite cells{mesh.points, {}};
  cells.add(kFileQuad, std::span(mesh.quads));
  return to_text(cells, format, {gmsh});
}

std::string to_text(const mesh::FacetMesh& mesh, FileFormat format) {
  core::expects(holds(format, Content::surface), "to_text: the format holds surfaces");
  return to_text(cells_of(mesh, Facets(mesh)), format, {});
}

std::string to_text(const mesh::TetView& mesh, FileFormat format) {
  core::expects(holds(format, Content::tetrahedra), "to_text: the format holds tetrahedra");
  return to_text(cells_of(mesh), format, kLargeManner);
}

std::string to_text(const mesh::HybridMesh& mesh, FileFormat format) {
  core::expects(holds(format, Content::hybrid), "to_text: the format holds hybrid meshes");
  return to_text(cells_of(mesh, Ordered(mesh, format)), format, kLargeManner);
}

void expect_hexahedra_writable(const std::string& path, std::optional<FileFormat> format) {
  expect_mesh_writable(path, format, Content::hexahedra);
}

void expect_tetrahedra_writable(const std::string& path, std::optional<FileFormat> format) {
  expect_mesh_writable(path, format, Content::tetrahedra);
}

void expect_facets_writable(const std::string& path, std::optional<FileFormat> format) {
  expect_mesh_writable(path, format, Content::surface);
}

void expect_hybrid_writable(const std::string& path, std::optional<FileFormat> format) {
  expect_mesh_writable(path, format, Content::hybrid);
}

void write_hexahedra(const std::string& path, const mesh::HexMesh& mesh,
                     std::optional<FileFormat> format, const WriteOptions& options) {
  const FileFormat known = format_to_write(path, format, Content::hexahedra);
  const std::vector<Hexahedron> ordered = in_file_order(mesh.hexahedra);
  write_file(path, cells_of(mesh, ordered, known, options), known, {options.gmsh});
}

void write_tetrahedra(const std::string& path, const mesh::TetView& mesh,
                      std::optional<FileFormat> format) {
  const FileFormat known = format_to_write(path, format, Content::tetrahedra);
  write_file(path, cells_of(mesh), known, kLargeManner);
}

void write_facets(const std::string& path, const mesh::FacetMesh& mesh,
                  std::optional<FileFormat> format) {
  const FileFormat known = format_to_write(path, format, Content::surface);
  write_file(path, cells_of(mesh, Facets(mesh)), known, {});
}

void write_hybrid(const std::string& path, const mesh::HybridMesh& mesh,
                  std::optional<FileFormat> format) {
  const FileFormat known = format_to_write(path, format, Content::hybrid);
  write_file(path, cells_of(mesh, Ordered(mesh, known)), known, kLargeManner);
}

}  // namespace hexatlas::io
