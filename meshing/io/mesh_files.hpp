#pragma once
/// \file
/// Reading and writing of meshes and of sets of points. The functions that parse and print are
/// pure, from bytes to a mesh and back; the functions that take a path add nothing but the file.
///
/// Definition. Points keep the order of the file and are never merged or dropped, so indices of
/// the mesh are those of the file, less 1 where the file counts from 1; in Gmsh files, whose
/// tags may be sparse, they are positions in the list of nodes. Coordinates are rounded
/// correctly, denormal numbers and the sign of zero included, and written in the shortest form
/// that reads back to the same bits, whatever the locale. The order of the corners of hexahedra,
/// and of prisms in the VTK formats, is converted (cell_types.hpp); orientation is not changed.
///
/// A surface file consists of quads, a file of facets of triangles and quads; points and edges
/// among them are ignored. A hexahedral file consists of hexahedra, a tetrahedral one of
/// tetrahedra, a hybrid one of tetrahedra, hexahedra, prisms and pyramids, of which some may be
/// missing; cells of lower dimension are ignored. A model is a tetrahedral file with attributes: of
/// its triangles, which are kept, and of its tetrahedra the references in .mesh and the tags of the
/// geometrical entity in .msh (the second tag of an element in version 2.2; 0 if there is none);
/// other formats have no such attributes that are read. Of a file of points any cells are ignored,
/// and there need be none. Other attributes are ignored.
///
/// Errors: InvalidInput with the line for each defect: other cells, files that are cut or
/// contradict themselves, indices outside the list of points, a vertex twice in a cell, numbers
/// that are not finite or underflow or overflow in double precision, unknown sections and versions,
/// no cell at all; where points are read, no list of them, though one of no points will do. In
/// binary parts the line is that of the array, or unknown; lists of points say which point is not
/// finite. A format that has no such content is refused before the file is opened.
///
/// Cost: linear in the file (Gmsh with sparse tags: n log n); memory within a small factor of the
/// file, since counts are compared with the bytes left before anything is allocated, and
/// compressed arrays with the largest ratio that zlib can reach. Of points in .bin: the file and
/// the points. Writing to a path takes no memory for the file, only for what is in other order
/// there (hexahedra, prisms) and for compressed arrays (.vtu with hexahedra alone).
///
/// Not promised: that the surface is closed, oriented or manifold; that cells have positive
/// volume; that points are distinct. A cut is noticed except in .obj and .xyz, which have no
/// counts, and in .bin at the end of a point; and except within the digits of the last number of a
/// file that has no end mark (.off, .vtk): a missing last end of line is legal. Where points are
/// read, what follows them in .ply is not looked at.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/io/format.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

/// The points in these bytes, at most mesh::kMostPoints; `file` is the name used in messages.
/// Formats: all; .xyz and .bin are described in docs/formats/points.md.
[[nodiscard]] std::vector<mesh::Point> parse_points(std::string_view bytes, FileFormat format,
                                                    const std::string& file);

/// The same with a weight for each point, the fourth number (.xyz .bin).
[[nodiscard]] mesh::WeightedPoints parse_weighted_points(std::string_view bytes, FileFormat format,
                                                         const std::string& file);

/// The quads in these bytes; `file` is the name used in messages. Each quad has its line, 0 in
/// binary files.
[[nodiscard]] mesh::SurfaceMesh parse_surface(std::string_view bytes, FileFormat format,
                                              const std::string& file);

/// The triangles and quads in these bytes, in their order, each with its colour (.mesh .msh).
[[nodiscard]] mesh::FacetMesh parse_facets(std::string_view bytes, FileFormat format,
                                           const std::string& file);

/// The tetrahedra in these bytes (.vtk .vtu .mesh .msh .hxtet).
[[nodiscard]] mesh::TetMesh parse_tetrahedra(std::string_view bytes, FileFormat format,
                                             const std::string& file);

/// The same, with the regions of the tetrahedra (none in .vtk .vtu .hxtet) and with the triangles
/// and their colours (0 in .vtk .vtu; no triangles in .hxtet). References are from 0 to 2^32 - 1.
[[nodiscard]] mesh::TetModel parse_tet_model(std::string_view bytes, FileFormat format,
                                             const std::string& file);

/// The cells of four shapes in these bytes (.vtk .vtu .mesh .msh), those of each in their order; a
/// voxel is a hexahedron.
[[nodiscard]] mesh::HybridMesh parse_hybrid(std::string_view bytes, FileFormat format,
                                            const std::string& file);

/// The hexahedra in these bytes (.vtk .vtu .mesh .msh).
[[nodiscard]] mesh::HexMesh parse_hexahedra(std::string_view bytes, FileFormat format,
                                            const std::string& file);

/// The same, with the quads and with the regions of the hexahedra as of the tetrahedra of a model,
/// modulo 2^32.
[[nodiscard]] mesh::HexModel parse_hex_model(std::string_view bytes, FileFormat format,
                                             const std::string& file);

/// The file at `path` ("-": standard input). The format is that of the extension unless given;
/// for standard input, that of the first bytes, which .bin does not announce.
[[nodiscard]] std::vector<mesh::Point> read_points(const std::string& path,
                                                   std::optional<FileFormat> format = {});
[[nodiscard]] mesh::WeightedPoints read_weighted_points(const std::string& path,
                                                        std::optional<FileFormat> format = {});
[[nodiscard]] mesh::SurfaceMesh read_surface(const std::string& path,
                                             std::optional<FileFormat> format = {});
[[nodiscard]] mesh::FacetMesh read_facets(const std::string& path,
                                          std::optional<FileFormat> format = {});
[[nodiscard]] mesh::TetMesh read_tetrahedra(const std::string& path,
                                            std::optional<FileFormat> format = {});
[[nodiscard]] mesh::TetModel read_tet_model(const std::string& path,
                                            std::optional<FileFormat> format = {});
[[nodiscard]] mesh::HexMesh read_hexahedra(const std::string& path,
                                           std::optional<FileFormat> format = {});
[[nodiscard]] mesh::HexModel read_hex_model(const std::string& path,
                                            std::optional<FileFormat> format = {});
[[nodiscard]] mesh::HybridMesh read_hybrid(const std::string& path,
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

/// Requires: a format that holds surfaces, finite coordinates, indices below points.size().
/// quad_line is not read.
[[nodiscard]] std::string to_text(const mesh::SurfaceMesh& mesh, FileFormat format,
                                  GmshVersion gmsh = GmshVersion::v4_1);

/// Triangles first, then quads; colours as the regions of hybrid meshes are written unless all are
/// 0, but not in .obj and .off. Requires as above, and colours from 0 to 2^32 - 1; line is not read.
[[nodiscard]] std::string to_text(const mesh::FacetMesh& mesh, FileFormat format);

/// The file as bytes: in .vtu, raw and uncompressed; in .msh, version 4.1; in .hxtet, as
/// docs/formats/hxtet.md says. The same mesh gives the same bytes. No tetrahedra at all can be
/// written, though not be read again.
/// Requires: a format that holds tetrahedra, finite coordinates, indices below points.size().
[[nodiscard]] std::string to_text(const mesh::TetView& mesh, FileFormat format);

/// The file as bytes: its tetrahedra, hexahedra, prisms and pyramids in this order; .vtu and .msh
/// as for tetrahedra. The same mesh gives the same bytes. No cells at all can be written, though
/// not be read again. Requires: a format that holds hybrid meshes, finite coordinates, indices
/// below points.size().
[[nodiscard]] std::string to_text(const mesh::HybridMesh& mesh, FileFormat format);

/// Tells before long work what would make it be in vain: that write_hexahedra() would throw
/// InvalidInput as the file system stands. Writes nothing.
void expect_hexahedra_writable(const std::string& path, std::optional<FileFormat> format = {});

/// Replaces the file at `path`, whole or not at all; "-" is standard output and needs a format.
/// Throws InvalidInput (unknown extension, a format without hexahedra, no such folder),
/// ResourceFailure (disk full).
void write_hexahedra(const std::string& path, const mesh::HexMesh& mesh,
                     std::optional<FileFormat> format = {}, const WriteOptions& options = {});

/// The same for tetrahedra, as to_text() has them.
void expect_tetrahedra_writable(const std::string& path, std::optional<FileFormat> format = {});
void write_tetrahedra(const std::string& path, const mesh::TetView& mesh,
                      std::optional<FileFormat> format = {});

/// The same for triangles and quads.
void expect_facets_writable(const std::string& path, std::optional<FileFormat> format = {});
void write_facets(const std::string& path, const mesh::FacetMesh& mesh,
                  std::optional<FileFormat> format = {});

/// The same for hybrid meshes.
void expect_hybrid_writable(const std::string& path, std::optional<FileFormat> format = {});
void write_hybrid(const std::string& path, const mesh::HybridMesh& mesh,
                  std::optional<FileFormat> format = {});

}  // namespace hexatlas::io
