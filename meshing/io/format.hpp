#pragma once
/// \file
/// The formats of mesh files and how they are told apart: by the extension of a path, or,
/// where there is none (standard input), by the first bytes.
///
/// Errors: InvalidInput if no format fits; the message lists the known ones.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hexatlas::io {

enum class FileFormat : std::uint8_t {
  obj,    ///< Wavefront .obj: polygons only
  off,    ///< Geomview .off: polygons only
  vtk,    ///< VTK legacy .vtk, ASCII
  vtu,    ///< VTK XML unstructured grid .vtu
  medit,  ///< MEDIT .mesh, ASCII
  gmsh,   ///< Gmsh .msh 2.2 and 4.1
  xyz,    ///< lines of coordinates .xyz: points only, with weights too
  raw,    ///< coordinates in binary .bin: points only, with weights too
  ply,    ///< .ply, ASCII and little-endian binary: its points only
  hxtet,  ///< tetrahedra in binary .hxtet
};

/// What a caller wants of a file, or puts into it.
enum class Content : std::uint8_t {
  points,
  weighted_points,
  surface,
  tetrahedra,
  hexahedra,
  hybrid
};

/// The extension of the format, with its dot.
[[nodiscard]] std::string_view extension_of(FileFormat format);

/// Whether files of this format are read and written (points, weighted or not: read) with such
/// content.
[[nodiscard]] bool holds(FileFormat format, Content content);
[[nodiscard]] inline bool holds_hexahedra(FileFormat format) {
  return holds(format, Content::hexahedra);
}

/// Throws InvalidInput, in the name of `file`, unless holds(format, content).
void expect_holds(FileFormat format, Content content, const std::string& file);

/// The format that the extension of the path names, upper or lower case. `content` chooses what
/// the message lists, not what is accepted.
[[nodiscard]] FileFormat format_of_path(const std::string& path,
                                        std::optional<Content> content = {});

/// The format that the first bytes announce; `file` is the name used in the message. Raw
/// coordinates announce nothing and are not found; a first word that is a number announces .xyz.
/// Not promised: that the rest of the bytes is in that format.
[[nodiscard]] FileFormat detect_format(std::string_view bytes, const std::string& file,
                                       std::optional<Content> content = {});

}  // namespace hexatlas::io
