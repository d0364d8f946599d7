// Claim. No prefix of a file is taken for another mesh.
// Oracle. The mesh of the whole file.
#include <gtest/gtest.h>

#include <cctype>

#include "enum/core/errors.hpp"
#include "tests/meshing/io/samples.hpp"

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

template <class Parse>
void expect_prefixes_refused(const Sample& sample, const Parse& parse) {
  SCOPED_TRACE(sample.name);
  const auto whole = parse(sample.bytes, sample.format, "f");
  const bool has_end_mark = sample.format != off && sample.format != vtk;
  for (std::size_t cut = 0; cut < sample.bytes.size(); ++cut) {
    try {
      const auto mesh = parse(sample.bytes.substr(0, cut), sample.format, "f");
      if (sample.format == obj) continue;  // has no counts: a cut cannot be told from an end
      if (!has_end_mark && is_in_last_word(sample.bytes, cut)) continue;
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
  const mesh::HexMesh cube = io::parse_hexahedra(kHexVtk, vtk, "f");
  for (const FileFormat format : {vtk, vtu, medit, gmsh})
    expect_prefixes_refused(Sample{"written", format, io::to_text(cube, format), {}},
                            io::parse_hexahedra);
}

}  // namespace
