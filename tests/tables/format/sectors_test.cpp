// Claim. read_sectors() reads what docs/formats/sectors.md describes, finds all scars, and refuses
// everything else, with the line of the fault; sectors_bytes() writes it back; the shipped file has
// sectors of 30, 32 and 50 hexahedra, of which those of 50 are the first without scars.
// Oracle. tests/sabotage/sector_oracle.hpp, a slow reading of the same page; damages put in here
// line by line, and single characters changed at random.
#include "tables/format/sectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/core/random.hpp"
#include "tests/sabotage/sector_oracle.hpp"
#include "tests/shipped.hpp"

namespace {

using namespace hexatlas;
using format::Sector;

std::string shipped_bytes() { return core::read_file(support::kShippedSectors); }

/// What is said of the bytes after the name of the file; empty if they are read.
std::string fault_of(const std::string& bytes) {
  try {
    (void)format::read_sectors(bytes, "some.hxs");
  } catch (const core::InvalidInput& error) {
    const std::string said = error.what();
    EXPECT_TRUE(said.starts_with("some.hxs:")) << said;
    return said.substr(8);
  }
  return "";
}

void expect_fault(const std::string& bytes, std::size_t line, const std::string& part) {
  const std::string said = fault_of(bytes);
  const std::string where = line == 0 ? ": " : ":" + std::to_string(line) + ": ";
  EXPECT_TRUE(said.starts_with(where)) << "expected line " << line << ", said " << said;
  EXPECT_NE(said.find(part), std::string::npos) << "expected " << part << ", said " << said;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// The shipped file with one line, counted from 1, replaced.
std::string with_line(std::size_t number, const std::string& fresh) {
  auto lines = lines_of(shipped_bytes());
  lines.at(number - 1) = fresh;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::vector<complex::HexComplex> meshes_of(const std::vector<Sector>& sectors) {
  std::vector<complex::HexComplex> result;
  for (const Sector& sector : sectors) result.push_back(sector.mesh);
  return result;
}

sabotage::SlowSector slow(const Sector& sector) {
  sabotage::SlowSector result{static_cast<int>(sector.mesh.vertices), {}};
  for (const auto& cell : sector.mesh.hexahedra) {
    sabotage::SlowHex copy{};
    std::copy(cell.begin(), cell.end(), copy.begin());
    result.cells.push_back(copy);
  }
  return result;
}

TEST(ReadSectors, KnowsTheSurface) {
  const auto quads = format::sector_quads();
  std::vector<sabotage::SlowQuad> found;
  for (const auto& quad : quads) {
    sabotage::SlowQuad copy{};
    std::copy(quad.begin(), quad.end(), copy.begin());
    found.push_back(sabotage::turned(copy));
  }
  std::vector<sabotage::SlowQuad> expected;
  for (const auto& quad : sabotage::kSectorQuads) expected.push_back(sabotage::turned(quad));
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(found, expected);
}

TEST(ReadSectors, ReadsTheShippedFile) {
  const auto sectors = format::read_sectors(shipped_bytes(), "shipped");
  std::vector<std::size_t> sizes;
  for (const Sector& sector : sectors) {
    sizes.push_back(sector.mesh.hexahedra.size());
    EXPECT_TRUE(sabotage::is_slow_sector(slow(sector))) << sizes.back();
    EXPECT_EQ(sector.scars.size(), sabotage::slow_scars(slow(sector))) << sizes.back();
    EXPECT_TRUE(std::is_sorted(sector.scars.begin(), sector.scars.end()));
  }
  EXPECT_EQ(sizes, (std::vector<std::size_t>{30, 32, 50}));
  const auto first = std::find_if(sectors.begin(), sectors.end(),
                                  [](const Sector& sector) { return sector.scars.empty(); });
  ASSERT_NE(first, sectors.end());
  EXPECT_EQ(first->mesh.hexahedra.size(), 50U);
}

TEST(ReadSectors, ListsScarsOneByOne) {
  for (const Sector& sector : format::read_sectors(shipped_bytes(), "shipped"))
    for (const auto& [a, b] : sector.scars) {
      const auto both = [a = a, b = b](const auto& vertices) {
        return std::find(vertices.begin(), vertices.end(), a) != vertices.end() &&
               std::find(vertices.begin(), vertices.end(), b) != vertices.end();
      };
      EXPECT_LT(a, b);
      EXPECT_LT(b, 28U);
      const auto& cells = sector.mesh.hexahedra;
      EXPECT_TRUE(std::any_of(cells.begin(), cells.end(), both));
      const auto cell_of_ints = [&](const sabotage::SlowQuad& quad) {
        return both(std::vector<complex::VertexId>(quad.begin(), quad.end()));
      };
      EXPECT_TRUE(
          std::none_of(sabotage::kSectorQuads.begin(), sabotage::kSectorQuads.end(), cell_of_ints));
    }
}

TEST(ReadSectors, RoundTrip) {
  const std::string bytes = shipped_bytes();
  const auto sectors = format::read_sectors(bytes, "shipped");
  EXPECT_EQ(format::sectors_bytes(meshes_of(sectors)), bytes);
  // In any order of the file, fewest hexahedra come first.
  auto meshes = meshes_of(sectors);
  std::reverse(meshes.begin(), meshes.end());
  const std::string reversed = format::sectors_bytes(meshes);
  EXPECT_NE(reversed, bytes);
  EXPECT_EQ(format::sectors_bytes(meshes_of(format::read_sectors(reversed, "reversed"))), bytes);
  // A layer around a sector hides its scars.
  const auto layered = sabotage::layer_around(sabotage::scarred_sector());
  const std::string pillow = sabotage::text_of({layered});
  const auto made = format::read_sectors(pillow, "pillow");
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].mesh.hexahedra.size(), 56U);
  EXPECT_TRUE(made[0].scars.empty());
  EXPECT_EQ(format::sectors_bytes(meshes_of(made)), pillow);
}

TEST(ReadSectors, RefusesWhatIsNoSuchFile) {
  const std::string bytes = shipped_bytes();
  const auto lines = lines_of(bytes);
  const std::size_t end = lines.size();
  expect_fault("", 1, "ends early");
  expect_fault("hexatlas sectors 1", 1, "no end");
  expect_fault("hexatlas sectors 1\n", 0, "without scars");
  for (const char* header : {"hexatlas sectors 2", "hexatlas sectors 1 ", "hexatlas sectors 1\r",
                             " hexatlas sectors 1", "", "hexatlas bound 1"})
    expect_fault(with_line(1, header), 1, "no file of sectors");
  expect_fault(bytes.substr(0, bytes.size() - 1), end, "no end");
  expect_fault(bytes.substr(0, bytes.size() - lines.back().size() - 1), end, "ends early");
  for (const char* more : {"\n", " \n", "end\n", "0 1 2 3 4 5 6 7\n"})
    expect_fault(bytes + more, end + 1, "expected `sector`");
  expect_fault(bytes + "x", end + 1, "no end");
  expect_fault(bytes + std::string(1, '\0'), end + 1, "no end");
}

TEST(ReadSectors, RefusesSizes) {
  expect_fault(with_line(2, "Sector 30 49"), 2, "expected `sector`");
  expect_fault(with_line(2, "sector"), 2, "expected `sector`");
  for (const char* sizes : {"", "x 49", "+30 49", "-30 49", "030 49", " 30 49", "99999999999 49"})
    expect_fault(with_line(2, std::string("sector ") + sizes), 2, "expected a number");
  expect_fault(with_line(2, "sector 30"), 2, "expected a space");
  expect_fault(with_line(2, "sector 30\t49"), 2, "expected a space");
  for (const char* sizes : {"30  49", "30 049", "30 ", "30 -49", "30 4294967296"})
    expect_fault(with_line(2, std::string("sector ") + sizes), 2, "expected a number");
  for (const char* sizes : {"30 49 ", "30 49 1", "30 49\r", "30 49.0"})
    expect_fault(with_line(2, std::string("sector ") + sizes), 2, "expected the end");
  for (const char* sizes : {"0 49", "1001 49", "30 28", "30 241", "4 33"})
    expect_fault(with_line(2, std::string("sector ") + sizes), 2, "so many");
  // One hexahedron too many or too few is seen where the next sector begins, or does not.
  expect_fault(with_line(2, "sector 31 49"), 33, "expected a number");
  EXPECT_NE(fault_of(with_line(2, "sector 29 49")), "");
}

TEST(ReadSectors, RefusesHexahedra) {
  const std::string first = lines_of(shipped_bytes()).at(2);
  for (const char* more : {" ", " 8", "\r", ","})
    expect_fault(with_line(3, first + more), 3, "expected the end");
  expect_fault(with_line(3, first.substr(0, first.rfind(' '))), 3, "expected a space");
  expect_fault(with_line(3, ""), 3, "expected a number");
  expect_fault(with_line(3, " " + first), 3, "expected a number");
  expect_fault(with_line(3, "00" + first), 3, "expected a number");
  expect_fault(with_line(3, first.substr(0, first.rfind(' ')) + " 49"), 3, "out of range");
  // Well-formed, but a law is broken: seen where the sector, of 30 hexahedra, ends.
  const std::string twice = "0 0" + first.substr(first.find(' ', first.find(' ') + 1));
  expect_fault(with_line(3, twice), 32, "the sector: ");
  expect_fault(with_line(3, lines_of(shipped_bytes()).at(3)), 32, "the sector: ");
  expect_fault(with_line(2, "sector 30 50"), 32, "the sector: ");
}

TEST(ReadSectors, RefusesOtherBoundaries) {
  auto meshes = meshes_of(format::read_sectors(shipped_bytes(), "shipped"));
  // The mirror image; two vertices of the surface exchanged; a quad of the base cut off.
  auto mirrored = meshes;
  for (auto& cell : mirrored[2].hexahedra)
    for (std::size_t i = 0; i < 8; i += 2) std::swap(cell[i], cell[i + 1]);
  expect_fault(format::sectors_bytes(mirrored), 116, "the boundary");
  auto exchanged = meshes;
  for (auto& cell : exchanged[0].hexahedra)
    for (auto& v : cell) v = v == 1 ? 5 : v == 5 ? 1 : v;
  expect_fault(format::sectors_bytes(exchanged), 32, "the boundary");
  auto inner = meshes;
  for (auto& cell : inner[1].hexahedra)
    for (auto& v : cell) v = v == 3 ? 40 : v == 40 ? 3 : v;
  expect_fault(format::sectors_bytes(inner), 65, "the boundary");
}

TEST(ReadSectors, WantsASectorWithoutScars) {
  auto meshes = meshes_of(format::read_sectors(shipped_bytes(), "shipped"));
  meshes.pop_back();
  expect_fault(format::sectors_bytes(meshes), 0, "without scars");
}

// Sabotage. Whatever single character is changed: what is read must be what the oracle accepts.
TEST(ReadSectors, SeesEachChangedCharacter) {
  const std::string bytes = shipped_bytes();
  const std::string signs = "0123456789 \nsx-";
  core::Random random(11);
  std::size_t refused = 0;
  constexpr std::size_t kRounds = 1500;
  for (std::size_t round = 0; round < kRounds; ++round) {
    std::string damaged = bytes;
    damaged[random.below(bytes.size())] = signs[random.below(signs.size())];
    if (damaged == bytes) continue;
    const auto read = sabotage::slow_read(damaged);
    const bool is_right = read && sabotage::slow_least(*read) != 0;
    EXPECT_EQ(fault_of(damaged).empty(), is_right) << damaged;
    if (!is_right) ++refused;
  }
  EXPECT_GT(refused, kRounds / 2);
}

}  // namespace
