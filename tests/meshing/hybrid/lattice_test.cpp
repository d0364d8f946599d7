// Claim. fill_with_lattice fills closed surfaces with tetrahedra that overlap nowhere and whose
// boundary is the surface; tetrahedra of a lattice combine into cubes; other surfaces are refused.
// Oracles. Volumes by integers and by the divergence theorem; counts of facets by a map; the cubes
// of which a surface was made.
#include "meshing/hybrid/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/selection.hpp"
#include "meshing/hybrid/tet_graph.hpp"
#include "realize/exact/orientation.hpp"
#include "realize/exact/volume.hpp"
#include "tests/meshing/hybrid/closed_surfaces.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::hybrid_tests;
using hybrid::Filled;
using hybrid::LatticeOptions;

using Triangles = std::vector<std::array<exact::Point3, 3>>;

exact::Point3 exact_point(const mesh::Point& p) { return {p.x, p.y, p.z}; }

Filled filled(const mesh::FacetMesh& surface, const LatticeOptions& options = {}) {
  auto result = hybrid::fill_with_lattice(surface, options);
  if (const auto* fault = std::get_if<complex::BrokenLaw>(&result)) {
    ADD_FAILURE() << fault->reason;
    return {};
  }
  return std::get<Filled>(std::move(result));
}

std::string refusal(const mesh::FacetMesh& surface, const LatticeOptions& options = {}) {
  const auto result = hybrid::fill_with_lattice(surface, options);
  const auto* fault = std::get_if<complex::BrokenLaw>(&result);
  return fault != nullptr ? fault->reason : "";
}

std::array<Index, 3> from_least(std::array<Index, 3> t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The facets of the tetrahedra that are those of one only, counter-clockwise from outside; empty
/// if a tetrahedron is not right-handed or a facet is twice on the same side.
std::set<std::array<Index, 3>> boundary(const mesh::TetMesh& mesh) {
  std::set<std::array<Index, 3>> open;
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    const auto& p = mesh.points;
    if (exact::sign_of_orientation(exact_point(p[a]), exact_point(p[b]), exact_point(p[c]),
                                   exact_point(p[d])) != exact::Sign::positive)
      return {};
    for (const auto& [u, v, w] : {std::array{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}) {
      if (open.erase(from_least({u, w, v})) != 0) continue;
      if (!open.insert(from_least({u, v, w})).second) return {};
    }
  }
  return open;
}

/// Vertices - edges + triangles.
int euler(const std::set<std::array<Index, 3>>& triangles) {
  std::set<Index> vertices;
  std::set<std::pair<Index, Index>> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(triangles.size());
}

/// The sign of the volume of the tetrahedra less that inside the surface, counter-clockwise from
/// outside.
exact::Sign excess(const Filled& filled, const mesh::FacetMesh& surface) {
  Triangles all;
  for (const auto& t : boundary(filled.model.mesh)) {
    const auto& p = filled.model.mesh.points;
    all.push_back({exact_point(p[t[0]]), exact_point(p[t[1]]), exact_point(p[t[2]])});
  }
  for (const mesh::Facet& f : surface.facets) {
    const auto& p = surface.points;
    all.push_back({exact_point(p[f.vertices[0]]), exact_point(p[f.vertices[2]]),
                   exact_point(p[f.vertices[1]])});
  }
  return exact::sign_of_volume(all);
}

/// The laws that every filling obeys. The tetrahedra are right-handed and their boundary encloses
/// what they fill, so they overlap nowhere if that does not cross itself.
void expect_laws(const Filled& filled, const mesh::FacetMesh& surface) {
  const mesh::TetModel& model = filled.model;
  const auto outside = boundary(model.mesh);
  std::set<std::array<Index, 3>> triangles;
  for (const auto& t : model.triangles) triangles.insert(from_least(t));
  EXPECT_FALSE(outside.empty());
  EXPECT_EQ(triangles.size(), model.triangles.size());
  EXPECT_EQ(outside, triangles);
  EXPECT_EQ(model.colours.size(), model.triangles.size());
  EXPECT_EQ(model.regions, std::vector<std::uint32_t>(model.mesh.tetrahedra.size(), 0));
  EXPECT_EQ(model.mesh.points.size(),
            surface.points.size() + filled.added_on_surface + filled.lattice_points);
  EXPECT_TRUE(std::equal(surface.points.begin(), surface.points.end(), model.mesh.points.begin()));
  std::set<Index> used;
  for (const auto& t : model.mesh.tetrahedra) used.insert(t.begin(), t.end());
  EXPECT_EQ(used.size(), model.mesh.points.size());
}

/// How many hexahedra a selection among all candidates has.
std::size_t hexahedra(const Filled& filled) {
  const mesh::TetModel& model = filled.model;
  const auto graph = hybrid::TetGraph::of({model.mesh.points, model.mesh.tetrahedra},
                                          {model.regions, model.triangles, model.colours});
  const auto* sound = std::get_if<hybrid::TetGraph>(&graph);
  if (sound == nullptr) return 0;
  const hybrid::Candidates candidates = hybrid::candidates(*sound, 0.9);
  const auto cells = hybrid::selection(*sound, candidates, {.rounds = 0});
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [](const auto& cell) {
    return cell.shape == hybrid::Shape::hexahedron;
  }));
}

std::size_t colours(const Filled& filled) {
  return std::set<std::uint32_t>(filled.model.colours.begin(), filled.model.colours.end()).size();
}

struct CubesCase {
  const char* name;
  Place size;
  bool (*is_wanted)(Place);
  std::size_t cubes;
  std::size_t inner_points;
  int euler;
  std::size_t colours;
};

bool is_middle(int x) { return x >= 2 && x < 4; }

const std::array<CubesCase, 6> kCubes{{
    {"one cube", {1, 1, 1}, [](Place) { return true; }, 1, 0, 2, 6},
    {"box", {5, 4, 3}, [](Place) { return true; }, 60, 24, 2, 6},
    {"plate", {4, 5, 1}, [](Place) { return true; }, 20, 0, 2, 6},
    {"L", {4, 4, 2}, [](Place p) { return p[0] < 2 || p[1] < 2; }, 24, 5, 2, 8},
    {"hole",
     {6, 6, 2},
     [](Place p) { return !is_middle(p[0]) || !is_middle(p[1]); },
     64,
     16,
     0,
     10},
    {"cavity",
     {6, 6, 6},
     [](Place p) { return !is_middle(p[0]) || !is_middle(p[1]) || !is_middle(p[2]); },
     208,
     98,
     4,
     12},
}};

TEST(Lattice, UnionsOfCubesBecomeTheseCubes) {
  for (const CubesCase& c : kCubes)
    for (const Diagonals diagonals : {Diagonals::alike, Diagonals::random}) {
      SCOPED_TRACE(c.name);
      const mesh::FacetMesh surface = surface_of_cubes(c.size, c.is_wanted, diagonals);
      const Filled result = filled(surface);
      expect_laws(result, surface);
      EXPECT_EQ(result.added_on_surface, 0U);
      EXPECT_EQ(result.lattice_points, c.inner_points);
      EXPECT_EQ(result.model.triangles.size(), surface.facets.size());
      EXPECT_EQ(excess(result, surface), exact::Sign::zero);
      EXPECT_EQ(euler(boundary(result.model.mesh)), c.euler);
      EXPECT_EQ(colours(result), c.colours);
      EXPECT_EQ(result.spacing, 1);
      EXPECT_EQ(hexahedra(result), c.cubes);
      double volume = 0;  // six times; of small integers, so exact
      for (const auto& t : result.model.mesh.tetrahedra) {
        const auto& p = result.model.mesh.points;
        const auto d = [&](std::size_t i) {
          return std::array{p[t[i]].x - p[t[0]].x, p[t[i]].y - p[t[0]].y, p[t[i]].z - p[t[0]].z};
        };
        const auto [a, b, e] = std::array{d(1), d(2), d(3)};
        volume += a[0] * (b[1] * e[2] - b[2] * e[1]) + a[1] * (b[2] * e[0] - b[0] * e[2]) +
                  a[2] * (b[0] * e[1] - b[1] * e[0]);
      }
      EXPECT_EQ(volume, 6.0 * static_cast<double>(c.cubes));
    }
}

TEST(Lattice, CubesWithRoundedCoordinates) {
  const auto whole = [](Place) { return true; };
  for (const double side : {1.0 / 7, 0.1, 1e-5, 3e7}) {
    const mesh::FacetMesh surface =
        moved(surface_of_cubes({5, 4, 3}, whole, Diagonals::random), side / 3, side);
    const Filled result = filled(surface);
    expect_laws(result, surface);
    EXPECT_EQ(hexahedra(result), 60U);
    EXPECT_EQ(result.model.mesh.tetrahedra.size(), 360U);  // ties are exact: planes have one value
  }
}

TEST(Lattice, KeepsDiagonalsIfAsked) {
  const mesh::FacetMesh surface = surface_of_cubes(
      {3, 3, 3}, [](Place) { return true; }, Diagonals::random);
  const Filled result = filled(surface, {.keeps_diagonals = true});
  expect_laws(result, surface);
  EXPECT_EQ(result.exchanged_diagonals, 0U);
  EXPECT_EQ(excess(result, surface), exact::Sign::zero);
  std::set<std::pair<Index, Index>> edges;
  for (const auto& t : result.model.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  // An edge of the input is there, or the halves of it are.
  std::map<std::array<double, 3>, Index> at;
  for (Index v = 0; v < result.model.mesh.points.size(); ++v) {
    const mesh::Point& p = result.model.mesh.points[v];
    at.emplace(std::array{p.x, p.y, p.z}, v);
  }
  const std::function<bool(Index, Index, int)> is_covered = [&](Index a, Index b, int depth) {
    if (edges.contains(std::minmax(a, b))) return true;
    const mesh::Point& p = result.model.mesh.points[a];
    const mesh::Point& q = result.model.mesh.points[b];
    const auto middle = at.find({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
    return depth > 0 && middle != at.end() && is_covered(a, middle->second, depth - 1) &&
           is_covered(middle->second, b, depth - 1);
  };
  for (const mesh::Facet& f : surface.facets)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(is_covered(f.vertices[k], f.vertices[(k + 1) % 3], 4));
}

/// Curved, where no diagonal may be exchanged unless the pair is flat.
TEST(Lattice, CurvedSurfaces) {
  struct Case {
    mesh::FacetMesh surface;
    int euler;
    std::size_t colours;
    double volume;  ///< of the smooth surface
  };
  const double pi = std::numbers::pi;
  for (const Case& c :
       {Case{sphere(1, 8), 2, 1, 4 * pi / 3}, Case{sphere(3, 12), 2, 1, 36 * pi},
        Case{torus(3, 1, 48, 16), 0, 1, 6 * pi * pi}, Case{cylinder(1, 2, 8, 12), 2, 3, 2 * pi}}) {
    const Filled result = filled(c.surface);
    expect_laws(result, c.surface);
    EXPECT_EQ(euler(boundary(result.model.mesh)), c.euler);
    EXPECT_EQ(colours(result), c.colours);
    double volume = 0;
    for (const auto& t : result.model.triangles) {
      const auto& p = result.model.mesh.points;
      const auto& [a, b, d] = t;
      volume += p[a].x * (p[b].y * p[d].z - p[b].z * p[d].y) +
                p[a].y * (p[b].z * p[d].x - p[b].x * p[d].z) +
                p[a].z * (p[b].x * p[d].y - p[b].y * p[d].x);
    }
    EXPECT_GT(volume / 6, 0.9 * c.volume);
    EXPECT_LT(volume / 6, c.volume);
    EXPECT_GT(hexahedra(result), 0U);
  }
}

/// Rough: no pair of triangles is flat, so that the surface stays.
TEST(Lattice, ExchangesNoDiagonalThatIsNotFlat) {
  mesh::FacetMesh surface = sphere(1, 8);
  Random random(7);
  for (mesh::Point& p : surface.points) {
    const double s = 1 + 0.05 * random();
    p = {s * p.x, s * p.y, s * p.z};
  }
  const Filled result = filled(surface);
  expect_laws(result, surface);
  EXPECT_EQ(result.exchanged_diagonals, 0U);
}

/// Flat faces with points that are spread at random: diagonals are exchanged, no points are added.
TEST(Lattice, FlatFacesBecomeDelaunay) {
  mesh::FacetMesh surface = surface_of_cubes(
      {6, 6, 6}, [](Place) { return true; }, Diagonals::random);
  Random random(9);
  for (mesh::Point& p : surface.points)
    for (double* x : {&p.x, &p.y, &p.z})
      if (*x > 0 && *x < 6) *x += 0.45 * (random() - 0.5);
  const Filled result = filled(surface);
  expect_laws(result, surface);
  EXPECT_EQ(result.added_on_surface, 0U);
  EXPECT_EQ(excess(result, surface), exact::Sign::zero);
}

/// A wedge whose greatest facet is its slope: most of its flat area is along the axes.
TEST(Lattice, AxesIfMoreIsAlongThem) {
  mesh::FacetMesh surface = surface_of_cubes({6, 4, 1}, [](Place) { return true; });
  for (mesh::Point& p : surface.points) p.z *= 1 + p.x / 6;
  const Filled result = filled(surface);
  expect_laws(result, surface);
  for (std::size_t v = surface.points.size(); v < result.model.mesh.points.size(); ++v)
    EXPECT_EQ(result.model.mesh.points[v].x, std::round(result.model.mesh.points[v].x));
}

/// Without exchanged diagonals and added points the enclosed volume is exactly the same.
TEST(Lattice, SphereIsKept) {
  const mesh::FacetMesh surface = sphere(1, 8);
  const Filled result = filled(surface, {.keeps_diagonals = true});
  ASSERT_EQ(result.added_on_surface, 0U);
  EXPECT_EQ(excess(result, surface), exact::Sign::zero);
  EXPECT_EQ(result.model.triangles.size(), surface.facets.size());
}

TEST(Lattice, TurnedBoxAndThreadsAndOrientationOfTheInput) {
  mesh::FacetMesh surface = turned(surface_of_cubes(
      {6, 5, 4}, [](Place) { return true; }, Diagonals::random));
  const Filled one = filled(surface);
  expect_laws(one, surface);
  EXPECT_EQ(colours(one), 6U);
  EXPECT_EQ(hexahedra(one), 120U);  // the lattice is turned with the box
  const Filled two = filled(surface, {.threads = 2});
  EXPECT_EQ(one.model.mesh.tetrahedra, two.model.mesh.tetrahedra);
  EXPECT_EQ(one.model.triangles, two.model.triangles);
  Random random(3);
  for (mesh::Facet& f : surface.facets)
    if (random() < 0.5) std::swap(f.vertices[0], f.vertices[1]);
  expect_laws(filled(surface), surface);  // outward all the same
}

/// A spindle of slivers: sharp angles, where points have to be added on the surface.
TEST(Lattice, SharpAngles) {
  mesh::FacetMesh surface;
  surface.points = {{0, 0, 0}, {4, 0, 0}, {2, 1, 0.05}, {2, 1, -0.05}, {2, -1, 0.02}};
  for (const auto& [a, b] : {std::array<Index, 2>{2, 3}, {3, 4}, {4, 2}}) {
    surface.facets.push_back(triangle(0, b, a));
    surface.facets.push_back(triangle(1, a, b));
  }
  for (const double spacing : {0.0, 0.5, 0.2}) {
    const Filled result = filled(surface, {.spacing = spacing});
    expect_laws(result, surface);
    EXPECT_EQ(euler(boundary(result.model.mesh)), 2);
  }
}

/// Two plates near each other, joined at one end: recovery has to add points.
TEST(Lattice, NarrowGap) {
  mesh::FacetMesh surface = surface_of_cubes(
      {8, 8, 3}, [](Place p) { return p[2] != 1 || p[0] == 0; }, Diagonals::alike);
  for (mesh::Point& p : surface.points)
    p.z = p.z <= 1 ? p.z : 1 + (p.z - 1) * 0.05 + (p.z > 2 ? 0.95 * (p.z - 2) : 0);
  Random random(5);
  for (mesh::Point& p : surface.points)
    if (p.x > 1 && p.x < 8 && p.y > 0 && p.y < 8 && p.z > 1 && p.z < 1.5)
      p = {p.x + 0.4 * (random() - 0.5), p.y + 0.4 * (random() - 0.5), p.z};
  const Filled result = filled(surface);
  expect_laws(result, surface);
  EXPECT_GT(result.added_on_surface, 0U);
  EXPECT_EQ(euler(boundary(result.model.mesh)), 2);
}

TEST(Lattice, LeavesOutUnusedPoints) {
  mesh::FacetMesh surface = surface_of_cubes({2, 2, 2}, [](Place) { return true; });
  surface.points.insert(surface.points.begin(), {0.5, 0.25, 0.125});
  for (mesh::Facet& f : surface.facets)
    for (std::size_t k = 0; k < 3; ++k) ++f.vertices[k];
  const Filled result = filled(surface);
  EXPECT_EQ(result.model.mesh.points.size(), 27U);
  EXPECT_EQ(result.model.mesh.points[0], surface.points[1]);
  EXPECT_EQ(hexahedra(result), 8U);
}

TEST(Lattice, RefusesWhatIsNoClosedSurface) {
  const auto box = surface_of_cubes({2, 2, 2}, [](Place) { return true; });
  EXPECT_EQ(refusal({}), "the surface has no triangles");
  mesh::FacetMesh broken = box;
  broken.facets.pop_back();
  EXPECT_NE(refusal(broken).find("is in 1 triangles, not in 2"), std::string::npos);
  broken = box;
  broken.facets.push_back(broken.facets[0]);
  EXPECT_NE(refusal(broken).find("is in 3 triangles, not in 2"), std::string::npos);
  broken = box;
  broken.facets[5].size = 4;
  EXPECT_NE(refusal(broken).find("facet 5 is a quad"), std::string::npos);
  broken = box;
  broken.facets[7].vertices[1] = broken.facets[7].vertices[0];
  EXPECT_EQ(refusal(broken), "triangle 7 has no area");
  broken = box;
  for (mesh::Point& p : broken.points) p.z = 0;
  EXPECT_NE(refusal(broken).find("has no area"), std::string::npos);
  mesh::FacetMesh pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.facets = {triangle(0, 1, 2), triangle(0, 2, 1)};
  EXPECT_EQ(refusal(pillow), "triangles 0 and 1 have the same vertices");
  const auto two = surface_of_cubes({2, 2, 1}, [](Place p) { return p[0] == p[1]; });
  EXPECT_NE(refusal(two).find("is in 4 triangles, not in 2"), std::string::npos);
  broken = box;  // unsewn: a second box with the same places
  for (const mesh::Facet& f : box.facets) {
    const auto n = static_cast<Index>(box.points.size());
    broken.facets.push_back(triangle(f.vertices[0] + n, f.vertices[1] + n, f.vertices[2] + n));
  }
  broken.points.insert(broken.points.end(), box.points.begin(), box.points.end());
  EXPECT_NE(refusal(broken).find("are at the same place"), std::string::npos);
}

TEST(Lattice, RefusesSurfacesThatMeetThemselves) {
  const auto box = surface_of_cubes({3, 3, 3}, [](Place) { return true; });
  for (const double shift : {0.5, 1.0 / 3, 2.75}) {
    mesh::FacetMesh both = box;
    const auto n = static_cast<Index>(box.points.size());
    for (const mesh::Point& p : moved(box, shift, 1).points) both.points.push_back(p);
    for (const mesh::Facet& f : box.facets)
      both.facets.push_back(triangle(f.vertices[0] + n, f.vertices[1] + n, f.vertices[2] + n));
    EXPECT_NE(refusal(both, {.rounds = 6}).find("meets itself near"), std::string::npos) << shift;
  }
}

TEST(Lattice, RefusesTooManyPlaces) {
  const auto box = surface_of_cubes({2, 2, 2}, [](Place) { return true; });
  EXPECT_NE(refusal(box, {.spacing = 1e-4}).find("2^28 places"), std::string::npos);
}

TEST(Lattice, PreconditionsAreChecked) {
  auto box = surface_of_cubes({1, 1, 1}, [](Place) { return true; });
  const double infinity = std::numeric_limits<double>::infinity();
  for (const LatticeOptions& options :
       {LatticeOptions{.spacing = -1}, LatticeOptions{.spacing = infinity},
        LatticeOptions{.clearance = 0}, LatticeOptions{.flatness = -1}, LatticeOptions{.rounds = 0},
        LatticeOptions{.threads = 0}})
    EXPECT_THROW((void)hybrid::fill_with_lattice(box, options), core::PreconditionViolated);
  box.points[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)hybrid::fill_with_lattice(box), core::PreconditionViolated);
  box.points[0].x = 0;
  box.facets[0].vertices[0] = 99;
  EXPECT_THROW((void)hybrid::fill_with_lattice(box), core::PreconditionViolated);
}

}  // namespace
