#include <utility>

#include "tables/check/file_bytes.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/readers.hpp"

namespace hexatlas::check {

namespace {

/// In lower case.
std::string ending(const std::string& name) {
  std::string result = std::filesystem::path(name).extension().string();
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace

Mesh parse_mesh(const std::string& name, std::string_view bytes) {
  const std::string format = ending(name);
  if (format == ".vtk") return parse_legacy_vtk(name, bytes);
  if (format == ".vtu") return parse_vtu(name, bytes);
  if (format == ".mesh") return parse_medit(name, bytes);
  if (format == ".msh") return parse_gmsh(name, bytes);
  throw Malformed(name, 0, "a mesh file ends in .vtk, .vtu, .mesh or .msh");
}

Surface parse_surface(const std::string& name, std::string_view bytes) {
  const std::string format = ending(name);
  if (format == ".obj") return parse_obj(name, bytes);
  if (format == ".off") return parse_off(name, bytes);
  Mesh mesh = parse_mesh(name, bytes);
  if (!mesh.hexahedra.empty()) throw Malformed(name, 0, "a surface has no hexahedra");
  return {std::move(mesh.points), std::move(mesh.quads)};
}

Mesh read_mesh(const std::filesystem::path& path) {
  return parse_mesh(path.string(), bytes_of_file(path));
}

Surface read_surface(const std::filesystem::path& path) {
  return parse_surface(path.string(), bytes_of_file(path));
}

}  // namespace hexatlas::check
