// Program for peers_test.py: writes a mesh in a format, or prints the mesh that a file states.
//   mesh_tool write-hexahedra FORMAT FILE     FORMAT: vtk vtu medit gmsh2 gmsh4
//   mesh_tool write-surface FORMAT FILE       FORMAT: these, obj, off
//   mesh_tool write-tetrahedra FORMAT FILE    FORMAT: vtk vtu medit gmsh4 hxtet
//   mesh_tool write-hybrid FORMAT FILE        FORMAT: vtk vtu medit gmsh4
//   mesh_tool print-hexahedra FILE
//   mesh_tool print-hybrid FILE
//   mesh_tool print-tetrahedra FILE
//   mesh_tool print-surface FILE
//   mesh_tool print-points FILE
// The mesh written is a grid of 3 x 2 x 2 skewed hexahedra; the surface is its boundary; of
// tetrahedra there are six in each hexahedron, around a diagonal; of a hybrid mesh every second
// hexahedron is cut, in turn in two prisms, six pyramids around its centre, or six tetrahedra, so
// that it is not conforming.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "meshing/io/mesh_files.hpp"

namespace {

using namespace hexatlas;

constexpr std::array<mesh::Index, 3> kCells{3, 2, 2};

mesh::HexMesh make_grid() {
  mesh::HexMesh mesh;
  const auto vertex = [](mesh::Index x, mesh::Index y, mesh::Index z) {
    return x + (kCells[0] + 1) * (y + (kCells[1] + 1) * z);
  };
  for (mesh::Index z = 0; z <= kCells[2]; ++z)
    for (mesh::Index y = 0; y <= kCells[1]; ++y)
      for (mesh::Index x = 0; x <= kCells[0]; ++x)
        mesh.points.push_back({x + 0.1 * y, y / 3.0 + 0.01 * z, 1.5 * z + 0.1 * x * y});
  for (mesh::Index z = 0; z < kCells[2]; ++z)
    for (mesh::Index y = 0; y < kCells[1]; ++y)
      for (mesh::Index x = 0; x < kCells[0]; ++x) {
        auto& hexahedron = mesh.hexahedra.emplace_back();
        for (mesh::Index v = 0; v < 8; ++v)
          hexahedron[v] = vertex(x + (v & 1U), y + (v >> 1U & 1U), z + (v >> 2U & 1U));
      }
  return mesh;
}

using Hexahedron = std::array<mesh::Index, 8>;
using Tetrahedra = std::vector<std::array<mesh::Index, 4>>;

void split(const Hexahedron& hexahedron, Tetrahedra& tetrahedra) {
  // Each has the corners of a path from 0 to 7 along three edges, in right-handed order.
  constexpr std::array<std::array<std::size_t, 4>, 6> kPaths{
      {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 5, 1, 7}, {0, 6, 4, 7}}};
  for (const auto& path : kPaths)
    tetrahedra.push_back(
        {hexahedron[path[0]], hexahedron[path[1]], hexahedron[path[2]], hexahedron[path[3]]});
}

mesh::TetMesh split(const mesh::HexMesh& mesh) {
  mesh::TetMesh tetrahedra{mesh.points, {}};
  for (const auto& hexahedron : mesh.hexahedra) split(hexahedron, tetrahedra.tetrahedra);
  return tetrahedra;
}

mesh::Point centre_of(const std::vector<mesh::Point>& points, const Hexahedron& hexahedron) {
  mesh::Point sum;
  for (const mesh::Index v : hexahedron)
    sum = {sum.x + points[v].x, sum.y + points[v].y, sum.z + points[v].z};
  return {sum.x / 8, sum.y / 8, sum.z / 8};
}

mesh::HybridMesh mix(const mesh::HexMesh& mesh) {
  mesh::HybridMesh hybrid{mesh.points, {}, {}, {}, {}};
  for (std::size_t i = 0; i < mesh.hexahedra.size(); ++i) {
    const Hexahedron& h = mesh.hexahedra[i];
    if (i % 6 == 1) {
      hybrid.prisms.push_back({h[0], h[1], h[2], h[4], h[5], h[6]});
      hybrid.prisms.push_back({h[3], h[2], h[1], h[7], h[6], h[5]});
    } else if (i % 6 == 3) {
      const auto centre = static_cast<mesh::Index>(hybrid.points.size());
      hybrid.points.push_back(centre_of(mesh.points, h));
      for (const auto& facet : cells::kFacetVertices)  // seen from outside, so from inside reversed
        hybrid.pyramids.push_back({h[facet[3]], h[facet[2]], h[facet[1]], h[facet[0]], centre});
    } else if (i % 6 == 5) {
      split(h, hybrid.tetrahedra);
    } else {
      hybrid.hexahedra.push_back(h);
    }
  }
  return hybrid;
}

mesh::SurfaceMesh boundary_of(const mesh::HexMesh& mesh) {
  std::map<std::array<mesh::Index, 4>, std::array<mesh::Index, 4>> once;
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& facet : cells::kFacetVertices) {
      std::array<mesh::Index, 4> quad{};
      for (std::size_t k = 0; k < 4; ++k) quad[k] = hexahedron[facet[k]];
      auto key = quad;
      std::sort(key.begin(), key.end());
      if (!once.emplace(key, quad).second) once.erase(key);
    }
  mesh::SurfaceMesh surface{mesh.points, {}, {}};
  for (const auto& [key, quad] : once) surface.quads.push_back(quad);
  return surface;
}

const std::map<std::string, io::FileFormat> kFormats{
    {"obj", io::FileFormat::obj},     {"off", io::FileFormat::off},
    {"vtk", io::FileFormat::vtk},     {"vtu", io::FileFormat::vtu},
    {"medit", io::FileFormat::medit}, {"gmsh2", io::FileFormat::gmsh},
    {"gmsh4", io::FileFormat::gmsh},  {"hxtet", io::FileFormat::hxtet}};

void print_cells(const auto& cells) {
  for (const auto& cell : cells) {
    for (const mesh::Index index : cell) std::printf("%u ", index);
    std::printf("\n");
  }
}

/// Cells of each number of corners, one list after the other.
template <class... Cells>
void print(const std::vector<mesh::Point>& points, const Cells&... cells) {
  std::printf("%zu %zu\n", points.size(), (cells.size() + ...));
  for (const mesh::Point& p : points) std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z);
  (print_cells(cells), ...);
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 2 && words[0] == "print-surface") {
    const mesh::SurfaceMesh mesh = io::read_surface(words[1]);
    print(mesh.points, mesh.quads);
    return 0;
  }
  if (words.size() == 2 && words[0] == "print-hexahedra") {
    const mesh::HexMesh mesh = io::read_hexahedra(words[1]);
    print(mesh.points, mesh.hexahedra);
    return 0;
  }
  if (words.size() == 2 && words[0] == "print-tetrahedra") {
    const mesh::TetMesh mesh = io::read_tetrahedra(words[1]);
    print(mesh.points, mesh.tetrahedra);
    return 0;
  }
  if (words.size() == 2 && words[0] == "print-hybrid") {
    const mesh::HybridMesh mesh = io::read_hybrid(words[1]);
    print(mesh.points, mesh.tetrahedra, mesh.hexahedra, mesh.prisms, mesh.pyramids);
    return 0;
  }
  if (words.size() == 2 && words[0] == "print-points") {
    print(io::read_points(words[1]), std::vector<std::array<mesh::Index, 1>>{});
    return 0;
  }
  if (words.size() != 3 || !kFormats.contains(words[1])) return 2;
  const io::FileFormat format = kFormats.at(words[1]);
  const auto version = words[1] == "gmsh2" ? io::GmshVersion::v2_2 : io::GmshVersion::v4_1;
  const mesh::HexMesh grid = make_grid();
  const mesh::SurfaceMesh surface = boundary_of(grid);
  const mesh::TetMesh tetrahedra = split(grid);
  if (words[0] == "write-hexahedra")
    io::write_hexahedra(words[2], grid, format, {version, surface.quads});
  else if (words[0] == "write-hybrid")
    io::write_hybrid(words[2], mix(grid), format);
  else if (words[0] == "write-tetrahedra")
    io::write_tetrahedra(words[2], {tetrahedra.points, tetrahedra.tetrahedra}, format);
  else
    core::write_file(words[2], io::to_text(surface, format, version));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const hexatlas::core::InvalidInput& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
