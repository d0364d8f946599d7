// Claim. The chosen cells are compatible and none can be added; the mesh made of them is conforming
// and has the boundary of the tetrahedra; on small inputs the weight is near the greatest.
// Oracles. The judge of hybrid meshes (tables/check); compatibility pair by pair, from the
// definition; the greatest weight by a search over all subsets of compatible cells.
#include "meshing/hybrid/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "meshing/hybrid/conforming.hpp"
#include "tables/check/hybrid_check.hpp"
#include "tests/meshing/hybrid/kuhn.hpp"
#include "tests/meshing/hybrid/oracle.hpp"
#include "tests/share.hpp"

namespace hexatlas {
namespace {

using hybrid::Candidates;
using hybrid::Cell;
using hybrid::Shape;
using hybrid::TetGraph;

struct Setting {
  mesh::TetMesh mesh;
  TetGraph graph;
  Candidates candidates;
};

Setting setting(mesh::TetMesh mesh, double quality) {
  Setting s{std::move(mesh), {}, {}};
  s.graph = std::get<TetGraph>(TetGraph::of({s.mesh.points, s.mesh.tetrahedra}));
  s.candidates = hybrid::candidates(s.graph, quality);
  return s;
}

/// What the definition of compatible cells speaks of.
struct Parts {
  std::set<hybrid::TetIndex> inner, flat;
  std::set<std::pair<mesh::Index, mesh::Index>> edges;
  std::map<std::pair<mesh::Index, mesh::Index>, std::pair<mesh::Index, mesh::Index>> diagonals;
  double weight = 0;
};

template <std::size_t N>
Parts parts_of(const Setting& s, const hybrid_tests::OracleShape& shape,
               const hybrid::CandidateList<N>& list, std::size_t i, double factor) {
  Parts parts;
  const auto& v = list.cells[i].vertices;
  const auto pair = [](mesh::Index a, mesh::Index b) {
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (const auto t : list.inside(i)) {
    parts.inner.insert(t);
    const auto at = [&](std::size_t k) { return s.mesh.points[s.graph[t][k]]; };
    const auto d = [&](std::size_t k) {
      return std::array{at(k).x - at(0).x, at(k).y - at(0).y, at(k).z - at(0).z};
    };
    const auto a = d(1), b = d(2), c = d(3);
    parts.weight += factor / 6 *
                    (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]));
  }
  for (const auto t : list.all(i))
    if (!parts.inner.contains(t)) parts.flat.insert(t);
  for (const auto& face : shape.faces) {
    for (std::size_t k = 0; k < face.size(); ++k)
      parts.edges.insert(pair(v[face[k]], v[face[(k + 1) % face.size()]]));
    if (face.size() == 3) continue;
    const auto one = pair(v[face[0]], v[face[2]]);
    const auto other = pair(v[face[1]], v[face[3]]);
    parts.diagonals[one] = other;
    parts.diagonals[other] = one;
  }
  return parts;
}

bool are_compatible(const Parts& a, const Parts& b) {
  const auto half = [](const Parts& p, const Parts& q) {
    for (const auto t : p.inner)
      if (q.inner.contains(t) || q.flat.contains(t)) return false;
    for (const auto& [diagonal, other] : p.diagonals) {
      if (q.edges.contains(diagonal)) return false;
      const auto it = q.diagonals.find(diagonal);
      if (it != q.diagonals.end() && it->second != other) return false;
    }
    return true;
  };
  return half(a, b) && half(b, a);
}

std::map<Cell, Parts> all_parts(const Setting& s) {
  std::map<Cell, Parts> all;
  const auto add = [&](Shape shape, const auto& oracle, const auto& list, double factor) {
    for (std::uint32_t i = 0; i < list.cells.size(); ++i)
      all[{shape, i}] = parts_of(s, oracle, list, i, factor);
  };
  add(Shape::hexahedron, hybrid_tests::hexahedron_shape(), s.candidates.hexahedra, 1);
  add(Shape::prism, hybrid_tests::prism_shape(), s.candidates.prisms, 0.5);
  add(Shape::pyramid, hybrid_tests::pyramid_shape(), s.candidates.pyramids, 0.25);
  return all;
}

check::HybridMesh for_judge(const mesh::HybridMesh& mesh) {
  check::HybridMesh judged;
  for (const auto& p : mesh.points) judged.points.push_back({p.x, p.y, p.z});
  judged.tetrahedra.assign(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  judged.prisms.assign(mesh.prisms.begin(), mesh.prisms.end());
  judged.pyramids.assign(mesh.pyramids.begin(), mesh.pyramids.end());
  for (const auto& h : mesh.hexahedra)
    judged.hexahedra.push_back({h[0], h[1], h[3], h[2], h[4], h[5], h[7], h[6]});
  return judged;
}

void expect_accepted(const Setting& s, const hybrid::Combined& combined) {
  check::TetrahedralMesh given;
  for (const auto& p : s.mesh.points) given.points.push_back({p.x, p.y, p.z});
  given.tetrahedra.assign(s.mesh.tetrahedra.begin(), s.mesh.tetrahedra.end());
  const check::HybridVerdict verdict = check::check_hybrid(for_judge(combined.mesh), &given);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
}

void expect_compatible_and_full(const Setting& s, const std::vector<Cell>& cells) {
  const auto parts = all_parts(s);
  const std::set<Cell> chosen(cells.begin(), cells.end());
  EXPECT_EQ(chosen.size(), cells.size());
  for (const auto& [cell, its] : parts) {
    bool fits = true;
    for (const Cell& other : cells)
      if (other != cell && !are_compatible(its, parts.at(other))) fits = false;
    EXPECT_EQ(fits, chosen.contains(cell)) << static_cast<int>(cell.shape) << ' ' << cell.index;
  }
}

TEST(Selection, FindsTheCubesOfALattice) {
  for (unsigned n = 1; n <= 4; ++n) {
    const Setting s = setting(hybrid_tests::kuhn(n, 1.0 / n), 0.3);
    const auto cells = hybrid::selection(s.graph, s.candidates);
    const hybrid::Combined combined = hybrid::conforming_mesh(s.graph, s.candidates, cells);
    EXPECT_EQ(combined.mesh.hexahedra.size(), n * n * n);
    EXPECT_TRUE(combined.mesh.tetrahedra.empty());
    EXPECT_EQ(combined.new_points, 0U);
    expect_accepted(s, combined);
  }
}

TEST(Selection, IsCompatibleAndFull) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 3; ++round) {
    SCOPED_TRACE(round);
    const Setting s = setting(hybrid_tests::random_delaunay(60, 1000, random), 0.05);
    for (const int rounds : {0, 2}) {
      hybrid::SelectionOptions options;
      options.rounds = rounds;
      expect_compatible_and_full(s, hybrid::selection(s.graph, s.candidates, options));
    }
  }
}

/// The greatest weight of compatible cells, each branch bounded by what is left.
class Greatest {
 public:
  explicit Greatest(std::vector<Parts> cells) : cells_(std::move(cells)) {
    std::sort(cells_.begin(), cells_.end(),
              [](const Parts& a, const Parts& b) { return a.weight > b.weight; });
    left_.resize(cells_.size() + 1);
    for (std::size_t i = cells_.size(); i-- > 0;) left_[i] = left_[i + 1] + cells_[i].weight;
    std::vector<std::size_t> chosen;
    branch(0, 0, chosen);
  }
  [[nodiscard]] double weight() const { return best_; }

 private:
  void branch(std::size_t i, double weight, std::vector<std::size_t>& chosen) {
    best_ = std::max(best_, weight);
    if (i == cells_.size() || weight + left_[i] <= best_) return;
    const bool fits = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t c) {
      return are_compatible(cells_[i], cells_[c]);
    });
    if (fits) {
      chosen.push_back(i);
      branch(i + 1, weight + cells_[i].weight, chosen);
      chosen.pop_back();
    }
    branch(i + 1, weight, chosen);
  }

  std::vector<Parts> cells_;
  std::vector<double> left_;
  double best_ = 0;
};

TEST(Selection, IsNearTheGreatestWeightOnSmallMeshes) {
  std::mt19937_64 random(5);
  double found = 0;
  double greatest = 0;
  for (int round = 0; round < 40; ++round) {
    const Setting s = setting(hybrid_tests::random_delaunay(11, 1000, random), 0.1);
    const auto parts = all_parts(s);
    if (parts.size() > 40) continue;
    std::vector<Parts> list;
    for (const auto& [cell, its] : parts) list.push_back(its);
    double weight = 0;
    for (const Cell& cell : hybrid::selection(s.graph, s.candidates))
      weight += parts.at(cell).weight;
    const double best = Greatest(std::move(list)).weight();
    EXPECT_LE(weight, best * (1 + 1e-9));
    found += weight;
    greatest += best;
  }
  EXPECT_GT(greatest, 0);
  EXPECT_GT(found, 0.9 * greatest);
}

/// What is done grows, within each pass over the cells, and has no say in the result.
TEST(Conforming, TellsHowFarItIs) {
  std::mt19937_64 random(13);
  const Setting s = setting(hybrid_tests::random_delaunay(200, 1U << 16U, random), 0.1);
  std::vector<std::size_t> told;
  const auto tell = [&told](std::size_t done, std::size_t all) {
    EXPECT_LE(done, all);
    told.push_back(done);
  };
  hybrid::SelectionOptions options;
  options.progress = tell;
  const auto cells = hybrid::selection(s.graph, s.candidates, options);
  EXPECT_EQ(cells, hybrid::selection(s.graph, s.candidates));
  EXPECT_GT(told.size(), 3U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  told.clear();
  const auto watched = hybrid::conforming_mesh(s.graph, s.candidates, cells, tell);
  const auto unwatched = hybrid::conforming_mesh(s.graph, s.candidates, cells);
  EXPECT_EQ(watched.mesh.tetrahedra, unwatched.mesh.tetrahedra);
  EXPECT_EQ(watched.mesh.points, unwatched.mesh.points);
  EXPECT_GT(std::count(told.begin(), told.end(), 0U), 1);
}

/// Triangles of the mesh, and those that a quad may stand for.
std::set<std::set<mesh::Index>> triangles_of(const mesh::HybridMesh& mesh) {
  std::set<std::set<mesh::Index>> triangles;
  const auto add = [&](const auto& cell, std::initializer_list<std::array<std::size_t, 4>> facets) {
    for (const auto& f : facets)  // the fourth is the third of a triangle
      for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        std::set<mesh::Index> triangle;
        for (std::size_t i = 0; i < 4; ++i)
          if (i != left_out) triangle.insert(cell[f[i]]);
        if (triangle.size() == 3) triangles.insert(triangle);
      }
  };
  for (const auto& t : mesh.tetrahedra)
    add(t, {{1, 2, 3, 3}, {0, 2, 3, 3}, {0, 1, 3, 3}, {0, 1, 2, 2}});
  for (const auto& h : mesh.hexahedra)
    add(h, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  for (const auto& p : mesh.prisms)
    add(p, {{0, 1, 2, 2}, {3, 4, 5, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
  for (const auto& y : mesh.pyramids)
    add(y, {{0, 1, 2, 3}, {0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {3, 0, 4, 4}});
  return triangles;
}

TEST(Conforming, KeepsFacetsBetweenRegionsAndOnSurfaces) {
  std::mt19937_64 random(17);
  std::size_t facets = 0;
  std::size_t cells_made = 0;
  for (int round = 0; round < support::share_of(20); ++round) {
    Setting s{hybrid_tests::random_delaunay(80, 1U << 16U, random), {}, {}};
    std::vector<std::uint32_t> regions;
    std::vector<std::array<mesh::Index, 3>> triangles;
    for (const auto& t : s.mesh.tetrahedra) {
      double x = 0;
      for (const mesh::Index v : t) x += s.mesh.points[v].x;
      regions.push_back(x < 4 * 0x1p15 ? 3 : 8);
      if (random() % 20 == 0) triangles.push_back({t[0], t[1], t[2]});
    }
    const std::vector<std::uint32_t> colours(triangles.size(), 1);
    s.graph = std::get<TetGraph>(
        TetGraph::of({s.mesh.points, s.mesh.tetrahedra}, {regions, triangles, colours}));
    s.candidates = hybrid::candidates(s.graph, 0.2);
    const auto cells = hybrid::selection(s.graph, s.candidates);
    const hybrid::Combined combined = hybrid::conforming_mesh(s.graph, s.candidates, cells);
    expect_accepted(s, combined);
    cells_made += combined.inserted_pyramids;
    const auto made = triangles_of(combined.mesh);
    std::map<std::set<mesh::Index>, std::set<std::uint32_t>> sides;
    for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t)
      for (const mesh::Index apex : s.mesh.tetrahedra[t]) {
        std::set<mesh::Index> facet(s.mesh.tetrahedra[t].begin(), s.mesh.tetrahedra[t].end());
        facet.erase(apex);
        sides[facet].insert(regions[t]);
      }
    for (const auto& t : triangles) sides[{t[0], t[1], t[2]}] = {0, 1};
    for (const auto& [facet, of] : sides)
      if (of.size() == 2) {
        ++facets;
        ASSERT_TRUE(made.contains(facet)) << round;
      }
  }
  EXPECT_GT(facets, std::size_t{support::share_of(500)});
  EXPECT_GT(cells_made, std::size_t{support::share_of(50)});
}

TEST(Conforming, MeshesOfRandomPointsAreAccepted) {
  std::mt19937_64 random(9);
  for (const std::size_t points : {20U, 100U, 400U}) {
    SCOPED_TRACE(points);
    const Setting s = setting(hybrid_tests::random_delaunay(points, 1U << 16U, random), 0.1);
    const auto cells = hybrid::selection(s.graph, s.candidates);
    const hybrid::Combined combined = hybrid::conforming_mesh(s.graph, s.candidates, cells);
    expect_accepted(s, combined);
    EXPECT_EQ(combined.chosen[0], combined.mesh.hexahedra.size());
    EXPECT_EQ(combined.chosen[0] + combined.chosen[1] + combined.chosen[2] + combined.given_up,
              cells.size());
    const hybrid::Combined plain = hybrid::plain_mesh(s.graph, s.candidates, cells);
    EXPECT_EQ(plain.mesh.hexahedra.size() + plain.mesh.prisms.size() + plain.mesh.pyramids.size(),
              cells.size());
    EXPECT_EQ(plain.new_points, 0U);
    if (points > 20) {
      EXPECT_GT(combined.mesh.hexahedra.size(), 0U);
      EXPECT_GT(plain.quads_on_triangles, 0U);
    }
  }
}

}  // namespace
}  // namespace hexatlas
