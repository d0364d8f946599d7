#pragma once
/// \file
/// The judge's own readers of mesh files. They share no code with the readers of the mesher, so
/// that an error of those cannot hide itself.
///
/// Formats, by the ending of the name, in either case: `.vtk` (legacy, ASCII or binary,
/// versions 2.0, 3.0, 4.2, 5.1, UNSTRUCTURED_GRID; surfaces also POLYDATA), `.vtu` (ASCII; base64
/// inline; appended raw or base64; uncompressed or zlib; little-endian), `.mesh` (MEDIT, ASCII),
/// `.msh` (Gmsh 2.2 and 4.1, ASCII), for tetrahedra also `.hxtet` (docs/formats/hxtet.md), for
/// surfaces also `.obj` and `.off`, for points alone also these two with any records, `.ply`
/// (ASCII, little-endian binary), `.xyz` (text, three numbers a line, '#' comments) and `.bin`
/// (consecutive little-endian doubles x y z). Where the name has no ending (a pipe, standard input)
/// the first bytes decide: `# vtk DataFile`,
/// `<?xml` or `<VTKFile`, `MeshVersionFormatted`, `$MeshFormat`, `HXTET`, `OFF`, `ply`; a surface
/// that begins otherwise is OBJ, points that do are `.xyz`.
///
/// Points keep the order of the file. Of the cells of a Mesh, hexahedra and quads are kept;
/// isolated points and line segments are passed over, since they carry no part of a mesh; any other
/// cell is refused. Of a mesh of tetrahedra these are kept, while isolated points, line segments,
/// triangles and quads are passed over and other cells refused; of a hybrid mesh hexahedra, prisms
/// and pyramids are kept as well. Attributes (fields, references, physical groups) are passed over.
/// Decimal coordinates are read as the nearest double, whatever width the file declares.
///
/// Errors: Malformed, for everything that is not a well-formed file of its format, among them a
/// count larger than the rest of the file can hold, an index outside the points, and a coordinate
/// that is not finite. Cost: linear; memory is never asked for on the word of a count alone.
/// Not promised: that a mesh is valid. That is check_mesh.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hexatlas::check {

using Point = std::array<double, 3>;
using Quad = std::array<std::uint32_t, 4>;

/// Eight vertices in VTK order: the bottom quad cyclically, then the top quad, vertex i + 4 above
/// vertex i. With right-handed axes the corners are 000 100 110 010 001 101 111 011.
using Hexahedron = std::array<std::uint32_t, 8>;

/// Four vertices a, b, c, d in VTK order: with right-handed axes det(b - a, c - a, d - a) > 0.
using Tetrahedron = std::array<std::uint32_t, 4>;

/// Bottom triangle 0 1 2 and top triangle 3 4 5, vertex i + 3 above vertex i: with right-handed
/// axes det(1 - 0, 2 - 0, 3 - 0) > 0. Of a VTK wedge the first triangle turns the other way, as VTK
/// documents and computes volumes; MEDIT and Gmsh list prisms like this.
using Prism = std::array<std::uint32_t, 6>;

/// Base 0 1 2 3, cyclic, and apex 4, as in all formats: with right-handed axes
/// det(1 - 0, 3 - 0, 4 - 0) > 0.
using Pyramid = std::array<std::uint32_t, 5>;

/// Each point with its weight.
struct WeightedPoints {
  std::vector<Point> points;
  std::vector<double> weights;
};

struct Surface {
  std::vector<Point> points;
  std::vector<Quad> quads;
};

struct Mesh {
  std::vector<Point> points;
  std::vector<Hexahedron> hexahedra;
  std::vector<Quad> quads;  ///< the boundary as listed in the file; empty if it lists none
};

struct TetrahedralMesh {
  std::vector<Point> points;
  std::vector<Tetrahedron> tetrahedra;
};

struct HybridMesh {
  std::vector<Point> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Hexahedron> hexahedra;
  std::vector<Prism> prisms;
  std::vector<Pyramid> pyramids;
};

/// "-" is standard input; pipes and devices are read until they end. At most 4 GiB.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path);
[[nodiscard]] Surface read_surface(const std::filesystem::path& path);
[[nodiscard]] HybridMesh read_hybrid(const std::filesystem::path& path);
[[nodiscard]] TetrahedralMesh read_tetrahedra(const std::filesystem::path& path);
/// The points of a file of points, or of a mesh of any known cells.
[[nodiscard]] std::vector<Point> read_points(const std::filesystem::path& path);
/// Points with a fourth number each, the weight: .xyz or .bin.
[[nodiscard]] WeightedPoints read_weighted_points(const std::filesystem::path& path);

/// The same for bytes in memory; the format is that of the ending of `name`, or of the first
/// bytes; `name` also opens each message.
[[nodiscard]] Mesh parse_mesh(const std::string& name, std::string_view bytes);
[[nodiscard]] Surface parse_surface(const std::string& name, std::string_view bytes);
[[nodiscard]] HybridMesh parse_hybrid(const std::string& name, std::string_view bytes);
[[nodiscard]] TetrahedralMesh parse_tetrahedra(const std::string& name, std::string_view bytes);
[[nodiscard]] std::vector<Point> parse_points(const std::string& name, std::string_view bytes);
[[nodiscard]] WeightedPoints parse_weighted_points(const std::string& name, std::string_view bytes);

}  // namespace hexatlas::check
