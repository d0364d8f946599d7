#include "meshing/io/cell_types.hpp"

#include <algorithm>

namespace hexatlas::io {
namespace {

struct Numbered {
  std::int64_t number = 0;
  CellType type;
};

using enum CellShape;

constexpr std::array kVtkTypes{
    Numbered{0, {"empty cell", low, 0}},
    Numbered{1, {"vertex", low, 1}},
    Numbered{2, {"poly-vertex", low, 0}},
    Numbered{3, {"line", low, 2}},
    Numbered{4, {"poly-line", low, 0}},
    Numbered{5, {"triangle", surface, 3}},
    Numbered{6, {"triangle strip", surface, 0}},
    Numbered{7, {"polygon", surface, 0}},
    Numbered{8, {"pixel", pixel, 4}},
    Numbered{kFileQuad.vtk, kQuad},
    Numbered{kFileTetrahedron.vtk, kTetrahedron},
    Numbered{11, {"voxel", voxel, 8}},
    Numbered{kFileHexahedron.vtk, kHexahedron},
    Numbered{kFilePrism.vtk, kWedge},
    Numbered{kFilePyramid.vtk, kPyramid},
    Numbered{15, {"pentagonal prism", volume, 10}},
    Numbered{16, {"hexagonal prism", volume, 12}},
    Numbered{21, {"quadratic edge", low, 3}},
    Numbered{22, {"quadratic triangle", surface, 6}},
    Numbered{23, {"quadratic quad", surface, 8}},
    Numbered{24, {"quadratic tetrahedron", volume, 10}},
    Numbered{25, {"quadratic hexahedron", volume, 20}},
    Numbered{26, {"quadratic wedge", volume, 15}},
    Numbered{27, {"quadratic pyramid", volume, 13}},
    Numbered{28, {"biquadratic quad", surface, 9}},
    Numbered{29, {"triquadratic hexahedron", volume, 27}},
    Numbered{42, {"polyhedron", volume, 0}},
    Numbered{68, {"Lagrange curve", low, 0}},
    Numbered{69, {"Lagrange triangle", surface, 0}},
    Numbered{70, {"Lagrange quad", surface, 0}},
    Numbered{71, {"Lagrange tetrahedron", volume, 0}},
    Numbered{72, {"Lagrange hexahedron", volume, 0}},
    Numbered{73, {"Lagrange wedge", volume, 0}},
};

constexpr std::array kGmshTypes{
    Numbered{1, {"line", low, 2}},
    Numbered{2, {"triangle", surface, 3}},
    Numbered{kFileQuad.gmsh, kQuad},
    Numbered{kFileTetrahedron.gmsh, kTetrahedron},
    Numbered{kFileHexahedron.gmsh, kHexahedron},
    Numbered{kFilePrism.gmsh, kPrism},
    Numbered{kFilePyramid.gmsh, kPyramid},
    Numbered{8, {"second-order line", low, 3}},
    Numbered{9, {"second-order triangle", surface, 6}},
    Numbered{10, {"second-order quad", surface, 9}},
    Numbered{11, {"second-order tetrahedron", volume, 10}},
    Numbered{12, {"second-order hexahedron", volume, 27}},
    Numbered{13, {"second-order prism", volume, 18}},
    Numbered{14, {"second-order pyramid", volume, 14}},
    Numbered{15, {"point", low, 1}},
    Numbered{16, {"second-order quad", surface, 8}},
    Numbered{17, {"second-order hexahedron", volume, 20}},
    Numbered{18, {"second-order prism", volume, 15}},
    Numbered{19, {"second-order pyramid", volume, 13}},
    Numbered{26, {"third-order line", low, 4}},
};

template <std::size_t N>
std::optional<CellType> find_type(const std::array<Numbered, N>& types, std::int64_t number) {
  const auto found = std::find_if(types.begin(), types.end(),
                                  [&](const Numbered& each) { return each.number == number; });
  if (found == types.end()) return std::nullopt;
  return found->type;
}

}  // namespace

std::optional<CellType> vtk_cell_type(std::int64_t number) { return find_type(kVtkTypes, number); }

std::optional<CellType> gmsh_cell_type(std::int64_t number) {
  return find_type(kGmshTypes, number);
}

CellType polygon_type(std::size_t corners) {
  switch (corners) {
    case 3:
      return {"triangle", surface, 3};
    case 4:
      return kQuad;
    case 5:
      return {"pentagon", surface, 5};
    case 6:
      return {"hexagon", surface, 6};
    default:
      return {"polygon", surface, 0};
  }
}

}  // namespace hexatlas::io
