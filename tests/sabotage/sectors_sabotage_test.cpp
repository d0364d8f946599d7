// Claim. Of any change of a file of sectors the judge says what a slow second reading of
// docs/formats/sectors.md says: malformed, rejected, or accepted with this number.
// Oracle. sector_oracle.hpp, which shares nothing with the judge but the document. Not every change
// is a damage: interior vertices may be renamed, hexahedra turned and listed in another order.
#include <gtest/gtest.h>

#include <cctype>

#include "tables/check/malformed.hpp"
#include "tables/check/sectors.hpp"
#include "tests/sabotage/sector_oracle.hpp"

namespace hexatlas::check {
namespace {

using namespace sabotage;

using Sectors = std::vector<SlowSector>;

const std::vector<Sectors>& samples() {
  static const std::vector<Sectors> all = [] {
    const SlowSector scarred = scarred_sector();
    const SlowSector one = layer_around(scarred);
    const SlowSector two = layer_around(one);
    return std::vector<Sectors>{{one}, {scarred, one}, {two, scarred, one}, {scarred}};
  }();
  return all;
}

/// How often the readings, which agree, said what.
struct Tally {
  int malformed = 0;
  int rejected = 0;
  int accepted = 0;

  void judge(const std::string& text) {
    const std::optional<Sectors> sectors = slow_read(text);
    try {
      const SectorsVerdict verdict = check_sectors_bytes(text, "sectors");
      ASSERT_TRUE(sectors.has_value()) << text;
      const std::size_t least = slow_least(*sectors);
      ASSERT_FALSE(verdict.undecided) << text;
      ASSERT_EQ(verdict.accepted, least != 0) << verdict.fault << "\n" << text;
      ASSERT_EQ(verdict.accepted, verdict.fault.empty());
      ASSERT_EQ(verdict.least_without_scars, least) << text;
      ASSERT_EQ(verdict.sectors, sectors->size());
      std::size_t scars = 0;
      for (const SlowSector& sector : *sectors) scars += slow_scars(sector);
      ASSERT_EQ(verdict.scars, scars) << text;
      ++(verdict.accepted ? accepted : rejected);
    } catch (const Malformed&) {
      ASSERT_FALSE(sectors.has_value()) << text;
      ++malformed;
    }
  }
};

std::size_t below(std::mt19937_64& random, std::size_t end) { return random() % end; }

const Sectors& any_sample(std::mt19937_64& random) {
  return samples()[below(random, samples().size())];
}

TEST(SectorsSabotage, SamplesAreJudgedAsByTheSlowReading) {
  Tally tally;
  for (const Sectors& sample : samples()) tally.judge(text_of(sample));
  EXPECT_EQ(tally.accepted, 3);
  EXPECT_EQ(tally.rejected, 1);
}

std::string changed_number(const std::string& old, std::mt19937_64& random) {
  const long value = std::stol(old);
  std::string changed = old;
  while (changed == old) {
    switch (below(random, 6)) {
      case 0:
        changed = std::to_string(value + 1);
        break;
      case 1:
        changed = std::to_string(value - 1);
        break;
      case 2:
        changed = old + std::to_string(below(random, 10));
        break;
      default:
        changed = std::to_string(below(random, 80));
    }
  }
  return changed;
}

TEST(SectorsSabotage, OneNumberChanged) {
  std::mt19937_64 random(1);
  Tally tally;
  for (int round = 0; round < 1000; ++round) {
    std::string text = text_of(any_sample(random));
    std::vector<std::pair<std::size_t, std::size_t>> numbers;  // place, length
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) continue;
      const std::size_t start = i;
      while (std::isdigit(static_cast<unsigned char>(text[i])) != 0) ++i;
      numbers.emplace_back(start, i - start);
    }
    // One in eight in the headers, which have few of them.
    const auto [at, length] = numbers[below(random, random() % 8 == 0 ? 3 : numbers.size())];
    text.replace(at, length, changed_number(text.substr(at, length), random));
    ASSERT_NO_FATAL_FAILURE(tally.judge(text));
  }
  EXPECT_GT(tally.malformed, 100);
  EXPECT_GT(tally.rejected, 500);
}

TEST(SectorsSabotage, BytesChanged) {
  std::mt19937_64 random(2);
  Tally tally;
  for (int round = 0; round < 1000; ++round) {
    std::string text = text_of(any_sample(random));
    const std::size_t at = random() % 4 == 0 ? below(random, 40) : below(random, text.size());
    const std::string all = "0123456789 \n\r\t+-.x\xff";
    const char byte = all[below(random, all.size())];
    switch (below(random, 5)) {
      case 0:
        text[at] = byte;
        break;
      case 1:
        text.insert(at, 1, byte);
        break;
      case 2:
        text.erase(at, 1);
        break;
      case 3:
        text.resize(at);
        break;
      default:
        std::swap(text[at], text[below(random, text.size())]);
    }
    ASSERT_NO_FATAL_FAILURE(tally.judge(text));
  }
  EXPECT_GT(tally.malformed, 300);
  EXPECT_GT(tally.rejected, 100);
}

void rename(SlowSector& sector, int from, int to) {
  for (SlowHex& cell : sector.cells) std::replace(cell.begin(), cell.end(), from, to);
}

void exchange(SlowSector& sector, int u, int v) {
  rename(sector, u, -1);
  rename(sector, v, u);
  rename(sector, -1, v);
}

/// Vertex v becomes u; the last one takes its place.
void identify(SlowSector& sector, int u, int v) {
  rename(sector, v, u);
  if (v != sector.vertices - 1) rename(sector, sector.vertices - 1, v);
  --sector.vertices;
}

/// An even number of coordinates reversed or exchanged leaves the hexahedron as it is.
SlowHex with_axes(const SlowHex& cell, unsigned reversed, bool exchanged) {
  SlowHex result{};
  for (unsigned c = 0; c < 8; ++c) {
    const unsigned turned = exchanged ? (c & 4U) | (c & 1U) << 1U | (c >> 1U & 1U) : c;
    result[turned ^ reversed] = cell[c];
  }
  return result;
}

void change(Sectors& sectors, std::mt19937_64& random) {
  SlowSector& sector = sectors[below(random, sectors.size())];
  SlowHex& cell = sector.cells[below(random, sector.cells.size())];
  const auto vertices = static_cast<std::size_t>(sector.vertices);
  const auto interior = [&] { return static_cast<int>(28 + below(random, vertices - 28)); };
  switch (below(random, 9)) {
    case 0:
    case 1:
      exchange(sector, interior(), interior());
      break;
    case 2:
      std::shuffle(sector.cells.begin(), sector.cells.end(), random);
      break;
    case 3:
    case 4:
      cell = with_axes(cell, static_cast<unsigned>(random() % 8), random() % 2 == 0);
      break;
    case 5: {
      const int v = interior();
      const int u = random() % 2 == 0 ? interior() : static_cast<int>(below(random, 28));
      if (u < v) identify(sector, u, v);
      break;
    }
    case 6:
      if (random() % 4 == 0) {
        exchange(sector, static_cast<int>(below(random, vertices)), interior());
      }
      break;
    case 7:
      sectors.push_back(any_sample(random)[0]);
      break;
    default:
      if (random() % 4 == 0) {
        std::swap(cell, sector.cells.back());
        sector.cells.pop_back();
      } else {
        std::swap(sectors.front(), sectors.back());
        if (sectors.size() > 1) sectors.pop_back();
      }
  }
}

TEST(SectorsSabotage, MeshesChanged) {
  std::mt19937_64 random(3);
  Tally tally;
  for (int round = 0; round < 300; ++round) {
    Sectors sectors = any_sample(random);
    for (std::size_t left = 1 + below(random, 3); left > 0; --left) change(sectors, random);
    ASSERT_NO_FATAL_FAILURE(tally.judge(text_of(sectors)));
  }
  EXPECT_GT(tally.accepted, 50);
  EXPECT_GT(tally.rejected, 100);
}

}  // namespace
}  // namespace hexatlas::check
