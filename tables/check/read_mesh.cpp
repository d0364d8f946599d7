#include <utility>

#include "tables/check/file_bytes.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

/// In lower case.
std::string ending(const std::string& name) {
  std::string result = std::filesystem::path(name).extension().string();
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

/// Whether the first words are those of the heading of a legacy VTK file, which looks like a
/// comment to other formats.
bool begins_like_legacy_vtk(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes);
  for (const std::string_view wanted : {"#", "vtk", "DataFile"}) {
    if (in.peek() != wanted) return false;
    static_cast<void>(in.word());
  }
  return true;
}

/// The ending of the format that the first bytes announce. OBJ has no heading: it is what remains.
std::string announced_ending(const std::string& name, std::string_view bytes) {
  if (begins_like_legacy_vtk(name, bytes)) return ".vtk";
  Scanner in(name, bytes, '#');
  if (in.at_end()) throw Malformed(name, 0, "is empty");
  const std::string_view first = in.peek();
  if (first.starts_with("<?xml") || first.starts_with("<VTKFile")) return ".vtu";
  if (first == "MeshVersionFormatted") return ".mesh";
  if (first == "$MeshFormat") return ".msh";
  if (first == "OFF") return ".off";
  return ".obj";
}

/// The ending of the name, or where it has none (standard input, the pipe /dev/fd/63) the one that
/// the first bytes announce.
std::string format_of(const std::string& name, std::string_view bytes) {
  const std::string given = ending(name);
  return given.empty() ? announced_ending(name, bytes) : given;
}

}  // namespace

Mesh parse_mesh(const std::string& name, std::string_view bytes) {
  const std::string format = format_of(name, bytes);
  if (format == ".vtk") return parse_legacy_vtk(name, bytes);
  if (format == ".vtu") return parse_vtu(name, bytes);
  if (format == ".mesh") return parse_medit(name, bytes);
  if (format == ".msh") return parse_gmsh(name, bytes);
  throw Malformed(name, 0,
                  ending(name).empty() ? "begins like no .vtk, .vtu, .mesh or .msh file"
                                       : "a mesh file ends in .vtk, .vtu, .mesh or .msh");
}

Surface parse_surface(const std::string& name, std::string_view bytes) {
  const std::string format = format_of(name, bytes);
  if (format == ".obj") return parse_obj(name, bytes);
  if (format == ".off") return parse_off(name, bytes);
  Mesh mesh = parse_mesh(name, bytes);
  if (!mesh.hexahedra.empty()) throw Malformed(name, 0, "a surface has no hexahedra");
  return {std::move(mesh.points), std::move(mesh.quads)};
}

Mesh read_mesh(const std::filesystem::path& path) {
  return parse_mesh(name_of_file(path), bytes_of_file(path));
}

Surface read_surface(const std::filesystem::path& path) {
  return parse_surface(name_of_file(path), bytes_of_file(path));
}

}  // namespace hexatlas::check
