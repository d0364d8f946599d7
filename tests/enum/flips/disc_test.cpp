// Claim. discs() gives each quadrangulation of the disc without two edges of the same ends exactly
// once, whatever the numbers of the interior vertices; what else it gives are such discs as well,
// none twice.
// Oracle. All ways to sew quads and the outside of the circle together edge by edge, in no regard
// of what they enclose; those are kept whose vertices, counted as orbits, are those of a disc.
// Beyond its reach the laws from scratch, the symmetry of the circle, and classical counts.
#include "enum/flips/disc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "tests/oracles/hexahedra.hpp"

namespace {

using namespace hexatlas;
using Sets = std::vector<oracle::Cycle>;  ///< each quad from its least vertex on, in order

/// The least list of quads over all numberings of the interior vertices.
Sets canonical(const Sets& quads, std::uint32_t length, std::uint32_t interior) {
  std::vector<std::uint32_t> name(length + interior);
  std::iota(name.begin(), name.end(), 0U);
  Sets least;
  do {
    Sets renamed;
    for (oracle::Cycle quad : quads) {
      for (auto& v : quad) v = name[v];
      renamed.push_back(oracle::rotated(quad));
    }
    std::sort(renamed.begin(), renamed.end());
    if (least.empty() || renamed < least) least = std::move(renamed);
  } while (std::next_permutation(name.begin() + length, name.end()));
  return least;
}

std::multiset<Sets> given(int length, int interior) {
  std::multiset<Sets> result;
  for (const flips::Disc& disc : flips::discs(length, interior)) {
    Sets quads;
    for (const auto& q : disc) quads.push_back({q[0], q[1], q[2], q[3]});
    result.insert(
        canonical(quads, static_cast<std::uint32_t>(length), static_cast<std::uint32_t>(interior)));
  }
  return result;
}

/// How often a quad runs from one vertex to another.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const Sets& quads) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& quad : quads)
    for (std::size_t i = 0; i < 4; ++i) ++edges[{quad[i], quad[(i + 1) % 4]}];
  return edges;
}

bool is_simple(const Sets& quads, std::uint32_t length) {
  const auto edges = edges_of(quads);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto [from, to] = edge.first;
    const bool goes_back = from < length && to == (from + length - 1) % length;
    return edge.second == 1 && !goes_back;
  });
}

/// Sews darts in pairs. The circle's darts come first, seen from outside: dart k runs from k + 1 to
/// k. Each new quad is sewn on by its first dart, so each disc comes up once.
class Sewing {
 public:
  Sewing(int length, int interior)
      : length_(length), quads_(length / 2 - 1 + interior), interior_(interior) {
    for (int k = 0; k < length; ++k) add_dart(k % 2);
    sew(0);
  }
  [[nodiscard]] const std::multiset<Sets>& result() const { return result_; }

 private:
  static constexpr int kFree = -1;

  void add_dart(int colour) {
    twin_.push_back(kFree);
    colour_.push_back(colour);  // of the origin: a disc is bipartite
  }
  [[nodiscard]] int darts() const { return static_cast<int>(twin_.size()); }
  [[nodiscard]] int next(int d) const {
    if (d < length_) return (d + length_ - 1) % length_;
    return (d - length_) % 4 == 3 ? d - 3 : d + 1;
  }
  int& twin(int d) { return twin_[static_cast<std::size_t>(d)]; }
  [[nodiscard]] int colour(int d) const { return colour_[static_cast<std::size_t>(d)]; }

  void sew(int from) {
    while (from < darts() && twin(from) != kFree) ++from;
    if (from == darts()) {
      if (darts() == length_ + 4 * quads_) keep();
      return;
    }
    for (int other = std::max(from + 1, length_); other < darts(); ++other) {
      if (twin(other) != kFree || colour(other) == colour(from)) continue;
      link(from, other);
      sew(from + 1);
      unlink(from, other);
    }
    if (darts() == length_ + 4 * quads_) return;
    const int first = darts();
    for (int i = 0; i < 4; ++i) add_dart((1 - colour(from) + i) % 2);
    link(from, first);
    sew(from + 1);
    unlink(from, first);
    twin_.resize(static_cast<std::size_t>(first));
    colour_.resize(static_cast<std::size_t>(first));
  }
  void link(int d, int e) {
    twin(d) = e;
    twin(e) = d;
  }
  void unlink(int d, int e) { twin(d) = twin(e) = kFree; }

  /// Euler's count makes it a sphere; the circle's vertices must differ, and those of each quad.
  void keep() {
    std::vector<int> vertex(twin_.size(), kFree);
    int count = 0;
    const auto number_around = [&](int d, int v) {
      for (; vertex[static_cast<std::size_t>(d)] == kFree; d = next(twin(d)))
        vertex[static_cast<std::size_t>(d)] = v;
    };
    for (int k = 0; k < length_; ++k) {
      if (vertex[static_cast<std::size_t>(k)] != kFree) return;
      number_around(k, (k + 1) % length_);
    }
    for (int d = length_; d < darts(); ++d)
      if (vertex[static_cast<std::size_t>(d)] == kFree) {
        if (count == interior_) return;
        number_around(d, length_ + count++);
      }
    if (count != interior_) return;
    Sets quads;
    for (int q = 0; q < quads_; ++q) {
      oracle::Cycle quad{};
      for (std::size_t i = 0; i < 4; ++i)
        quad[i] = static_cast<std::uint32_t>(vertex[static_cast<std::size_t>(length_ + 4 * q) + i]);
      if (oracle::Face(quad.begin(), quad.end()).size() != 4) return;
      quads.push_back(quad);
    }
    result_.insert(canonical(quads, static_cast<std::uint32_t>(length_),
                             static_cast<std::uint32_t>(interior_)));
  }

  int length_, quads_, interior_;
  std::vector<int> twin_, colour_;
  std::multiset<Sets> result_;
};

/// The first law of a disc that a simple list of quads breaks; empty if none.
std::string fault(const Sets& quads, std::uint32_t length, std::uint32_t interior) {
  const auto edges = edges_of(quads);
  std::size_t twice = 0;  // darts on the circle or with a quad behind them
  for (const auto& [edge, count] : edges) {
    const auto [from, to] = edge;
    const bool on_circle = from < length && to == (from + 1) % length;
    if (on_circle == edges.contains({to, from})) return "an edge is sewn wrongly";
    twice += on_circle ? 2 : 1;
  }
  for (std::uint32_t v = 0; v < length; ++v)
    if (!edges.contains({v, (v + 1) % length})) return "the circle is not covered";
  if (length + interior + quads.size() != twice / 2 + 1) return "Euler's count is wrong";
  for (std::uint32_t v = 0; v < length + interior; ++v) {
    std::map<std::uint32_t, std::uint32_t> around;  // the link, counter-clockwise
    for (const auto& quad : quads)
      for (std::size_t i = 0; i < 4; ++i)
        if (quad[i] == v) around[quad[(i + 1) % 4]] = quad[(i + 3) % 4];
    if (around.empty()) return "a vertex is in no quad";
    const std::uint32_t first = v < length ? (v + 1) % length : around.begin()->first;
    const std::uint32_t last = v < length ? (v + length - 1) % length : first;
    std::size_t steps = 0;
    std::uint32_t at = first;
    do {
      if (!around.contains(at)) return "a link breaks off";
      at = around[at];
      ++steps;
    } while (at != last && steps <= around.size());
    if (steps != around.size()) return "a link falls apart";
  }
  return "";
}

TEST(Disc, EachComesOnce) {
  for (const auto& [length, interior] :
       {std::pair(4, 0), {4, 1}, {4, 2}, {4, 3}, {6, 0}, {6, 1}, {6, 2}, {8, 0}, {8, 1}, {10, 0}}) {
    SCOPED_TRACE(::testing::Message() << length << " edges, " << interior << " vertices inside");
    const auto expected = Sewing(length, interior).result();
    const auto actual = given(length, interior);
    for (const Sets& disc : expected)
      if (is_simple(disc, static_cast<std::uint32_t>(length))) {
        EXPECT_EQ(actual.count(disc), 1U);
      }
    for (const Sets& disc : actual) EXPECT_LE(actual.count(disc), expected.count(disc));
  }
}

TEST(Disc, SimpleOnesObeyTheLawsAndTheSymmetryOfTheCircle) {
  // The search begins at one edge of the circle; none is missing only if every turn of the circle
  // and its mirror image leave the whole set as it is.
  for (const auto& [length, interior] : {std::pair(4U, 4U), {6U, 3U}, {8U, 2U}, {10U, 1U}}) {
    SCOPED_TRACE(::testing::Message() << length << " edges, " << interior << " vertices inside");
    std::set<Sets> simple;
    for (const Sets& disc : given(static_cast<int>(length), static_cast<int>(interior))) {
      if (!is_simple(disc, length)) continue;
      ASSERT_EQ(disc.size(), length / 2 - 1 + interior);
      ASSERT_EQ(fault(disc, length, interior), "");
      ASSERT_TRUE(simple.insert(disc).second) << "twice";
    }
    for (const Sets& disc : simple) {
      Sets turned = disc, mirrored = disc;
      for (auto& quad : turned)
        for (auto& v : quad) v = v < length ? (v + 1) % length : v;
      for (auto& quad : mirrored) {
        std::reverse(quad.begin(), quad.end());
        for (auto& v : quad) v = v < length ? length - 1 - v : v;
      }
      ASSERT_TRUE(simple.contains(canonical(turned, length, interior)));
      ASSERT_TRUE(simple.contains(canonical(mirrored, length, interior)));
    }
  }
}

TEST(Disc, ClassicalCounts) {
  // Without vertices inside: ternary trees. With four edges: simple quadrangulations of the sphere
  // with a root, as many as nonseparable maps with a root (Tutte, 1963).
  const auto simple = [](int length, int interior) {
    const auto all = given(length, interior);
    return std::count_if(all.begin(), all.end(), [&](const Sets& disc) {
      return is_simple(disc, static_cast<std::uint32_t>(length));
    });
  };
  for (const auto& [length, count] : {std::pair(4, 1U), {6, 3U}, {8, 12U}, {10, 55U}, {12, 273U}})
    EXPECT_EQ(flips::discs(length, 0).size(), count);
  for (const auto& [interior, count] : {std::pair(0, 1), {1, 2}, {2, 6}, {3, 22}, {4, 91}})
    EXPECT_EQ(simple(4, interior), count);
}

TEST(Disc, NeedsAnEvenCircle) {
  EXPECT_THROW((void)flips::discs(2, 1), core::PreconditionViolated);
  EXPECT_THROW((void)flips::discs(5, 1), core::PreconditionViolated);
  EXPECT_THROW((void)flips::discs(4, -1), core::PreconditionViolated);
}

}  // namespace
