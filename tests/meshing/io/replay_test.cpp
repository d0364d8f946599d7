// Claim. The seeds of the fuzz targets and all their findings so far obey the law of
// tests/fuzz/round_trip.hpp: refused, or the same after writing and reading.
// Oracle. The law itself. Files named surface_*, hexahedra_*, tetrahedra_* and points_* are known
// to be valid.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "tests/bytes_of.hpp"
#include "tests/fuzz/round_trip.hpp"

namespace {

using namespace hexatlas;

constexpr std::array<std::pair<const char*, io::FileFormat>, 10> kFormats{
    {{"obj", io::FileFormat::obj},
     {"off", io::FileFormat::off},
     {"vtk", io::FileFormat::vtk},
     {"vtu", io::FileFormat::vtu},
     {"medit", io::FileFormat::medit},
     {"gmsh", io::FileFormat::gmsh},
     {"xyz", io::FileFormat::xyz},
     {"raw", io::FileFormat::raw},
     {"ply", io::FileFormat::ply},
     {"hxtet", io::FileFormat::hxtet}}};

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Replay, SeedsOfEachFormat) {
  const std::filesystem::path corpus = HEXATLAS_SOURCE_DIR "/tests/fuzz/corpus";
  for (const auto& [name, format] : kFormats) {
    const auto files = files_below(corpus / name);
    EXPECT_FALSE(files.empty()) << name;
    for (const auto& path : files) {
      const fuzz::Outcome outcome = fuzz::check_bytes(support::bytes_of(path), format);
      const std::string file = path.filename();
      EXPECT_TRUE(outcome.is_surface || !file.starts_with("surface_")) << path;
      EXPECT_TRUE(outcome.is_tetrahedral || !file.starts_with("tetrahedra_")) << path;
      EXPECT_TRUE(outcome.has_points || !file.starts_with("points_")) << path;
      EXPECT_TRUE(outcome.is_hexahedral || !file.starts_with("hexahedra_")) << path;
    }
  }
}

/// Each finding is given to every reader: a defect of one may be near in another.
TEST(Replay, Findings) {
  for (const auto& path : files_below(HEXATLAS_SOURCE_DIR "/tests/regressions/io"))
    for (const auto& [name, format] : kFormats) {
      SCOPED_TRACE(path.string() + " as " + name);
      EXPECT_NO_THROW(static_cast<void>(fuzz::check_bytes(support::bytes_of(path), format)));
    }
}

}  // namespace
