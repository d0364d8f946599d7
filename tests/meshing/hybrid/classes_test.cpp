// Claim. class_of() knows the class of a candidate among the subdivisions of the hexahedron,
// whatever the numbering of its vertices. Oracle. The catalogue itself: each class in each of its
// 48 images.
#include "meshing/hybrid/classes.hpp"

#include <gtest/gtest.h>

#include "enum/complex/cell.hpp"
#include "tests/meshing/hybrid/kuhn.hpp"

namespace hexatlas {
namespace {

/// The five tetrahedra with one in the middle, and the six around the diagonal 0 7.
std::vector<complex::Triangulation> two_classes() {
  const auto set = [](int a, int b, int c, int d) {
    return static_cast<complex::VertexSet>(complex::bit_of(a) | complex::bit_of(b) |
                                           complex::bit_of(c) | complex::bit_of(d));
  };
  return {
      {8, {set(0, 1, 2, 4), set(1, 2, 4, 7), set(1, 2, 3, 7), set(1, 4, 5, 7), set(2, 4, 6, 7)}},
      {8,
       {set(0, 1, 3, 7), set(0, 1, 5, 7), set(0, 2, 3, 7), set(0, 2, 6, 7), set(0, 4, 5, 7),
        set(0, 4, 6, 7)}}};
}

TEST(HexahedronClasses, CountTheCubesOfALattice) {
  const auto classes = two_classes();
  const hybrid::HexahedronClasses known(classes);
  EXPECT_EQ(known.size(), 2U);
  const mesh::TetMesh mesh = hybrid_tests::kuhn(3, 1);
  const auto graph =
      std::get<hybrid::TetGraph>(hybrid::TetGraph::of({mesh.points, mesh.tetrahedra}));
  const auto found = hybrid::candidates(graph, 0.9);
  EXPECT_EQ(known.counts(graph, found.hexahedra), (std::vector<std::size_t>{0, 27, 0}));
}

TEST(HexahedronClasses, KnowEachImage) {
  const auto classes = two_classes();
  const hybrid::HexahedronClasses known(classes);
  const auto cube = complex::cell_named("hexahedron");
  ASSERT_TRUE(cube);
  std::vector<mesh::Point> points;
  for (unsigned v = 0; v < 8; ++v)
    points.push_back({static_cast<double>(v & 1U), static_cast<double>(v >> 1U & 1U),
                      static_cast<double>(v >> 2U)});
  for (std::size_t c = 0; c < classes.size(); ++c)
    for (const complex::VertexMap& map : complex::symmetries(*cube)) {
      mesh::TetMesh mesh{points, {}};
      hybrid::CandidateList<8> list{{{{0, 1, 2, 3, 4, 5, 6, 7}, 1, 0, 0, 0}}, {}};
      for (const complex::VertexSet set : complex::image_of(classes[c], map).tetrahedra) {
        const auto v = complex::vertices_of(set);
        std::array<mesh::Index, 4> t{v[0], v[1], v[2], v[3]};
        const auto sign = [&] {
          const auto& o = points[t[0]];
          const auto d = [&](std::size_t i) {
            return std::array{points[t[i]].x - o.x, points[t[i]].y - o.y, points[t[i]].z - o.z};
          };
          const auto a = d(1), b = d(2), e = d(3);
          return a[0] * (b[1] * e[2] - b[2] * e[1]) + a[1] * (b[2] * e[0] - b[0] * e[2]) +
                 a[2] * (b[0] * e[1] - b[1] * e[0]);
        };
        if (sign() < 0) std::swap(t[0], t[1]);
        list.tetrahedra.push_back(static_cast<hybrid::TetIndex>(mesh.tetrahedra.size()));
        mesh.tetrahedra.push_back(t);
      }
      list.cells[0].inner = static_cast<std::uint8_t>(list.tetrahedra.size());
      const auto graph =
          std::get<hybrid::TetGraph>(hybrid::TetGraph::of({mesh.points, mesh.tetrahedra}));
      EXPECT_EQ(known.class_of(graph, list, 0), c);
      list.cells[0].inner -= 1;
      EXPECT_EQ(known.class_of(graph, list, 0), std::nullopt);
    }
}

}  // namespace
}  // namespace hexatlas
