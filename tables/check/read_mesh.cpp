#include <algorithm>
#include <array>
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
  if (begins_like_hxtet(bytes)) return ".hxtet";
  Scanner in(name, bytes, '#');
  if (in.at_end()) throw Malformed(name, 0, "is empty");
  const std::string_view first = in.peek();
  if (first.starts_with("<?xml") || first.starts_with("<VTKFile")) return ".vtu";
  if (first == "MeshVersionFormatted") return ".mesh";
  if (first == "$MeshFormat") return ".msh";
  if (first == "OFF" || first == "COFF") return ".off";
  if (first == "ply") return ".ply";
  return ".obj";
}

/// The ending of the name, or where it has none (standard input, the pipe /dev/fd/63) the one that
/// the first bytes announce.
std::string format_of(const std::string& name, std::string_view bytes) {
  const std::string given = ending(name);
  return given.empty() ? announced_ending(name, bytes) : given;
}

Draft parse_draft(const std::string& name, std::string_view bytes, Wanted wanted) {
  const std::string format = format_of(name, bytes);
  if (format == ".vtk") return parse_legacy_vtk(name, bytes, wanted);
  if (format == ".vtu") return parse_vtu(name, bytes, wanted);
  if (format == ".mesh") return parse_medit(name, bytes, wanted);
  if (format == ".msh") return parse_gmsh(name, bytes, wanted);
  const bool takes_hxtet = wanted == Wanted::kTetrahedra || wanted == Wanted::kPoints;
  if (format == ".hxtet" && takes_hxtet) return parse_hxtet(name, bytes, wanted);
  const std::string known =
      takes_hxtet ? ".vtk, .vtu, .mesh, .msh or .hxtet" : ".vtk, .vtu, .mesh or .msh";
  throw Malformed(name, 0,
                  ending(name).empty() ? "begins like no " + known + " file"
                  : wanted == Wanted::kPoints
                      ? "a file of points ends in .xyz, .bin, .ply, .obj, .off, " + known
                      : "a mesh file ends in " + known);
}

}  // namespace

std::size_t corner_count(Shape shape) {
  constexpr std::array<std::size_t, kShapes> kCorners = {1, 2, 3, 4, 4, 8, 6, 6, 5};
  return kCorners[static_cast<std::size_t>(shape)];
}

bool Draft::refuses(Shape shape) const {
  switch (shape) {
    case Shape::kTriangle:
    case Shape::kTetrahedron:
      return wanted_ == Wanted::kHexahedra;
    case Shape::kHexahedron:
      return wanted_ == Wanted::kTetrahedra;
    case Shape::kPrism:
    case Shape::kWedge:
    case Shape::kPyramid:
      return wanted_ == Wanted::kTetrahedra || wanted_ == Wanted::kHexahedra;
    default:
      return false;
  }
}

void Draft::add(Shape shape, std::span<const std::uint32_t> corners) {
  const auto append = [&corners](auto& cells) {
    std::copy(corners.begin(), corners.end(), cells.emplace_back().begin());
  };
  if (wanted_ == Wanted::kPoints) return;
  if (wanted_ == Wanted::kHexahedra && shape == Shape::kQuad) append(quads);
  if (shape == Shape::kHexahedron) append(hexahedra);
  if (shape == Shape::kTetrahedron) append(tetrahedra);
  if (shape == Shape::kPyramid) append(pyramids);
  if (shape == Shape::kPrism || shape == Shape::kWedge) append(prisms);
  if (shape == Shape::kWedge) {
    std::swap(prisms.back()[1], prisms.back()[2]);
    std::swap(prisms.back()[4], prisms.back()[5]);
  }
}

const char* Draft::refusal() const {
  if (wanted_ == Wanted::kHexahedra) {
    return "neither a hexahedron nor a quad, so that this is a mesh for --hybrid or --delaunay";
  }
  return wanted_ == Wanted::kTetrahedra ? "no tetrahedron" : "of no known kind";
}

Mesh parse_mesh(const std::string& name, std::string_view bytes) {
  Draft draft = parse_draft(name, bytes, Wanted::kHexahedra);
  return {std::move(draft.points), std::move(draft.hexahedra), std::move(draft.quads)};
}

HybridMesh parse_hybrid(const std::string& name, std::string_view bytes) {
  Draft draft = parse_draft(name, bytes, Wanted::kHybrid);
  return {std::move(draft.points), std::move(draft.tetrahedra), std::move(draft.hexahedra),
          std::move(draft.prisms), std::move(draft.pyramids)};
}

TetrahedralMesh parse_tetrahedra(const std::string& name, std::string_view bytes) {
  Draft draft = parse_draft(name, bytes, Wanted::kTetrahedra);
  return {std::move(draft.points), std::move(draft.tetrahedra)};
}

std::vector<Point> parse_points(const std::string& name, std::string_view bytes) {
  const std::string format = format_of(name, bytes);
  if (format == ".bin") return parse_bin(name, bytes);
  if (format == ".ply") return parse_ply(name, bytes);
  if (format == ".off") return parse_off_points(name, bytes);
  if (ending(name) == ".obj") return parse_obj_points(name, bytes);
  if (format == ".xyz" || (ending(name).empty() && format == ".obj")) return parse_xyz(name, bytes);
  return parse_draft(name, bytes, Wanted::kPoints).points;
}

WeightedPoints parse_weighted_points(const std::string& name, std::string_view bytes) {
  const std::string format = format_of(name, bytes);
  if (format == ".bin") return parse_weighted_bin(name, bytes);
  if (format == ".xyz" || (ending(name).empty() && format == ".obj")) {
    return parse_weighted_xyz(name, bytes);
  }
  throw Malformed(name, 0, "a file of points with weights ends in .xyz or .bin");
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

HybridMesh read_hybrid(const std::filesystem::path& path) {
  return parse_hybrid(name_of_file(path), bytes_of_file(path));
}

TetrahedralMesh read_tetrahedra(const std::filesystem::path& path) {
  return parse_tetrahedra(name_of_file(path), bytes_of_file(path));
}

WeightedPoints read_weighted_points(const std::filesystem::path& path) {
  return parse_weighted_points(name_of_file(path), bytes_of_file(path));
}

std::vector<Point> read_points(const std::filesystem::path& path) {
  return parse_points(name_of_file(path), bytes_of_file(path));
}

}  // namespace hexatlas::check
