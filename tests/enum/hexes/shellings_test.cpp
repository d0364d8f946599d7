// Claim. The census of shellable balls is complete and without repetition; words decide
// isomorphism; lists are shellings.
// Oracle. Counts of an independent program; flips of fronts with whole meshes told apart by nauty,
// and the exhaustive search for all meshes of small boundaries, neither of which shares code with
// the census; hexahedra met as sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "enum/canon/nauty/hex_symmetry.hpp"
#include "enum/core/errors.hpp"
#include "enum/hexes/shellings.hpp"
#include "enum/quads/generate.hpp"
#include "tests/counts/known_counts.hpp"
#include "tests/enum/hexes/found_meshes.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using hexes::Corners;
using hexes::SmallBall;

constexpr int kMost = support::by_length(5, 7);

using Certificate = std::vector<std::uint64_t>;

hexes::ShellingCensus census(int hexahedra) {
  return hexes::shellable_balls({.hexahedra = hexahedra});
}

std::vector<oracle::Cell> cells_of(const SmallBall& ball) {
  std::vector<oracle::Cell> cells;
  for (const Corners& cell : ball.cells()) {
    oracle::Cell wide{};
    std::copy(cell.begin(), cell.end(), wide.begin());
    cells.push_back(wide);
  }
  return cells;
}

SmallBall ball_of(const complex::HexComplex& mesh) {
  std::vector<Corners> cells;
  for (const auto& hexahedron : mesh.hexahedra) {
    Corners cell{};
    for (std::size_t i = 0; i < cell.size(); ++i)
      cell[i] = static_cast<hexes::Vertex>(hexahedron[i]);
    cells.push_back(cell);
  }
  return SmallBall(cells);
}

/// What is compared of a class, by its certificate.
struct Traits {
  std::uint64_t automorphisms = 0;
  canon::Code boundary;
  friend bool operator==(const Traits&, const Traits&) = default;
};

/// The classes of shellable balls with so many hexahedra: breadth-first search by flips.
std::map<Certificate, Traits> classes_by_flips(int hexahedra) {
  const auto form = [](const flips::Shelling& shelling) {
    return canon::graph_form(support::mesh_of(support::cells_of(shelling)));
  };
  std::map<Certificate, flips::Shelling> level{{form(flips::Shelling()).certificate, {}}};
  for (int h = 1; h < hexahedra; ++h) {
    std::map<Certificate, flips::Shelling> next;
    for (auto& entry : level) {
      flips::Shelling& shelling = entry.second;
      for (const flips::Flip flip :
           support::candidate_flips(shelling.front().boundary, flips::kMaxFrontQuads)) {
        if (!shelling.push(flip)) continue;
        next.emplace(form(shelling).certificate, shelling);
        shelling.pop();
      }
    }
    level = std::move(next);
  }
  std::map<Certificate, Traits> result;
  for (const auto& [certificate, shelling] : level)
    result[certificate] = {form(shelling).automorphisms,
                           canon::canonical_form(shelling.front().boundary).code};
  return result;
}

TEST(Shellings, AreAsManyAsKnown) {
  const auto found = census(kMost);
  EXPECT_TRUE(found.exhaustive);
  std::map<int, std::uint64_t> meshes, boundaries;
  for (const auto& counts : found.by_hexahedra) {
    meshes[counts.hexahedra] = counts.meshes;
    boundaries[counts.hexahedra] = counts.boundaries;
    EXPECT_EQ(counts.unshellable_rests, 0U);
  }
  EXPECT_EQ(meshes, counts::known("shellable_meshes", 1, kMost));
  EXPECT_EQ(boundaries, counts::known("boundaries_of_shellable_meshes", 1, kMost));
  const std::vector<std::uint64_t> new_boundaries{1, 1, 3, 12, 57, 415};
  for (std::size_t i = 0; i < std::min(new_boundaries.size(), found.by_hexahedra.size()); ++i)
    EXPECT_EQ(found.by_hexahedra[i].new_boundaries, new_boundaries[i]);
  EXPECT_EQ(found.classes.size(), found.by_hexahedra.back().meshes);
}

TEST(Shellings, AreTheClassesThatFlipsFind) {
  for (int h = kMost == 5 ? 1 : kMost; h <= kMost; ++h) {
    std::map<Certificate, Traits> found;
    for (const auto& entry : census(h).classes) {
      const SmallBall ball = hexes::ball_of(entry.word, h);
      const Certificate certificate = canon::graph_form(complex_of(ball)).certificate;
      EXPECT_TRUE(
          found.emplace(certificate, Traits{entry.automorphisms, boundary_code(ball)}).second);
    }
    EXPECT_TRUE(found == classes_by_flips(h)) << h;
  }
}

TEST(Shellings, AreTheBallsThatExhaustiveSearchFinds) {
  const int hexahedra = kMost - 1, max_quads = 18;
  std::map<canon::Code, std::set<hexes::Word>> found, searched;
  for (const auto& entry : census(hexahedra).classes) {
    const canon::Code code = boundary_code(hexes::ball_of(entry.word, hexahedra));
    if (code.quads <= max_quads) found[code].insert(entry.word);
  }
  const auto search_all = [&](const complex::Quadrangulation& boundary, int, int) {
    hexes::HexSearch problem(boundary, support::limits_for(boundary, hexahedra));
    const auto result = search::explore(problem, {}, {}, [&](const hexes::HexSearch& at) {
      const auto mesh = hexes::complex_of(at.mesh());
      if (at.mesh().cells().size() == static_cast<std::size_t>(hexahedra) &&
          !complex::validate(mesh) && complex::shelling_of(mesh))
        searched[canon::canonical_form(boundary).code].insert(canonical_word(ball_of(mesh)).word);
      return true;
    });
    EXPECT_TRUE(result.is_proof());
  };
  for (int n = 6; n <= max_quads; n += 2)
    static_cast<void>(quads::generate(quads::Class::three_connected, n, search_all));
  EXPECT_TRUE(found == searched);
  EXPECT_FALSE(found.empty());
}

TEST(Shellings, AreListedAsShellings) {
  const int hexahedra = std::min(kMost, 6);
  const auto found = census(hexahedra);
  std::istringstream lines(hexes::shellings_text(found, 2));
  std::string word;
  std::size_t version = 0, said = 0, count = 0;
  lines >> word >> version >> said >> count;
  EXPECT_EQ(word, "shellings");
  EXPECT_EQ(version, 1U);
  EXPECT_EQ(said, static_cast<std::size_t>(hexahedra));
  ASSERT_EQ(count, found.classes.size());
  for (const auto& entry : found.classes) {
    std::string code;
    std::uint32_t automorphisms = 0;
    std::vector<oracle::Cell> cells(said);
    lines >> code >> automorphisms;
    for (auto& cell : cells)
      for (auto& v : cell) lines >> v;
    ASSERT_TRUE(lines);
    EXPECT_EQ(automorphisms, entry.automorphisms);
    EXPECT_TRUE(oracle::obeys_strict_rule(cells) && oracle::is_shelling(cells));
    const auto mesh = support::mesh_of(cells);
    EXPECT_FALSE(complex::validate(mesh).has_value());
    EXPECT_EQ(canonical_word(ball_of(mesh)).word, entry.word);
    EXPECT_EQ(canon::to_text(boundary_code(ball_of(mesh))), code);
  }
}

TEST(Shellings, StopWithWhatIsFinished) {
  std::atomic<bool> stop{false};
  hexes::ShellingOptions options{.hexahedra = hexes::kMaxBallHexahedra, .stop = &stop};
  options.progress = [&](int hexahedra, std::size_t, std::size_t) { stop = hexahedra == 5; };
  const auto found = hexes::shellable_balls(options);
  EXPECT_FALSE(found.exhaustive);
  EXPECT_EQ(found.by_hexahedra.size(), 4U);
  EXPECT_EQ(found.classes.size(), 12U);
}

TEST(Shellings, RefuseWhatTheyCannotHold) {
  EXPECT_THROW(static_cast<void>(hexes::shellable_balls({.hexahedra = 5, .max_bytes = 1000})),
               core::ResourceFailure);
  for (const int hexahedra : {0, hexes::kMaxBallHexahedra + 1})
    EXPECT_THROW(static_cast<void>(census(hexahedra)), core::PreconditionViolated);
}

TEST(BallWord, IsThatOfIsomorphicBallsOnly) {
  support::Random random(20261);
  std::map<hexes::Word, Certificate> certificate_of;
  std::map<Certificate, hexes::Word> word_of;
  for (int trial = 0; trial < 300; ++trial) {
    const auto shelling = support::random_shelling(6, flips::kMaxFrontQuads, random);
    const auto mesh = support::mesh_of(support::cells_of(shelling));
    const auto form = canon::graph_form(mesh);
    const auto canonical = canonical_word(ball_of(mesh));
    const auto again = canonical_word(ball_of(support::scrambled(mesh, random, random.coin())));
    EXPECT_EQ(canonical.word, again.word);
    EXPECT_EQ(canonical.word, canonical_word(hexes::ball_of(canonical.word, 6)).word);
    EXPECT_EQ(static_cast<std::uint64_t>(canonical.automorphisms), form.automorphisms);
    EXPECT_EQ(certificate_of.emplace(canonical.word, form.certificate).first->second,
              form.certificate);
    EXPECT_EQ(word_of.emplace(form.certificate, canonical.word).first->second, canonical.word);
  }
  EXPECT_LT(certificate_of.size(), 300U);
}

/// Whether hexahedra other than c are a ball with c glued on it along a patch, by sets.
bool rest_is_ball(const std::vector<oracle::Cell>& cells, std::size_t c) {
  std::vector<oracle::Cell> rest = cells;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(c));
  std::map<std::uint32_t, std::uint32_t> number;
  for (auto& cell : rest)
    for (auto& v : cell) v = number.try_emplace(v, number.size()).first->second;
  const auto mesh = support::mesh_of(rest);
  return !complex::validate(mesh) && complex::shelling_of(mesh).has_value();
}

TEST(SmallBall, GivesOffWhatLeavesABall) {
  support::Random random(20262);
  int yes = 0, no = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const auto shelling =
        support::random_shelling(2 + random.below(8), flips::kMaxFrontQuads, random);
    const auto cells = support::cells_of(shelling);
    const SmallBall ball = ball_of(support::mesh_of(cells));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const bool expected = rest_is_ball(cells, c);
      EXPECT_EQ(is_removable(ball, c), expected);
      ++(expected ? yes : no);
    }
  }
  EXPECT_GT(yes, 100);
  EXPECT_GT(no, 100);
}

TEST(SmallBall, TakesWhatKeepsTheStrictRule) {
  support::Random random(20263);
  for (int trial = 0; trial < 40; ++trial) {
    const auto shelling =
        support::random_shelling(1 + random.below(7), flips::kMaxFrontQuads, random);
    auto by_flips = shelling;
    const SmallBall ball = ball_of(support::mesh_of(support::cells_of(shelling)));
    std::multiset<hexes::Word> expected, found;
    const auto& boundary = shelling.front().boundary;
    for (const flips::Flip flip : support::candidate_flips(boundary, flips::kMaxFrontQuads)) {
      if (!flips::is_preferred(boundary, flip) || !by_flips.push(flip)) continue;
      expected.insert(canonical_word(ball_of(support::mesh_of(support::cells_of(by_flips)))).word);
      by_flips.pop();
    }
    for (const auto& gluing : gluings(ball)) {
      SmallBall larger = ball;
      larger.glue(gluing);
      found.insert(canonical_word(larger).word);
      EXPECT_TRUE(oracle::obeys_strict_rule(cells_of(larger)));
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(CubeSymmetries, AreThe48MapsThatKeepEdges) {
  std::set<cells::CornerMap> all;
  for (cells::CubeSymmetry s = 0; s < cells::kCubeSymmetries; ++s) {
    const auto& map = cells::kCubeTables.corner[s];
    EXPECT_EQ(cells::symmetry_of(map), s);
    all.insert(map);
    for (unsigned v = 0; v < 8; ++v)
      for (unsigned k = 0; k < 3; ++k)
        EXPECT_EQ(std::popcount(static_cast<unsigned>(map[v] ^ map[v ^ 1U << k])), 1);
    for (unsigned f = 0; f < 6; ++f) {
      std::set<unsigned> image, facet;
      for (const auto corner : cells::kFacetVertices[f]) image.insert(map[corner]);
      for (const auto corner : cells::kFacetVertices[cells::kCubeTables.facet[s][f]])
        facet.insert(corner);
      EXPECT_EQ(image, facet);
    }
    for (cells::CubeSymmetry t = 0; t < cells::kCubeSymmetries; ++t)
      for (unsigned v = 0; v < 8; ++v)
        EXPECT_EQ(cells::kCubeTables.corner[cells::kCubeTables.after[s][t]][v],
                  map[cells::kCubeTables.corner[t][v]]);
  }
  EXPECT_EQ(all.size(), 48U);
  EXPECT_EQ(cells::kCubeTables.corner[0], (cells::CornerMap{0, 1, 2, 3, 4, 5, 6, 7}));
}

}  // namespace
