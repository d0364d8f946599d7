// Claim. may_take() says yes exactly to the patches whose hexahedron the strict rule allows; take()
// changes cavity, degrees and related pairs as the hexahedron does, and put_back() undoes it
// exactly; what was taken off and a ball in the cavity are a mesh if and only if they have no scar
// in common. Oracle. flips::Front, a small value without twins kept in place, which has tests of
// its own; the same sequence replayed from the start; complex::validate() on the whole mesh.
#include "enum/flips/peeling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/front.hpp"
#include "enum/quads/generate.hpp"
#include "tests/enum/flips/peelings.hpp"
#include "tests/enum/support.hpp"
#include "tests/meshing/hexahedrize/spheres.hpp"

namespace {

using namespace hexatlas;
using complex::QuadSphere;
using flips::Flip;
using flips::Front;
using flips::Peeling;
using support::Choice;
using support::choices;
using support::peeling_of;
using support::Seen;
using support::seen;

complex::Quadrangulation small(const QuadSphere& sphere) {
  std::vector<complex::QuadVertices> quads;
  for (const auto& quad : sphere.quads) {
    quads.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) quads.back()[i] = static_cast<complex::Vertex>(quad[i]);
  }
  return complex::Quadrangulation::from_quads(quads).value();
}

std::uint8_t turned(unsigned sides, unsigned by) {
  return static_cast<std::uint8_t>((sides << by | sides >> (4 - by)) & 15U);
}

/// A peeling and the front of its collar, side by side. The front has numbers of its own.
class Pair {
 public:
  explicit Pair(const QuadSphere& sphere)
      : peeling_(peeling_of(sphere)), front_{small(sphere), {}} {
    front_.related = flips::relation_of_quads(front_.boundary);
    for (std::uint32_t v = 0; v < sphere.vertices(); ++v) name_.push_back(v);
  }

  [[nodiscard]] const Peeling& peeling() const { return peeling_; }
  [[nodiscard]] int quads() const { return front_.boundary.quads(); }

  /// The same quads, and the same pairs related.
  void expect_same() const {
    ASSERT_EQ(peeling_.quads(), static_cast<std::size_t>(quads()));
    for (int bottom = 0; bottom < quads(); ++bottom) ASSERT_TRUE(place_of(bottom));
    for (std::size_t a = 0; a < name_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_EQ(peeling_.are_related(name_[a], name_[b]), (front_.related[a] >> b & 1U) != 0);
  }

  /// Compares what may be taken at all bottoms; gives how often the answer was yes and no.
  void expect_same_choices(std::size_t& yes, std::size_t& no) const {
    for (int bottom = 0; bottom < quads(); ++bottom) {
      const Place place = place_of(bottom).value();
      for (std::uint8_t sides = 0; sides < flips::kSideSets; ++sides) {
        const Flip flip{static_cast<complex::Quad>(bottom), sides};
        const auto expected = flips::prism_of(front_.boundary, flip);
        const bool may = expected && flips::may_glue(front_, flip, *expected);
        Peeling::Prism prism;
        ASSERT_EQ(peeling_.may_take({place.quad, turned(sides, place.turn)}, prism), may);
        ++(may ? yes : no);
        if (may) expect_same_prism(*expected, prism, place.turn);
      }
    }
  }

  void take(Flip flip) {
    const Place place = place_of(flip.bottom).value();
    const auto glued = flips::glued(front_, flip, flips::prism_of(front_.boundary, flip).value());
    Peeling::Prism prism;
    const Peeling::Patch patch{place.quad, turned(flip.sides, place.turn)};
    ASSERT_TRUE(peeling_.may_take(patch, prism));
    peeling_.take(patch, prism);
    const auto& cell = peeling_.taken().back();
    const auto former = std::move(name_);
    front_ = glued.front;
    name_.assign(static_cast<std::size_t>(front_.boundary.vertices()), Peeling::kNoVertex);
    for (std::size_t v = 0; v < name_.size(); ++v)
      if (glued.flipped.former[v] != flips::kNewVertex) name_[v] = former[glued.flipped.former[v]];
    for (unsigned i = 0; i < 4; ++i)
      name_[glued.flipped.top[i]] = cell[cells::kCornerOfPrism[4 + (i + place.turn) % 4]];
  }

  [[nodiscard]] std::vector<Flip> flips_within(int most) const {
    std::vector<Flip> result;
    flips::for_each_glueable(
        front_, most, [&](Flip flip, const flips::Prism& /*prism*/) { result.push_back(flip); });
    return result;
  }

 private:
  /// Side i of the front's quad is side i + turn of the peeling's.
  struct Place {
    std::uint32_t quad = 0;
    unsigned turn = 0;
  };
  [[nodiscard]] std::optional<Place> place_of(int bottom) const {
    const auto vertices = front_.boundary.vertices_of(bottom);
    for (std::uint32_t q = 0; q < peeling_.quad_numbers(); ++q)
      for (unsigned turn = 0; turn < 4 && peeling_.is_live(q); ++turn) {
        bool same = true;
        for (unsigned i = 0; i < 4; ++i)
          same = same && peeling_.origin(4 * q + (i + turn) % 4) == name_[vertices[i]];
        if (same) return Place{q, turn};
      }
    return std::nullopt;
  }

  void expect_same_prism(const flips::Prism& expected, const Peeling::Prism& prism,
                         unsigned turn) const {
    for (unsigned i = 0; i < 4; ++i) {
      const auto top = expected.top[i];
      ASSERT_EQ(prism.bottom[(i + turn) % 4], name_[expected.bottom[i]]);
      ASSERT_EQ(prism.top[(i + turn) % 4],
                top == flips::kNewVertex ? Peeling::kNoVertex : name_[top]);
    }
  }

  Peeling peeling_;
  Front front_;
  std::vector<std::uint32_t> name_;  ///< in the peeling, of each vertex of the front
};

/// All of up to 12 quads, some regular ones and some random ones of up to 30.
std::vector<QuadSphere> small_spheres() {
  std::vector<QuadSphere> result;
  for (const int quads : {6, 8, 10, 12})
    quads::generate(quads::Class::three_connected, quads,
                    [&](const complex::Quadrangulation& q, int, int) {
                      result.push_back(support::sphere_of(q));
                    });
  result.push_back(support::grid_cube(2));
  for (const complex::VertexId k : {7U, 10U, 15U}) result.push_back(support::trapezohedron(k));
  for (const std::size_t inserted : {3U, 30U, 80U})
    for (const std::size_t quads : {24U, 27U, 30U})
      result.push_back(support::random_sphere(quads, quads + inserted, inserted));
  return result;
}

TEST(Peeling, TakesWhatTheFrontAllows) {
  support::Random random(61);
  std::size_t yes = 0, no = 0, steps = 0;
  for (const QuadSphere& sphere : small_spheres())
    for (int walk = 0; walk < 3; ++walk) {
      Pair pair(sphere);
      // Without room to grow the front gets crowded, and much is forbidden.
      const int most = pair.quads() + (walk == 0 ? 0 : walk == 1 ? 4 : 20);
      for (int step = 0; step < 16; ++step, ++steps) {
        pair.expect_same();
        support::expect_consistent(pair.peeling());
        pair.expect_same_choices(yes, no);
        if (HasFatalFailure()) return;
        const auto flips = pair.flips_within(std::min(most, flips::kMaxFrontQuads - 4));
        if (flips.empty()) break;
        pair.take(flips[random.below(flips.size())]);
      }
      pair.expect_same();
    }
  EXPECT_GT(steps, 700U);
  EXPECT_GT(yes, 50'000U);
  EXPECT_GT(no, 50'000U);
}

TEST(Peeling, PutBackUndoesExactly) {
  support::Random random(67);
  for (const auto& sphere : {support::random_sphere(30, 3), support::random_sphere(24, 4, 80),
                             support::trapezohedron(9), support::grid_cube(2)}) {
    Peeling peeling = peeling_of(sphere);
    std::vector<Choice> taken;
    std::vector<Seen> former{seen(peeling)};
    for (int step = 0; step < 250; ++step) {
      const bool back = !taken.empty() && random.below(5) < 2;
      const auto next = back ? std::vector<Choice>{} : choices(peeling, random.coin() ? 0 : 4);
      if (next.empty() && taken.empty()) continue;
      if (next.empty()) {
        peeling.put_back();
        taken.pop_back();
        former.pop_back();
      } else {
        taken.push_back(next[random.below(next.size())]);
        peeling.take(taken.back().patch, taken.back().prism);
        Peeling fresh = peeling_of(sphere);
        for (const Choice& choice : taken) fresh.take(choice.patch, choice.prism);
        former.push_back(seen(fresh));
      }
      ASSERT_EQ(seen(peeling), former.back()) << "step " << step;
    }
    EXPECT_GT(taken.size(), 10U);
    while (!peeling.taken().empty()) peeling.put_back();
    EXPECT_EQ(seen(peeling), former.front());
    EXPECT_THROW(peeling.put_back(), core::PreconditionViolated);
  }
}

TEST(Peeling, NumbersNewQuadsAndVerticesFromTheFormerNumbersOn) {
  support::Random random(71);
  Peeling peeling = peeling_of(support::random_sphere(24, 5));
  for (int step = 0; step < 60; ++step) {
    const Seen before = seen(peeling);
    const auto next = choices(peeling, step % 2 == 0 ? 4 : 0);
    if (next.empty()) continue;
    const Choice& choice = next[random.below(next.size())];
    peeling.take(choice.patch, choice.prism);
    const auto added =
        std::count(choice.prism.top.begin(), choice.prism.top.end(), Peeling::kNoVertex);
    EXPECT_EQ(peeling.vertices(), before.vertices + static_cast<std::uint32_t>(added));
    for (std::uint32_t q = before.quad_numbers; q < peeling.quad_numbers(); ++q)
      EXPECT_TRUE(peeling.is_live(q));
    EXPECT_EQ(static_cast<int>(peeling.quads()), static_cast<int>(before.quads) + choice.growth());
    // A hexahedron has six quads: those taken away, and those that are new.
    const auto consumed = 1U + static_cast<unsigned>(std::popcount(choice.patch.sides));
    EXPECT_EQ(peeling.quad_numbers(), before.quad_numbers + 6 - consumed);
  }
}

/// The pairs that hexahedra of both contain, and that lie in no quad of the sphere between them.
std::size_t common_scars(const Peeling& peeling, const complex::HexComplex& ball,
                         const std::vector<complex::BoundaryQuad>& sphere) {
  using Pairs = std::set<std::pair<complex::VertexId, complex::VertexId>>;
  const auto pairs_of = [](const auto& cells) {
    Pairs pairs;
    for (const auto& cell : cells)
      for (const auto u : cell)
        for (const auto v : cell)
          if (u < v) pairs.emplace(u, v);
    return pairs;
  };
  const Pairs in_quads = pairs_of(sphere);
  const Pairs in_ball = pairs_of(ball.hexahedra);
  return static_cast<std::size_t>(
      std::count_if(in_ball.begin(), in_ball.end(), [&](const auto& pair) {
        const bool is_outside = pair.second < 2 + sphere.size();
        return is_outside && !in_quads.contains(pair) &&
               peeling.are_related(pair.first, pair.second);
      }));
}

// The theorem is one of two sides of a sphere. Here the ball is the outer side, and hexahedra are
// taken off what lies around it: so there are balls with many scars to be met.
TEST(Peeling, AndABallOnTheOtherSideAreAMeshIfTheyShareNoScar) {
  support::Random random(73);
  std::size_t meshes = 0, refused = 0;
  for (int walk = 0; walk < 300; ++walk) {
    complex::HexComplex ball = support::mesh_of(
        support::cells_of(support::random_shelling(3 + random.below(12), 26, random)));
    std::set<complex::VertexId> outer;
    for (const auto& quad : complex::boundary_of(ball)) outer.insert(quad.begin(), quad.end());
    ball = complex::renumbered(ball, std::vector(outer.begin(), outer.end()));
    auto sphere = complex::boundary_of(ball);
    for (auto& quad : sphere) std::swap(quad[1], quad[3]);
    Peeling peeling(sphere, sphere.size() + 2);
    for (std::size_t step = 1 + random.below(8); step > 0; --step) {
      const auto next = choices(peeling, random.coin() ? 0 : 4);
      if (next.empty()) continue;
      const Choice& choice = next[random.below(next.size())];
      peeling.take(choice.patch, choice.prism);
    }
    complex::HexComplex mesh = ball;
    for (complex::Hexahedron cell : peeling.taken()) {
      for (auto& v : cell)
        if (v >= outer.size()) v += ball.vertices - static_cast<std::uint32_t>(outer.size());
      mesh.hexahedra.push_back(cell);
    }
    mesh.vertices += peeling.vertices() - static_cast<std::uint32_t>(outer.size());
    const bool fits = common_scars(peeling, ball, sphere) == 0;
    ASSERT_EQ(!complex::validate(mesh), fits);
    ++(fits ? meshes : refused);
    if (!fits) continue;
    EXPECT_EQ(complex::boundary_of(mesh).size(), peeling.quads());
    EXPECT_TRUE(complex::shelling_of(mesh).has_value());
  }
  EXPECT_GT(meshes, 50U);
  EXPECT_GT(refused, 50U);
}

}  // namespace
