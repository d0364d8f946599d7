#include "meshing/io/mesh_files.hpp"

#include <algorithm>
#include <cmath>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "meshing/io/cell_types.hpp"
#include "meshing/io/mesh_builder.hpp"
#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"
#include "meshing/io/writers.hpp"

namespace hexatlas::io {
namespace {

using mesh::Index;

bool counts_from_one(FileFormat format) {
  return format == FileFormat::obj || format == FileFormat::medit || format == FileFormat::gmsh;
}

MeshBuilder parse(std::string_view bytes, FileFormat format, const std::string& file,
                  Wanted wanted) {
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.empty()) throw core::InvalidInput(file, "is empty");
  MeshBuilder builder(wanted, file, counts_from_one(format) ? 1 : 0);
  switch (format) {
    case FileFormat::obj:
      read_obj(text, builder);
      break;
    case FileFormat::off:
      read_off(text, builder);
      break;
    case FileFormat::vtk:
      read_vtk(text, builder);
      break;
    case FileFormat::vtu:
      read_vtu(text, builder);
      break;
    case FileFormat::medit:
      read_medit(text, builder);
      break;
    case FileFormat::gmsh:
      read_gmsh(text, builder);
      break;
  }
  return builder;
}

struct NamedBytes {
  std::string bytes;
  std::string file;
  FileFormat format;
};

NamedBytes load(const std::string& path, std::optional<FileFormat> format) {
  if (path != "-") {
    // The name is judged first: it costs nothing.
    const FileFormat known = format ? *format : format_of_path(path);
    return {core::read_file(path), path, known};
  }
  std::string bytes = core::read_file(path);
  const std::string file = "standard input";
  const FileFormat known = format ? *format : detect_format(bytes, file);
  return {std::move(bytes), file, known};
}

template <class Cells>
void check_cells(const Cells& cells, std::size_t points) {
  for (const auto& cell : cells)
    for (const Index index : cell)
      core::expects(index < points, "to_text: indices are below points.size()");
}

std::string write(const CellsToWrite& cells, FileFormat format, GmshVersion gmsh) {
  for (const mesh::Point& point : cells.points)
    core::expects(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z),
                  "to_text: coordinates are finite");
  check_cells(cells.quads, cells.points.size());
  check_cells(cells.hexahedra, cells.points.size());
  switch (format) {
    case FileFormat::obj:
      return write_obj(cells);
    case FileFormat::off:
      return write_off(cells);
    case FileFormat::vtk:
      return write_vtk(cells);
    case FileFormat::vtu:
      return write_vtu(cells);
    case FileFormat::medit:
      return write_medit(cells);
    case FileFormat::gmsh:
      return write_gmsh(cells, gmsh);
  }
  throw core::PreconditionViolated("to_text: the format is one of the enumerators");
}

std::string refusal(FileFormat format) {
  return "a file of format " + std::string(extension_of(format)) + " cannot hold hexahedra";
}

FileFormat format_to_write(const std::string& path, std::optional<FileFormat> format) {
  if (path == "-" && !format)
    throw core::InvalidInput("standard output", "a format is needed, since there is no extension");
  const FileFormat known = format ? *format : format_of_path(path);
  if (!holds_hexahedra(known)) throw core::InvalidInput(path, refusal(known));
  return known;
}

}  // namespace

mesh::SurfaceMesh parse_surface(std::string_view bytes, FileFormat format,
                                const std::string& file) {
  return parse(bytes, format, file, Wanted::surface).take_surface();
}

mesh::FacetMesh parse_facets(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::facets).take_facets();
}

mesh::HexMesh parse_hexahedra(std::string_view bytes, FileFormat format, const std::string& file) {
  if (!holds_hexahedra(format)) throw core::InvalidInput(file, refusal(format));
  return parse(bytes, format, file, Wanted::hexahedra).take_hexahedra();
}

mesh::SurfaceMesh read_surface(const std::string& path, std::optional<FileFormat> format) {
  const NamedBytes input = load(path, format);
  return parse_surface(input.bytes, input.format, input.file);
}

mesh::FacetMesh read_facets(const std::string& path, std::optional<FileFormat> format) {
  const NamedBytes input = load(path, format);
  return parse_facets(input.bytes, input.format, input.file);
}

mesh::HexMesh read_hexahedra(const std::string& path, std::optional<FileFormat> format) {
  const NamedBytes input = load(path, format);
  return parse_hexahedra(input.bytes, input.format, input.file);
}

std::string to_text(const mesh::HexMesh& mesh, FileFormat format, const WriteOptions& options) {
  core::expects(holds_hexahedra(format), "to_text: the format holds hexahedra");
  std::vector<std::array<Index, 8>> hexahedra;
  hexahedra.reserve(mesh.hexahedra.size());
  for (const auto& hexahedron : mesh.hexahedra) {
    auto& ordered = hexahedra.emplace_back();
    std::transform(kFileCorner.begin(), kFileCorner.end(), ordered.begin(),
                   [&](cells::CubeVertex corner) { return hexahedron[corner]; });
  }
  const bool has_single_list = format == FileFormat::vtk || format == FileFormat::vtu;
  CellsToWrite cells{mesh.points, {}, hexahedra};
  if (!has_single_list) cells.quads = options.boundary;
  return write(cells, format, options.gmsh);
}

std::string to_text(const mesh::SurfaceMesh& mesh, FileFormat format, GmshVersion gmsh) {
  return write({mesh.points, mesh.quads, {}}, format, gmsh);
}

void expect_hexahedra_writable(const std::string& path, std::optional<FileFormat> format) {
  (void)format_to_write(path, format);
  if (path != "-") core::expect_writable(path);
}

void write_hexahedra(const std::string& path, const mesh::HexMesh& mesh,
                     std::optional<FileFormat> format, const WriteOptions& options) {
  core::write_file(path, to_text(mesh, format_to_write(path, format), options));
}

}  // namespace hexatlas::io
