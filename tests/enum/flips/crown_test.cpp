// Crowns: against all hexahedra glued on around a vertex in all orders, images looked for among all
// maps of corners; and what a search finds with them.
#include "enum/flips/crown.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "enum/flips/symmetric_balls.hpp"
#include "tests/enum/flips/glued_steps.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas {
namespace {

using complex::Vertex;
using flips::SymmetricFront;
using flips::SymmetricState;

/// The quads at a vertex, counter-clockwise, by turning around it.
std::vector<std::set<int>> star_of(const complex::Quadrangulation& q, Vertex v) {
  std::vector<std::set<int>> star;
  complex::Dart first = 0;
  while (q.origin(first) != v) ++first;
  for (complex::Dart dart = first; star.empty() || dart != first; dart = q.turn_left(dart)) {
    const auto corners = q.vertices_of(complex::Quadrangulation::quad_of(dart));
    star.emplace_back(corners.begin(), corners.end());
  }
  return star;
}

/// The corner above v if the hexahedron stands with a facet on this quad, which v is in.
std::optional<int> above(const std::array<int, 8>& cell, const std::set<int>& quad, int v) {
  for (std::size_t axis = 1; axis < 8; axis *= 2)
    for (const std::size_t side : {std::size_t{0}, axis}) {
      std::set<int> facet;
      std::optional<int> top;
      for (std::size_t c = 0; c < 8; ++c) {
        if ((c & axis) != side) continue;
        facet.insert(cell[c]);
        if (cell[c] == v) top = cell[c ^ axis];
      }
      if (facet == quad) return top;
    }
  return std::nullopt;
}

/// More in a crown take the oracle, which tries all orders, too long.
constexpr std::size_t kMostTried = 6;

/// All states after hexahedra on the quads at a vertex, glued on in any order, with one new edge in
/// common, that the involution takes to each other.
class AllCrowns {
 public:
  AllCrowns(const SymmetricFront& from, int max_quads)
      : vertices_(from.front.boundary.vertices()), max_quads_(max_quads) {
    std::vector<int> name(static_cast<std::size_t>(vertices_));
    std::iota(name.begin(), name.end(), 0);
    std::map<int, int> image;
    for (int v = 0; v < vertices_; ++v) image[v] = from.image[static_cast<std::size_t>(v)];
    for (int v = 0; v < vertices_; ++v) {
      if (image[v] != v) continue;
      vertex_ = v;
      star_ = star_of(from.front.boundary, static_cast<Vertex>(v));
      if (star_.size() % 2 != 0 || star_.size() < 4 || star_.size() > kMostTried) continue;
      grow({from.front, name, {}}, image, {}, 0);
    }
  }
  [[nodiscard]] const std::set<SymmetricState>& states() const { return states_; }

 private:
  using Cells = std::map<std::size_t, std::array<int, 8>>;  ///< by the place of the quad below

  void grow(const support::Step& at, const std::map<int, int>& image, const Cells& cells, int end) {
    if (cells.size() == star_.size()) return support::add_state(at, image, max_quads_, states_);
    const int first_new = vertices_ + 4 * static_cast<int>(cells.size());
    for (const support::Step& next : support::all_steps(at.front, at.name, first_new))
      for (std::size_t i = 0; i < star_.size(); ++i) {
        const auto top = above(next.cell, star_[i], vertex_);
        if (!top || cells.contains(i) || (cells.empty() ? *top < vertices_ : *top != end)) continue;
        auto extended = std::optional(image);
        if (cells.empty()) extended->emplace(*top, *top);
        const auto other = cells.find((i + star_.size() / 2) % star_.size());
        if (other != cells.end()) extended = support::extension(image, other->second, next.cell);
        if (!extended) continue;
        Cells with = cells;
        with.emplace(i, next.cell);
        grow(next, *extended, with, *top);
      }
  }

  int vertices_;
  int max_quads_;
  int vertex_ = 0;
  std::vector<std::set<int>> star_;
  std::set<SymmetricState> states_;
};

std::vector<flips::GluedOrbit> crowns_of(const SymmetricFront& front, int max_quads) {
  std::vector<flips::GluedOrbit> result;
  flips::for_each_glueable_crown(front, max_quads,
                                 [&](const auto& each) { result.push_back(each); });
  return result;
}

TEST(Crowns, AreTheHexahedraAroundANewEdgeThatAHalfTurnExchanges) {
  support::Random random(72);
  std::map<int, int> of_size;
  for (const char* text : {"q1:08a5df", "q1:088a577f", "q1:088a2a5ddf7f", "q1:02228a5d777f",
                           "q1:08888a5577ff", "q1:02228a2a5777df7f", "q1:0888888a55577fff"}) {
    const auto q = support::boundary_of(text);
    const auto involutions = flips::involutions_of(q);
    for (std::size_t walk = 0; walk < 3 * involutions.size(); ++walk) {
      const flips::Involution& involution = involutions[walk / 3];
      SymmetricFront front{{q, flips::relation_of_quads(q)}, involution.image};
      for (int step = 0; step < 5; ++step) {
        const int max_quads = q.quads() + 16;
        std::set<SymmetricState> states, small;
        std::vector<flips::GluedOrbit> found = crowns_of(front, max_quads);
        for (const flips::GluedOrbit& crown : found) {
          const SymmetricState state = flips::canonical_state(crown.made).state;
          states.insert(state);
          if (crown.orbit.size <= kMostTried) small.insert(state);
          EXPECT_EQ(flips::glued(front, crown.orbit).former, crown.former);
          EXPECT_EQ(flips::glued(front, crown.orbit).cell, crown.cell);
          ++of_size[crown.orbit.size];
          EXPECT_FALSE(involution.is_mirrored);
        }
        EXPECT_EQ(small, AllCrowns(front, max_quads).states()) << text << ' ' << step;
        std::set<SymmetricState> renumbered;
        const SymmetricFront canonical = flips::front_of(flips::canonical_state(front).state);
        for (const flips::GluedOrbit& crown : crowns_of(canonical, max_quads))
          renumbered.insert(flips::canonical_state(crown.made).state);
        EXPECT_EQ(states, renumbered) << text << ' ' << step;
        flips::for_each_glueable_orbit(front, max_quads,
                                       [&](const auto& each) { found.push_back(each); });
        if (found.empty()) break;
        front = found[random.below(found.size())].made;
      }
    }
  }
  EXPECT_GT(of_size[4], 20);
  EXPECT_GT(of_size[6], 0);
  EXPECT_GT(of_size[8], 0);
}

TEST(Crowns, AreNoneWithoutAHalfTurnThatFixesAVertex) {
  const auto q = support::boundary_of("q1:02228a2a5777df7f");
  EXPECT_TRUE(crowns_of(flips::front_without_symmetry(q, {}), 40).empty());
  int without = 0;
  for (const flips::Involution& involution : flips::involutions_of(q)) {
    bool fixes = false;
    for (int v = 0; v < q.vertices(); ++v)
      fixes = fixes || involution.image[static_cast<std::size_t>(v)] == v;
    if (fixes && !involution.is_mirrored) continue;
    ++without;
    EXPECT_TRUE(crowns_of({{q, flips::relation_of_quads(q)}, involution.image}, 40).empty());
  }
  EXPECT_EQ(without, 2);
}

// Without crowns, and six hexahedra around an edge to begin with, the least found so has 40.
TEST(Crowns, LeadToTheMeshesOfSchneidersPyramid) {
  const auto q = support::boundary_of("q1:02228a2a5777df7f");
  flips::BeamOptions options;
  options.max_quads = 30;
  options.fronts_per_class = options.fronts_per_level = 300;
  const flips::SymmetricBalls balls(options, 20);
  std::optional<int> least;
  for (const SymmetricFront& start : flips::symmetric_fronts(q, {})) {
    flips::SymmetricBeam collars({flips::start_of_collars(start)}, flips::Growth::inward, options);
    while (collars.level() <= 18) {
      const auto fit = balls.least_fit(collars.nodes(), least.value_or(100), 1);
      if (fit) least = fit->hexahedra;
      if (!collars.expand_level()) break;
    }
  }
  EXPECT_EQ(least, 36);
}

}  // namespace
}  // namespace hexatlas
