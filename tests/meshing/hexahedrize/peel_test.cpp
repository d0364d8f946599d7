// Claim. mesh_by_peeling() gives every 3-connected quadrangulation with an even number of quads a
// mesh under the strict rule with this boundary, with a table and without, whatever layers come
// first; its account is true; it is the same for any number of threads. mesh_by_zones() gives the
// surface of a block the structured mesh, and others none. Without regard to what the hexahedra
// taken off relate it would be wrong. Oracle. The judge of tables/check, which shares no code;
// complex::validate(); the hexahedra of the sectors, counted; edges of a grid, by formula.
#include "meshing/hexahedrize/peel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/peeling.hpp"
#include "enum/flips/reducing.hpp"
#include "enum/flips/scars.hpp"
#include "meshing/hexahedrize/linear.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "tables/fill/query.hpp"
#include "tests/meshing/hexahedrize/judged.hpp"
#include "tests/meshing/hexahedrize/peeled.hpp"
#include "tests/meshing/hexahedrize/spheres.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using complex::QuadSphere;
using complex::VertexId;
using flips::Peeling;
using support::expect_accepted;
using support::expect_peeled;
using support::expect_true_account;
using support::sectors;
using support::small_spheres;
using support::table;

TEST(Peel, MeshesAllSmallQuadrangulations) {
  for (const int quads : {6, 8, 10})
    for (const QuadSphere& sphere : small_spheres(quads)) {
      const auto made = expect_peeled(sphere, &table(), {.tries = 1});
      const auto direct = hexahedrize::mesh_by_zones(sphere, table());
      if (direct) expect_accepted(direct->mesh, sphere);
      EXPECT_EQ(made.account.rest, hexahedrize::Rest::table);
      expect_peeled(sphere, nullptr, {.tries = 1});
    }
}

TEST(Peel, MeshesRandomQuadrangulations) {
  for (const std::size_t inserted : {3U, 30U, 90U})
    for (std::uint64_t seed = 0; seed < (support::kSanitized ? 2 : 3); ++seed)
      expect_peeled(support::random_sphere(24 + 30 * seed, seed, inserted), &table(), {.tries = 1});
}

TEST(Peel, MeshesGridsAndVerticesOfHighDegree) {
  for (const VertexId n : {1U, 2U, 3U, 5U, 8U})
    expect_peeled(support::grid_cube(n), &table(), {.tries = 1});
  for (const VertexId k : {3U, 4U, 5U, 7U, 13U, 14U, 50U, 201U})
    expect_peeled(support::trapezohedron(k), &table(), {.tries = 1});
}

// The sectors are joined to what was taken off: their scars must not be scars there.
TEST(Peel, IsCompletedBySectorsWithoutATable) {
  std::size_t sectors_used = 0;
  for (const std::size_t inserted : {3U, 30U, 90U})
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
      const auto sphere = support::random_sphere(24 + 8 * seed, 100 + seed, inserted);
      const auto made = expect_peeled(sphere, nullptr, {.tries = 2});
      EXPECT_EQ(made.account.rest, hexahedrize::Rest::sectors);
      for (const std::size_t times : made.used) sectors_used += times > 0 ? 1 : 0;
    }
  EXPECT_GT(sectors_used, 48U) << "where scars forbid one sector, another one is taken";
  for (const VertexId n : {2U, 4U}) expect_peeled(support::grid_cube(n), nullptr, {.tries = 1});
  for (const VertexId k : {5U, 20U}) expect_peeled(support::trapezohedron(k), nullptr);
}

TEST(Peel, PutsLayersFirst) {
  for (const std::size_t layers : {1U, 2U})
    for (const auto& sphere : {support::random_sphere(40, 7), support::grid_cube(1),
                               support::grid_cube(3), support::trapezohedron(9)}) {
      const auto made = expect_peeled(sphere, &table(), {.tries = 1, .layers = layers});
      // One below each quad, and in it four vertices of the layer.
      std::multiset<std::set<VertexId>> quads, below;
      for (const auto& quad : sphere.quads) quads.insert({quad.begin(), quad.end()});
      for (std::size_t i = 0; i < sphere.quads.size(); ++i) {
        std::set<VertexId> outer;
        for (const VertexId v : made.mesh.hexahedra[i])
          if (v < sphere.vertices()) outer.insert(v);
        below.insert(outer);
      }
      EXPECT_EQ(quads, below);
      expect_peeled(sphere, nullptr, {.tries = 1, .layers = layers});
    }
}

TEST(Peel, GivesTheSameForAnyNumberOfThreads) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const auto sphere = support::random_sphere(30 + 40 * seed, seed);
    const auto once = hexahedrize::mesh_by_peeling(sphere, &table(), sectors(), {.tries = 1});
    for (const int threads : {1, 3}) {
      const auto again = hexahedrize::mesh_by_peeling(sphere, &table(), sectors(),
                                                      {.tries = 1, .threads = threads});
      EXPECT_EQ(again.mesh.vertices, once.mesh.vertices);
      EXPECT_EQ(again.mesh.hexahedra, once.mesh.hexahedra);
      EXPECT_EQ(again.account.peeled, once.account.peeled);
      EXPECT_EQ(again.account.layers, once.account.layers);
      EXPECT_EQ(again.account.cavity, once.account.cavity);
    }
  }
}

/// Each interior edge of a grid is in four hexahedra, each interior vertex in eight.
void expect_grid(const complex::HexComplex& mesh, const std::array<VertexId, 3>& cubes) {
  const auto [k, l, m] = cubes;
  EXPECT_EQ(mesh.hexahedra.size(), std::size_t{k} * l * m);
  EXPECT_EQ(mesh.vertices, (k + 1) * (l + 1) * (m + 1));
  std::set<VertexId> outer;
  std::set<std::pair<VertexId, VertexId>> on_boundary;
  for (const auto& quad : complex::boundary_of(mesh))
    for (std::size_t i = 0; i < 4; ++i) {
      outer.insert(quad[i]);
      on_boundary.insert(std::minmax(quad[i], quad[(i + 1) % 4]));
    }
  std::map<std::pair<VertexId, VertexId>, int> around;
  std::map<VertexId, int> at;
  for (const auto& cell : mesh.hexahedra)
    for (std::size_t i = 0; i < 8; ++i) {
      ++at[cell[i]];
      for (std::size_t axis = 1; axis < 8; axis *= 2)
        if ((i & axis) == 0) ++around[std::minmax(cell[i], cell[i | axis])];
    }
  for (const auto& [edge, times] : around)
    if (!on_boundary.contains(edge)) {
      EXPECT_EQ(times, 4);
    }
  for (const auto& [vertex, times] : at)
    if (!outer.contains(vertex)) {
      EXPECT_EQ(times, 8);
    }
}

TEST(Zones, GiveBlocksTheirStructuredMesh) {
  for (const auto& cubes : std::vector<std::array<VertexId, 3>>{{1, 1, 1},
                                                                {2, 1, 1},
                                                                {2, 2, 2},
                                                                {3, 2, 1},
                                                                {3, 3, 3},
                                                                {5, 4, 3},
                                                                {9, 1, 1},
                                                                {8, 8, 8},
                                                                {12, 7, 2},
                                                                {40, 1, 2}}) {
    const QuadSphere sphere = support::block(cubes);
    const auto made = hexahedrize::mesh_by_zones(sphere, table());
    ASSERT_TRUE(made) << cubes[0] << ' ' << cubes[1] << ' ' << cubes[2];
    expect_accepted(made->mesh, sphere);
    expect_true_account(*made, sphere);
    EXPECT_EQ(made->account.rest, hexahedrize::Rest::table);
    EXPECT_EQ(made->account.layers, 0U);
    expect_grid(made->mesh, cubes);
  }
}

TEST(Zones, LeaveTooMuchOfRandomQuadrangulations) {
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    EXPECT_FALSE(hexahedrize::mesh_by_zones(support::random_sphere(300 + 2 * seed, seed), table()));
}

/// As mesh_by_peeling() completes a peeling by a table, but for what is `apart`.
std::optional<complex::HexComplex> completed(const Peeling& peeling, bool is_careful) {
  const QuadSphere cavity = support::sphere_of(peeling.cavity(), peeling.vertices());
  const auto form = canon::canonical_form(hexahedrize::small_form(cavity).value());
  fill::QueryOptions options{.max_collar = 4, .collars_per_level = 200};
  for (complex::Vertex a = 0; is_careful && a < cavity.vertices(); ++a)
    for (complex::Vertex b = 0; b < a; ++b) {
      const auto has_both = [&](const auto& quad) {
        return std::count(quad.begin(), quad.end(), a) + std::count(quad.begin(), quad.end(), b) ==
               2;
      };
      if (peeling.are_related(cavity.point_of[a], cavity.point_of[b]) &&
          std::none_of(cavity.quads.begin(), cavity.quads.end(), has_both))
        options.apart.add(form.label[a], form.label[b]);
    }
  auto found = fill::fill_through(table(), form.code, options);
  if (!found) return std::nullopt;
  const auto rest = hexahedrize::carried_over(*std::move(found), form, cavity.vertices());
  complex::HexComplex mesh{peeling.vertices(), peeling.taken()};
  const auto on_cavity = static_cast<VertexId>(cavity.vertices());
  for (complex::Hexahedron cell : rest.hexahedra) {
    for (VertexId& v : cell) v = v < on_cavity ? cavity.point_of[v] : mesh.vertices + v - on_cavity;
    mesh.hexahedra.push_back(cell);
  }
  mesh.vertices += rest.vertices - on_cavity;
  return mesh;
}

// Sabotage. Without regard to `apart` some meshes break the strict rule; with it none does.
TEST(Peel, NeedsTheRuleOfWhatIsApart) {
  std::size_t faults = 0, careful = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto sphere = support::random_sphere(24 + 2 * (seed % 20), seed, 30);
    Peeling peeling(sphere.quads, sphere.vertices());
    flips::reduce(peeling, {.seed = seed});
    if (peeling.quads() > static_cast<std::size_t>(flips::kMaxSearchQuads)) continue;
    if (const auto mesh = completed(peeling, true)) {
      ++careful;
      expect_accepted(*mesh, sphere);
    }
    const auto careless = completed(peeling, false);
    if (!careless || !complex::validate(*careless)) continue;
    ++faults;
    EXPECT_FALSE(support::judged(*careless, sphere).accepted);
  }
  EXPECT_GT(careful, 0U);
  EXPECT_GT(faults, 0U);
}

// No scar of the sectors that are shipped has both ends on the boundary. Such a scar is put in.
TEST(Peel, SectorsRegardWhatIsApart) {
  std::vector<format::Sector> scarred = sectors();
  for (format::Sector& sector : scarred)
    if (!sector.scars.empty()) sector.scars.push_back({1, 4});
  const auto sphere = support::random_sphere(80, 3);
  std::size_t asked = 0;
  const auto used_if = [&](bool is_apart) {
    return hexahedrize::mesh_by_sectors(sphere, scarred,
                                        [&, is_apart](VertexId a, VertexId b) {
                                          EXPECT_LT(std::max(a, b), sphere.vertices());
                                          ++asked;
                                          return is_apart;
                                        })
        .used;
  };
  EXPECT_GT(used_if(false).front(), 0U);
  EXPECT_GT(asked, 0U);
  EXPECT_EQ(used_if(true).back(), 40U);
}

}  // namespace
