// Claim. Cells of four shapes are read and written in four formats, bit for bit and with corners in
// the order of each format; models come with their regions, triangles and colours; other cells and
// damaged files are refused with InvalidInput at their line.
// Oracle. Hand-made files; seeded random meshes compared with themselves; literal bytes; the order
// of corners is that of hybrid_peers_test.py.
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "tests/meshing/io/malformed.hpp"
#include "tests/meshing/io/random_meshes.hpp"
#include "tests/meshing/io/sample_hybrid.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

constexpr std::array kHybridFormats{vtk, vtu, medit, gmsh};

TEST(Hybrid, Read) {
  for (const Sample& sample : hybrid_samples())
    EXPECT_TRUE(same(io::parse_hybrid(sample.bytes, sample.format, "f"), kFour)) << sample.name;
}

TEST(Hybrid, OneShapeAloneIsOne) {
  for (const Sample& sample : tetrahedra_samples())
    if (sample.format != hxtet) {
      const mesh::HybridMesh mesh = io::parse_hybrid(sample.bytes, sample.format, "f");
      EXPECT_EQ(mesh.tetrahedra, kTetrahedra) << sample.name;
      EXPECT_TRUE(mesh.hexahedra.empty() && mesh.prisms.empty() && mesh.pyramids.empty());
    }
  for (const Sample& sample : hexahedra_samples()) {
    const mesh::HybridMesh mesh = io::parse_hybrid(sample.bytes, sample.format, "f");
    EXPECT_EQ(mesh.hexahedra, kFour.hexahedra) << sample.name;
  }
  const std::string voxel =
      edit(edit(kHybridVtk, "8 0 1 2 3 4 5 6 7", "8 0 1 3 2 4 5 7 6"), "\n12\n", "\n11\n");
  EXPECT_TRUE(same(io::parse_hybrid(voxel, vtk, "f"), kFour));
}

TEST(Hybrid, RoundTrip) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::size_t points = 8 + random() % (seed % 20 == 0 ? 40000 : 50);
    // Some shapes are missing, but not all.
    const auto some = [&] { return random() % 3 == 0 ? 0 : 1 + random() % 40; };
    const mesh::HybridMesh mesh{
        random_points(random, points), random_cells<4>(random, points, some()),
        random_cells<8>(random, points, some()), random_cells<6>(random, points, some()),
        random_cells<5>(random, points, 1 + some())};
    for (const FileFormat format : kHybridFormats) {
      const std::string text = io::to_text(mesh, format);
      EXPECT_TRUE(same(io::parse_hybrid(text, format, "f"), mesh)) << io::extension_of(format);
      EXPECT_TRUE(same(io::parse_points(text, format, "f"), mesh.points));
      EXPECT_EQ(text, io::to_text(mesh, format));
    }
  }
}

TEST(Hybrid, Layouts) {
  EXPECT_TRUE(io::to_text(kFour, medit)
                  .ends_with("\n0 1 1 0\nTetrahedra\n1\n1 2 4 5 0\nHexahedra\n1\n"
                             "1 2 3 4 5 6 7 8 0\nPrisms\n1\n1 2 3 5 6 7 0\nPyramids\n2\n"
                             "1 2 3 4 5 0\n5 8 7 6 1 0\nEnd\n"));
  EXPECT_TRUE(io::to_text(kFour, vtk)
                  .ends_with("\nCELLS 5 33\n4 0 1 3 4\n8 0 1 2 3 4 5 6 7\n6 0 2 1 4 6 5\n5 0 1 2 3 "
                             "4\n5 4 7 6 5 0\n"
                             "CELL_TYPES 5\n10\n12\n13\n14\n14\n"));
  const std::string in_gmsh = io::to_text(kFour, gmsh);
  EXPECT_NE(in_gmsh.find("$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 0\n"), std::string::npos);
  EXPECT_NE(in_gmsh.find("$Elements\n4 5 1 5\n3 1 4 1\n1 1 2 4 5\n3 1 5 1\n2 1 2 3 4 5 6 7 8\n"
                         "3 1 6 1\n3 1 2 3 5 6 7\n3 1 7 2\n4 1 2 3 4 5\n5 5 8 7 6 1\n"),
            std::string::npos);
  const std::string in_vtu = io::to_text(kFour, vtu);
  EXPECT_NE(in_vtu.find(packed(std::uint64_t{5}) + "\x0a\x0c\x0d\x0e\x0e\n</AppendedData>"),
            std::string::npos);
}

TEST(Hybrid, NoneAreWrittenButNotRead) {
  const mesh::HybridMesh none{kPoints, {}, {}, {}, {}};
  for (const FileFormat format : kHybridFormats) {
    const std::string text = io::to_text(none, format);
    EXPECT_EQ(io::parse_points(text, format, "f"), kPoints) << io::extension_of(format);
    expect_all_refused({{format, text, 0, "contains no tetrahedron, hexahedron, prism or pyramid"}},
                       io::parse_hybrid);
  }
}

TEST(Malformed, Hybrid) {
  const std::string every = "; every cell must be a tetrahedron, hexahedron, prism or pyramid";
  const std::string ten = edit(edit(kHybridVtk, "8 0 1 2 3 4 5 6 7", "8 0 1 2 3 4 5 6 7"),
                               "CELL_TYPES 6\n14\n13\n12", "CELL_TYPES 6\n14\n13\n42");
  expect_all_refused(
      {
          {vtk, ten, 17, "polyhedron" + every},
          {vtk, edit(kHybridVtk, "6 0 2 1 4 6 5", "6 0 2 1 4 6 8"), 16, "index 8 is too large"},
          {vtk, edit(kHybridVtk, "6 0 2 1 4 6 5", "6 0 2 1 4 6 0"), 16, "wedge with a repeated"},
          {vtk, edit(kHybridVtk, "5 0 1 2 3 4", "5 0 1 2 3 0"), 15, "pyramid with a repeated"},
          {vtk, edit(kHybridVtk, "\n14\n13\n", "\n13\n13\n"), 15, "wedge with 5 vertices"},
          {vtk, edit(kHybridVtk, "\n14\n13\n", "\n14\n14\n"), 16, "pyramid with 6 vertices"},
          {vtu, edit(kHybridVtu, "14 13 12", "14 14 12"), 7, "pyramid with 6 vertices"},
          {vtu, edit(kHybridVtu, "14 13 12", "14 13 29"), 8, "triquadratic hexahedron with 8"},
          {vtu, edit(kHybridVtu, "0 2 1 4 6 5", "0 2 1 4 6 6"), 7, "wedge with a repeated vertex"},
          {medit, edit(kHybridMedit, "1 2 3 5 6 7 1", "1 2 3 5 6 9 1"), 18, "index 9 is too large"},
          {medit, edit(kHybridMedit, "1 2 3 5 6 7 1", "1 2 3 5 6 6 1"), 18, "prism with a repea"},
          {medit, edit(kHybridMedit, "Prisms 1", "Prisms 2"), 19, "'Hexahedra' is not an integer"},
          {gmsh, edit(kHybridGmsh2, "2 6 2 0 1 1 2 3", "2 6 2 0 1 1 2 2"), 18, "prism with a rep"},
          {gmsh, edit(kHybridGmsh2, "1 7 2 0 1", "1 19 2 0 1 1 2 3 4 5 6 7 8"), 17,
           "second-order pyramid" + every},
          {gmsh, edit(kHybridGmsh2, "1 7 2 0 1 1 2 3 4 5", "1 7 2 0 1 1 2 3 4 9"), 17, "tag 9"},
          {gmsh, edit(kHybridGmsh4, "3 1 6 1", "3 1 6 2"), 31, "no node with tag 9"},
          {obj, kObj, 0, "the format .obj is not one for hybrid meshes (known: .vtk .vtu .mesh"},
          {hxtet, hxtet_bytes(), 0, "the format .hxtet is not one for hybrid meshes"},
      },
      io::parse_hybrid);
  for (const Sample& sample : hybrid_samples()) {
    EXPECT_THROW(static_cast<void>(io::parse_tetrahedra(sample.bytes, sample.format, "f")),
                 core::InvalidInput);
    EXPECT_THROW(static_cast<void>(io::parse_tet_model(sample.bytes, sample.format, "f")),
                 core::InvalidInput);
    EXPECT_THROW(static_cast<void>(io::parse_hexahedra(sample.bytes, sample.format, "f")),
                 core::InvalidInput);
  }
}

TEST(Hybrid, Preconditions) {
  EXPECT_THROW(static_cast<void>(io::to_text(kFour, off)), core::PreconditionViolated);
  EXPECT_THROW(static_cast<void>(io::to_text(kFour, hxtet)), core::PreconditionViolated);
  for (const FileFormat format : kHybridFormats) {
    mesh::HybridMesh mesh = kFour;
    mesh.prisms[0][5] = 8;
    EXPECT_THROW(static_cast<void>(io::to_text(mesh, format)), core::PreconditionViolated);
    mesh = kFour;
    mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(io::to_text(mesh, format)), core::PreconditionViolated);
  }
}

TEST(Hybrid, Files) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "hexatlas_hybrid";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const FileFormat format : kHybridFormats) {
    const std::string file = folder / ("a" + std::string(io::extension_of(format)));
    io::expect_hybrid_writable(file);
    io::write_hybrid(file, kFour);
    EXPECT_TRUE(same(io::read_hybrid(file), kFour)) << file;
    const std::string odd = folder / "odd.name";
    io::write_hybrid(odd, kFour, format);
    EXPECT_TRUE(same(io::read_hybrid(odd, format), kFour)) << file;
  }
  for (const char* name : {"a.obj", "a.hxtet", "a.stl", "missing/a.vtu"}) {
    EXPECT_THROW(io::expect_hybrid_writable(folder / name), core::InvalidInput) << name;
    EXPECT_THROW(io::write_hybrid(folder / name, kFour), core::InvalidInput) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  }
  EXPECT_THROW(io::write_hybrid("-", kFour), core::InvalidInput);
  std::filesystem::remove_all(folder);
}

// Regions and colours that differ from each other and from all else in the files.
const std::string kModelMedit =
    edit(edit(edit(kTetMedit, "1 2 4 5 1", "1 2 4 5 11"), "7 5 2 4 1", "7 5 2 4 4294967295"),
         "1 2 4 7", "1 2 4 21");

const std::string kModelGmsh2 = kGmshNodes2 + R"($Elements
5
1 4 2 8 11 1 2 4 5
2 2 3 8 21 9 1 2 4
3 4 4 8 12 1 9 7 5 2 4
4 2 0 2 3 4
5 3 2 0 5 1 2 3 4
$EndElements
)";

const std::string kModelGmsh4 = kHexGmsh4.substr(0, kHexGmsh4.find("$Elements")) + R"($Elements
4 4 1 4
3 11 4 1
1 1 2 4 5
2 21 2 1
2 1 2 4
3 12 4 1
3 7 5 2 4
2 22 2 1
4 2 3 4
$EndElements
)";

std::string model_gmsh2_binary() {
  const auto row = [](auto... numbers) { return packed(std::int32_t{numbers}...); };
  return gmsh2_binary().substr(0, gmsh2_binary().find("$Elements")) + "$Elements\n4\n" +
         row(4, 2, 2) + row(1, 8, 11, 1, 2, 4, 5) + row(2, 8, 12, 7, 5, 2, 4) +  //
         row(2, 1, 3) + row(3, 8, 21, 9, 1, 2, 4) + row(2, 1, 1) + row(4, 8, 2, 3, 4) +
         "\n$EndElements\n";
}

TEST(TetModel, Medit) {
  const mesh::TetModel model = io::parse_tet_model(kModelMedit, medit, "f");
  EXPECT_TRUE(same(model.mesh, {kPoints, kTetrahedra}));
  EXPECT_EQ(model.regions, (std::vector<std::uint32_t>{11, 4294967295}));
  EXPECT_EQ(model.triangles, (std::vector<std::array<mesh::Index, 3>>{{0, 1, 3}}));
  EXPECT_EQ(model.colours, (std::vector<std::uint32_t>{21}));
}

TEST(TetModel, Gmsh) {
  for (const auto& [bytes, second] :
       {std::pair{kModelGmsh2, 0U}, {kModelGmsh4, 22U}, {model_gmsh2_binary(), 0U}}) {
    const mesh::TetModel model = io::parse_tet_model(bytes, gmsh, "f");
    EXPECT_TRUE(same(model.mesh, {kPoints, kTetrahedra}));
    EXPECT_EQ(model.regions, (std::vector<std::uint32_t>{11, 12}));
    EXPECT_EQ(model.triangles, (std::vector<std::array<mesh::Index, 3>>{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(model.colours, (std::vector<std::uint32_t>{21, second}));
  }
}

TEST(TetModel, FormatsWithoutReferences) {
  for (const Sample& sample : tetrahedra_samples()) {
    const mesh::TetModel model = io::parse_tet_model(sample.bytes, sample.format, "f");
    EXPECT_TRUE(same(model.mesh, {kPoints, kTetrahedra})) << sample.name;
    const bool has_references = sample.format == medit || sample.format == gmsh;
    EXPECT_EQ(model.regions.size(), has_references ? 2U : 0U) << sample.name;
    EXPECT_EQ(model.triangles.size(), model.colours.size()) << sample.name;
  }
  const mesh::TetModel model = io::parse_tet_model(kTetVtk, vtk, "f");
  EXPECT_EQ(model.triangles, (std::vector<std::array<mesh::Index, 3>>{{0, 1, 2}}));
  EXPECT_EQ(model.colours, (std::vector<std::uint32_t>{0}));
}

TEST(TetModel, FromAFile) {
  const std::string file = std::filesystem::path(testing::TempDir()) / "hexatlas_model.mesh";
  io::write_tetrahedra(file, {kPoints, kTetrahedra});
  EXPECT_EQ(io::read_tet_model(file).regions, (std::vector<std::uint32_t>{0, 0}));
  std::filesystem::remove(file);
}

TEST(Malformed, TetModel) {
  expect_all_refused(
      {
          {medit, edit(kModelMedit, "1 2 4 5 11", "1 2 4 5 -1"), 15, "reference -1 is not between"},
          {medit, edit(kModelMedit, "4294967295", "4294967296"), 16, "reference 4294967296 is not"},
          {medit, edit(kModelMedit, "1 2 4 21", "1 2 4 -3"), 13, "reference -3 is not between"},
          {medit, edit(kModelMedit, "1 2 4 21", "1 2 2 21"), 13, "triangle with a repeated"},
          {medit, edit(kModelMedit, "1 2 4 21", "1 2 9 21"), 13, "index 9 is too large"},
          {gmsh, edit(kModelGmsh2, "8 11 1 2", "8 -1 1 2"), 17, "reference -1 is not between"},
          {gmsh, edit(kModelGmsh2, "5 3 2 0 5", "5 6 2 0 5 5 6"), 21, "prism; every cell must be"},
          {gmsh, edit(kModelGmsh4, "3 11 4 1", "3 -11 4 1"), 27, "reference -11 is not between"},
          {vtk, kHybridVtk, 15, "pyramid; every cell must be a tetrahedron"},
      },
      io::parse_tet_model);
}

TEST(Hybrid, RegionsAreWritten) {
  mesh::HybridMesh mesh = kFour;
  mesh.regions = {7, 0, 4'000'000'000, 7, 7};
  for (const FileFormat format : kHybridFormats) {
    const std::string text = io::to_text(mesh, format);
    EXPECT_TRUE(same(io::parse_hybrid(text, format, "f"), kFour)) << io::extension_of(format);
    EXPECT_NE(text, io::to_text(kFour, format));
  }
  EXPECT_NE(io::to_text(mesh, vtk).find("SCALARS region unsigned_int 1\nLOOKUP_TABLE default\n"
                                        "7\n0\n4000000000\n7\n7\n"),
            std::string::npos);
  EXPECT_NE(io::to_text(mesh, vtu).find("<CellData Scalars=\"region\">"), std::string::npos);
  // Volumes 7 and, for regions that are no tags of Gmsh, 1 and 2.
  EXPECT_NE(io::to_text(mesh, gmsh).find("$Entities\n0 0 0 3\n1 "), std::string::npos);
  mesh.regions.pop_back();
  EXPECT_THROW((void)io::to_text(mesh, medit), core::PreconditionViolated);
}

TEST(Hybrid, ColoursOfFacetsAreReadBack) {
  mesh::FacetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.facets = {{{0, 1, 2, 3}, 4, 0, 5}, {{0, 1, 4, 0}, 3, 0, 9}, {{1, 2, 4, 0}, 3, 0, 5}};
  const auto colours = [](const mesh::FacetMesh& some) {
    std::vector<std::int64_t> all;
    for (const mesh::Facet& facet : some.facets) all.push_back(facet.colour);
    return all;
  };
  const auto read_back = [&](FileFormat format) {
    return colours(io::parse_facets(io::to_text(mesh, format), format, "f"));
  };
  EXPECT_EQ(read_back(medit), (std::vector<std::int64_t>{9, 5, 5}));
  EXPECT_EQ(read_back(gmsh), (std::vector<std::int64_t>{5, 9, 5}));
  EXPECT_EQ(read_back(FileFormat::off), (std::vector<std::int64_t>{0, 0, 0}));
  EXPECT_NE(io::to_text(mesh, gmsh).find("$Entities\n0 0 2 0\n5 "), std::string::npos);
  EXPECT_NE(io::to_text(mesh, vtk).find("LOOKUP_TABLE default\n9\n5\n5\n"), std::string::npos);
  mesh.facets[0].colour = -1;
  EXPECT_THROW((void)io::to_text(mesh, medit), core::PreconditionViolated);
  for (mesh::Facet& facet : mesh.facets) facet.colour = 0;
  EXPECT_EQ(read_back(gmsh), (std::vector<std::int64_t>{1, 1, 1}));
  EXPECT_EQ(io::to_text(mesh, vtk).find("region"), std::string::npos);
}

TEST(Hybrid, RegionsOfTetrahedraAreReadBack) {
  mesh::HybridMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {2, 2, 2}};
  mesh.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 4, 5}};
  mesh.regions = {5, 9, 5};
  const mesh::TetModel by_medit = io::parse_tet_model(io::to_text(mesh, medit), medit, "f");
  EXPECT_EQ(by_medit.mesh.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(by_medit.regions, mesh.regions);
  const mesh::TetModel by_gmsh = io::parse_tet_model(io::to_text(mesh, gmsh), gmsh, "f");
  EXPECT_EQ(by_gmsh.mesh.tetrahedra,
            (std::vector<std::array<mesh::Index, 4>>{{0, 1, 2, 3}, {1, 2, 4, 5}, {1, 2, 3, 4}}));
  EXPECT_EQ(by_gmsh.regions, (std::vector<std::uint32_t>{5, 5, 9}));
}

}  // namespace
