// Claim. The extension of a path, or the first bytes, decide the format; files are written whole
// and read back; errors name the file.
// Oracle. Literal paths, samples, and bytes read with the standard library.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "enum/core/errors.hpp"
#include "tests/bytes_of.hpp"
#include "tests/meshing/io/samples.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

TEST(Format, OfPath) {
  EXPECT_EQ(io::format_of_path("a.obj"), obj);
  EXPECT_EQ(io::format_of_path("dir.d/a.b.OFF"), off);
  EXPECT_EQ(io::format_of_path("/x/a.Vtk"), vtk);
  EXPECT_EQ(io::format_of_path("a.vtu"), vtu);
  EXPECT_EQ(io::format_of_path("a.mesh"), medit);
  EXPECT_EQ(io::format_of_path("a.MSH"), gmsh);
  for (const char* path : {"a", "a.stl", "obj", "a.mesh/b", "a.", "", "a.objx"}) {
    try {
      static_cast<void>(io::format_of_path(path));
      ADD_FAILURE() << path;
    } catch (const core::InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(".obj .off .vtk .vtu .mesh .msh"),
                std::string::npos);
    }
  }
}

TEST(Format, Detected) {
  for (const Sample& sample : surface_samples())
    EXPECT_EQ(io::detect_format(sample.bytes, "f"), sample.format) << sample.name;
  EXPECT_EQ(io::detect_format("\xEF\xBB\xBF\n# c\n\nMeshVersionFormatted 2", "f"), medit);
  for (const char* bytes : {"", "\n", "# only\n", "solid cube", "plywood", "1,2 3"})
    EXPECT_THROW(static_cast<void>(io::detect_format(bytes, "f")), core::InvalidInput) << bytes;
}

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("hexatlas_io_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

TEST_F(Files, WrittenAndRead) {
  const mesh::HexMesh cube = io::parse_hexahedra(kHexMedit, medit, "f");
  for (const char* name : {"a.vtk", "a.vtu", "a.mesh", "a.MSH"}) {
    io::write_hexahedra(path(name), cube);
    EXPECT_TRUE(same(io::read_hexahedra(path(name)), cube)) << name;
  }
  io::write_hexahedra(path("odd.name"), cube, medit);
  EXPECT_EQ(support::bytes_of(path("odd.name")), support::bytes_of(path("a.mesh")));
  EXPECT_TRUE(same(io::read_hexahedra(path("odd.name"), medit), cube));
  io::write_hexahedra(path("two.msh"), cube, {}, {io::GmshVersion::v2_2, {}});
  EXPECT_TRUE(support::bytes_of(path("two.msh")).starts_with("$MeshFormat\n2.2 0 8\n"));
}

TEST_F(Files, SurfaceRead) {
  std::ofstream(path("box.off")) << kOff;
  EXPECT_EQ(io::read_surface(path("box.off")).quads, kQuads);
  EXPECT_THROW(static_cast<void>(io::read_surface(path("none.off"))), core::InvalidInput);
  EXPECT_THROW(static_cast<void>(io::read_surface(path("."), off)), core::InvalidInput);
  EXPECT_THROW(static_cast<void>(io::read_surface(path("box.off"), obj)), core::InvalidInput);
}

TEST_F(Files, WritingIsRefused) {
  const mesh::HexMesh cube = io::parse_hexahedra(kHexMedit, medit, "f");
  for (const char* name : {"a.obj", "a.off", "a.xyz", "missing/a.vtk"}) {
    EXPECT_THROW(io::write_hexahedra(path(name), cube), core::InvalidInput) << name;
    EXPECT_FALSE(std::filesystem::exists(path(name))) << name;
  }
  EXPECT_THROW(io::write_hexahedra("-", cube), core::InvalidInput);
}

}  // namespace
