// Claim. No damaged hybrid mesh is accepted, and none is refused that is still one with the
// boundary that it must have. Oracle. hybrid_oracle.hpp decides by brute force which random damages
// are true ones.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <span>

#include "tables/check/hybrid_check.hpp"
#include "tests/share.hpp"
#include "tests/tables/check/hybrid_examples.hpp"
#include "tests/tables/check/hybrid_oracle.hpp"

namespace hexatlas::check {
namespace {

constexpr int kRounds = support::by_length(6, 40);

class Saboteur {
 public:
  explicit Saboteur(unsigned seed) : random_(seed) {}

  std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(random_() % count); }

  /// Some cell, as its vertices; of a mesh that has one.
  std::span<std::uint32_t> cell(HybridMesh& mesh) {
    while (true) {
      switch (below(4)) {
        case 0:
          if (!mesh.tetrahedra.empty()) return some(mesh.tetrahedra);
          break;
        case 1:
          if (!mesh.hexahedra.empty()) return some(mesh.hexahedra);
          break;
        case 2:
          if (!mesh.prisms.empty()) return some(mesh.prisms);
          break;
        default:
          if (!mesh.pyramids.empty()) return some(mesh.pyramids);
      }
    }
  }

  /// Applies `change` to a list of cells that is not empty.
  template <class Change>
  void change_list(HybridMesh& mesh, const Change& change) {
    const std::size_t size = cell(mesh).size();
    if (size == 4) change(mesh.tetrahedra);
    if (size == 8) change(mesh.hexahedra);
    if (size == 6) change(mesh.prisms);
    if (size == 5) change(mesh.pyramids);
  }

 private:
  std::span<std::uint32_t> some(auto& list) { return list[below(list.size())]; }

  std::mt19937 random_;
};

struct Damage {
  const char* name;
  std::function<void(Saboteur&, HybridMesh&)> apply;
};

template <class List>
auto taken(List& list, std::uint32_t i) {
  const auto cell = list[i];
  list.erase(list.begin() + i);
  return cell;
}

void split_hexahedron(HybridMesh& mesh, std::uint32_t i, std::uint32_t way) {
  const Hexahedron h = taken(mesh.hexahedra, i);
  // Along a diagonal of the bottom, or of the facet 0 3 7 4.
  if (way % 2 == 0) {
    mesh.prisms.push_back({h[0], h[1], h[2], h[4], h[5], h[6]});
    mesh.prisms.push_back({h[0], h[2], h[3], h[4], h[6], h[7]});
  } else {
    mesh.prisms.push_back({h[0], h[3], h[7], h[1], h[2], h[6]});
    mesh.prisms.push_back({h[0], h[7], h[4], h[1], h[6], h[5]});
  }
}

const std::vector<Damage>& damages() {
  static const std::vector<Damage> kDamages = {
      {"change an index",
       [](Saboteur& s, HybridMesh& m) {
         const auto cell = s.cell(m);
         cell[s.below(cell.size())] = s.below(m.points.size() + 1);
       }},
      {"exchange two vertices",
       [](Saboteur& s, HybridMesh& m) {
         const auto cell = s.cell(m);
         std::swap(cell[s.below(cell.size())], cell[s.below(cell.size())]);
       }},
      {"shuffle a cell",
       [](Saboteur& s, HybridMesh& m) {
         const auto cell = s.cell(m);
         for (std::size_t i = cell.size(); i > 1; --i) std::swap(cell[i - 1], cell[s.below(i)]);
       }},
      {"turn a cell",
       [](Saboteur& s, HybridMesh& m) {
         const auto cell = s.cell(m);
         const std::size_t turn = cell.size() == 5 || cell.size() == 8 ? 4 : 3;
         std::rotate(cell.begin(), cell.begin() + 1, cell.begin() + turn);
         if (cell.size() == 8 || cell.size() == 6)
           std::rotate(cell.begin() + turn, cell.begin() + turn + 1, cell.end());
       }},
      {"leave a cell out",
       [](Saboteur& s, HybridMesh& m) {
         s.change_list(m, [&](auto& list) { taken(list, s.below(list.size())); });
       }},
      {"repeat a cell",
       [](Saboteur& s, HybridMesh& m) {
         s.change_list(m, [&](auto& list) { list.push_back(list[s.below(list.size())]); });
       }},
      {"make two points one",
       [](Saboteur& s, HybridMesh& m) {
         const std::uint32_t a = s.below(m.points.size()), b = s.below(m.points.size());
         const auto replace = [&](auto& list) {
           for (auto& cell : list) std::replace(cell.begin(), cell.end(), a, b);
         };
         replace(m.tetrahedra);
         replace(m.hexahedra);
         replace(m.prisms);
         replace(m.pyramids);
       }},
      {"make one point two",
       [](Saboteur& s, HybridMesh& m) {
         const auto cell = s.cell(m);
         std::uint32_t& vertex = cell[s.below(cell.size())];
         m.points.push_back(m.points[vertex]);
         vertex = static_cast<std::uint32_t>(m.points.size() - 1);
       }},
      {"move a point far",
       [](Saboteur& s, HybridMesh& m) {
         m.points[s.below(m.points.size())][s.below(3)] += 8.0 * s.below(7) - 24;
       }},
      {"move a point a little",
       [](Saboteur& s, HybridMesh& m) {
         m.points[s.below(m.points.size())][s.below(3)] += s.below(5) - 2.0;
       }},
      {"cut a hexahedron in prisms",
       [](Saboteur& s, HybridMesh& m) {
         if (!m.hexahedra.empty()) split_hexahedron(m, s.below(m.hexahedra.size()), s.below(2));
       }},
      {"cut a pyramid in tetrahedra",
       [](Saboteur& s, HybridMesh& m) {
         if (m.pyramids.empty()) return;
         const Pyramid p = taken(m.pyramids, s.below(m.pyramids.size()));
         const std::size_t i = s.below(2);
         m.tetrahedra.push_back({p[i], p[i + 1], p[i + 2], p[4]});
         m.tetrahedra.push_back({p[i], p[i + 2], p[(i + 3) % 4], p[4]});
       }},
      {"exchange the points of two vertices",
       [](Saboteur& s, HybridMesh& m) {
         std::swap(m.points[s.below(m.points.size())], m.points[s.below(m.points.size())]);
       }},
      {"a tetrahedron for a pyramid",
       [](Saboteur& s, HybridMesh& m) {
         if (m.pyramids.empty()) return;
         const Pyramid p = taken(m.pyramids, s.below(m.pyramids.size()));
         m.tetrahedra.push_back({p[0], p[1], p[3], p[4]});
       }},
  };
  return kDamages;
}

TEST(HybridSabotage, TheJudgeSaysWhatBruteForceSays) {
  std::map<std::string, std::array<int, 2>> counts;
  std::map<HybridLaw, int> laws;
  for (unsigned seed = 0; seed < static_cast<unsigned>(kRounds); ++seed) {
    const examples::Lattice size = {static_cast<int>(1 + seed % 3), 2,
                                    static_cast<int>(1 + seed % 2)};
    const examples::Example example =
        examples::make_example(seed, size, static_cast<int>(seed % 2));
    Saboteur saboteur(seed);
    for (const Damage& damage : damages())
      for (int i = 0; i < 8; ++i) {
        HybridMesh mesh = example.mesh;
        damage.apply(saboteur, mesh);
        const bool is_good = oracle::accepts(mesh, example.given);
        const HybridVerdict verdict = check_hybrid(mesh, &example.given);
        ASSERT_EQ(verdict.accepted, is_good)
            << damage.name << ", seed " << seed << ": " << verdict.reason;
        ++counts[damage.name][is_good ? 1 : 0];
        ++laws[verdict.broken];
      }
  }
  for (const Damage& damage : damages()) {
    const auto [refused, accepted] = counts[damage.name];
    EXPECT_EQ(refused + accepted, 8 * kRounds);
    std::printf("%-36s %5d refused %5d accepted\n", damage.name, refused, accepted);
    EXPECT_EQ(refused == 0, std::string(damage.name) == "turn a cell") << damage.name;
  }
  for (const HybridLaw law : {HybridLaw::kCorners, HybridLaw::kPositive, HybridLaw::kTwoCells,
                              HybridLaw::kDiagonal, HybridLaw::kGivenBoundary})
    EXPECT_GT(laws[law], 0) << name_of(law);
}

}  // namespace
}  // namespace hexatlas::check
