// Claim. Each implementation finds the same cavity by each filter, in the same order, and its cells
// are those in conflict with the site; it leaves no mark elsewhere, and its facets are those
// between a cell of the cavity and one that stays. Oracle. Exact signs of realize/exact, for every
// tetrahedron.
#include "meshing/delaunay/digging.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshing/delaunay/four_facets.hpp"
#include "meshing/delaunay/inserter.hpp"
#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/sites.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::FourFacets;
using delaunay::Site;
using exact::Sign;

std::vector<const FourFacets*> implementations() {
  std::vector<const FourFacets*> result{&delaunay::four_facets_plain()};
#if defined(__x86_64__)
  const bool has_fma = __builtin_cpu_supports("fma") != 0;
  if (const FourFacets* f = delaunay::four_facets_avx2();
      f != nullptr && has_fma && __builtin_cpu_supports("avx2") != 0)
    result.push_back(f);
  if (const FourFacets* f = delaunay::four_facets_avx512();
      f != nullptr && has_fma && __builtin_cpu_supports("avx512vl") != 0 &&
      __builtin_cpu_supports("avx512dq") != 0)
    result.push_back(f);
#endif
  return result;
}

template <class Index>
class Cavity final : private delaunay::Digging<Index>::Owner {
 public:
  using Cell = delaunay::Cell<Index>;

  Cavity(delaunay::Cells<Index>& cells, const std::vector<Site>& sites, Index first, const Site& p)
      : sites_(sites) {
    make_room();
    digging_.owner = this;
    digging_.cells = cells.data();
    digging_.sites = sites.data();
    digging_.site = &p;
    doomed_[0] = 4 * first;
    digging_.cells[first].vertices[0] |= Cell::kMark;
  }
  /// The choice is made by what cavities before left open.
  void dig(const FourFacets& functions, bool by_thorough) {
    if (by_thorough) digging_.choice.note(false, 1000);
    ASSERT_EQ(delaunay::FilterChoice(digging_.choice).takes_thorough(), by_thorough);
    ASSERT_TRUE(functions.dig(digging_));
  }
  void fill_up() {
    for (const Index facet : doomed()) digging_.cells[facet / 4].vertices[0] &= ~Cell::kMark;
  }
  [[nodiscard]] std::vector<Index> doomed() const {
    return {doomed_.data(), doomed_.data() + digging_.doomed_count};
  }
  [[nodiscard]] std::vector<std::array<Index, 4>> facets() const {
    std::vector<std::array<Index, 4>> result;
    for (std::size_t i = 0; i < digging_.facet_count; ++i) {
      const auto& [v, outer] = facets_[i];
      result.push_back({v[0], v[1], v[2], outer});
    }
    return result;
  }
  [[nodiscard]] bool conflicts(Cell cell) const {
    cell.vertices[0] &= ~Cell::kMark;
    const unsigned ghost = cell.ghost();
    std::array<exact::Point3, 4> t{};
    for (unsigned i = 0; i < 4; ++i)
      t[i] = (i == ghost ? *digging_.site : sites_[cell.vertices[i]]).point();
    if (ghost < 4) return exact::sign_of_orientation(t[0], t[1], t[2], t[3]) == Sign::positive;
    return exact::sign_of_perturbed_in_sphere(t[0], t[1], t[2], t[3], digging_.site->point()) ==
           Sign::positive;
  }

 private:
  [[nodiscard]] unsigned conflicting_exactly(const Cell& cell, unsigned which,
                                             const Site&) const override {
    unsigned inside = 0;
    for (unsigned j = 0; j < 4; ++j)
      if ((which >> j & 1U) != 0 &&
          conflicts(digging_.cells[cell.neighbors[delaunay::opposite_of(j)] / 4]))
        inside |= 1U << j;
    return inside;
  }
  void make_room() override {
    digging_.room += 5;
    doomed_.resize(digging_.room);
    facets_.resize(2 * digging_.room + 8);
    digging_.doomed = doomed_.data();
    digging_.facets = facets_.data();
  }

  const std::vector<Site>& sites_;
  delaunay::Digging<Index> digging_;
  std::vector<Index> doomed_;
  std::vector<delaunay::CavityFacet<Index>> facets_;
};

/// The first four points are vertices of a tetrahedron.
template <class Index>
void dig_into(const Cloud& points) {
  using Inserter = delaunay::Inserter<Index, false>;
  const std::vector<Site> sites =
      sites_of(points, [](const mesh::Point&) { return std::uint64_t{0}; });
  delaunay::Cells<Index> cells;
  cells.reserve(8 * sites.size());
  std::vector<typename Inserter::Claim> claims(sites.size());
  Inserter inserter(cells, sites.data(), claims.data(), nullptr);
  inserter.begin(first_four<Index>(sites));
  for (Index s = 6; s < sites.size(); ++s) {
    const Index start = inserter.walk().located(sites[s]);
    std::vector<Index> doomed;
    std::vector<std::array<Index, 4>> facets;
    for (unsigned i = 0; i < 2 * implementations().size(); ++i) {
      Cavity<Index> cavity(cells, sites, start, sites[s]);
      cavity.dig(*implementations()[i / 2], i % 2 == 1);
      if (doomed.empty()) {
        doomed = cavity.doomed();
        facets = cavity.facets();
        for (std::size_t c = 1; c < cells.size(); ++c) {
          const auto& cell = cells[static_cast<Index>(c)];
          ASSERT_EQ(cell.is_marked(), cell.is_used() && cavity.conflicts(cell));
        }
      }
      ASSERT_EQ(cavity.doomed(), doomed);
      ASSERT_EQ(cavity.facets(), facets);
      cavity.fill_up();
    }
    ASSERT_EQ(inserter.insert(s), delaunay::Outcome::inserted);
    ASSERT_EQ(inserter.made().size(), facets.size());
  }
}

TEST(FilterChoice, TakesWhatLeavesLessOpen) {
  // Steps that a cavity leaves open: by the plain filter, by the thorough one.
  const auto share_of_thorough = [](std::size_t by_plain, std::size_t by_thorough) {
    delaunay::FilterChoice choice;
    int thorough = 0;
    for (int i = 0; i < 3200; ++i) {
      const bool is_thorough = choice.takes_thorough();
      thorough += is_thorough ? 1 : 0;
      choice.note(is_thorough, is_thorough ? by_thorough : by_plain);
    }
    return thorough / 3200.0;
  };
  EXPECT_GT(share_of_thorough(9, 0), 0.9);
  EXPECT_LT(share_of_thorough(0, 0), 0.1);
  EXPECT_LT(share_of_thorough(13, 13), 0.1);
}

TEST(Digging, FindsWhatIsInConflict) {
  Random random(20261123);
  dig_into<std::uint32_t>(uniform(300, random));
  dig_into<std::uint64_t>(uniform(300, random));
  dig_into<std::uint32_t>(sphere(200, random));
  dig_into<std::uint64_t>(paraboloid(200, random));
}

}  // namespace
