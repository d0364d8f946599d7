// Claim. A complete table that is damaged in its records, its counts or its claim, and given a
// correct digest, is refused unless it is a true table still; then the judge says of it how far it
// is complete. Without a new digest no changed byte is accepted. Oracle. The meshes by a second
// replay and by sets (table_replay.hpp); which keys there are, from the table before it was
// damaged; how many there must be, from OEIS A007022 (the judge adds up 8n / |Aut|).
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

#include "tables/check/table_check.hpp"
#include "tests/sabotage/sample_tables.hpp"
#include "tests/sabotage/table_replay.hpp"
#include "tests/share.hpp"
#include "tests/shipped.hpp"

namespace hexatlas::check {
namespace {

using sabotage::SampleTable;
using sabotage::TableEntry;

constexpr int kRounds = support::by_length(700, 4000);
constexpr std::uint32_t kMostQuads = 10;
const std::map<unsigned, std::size_t> kNumber{{6, 1}, {8, 1}, {10, 3}};  // A007022

const SampleTable& whole() {
  static const SampleTable kTable = [] {
    SampleTable table = sabotage::complete_table(support::kShippedTable, kMostQuads);
    table.per_block = 2;  // with one block any greater number would do
    return table;
  }();
  return kTable;
}

class Oracle {
 public:
  bool is_true(const SampleTable& table) {
    for (std::size_t i = 0; i < table.entries.size(); ++i) {
      const TableEntry& entry = table.entries[i];
      if (i > 0 && !sabotage::in_order(table.entries[i - 1], entry)) return false;
      if (!is_true_entry(entry)) return false;
    }
    for (unsigned n = 6; n <= table.complete_through; n += 2) {
      if (n > kMostQuads || count_of(table, n) != kNumber.at(n)) return false;
    }
    return table.complete_through == 0 ||
           (table.complete_through >= 6 && table.complete_through % 2 == 0);
  }

  /// The greatest even N up to which all are there.
  static unsigned complete_through(const SampleTable& table) {
    unsigned n = 4;
    while (n < kMostQuads && count_of(table, n + 2) == kNumber.at(n + 2)) n += 2;
    return n < 6 ? 0 : n;
  }

 private:
  static std::size_t count_of(const SampleTable& table, unsigned quads) {
    std::size_t count = 0;
    for (const TableEntry& entry : table.entries) count += entry.quads == quads ? 1 : 0;
    return count;
  }

  bool is_true_entry(const TableEntry& entry) {
    const auto known = [&](const TableEntry& other) {
      return other.quads == entry.quads && other.key == entry.key;
    };
    const auto& keys = whole().entries;
    if (std::none_of(keys.begin(), keys.end(), known)) return false;
    const auto mesh = std::pair(entry.key, entry.payload);
    const auto [judged, is_new] = is_filling_.try_emplace(mesh, false);
    if (is_new) judged->second = sabotage::is_filling(entry);
    return judged->second && sabotage::has_true_numbers(entry);
  }

  std::map<std::pair<std::string, std::string>, bool> is_filling_;
};

/// Encoding 1 of the mesh of an entry.
std::string as_cells(const TableEntry& entry) {
  std::string reason;
  const auto quads = *decode_word(*word_of_key(entry.key, entry.quads), reason);
  return sabotage::cells_payload({{}, quads, sabotage::second_reading(quads, entry.payload)});
}

/// One damage, or a change that leaves the table true.
void change(SampleTable& table, std::mt19937& random) {
  auto& entries = table.entries;
  if (entries.empty()) return;
  const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  const std::size_t i = below(entries.size()), j = below(entries.size());
  const auto at = entries.begin() + static_cast<std::ptrdiff_t>(i);
  const auto nudge = [&](std::uint32_t& number) { number += random() % 2 == 0 ? 1U : ~0U; };
  switch (below(15)) {
    case 0:
      std::swap(entries[i], entries[j]);
      return;
    case 1:
      std::swap(entries[i].payload, entries[j].payload);
      return;
    case 2:
      entries.erase(at);
      return;
    case 3:
      table.complete_through = std::min(table.complete_through, at->quads - 2);
      if (table.complete_through < 6) table.complete_through = 0;
      entries.erase(at);
      return;
    case 4:
      entries.insert(at, TableEntry(entries[j]));
      return;
    case 5:
      nudge(entries[i].hexahedra);
      return;
    case 6:
      nudge(entries[i].interior);
      return;
    case 7:
      entries[i].lower_bound = static_cast<std::uint32_t>(below(80));
      return;
    case 8:
      table.complete_through = static_cast<std::uint32_t>(2 * below(10));
      return;
    case 9:
    case 10: {
      std::string& payload = entries[i].payload;
      payload[below(payload.size())] = static_cast<char>(below(24));
      return;
    }
    case 11:
      entries[i].key = entries[j].key;
      return;
    case 12:
      table.per_block = 1 + below(8);
      return;
    case 13:
      entries[i].payload = as_cells(whole().entries[j % whole().entries.size()]);
      return;
    default:
      entries[i].payload.resize(below(entries[i].payload.size()) / 2 * 2 + 1);
      entries[i].hexahedra = static_cast<std::uint32_t>(entries[i].payload.size() / 2 + 1);
  }
}

TEST(TableRecordsSabotage, WhatIsAcceptedIsTrue) {
  std::mt19937 random(17);
  Oracle oracle;
  ASSERT_TRUE(oracle.is_true(whole()));
  ASSERT_TRUE(check_table_bytes(whole().bytes()).accepted);
  std::map<std::string, int> rounds;
  for (int round = 0; round < kRounds; ++round) {
    SampleTable table = whole();
    for (auto changes = 1 + random() % 3; changes > 0; --changes) change(table, random);
    const TableVerdict verdict = check_table_bytes(table.bytes());
    if (!oracle.is_true(table)) {
      ASSERT_FALSE(verdict.accepted) << "round " << round;
      ASSERT_FALSE(verdict.reason.empty());
      ++rounds["refused"];
      continue;
    }
    // A true filling that is no ball would be refused, rightly; none occurs.
    ASSERT_TRUE(verdict.accepted) << "round " << round << ": " << verdict.reason;
    ASSERT_EQ(verdict.complete_through, Oracle::complete_through(table)) << "round " << round;
    ASSERT_EQ(verdict.claimed_through, table.complete_through);
    ++rounds[verdict.complete_through == kMostQuads ? "accepted, complete" : "accepted, less"];
  }
  EXPECT_GT(rounds["refused"], kRounds / 2);
  EXPECT_GT(rounds["accepted, complete"], kRounds / 100);
  EXPECT_GT(rounds["accepted, less"], kRounds / 100);
}

TEST(TableRecordsSabotage, NoChangedByteIsAccepted) {
  std::mt19937 random(19);
  const std::string good = whole().bytes();
  for (int round = 0; round < 4 * kRounds; ++round) {
    std::string bad = good;
    for (auto changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % bad.size();
      bad[at] = static_cast<char>(static_cast<unsigned char>(bad[at]) ^ (1U << random() % 8));
    }
    ASSERT_EQ(check_table_bytes(bad).accepted, bad == good) << "round " << round;
  }
}

// The digest is made right, and every law must do its own work: bytes of the header, the index, the
// directory and the blocks, one at a time. What is accepted is another true table, of which only
// the lower bounds (claims without proof) and the claim of completeness can differ.
TEST(TableRecordsSabotage, SealedBytesThatAreAcceptedAreClaimsOnly) {
  std::mt19937 random(23);
  sabotage::Parts parts;
  const std::string good = whole().bytes(parts);
  std::size_t refused = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::string bad = good;
    const std::size_t at = random() % parts.blocks;
    if (at >= 96 && at < 128) continue;
    bad[at] = static_cast<char>(random() % 256);
    sabotage::seal(bad);
    if (bad == good) continue;
    const TableVerdict verdict = check_table_bytes(bad);
    if (!verdict.accepted) {
      ++refused;
      continue;
    }
    std::size_t entry = parts.index;
    bool is_bound = at >= 72 && at < 76;
    for (const TableEntry& e : whole().entries) {
      is_bound = is_bound || at - entry - e.key.size() - 4 < 2;
      entry += e.key.size() + 8;
    }
    ASSERT_TRUE(is_bound) << "byte " << at << " of " << good.size();
  }
  EXPECT_GT(refused, static_cast<std::size_t>(kRounds) / 2);
}

}  // namespace
}  // namespace hexatlas::check
