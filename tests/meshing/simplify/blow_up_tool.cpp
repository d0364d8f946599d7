// Makes a mesh of a ball larger at random, its boundary kept, for experiments.
// usage: meshing_simplify_blow_up MESH OUTPUT HEXAHEDRA SEED MIXING
// Boundary vertices must come first, as in the meshes of the program.
#include <cstdio>
#include <exception>
#include <string>

#include "meshing/hexahedrize/placing.hpp"
#include "meshing/io/mesh_files.hpp"
#include "tests/meshing/simplify/blow_up.hpp"

int main(int argc, char** argv) {
  using namespace hexatlas;
  try {
    if (argc != 6) {
      std::fputs("usage: meshing_simplify_blow_up MESH OUTPUT HEXAHEDRA SEED MIXING\n", stderr);
      return 2;
    }
    mesh::HexMesh mesh = io::read_hexahedra(argv[1]);
    const complex::HexComplex given{static_cast<std::uint32_t>(mesh.points.size()), mesh.hexahedra};
    const auto made =
        support::blown_up(given, std::stoi(argv[3]), std::stoull(argv[4]), std::stoi(argv[5]));
    const std::size_t boundary = complex::boundary_of(given).size() + 2;
    mesh.hexahedra = made.hexahedra;
    mesh.points.resize(boundary);
    mesh.points.resize(made.vertices);
    hexahedrize::place(mesh, boundary, {.effort = 0});
    io::write_hexahedra(argv[2], mesh);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
