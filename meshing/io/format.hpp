#pragma once
/// \file
/// The formats of mesh files and how they are told apart: by the extension of a path, or,
/// where there is none (standard input), by the first bytes.
///
/// Errors: InvalidInput if no format fits; the message lists the known ones.

#include <cstdint>
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
};

/// The extension of the format, with its dot.
[[nodiscard]] std::string_view extension_of(FileFormat format);

/// True for vtk, vtu, medit, gmsh.
[[nodiscard]] bool holds_hexahedra(FileFormat format);

/// The format that the extension of the path names, upper or lower case.
[[nodiscard]] FileFormat format_of_path(const std::string& path);

/// The format that the first bytes announce; `file` is the name used in the message. Not
/// promised: that the rest of the bytes is in that format.
[[nodiscard]] FileFormat detect_format(std::string_view bytes, const std::string& file);

}  // namespace hexatlas::io
