// Claim. A table gives back its rows and names, its bytes depend on nothing but them, the judge
// accepts it, and no altered or truncated byte gets past the reader. Oracle. The rows; every single
// bit and every length; the judge, which shares no code.
#include "tables/format/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "enum/canon/nauty/hex_symmetry.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "tables/check/table_check.hpp"
#include "tables/format/manifest.hpp"
#include "tables/format/sha256.hpp"
#include "tests/enum/support.hpp"
#include "tests/tables/format/fixtures.hpp"

namespace {

using namespace hexatlas;
using format::Table;

std::string refusal(const std::string& bytes) {
  try {
    (void)Table::from_bytes(bytes, "small.hxt");
  } catch (const core::InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

/// The digest of docs/formats/table.md, put into the bytes.
std::string sealed(std::string bytes) {
  std::fill(bytes.begin() + 96, bytes.begin() + 128, '\0');
  const std::array<std::string_view, 1> whole{bytes};
  const auto digest = format::sha256(whole);
  std::copy(digest.begin(), digest.end(), bytes.begin() + 96);
  return bytes;
}

std::string small_table() {
  auto rows = fixtures::rows(14, 4);
  return format::table_bytes(rows, fixtures::names());
}

TEST(Table, GivesBackItsRows) {
  auto rows = fixtures::rows(20, 9);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].lower_bound =
        static_cast<std::uint16_t>(i % 2 == 0 ? 1 : rows[i].mesh.hexahedra.size());
  ASSERT_GT(rows.size(), 64U) << "several blocks";
  const Table table = Table::from_bytes(format::table_bytes(rows, fixtures::names()), "t");
  ASSERT_EQ(table.size(), rows.size());
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.code < b.code; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto entry = table.entry(i);
    EXPECT_EQ(entry.code, rows[i].code);
    EXPECT_EQ(entry.hexahedra, rows[i].mesh.hexahedra.size());
    EXPECT_EQ(entry.interior_vertices, rows[i].mesh.vertices - rows[i].code.quads - 2);
    EXPECT_EQ(entry.lower_bound, rows[i].lower_bound);
    EXPECT_EQ(table.find(rows[i].code), i);
    const auto mesh = table.mesh(i);
    EXPECT_EQ(support::fault_of_filling(mesh, entry.code), "");
    EXPECT_EQ(canon::graph_form(mesh).certificate, canon::graph_form(rows[i].mesh).certificate);
  }
  for (const auto& [name, code] : {std::pair("cube", "q1:08a5df"), {"two-cubes", "q1:022972977f"}})
    EXPECT_EQ(table.entry(table.find_name(name).value()).code, canon::from_text(code));
  EXPECT_FALSE(table.find_name("three-cubes").has_value());
  EXPECT_THROW((void)table.entry(table.size()), core::PreconditionViolated);
}

TEST(Table, DoesNotFindWhatIsAbsent) {
  auto rows = fixtures::rows(16, 10);
  const auto all = rows;
  std::vector<format::TableRow> some;
  for (std::size_t i = 0; i < rows.size(); i += 2) some.push_back(rows[i]);
  const Table table = Table::from_bytes(format::table_bytes(some, {}), "t");
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(table.find(all[i].code).has_value(), i % 2 == 0);
  EXPECT_FALSE(table.find(canon::from_text("q1:000000").value()).has_value());
  EXPECT_FALSE(table.find(canon::from_text("q1:ffffff").value()).has_value());
  EXPECT_FALSE(table.find(canon::from_text("q1:" + std::string(64, 'a')).value()).has_value());
  const Table empty = Table::from_bytes(format::table_bytes({}, {}), "t");
  EXPECT_EQ(empty.size(), 0U);
  EXPECT_FALSE(empty.find(all[0].code).has_value());
}

TEST(Table, BytesDoNotDependOnTheOrderOfRows) {
  support::Random random(79);
  auto rows = fixtures::rows(16, 10);
  auto names = fixtures::names();
  const std::string bytes = format::table_bytes(rows, names);
  for (int i = 0; i < 5; ++i) {
    random.shuffle(rows);
    random.shuffle(names);
    EXPECT_EQ(format::table_bytes(rows, names), bytes);
  }
  rows.push_back(rows[0]);
  EXPECT_THROW((void)format::table_bytes(rows, names), core::PreconditionViolated);
}

TEST(Table, TheJudgeAccepts) {
  const auto rows = fixtures::rows(18, 12);
  const std::string bytes = format::table_bytes(rows, fixtures::names());
  const auto verdict = check::check_table_bytes(bytes);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.entries, rows.size());
  EXPECT_EQ(verdict.names, 2U);
  const auto tallies = format::tally_of(Table::from_bytes(bytes, "t"));
  ASSERT_EQ(tallies.size(), verdict.by_quads.size());
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    EXPECT_EQ(static_cast<unsigned>(tallies[i].quads), verdict.by_quads[i].quads);
    EXPECT_EQ(tallies[i].entries, verdict.by_quads[i].entries);
    EXPECT_EQ(tallies[i].least, verdict.by_quads[i].least_hexahedra);
    EXPECT_EQ(tallies[i].greatest, verdict.by_quads[i].greatest_hexahedra);
    EXPECT_EQ(tallies[i].total, verdict.by_quads[i].total_hexahedra);
  }
}

TEST(Table, GivesBackItsClaim) {
  const auto rows = fixtures::rows(14, 4);
  for (const int quads : {0, 6, 20, 64}) {
    const Table table = Table::from_bytes(format::table_bytes(rows, {}, quads), "t");
    EXPECT_EQ(table.complete_through(), quads);
    EXPECT_NE(format::manifest_text(table, {}).find(
                  "\"complete_through\": " + std::to_string(quads) + ","),
              std::string::npos);
  }
  EXPECT_EQ(format::table_bytes(rows, {}), format::table_bytes(rows, {}, 0));
  for (const int quads : {-2, 2, 4, 7, 65, 66})
    EXPECT_THROW((void)format::table_bytes(rows, {}, quads), core::PreconditionViolated) << quads;
  for (const std::size_t at : {72U, 74U, 76U, 95U}) {
    std::string bytes = format::table_bytes(rows, {}, 0);
    bytes[at] = 5;
    EXPECT_EQ(refusal(sealed(bytes)),
              at < 76 ? "small.hxt: is damaged: its claim of completeness is impossible"
                      : "small.hxt: is damaged: its header has bytes that are not 0 where it must");
  }
}

TEST(Table, NoDamagedBitPasses) {
  const std::string good = small_table();
  ASSERT_EQ(refusal(good), "accepted");
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
    const std::string message = refusal(bad);
    ASSERT_TRUE(message.starts_with("small.hxt: is ")) << "bit " << bit << ": " << message;
  }
  for (std::size_t size = 0; size < good.size(); ++size)
    ASSERT_TRUE(refusal(good.substr(0, size)).starts_with("small.hxt: is ")) << size;
  EXPECT_NE(refusal(good + '\0').find("is truncated or damaged"), std::string::npos);
}

TEST(Table, MessagesSayWhatIsWrong) {
  const std::string good = small_table();
  EXPECT_EQ(refusal(""), "small.hxt: is not a table of hexatlas");
  EXPECT_EQ(refusal(std::string(500, 'x')), "small.hxt: is not a table of hexatlas");
  std::string version = good;
  version[8] = 1;
  EXPECT_EQ(refusal(sealed(version)),
            "small.hxt: is a table of version 1; this program reads version 2");
  std::string order = good;
  std::reverse(order.begin() + 12, order.begin() + 16);
  EXPECT_NE(refusal(sealed(order)).find("byte order"), std::string::npos);
  EXPECT_NE(refusal(good.substr(0, good.size() - 1))
                .find(std::to_string(good.size() - 1) + " bytes of " + std::to_string(good.size())),
            std::string::npos);
  std::string content = good;
  content.back() = static_cast<char>(content.back() ^ 1);
  EXPECT_NE(refusal(content).find("SHA-256"), std::string::npos);
  EXPECT_EQ(refusal(sealed(good)), "accepted") << "the digest of the format";
}

TEST(Table, SealedDamageNeverCrashes) {
  // With a fresh digest the reader must cope with any value; what it does not see, mesh() refuses.
  const std::string good = small_table();
  support::Random random(83);
  int accepted = 0;
  for (int i = 0; i < 5'000; ++i) {
    std::string bad = good;
    const std::size_t at = random.coin() ? 8 + random.below(120) : random.below(bad.size());
    bad[at] = static_cast<char>(random.coin() ? random.below(256) : bad[at] ^ 1 << random.below(8));
    if (random.below(3) == 0) bad[random.below(bad.size())] = static_cast<char>(random.below(256));
    try {
      const Table table = Table::from_bytes(sealed(bad), "bad");
      for (std::size_t k = 0; k < table.size(); ++k) {
        (void)table.find(table.entry(k).code);
        (void)table.mesh(k);
      }
      (void)format::manifest_text(table, {});
      ++accepted;
    } catch (const core::InvalidInput&) {
    }
  }
  EXPECT_GT(accepted, 0);
}

TEST(Table, NamesAreChecked) {
  const auto rows = fixtures::rows(14, 2);
  const auto cube = canon::from_text("q1:08a5df").value();
  for (const std::string name : {"", "Cube", "a b", "a/b", "\xff"})
    EXPECT_THROW((void)format::table_bytes(rows, {{name, cube}}), core::PreconditionViolated);
  EXPECT_THROW((void)format::table_bytes(rows, {{std::string(256, 'a'), cube}}),
               core::PreconditionViolated);
  EXPECT_THROW((void)format::table_bytes(rows, {{"a", canon::from_text("q1:000000").value()}}),
               core::PreconditionViolated);
  std::string bytes = format::table_bytes(rows, {{"cube", cube}});
  bytes.back() = '\xff';
  EXPECT_EQ(refusal(sealed(bytes)), "small.hxt: is damaged: name 0 is inconsistent");
}

class TableFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "hexatlas-table-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(TableFile, IsOpenedLikeItsBytes) {
  const std::string path = (folder_ / "small.hxt").string();
  const std::string bytes = small_table();
  core::write_file(path, bytes);
  const Table table = Table::open(path);
  EXPECT_EQ(table.sha256(), Table::from_bytes(bytes, "t").sha256());
  EXPECT_EQ(table.bytes(), bytes.size());
  EXPECT_EQ(table.path(), path);
  EXPECT_THROW((void)Table::open((folder_ / "none.hxt").string()), core::InvalidInput);
  EXPECT_THROW((void)Table::open(folder_.string()), core::InvalidInput);
  core::write_file(path, "");
  EXPECT_THROW((void)Table::open(path), core::InvalidInput);
}

TEST_F(TableFile, ManifestSaysWhatTheTableIs) {
  const std::string path = (folder_ / "small.hxt").string();
  core::write_file(path, small_table());
  const Table table = Table::open(path);
  const std::string manifest = format::manifest_path(path);
  EXPECT_EQ(manifest, (folder_ / "small.manifest.json").string());
  core::write_file(manifest, format::manifest_text(table, {"build it", 7, "hexatlas 1", "abc"}));
  const auto claims = format::read_manifest(manifest);
  EXPECT_EQ(claims.sha256, table.sha256());
  EXPECT_EQ(claims.bytes, table.bytes());
  EXPECT_EQ(claims.entries, table.size());
  EXPECT_EQ(claims.command, "build it");
  EXPECT_EQ(claims.seed, 7U);
  EXPECT_EQ(claims.program, "hexatlas 1");
  EXPECT_EQ(claims.commit, "abc");
  for (const char* text : {"", "{", "[]", "{}", "{\"sha256\": 3}", "null"}) {
    core::write_file(manifest, text);
    EXPECT_THROW((void)format::read_manifest(manifest), core::InvalidInput) << text;
  }
}

TEST(Sha256, IsThatOfTheStandard) {
  // FIPS 180-4 examples: "abc", and the two-block message.
  const std::array<std::string_view, 2> abc{"a", "bc"};
  EXPECT_EQ(format::to_hex(format::sha256(abc)),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const std::array<std::string_view, 1> long_one{
      "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"};
  EXPECT_EQ(format::to_hex(format::sha256(long_one)),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

}  // namespace
