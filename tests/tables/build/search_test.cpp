// Claim. three_connected_codes() lists the 3-connected quadrangulations with an even number of
// quads; a search finds checked meshes, the same for any number of threads, and the same after it
// was saved and taken up again anywhere. Oracle. Vertex splits of tests/oracles; meshes checked by
// sets and by the judge; the uninterrupted search.
#include "tables/build/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "tables/check/table_check.hpp"
#include "tests/counts/known_counts.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using build::TableSearch;

TEST(ThreeConnectedCodes, AreThoseOfVertexSplits) {
  constexpr int kMost = support::kSanitized ? 10 : 12;
  std::set<canon::Code> expected;
  auto level = support::four_cycle_class();
  for (int n = 3; n <= kMost; ++n) {
    level = support::grown(level);
    for (const auto& [code, map] : level)
      if (n % 2 == 0 && oracle::is_three_connected(map)) expected.insert(code);
  }
  const auto codes = build::three_connected_codes(kMost);
  EXPECT_TRUE(std::equal(codes.begin(), codes.end(), expected.begin(), expected.end()));
  EXPECT_TRUE(std::is_sorted(codes.begin(), codes.end()));
}

TEST(ThreeConnectedCodes, AreAsManyAsKnown) {
  std::map<int, std::uint64_t> counted;
  for (const auto& code : build::three_connected_codes(14)) ++counted[code.quads];
  auto expected = counts::known("three_connected_quadrangulations", 6, 14);
  std::erase_if(expected, [](const auto& row) { return row.first % 2 == 1; });
  EXPECT_EQ(counted, expected);
}

build::SearchOptions small(int threads) {
  build::SearchOptions options;
  options.balls.threads = threads;
  options.rounds = 2;
  options.balls.max_quads = options.collars.max_quads = 20;
  options.balls.fronts_per_class = 6;
  options.balls.fronts_per_level = 400;
  options.max_hexahedra = 40;
  options.growths = 4;
  options.cut = 5;
  options.cuts_each = 2;
  options.cut_growths = 4;
  options.symmetric.max_quads = 24;
  options.symmetric.fronts_per_level = 20;
  options.max_symmetric = 8;
  options.symmetrized = 3;
  options.symmetric_balls.max_quads = 24;
  options.symmetric_balls.fronts_per_level = 20;
  options.max_symmetric_ball = 8;
  options.collars.fronts_per_level = 60;
  options.max_collar = 3;
  options.collared = 3;
  options.anneal_rounds = 1;
  options.annealed = 1;
  options.anneal_starts = 2;
  options.anneal_faulty = 2;
  options.anneal_cut = 2;
  options.anneal_transplant = 2;
  options.anneal_leaps = 2;
  return options;
}

TableSearch run_to_its_end(TableSearch search) {
  while (!search.is_finished()) search.step();
  return search;
}

TableSearch finished(std::vector<canon::Code> codes, const build::SearchOptions& options) {
  return run_to_its_end({std::move(codes), options});
}

std::string table_of(const TableSearch& search) {
  return format::table_bytes(build::table_rows(search), {});
}

TEST(TableSearch, FillsWhatItSays) {
  const auto codes = build::three_connected_codes(14);
  TableSearch search(codes, small(1));
  std::set<std::string> phases;
  while (!search.is_finished()) {
    const auto progress = search.progress();
    EXPECT_LE(progress.done, progress.total);
    phases.insert(progress.phase);
    search.step();
  }
  EXPECT_EQ(phases.size(), 12U);
  const auto rows = build::table_rows(search);
  EXPECT_EQ(rows.size() + search.without_mesh().size(), codes.size());
  EXPECT_GE(rows.size(), 8U);
  const auto found = search.rows();
  ASSERT_EQ(found.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].code, found[i].code);
    EXPECT_EQ(rows[i].mesh.hexahedra.size(), static_cast<std::size_t>(found[i].hexahedra));
    EXPECT_EQ(support::fault_of_mesh(rows[i].mesh, rows[i].code), "");
    EXPECT_EQ(rows[i].lower_bound, 1);
  }
  const auto verdict = check::check_table_bytes(table_of(search));
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
}

TEST(TableSearch, IsTheSameForAnyThreadsAndAfterAnyInterruption) {
  const auto codes = build::three_connected_codes(10);
  const TableSearch whole = finished(codes, small(1));
  const std::string expected = whole.to_bytes();

  TableSearch interrupted(codes, small(2));
  for (int step = 0; !interrupted.is_finished(); ++step) {
    interrupted.step();
    if (step % 7 == 0)
      interrupted =
          TableSearch::from_bytes(interrupted.to_bytes(), codes, small(1 + step % 3), "saved");
  }
  EXPECT_EQ(interrupted.to_bytes(), expected);
  EXPECT_EQ(table_of(interrupted), table_of(whole));
}

TEST(TableSearch, TakesCollarsWiderThanStates) {
  const auto codes = build::three_connected_codes(12);
  const auto wide = [](int threads, int guided) {
    build::SearchOptions options = small(threads);
    options.rounds = 1;
    options.collars.max_quads = 36;
    options.collars.scars_per_quad = 12;
    options.guided = guided;
    return options;
  };
  const TableSearch one = finished(codes, wide(1, 2));
  const TableSearch three = finished(codes, wide(3, 2));
  EXPECT_EQ(one.to_bytes(), three.to_bytes());
  const auto verdict = check::check_table_bytes(table_of(one));
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_NO_THROW((void)TableSearch::from_bytes(one.to_bytes(), codes, wide(1, 2), "saved"));
  EXPECT_THROW((void)TableSearch::from_bytes(one.to_bytes(), codes, wide(1, 0), "saved"),
               core::InvalidInput);
}

TEST(TableSearch, TakesBoundariesAsWideAsStatesHave) {
  const auto codes = build::three_connected_codes(10);
  build::SearchOptions options = small(1);
  options.rounds = 1;
  options.balls.max_quads = flips::kMaxStateQuads;
  options.balls.fronts_per_level = 20;
  options.max_hexahedra = 24;
  const TableSearch whole = finished(codes, options);
  int widest = 0;
  for (const auto& code : whole.balls().codes()) widest = std::max(widest, int{code.quads});
  EXPECT_EQ(widest, flips::kMaxStateQuads);
  TableSearch saved(codes, options);
  for (int step = 0; !saved.is_finished(); ++step) {
    saved.step();
    if (step % 5 == 0) saved = TableSearch::from_bytes(saved.to_bytes(), codes, options, "saved");
  }
  EXPECT_EQ(table_of(saved), table_of(whole));
  const auto verdict = check::check_table_bytes(table_of(whole));
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
}

TEST(TableSearch, MayGoOnForFurtherRounds) {
  const auto codes = build::three_connected_codes(10);
  build::SearchOptions options = small(1);
  options.rounds = 3;
  const TableSearch whole = finished(codes, options);
  options.rounds = 1;
  const TableSearch first = finished(codes, options);
  options.rounds = 3;
  auto longer = TableSearch::from_bytes(first.to_bytes(), codes, options, "saved");
  EXPECT_FALSE(longer.is_finished());
  EXPECT_EQ(run_to_its_end(std::move(longer)).to_bytes(), whole.to_bytes());
}

TEST(TableSearch, EndsTheRoundItIsInIfFewerAreWanted) {
  const auto codes = build::three_connected_codes(10);
  build::SearchOptions options = small(1);
  options.rounds = 2;
  const TableSearch whole = finished(codes, options);
  options.rounds = 3;
  TableSearch longer(codes, options);
  while (!longer.progress().phase.starts_with("round 2")) longer.step();
  options.rounds = 1;
  auto shorter = TableSearch::from_bytes(longer.to_bytes(), codes, options, "saved");
  for (int steps = 0; !shorter.is_finished() && steps < 10'000; ++steps) shorter.step();
  EXPECT_EQ(shorter.to_bytes(), whole.to_bytes());
}

std::map<canon::Code, int> hexahedra_of(const TableSearch& search) {
  std::map<canon::Code, int> result;
  for (const auto& row : search.rows()) result[row.code] = row.hexahedra;
  return result;
}

TEST(TableSearch, BeginsWithWhatOthersFound) {
  const auto codes = build::three_connected_codes(12);
  const TableSearch first = finished(codes, small(1));
  const auto found = hexahedra_of(first);
  ASSERT_GE(found.size(), 4U);
  EXPECT_TRUE(TableSearch::is_saved(first.to_bytes()));
  EXPECT_FALSE(TableSearch::is_saved(table_of(first)));

  const auto more = build::three_connected_codes(14);
  const auto saved = TableSearch::started_from(first.to_bytes(), more, small(1), "saved");
  for (const auto& [code, hexahedra] : found) EXPECT_LE(hexahedra_of(saved)[code], hexahedra);

  const auto table = format::Table::from_bytes(table_of(first), "table");
  build::SearchOptions quick = small(2);
  quick.rounds = 1;
  quick.max_hexahedra = 20;
  TableSearch taken(more, quick);
  TableSearch::Origins origins;
  for (const auto& [code, hexahedra] : found)
    origins[code] = build::origin_named(code.quads == 8 ? "cut" : "a word of others");
  EXPECT_EQ(taken.take_over(table, "table", origins), found.size() - 1);  // it begins with the cube
  EXPECT_EQ(hexahedra_of(taken), found);
  for (const auto& row : taken.rows()) {
    const std::string source = row.code.quads == 6   ? "sweep"
                               : row.code.quads == 8 ? "cut"
                                                     : "table";
    EXPECT_EQ(build::name_of(row.origin), source);
    EXPECT_EQ(support::fault_of_mesh(taken.mesh(row.code), row.code), "");
  }
  EXPECT_EQ(taken.take_over(table, "table"), 0U);
  const auto after = hexahedra_of(run_to_its_end(std::move(taken)));
  for (const auto& [code, hexahedra] : found) EXPECT_LE(after.at(code), hexahedra);
}

TEST(TableSearch, ExchangesMeshesBesideTheBeamToo) {
  const auto codes = build::three_connected_codes(14);
  build::SearchOptions options = small(1);
  options.balls.max_quads = 14;
  options.rounds = support::kSanitized ? 1 : 3;
  options.growths = 100;
  options.cut = 60;
  options.cut_interior = 6;
  TableSearch search(codes, options);
  std::map<canon::Code, int> before;
  while (!search.is_finished()) {
    search.step();
    for (const auto& [code, hexahedra] : hexahedra_of(search)) {
      const auto [known, is_new] = before.try_emplace(code, hexahedra);
      EXPECT_LE(hexahedra, known->second);
      known->second = hexahedra;
    }
  }
  for (const auto& row : search.rows())
    EXPECT_EQ(support::fault_of_mesh(search.mesh(row.code), row.code), "");
}

TEST(TableSearch, RefusesWhatIsNotItsOwn) {
  const auto codes = build::three_connected_codes(10);
  TableSearch search(codes, small(1));
  for (int step = 0; step < 12; ++step) search.step();
  const std::string bytes = search.to_bytes();
  const auto restore = [&](const std::string& saved) {
    (void)TableSearch::from_bytes(saved, codes, small(1), "saved");
  };
  EXPECT_NO_THROW(restore(bytes));
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 300) {
    std::string damaged = bytes;
    damaged[at] ^= 1;
    EXPECT_THROW(restore(damaged), core::InvalidInput) << at;
    EXPECT_THROW(restore(bytes.substr(0, at)), core::InvalidInput) << at;
  }
  auto fewer = codes;
  fewer.pop_back();
  EXPECT_THROW((void)TableSearch::from_bytes(bytes, fewer, small(1), "saved"), core::InvalidInput);
  build::SearchOptions other = small(1);
  other.growths = 5;
  EXPECT_THROW((void)TableSearch::from_bytes(bytes, codes, other, "saved"), core::InvalidInput);
  other = small(1);
  other.cut_interior = 5;
  EXPECT_THROW((void)TableSearch::from_bytes(bytes, codes, other, "saved"), core::InvalidInput);
}

}  // namespace
