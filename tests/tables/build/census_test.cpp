// Claim. A census gives back its rows, its bytes depend on nothing else, no changed byte gives
// other rows, and what is no census is refused in one line. Oracle. The rows; the program sqlite3
// is not needed: the digest is computed here again from docs/formats/census.md.
#include "tables/build/census.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "tables/format/sha256.hpp"
#include "tests/tables/format/fixtures.hpp"

namespace {

using namespace hexatlas;

void write_census(const std::string& path, const build::Census& census) {
  core::write_file(path, build::census_bytes(path, census));
}
using build::Census;

class CensusFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "hexatlas-census-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder = pattern;
    path = (folder / "small.census.sqlite").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] std::string refusal() const {
    try {
      (void)build::read_census(path);
    } catch (const core::InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  }
  void put(const std::string& bytes) const { std::ofstream(path, std::ios::binary) << bytes; }
  [[nodiscard]] std::string bytes_of(const Census& census) const {
    write_census(path, census);
    return core::read_file(path);
  }

  std::filesystem::path folder;
  std::string path;
};

const Census& small_census() {
  static const Census kCensus = [] {
    const auto table =
        format::Table::from_bytes(format::table_bytes(fixtures::rows(20, 9), {}), "small.hxt");
    Census census{{table.sha256(), "hexatlas 9", "abc"}, {}};
    for (std::size_t i = 0; i < table.size(); ++i)
      census.rows.push_back(
          build::census_row(table.entry(i), i % 3 == 0 ? "beam" : "meeting", "2026-01-02"));
    return census;
  }();
  return kCensus;
}

bool are_same(const Census& a, const Census& b) { return a.about == b.about && a.rows == b.rows; }

TEST_F(CensusFile, GivesBackItsRows) {
  Census census = small_census();
  ASSERT_GT(census.rows.size(), 50U);
  const std::string bytes = bytes_of(census);
  std::mt19937 random(1);
  Census shuffled = census;
  std::shuffle(shuffled.rows.begin(), shuffled.rows.end(), random);
  EXPECT_EQ(bytes_of(shuffled), bytes);
  std::sort(census.rows.begin(), census.rows.end(),
            [](const auto& a, const auto& b) { return a.code < b.code; });
  EXPECT_TRUE(are_same(build::read_census(path), census));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "no other file";
  census.rows.clear();
  write_census(path, census);
  EXPECT_TRUE(build::read_census(path).rows.empty());
  EXPECT_EQ(build::census_path("a/b.hxt"), "a/b.census.sqlite");
}

TEST_F(CensusFile, RowsAreThoseOfTheEntries) {
  const auto cube = canon::from_text("q1:08a5df").value();
  const build::CensusRow row = build::census_row({cube, 1, 0, 1}, "known", "2026-01-02");
  EXPECT_EQ(row, (build::CensusRow{"q1:08a5df", 6, 48, 24, 1, 0, 1, "known", "2026-01-02"}));
}

TEST_F(CensusFile, RowsThatCannotBeAreNotWritten) {
  const Census& good = small_census();
  const auto refuses = [&](const std::function<void(Census&)>& change) {
    Census bad = good;
    change(bad);
    EXPECT_THROW(write_census(path, bad), core::PreconditionViolated);
    EXPECT_FALSE(std::filesystem::exists(path));
  };
  refuses([](Census& c) { c.rows.push_back(c.rows[3]); });
  refuses([](Census& c) { c.rows[3].lower_bound = 0; });
  refuses([](Census& c) { c.rows[3].lower_bound = c.rows[3].hexahedra + 1; });
}

TEST_F(CensusFile, NoChangedByteGivesOtherRows) {
  Census census = small_census();
  census.rows.resize(20);
  const std::string good = bytes_of(census);
  const Census read = build::read_census(path);
  std::mt19937 random(2);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::string bad = good;
    const auto at = random() % bad.size();
    bad[at] = static_cast<char>(bad[at] ^ (1 << random() % 8));
    put(bad);
    try {
      EXPECT_TRUE(are_same(build::read_census(path), read)) << at;
    } catch (const core::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
  for (std::size_t size = 0; size < good.size(); size += 997) {
    put(good.substr(0, size));
    EXPECT_NE(refusal(), "accepted") << size;
  }
}

TEST_F(CensusFile, WhatIsNoCensusIsRefused) {
  EXPECT_NE(refusal().find("small.census.sqlite: cannot be opened"), std::string::npos);
  for (const std::string& text : {std::string(), std::string("hexatlas"), std::string(9999, 'x')}) {
    put(text);
    EXPECT_NE(refusal().find("is no SQLite database"), std::string::npos);
  }
  std::filesystem::remove(path);
  std::filesystem::create_directory(path);
  EXPECT_NE(refusal().find("is a directory"), std::string::npos);
  EXPECT_THROW(write_census(path, small_census()), core::InvalidInput);
  EXPECT_THROW(write_census((folder / "no" / "where").string(), small_census()),
               core::InvalidInput);
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_THROW(write_census("/dev/full", small_census()), core::ResourceFailure);
  }
}

TEST_F(CensusFile, OtherVersionsAndDatabasesAreRefused) {
  const std::string good = bytes_of(small_census());
  std::string version = good;  // the user version: big-endian at byte 60; the application id at 68
  version[63] = 2;
  put(version);
  EXPECT_NE(refusal().find("is a census of version 2"), std::string::npos);
  std::string other = good;
  other[68] = 0;
  put(other);
  EXPECT_NE(refusal().find("is another database"), std::string::npos);
  std::string table = good;  // the name of a column, in the schema
  table.replace(table.find("interior_vertices"), 5, "outer");
  put(table);
  EXPECT_NE(refusal().find("other tables"), std::string::npos) << refusal();
}

TEST_F(CensusFile, DigestIsThatOfTheSpecification) {
  Census census = small_census();
  census.rows.resize(1);
  const std::string bytes = bytes_of(census);
  const auto& row = census.rows[0];
  const auto word = [](const std::string& w) { return std::to_string(w.size()) + " " + w + "\n"; };
  const std::string text = word(census.about.table_sha256) + word("hexatlas 9") + word("abc") +
                           "6\n48\n24\n1\n0\n1\n" + word(row.code) + word(row.source) +
                           word(row.found);
  const std::array<std::string_view, 1> whole{text};
  EXPECT_NE(bytes.find(format::to_hex(format::sha256(whole))), std::string::npos);
}

}  // namespace
