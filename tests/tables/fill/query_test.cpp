// Claim. A boundary that is not in a table is filled by way of one that is: the mesh obeys the
// strict rule and has this boundary; the same for any number of threads; where no way is found,
// nothing is given. Oracle. Meshes checked by sets.
#include "tables/fill/query.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;

/// Meshes of the classes that few hexahedra reach, with at most 14 quads.
format::Table small_table() {
  const flips::Beam beam = support::grown(20, 20, 2'000, 9);
  std::vector<format::TableRow> rows;
  for (const auto& code : beam.codes())
    if (code.quads <= 14)
      rows.push_back({code, flips::filling_of(beam, beam.fronts_of(code)[0].id).mesh, 1});
  return format::Table::from_bytes(format::table_bytes(rows, {}), "table");
}

TEST(Query, FillsBoundariesByWayOfTheTable) {
  const format::Table table = small_table();
  const flips::Beam beam = support::grown(20, 20, 200'000, 5);
  int known = 0, asked = 0, filled = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads < 16 || known++ % support::kStride != 0) continue;
    ++asked;
    fill::QueryOptions options{.max_collar = 5, .collars_per_level = 200};
    const auto mesh = fill::fill_through(table, code, options);
    if (!mesh) continue;
    ++filled;
    EXPECT_EQ(support::fault_of_mesh(*mesh, code), "") << canon::to_text(code);
    options.threads = 3;
    EXPECT_EQ(fill::fill_through(table, code, options)->hexahedra, mesh->hexahedra);
  }
  EXPECT_GT(asked, support::share_of(20));
  EXPECT_GT(filled, asked / 2);
}

TEST(Query, GivesWhatIsInTheTable) {
  const format::Table table = small_table();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto mesh = fill::fill_through(table, table.entry(i).code);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->hexahedra.size(), table.entry(i).hexahedra);
    EXPECT_EQ(support::fault_of_mesh(*mesh, table.entry(i).code), "");
  }
}

TEST(Query, MayFindNothing) {
  const format::Table empty = format::Table::from_bytes(format::table_bytes({}, {}), "empty");
  const auto spindle = canon::from_text("q1:088a577f").value();
  EXPECT_FALSE(fill::fill_through(empty, spindle, {.max_collar = 3, .collars_per_level = 50}));
}

}  // namespace
