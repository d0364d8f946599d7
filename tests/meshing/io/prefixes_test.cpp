// Claim. No prefix of a file is taken for another mesh, or for other points; prefixes of lists of
// points without a count have the first of them.
// Oracle. The mesh of the whole file, its points.
#include <gtest/gtest.h>

#include <cctype>

#include "enum/core/errors.hpp"
#include "tests/meshing/io/sample_hybrid.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

/// True if the cut leaves a proper prefix of the last word of the file.
bool is_in_last_word(const std::string& bytes, std::size_t cut) {
  const auto is_space = [&](std::size_t i) {
    return std::isspace(static_cast<unsigned char>(bytes[i])) != 0;
  };
  if (is_space(cut - 1) || is_space(cut)) return false;
  while (cut < bytes.size() && !is_space(cut)) ++cut;
  while (cut < bytes.size() && is_space(cut)) ++cut;
  return cut == bytes.size();
}

bool has_counts(FileFormat format) { return format != obj && format != xyz && format != raw; }

/// Without an end mark, or before it.
template <class Mesh>
bool may_end_in_number(FileFormat format, const Mesh&) {
  return format == off || format == vtk;
}
bool may_end_in_number(FileFormat format, const std::vector<mesh::Point>&) {
  return format == off || format == vtk || format == ply;
}

template <class Parse>
void expect_prefixes_refused(const Sample& sample, const Parse& parse) {
  SCOPED_TRACE(sample.name);
  const auto whole = parse(sample.bytes, sample.format, "f");
  for (std::size_t cut = 0; cut < sample.bytes.size(); ++cut) {
    try {
      const auto mesh = parse(sample.bytes.substr(0, cut), sample.format, "f");
      if (!has_counts(sample.format)) continue;  // a cut cannot be told from an end
      if (may_end_in_number(sample.format, whole) && is_in_last_word(sample.bytes, cut)) continue;
      EXPECT_TRUE(same(mesh, whole)) << "cut at byte " << cut;
    } catch (const core::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, 2), "f:");
    }
  }
}

TEST(Malformed, EveryPrefixIsRefusedOrTheSameMesh) {
  for (const Sample& sample : surface_samples()) expect_prefixes_refused(sample, io::parse_surface);
  for (const Sample& sample : hexahedra_samples())
    expect_prefixes_refused(sample, io::parse_hexahedra);
  for (const Sample& sample : hybrid_samples()) expect_prefixes_refused(sample, io::parse_hybrid);
  const mesh::HexMesh cube = io::parse_hexahedra(kHexVtk, vtk, "f");
  for (const FileFormat format : {vtk, vtu, medit, gmsh})
    expect_prefixes_refused(Sample{"written", format, io::to_text(cube, format), {}},
                            io::parse_hexahedra);
  for (const Sample& sample : tetrahedra_samples())
    expect_prefixes_refused(sample, io::parse_tetrahedra);
  const mesh::TetMesh two = io::parse_tetrahedra(kTetVtk, vtk, "f");
  for (const FileFormat format : {vtk, vtu, medit, gmsh, FileFormat::hxtet})
    expect_prefixes_refused(
        Sample{
            "written", format, io::to_text(mesh::TetView{two.points, two.tetrahedra}, format), {}},
        io::parse_tetrahedra);
}

TEST(Malformed, EveryPrefixIsRefusedOrTheSamePoints) {
  for (const Sample& sample : points_samples()) expect_prefixes_refused(sample, io::parse_points);
}

TEST(Malformed, PrefixesOfListsWithoutCount) {
  for (std::size_t cut = 0; cut <= raw_points().size(); ++cut) {
    if (cut % 24 != 0) {
      EXPECT_THROW(static_cast<void>(io::parse_points(raw_points().substr(0, cut), raw, "f")),
                   core::InvalidInput);
      continue;
    }
    const auto points = io::parse_points(raw_points().substr(0, cut), raw, "f");
    EXPECT_TRUE(same(points, {kPoints.begin(), kPoints.begin() + static_cast<int>(cut / 24)}));
  }
  std::size_t end = 0, lines = 0;
  while ((end = kPointRows.find('\n', end)) != std::string::npos) {
    const auto points = io::parse_points(kPointRows.substr(0, ++end), xyz, "f");
    EXPECT_TRUE(same(points, {kPoints.begin(), kPoints.begin() + static_cast<int>(++lines)}));
  }
  EXPECT_EQ(lines, kPoints.size());
}

}  // namespace
