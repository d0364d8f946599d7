// Claim. Tetrahedra are read and written in five formats, bit for bit and in the order of their
// corners; files have the layout that other programs rely on, and are the same to a path as to
// memory; other cells of dimension 3 and damaged files are refused with InvalidInput.
// Oracle. Hand-made files; seeded random meshes compared with themselves; literal bytes.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <limits>

#include "tests/bytes_of.hpp"
#include "tests/meshing/io/malformed.hpp"
#include "tests/meshing/io/random_meshes.hpp"
#include "tests/meshing/io/sample_points.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

constexpr std::array kTetFormats{vtk, vtu, medit, gmsh, hxtet};

mesh::TetView view(const mesh::TetMesh& mesh) { return {mesh.points, mesh.tetrahedra}; }

const mesh::TetMesh kTwo{kPoints, kTetrahedra};

TEST(Tetrahedra, Read) {
  for (const Sample& sample : tetrahedra_samples())
    EXPECT_TRUE(same(io::parse_tetrahedra(sample.bytes, sample.format, "f"), kTwo)) << sample.name;
}

TEST(Tetrahedra, RoundTrip) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    // Now and then more than one block of output.
    const std::size_t points = 4 + random() % (seed % 20 == 0 ? 60000 : 50);
    const mesh::TetMesh mesh{random_points(random, points),
                             random_cells<4>(random, points, 1 + random() % 60)};
    for (const FileFormat format : kTetFormats) {
      const std::string text = io::to_text(view(mesh), format);
      EXPECT_TRUE(same(io::parse_tetrahedra(text, format, "f"), mesh)) << io::extension_of(format);
      EXPECT_TRUE(same(io::parse_points(text, format, "f"), mesh.points));
      EXPECT_EQ(text, io::to_text(view(mesh), format));
    }
  }
}

TEST(Tetrahedra, Layouts) {
  EXPECT_EQ(io::to_text(view(kTwo), hxtet), hxtet_bytes());
  const std::string in_medit = io::to_text(view(kTwo), medit);
  EXPECT_TRUE(in_medit.ends_with("\n0 1 1 0\nTetrahedra\n2\n1 2 4 5 0\n7 5 2 4 0\nEnd\n"));
  const std::string in_vtk = io::to_text(view(kTwo), vtk);
  EXPECT_NE(in_vtk.find("\nCELLS 2 10\n4 0 1 3 4\n4 6 4 1 3\nCELL_TYPES 2\n10\n10\n"),
            std::string::npos);
  const std::string in_gmsh = io::to_text(view(kTwo), gmsh);
  EXPECT_NE(in_gmsh.find("$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 0\n"), std::string::npos);
  EXPECT_NE(in_gmsh.find("$Elements\n1 2 1 2\n3 1 4 2\n1 1 2 4 5\n2 7 5 2 4\n$EndElements\n"),
            std::string::npos);
}

TEST(Tetrahedra, VtuLayout) {
  const std::string text = io::to_text(view(kTwo), vtu);
  const std::string points = packed(std::uint64_t{8 * 24}) + raw_points();
  std::string corners = packed(std::uint64_t{32});
  for (const auto& tetrahedron : kTetrahedra)
    for (const mesh::Index corner : tetrahedron)
      corners += packed(static_cast<std::int32_t>(corner));
  const std::string offsets = packed(std::uint64_t{8}, std::int32_t{4}, std::int32_t{8});
  const std::string types = packed(std::uint64_t{2}) + "\n\n";  // type 10 is a line feed
  EXPECT_EQ(text.substr(text.find("<AppendedData")), "<AppendedData encoding=\"raw\">\n_" + points +
                                                         corners + offsets + types +
                                                         "\n</AppendedData>\n</VTKFile>\n");
  EXPECT_NE(text.find("header_type=\"UInt64\">"), std::string::npos);
  EXPECT_NE(text.find("Name=\"connectivity\" format=\"appended\" offset=\"200\"/>"),
            std::string::npos);
  EXPECT_NE(text.find("Name=\"offsets\" format=\"appended\" offset=\"240\"/>"), std::string::npos);
  EXPECT_NE(text.find("Name=\"types\" format=\"appended\" offset=\"256\"/>"), std::string::npos);
}

TEST(Tetrahedra, NoneAreWrittenButNotRead) {
  const mesh::TetMesh none{kPoints, {}};
  for (const FileFormat format : kTetFormats) {
    const std::string text = io::to_text(view(none), format);
    EXPECT_EQ(io::parse_points(text, format, "f"), kPoints) << io::extension_of(format);
    expect_all_refused({{format, text, 0, "contains no tetrahedron"}}, io::parse_tetrahedra);
    EXPECT_TRUE(io::parse_points(io::to_text(mesh::TetView{}, format), format, "f").empty());
  }
}

TEST(Malformed, Tetrahedra) {
  expect_all_refused(
      {
          {vtk, kHexVtk, 15, "hexahedron; every cell must be a tetrahedron"},
          {vtu, kHexVtu, 6, "hexahedron; every cell must be a tetrahedron"},
          {medit, kHexMedit, 15, "hexahedron; every cell must be a tetrahedron"},
          {gmsh, kHexGmsh2, 18, "hexahedron; every cell must be a tetrahedron"},
          {vtk, edit(kTetVtk, "4 6 4 1 3", "4 6 4 1 8"), 17, "index 8 is too large"},
          {vtk, edit(kTetVtk, "4 6 4 1 3", "4 6 4 1 6"), 17, "tetrahedron with a repeated vertex"},
          {vtk, edit(kTetVtk, "\n10\n", "\n14\n"), 15, "pyramid with 4 vertices"},
          {vtk, edit(kTetVtk, "10\n5\n", "5\n5\n"), 15, "triangle with 4 vertices"},
          {medit, edit(kTetMedit, "7 5 2 4 1", "9 5 2 4 1"), 16, "index 9 is too large"},
          {medit, edit(kTetMedit, "Tetrahedra 2", "Tetrahedra 1"), 16, "unknown section '7'"},
          {obj, kObj, 0, "the format .obj is not one for tetrahedra"},
          {xyz, kXyz, 0, "the format .xyz is not one for tetrahedra"},
      },
      io::parse_tetrahedra);
  const std::vector<Malformed> as_other{
      {vtk, kTetVtk, 15, "tetrahedron; every cell must be a hexahedron"}};
  expect_all_refused(as_other, io::parse_hexahedra);
  expect_surfaces_refused({{vtk, kTetVtk, 15, "tetrahedron; this is a volume mesh"}});
}

TEST(Malformed, Hxtet) {
  const std::string whole = hxtet_bytes();
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(whole).replace(at, bytes.size(), bytes);
  };
  const std::string nan = packed(std::numeric_limits<double>::quiet_NaN());
  expect_all_refused(
      {
          {hxtet, with(0, "h"), 0, "does not begin as a file .hxtet of version 1"},
          {hxtet, with(7, "\2"), 0, "does not begin as a file .hxtet of version 1"},
          {hxtet, whole.substr(0, 7), 0, "does not begin"},
          {hxtet, whole.substr(0, 23), 0, "ends within its header"},
          {hxtet, with(8, packed(std::uint64_t{10})), 0,
           "count 10 of points is too large: only 224"},
          {hxtet, with(8, packed(~std::uint64_t{0})), 0, "count 18446744073709551615 of points"},
          {hxtet, with(8, packed(std::uint64_t{7})), 0, "count 2 of tetrahedra, but 56 bytes"},
          {hxtet, with(16, packed(std::uint64_t{1})), 0, "count 1 of tetrahedra, but 32 bytes"},
          {hxtet, with(16, packed(~std::uint64_t{0})), 0, "count 18446744073709551615 of tetra"},
          {hxtet, with(16, packed((std::uint64_t{1} << 60U) + 2)), 0, "of tetrahedra, but 32"},
          {hxtet, whole + "x", 0, "count 2 of tetrahedra, but 33 bytes follow the points"},
          {hxtet, whole.substr(0, whole.size() - 1), 0, "count 2 of tetrahedra, but 31 bytes"},
          {hxtet, with(24 + 5 * 24, nan), 0, "point 5, counted from 0, has a coordinate"},
          {hxtet, with(whole.size() - 4, packed(mesh::Index{8})), 0, "index 8 is too large"},
          {hxtet, with(whole.size() - 4, packed(~mesh::Index{0})), 0, "index 4294967295 is too"},
          {hxtet, with(whole.size() - 4, packed(mesh::Index{6})), 0, "a repeated vertex"},
      },
      io::parse_tetrahedra);
}

TEST(Tetrahedra, Preconditions) {
  mesh::TetMesh mesh = kTwo;
  EXPECT_THROW(static_cast<void>(io::to_text(view(mesh), obj)), core::PreconditionViolated);
  EXPECT_THROW(static_cast<void>(io::to_text(view(mesh), ply)), core::PreconditionViolated);
  mesh.tetrahedra[1][3] = 8;
  EXPECT_THROW(static_cast<void>(io::to_text(view(mesh), hxtet)), core::PreconditionViolated);
  mesh = kTwo;
  mesh.points[3].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(io::to_text(view(mesh), vtu)), core::PreconditionViolated);
}

class TetrahedraFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  (std::string("hexatlas_io_tetrahedra_") +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(TetrahedraFiles, AreWhatIsInMemory) {
  std::mt19937_64 random(1);
  const int size = support::share_of(60000, 20000);  // more than a block of each text
  const mesh::TetMesh mesh{random_points(random, size), random_cells<4>(random, size, 9)};
  for (const FileFormat format : kTetFormats) {
    const std::string file = path("a" + std::string(io::extension_of(format)));
    io::expect_tetrahedra_writable(file);
    io::write_tetrahedra(file, view(mesh));
    EXPECT_TRUE(support::bytes_of(file) == io::to_text(view(mesh), format)) << file;
    EXPECT_TRUE(same(io::read_tetrahedra(file), mesh)) << file;
    io::write_tetrahedra(path("odd.name"), view(mesh), format);
    EXPECT_TRUE(support::bytes_of(path("odd.name")) == support::bytes_of(file)) << file;
  }
}

TEST_F(TetrahedraFiles, WhatWasThereStays) {
  const std::string file = path("a.hxtet");
  io::write_tetrahedra(file, view(kTwo));
  mesh::TetMesh bad = kTwo;
  bad.tetrahedra[0][0] = 8;
  EXPECT_THROW(io::write_tetrahedra(file, view(bad)), core::PreconditionViolated);
  EXPECT_EQ(support::bytes_of(file), hxtet_bytes());
  for (const char* name : {"a.obj", "a.ply", "a.xyz", "a.stl", "missing/a.vtu"}) {
    EXPECT_THROW(io::write_tetrahedra(path(name), view(kTwo)), core::InvalidInput) << name;
    EXPECT_THROW(io::expect_tetrahedra_writable(path(name)), core::InvalidInput) << name;
    EXPECT_FALSE(std::filesystem::exists(path(name))) << name;
  }
  EXPECT_THROW(io::write_tetrahedra("-", view(kTwo)), core::InvalidInput);
}

}  // namespace
