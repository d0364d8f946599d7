// Claim. No pruning refutes a state from which a known mesh follows: the meshes of the shipped
// table are put together hexahedron by hexahedron, within limits that just permit them, on the
// facets that the search chooses and on open facets at random. Of the images of a mesh under the
// automorphisms of its boundary just one is kept. Oracle. The meshes themselves, found by flips,
// which share no code with the search.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "enum/hexes/partners.hpp"
#include "enum/hexes/search.hpp"
#include "tables/format/table.hpp"
#include "tests/enum/support.hpp"
#include "tests/oracles/hexahedra.hpp"
#include "tests/shipped.hpp"

namespace {

using namespace hexatlas;
using hexes::Facet;
using hexes::PartialMesh;
using hexes::Vertex;

/// A mesh whose interior vertices get their numbers when they are met.
class Known {
 public:
  Known(const complex::HexComplex& mesh, int boundary_vertices)
      : mesh_(mesh), named_(mesh.vertices, -1), used_(mesh.hexahedra.size(), false) {
    for (int v = 0; v < boundary_vertices; ++v) named_[static_cast<std::size_t>(v)] = v;
    next_ = boundary_vertices;
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      for (const auto& quad : oracle::outer_quads(mesh.hexahedra[h]))
        with_quad_[sorted(quad)].push_back(h);
  }

  /// The top vertices of the hexahedron that is not there yet on a facet of numbered vertices.
  std::array<Vertex, 4> put_on(const Facet& facet) {
    std::array<std::uint32_t, 4> quad{};
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = static_cast<std::uint32_t>(
          std::find(named_.begin(), named_.end(), static_cast<int>(facet[i])) - named_.begin());
    const auto& both = with_quad_.at(sorted(quad));
    const std::size_t h = used_[both.front()] ? both.back() : both.front();
    EXPECT_FALSE(used_[h]);
    used_[h] = true;
    std::array<Vertex, 4> tops{};
    const complex::Hexahedron& cell = mesh_.hexahedra[h];
    for (std::size_t i = 0; i < 4; ++i) {
      // Across the edge that leaves the facet: one bit of the place in the cell.
      const auto place =
          static_cast<std::size_t>(std::find(cell.begin(), cell.end(), quad[i]) - cell.begin());
      for (const std::size_t axis : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
        const std::uint32_t other = cell[place ^ axis];
        if (std::find(quad.begin(), quad.end(), other) != quad.end()) continue;
        if (named_[other] < 0) named_[other] = next_++;
        tops[i] = static_cast<Vertex>(named_[other]);
      }
    }
    return tops;
  }

 private:
  using Quad = std::array<std::uint32_t, 4>;
  template <class Four>
  static Quad sorted(const Four& quad) {
    Quad result{};
    std::copy(quad.begin(), quad.end(), result.begin());
    std::sort(result.begin(), result.end());
    return result;
  }

  const complex::HexComplex& mesh_;
  std::vector<int> named_;
  std::vector<bool> used_;
  std::map<Quad, std::vector<std::size_t>> with_quad_;
  int next_ = 0;
};

struct Entry {
  complex::Quadrangulation boundary;
  complex::HexComplex mesh;
  int interior = 0;
};

Entry entry_of(const format::Table& table, std::size_t ordinal) {
  const complex::Quadrangulation boundary = canon::decode(table.entry(ordinal).code).value();
  complex::HexComplex mesh = table.mesh(ordinal);
  return {boundary, mesh, static_cast<int>(mesh.vertices) - boundary.vertices()};
}

/// Takes the choices that lead to a known mesh. False if one is not offered, or refuted.
bool leads_to(const complex::HexComplex& known, hexes::HexSearch& search) {
  Known mesh(known, search.mesh().boundary_vertices());
  while (!search.is_complete()) {
    for (const Vertex top : mesh.put_on(search.mesh().facet(search.mesh().bottom()))) {
      bool offered = false;
      for (const auto choice : search.choices()) offered = offered || choice.top == top;
      if (!offered || !search.apply({top})) return false;
    }
    EXPECT_NE(search.is_complete(), search.mesh().has_begun());
  }
  return search.mesh().cells().size() == known.hexahedra.size();
}

void expect_found_by_search(const Entry& known, bool ball) {
  const auto hexahedra = static_cast<int>(known.mesh.hexahedra.size());
  hexes::HexSearch search(known.boundary, {hexahedra, known.interior, ball});
  EXPECT_TRUE(leads_to(known.mesh, search));
}

/// How many automorphisms of the boundary take the mesh to an image that the search keeps, if all
/// these images are one; otherwise 0.
int kept_images(const Entry& known, bool ball) {
  const auto hexahedra = static_cast<int>(known.mesh.hexahedra.size());
  int kept = 0, automorphisms = 0;
  for (const hexes::BoundaryMap& map : hexes::automorphisms_of(known.boundary)) {
    complex::HexComplex image = known.mesh;
    for (auto& cell : image.hexahedra)
      for (auto& v : cell)
        if (v < static_cast<std::uint32_t>(known.boundary.vertices())) v = map[v];
    hexes::HexSearch search(known.boundary, {hexahedra, known.interior, ball, true});
    if (!leads_to(image, search)) continue;
    ++kept;
    automorphisms = search.automorphisms();
  }
  return kept == automorphisms ? kept : 0;
}

/// `new_vertices`: how many the rest of the mesh has.
void expect_refuted_nowhere(const PartialMesh& mesh, int left, int new_vertices) {
  if (mesh.open_count() == 0) return;
  ASSERT_FALSE(mesh.is_for_balls() && !mesh.cells().empty() && closes_badly(mesh));
  ASSERT_FALSE(exceeds_face_budget(mesh, left));
  hexes::OpenFacets open;
  open.list(mesh);
  for (const bool ears : {false, true}) {
    const int within = new_vertices_within(mesh, open, left, ears);
    ASSERT_GE(within, new_vertices);
    ASSERT_TRUE(!is_ample(mesh, left) || within >= mesh.new_vertices().all);
  }
  const hexes::NewVertices due = mesh.new_vertices(new_vertices);
  ASSERT_EQ(due.all, new_vertices);
  PartialMesh copy = mesh;
  ASSERT_FALSE(tightest(copy, due).is_refuted);
  ASSERT_TRUE(facets_apart(open, left).empty());
}

void expect_refuted_in_no_order(const Entry& known, bool ball, support::Random& random) {
  const auto hexahedra = static_cast<int>(known.mesh.hexahedra.size());
  PartialMesh mesh(known.boundary, static_cast<int>(known.mesh.vertices), ball);
  ASSERT_TRUE(!ball || mesh.balance());
  Known source(known.mesh, known.boundary.vertices());
  while (mesh.open_count() > 0) {
    ASSERT_NO_FATAL_FAILURE(
        expect_refuted_nowhere(mesh, hexahedra - static_cast<int>(mesh.cells().size()),
                               static_cast<int>(known.mesh.vertices) - mesh.vertices()));
    std::vector<int> open;
    mesh.open().for_each([&](int facet) { open.push_back(facet); });
    if (ball) {
      const hexes::Partners partners = partners_of(mesh, mesh.saturated());
      ASSERT_FALSE(partners.are_too_few);
      mesh.saturate(partners.saturated);
    }
    const hexes::NewVertices may_bring = mesh.new_vertices();
    mesh.begin(open[random.below(open.size())]);
    for (const Vertex top : source.put_on(mesh.facet(mesh.bottom()))) {
      ASSERT_NE(mesh.next_tops(may_bring) & hexes::bit(top), 0U);
      mesh.put(top);
    }
  }
  EXPECT_EQ(mesh.new_vertices().all, 0);
}

/// The least boundaries, and some of all sizes, whose meshes fit into a search.
template <class Visit>
void for_some_meshes(Visit&& visit) {
  const auto table = format::Table::open(support::kShippedTable);
  for (std::size_t ordinal = 0; ordinal < table.size(); ordinal += ordinal < 20 ? 1 : 401) {
    SCOPED_TRACE(canon::to_text(table.entry(ordinal).code));
    const Entry known = entry_of(table, ordinal);
    if (known.mesh.vertices <= hexes::kMaxMeshVertices &&
        known.mesh.hexahedra.size() <= hexes::kMaxHexahedra)
      visit(known);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(KnownMeshes, AreRefutedNowhere) {
  support::Random random(5);
  int seen = 0;
  for_some_meshes([&](const Entry& known) {
    for (const bool ball : {true, false}) {
      ASSERT_NO_FATAL_FAILURE(expect_found_by_search(known, ball));
      for (int order = 0; order < 2; ++order)
        ASSERT_NO_FATAL_FAILURE(expect_refuted_in_no_order(known, ball, random));
    }
    ++seen;
  });
  EXPECT_GT(seen, 100);
}

/// Each automorphism that the mesh has takes the image that is kept to itself.
TEST(KnownMeshes, HaveOneImageThatIsKept) {
  int symmetric = 0, refuted = 0;
  for_some_meshes([&](const Entry& known) {
    const auto order = static_cast<int>(hexes::automorphisms_of(known.boundary).size());
    if (order == 1) return;
    for (const bool ball : {true, false}) {
      const int kept = kept_images(known, ball);
      EXPECT_GT(kept, 0);
      refuted += order - kept;
    }
    ++symmetric;
  });
  EXPECT_GT(symmetric, 15);
  EXPECT_GT(refuted, 100);
}

}  // namespace
