// Claim. What is written is read again, orientation included; lists in clockwise order are read as
// such; files that are cut, changed or hold something else are refused with the number of the
// graph. Oracle. The cyclic lists of neighbours of tests/oracles, written by hand here; mirror
// images.
#include "enum/quads/planar_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/quads/generate.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;

std::set<oracle::Cycle> cycles(const Quadrangulation& q) {
  std::set<oracle::Cycle> result;
  for (const auto& quad : q.list_of_quads()) result.insert(support::cycle(quad));
  return result;
}

/// around[v] counter-clockwise; the file wants clockwise.
std::string bytes_of(const oracle::Rotations& around) {
  std::string bytes(1, static_cast<char>(around.size()));
  for (auto neighbours : around) {
    std::reverse(neighbours.begin(), neighbours.end());
    for (const int w : neighbours) bytes.push_back(static_cast<char>(w + 1));
    bytes.push_back('\0');
  }
  return bytes;
}

std::string bytes_of(const Quadrangulation& q) {
  std::string bytes;
  quads::append_planar_code(q, bytes);
  return bytes;
}

std::vector<Quadrangulation> read_all(const std::string& bytes, const std::string& name) {
  std::vector<Quadrangulation> result;
  quads::for_each_in_planar_code(bytes, name,
                                 [&](const Quadrangulation& q) { result.push_back(q); });
  return result;
}

std::string reason(const std::string& bytes) {
  try {
    static_cast<void>(read_all(bytes, "some.pc"));
  } catch (const core::InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(PlanarCode, ListsAreClockwise) {
  auto level = support::four_cycle_class();
  for (int n = 2; n <= 8; ++n) {
    if (n > 2) level = support::grown(level);
    for (const auto& [code, map] : level) {
      const auto read = read_all(bytes_of(map), "a");
      ASSERT_EQ(read.size(), 1U);
      EXPECT_EQ(cycles(read[0]), cycles(support::quadrangulation(map)));
    }
  }
}

TEST(PlanarCode, RoundTrip) {
  support::Random random(3);
  for (const std::string_view header : {std::string_view(), quads::kPlanarCodeHeader}) {
    std::string file(header);
    std::vector<Quadrangulation> written;
    int chiral = 0;
    for (const int n : {6, 10, 14})
      quads::generate(quads::Class::three_connected, n,
                      [&](const Quadrangulation& q, int automorphisms, int rotations) {
                        chiral += automorphisms == rotations ? 1 : 0;
                        for (const bool mirrored : {false, true}) {
                          written.push_back(support::scrambled(q, random, mirrored));
                          quads::append_planar_code(written.back(), file);
                        }
                      });
    EXPECT_GT(chiral, 10);
    const auto read = read_all(file, "a");
    ASSERT_EQ(read.size(), written.size());
    std::string again(header);
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(cycles(read[i]), cycles(written[i]));
      quads::append_planar_code(read[i], again);
    }
    EXPECT_EQ(again, file);
  }
  EXPECT_TRUE(read_all("", "a").empty());
  EXPECT_TRUE(read_all(std::string(quads::kPlanarCodeHeader), "a").empty());
}

TEST(PlanarCode, LargestGraph) {
  std::array<complex::QuadVertices, 64> list{};  // two poles, 64 vertices of degree 2
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i] = {64, static_cast<complex::Vertex>(i), 65,
               static_cast<complex::Vertex>((i + 1) % list.size())};
  const auto q = Quadrangulation::from_quads(list).value();
  EXPECT_EQ(cycles(read_all(bytes_of(q), "a").at(0)), cycles(q));
}

TEST(PlanarCode, EveryTruncationIsRefused) {
  const std::string cube = bytes_of(Quadrangulation::cube());
  const std::string file = std::string(quads::kPlanarCodeHeader) + cube + cube;
  const std::size_t header = quads::kPlanarCodeHeader.size();
  for (std::size_t size = 1; size < file.size(); ++size) {
    const std::string said = reason(file.substr(0, size));
    if (size == header || size == header + cube.size()) {
      EXPECT_EQ(said, "") << size;
    } else {
      const std::string graph = size > header + cube.size() ? "graph 2: " : "graph 1: ";
      EXPECT_TRUE(said.starts_with("some.pc: " + graph)) << size << said;
    }
  }
}

TEST(PlanarCode, ChangedBytesAreRefusedOrAreAnotherQuadrangulation) {
  const auto wheel = [] {
    std::string bytes;
    quads::generate(quads::Class::three_connected, 8, [&](const Quadrangulation& q, int, int) {
      quads::append_planar_code(q, bytes);
    });
    return bytes;
  }();
  const std::string file = bytes_of(Quadrangulation::cube()) + wheel;
  std::size_t refused = 0;
  const auto try_file = [&refused](const std::string& bytes) {
    try {
      for (const auto& q : read_all(bytes, "a")) {
        EXPECT_FALSE(q.validate());
        EXPECT_FALSE(complex::broken_law(q.list_of_quads()));
      }
    } catch (const core::InvalidInput&) {
      ++refused;
    }
  };
  for (std::size_t i = 0; i < file.size(); ++i)
    for (int value = 0; value < 256; ++value) {
      std::string changed = file;
      changed[i] = static_cast<char>(value);
      try_file(changed);
    }
  EXPECT_GE(refused, file.size() * 255 - 1);  // one edge and its two ends cannot change in one byte
  support::Random random(11);
  for (int i = 0; i < 20'000; ++i) {
    std::string changed = file;
    for (std::size_t k = random.below(6) + 1; k > 0; --k)
      changed[random.below(file.size())] = static_cast<char>(random.below(12));
    try_file(changed);
  }
}

TEST(PlanarCode, SaysWhatIsWrong) {
  const auto expect = [](const std::string& said, const std::string& words) {
    EXPECT_NE(said.find("graph 1: "), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  using namespace std::string_literals;
  expect(reason("\0"s), "number of vertices");
  expect(reason("\x43"s), "number of vertices");
  expect(reason("\4\2\4\0"s), "ends inside");
  expect(reason("\4\2\5\0\1\3\0\2\4\0\1\3\0"s), "vertex 1 has the neighbour 5");
  expect(reason("\4\1\4\0\1\3\0\2\4\0\1\3\0"s), "own neighbour");
  expect(reason("\4\2\2\0\1\3\0\2\4\0\1\3\0"s), "vertex 1 has the neighbour 2 twice");
  expect(reason("\4\2\4\2\0\1\3\0\2\4\0\1\3\0"s), "vertex 1 has the neighbour 2 twice");
  expect(reason("\4\0\1\3\0\2\4\0\1\3\0"s), "vertex 1 has no neighbour");
  expect(reason("\4\2\0\1\3\0\2\4\0\1\3\0"s), "not the other way round");
  expect(reason("\4\2\3\4\0\1\4\3\0\1\2\4\0\1\3\2\0"s), "is no quad");  // the tetrahedron
  EXPECT_EQ(reason("\4\2\4\0\1\3\0\2\4\0\1\3\0"s), "");
  // Two spheres; a torus of 16 quads; a star.
  expect(reason("\x08\2\4\0\1\3\0\2\4\0\1\3\0\6\x08\0\5\7\0\6\x08\0\5\7\0"s), "");
  oracle::Rotations torus;
  for (int i = 0; i < 16; ++i) {
    const int row = i / 4 * 4;
    torus.push_back({row + (i + 1) % 4, (i + 4) % 16, row + (i + 3) % 4, (i + 12) % 16});
  }
  expect(reason(bytes_of(torus)), "");
  expect(reason("\4\2\3\4\0\1\0\1\0\1\0"s), "");
}

}  // namespace
