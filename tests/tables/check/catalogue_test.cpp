// Claim. The judge accepts catalogues of all triangulations of small cells and of all small balls,
// counts them rightly, and accepts points exactly if they fulfil the condition, also where they are
// in special position. Oracle. tests/sabotage/triangulation_oracle.hpp: all sets of tetrahedra are
// tried, balls are found by links, symmetries among all permutations, embeddings by the corners of
// intersections, convex position by hulls; numbers of classes as in the literature. The digest is
// that of the document.
#include "tables/check/catalogue.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tables/check/jacobian.hpp"
#include "tables/check/malformed.hpp"
#include "tables/format/frame.hpp"
#include "tests/sabotage/sample_catalogues.hpp"

namespace hexatlas::check {
namespace {

using namespace sabotage;

CatalogueVerdict verdict_on(const TextCatalogue& c) {
  return check_catalogue_bytes(sealed(body_of(c)), "test");
}

TEST(Catalogue, TheDefinitionIsTheDocument) {
  EXPECT_EQ(judged_definition_digest(), sha256_hex(std::string(HEXATLAS_SOURCE_DIR) +
                                                   "/docs/theory/triangulation-definition.txt"));
}

TEST(Catalogue, AllTriangulationsOfSmallCellsAreAccepted) {
  const std::vector<std::pair<SampleCell, std::size_t>> cells = {
      {tetrahedron(0), 1}, {tetrahedron(1), 1}, {tetrahedron(2), 2}, {pyramid(0), 1},
      {pyramid(1), 4},     {prism(), 2},        {octahedron(), 2}};
  for (const auto& [cell, classes] : cells) {
    std::size_t members = 0;
    const TextCatalogue c = catalogue_of(cell, &members);
    const CatalogueVerdict verdict = verdict_on(c);
    EXPECT_TRUE(verdict.accepted) << cell.name << ": " << verdict.reason;
    EXPECT_EQ(verdict.classes, classes) << cell.name;
    EXPECT_EQ(verdict.labelled * (cell.interior == 2 ? 2 : 1), members) << cell.name;
    EXPECT_TRUE(verdict.claims_exhaustive);
    EXPECT_EQ(verdict.symmetries, static_cast<std::uint64_t>(c.symmetries));
  }
}

TEST(Catalogue, AllSmallBallsAreAccepted) {
  const std::array<std::size_t, 3> counts = {1, 3, 12};
  for (int vertices = 4; vertices <= 6; ++vertices) {
    const CatalogueVerdict verdict = verdict_on(catalogue_of_balls(vertices));
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_FALSE(verdict.is_cell);
    EXPECT_EQ(verdict.classes, counts[static_cast<std::size_t>(vertices - 4)]);
  }
}

TEST(Catalogue, AnotherMemberOfAClassIsAsGood) {
  std::mt19937_64 random(3);
  for (const SampleCell& cell : {prism(), octahedron(), pyramid(1), tetrahedron(2)}) {
    TextCatalogue c = catalogue_of(cell);
    const Maps maps = maps_of_cell(cell.cell, static_cast<int>(c.vertices));
    for (TextClass& item : c.list) {
      const auto& map = maps[random() % maps.size()];
      for (Simplex& t : item.tetrahedra) {
        for (int& v : t) v = map[static_cast<std::size_t>(v)];
        t = sorted(t);
      }
    }
    EXPECT_TRUE(verdict_on(c).accepted) << cell.name;
  }
}

TEST(Catalogue, AFileMayBeOneFrame) {
  const std::string text = sealed(body_of(catalogue_of(prism())));
  const std::string frame = format::compressed(text);
  EXPECT_TRUE(is_catalogue(text.substr(0, 20)));
  EXPECT_TRUE(is_catalogue(frame.substr(0, 20)));
  EXPECT_FALSE(is_catalogue("hexatlas\1"));
  EXPECT_TRUE(check_catalogue_bytes(frame, "test").accepted);
  EXPECT_THROW((void)check_catalogue_bytes(frame + frame, "test"), Malformed);
  EXPECT_THROW((void)check_catalogue_bytes(frame.substr(0, frame.size() - 1), "test"), Malformed);
}

TEST(Catalogue, AShellingIsFoundIfNoneIsGiven) {
  TextCatalogue c = catalogue_of_balls(6);
  for (TextClass& item : c.list) {
    item.unshelled = true;
    std::sort(item.tetrahedra.begin(), item.tetrahedra.end(),
              [](const Simplex& a, const Simplex& b) {
                return numbers_of({a}, first_numbers(6)) < numbers_of({b}, first_numbers(6));
              });
  }
  const CatalogueVerdict verdict = verdict_on(c);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  // Two tetrahedra with one vertex in common are no ball.
  c = catalogue_of_balls(6);
  c.vertices = 7;
  c.classes = 1;
  c.list = {{1, 72, true, {{0, 1, 2, 3}, {3, 4, 5, 6}}, {}}};
  EXPECT_FALSE(verdict_on(c).accepted);
  EXPECT_TRUE(verdict_on(c).undecided);
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kBall);
}

/// Points of each class are moved, and both are asked; in steps, so that many are in special
/// position.
TEST(Catalogue, PointsAreAcceptedExactlyIfTheyRealize) {
  std::mt19937_64 random(7);
  std::array<int, 2> answers = {0, 0};
  for (const SampleCell& cell : {prism(), octahedron(), pyramid(1), tetrahedron(2)}) {
    TextCatalogue c = catalogue_of(cell);
    for (TextClass& item : c.list) {
      const Points good = realization_of(c, item, false, 1'000'000, random);
      ASSERT_FALSE(good.empty()) << cell.name;
      item.properties = {{"embedded", "points", good, {}}};
    }
    ASSERT_TRUE(verdict_on(c).accepted) << verdict_on(c).reason;
    EXPECT_EQ(verdict_on(c).conditions[0].realizable, c.list.size());
    const SlowCell slow = c.cell();
    for (std::size_t i = 0; i < c.list.size(); ++i) {
      for (int round = 0; round < 120; ++round) {
        TextCatalogue moved = c;
        Points& points = moved.list[i].properties[0].points;
        for (auto& p : points) {
          for (auto& x : p) x += static_cast<std::int64_t>(random() % 7) - 3;
        }
        const bool realizes = is_embedded(points, moved.list[i].tetrahedra, &slow);
        EXPECT_EQ(verdict_on(moved).accepted, realizes) << body_of(moved);
        ++answers[realizes ? 1 : 0];
        moved.list[i].properties[0].condition = "convex";
        EXPECT_EQ(verdict_on(moved).accepted, realizes && is_in_convex_position(points));
      }
    }
  }
  EXPECT_GT(answers[0], 100);
  EXPECT_GT(answers[1], 100);
}

TEST(Catalogue, PointsInSpecialPositionAreJudgedExactly) {
  std::mt19937_64 random(11);
  int accepted = 0;
  for (const int vertices : {5, 6}) {
    TextCatalogue c = catalogue_of_balls(vertices);
    for (std::size_t i = 0; i < c.list.size(); ++i) {
      for (int round = 0; round < 100; ++round) {
        TextCatalogue one = c;
        const Points points = random_points(static_cast<std::size_t>(vertices), 1, random);
        const bool realizes = is_embedded(points, c.list[i].tetrahedra, nullptr);
        one.list[i].properties = {{"embedded", "points", points, {}}};
        EXPECT_EQ(verdict_on(one).accepted, realizes) << body_of(one);
        one.list[i].properties[0].condition = "convex";
        EXPECT_EQ(verdict_on(one).accepted, realizes && is_in_convex_position(points));
        accepted += realizes ? 1 : 0;
      }
    }
  }
  EXPECT_GT(accepted, 5);
}

/// Chains with all tetrahedra oriented as they should be, which may run into themselves; many
/// touch.
TEST(Catalogue, ChainsThatMeetThemselvesAreFound) {
  std::mt19937_64 random(17);
  std::array<int, 2> answers = {0, 0};
  for (const int vertices : {7, 8}) {
    TextCatalogue c = chain(vertices);
    const Clause signs = sign_literals(c.list[0].tetrahedra, nullptr, SignVariables(vertices));
    for (int round = 0; round < 600; ++round) {
      Points points;
      const std::int64_t bound = round % 2 == 0 ? 2 : 6;
      while (points.size() < static_cast<std::size_t>(vertices)) {
        points.push_back(random_points(1, bound, random)[0]);
        const auto t = static_cast<std::ptrdiff_t>(points.size()) - 4;
        if (t < 0) continue;
        const auto i = static_cast<std::size_t>(t);
        const Int128 volume = six_volumes(points, c.list[0].tetrahedra[i]);
        if (signs[i] > 0 ? volume <= 0 : volume >= 0) {
          points.resize(random() % 20 == 0 ? 0 : points.size() - 1);
        }
      }
      c.list[0].properties = {{"embedded", "points", points, {}}};
      const bool realizes = is_embedded(points, c.list[0].tetrahedra, nullptr);
      EXPECT_EQ(verdict_on(c).accepted, realizes) << body_of(c);
      ++answers[realizes ? 1 : 0];
    }
  }
  EXPECT_GT(answers[0], 100);
  EXPECT_GT(answers[1], 100);
}

TEST(Catalogue, LargeCoordinatesDoNotOverflow) {
  TextCatalogue c = catalogue_of(pyramid(0));
  constexpr std::int64_t kMost = (std::int64_t{1} << 20) - 1;
  const Points base = {{-kMost, -kMost, -kMost},
                       {kMost, -kMost, -kMost},
                       {kMost, kMost, -kMost},
                       {-kMost, kMost, -kMost},
                       {0, 0, kMost}};
  c.list[0].properties = {{"embedded", "points", base, {}}, {"convex", "points", base, {}}};
  EXPECT_TRUE(verdict_on(c).accepted) << verdict_on(c).reason;
  c.list[0].properties[0].points[4][2] = kMost + 1;
  EXPECT_THROW((void)verdict_on(c), Malformed);
}

TEST(Catalogue, TheJacobianIsJudgedExactly) {
  std::mt19937_64 random(13);
  const TextCatalogue cubes = catalogue_of_cubes();
  std::array<int, 3> answers = {0, 0, 0};
  for (int round = 0; round < 1000; ++round) {
    TextCatalogue c = cubes;
    const auto size = static_cast<std::int64_t>(20 + random() % 30);
    Points points = random_points(8, 12, random);
    for (unsigned v = 0; v < 8; ++v) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        if (((v >> axis) & 1U) != 0) points[v][axis] += size;
      }
    }
    const std::size_t i = random() % c.list.size();
    const SlowCell cell = c.cell();
    if (!is_embedded(points, c.list[i].tetrahedra, &cell)) continue;
    c.list[i].properties = {{"jacobian", "points", points, {}}};
    const CatalogueVerdict verdict = verdict_on(c);
    if (verdict.accepted) {
      EXPECT_TRUE(has_positive_jacobian_on_grid(points, 12));
    }
    if (!has_positive_jacobian_on_grid(points, 12)) {
      EXPECT_FALSE(verdict.accepted);
      EXPECT_EQ(verdict.broken, CatalogueLaw::kJacobian);
    }
    ++answers[verdict.accepted ? 0 : (verdict.undecided ? 1 : 2)];
  }
  EXPECT_GT(answers[0], 50);
  EXPECT_GT(answers[2], 50);
  EXPECT_LT(answers[1], 5);
}

/// Hexahedra with positive corners; many of them are negative somewhere between.
TEST(Catalogue, TheJacobianIsSubdividedExactly) {
  std::mt19937_64 random(19);
  std::array<int, 3> answers = {0, 0, 0};
  int between = 0;
  for (int round = 0; round < 20'000; ++round) {
    Points points = random_points(8, 12, random);
    for (unsigned v = 0; v < 8; ++v) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        if (((v >> axis) & 1U) != 0) points[v][axis] += 14;
      }
    }
    if (!has_positive_jacobian_on_grid(points, 1)) continue;
    const JacobianSign sign = jacobian_sign(points);
    const bool on_grid = has_positive_jacobian_on_grid(points, 16);
    if (sign == JacobianSign::kPositive) {
      EXPECT_TRUE(on_grid);
    }
    if (!on_grid) {
      EXPECT_EQ(sign, JacobianSign::kNotPositive);
    }
    between += sign == JacobianSign::kNotPositive && on_grid ? 1 : 0;
    ++answers[static_cast<std::size_t>(sign)];
  }
  EXPECT_GT(answers[0], 50);
  EXPECT_GT(answers[1], 50);
  EXPECT_LT(answers[2], 5);
  EXPECT_LE(between, answers[1] / 20);  // not positive between the points of the grid only
}

TEST(Catalogue, TheCubeItselfIsAccepted) {
  TextCatalogue c = catalogue_of_cubes();
  constexpr std::int64_t kMost = (std::int64_t{1} << 20) - 1;
  for (TextClass& item : c.list) {
    Points points(8);
    for (unsigned v = 0; v < 8; ++v) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        points[v][axis] = ((v >> axis) & 1U) != 0 ? kMost : -kMost;
      }
    }
    for (const std::string condition : {"embedded", "convex", "jacobian"}) {
      item.properties.push_back({condition, "points", points, {}});
    }
  }
  const CatalogueVerdict verdict = verdict_on(c);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  for (const ConditionCounts& counts : verdict.conditions) {
    EXPECT_EQ(counts.realizable, c.list.size());
  }
}

TEST(Catalogue, WhatIsNoBallIsRefused) {
  TextCatalogue c = catalogue_of_balls(5);
  c.classes = 1;
  c.list.resize(1);
  c.list[0] = {1, 120, false, subsets(first_numbers(5), 4), {}};  // a sphere
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kBall);
  c.list[0].unshelled = true;
  EXPECT_FALSE(verdict_on(c).accepted);
  c.vertices = 6;
  c.list[0] = {1, 36, false, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}, {}};
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kTriangles);
  c.list[0] = {1, 8, false, {{0, 1, 2, 3}, {0, 1, 4, 5}}, {}};  // an edge in common
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kBall);
}

TEST(Catalogue, WhatIsNoCellIsRefused) {
  // A torus of nine quads.
  TextCatalogue c = empty_catalogue("torus", 9);
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      const int right = (x + 1) % 3;
      const int up = (y + 1) % 3;
      c.facets.push_back({3 * x + y, 3 * right + y, 3 * right + up, 3 * x + up});
    }
  }
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kCell);
  // Two tetrahedra with a vertex in common.
  c = empty_catalogue("two", 7);
  c.facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2},
              {3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {3, 6, 5}};
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kCell);
  c = catalogue_of(prism());
  c.facets[0] = {0, 1, 2};
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kCell);
  c = catalogue_of(prism());
  c.name = "octahedron";
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kName);
}

TEST(Catalogue, TetrahedraOnOneFacetMustBeAllowed) {
  const SampleCell cell = pyramid(0);
  TextCatalogue c = catalogue_of(cell);
  const std::size_t without = c.list.size();
  c.list.clear();
  c.labelled = 0;
  c.boundary_tetrahedra = true;
  std::vector<Complex> found;
  for (const Complex& ball : all_balls(5, nullptr)) {
    if (bounds_cell(ball, cell.cell)) found.push_back(ball);
  }
  add_classes(c, found, maps_of_cell(cell.cell, 5));
  EXPECT_GT(c.list.size(), without);
  EXPECT_TRUE(verdict_on(c).accepted) << verdict_on(c).reason;
  c.boundary_tetrahedra = false;
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kBoundaryTetrahedra);
}

TEST(Catalogue, ATetrahedronHasFourVertices) {
  for (const std::string word : {"0012", "0112", "0122", "1023", "0126", "012", "01234", "012g"}) {
    const std::string text = body_of(catalogue_of(pyramid(0)));
    EXPECT_THROW((void)check_catalogue_bytes(
                     sealed(text.substr(0, text.rfind(' ') + 1) + word + "\n"), "test"),
                 Malformed)
        << word;
  }
}

TEST(Catalogue, MessagesNameTheClassOrTheLine) {
  TextCatalogue c = catalogue_of(prism());
  c.list[1].automorphisms += 1;
  EXPECT_EQ(verdict_on(c).reason.rfind("class 2: ", 0), 0U);
  EXPECT_EQ(verdict_on(c).broken, CatalogueLaw::kAutomorphisms);
  c = catalogue_of(prism());
  c.name = "Prism";
  try {
    (void)verdict_on(c);
    FAIL() << "read";
  } catch (const Malformed& error) {
    EXPECT_EQ(std::string(error.what()).rfind("test:4: ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace hexatlas::check
