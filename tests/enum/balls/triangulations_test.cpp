// Claim. The classes of triangulations of the cells, their sizes and groups, for any number of
// threads and in limited runs. Oracle. The literature (174 classes of the hexahedron: Pellerin,
// Verhetsel, Remacle 2018, with their numbers per number of tetrahedra); symmetry-blind labelled
// counts; automorphisms by brute force. The road through spheres is tested in
// spheres_cells_test.cpp.
#include "enum/balls/triangulations.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "enum/search/depth_first.hpp"

namespace {

using namespace hexatlas;
using balls::Census;
using complex::cell_named;

std::map<std::size_t, std::uint64_t> classes_by_size(const Census& census) {
  std::map<std::size_t, std::uint64_t> result;
  for (const auto& [size, counts] : census.by_tetrahedra) result[size] = counts.classes;
  return result;
}

TEST(Triangulations, TheHexahedronHas174) {
  const Census census = balls::triangulations(*cell_named("hexahedron"), {});
  EXPECT_TRUE(census.exhaustive);
  EXPECT_EQ(census.total().classes, 174U);
  EXPECT_EQ(classes_by_size(census), (std::map<std::size_t, std::uint64_t>{{5, 1},
                                                                           {6, 5},
                                                                           {7, 5},
                                                                           {8, 7},
                                                                           {9, 13},
                                                                           {10, 20},
                                                                           {11, 35},
                                                                           {12, 30},
                                                                           {13, 28},
                                                                           {14, 19},
                                                                           {15, 11}}));
  EXPECT_EQ(census.not_balls + census.undecided, 0U);
  std::uint64_t labelled = 0, least = 48, greatest = 0;
  for (const auto& entry : census.classes) {
    const std::uint64_t size = census.symmetries / entry.automorphisms;
    labelled += size;
    least = std::min(least, size);
    greatest = std::max(greatest, size);
  }
  EXPECT_EQ(labelled, census.total().labelled);
  EXPECT_EQ(least, 2U);
  EXPECT_EQ(greatest, 48U);
}

TEST(Triangulations, SmallCellsWithInteriorVertices) {
  const std::map<std::pair<std::string, int>, std::uint64_t> known{
      {{"tetrahedron", 0}, 1},  {{"tetrahedron", 1}, 1}, {{"tetrahedron", 2}, 2},
      {{"tetrahedron", 3}, 12}, {{"pyramid", 0}, 1},     {{"pyramid", 1}, 4},
      {{"prism", 0}, 2},        {{"prism", 1}, 32},      {{"octahedron", 0}, 2},
      {{"octahedron", 1}, 10}};
  for (const auto& [key, classes] : known)
    EXPECT_EQ(
        balls::triangulations(*cell_named(key.first), {.interior = key.second}).total().classes,
        classes)
        << key.first << " " << key.second;
}

TEST(Triangulations, LabelledCountsDoNotDependOnSymmetry) {
  // Filled boundary by boundary without any use of the group.
  const complex::Cell cell = *cell_named("prism");
  std::uint64_t labelled = 0;
  std::vector<complex::VertexSet> forbidden;
  for (const auto& facet : cell.facets)
    if (facet.size == 4) forbidden.push_back(facet.vertices());
  for (const auto& surface : complex::cut_surfaces(cell)) {
    balls::FrontSearch problem(surface.triangles, cell.vertices, 1, forbidden);
    labelled += search::explore(problem, {}, {}, [](const auto&) { return true; }).counts.solutions;
  }
  EXPECT_EQ(balls::triangulations(cell, {.interior = 1}).total().labelled, labelled);
}

TEST(Triangulations, AutomorphismsAndCanonicalFormsByBruteForce) {
  const complex::Cell cell = *cell_named("hexahedron");
  const auto group = complex::symmetries(cell);
  const Census census = balls::triangulations(cell, {});
  std::set<complex::Triangulation> members;
  for (const auto& entry : census.classes) {
    std::uint64_t fixed = 0;
    for (const auto& map : group) {
      const auto image = complex::image_of(entry.canonical, map);
      fixed += image == entry.canonical ? 1 : 0;
      EXPECT_LE(entry.canonical.tetrahedra, image.tetrahedra);
      members.insert(image);
    }
    EXPECT_EQ(fixed, entry.automorphisms);
  }
  EXPECT_EQ(members.size(), census.total().labelled) << "no two classes share a member";
}

TEST(Triangulations, ThreadsDoNotMatter) {
  const complex::Cell cell = *cell_named("prism");
  const Census one = balls::triangulations(cell, {.interior = 2});
  for (const int threads : {2, 3}) {
    const Census more = balls::triangulations(cell, {.interior = 2, .threads = threads});
    EXPECT_EQ(more.by_tetrahedra, one.by_tetrahedra);
    EXPECT_EQ(more.nodes, one.nodes);
    ASSERT_EQ(more.classes.size(), one.classes.size());
    for (std::size_t i = 0; i < one.classes.size(); ++i)
      EXPECT_EQ(more.classes[i].canonical, one.classes[i].canonical);
  }
}

TEST(Triangulations, ALimitedRunIsALowerBound) {
  const complex::Cell cell = *cell_named("hexahedron");
  const std::uint64_t whole = balls::triangulations(cell, {}).total().labelled;
  const Census limited = balls::triangulations(cell, {.max_nodes = 1000});
  EXPECT_FALSE(limited.exhaustive);
  EXPECT_LT(limited.total().labelled, whole);
  const std::atomic<bool> stop{true};
  const Census stopped = balls::triangulations(cell, {.stop = &stop});
  EXPECT_FALSE(stopped.exhaustive);
  EXPECT_EQ(stopped.total().classes, 0U);
}

TEST(Triangulations, CountsAloneAreTheSame) {
  const complex::Cell cell = *cell_named("prism");
  const Census kept = balls::triangulations(cell, {.interior = 1});
  const Census counted = balls::triangulations(cell, {.interior = 1, .keep_classes = false});
  EXPECT_EQ(kept.by_tetrahedra, counted.by_tetrahedra);
  EXPECT_TRUE(counted.classes.empty());
}

}  // namespace
