#include "meshing/io/mesh_files.hpp"

#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "meshing/io/mesh_builder.hpp"
#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

bool counts_from_one(FileFormat format) {
  return format == FileFormat::obj || format == FileFormat::medit || format == FileFormat::gmsh;
}

/// A byte order mark may precede text; elsewhere the same bytes are data.
bool is_text(FileFormat format) { return format != FileFormat::raw && format != FileFormat::hxtet; }

Content content_of(Wanted wanted) {
  switch (wanted) {
    case Wanted::points:
      return Content::points;
    case Wanted::weighted_points:
      return Content::weighted_points;
    case Wanted::surface:
    case Wanted::facets:
      return Content::surface;
    case Wanted::tetrahedra:
    case Wanted::tet_model:
      return Content::tetrahedra;
    case Wanted::hexahedra:
    case Wanted::hex_model:
      return Content::hexahedra;
    case Wanted::hybrid:
      return Content::hybrid;
  }
  throw core::PreconditionViolated("content_of: the argument is one of the enumerators");
}

void read(std::string_view text, FileFormat format, MeshBuilder& builder) {
  switch (format) {
    case FileFormat::obj:
      return read_obj(text, builder);
    case FileFormat::off:
      return read_off(text, builder);
    case FileFormat::vtk:
      return read_vtk(text, builder);
    case FileFormat::vtu:
      return read_vtu(text, builder);
    case FileFormat::medit:
      return read_medit(text, builder);
    case FileFormat::gmsh:
      return read_gmsh(text, builder);
    case FileFormat::xyz:
      return read_xyz(text, builder);
    case FileFormat::raw:
      return read_raw(text, builder);
    case FileFormat::ply:
      return read_ply(text, builder);
    case FileFormat::hxtet:
      return read_hxtet(text, builder);
  }
  throw core::PreconditionViolated("read: the format is one of the enumerators");
}

MeshBuilder parse(std::string_view bytes, FileFormat format, const std::string& file,
                  Wanted wanted) {
  expect_holds(format, content_of(wanted), file);
  const std::string_view text = is_text(format) ? without_byte_order_mark(bytes) : bytes;
  // A list without header and without points is empty; the other formats have a header.
  const bool may_be_empty = format == FileFormat::xyz || format == FileFormat::raw;
  if (text.empty() && !may_be_empty) throw core::InvalidInput(file, "is empty");
  MeshBuilder builder(wanted, file, counts_from_one(format) ? 1 : 0);
  read(text, format, builder);
  return builder;
}

/// What the file at `path` has.
MeshBuilder load(const std::string& path, std::optional<FileFormat> format, Wanted wanted) {
  const Content content = content_of(wanted);
  if (path != "-") {
    // The name is judged first: it costs nothing.
    const FileFormat known = format ? *format : format_of_path(path, content);
    expect_holds(known, content, path);
    return parse(core::read_file(path), known, path, wanted);
  }
  const std::string bytes = core::read_file(path);
  const std::string file = "standard input";
  return parse(bytes, format ? *format : detect_format(bytes, file, content), file, wanted);
}

}  // namespace

std::vector<mesh::Point> parse_points(std::string_view bytes, FileFormat format,
                                      const std::string& file) {
  return parse(bytes, format, file, Wanted::points).take_points();
}

mesh::WeightedPoints parse_weighted_points(std::string_view bytes, FileFormat format,
                                           const std::string& file) {
  return parse(bytes, format, file, Wanted::weighted_points).take_weighted_points();
}

mesh::SurfaceMesh parse_surface(std::string_view bytes, FileFormat format,
                                const std::string& file) {
  return parse(bytes, format, file, Wanted::surface).take_surface();
}

mesh::FacetMesh parse_facets(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::facets).take_facets();
}

mesh::TetMesh parse_tetrahedra(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::tetrahedra).take_tetrahedra();
}

mesh::HexMesh parse_hexahedra(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::hexahedra).take_hexahedra();
}

mesh::HexModel parse_hex_model(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::hex_model).take_hex_model();
}

mesh::TetModel parse_tet_model(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::tet_model).take_tet_model();
}

mesh::HybridMesh parse_hybrid(std::string_view bytes, FileFormat format, const std::string& file) {
  return parse(bytes, format, file, Wanted::hybrid).take_hybrid();
}

std::vector<mesh::Point> read_points(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::points).take_points();
}

mesh::WeightedPoints read_weighted_points(const std::string& path,
                                          std::optional<FileFormat> format) {
  return load(path, format, Wanted::weighted_points).take_weighted_points();
}

mesh::SurfaceMesh read_surface(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::surface).take_surface();
}

mesh::FacetMesh read_facets(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::facets).take_facets();
}

mesh::TetMesh read_tetrahedra(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::tetrahedra).take_tetrahedra();
}

mesh::HexMesh read_hexahedra(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::hexahedra).take_hexahedra();
}

mesh::HexModel read_hex_model(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::hex_model).take_hex_model();
}

mesh::TetModel read_tet_model(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::tet_model).take_tet_model();
}

mesh::HybridMesh read_hybrid(const std::string& path, std::optional<FileFormat> format) {
  return load(path, format, Wanted::hybrid).take_hybrid();
}

}  // namespace hexatlas::io
