#pragma once
/// \file
/// Reading and writing of meshes. The functions that parse and print are pure, from bytes to
/// a mesh and back; the functions that take a path add nothing but the file.
///
/// Definition. Points keep the order of the file and are never merged or dropped, so indices of
/// the mesh are those of the file, less 1 where the file counts from 1; in Gmsh files, whose
/// tags may be sparse, they are positions in the list of nodes. Coordinates are rounded
/// correctly, denormal numbers and the sign of zero included, and written in the shortest form
/// that reads back to the same bits, whatever the locale. The order of the corners of a
/// hexahedron is converted (cell_types.hpp); orientation is not changed.
///
/// A surface file consists of quads, a file of facets of triangles and quads; points and edges
/// among them are ignored. A hexahedral file consists of hexahedra; cells of lower dimension are
/// ignored. Attributes are ignored.
///
/// Errors: InvalidInput with the line for each defect: other cells, files that are cut or
/// contradict themselves, indices outside the list of points, a vertex twice in a cell, numbers
/// that are not finite or underflow or overflow in double precision, unknown sections and versions,
/// no cell at all. In binary parts the line is that of the array, or unknown.
///
/// Cost: linear in the file (Gmsh with sparse tags: n log n); memory within a small factor of the
/// file, since counts are compared with the bytes left before anything is allocated, and
/// compressed arrays with the largest ratio that zlib can reach.
///
/// Not promised: that the surface is closed, oriented or manifold; that cells have positive
/// volume. A cut is noticed except in .obj, which has no counts, and except within the digits of
/// the last number of a file that has no end mark (.off, .vtk): a missing last end of line is
/// legal.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/io/format.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

/// The quads in these bytes; `file` is the name used in messages. Each quad has its line, 0 in
/// binary files.
[[nodiscard]] mesh::SurfaceMesh parse_surface(std::string_view bytes, FileFormat format,
                                              const std::string& file);

/// The triangles and quads in these bytes, in their order.
[[nodiscard]] mesh::FacetMesh parse_facets(std::string_view bytes, FileFormat format,
                                           const std::string& file);

/// The hexahedra in these bytes. InvalidInput if the format cannot hold any.
[[nodiscard]] mesh::HexMesh parse_hexahedra(std::string_view bytes, FileFormat format,
                                            const std::string& file);

/// The file at `path` ("-": standard input). The format is that of the extension unless given;
/// for standard input, that of the first bytes.
[[nodiscard]] mesh::SurfaceMesh read_surface(const std::string& path,
                                             std::optional<FileFormat> format = {});
[[nodiscard]] mesh::FacetMesh read_facets(const std::string& path,
                                          std::optional<FileFormat> format = {});
[[nodiscard]] mesh::HexMesh read_hexahedra(const std::string& path,
                                           std::optional<FileFormat> format = {});

enum class GmshVersion : std::uint8_t { v2_2, v4_1 };

struct WriteOptions {
  GmshVersion gmsh = GmshVersion::v4_1;
  /// Quads written besides the hexahedra, in .mesh and .msh. The VTK formats have a single list
  /// of cells, which viewers of hexahedral meshes expect to hold nothing else: not written there.
  std::vector<std::array<mesh::Index, 4>> boundary;
};

/// The file as text. The same mesh gives the same bytes (.vtu: with the same zlib).
/// Requires: a format that holds hexahedra, finite coordinates, indices below points.size().
[[nodiscard]] std::string to_text(const mesh::HexMesh& mesh, FileFormat format,
                                  const WriteOptions& options = {});

/// Requires: finite coordinates, indices below points.size(). quad_line is not read.
[[nodiscard]] std::string to_text(const mesh::SurfaceMesh& mesh, FileFormat format,
                                  GmshVersion gmsh = GmshVersion::v4_1);

/// Tells before long work what would make it be in vain: that write_hexahedra() would throw
/// InvalidInput as the file system stands. Writes nothing.
void expect_hexahedra_writable(const std::string& path, std::optional<FileFormat> format = {});

/// Replaces the file at `path`, whole or not at all; "-" is standard output and needs a format.
/// Throws InvalidInput (unknown extension, a format without hexahedra, no such folder),
/// ResourceFailure (disk full).
void write_hexahedra(const std::string& path, const mesh::HexMesh& mesh,
                     std::optional<FileFormat> format = {}, const WriteOptions& options = {});

}  // namespace hexatlas::io
