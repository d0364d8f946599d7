// Claim. The bound of a row is raised to what the searches exclude and no further; a larger mesh
// than need be is replaced by a smallest one; nothing is claimed beyond the nodes that were
// allowed; the number of threads changes nothing. Oracle. What is evident of one, two and four
// hexahedra; the judge of tables. That the searches miss no ball: tests/enum/hexes.
#include "tables/build/bounds.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/hexes/hexmeshes.hpp"
#include "tables/check/table_check.hpp"

namespace {

using namespace hexatlas;
using Change = build::BoundOutcome::Change;

constexpr const char* kTwoCubes = "q1:022972977f";

/// A row with a ball of exactly so many hexahedra, from the list of all up to that size.
format::TableRow row_with(const std::string& text, std::size_t hexahedra) {
  const canon::Code code = canon::from_text(text).value();
  const complex::Quadrangulation boundary = canon::decode(code).value();
  const auto most = static_cast<int>(hexahedra);
  const hexes::HexmeshProblem problem(
      boundary, {.max_hexahedra = most,
                 .max_interior = hexes::most_interior_vertices(boundary.quads(), most),
                 .ball = true});
  hexes::HexFrontier frontier = problem.begin();
  problem.go_on(frontier, {}, {});
  for (const hexes::Hexmesh& found : frontier.found)
    if (found.mesh.hexahedra.size() == hexahedra && found.topology == hexes::Topology::ball)
      return {code, found.mesh, 1};
  ADD_FAILURE() << "no ball of " << hexahedra << " hexahedra";
  return {};
}

TEST(Bounds, StopAtTheSizeOfTheMesh) {
  for (const auto& [text, hexahedra] : std::vector<std::pair<std::string, std::size_t>>{
           {"q1:08a5df", 1}, {kTwoCubes, 2}, {"q1:088a2a5ddf7f", 4}}) {
    format::TableRow row = row_with(text, hexahedra);
    const auto before = row.mesh.hexahedra;
    EXPECT_EQ(build::raise_bound(row, {.max_hexahedra = 9}).change,
              hexahedra == 1 ? Change::none : Change::raised);
    EXPECT_EQ(row.lower_bound, hexahedra);
    EXPECT_EQ(row.mesh.hexahedra, before);
    EXPECT_EQ(build::raise_bound(row, {.max_hexahedra = 9}).change, Change::none);
  }
}

TEST(Bounds, ReplaceAMeshThatIsTooLarge) {
  for (const std::size_t hexahedra : {6U, 8U, 12U}) {
    format::TableRow row = row_with(kTwoCubes, hexahedra);
    EXPECT_EQ(build::raise_bound(row, {.max_hexahedra = 1}).change, Change::raised);
    EXPECT_EQ(row.lower_bound, 2);
    EXPECT_EQ(row.mesh.hexahedra.size(), hexahedra);
    EXPECT_EQ(build::raise_bound(row, {.max_hexahedra = 2}).change, Change::replaced);
    EXPECT_EQ(row.lower_bound, 2);
    EXPECT_EQ(row.mesh.hexahedra.size(), 2U);
    const auto verdict = check::check_table_bytes(format::table_bytes({row}, {}));
    EXPECT_EQ(verdict.reason, "");
    EXPECT_EQ(verdict.claimed_bounds, 1U);
  }
}

TEST(Bounds, ThatAreFalseAreRefused) {
  format::TableRow row = row_with(kTwoCubes, 6);
  row.lower_bound = 3;
  EXPECT_THROW((void)build::raise_bound(row, {.max_hexahedra = 3}), core::InvalidInput);
  EXPECT_EQ(row.mesh.hexahedra.size(), 6U);
  EXPECT_THROW(build::expect_not_refuted("x", row.code, 7, 6), core::InvalidInput);
  EXPECT_NO_THROW(build::expect_not_refuted("x", row.code, 6, 6));
}

TEST(Bounds, ClaimNoMoreThanWasSearched) {
  constexpr const char* kSpindle = "q1:088a577f";
  // 39 hexahedra are known, too many to be listed: any mesh stands for it.
  format::TableRow row{canon::from_text(kSpindle).value(), {}, 1};
  row.mesh.hexahedra.resize(39);
  const format::TableRow first = row;
  const std::atomic<bool> stop = true;
  const build::BoundOutcome stopped = build::raise_bound(row, {.max_hexahedra = 12, .stop = &stop});
  EXPECT_EQ(stopped.change, Change::none);
  EXPECT_TRUE(stopped.is_cut);
  EXPECT_EQ(row.lower_bound, 1);
  const build::BoundOutcome whole = build::raise_bound(row, {.max_hexahedra = 14});
  EXPECT_EQ(whole.change, Change::raised);
  EXPECT_FALSE(whole.is_cut);
  EXPECT_EQ(row.lower_bound, 15);
  int before = 1;
  for (const std::uint64_t nodes : {5U, 50U, 500U}) {
    format::TableRow limited = first;
    EXPECT_TRUE(build::raise_bound(limited, {.max_hexahedra = 14, .max_nodes = nodes}).is_cut);
    EXPECT_GE(limited.lower_bound, before);
    EXPECT_LT(limited.lower_bound, 15);
    before = limited.lower_bound;
  }
  EXPECT_GT(before, 5);
}

TEST(Bounds, OfABoundaryThatNoTableShouldHave) {
  const canon::Code with_degree_two = canon::from_text("q1:0055").value();
  ASSERT_TRUE(canon::decode(with_degree_two));
  for (const canon::Code& code : {canon::Code{}, with_degree_two}) {
    format::TableRow row{code, {}, 1};
    row.mesh.hexahedra.resize(2);
    EXPECT_THROW((void)build::raise_bound(row, {.max_hexahedra = 3}), core::InvalidInput);
    EXPECT_EQ(row.lower_bound, 1);
  }
}

std::vector<Change> changes_of(std::vector<format::TableRow>& rows,
                               const build::BoundOptions& options) {
  std::vector<format::TableRow*> pointers;
  pointers.reserve(rows.size());
  for (format::TableRow& row : rows) pointers.push_back(&row);
  std::vector<Change> result;
  for (const build::BoundOutcome& outcome : build::raise_bounds(pointers, options))
    result.push_back(outcome.change);
  return result;
}

TEST(Bounds, AreTheSameForAnyNumberOfThreads) {
  std::vector<format::TableRow> rows{row_with("q1:08a5df", 1), row_with(kTwoCubes, 12),
                                     row_with(kTwoCubes, 6), row_with("q1:088a2a5ddf7f", 4)};
  std::vector<format::TableRow> others = rows;
  const std::vector<Change> expected{Change::none, Change::replaced, Change::replaced,
                                     Change::raised};
  EXPECT_EQ(changes_of(rows, {.max_hexahedra = 8}), expected);
  EXPECT_EQ(changes_of(others, {.max_hexahedra = 8, .threads = 3}), expected);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].mesh.hexahedra, others[i].mesh.hexahedra);
    EXPECT_EQ(rows[i].lower_bound, others[i].lower_bound);
    EXPECT_EQ(rows[i].lower_bound, rows[i].mesh.hexahedra.size());
  }
}

}  // namespace
