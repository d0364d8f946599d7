// Claim. The judge accepts files of sectors that obey the laws, with the least number of hexahedra
// of a sector without scars, and refuses each damage of a field or a law, with the reason, and the
// line if the file is malformed.
// Oracle. One sector is a file, found by a search: 30 hexahedra. Around it goes a layer of one
// hexahedron for each of the 26 quads: then what a hexahedron has of the surface is one quad or
// nothing. The damages are put in here.
#include "tables/check/sectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tables/check/malformed.hpp"
#include "tests/sabotage/sector_oracle.hpp"
#include "tests/tables/check/replaced.hpp"

namespace hexatlas::check {
namespace {

using namespace sabotage;
using examples::replaced;

using Sectors = std::vector<SlowSector>;

SlowSector pillow() { return layer_around(scarred_sector()); }

SectorsVerdict verdict_of(const Sectors& sectors) {
  return check_sectors_bytes(text_of(sectors), "some.hxs");
}

/// The reason for which it is rejected; empty if it is not.
std::string fault_of(const Sectors& sectors) {
  const SectorsVerdict verdict = verdict_of(sectors);
  EXPECT_FALSE(verdict.undecided);
  EXPECT_EQ(verdict.accepted, verdict.fault.empty());
  EXPECT_EQ(verdict.accepted, verdict.least_without_scars != 0);
  return verdict.fault;
}

void expect_fault(const Sectors& sectors, const std::string& part) {
  EXPECT_NE(fault_of(sectors).find(part), std::string::npos) << part << ": " << fault_of(sectors);
}

void expect_malformed(const std::string& text, std::size_t line, const std::string& part = "") {
  try {
    (void)check_sectors_bytes(text, "some.hxs");
    ADD_FAILURE() << "read: " << text;
  } catch (const Malformed& error) {
    const std::string said = error.what();
    EXPECT_TRUE(said.starts_with("some.hxs:" + std::to_string(line) + ": ")) << line << "\n"
                                                                             << said;
    EXPECT_NE(said.find(part), std::string::npos) << part << ": " << said;
  }
}

SlowHex mirrored(const SlowHex& h) { return {h[1], h[0], h[3], h[2], h[5], h[4], h[7], h[6]}; }

TEST(Sectors, Accepted) {
  const SectorsVerdict one = verdict_of({pillow()});
  EXPECT_TRUE(one.accepted) << one.fault;
  EXPECT_EQ(one.sectors, 1U);
  EXPECT_EQ(one.least, 56U);
  EXPECT_EQ(one.most, 56U);
  EXPECT_EQ(one.scars, 0U);
  EXPECT_EQ(one.least_without_scars, 56U);
  const SectorsVerdict three = verdict_of({layer_around(pillow()), scarred_sector(), pillow()});
  EXPECT_TRUE(three.accepted) << three.fault;
  EXPECT_EQ(three.sectors, 3U);
  EXPECT_EQ(three.least, 30U);
  EXPECT_EQ(three.most, 82U);
  EXPECT_EQ(three.scars, 35U);
  EXPECT_EQ(three.least_without_scars, 56U);
}

TEST(Sectors, SurfaceIsASphere) {
  std::set<std::pair<int, int>> edges;
  std::set<int> vertices;
  for (const SlowQuad& quad : kSectorQuads) {
    for (std::size_t i = 0; i < 4; ++i) {
      vertices.insert(quad[i]);
      EXPECT_TRUE(edges.emplace(quad[i], quad[(i + 1) % 4]).second);
    }
  }
  EXPECT_EQ(vertices.size(), 28U);
  for (const auto& [u, v] : edges) EXPECT_TRUE(edges.contains({v, u}));
  EXPECT_EQ(28 - static_cast<int>(edges.size()) / 2 + 26, 2);
}

TEST(Sectors, ToldByTheFirstWords) {
  EXPECT_TRUE(is_sectors(text_of({pillow()})));
  EXPECT_TRUE(is_sectors("hexatlas sectors 2\n"));
  for (const char* other :
       {"", "hexatlas", "hexatlas sectors", "hexatlas-bound 1\n", "sector 1 29"}) {
    EXPECT_FALSE(is_sectors(other)) << other;
  }
}

TEST(Sectors, NoneWithoutScars) {
  EXPECT_EQ(fault_of({scarred_sector()}), "no sector is without scars");
  EXPECT_EQ(fault_of({scarred_sector(), scarred_sector()}), "no sector is without scars");
  EXPECT_EQ(fault_of({scarred_sector(), pillow()}), "");
}

TEST(Sectors, EachScarCounts) {
  // Whatever else is wrong: one hexahedron has two vertices of the surface instead of inner ones.
  for (int u = 0; u < 28; ++u) {
    for (int v = 0; v < u; ++v) {
      SlowSector sector = pillow();
      SlowHex& cell = sector.cells.back();  // has none of the surface
      cell[0] = u;
      cell[5] = v;
      const bool in_a_quad =
          std::any_of(kSectorQuads.begin(), kSectorQuads.end(), [&](const SlowQuad& quad) {
            return std::count(quad.begin(), quad.end(), u) +
                       std::count(quad.begin(), quad.end(), v) ==
                   2;
          });
      EXPECT_EQ(verdict_of({sector}).scars, in_a_quad ? 0U : 1U) << u << " " << v;
    }
  }
}

TEST(Sectors, AnyBadSectorIsNamed) {
  SlowSector bad = pillow();
  bad.cells.pop_back();
  expect_fault({pillow(), bad}, "the sector of line 59: ");
  expect_fault({bad, scarred_sector()}, "the sector of line 2: ");
  expect_fault({scarred_sector(), pillow(), bad}, "the sector of line 90: ");
}

TEST(Sectors, EachHexahedronMatters) {
  const SlowSector good = pillow();
  for (std::size_t i = 0; i < good.cells.size(); ++i) {
    SlowSector missing = good;
    missing.cells.erase(missing.cells.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(fault_of({missing}), "") << i;
    SlowSector twice = good;
    twice.cells.push_back(twice.cells[i]);
    EXPECT_NE(fault_of({twice}), "") << i;
    SlowSector mirror = good;
    mirror.cells[i] = mirrored(mirror.cells[i]);
    EXPECT_NE(fault_of({mirror}), "") << i;
  }
}

TEST(Sectors, EachCornerMatters) {
  const SlowSector good = pillow();
  for (std::size_t i = 0; i < good.cells.size(); ++i) {
    for (std::size_t c = 0; c < 8; ++c) {
      SlowSector changed = good;
      int& vertex = changed.cells[i][c];
      vertex = (vertex + 1) % good.vertices;
      EXPECT_NE(fault_of({changed}), "") << i << " " << c;
      for (std::size_t d = 0; d < c; ++d) {
        SlowSector exchanged = good;
        std::swap(exchanged.cells[i][c], exchanged.cells[i][d]);
        EXPECT_NE(fault_of({exchanged}), "") << i << " " << c << " " << d;
      }
    }
  }
}

TEST(Sectors, WholeMirrorImage) {
  SlowSector mirror = pillow();
  for (SlowHex& cell : mirror.cells) cell = mirrored(cell);
  expect_fault({mirror}, "of the quads of the surface");
}

TEST(Sectors, SurfaceNumberedOtherwise) {
  for (int u = 0; u < 28; ++u) {
    for (int v = 0; v < u; ++v) {
      SlowSector other = pillow();
      for (SlowHex& cell : other.cells) {
        for (int& w : cell) w = w == u ? v : w == v ? u : w;
      }
      expect_fault({other}, "of the quads of the surface");
    }
  }
}

TEST(Sectors, SurfaceOfAnotherBall) {
  // Without the hexahedron on its first quad it is still a ball.
  SlowSector other = pillow();
  other.cells.erase(other.cells.begin());
  expect_fault({other}, "of the quads of the surface");
}

TEST(Sectors, Numbering) {
  SlowSector gap = pillow();
  ++gap.vertices;
  expect_fault({gap}, "point 77 is in no hexahedron");
  gap = pillow();
  for (SlowHex& cell : gap.cells) std::replace(cell.begin(), cell.end(), 50, 77);
  ++gap.vertices;
  expect_fault({gap}, "point 50 is in no hexahedron");
  SlowSector twice = pillow();
  twice.cells[3][5] = twice.cells[3][2];
  expect_fault({twice}, "hexahedron 3 has vertex");
}

TEST(Sectors, StrictRule) {
  // The first two vertices above the base quads, which two hexahedra have, become one; the last
  // vertex takes the free number.
  SlowSector pinched = pillow();
  for (SlowHex& cell : pinched.cells) {
    std::replace(cell.begin(), cell.end(), 29, 33);
    std::replace(cell.begin(), cell.end(), 76, 29);
  }
  --pinched.vertices;
  expect_fault({pinched}, "share");
}

TEST(Sectors, TwoComponents) {
  SlowSector two = pillow();
  for (SlowHex cell : pillow().cells) {
    for (int& v : cell) v += 77;
    two.cells.push_back(cell);
  }
  two.vertices *= 2;
  expect_fault({two}, "2 components");
}

TEST(Sectors, MalformedFirstLine) {
  const std::string text = text_of({pillow()});
  expect_malformed("", 1);
  for (const char* first :
       {"hexatlas sectors 2", "hexatlas sectors 01", "hexatlas sectors", "hexatlas sectors 1 ",
        "hexatlas sectors 1 1", " hexatlas sectors 1", "hexatlas  sectors 1", "hexatlas sector 1",
        "Hexatlas sectors 1", "hexatlas-sectors 1", "hexatlas sectors 1\r",
        "\xef\xbb\xbfhexatlas sectors 1", "", "hexatlas\tsectors 1"}) {
    expect_malformed(replaced(text, "hexatlas sectors 1", first), 1);
  }
  expect_malformed("hexatlas sectors 1\n", 2, "there is no sector");
  expect_malformed("hexatlas sectors 1", 1, "no end");
}

TEST(Sectors, MalformedHeadOfASector) {
  const std::string text = text_of({pillow()});
  for (const char* head : {"sector 056 77",  "sector +56 77",
                           "sector -56 77",  "sector 56 077",
                           "sector 56 +77",  "sector 56",
                           "sector",         "",
                           "sector 56 77 ",  "sector 56 77 0",
                           "sector  56 77",  "sector 56 77\r",
                           "sectors 56 77",  "56 77",
                           "sector 56 28",   "sector 56 0",
                           "sector 0 77",    "sector 1001 77",
                           "sector 56 449",  "sector 56 18446744073709551693",
                           "sector 56.0 77", "sector 4294967352 77",
                           "sector 56 0x4d"}) {
    expect_malformed(replaced(text, "sector 56 77", head), 2);
  }
  // One hexahedron less or more than there are lines.
  expect_malformed(replaced(text, "sector 56 77", "sector 55 77"), 58, "expected 'sector'");
  expect_malformed(replaced(text, "sector 56 77", "sector 57 77"), 59, "ends too early");
  // The largest numbers that may be.
  EXPECT_EQ(check_sectors_bytes(replaced(text, "sector 56 77", "sector 56 448"), "x").fault,
            "the sector of line 2: point 77 is in no hexahedron");
  SlowSector large{29, std::vector<SlowHex>(1000)};
  EXPECT_NE(fault_of({large}), "");
  large.cells.emplace_back();
  expect_malformed(text_of({large}), 2);
}

TEST(Sectors, MalformedHexahedron) {
  const std::string text = text_of({pillow()});
  const std::string first = "28 29 31 30 0 1 3 2";
  for (const char* line : {"28 29 31 30 0 1 3", "28 29 31 30 0 1 3 2 4", "28 29 31 30 0 1 3 2 ",
                           " 28 29 31 30 0 1 3 2", "28 29 31 30 0 1 3 2\r", "28 29 31 30  0 1 3 2",
                           "28\t29 31 30 0 1 3 2", "28 29 31 30 00 1 3 2", "28 29 31 30 0 01 3 2",
                           "28 29 31 30 0 +1 3 2", "28 29 31 30 -0 1 3 2", "28 29 31 30 0 1 3 -2",
                           "28 29 31 30 0 1 3 77", "28 29 31 30 0 1 3 4294967298",
                           "28 29 31 30 0 1 3 18446744073709551618", "28 29 31 30 0 1 3 2.0",
                           "28 29 31 30 0 1 3 x", "", "sector 56 77"}) {
    expect_malformed(replaced(text, first, line), 3);
  }
  expect_malformed(replaced(text, first, first + "\n"), 4);
}

TEST(Sectors, MalformedEnd) {
  const std::string text = text_of({scarred_sector(), pillow()});
  for (const char* end : {"\n", " ", "x", "\n\n", "sector", "sectors 56 77\n", "\t\n"}) {
    expect_malformed(text + end, 90);
  }
  expect_malformed(text + '\0', 90);
  expect_malformed(text + "sector 56 77\n", 91, "ends too early");
  expect_malformed(text.substr(0, text.size() - 1), 89, "no end");
  // Cut after each line. After the first sector it is a file, whose sector has scars.
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size() - 1; ++at) {
    if (text[at] != '\n') continue;
    ++line;
    const std::string cut = text.substr(0, at + 1);
    if (line == 33) {
      EXPECT_FALSE(check_sectors_bytes(cut, "some.hxs").accepted);
    } else {
      expect_malformed(cut, line);
    }
    expect_malformed(cut.substr(0, at), line - 1, "no end");
  }
}

}  // namespace
}  // namespace hexatlas::check
