// Claim. check_table accepts well-formed tables and refuses each breach of a law of
// docs/formats/table.md, naming it and the entry.
// Oracle. Tables of lattice piles written by tests/sabotage/table_writer.hpp from the
// specification, with codes pinned below; numbers of quads and hexahedra by counting squares and
// cubes.
#include "tables/check/table_check.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <numeric>

#include "tables/check/malformed.hpp"
#include "tests/sabotage/sample_tables.hpp"
#include "tests/shipped.hpp"

namespace hexatlas::check {
namespace {

using sabotage::nested_table;
using sabotage::sample_table;
using sabotage::SampleTable;

void expect_refused(const std::string& bytes, const std::string& words) {
  const TableVerdict verdict = check_table_bytes(bytes);
  EXPECT_FALSE(verdict.accepted) << "expected: " << words;
  EXPECT_NE(verdict.reason.find(words), std::string::npos) << verdict.reason;
}

TEST(TableCheck, AcceptsSampleTables) {
  for (const bool flips : {true, false}) {
    for (const std::size_t per_block : {1U, 2U, 3U, 9U, 100U}) {
      const TableVerdict verdict = check_table_bytes(sample_table(flips, per_block).bytes());
      ASSERT_TRUE(verdict.accepted) << verdict.reason;
      EXPECT_EQ(verdict.entries, 9U);
      EXPECT_EQ(verdict.names, 3U);
    }
    const TableVerdict nested = check_table_bytes(nested_table(flips).bytes());
    EXPECT_TRUE(nested.accepted) << nested.reason;
  }
  const TableVerdict empty = check_table_bytes(SampleTable{}.bytes());
  EXPECT_TRUE(empty.accepted) << empty.reason;
}

// Each block of meshes is in one share of several; keys are in all of them.
TEST(TableCheck, SharesJudgeEachMeshOnce) {
  for (const bool flips : {true, false}) {
    for (const std::size_t per_block : {1U, 2U, 4U}) {
      const SampleTable good = sample_table(flips, per_block);
      for (const std::uint64_t parts : {1U, 2U, 3U, 12U}) {
        std::uint64_t judged = 0;
        for (std::uint64_t part = 0; part < parts; ++part) {
          const TableVerdict verdict = check_table_bytes(good.bytes(), {part, parts});
          ASSERT_TRUE(verdict.accepted) << verdict.reason;
          judged += verdict.judged_meshes;
        }
        EXPECT_EQ(judged, good.entries.size());
        for (std::size_t i = 0; i < good.entries.size(); ++i) {
          SampleTable bad_mesh = good, bad_key = good;
          bad_mesh.entries[i].payload[0] = '\x7f';
          bad_key.entries[i].key[0] = '\x7f';
          for (std::uint64_t part = 0; part < parts; ++part) {
            const bool has_it = i / per_block % parts == part;
            EXPECT_NE(check_table_bytes(bad_mesh.bytes(), {part, parts}).accepted, has_it);
            EXPECT_FALSE(check_table_bytes(bad_key.bytes(), {part, parts}).accepted);
          }
        }
      }
    }
  }
}

TEST(TableCheck, CountsHexahedraByQuads) {
  const TableVerdict verdict = check_table_bytes(sample_table(true, 4).bytes());
  ASSERT_EQ(verdict.by_quads.size(), 8U);
  std::vector<std::vector<std::uint64_t>> rows;
  for (const TableRow& row : verdict.by_quads) {
    rows.push_back(
        {row.quads, row.entries, row.least_hexahedra, row.greatest_hexahedra, row.total_hexahedra});
  }
  // By surface area: the cube; two cubes; three around an edge; the other two of three cubes;
  // 2x2x1; 3x2x1; 2x2x2; 3x3x3.
  const std::vector<std::vector<std::uint64_t>> expected = {
      {6, 1, 1, 1, 1},  {10, 1, 2, 2, 2}, {12, 1, 3, 3, 3}, {14, 2, 3, 3, 6},
      {16, 1, 4, 4, 4}, {22, 1, 6, 6, 6}, {24, 1, 8, 8, 8}, {54, 1, 27, 27, 27}};
  EXPECT_EQ(rows, expected);
}

// The code of the cube is worked out by hand in quad_code_test.cpp. The code of two stacked cubes
// was computed by reference_code.py, which shares nothing with this.
TEST(TableCheck, KeysAreThePinnedCodes) {
  const SampleTable table = sample_table(true, 1);
  EXPECT_EQ(table.entries[0].key, "\x08\xa5\xdf");
  EXPECT_EQ(table.entries[1].key, "\x02\x29\x72\x97\x7f");
  EXPECT_EQ(table.entries[0].payload, std::string(1, '\0'));
}

TEST(TableCheck, ReadsFilesAndSaysWhenItCannot) {
  const std::string path = ::testing::TempDir() + "table_check_test.hxt";
  std::ofstream(path, std::ios::binary) << sample_table(true, 2).bytes();
  EXPECT_TRUE(check_table(path).accepted);
  std::filesystem::remove(path);
  EXPECT_THROW(static_cast<void>(check_table(path)), Malformed);
  expect_refused("", "shorter than its header");
}

TEST(TableCheck, RefusesWrongEntries) {
  const auto with = [](auto change) {
    SampleTable table = sample_table(true, 3);
    change(table.entries);
    return table.bytes();
  };
  using Entries = std::vector<sabotage::TableEntry>;
  expect_refused(with([](Entries& e) { e[1].hexahedra = 3; }), "entry 1: the payload has a wrong");
  expect_refused(with([](Entries& e) { e[7].interior = 0; }), "entry 7: ");
  expect_refused(with([](Entries& e) { e[2].lower_bound = 4; }),
                 "entry 2: the number of hexahedra");
  expect_refused(with([](Entries& e) { e[2].lower_bound = 0; }), "entry 2: the lower bound is 0");
  expect_refused(with([](Entries& e) { std::swap(e[3], e[4]); }), "entry 4: the keys are not");
  expect_refused(with([](Entries& e) { e[4] = e[3]; }), "entry 4: the keys are not");
  expect_refused(with([](Entries& e) { e[0].payload = "\x02"; }), "entry 0: unknown encoding");
  expect_refused(with([](Entries& e) { e[0].payload = ""; }), "entry 0: the payload is empty");
  expect_refused(with([](Entries& e) { e[1].payload += '\0'; }),
                 "entry 1: the payload has a wrong");
  expect_refused(with([](Entries& e) { std::swap(e[3].payload, e[4].payload); }), "entry 3: ");
}

/// 8n / |Aut| for the class of an entry, all flags tried.
std::uint64_t rooted(const sabotage::TableEntry& entry) {
  std::string reason;
  const auto quads = *decode_word(*word_of_key(entry.key, entry.quads), reason);
  return 8 * entry.quads / canonical_code(quads)->automorphisms;
}

TEST(TableCheck, SaysOfEachNumberOfQuadsWhetherAllAreThere) {
  const SampleTable table = sample_table(true, 4);
  const TableVerdict verdict = check_table_bytes(table.bytes());
  ASSERT_TRUE(verdict.accepted);
  EXPECT_EQ(verdict.claimed_through, 0U);
  EXPECT_EQ(verdict.complete_through, 6U);  // the cube is all; none of the one with 8 quads
  std::map<std::uint32_t, std::uint64_t> sums;
  for (const auto& entry : table.entries) sums[entry.quads] += rooted(entry);
  for (const TableRow& row : verdict.by_quads) {
    EXPECT_EQ(row.rooted_sum, sums.at(row.quads)) << row.quads;
    EXPECT_EQ(row.is_complete(), row.quads == 6) << row.quads;
    EXPECT_EQ(row.rooted_all > 0, row.quads <= 32) << row.quads;
  }
  EXPECT_EQ(verdict.by_quads[1].rooted_all, 29U);
}

TEST(TableCheck, RefusesAClaimThatIsNotTrue) {
  SampleTable table = sample_table(true, 4);
  table.complete_through = 6;
  const TableVerdict verdict = check_table_bytes(table.bytes());
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.claimed_through, 6U);
  table.complete_through = 8;
  expect_refused(table.bytes(), "with 8 quads the rooted sum is 0 of 4");
  table.complete_through = 34;
  expect_refused(table.bytes(), "complete through 34 quads, as the table claims, is more");
  for (const std::uint32_t wrong : {1U, 2U, 4U, 7U, 65U, 66U, 0xFFFFFFFEU}) {
    table.complete_through = wrong;
    expect_refused(table.bytes(), "the claim of completeness names an impossible");
  }
  table = {};
  EXPECT_EQ(check_table_bytes(table.bytes()).complete_through, 0U);
  table.complete_through = 6;
  expect_refused(table.bytes(), "with 6 quads the rooted sum is 0 of 1");
}

TEST(TableCheck, NoEntryOfACompleteTableCanBeLeftOut) {
  const SampleTable all = sabotage::complete_table(support::kShippedTable, 12);
  const TableVerdict verdict = check_table_bytes(all.bytes());
  ASSERT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.complete_through, 12U);
  EXPECT_EQ(all.entries.size(), 16U);
  for (std::size_t i = 0; i < all.entries.size(); ++i) {
    SampleTable less = all;
    const unsigned quads = all.entries[i].quads;
    less.entries.erase(less.entries.begin() + static_cast<std::ptrdiff_t>(i));
    less.names.clear();
    expect_refused(less.bytes(), "with " + std::to_string(quads) + " quads");
    less.complete_through = 0;
    const TableVerdict left = check_table_bytes(less.bytes());
    EXPECT_TRUE(left.accepted) << left.reason;
    EXPECT_EQ(left.complete_through, quads == 6 ? 0 : quads - 2);
  }
}

TEST(TableCheck, RefusesMirroredCells) {
  SampleTable table = sample_table(false, 1);
  std::string& payload = table.entries[0].payload;
  ASSERT_EQ(payload.size(), 17U);
  std::rotate(payload.begin() + 1, payload.begin() + 9, payload.end());  // top and bottom
  expect_refused(table.bytes(), "entry 0: the boundary of the mesh is not that of the key");
}

// The cube in a cube, filled by its six outer hexahedra only, has two boundary components.
TEST(TableCheck, RefusesAHollowFilling) {
  SampleTable table = nested_table(false);
  table.entries[0].payload.resize(1 + 16 * 6);
  table.entries[0].hexahedra = 6;
  expect_refused(table.bytes(), "entry 0: the boundary has 2 components");
}

// A quadrangulation with a vertex of degree 2 is not 3-connected: a box with one quad cut in two.
TEST(TableCheck, RefusesAKeyThatIsNotThreeConnected) {
  std::vector<Quad> quads = examples::cubes(examples::box(1, 1, 1)).surface.quads;
  const Quad split = quads.back();
  quads.back() = {split[0], split[1], split[2], 8};
  quads.push_back({split[0], 8, split[2], split[3]});
  SampleTable table = sample_table(true, 1);
  table.entries[0].quads = 7;
  table.entries[0].key = key_of_word(canonical_code(quads)->word);
  expect_refused(table.bytes(), "entry 0: the quadrangulation is not 3-connected");
}

TEST(TableCheck, RefusesANonCanonicalKey) {
  SampleTable table = sample_table(true, 1);
  // The word of another flag of two stacked cubes: the one that stands first in degree order is
  // replaced by that of a list of quads begun elsewhere, decoded and coded again.
  const std::string canonical = table.entries[1].key;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < canonical.size(); ++i) {
    for (unsigned value = 0; value < 256; ++value) {
      table.entries[1].key = canonical;
      table.entries[1].key[i] = static_cast<char>(value);
      if (table.entries[1].key == canonical) continue;
      const TableVerdict verdict = check_table_bytes(table.bytes());
      ASSERT_FALSE(verdict.accepted);
      if (verdict.reason.find("not the canonical code") != std::string::npos) ++tried;
    }
  }
  EXPECT_GT(tried, 0U);
}

TEST(TableCheck, RefusesNamesThatBreakTheirLaws) {
  const auto named = [](std::vector<sabotage::Name> names) {
    SampleTable table = sample_table(true, 3);
    table.names = std::move(names);
    return table.bytes();
  };
  EXPECT_TRUE(check_table_bytes(named({{3, "a-0"}, {3, "b"}})).accepted);
  expect_refused(named({{3, "b"}, {3, "a"}}), "name 1 is out of order");
  expect_refused(named({{3, "a"}, {4, "a"}}), "name 1 is out of order");
  expect_refused(named({{9, "a"}}), "name 0 is that of no entry");
  expect_refused(named({{0, "A"}}), "name 0 has a character");
  expect_refused(named({{0, ""}}), "name 0 is empty");
}

}  // namespace
}  // namespace hexatlas::check
