// Claim. The judge finds in files of points the points that are there, and refuses what is damaged;
// where the reader of the mesher reads as well, both read the same bits.
// Oracle. Hand-made files; seeded random damages, given to both readers, which share no code.
#include <gtest/gtest.h>

#include <bit>
#include <optional>
#include <random>

#include "enum/core/errors.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/mesh.hpp"
#include "tests/meshing/io/malformed.hpp"
#include "tests/meshing/io/sample_points.hpp"

namespace hexatlas::check {
namespace {

using namespace hexatlas::io_tests;

std::vector<std::array<std::uint64_t, 3>> bits_of(const std::vector<Point>& points) {
  std::vector<std::array<std::uint64_t, 3>> all;
  for (const Point& p : points) all.push_back(std::bit_cast<std::array<std::uint64_t, 3>>(p));
  return all;
}

const std::vector<Sample> kSamples{{"a.ply", FileFormat::ply, kPlyAscii, {}},
                                   {"b.ply", FileFormat::ply, ply_binary(), {}},
                                   {"a.obj", FileFormat::obj, kObj, {}},
                                   {"a.off", FileFormat::off, kOff, {}}};

TEST(ReadPoints, FindsThem) {
  for (const Sample& sample : kSamples)
    EXPECT_EQ(bits_of(parse_points(sample.name, sample.bytes)), bits(kPoints)) << sample.name;
  // Polygons of any kind, which a surface of quads could not have.
  EXPECT_EQ(parse_points("a.obj", "v 0 0 1\nv 0 1 0\nv 1 0 0\nf 1 2 3\nl 1 2\n").size(), 3U);
  EXPECT_EQ(parse_points("a.off", "OFF\n3 1 0\n0 0 1\n0 1 0\n1 0 0\n3 0 1 2\n").size(), 3U);
  EXPECT_EQ(parse_points("a.xyz", "0 0 1 255 red\n0 1 0\n").size(), 2U);  // colours
  // Standard input and pipes have no ending.
  EXPECT_EQ(bits_of(parse_points("pipe", kPlyAscii)), bits(kPoints));
  EXPECT_EQ(bits_of(parse_points("pipe", kOff)), bits(kPoints));
  EXPECT_TRUE(parse_points("a.ply", edit(kPlyAscii, "element camera",
                                         "element vertex 0\nproperty "
                                         "int x\nproperty int y\nproperty int z\nelement camera"))
                  .empty());
}

TEST(ReadPoints, RefusesDamagedPly) {
  const auto without_format = edit(kPlyAscii, "format ascii 1.0\n", "");
  for (const std::string& bytes :
       {std::string("ply\n"), without_format, edit(kPlyAscii, "1.0", "2.0"),
        edit(kPlyAscii, "ascii", "binary_big_endian"), edit(kPlyAscii, "end_header", "end"),
        edit(kPlyAscii, "end_header", " end_header"),
        edit(kPlyAscii, "property double x", "property real x"),
        edit(kPlyAscii, "property double x\n", ""),
        edit(kPlyAscii, "property uchar red", "property uchar y"),
        edit(kPlyAscii, "vertex 8", "vertex 100000000000"),
        edit(kPlyAscii, "vertex 8", "vertex -8"), edit(kPlyAscii, "vertex 8", "verts 8"),
        edit(kPlyAscii, "0.5 3 7 8 9", "0.5 -3 7 8 9"),
        edit(kPlyAscii, "0 255 0 0 0", "nan 255 0 0 0"),
        edit(kPlyAscii, "element camera", "camera"),
        std::string("ply\nformat ascii 1.0\nelement vertex 9223372036854775807\nend_header\n"),
        std::string("ply\nformat ascii 1.0\nelement vertex 90000000000\nend_header\n"),
        ply_binary().substr(0, ply_binary().size() - 60),
        kPlyAscii.substr(0, kPlyAscii.size() - 40)})
    EXPECT_THROW(static_cast<void>(parse_points("a.ply", bytes)), Malformed) << bytes;
}

TEST(ReadPoints, AgreesWithTheOtherReader) {
  std::mt19937 random(3);
  std::array<int, 2> counts{};
  for (int round = 0; round < 8000; ++round) {
    const Sample& sample = kSamples[static_cast<std::size_t>(round) % kSamples.size()];
    std::string bytes = sample.bytes;
    for (std::size_t k = 1 + random() % 3; k > 0; --k) {
      const std::size_t at = random() % bytes.size();
      if (random() % 2 == 0) bytes[at] = "0123456789-+.e \n\xFF"[random() % 17];
      if (random() % 6 == 0) bytes.erase(at, 1);
      if (random() % 6 == 0) bytes.insert(at, 1, "0123456789-. "[random() % 13]);
    }
    std::optional<std::vector<Point>> mine;
    std::optional<std::vector<mesh::Point>> theirs;
    try {
      mine = parse_points(sample.name, bytes);
    } catch (const Malformed&) {
    }
    try {
      theirs = io::parse_points(bytes, sample.format, "f");
    } catch (const core::InvalidInput&) {
    }
    if (mine && theirs) {
      ASSERT_EQ(bits_of(*mine), bits(*theirs)) << bytes;
    }
    ++counts[mine && theirs ? 1 : 0];
  }
  EXPECT_GT(counts[0], 1000);
  EXPECT_GT(counts[1], 1000);
}

}  // namespace
}  // namespace hexatlas::check
