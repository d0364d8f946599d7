// Claim. A flip replaces exactly the quads of its patch by the rest of the hexahedron's, its
// inverse undoes it, and each patch has exactly one preferred name. Oracle. Lists of quads as
// vertex cycles, in which the patch is found by searching the edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "enum/flips/quad_flip.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;
using flips::Flip;
using oracle::Cycle;

constexpr std::uint32_t kUnknown = 0xFFFF;
constexpr std::uint32_t kFirstNew = 1000;  ///< names of top vertices that the flip makes

std::set<Cycle> quads_of(const Quadrangulation& q) {
  std::set<Cycle> result;
  for (const auto& quad : q.list_of_quads()) result.insert(support::cycle(quad));
  return result;
}

/// The hexahedron of a flip and the sets of quads before and after, by vertices alone.
struct Expected {
  std::array<std::uint32_t, 4> top{};
  std::set<Cycle> consumed;
  std::set<Cycle> after;
};

std::optional<Expected> expected_of(const Quadrangulation& q, Flip flip) {
  Expected result;
  result.top.fill(kUnknown);
  const auto b = q.vertices_of(flip.bottom);
  result.consumed.insert(support::cycle(b));
  for (std::size_t i = 0; i < 4; ++i) {
    if ((flip.sides >> i & 1U) == 0) continue;
    const std::size_t j = (i + 1) % 4;
    for (const auto& quad : q.list_of_quads())
      for (std::size_t k = 0; k < 4; ++k) {
        if (quad[k] != b[j] || quad[(k + 1) % 4] != b[i]) continue;
        for (const auto& [at, v] :
             {std::pair(i, quad[(k + 2) % 4]), std::pair(j, quad[(k + 3) % 4])}) {
          if (result.top[at] != kUnknown && result.top[at] != v) return std::nullopt;
          result.top[at] = v;
        }
        result.consumed.insert(support::cycle(quad));
      }
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (result.top[i] == kUnknown) result.top[i] = kFirstNew + static_cast<std::uint32_t>(i);
  std::set<std::uint32_t> all(result.top.begin(), result.top.end());
  all.insert(b.begin(), b.end());
  if (all.size() != 8) return std::nullopt;
  result.after = quads_of(q);
  for (const Cycle& quad : result.consumed) result.after.erase(quad);
  for (std::size_t i = 0; i < 4; ++i)
    if ((flip.sides >> i & 1U) == 0) {
      const std::size_t j = (i + 1) % 4;
      result.after.insert(oracle::rotated({b[i], b[j], result.top[j], result.top[i]}));
    }
  result.after.insert(oracle::rotated(result.top));
  return result;
}

/// Names of the vertices of the result: their former ones, or those of `fresh` for new ones.
std::vector<std::uint32_t> names_after(const flips::Flipped& made,
                                       const std::array<std::uint32_t, 4>& fresh) {
  std::vector<std::uint32_t> name(static_cast<std::size_t>(made.quadrangulation.vertices()));
  for (std::size_t v = 0; v < name.size(); ++v) name[v] = made.former[v];
  for (std::size_t i = 0; i < 4; ++i)
    if (name[made.top[i]] == flips::kNewVertex) name[made.top[i]] = fresh[i];
  return name;
}

std::set<Cycle> named(const Quadrangulation& q, const std::vector<std::uint32_t>& name) {
  std::set<Cycle> result;
  for (const auto& quad : q.list_of_quads())
    result.insert(oracle::rotated({name[quad[0]], name[quad[1]], name[quad[2]], name[quad[3]]}));
  return result;
}

void expect_flip(const Quadrangulation& q, Flip flip) {
  const auto expected = expected_of(q, flip);
  const auto prism = flips::prism_of(q, flip);
  ASSERT_EQ(prism.has_value(), expected.has_value());
  if (!prism) return;
  EXPECT_EQ(prism->bottom, q.vertices_of(flip.bottom));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(prism->top[i], expected->top[i] >= kFirstNew ? flips::kNewVertex : expected->top[i]);
  const int after = q.quads() + 6 - 2 * flip.consumed();
  if (after < 6 || after > complex::kMaxQuads) return;

  const auto made = flips::flipped(q, flip, *prism);
  ASSERT_EQ(made.quadrangulation.quads(), after);
  ASSERT_FALSE(made.quadrangulation.validate()) << made.quadrangulation.validate()->reason;
  const auto names = names_after(made, expected->top);
  EXPECT_EQ(named(made.quadrangulation, names), expected->after);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(names[made.top[i]], expected->top[i]);

  const auto back_prism = flips::prism_of(made.quadrangulation, made.inverse);
  ASSERT_TRUE(back_prism.has_value());
  EXPECT_EQ(made.inverse.consumed(), 6 - flip.consumed());
  const auto back = flips::flipped(made.quadrangulation, made.inverse, *back_prism);
  std::array<std::uint32_t, 4> bottom{};
  std::copy(prism->bottom.begin(), prism->bottom.end(), bottom.begin());
  std::vector<std::uint32_t> composed = names_after(back, bottom);
  for (std::size_t v = 0; v < composed.size(); ++v)
    if (back.former[v] != flips::kNewVertex) composed[v] = names[back.former[v]];
  EXPECT_EQ(named(back.quadrangulation, composed), quads_of(q));
  EXPECT_EQ(canon::canonical_form(back.quadrangulation).code, canon::canonical_form(q).code);
}

TEST(Flip, ReplacesThePatchAndIsUndoneByItsInverse) {
  // All names, patches or not, in 3-connected quadrangulations met on random walks.
  support::Random random(29);
  for (int walk = 0; walk < support::share_of(12); ++walk) {
    Quadrangulation q = Quadrangulation::cube();
    for (int step = 0; step < 25; ++step) {
      for (int bottom = 0; bottom < q.quads(); ++bottom)
        for (unsigned sides = 0; sides < flips::kSideSets; ++sides)
          expect_flip(q, {static_cast<complex::Quad>(bottom), static_cast<std::uint8_t>(sides)});
      if (HasFailure()) return;
      auto flips = support::candidate_flips(q, 40);
      random.shuffle(flips);
      for (const Flip flip : flips) {
        const auto next = flips::flipped(q, flip, *flips::prism_of(q, flip)).quadrangulation;
        if (!next.is_three_connected()) continue;
        q = next;
        break;
      }
    }
  }
}

TEST(Flip, EachPatchHasOnePreferredName) {
  support::Random random(31);
  for (int walk = 0; walk < 60; ++walk) {
    const auto q = support::random_shelling(1 + static_cast<std::size_t>(walk) / 2, 50, random)
                       .front()
                       .boundary;
    std::map<std::set<Cycle>, int> preferred;
    for (const Flip flip : support::candidate_flips(q, 62)) {
      const auto expected = expected_of(q, flip);
      ASSERT_TRUE(expected.has_value());
      preferred[expected->consumed] += flips::is_preferred(q, flip) ? 1 : 0;
    }
    for (const auto& [patch, names] : preferred) EXPECT_EQ(names, 1) << patch.size() << " quads";
  }
}

TEST(Flip, KindsFollowTheShapeOfThePatch) {
  // Of the sides of a bottom: how many, and whether two are opposite.
  using flips::FlipKind;
  const std::map<unsigned, FlipKind> kinds{
      {0b0000, FlipKind::k1to5},        {0b0001, FlipKind::k2to4},
      {0b1000, FlipKind::k2to4},        {0b0011, FlipKind::k3to3_corner},
      {0b1001, FlipKind::k3to3_corner}, {0b0101, FlipKind::k3to3_strip},
      {0b1010, FlipKind::k3to3_strip},  {0b0111, FlipKind::k4to2},
      {0b1101, FlipKind::k4to2},        {0b1111, FlipKind::k5to1}};
  for (const auto& [sides, kind] : kinds)
    EXPECT_EQ(flips::kind_of(Flip{0, static_cast<std::uint8_t>(sides)}), kind) << sides;
}

TEST(Flip, TenThousandStepsKeepTheLaws) {
  // Without regard to 3-connectedness: multiple edges and vertices of degree 2 occur.
  support::Random random(37);
  Quadrangulation q = Quadrangulation::cube();
  std::set<int> sizes;
  int not_simple = 0;
  for (int step = 0; step < 10'000; ++step) {
    auto flips = support::candidate_flips(q, 60);
    ASSERT_FALSE(flips.empty());
    const Flip flip = flips[random.below(flips.size())];
    const auto made = flips::flipped(q, flip, *flips::prism_of(q, flip));
    ASSERT_FALSE(made.quadrangulation.validate()) << made.quadrangulation.validate()->reason;
    const auto back_prism = flips::prism_of(made.quadrangulation, made.inverse);
    ASSERT_TRUE(back_prism.has_value());
    const auto back = flips::flipped(made.quadrangulation, made.inverse, *back_prism);
    ASSERT_EQ(canon::canonical_form(back.quadrangulation).code, canon::canonical_form(q).code);
    q = made.quadrangulation;
    sizes.insert(q.quads());
    not_simple += Quadrangulation::from_quads(q.list_of_quads()) ? 0 : 1;
  }
  EXPECT_GT(sizes.size(), 15U);
  EXPECT_GT(not_simple, 100);
}

}  // namespace
