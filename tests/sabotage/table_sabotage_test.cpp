// Claim. No damaged table is accepted: neither one whose bytes are damaged, nor one that is damaged
// in a field and given a correct digest afterwards.
// Oracle. Every byte of a file is covered by the digest, so any change without a new digest is a
// true damage. With a new digest, only damages are made that break a law for a reason given beside
// them. Random steps of flips may by chance be another valid filling; there slow_oracle.hpp, on the
// hexahedra of a second replay, table_replay.hpp, says which are true damages.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tables/check/table_check.hpp"
#include "tests/sabotage/sample_tables.hpp"
#include "tests/sabotage/table_replay.hpp"

namespace hexatlas::check {
namespace {

using sabotage::frame_of_zeros;
using sabotage::is_filling;
using sabotage::nested_table;
using sabotage::Parts;
using sabotage::sample_table;
using sabotage::SampleTable;
using sabotage::seal;

/// Damaged tables so far; each must be refused.
class Refusals {
 public:
  void expect(const std::string& bytes, const std::string& what) {
    ++count_;
    const TableVerdict verdict = check_table_bytes(bytes);
    EXPECT_FALSE(verdict.accepted) << what;
    EXPECT_FALSE(verdict.reason.empty()) << what;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

std::vector<std::string> valid_tables() {
  return {sample_table(true, 3).bytes(), sample_table(false, 1).bytes(), nested_table(true).bytes(),
          nested_table(false).bytes()};
}

TEST(TableSabotage, NoChangeOfBytesIsAccepted) {
  std::mt19937 random(3);
  Refusals refusals;
  for (const std::string& good : valid_tables()) {
    ASSERT_TRUE(check_table_bytes(good).accepted);
    for (int round = 0; round < 300; ++round) {
      std::string bad = good;
      const std::size_t at = random() % bad.size();
      const auto flipped = static_cast<unsigned char>(bad[at]) ^ 1U << random() % 8;
      bad[at] = static_cast<char>(flipped);
      refusals.expect(bad, "bit flipped at " + std::to_string(at));
    }
    for (std::size_t size = 0; size < good.size(); size += 7) {
      refusals.expect(good.substr(0, size), "cut to " + std::to_string(size));
    }
    for (std::size_t more = 1; more < 20; ++more) {
      refusals.expect(good + std::string(more, '\0'), "bytes appended");
      refusals.expect(good + good.substr(0, more), "bytes appended");
    }
    for (int round = 0; round < 100; ++round) {
      std::string bad = good;
      const std::size_t length = 1 + random() % 16;
      const std::size_t a = random() % (bad.size() - 2 * length);
      const std::size_t b = a + length + random() % (bad.size() - 2 * length - a + 1);
      std::swap_ranges(bad.begin() + static_cast<std::ptrdiff_t>(a),
                       bad.begin() + static_cast<std::ptrdiff_t>(a + length),
                       bad.begin() + static_cast<std::ptrdiff_t>(b));
      if (bad != good) refusals.expect(bad, "ranges swapped");
    }
  }
  EXPECT_GE(refusals.count(), 2000U);
}

// All bytes of the header, the sections and the directory follow from the rest of the file, so any
// change of one is a true damage. In the index this holds for the keys (no two entries are equal
// and each mesh has one boundary), for H, for the number of interior vertices, and for the zero.
TEST(TableSabotage, NoSealedChangeOfAStructuralByteIsAccepted) {
  Refusals refusals;
  for (const SampleTable& table : {sample_table(true, 2), nested_table(false)}) {
    Parts parts;
    const std::string good = table.bytes(parts);
    std::vector<std::size_t> places;
    for (std::size_t at = 0; at < 96; ++at) {
      // Bytes 44 to 47: the entries per block follow from the rest only if there are two blocks.
      const bool one_block = table.per_block >= table.entries.size();
      if (!one_block || at < 44 || at >= 48) places.push_back(at);
    }
    for (std::size_t at = 128; at < parts.index; ++at) places.push_back(at);
    std::size_t entry_at = parts.index;
    for (const auto& entry : table.entries) {
      for (std::size_t i = 0; i < entry.key.size() + 8; ++i) {
        const std::size_t field = i < entry.key.size() ? 0 : 1 + (i - entry.key.size()) / 2;
        if (field != 3) places.push_back(entry_at + i);  // 3: the lower bound
      }
      entry_at += entry.key.size() + 8;
    }
    for (std::size_t at = parts.directory; at < parts.blocks; ++at) places.push_back(at);
    for (const std::size_t at : places) {
      for (const unsigned mask : {0x01U, 0x80U, 0x2CU}) {
        std::string bad = good;
        bad[at] = static_cast<char>(static_cast<unsigned char>(bad[at]) ^ mask);
        seal(bad);
        refusals.expect(bad, "byte " + std::to_string(at) + " xor " + std::to_string(mask));
      }
    }
  }
  EXPECT_GE(refusals.count(), 1500U);
}

TEST(TableSabotage, NoLowerBoundAboveTheMeshIsAccepted) {
  Refusals refusals;
  const SampleTable good = sample_table(true, 2);
  for (std::size_t i = 0; i < good.entries.size(); ++i) {
    for (const std::uint32_t bound : {0U, good.entries[i].hexahedra + 1, 0xFFFFU}) {
      SampleTable bad = good;
      bad.entries[i].lower_bound = bound;
      refusals.expect(bad.bytes(), "lower bound " + std::to_string(bound));
    }
  }
  EXPECT_EQ(refusals.count(), 27U);
}

// If one label of one hexahedron is changed, its three quads at that corner are lost. One that was
// in the boundary is missing from it; one that was between two hexahedra is in one, so in the
// boundary, but not in the key. So every such change is a true damage; equal labels are so too.
TEST(TableSabotage, NoChangedLabelOfACellIsAccepted) {
  Refusals refusals;
  std::mt19937 random(5);
  const SampleTable good = sample_table(false, 4);
  for (std::size_t i = 0; i < good.entries.size(); ++i) {
    if (good.entries[i].payload[0] != 1) continue;
    const std::size_t vertices = good.entries[i].quads + 2 + good.entries[i].interior;
    for (int round = 0; round < 60; ++round) {
      SampleTable bad = good;
      std::string& payload = bad.entries[i].payload;
      const std::size_t at = 1 + 2 * (random() % (payload.size() / 2));
      const std::string before = payload;
      sabotage::put_at(payload, at, random() % (vertices + 2), 2);
      if (payload != before) refusals.expect(bad.bytes(), "label of a cell");
    }
  }
  EXPECT_GE(refusals.count(), 150U);
}

TEST(TableSabotage, NoPayloadOfAnotherShapeIsAccepted) {
  Refusals refusals;
  const SampleTable good = sample_table(true, 4);
  for (std::size_t i = 0; i < good.entries.size(); ++i) {
    const auto damaged = [&](const char* what, const std::function<void(std::string&)>& change) {
      SampleTable bad = good;
      change(bad.entries[i].payload);
      if (bad.entries[i].payload != good.entries[i].payload) refusals.expect(bad.bytes(), what);
    };
    damaged("encoding", [](std::string& p) { p[0] = static_cast<char>(1 - p[0]); });
    damaged("encoding", [](std::string& p) { p[0] = 2; });
    damaged("last byte dropped", [](std::string& p) { p.pop_back(); });
    damaged("last step dropped",
            [](std::string& p) { p.erase(p.size() - std::min<std::size_t>(2, p.size())); });
    damaged("byte added", [](std::string& p) { p += '\0'; });
    damaged("step added", [](std::string& p) { p += std::string("\0\x0f", 2); });
    damaged("empty", [](std::string& p) { p.clear(); });
    damaged("payload of another entry",
            [&](std::string& p) { p = good.entries[(i + 1) % good.entries.size()].payload; });
    if (good.entries[i].payload[0] != 0) continue;
    for (std::size_t step = 1; step < good.entries[i].payload.size(); step += 2) {
      damaged("place outside", [step](std::string& p) { p[step] = static_cast<char>(200); });
      damaged("side outside",
              [step](std::string& p) { p[step + 1] = static_cast<char>(p[step + 1] | 16); });
    }
  }
  EXPECT_GE(refusals.count(), 100U);
}

TEST(TableSabotage, NoRandomStepsAreAcceptedUnlessTheyAreAFilling) {
  std::mt19937 random(11);
  Refusals refusals;
  std::size_t fillings = 0;
  std::vector<SampleTable> tables = {nested_table(true)};
  for (const auto& example : sabotage::sample_meshes()) {
    SampleTable table;
    table.entries = {sabotage::entry_of(example, true)};
    if (table.entries[0].hexahedra > 1 && table.entries[0].hexahedra < 20) tables.push_back(table);
  }
  for (const SampleTable& good : tables) {
    ASSERT_TRUE(check_table_bytes(good.bytes()).accepted);
    ASSERT_TRUE(is_filling(good.entries[0]));
    for (int round = 0; round < 120; ++round) {
      SampleTable bad = good;
      std::string& payload = bad.entries[0].payload;
      const std::size_t at = 1 + random() % (payload.size() - 1);
      payload[at] = static_cast<char>(random() % (at % 2 == 1 ? good.entries[0].quads : 16U));
      if (payload == good.entries[0].payload) continue;
      if (is_filling(bad.entries[0])) {
        ++fillings;
      } else {
        refusals.expect(bad.bytes(), "random step");
      }
    }
  }
  EXPECT_GE(refusals.count(), 600U);
  RecordProperty("true_damages", static_cast<int>(refusals.count()));
  RecordProperty("other_fillings", static_cast<int>(fillings));
}

std::string from_hexadecimal(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(text.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

// The block of nested_table(false) as compressed by libzstd 1.5.4 at level 19.
constexpr const char* kCompressedBlock =
    "28B52FFD20750D020072460D0EC09D03FFFFFF431445511445640A6DBA9EE53888AA673A9260A8BA"
    "694B1A976D57B31467D1F52447B37455160D45F0764D0FF80B0200DB42157E97DA03";

TEST(TableSabotage, NoDamagedBlockIsAccepted) {
  Refusals refusals;
  Parts parts;
  const SampleTable table = nested_table(false);
  const std::string good = table.bytes(parts);
  const std::string frame = good.substr(parts.blocks, parts.names - parts.blocks);
  // Another number of frames, or anything that is no frame, breaks "one frame".
  const auto with_block = [&](const std::string& block) {
    std::string bad = good;
    bad.replace(parts.blocks, frame.size(), block);
    sabotage::put_at(bad, parts.directory + 8, block.size(), 4);
    sabotage::put_at(bad, 16, bad.size(), 8);
    sabotage::put_at(bad, 64, parts.blocks + block.size(), 8);
    seal(bad);
    return bad;
  };
  ASSERT_TRUE(check_table_bytes(with_block(frame)).accepted);
  ASSERT_TRUE(check_table_bytes(with_block(from_hexadecimal(kCompressedBlock))).accepted);
  const std::string skippable("\x50\x2A\x4D\x18\x02\x00\x00\x00xx", 10);
  refusals.expect(with_block(frame + frame), "two frames");
  refusals.expect(with_block(frame + skippable), "a skippable frame after the block");
  refusals.expect(with_block(skippable + frame), "a skippable frame before the block");
  refusals.expect(with_block(skippable), "a skippable frame");
  refusals.expect(with_block(""), "an empty block");
  for (std::size_t size = 0; size < frame.size(); ++size) {
    refusals.expect(with_block(frame.substr(0, size)), "a frame that is cut");
  }
  // A frame that unpacks to much more than the directory says.
  refusals.expect(with_block(frame_of_zeros()), "a frame that is too long");
  // What unpacks to a gigabyte is not unpacked.
  std::string large = good;
  sabotage::put_at(large, parts.directory + 12, std::uint64_t{1} << 30, 4);
  seal(large);
  EXPECT_NE(check_table_bytes(large).reason.find("more than 64 MiB"), std::string::npos);
}

}  // namespace
}  // namespace hexatlas::check
