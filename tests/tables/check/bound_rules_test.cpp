// Claim. No rule of a certificate refutes a state that has a mesh, whatever the order in which the
// mesh is built; the children of a branch have the hexahedron of the mesh; taking back restores.
// Oracle. Meshes of the shipped table, and complexes that are no balls, made of them by identifying
// vertices as long as the strict rule, tested by intersections, holds. In a mesh one knows which
// hexahedra and vertices are still to come. Hand-made states for what a rule does refute.
#include "tables/check/bound_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "tables/check/bound_partners.hpp"
#include "tables/check/bound_paths.hpp"
#include "tables/check/bound_sphere.hpp"
#include "tables/check/quad_code.hpp"
#include "tables/format/table.hpp"
#include "tests/oracles/hexahedra.hpp"
#include "tests/share.hpp"
#include "tests/shipped.hpp"

namespace hexatlas::check {
namespace {

using Cell = std::array<std::size_t, 8>;  ///< bottom, tops

struct KnownMesh {
  std::vector<Quad> quads;
  std::vector<Cell> cells;
  std::size_t vertices = 0;
};

std::set<std::size_t> set_of(const Cell& cell) { return {cell.begin(), cell.end()}; }

bool contains(const Cell& cell, std::size_t v) {
  return std::find(cell.begin(), cell.end(), v) != cell.end();
}

/// The corners by coordinates; from these back again, too.
template <class Index>
Cell exchanged(const std::array<Index, 8>& h) {
  return {h[0], h[1], h[3], h[2], h[4], h[5], h[7], h[6]};
}

std::optional<KnownMesh> mesh_of(const format::Table& table, std::size_t ordinal) {
  const format::TableEntry entry = table.entry(ordinal);
  const complex::HexComplex mesh = table.mesh(ordinal);
  if (mesh.vertices > kMostBoundVertices || mesh.hexahedra.size() > 64) return std::nullopt;
  KnownMesh known;
  known.vertices = mesh.vertices;
  for (const auto& h : mesh.hexahedra) {
    known.cells.push_back(exchanged(h));
  }
  for (const auto& quad : complex::boundary_of(mesh)) known.quads.push_back(quad);
  EXPECT_EQ(fault_of_boundary(known.quads, canon::to_text(entry.code)), "");
  return known;
}

/// Identifies pairs of vertices, at random, as long as the strict rule holds. Returns how many.
std::size_t pinch(KnownMesh& mesh, std::mt19937_64& random) {
  std::size_t pinched = 0;
  for (int round = 0; round < 400; ++round) {
    const std::size_t u = random() % mesh.vertices;
    const std::size_t v = random() % mesh.vertices;
    if (u == v || v < mesh.quads.size() + 2) continue;  // v goes, so it must be interior
    std::vector<Cell> cells = mesh.cells;
    bool holds = true;
    for (Cell& cell : cells) {
      std::replace(cell.begin(), cell.end(), v, u);
      holds = holds && set_of(cell).size() == 8;
      for (std::size_t& w : cell) w -= w > v ? 1 : 0;
    }
    const std::size_t at = u - (u > v ? 1 : 0);
    for (const Cell& a : cells) {
      for (const Cell& b : cells) {
        if (!holds || &a == &b || !contains(a, at)) continue;
        holds = oracle::meet_strictly(exchanged(a), exchanged(b));
      }
    }
    if (!holds) continue;
    mesh.cells = std::move(cells);
    --mesh.vertices;
    ++pinched;
  }
  return pinched;
}

/// Builds a known mesh in random order and asks the rules of each state.
class Walk {
 public:
  Walk(const KnownMesh& mesh, bool is_ball, std::uint64_t seed)
      : mesh_(mesh),
        random_(seed),
        state_(mesh.quads, is_ball),
        number_(mesh.vertices, 255),
        placed_(mesh.cells.size(), false) {
    for (std::size_t v = 0; v < mesh.quads.size() + 2; ++v) {
      number_[v] = static_cast<std::uint8_t>(v);
      named_.push_back(v);
    }
  }

  void run() {
    std::vector<int> rooms;
    for (auto left = static_cast<int>(mesh_.cells.size()); left > 0; --left) {
      expect_unrefuted(left);
      rooms.push_back(room_of(state_, left));
      const std::vector<std::uint16_t> open = state_.open_facets();
      put_on(open[random_() % open.size()], within_room(state_, interior(), left));
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_EQ(state_.open_count(), 0U);
    EXPECT_EQ(may_come(state_, interior()).all, 0);
    EXPECT_FALSE(has_bad_link(state_));
    state_.saturate(0);
    for (int left = 1; !rooms.empty(); ++left) {
      state_.take_back();
      if (saturated_.size() > 1) saturated_.pop_back();
      state_.saturate(saturated_.back());
      EXPECT_EQ(room_of(state_, left), rooms.back());
      rooms.pop_back();
    }
    EXPECT_EQ(state_.open_count(), mesh_.quads.size());
    EXPECT_EQ(state_.edges(), 2 * mesh_.quads.size());
    EXPECT_EQ(state_.vertices(), mesh_.quads.size() + 2);
  }

  /// Always on the first open facet. With `is_least` no state has an image that comes before it.
  std::vector<BoundCorners> path(const std::vector<BoundAutomorphism>& automorphisms,
                                 bool is_least) {
    std::vector<BoundCorners> tops;
    while (state_.open_count() > 0 && !testing::Test::HasFailure()) {
      put_on(state_.open_facets().front(), {static_cast<int>(mesh_.vertices - state_.vertices())});
      const BoundHexahedron& last = state_.hexahedra().back().vertices;
      tops.push_back({last[4], last[5], last[6], last[7]});
      EXPECT_FALSE(is_least && has_lesser_image(state_, automorphisms));
    }
    EXPECT_EQ(has_lesser_image(state_, automorphisms), !is_least);
    return tops;
  }

 private:
  /// The cell to come on an open facet.
  std::size_t cell_on(const BoundFacet& facet) {
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      const bool is_on =
          std::all_of(facet.corners.begin(), facet.corners.end(),
                      [&](std::uint8_t v) { return contains(mesh_.cells[c], named_[v]); });
      if (is_on && !placed_[c]) return c;
    }
    ADD_FAILURE() << "no cell on an open facet";
    return 0;
  }

  [[nodiscard]] int interior() const {
    return static_cast<int>(mesh_.vertices - state_.boundary_vertices());
  }

  void expect_unrefuted(int left) {
    if (state_.is_ball()) {
      const BoundPartners partners = partners_of(state_, may_come(state_, interior()));
      EXPECT_FALSE(partners.are_too_few);
      state_.saturate(partners.saturated);
    }
    saturated_.push_back(state_.saturated());
    EXPECT_FALSE(is_negative(within_room(state_, interior(), left)));
    EXPECT_FALSE(exceeds_face_budget(state_, left));
    EXPECT_GE(room_of(state_, left), static_cast<int>(mesh_.vertices - state_.vertices()));
    EXPECT_FALSE(has_bad_link(state_));
    std::map<std::size_t, std::vector<std::uint16_t>> by_cell;
    for (const std::uint16_t f : state_.open_facets()) {
      by_cell[cell_on(state_.facets()[f])].push_back(f);
    }
    for (const auto& [cell, facets] : by_cell) {
      for (const std::uint16_t f : facets) {
        for (const std::uint16_t g : facets) {
          if (f >= g) continue;
          const BoundFacet& a = state_.facets()[f];
          const BoundFacet& b = state_.facets()[g];
          EXPECT_FALSE(are_apart(state_, a, b));
          EXPECT_EQ(fit_across(state_, a, b), (a.vertices & b.vertices) != 0);
        }
      }
    }
  }

  void put_on(std::size_t number, const BoundNewVertices& most) {
    const BoundFacet facet = state_.facets()[number];
    const std::size_t c = cell_on(facet);
    const Cell& cell = mesh_.cells[c];
    BoundCorners tops{};
    for (unsigned i = 0; i < 4; ++i) {
      for (const std::size_t v : cell) {
        const bool is_corner = number_[v] < 64 && (facet.vertices >> number_[v] & 1U) != 0;
        if (is_corner || !oracle::is_edge(exchanged(cell), named_[facet.corners[i]], v)) continue;
        if (number_[v] == 255) {
          number_[v] = static_cast<std::uint8_t>(named_.size());
          named_.push_back(v);
        }
        tops[i] = number_[v];
      }
    }
    const std::vector<BoundCorners> children = state_.tops_on(number, most);
    EXPECT_TRUE(std::is_sorted(children.begin(), children.end()));
    EXPECT_EQ(std::count(children.begin(), children.end(), tops), 1);
    state_.put(number, tops);
    placed_[c] = true;
  }

  const KnownMesh& mesh_;
  std::mt19937_64 random_;
  BoundState state_;
  std::vector<std::uint8_t> number_;  ///< in the state, of each vertex of the mesh
  std::vector<std::size_t> named_;    ///< the other way round
  std::vector<bool> placed_;
  std::vector<VertexSet> saturated_;  ///< in each state
};

const format::Table& shipped() {
  static const format::Table table = format::Table::open(support::kShippedTable);
  return table;
}

/// Small boundaries first, then some of all sizes.
std::vector<KnownMesh> some_meshes(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<KnownMesh> found;
  for (std::size_t i = 0; found.size() < count; ++i) {
    const std::size_t ordinal = i < count / 2 ? i : random() % shipped().size();
    if (auto mesh = mesh_of(shipped(), ordinal)) found.push_back(std::move(*mesh));
  }
  return found;
}

TEST(BoundRules, NoStateOfAKnownBallIsRefuted) {
  std::uint64_t seed = 1;
  for (const KnownMesh& mesh : some_meshes(support::share_of(40), 1)) {
    Walk(mesh, true, ++seed).run();
    Walk(mesh, false, ++seed).run();
    if (HasFailure()) return;
  }
}

TEST(BoundRules, NoStateOfAPinchedComplexIsRefuted) {
  std::mt19937_64 random(2);
  std::size_t pinched = 0;
  for (KnownMesh& mesh : some_meshes(30, 2)) {
    const std::size_t own = pinch(mesh, random);
    pinched += own;
    if (own == 0) continue;
    for (int round = 0; round < 3; ++round) Walk(mesh, false, random()).run();
    if (HasFailure()) return;
  }
  EXPECT_GT(pinched, 20U);
}

/// Whatever the order of the facets, as long as it depends on nothing but the path.
TEST(BoundRules, JustTheLeastImageIsNotRefutedBySymmetry) {
  std::size_t symmetric = 0;
  std::size_t refuted = 0;
  for (const KnownMesh& mesh : some_meshes(support::share_of(300), 3)) {
    const std::vector<BoundAutomorphism> automorphisms = automorphisms_of(mesh.quads);
    EXPECT_EQ(automorphisms.size(), canonical_code(mesh.quads)->automorphisms);
    if (automorphisms.size() == 1) continue;
    ++symmetric;
    std::map<std::vector<BoundCorners>, KnownMesh> by_path;
    for (const BoundAutomorphism& map : automorphisms) {
      KnownMesh image = mesh;
      for (Cell& cell : image.cells) {
        for (std::size_t& v : cell) v = v < map.size() ? map[v] : v;
      }
      const auto path = Walk(image, true, 0).path({}, true);
      by_path.emplace(path, std::move(image));
    }
    bool is_least = true;
    for (const auto& [path, image] : by_path) {
      EXPECT_EQ(Walk(image, true, 0).path(automorphisms, is_least), path);
      if (HasFailure()) return;
      is_least = false;
    }
    refuted += by_path.size() - 1;
  }
  EXPECT_GT(symmetric, std::size_t{support::share_of(10)});
  EXPECT_GT(refuted, 10U);
}

/// The surface of the cube; vertex x + 2 y + 4 z.
std::vector<Quad> cube() {
  return {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
}

TEST(BoundRules, TheEmptyCube) {
  const std::vector<Quad> quads = cube();
  EXPECT_EQ(fault_of_boundary(quads, "q1:08a5df"), "");
  EXPECT_EQ(fault_of_boundary(quads, "q1:08a5de"), "the code of the boundary is q1:08a5df");
  EXPECT_EQ(automorphisms_of(quads).size(), 48U);
  for (const bool is_ball : {false, true}) {
    BoundState state(quads, is_ball);
    EXPECT_EQ(cycle_dimension(state), 1);
    EXPECT_TRUE(exceeds_face_budget(state, 0));
    EXPECT_FALSE(exceeds_face_budget(state, 1));
    // 8 left - (24 - 2 * 8) corners, four for a new vertex.
    EXPECT_EQ(room_of(state, 1), 0);
    EXPECT_EQ(room_of(state, 3), 4);
    EXPECT_LT(room_of(state, 0), 0);
    EXPECT_FALSE(has_bad_link(state));
    for (std::size_t f = 0; f < 6; ++f) {
      for (std::size_t g = 0; g < f; ++g) {
        EXPECT_FALSE(are_apart(state, state.facets()[f], state.facets()[g]));
      }
    }
    EXPECT_EQ(state.tops_on(0, {-1}).size(), 0U);
    EXPECT_EQ(state.tops_on(0, {0}), (std::vector<BoundCorners>{{4, 5, 7, 6}}));
    state.put(0, {4, 5, 7, 6});
    EXPECT_EQ(state.open_count(), 0U);
    EXPECT_FALSE(has_bad_link(state));
    EXPECT_EQ(state.edges(), 12U);
    EXPECT_EQ(state.relation(0, 7), PairRelation::kBodyDiagonal);
  }
}

TEST(BoundRules, RefusesOtherBoundaries) {
  std::vector<Quad> quads = cube();
  // In any direction and from any corner.
  std::reverse(quads[2].begin(), quads[2].end());
  std::rotate(quads[4].begin(), quads[4].begin() + 1, quads[4].end());
  EXPECT_EQ(fault_of_boundary(quads, "q1:08a5df"), "");
  const auto refuses = [&quads](const auto& change) {
    std::vector<Quad> changed = quads;
    change(changed);
    const std::string fault = fault_of_boundary(changed, "q1:08a5df");
    return !fault.empty() && fault.find("code") == std::string::npos;
  };
  for (std::size_t q = 0; q < 6; ++q) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_TRUE(refuses([=](auto& all) { std::swap(all[q][i], all[q][(i + 1) % 4]); }));
      for (std::uint32_t v = 0; v < 8; ++v) {
        if (v == quads[q][i]) continue;
        EXPECT_TRUE(refuses([=](auto& all) { all[q][i] = v; }));
      }
    }
    EXPECT_TRUE(refuses([q](auto& all) { all[q] = all[(q + 1) % 6]; }));
  }
  // A cube with a quad cut in two along a path of one new vertex: a vertex of degree 2.
  EXPECT_TRUE(refuses([](auto& all) {
    all[0] = {0, 1, 3, 8};
    all.push_back({0, 8, 3, 2});
  }));
}

}  // namespace
}  // namespace hexatlas::check
