// Claim. No damaged mesh is accepted, whether its labels are damaged or the bytes of its file.
// Oracle. slow_oracle.hpp decides which random damages are true ones: a damage after which the mesh
// still obeys the strict rule with the right boundary (such as a rotated hexahedron) is no damage
// and is not counted. For bytes: what is read must have the content of the undamaged file.
#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <random>

#include "tables/check/malformed.hpp"
#include "tables/check/mesh_check.hpp"
#include "tests/sabotage/slow_oracle.hpp"
#include "tests/tables/check/example_files.hpp"
#include "tests/tables/check/example_meshes.hpp"

namespace hexatlas::check {
namespace {

using examples::Example;

class Saboteur {
 public:
  explicit Saboteur(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t count) { return random_() % count; }
  Hexahedron& cell(Example& e) { return e.mesh.hexahedra[below(e.mesh.hexahedra.size())]; }
  std::uint32_t vertex(const Example& e) {
    return static_cast<std::uint32_t>(below(e.mesh.points.size()));
  }

  /// Damages of every kind; the name of the kind is for the report.
  struct Damage {
    const char* name;
    std::function<void(Saboteur&, Example&)> apply;
  };
  static const std::vector<Damage>& damages();

 private:
  std::mt19937 random_;
};

void merge(Example& e, std::uint32_t from, std::uint32_t to) {
  for (Hexahedron& cell : e.mesh.hexahedra) std::replace(cell.begin(), cell.end(), from, to);
}

const std::vector<Saboteur::Damage>& Saboteur::damages() {
  static const std::vector<Damage> kDamages = {
      {"swap two labels of a cell",
       [](Saboteur& s, Example& e) {
         Hexahedron& cell = s.cell(e);
         std::swap(cell[s.below(8)], cell[s.below(8)]);
       }},
      {"replace a label",
       [](Saboteur& s, Example& e) {
         const std::uint32_t vertex = s.vertex(e);
         s.cell(e)[s.below(8)] = vertex;
       }},
      {"drop a cell",
       [](Saboteur& s, Example& e) {
         std::swap(s.cell(e), e.mesh.hexahedra.back());
         e.mesh.hexahedra.pop_back();
       }},
      {"duplicate a cell",
       [](Saboteur& s, Example& e) {
         const Hexahedron cell = s.cell(e);
         e.mesh.hexahedra.push_back(cell);
       }},
      {"merge two vertices", [](Saboteur& s, Example& e) { merge(e, s.vertex(e), s.vertex(e)); }},
      {"swap two labels everywhere",
       [](Saboteur& s, Example& e) {
         const std::uint32_t a = s.vertex(e);
         const std::uint32_t b = s.vertex(e);
         merge(e, a, 0xFFFFFFFF);
         merge(e, b, a);
         merge(e, 0xFFFFFFFF, b);
       }},
      {"reverse a cell",
       [](Saboteur& s, Example& e) {
         Hexahedron& cell = s.cell(e);
         std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
       }},
      {"permute the corners of a cell",
       [](Saboteur& s, Example& e) {
         Hexahedron& cell = s.cell(e);
         std::shuffle(cell.begin(), cell.end(), s.random_);
       }},
      {"twist a quad of a cell",
       [](Saboteur& s, Example& e) {
         Hexahedron& cell = s.cell(e);
         std::rotate(cell.begin(), cell.begin() + 1 + static_cast<std::ptrdiff_t>(s.below(3)),
                     cell.begin() + 4);
       }},
      {"move a boundary point by one bit",
       [](Saboteur& s, Example& e) {
         double& x = e.mesh.points[s.below(e.surface.points.size())][s.below(3)];
         std::uint64_t bits = 0;
         std::memcpy(&bits, &x, sizeof x);
         bits ^= std::uint64_t{1} << s.below(64);
         std::memcpy(&x, &bits, sizeof x);
       }},
      {"swap two boundary points",
       [](Saboteur& s, Example& e) {
         std::swap(e.mesh.points[s.below(e.surface.points.size())],
                   e.mesh.points[s.below(e.surface.points.size())]);
       }},
      {"swap two labels of a boundary quad",
       [](Saboteur& s, Example& e) {
         Quad& quad = e.surface.quads[s.below(e.surface.quads.size())];
         std::swap(quad[s.below(2)], quad[2 + s.below(2)]);
       }},
      {"replace a label of a boundary quad",
       [](Saboteur& s, Example& e) {
         Quad& quad = e.surface.quads[s.below(e.surface.quads.size())];
         quad[s.below(4)] = static_cast<std::uint32_t>(s.below(e.surface.points.size()));
       }},
      {"drop a boundary quad", [](Saboteur&, Example& e) { e.surface.quads.pop_back(); }},
  };
  return kDamages;
}

std::vector<Example> valid_meshes() {
  using examples::box;
  using examples::cubes;
  return {cubes(box(1, 1, 1)),
          cubes(box(2, 1, 1)),
          cubes(box(2, 2, 2)),
          cubes(box(3, 3, 3)),
          cubes(box(4, 2, 1)),
          examples::cube_in_cube(),
          examples::three_around_an_edge()};
}

/// The oracle compares oriented cycles. A surface that is damaged to be incoherent is compared by
/// the judge without orientation, so a quad that is only reversed is no true damage.
bool is_true_damage(const Example& good, const Example& bad) {
  if (oracle::fits(bad.mesh, bad.surface)) return false;
  Example oriented = bad;
  for (std::size_t q = 0; q < bad.surface.quads.size(); ++q) {
    const Quad before = oracle::cycle(good.surface.quads[q]);
    const Quad after = oracle::cycle(bad.surface.quads[q]);
    if (after == Quad{before[0], before[3], before[2], before[1]}) {
      oriented.surface.quads[q] = before;
    }
  }
  return !oracle::fits(oriented.mesh, oriented.surface);
}

TEST(MeshSabotage, TheUndamagedMeshesAreAccepted) {
  for (const Example& example : valid_meshes()) {
    EXPECT_TRUE(oracle::fits(example.mesh, example.surface));
    const Verdict verdict = check_mesh(example.mesh, &example.surface);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
  }
}

TEST(MeshSabotage, NoDamagedMeshIsAccepted) {
  std::size_t true_damages = 0;
  for (const auto& damage : Saboteur::damages()) {
    SCOPED_TRACE(damage.name);
    std::size_t of_this_kind = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
      Saboteur saboteur(seed);
      for (const Example& good : valid_meshes()) {
        Example bad = good;
        damage.apply(saboteur, bad);
        if (!is_true_damage(good, bad)) continue;
        ++of_this_kind;
        const Verdict verdict = check_mesh(bad.mesh, &bad.surface);
        EXPECT_FALSE(verdict.accepted) << "seed " << seed;
        EXPECT_FALSE(verdict.reason.empty());
      }
    }
    EXPECT_GE(of_this_kind, 10U);
    true_damages += of_this_kind;
  }
  EXPECT_GE(true_damages, 400U);
  RecordProperty("true_damages", static_cast<int>(true_damages));
}

/// Empty, or what the judge saw wrong with the bytes.
std::string judge(const std::string& name, const std::string& bytes, const Example& good) {
  try {
    const Mesh mesh = parse_mesh(name, bytes);
    const Verdict verdict = check_mesh(mesh, &good.surface);
    if (!verdict.accepted) return verdict.reason;
    const bool same_points = std::memcmp(mesh.points.data(), good.surface.points.data(),
                                         good.surface.points.size() * sizeof(Point)) == 0;
    EXPECT_TRUE(same_points);
    EXPECT_EQ(mesh.points.size(), good.mesh.points.size());
    EXPECT_EQ(mesh.hexahedra, good.mesh.hexahedra);
    return {};
  } catch (const Malformed& error) {
    return error.what();
  }
}

TEST(MeshSabotage, NoDamagedFileIsTakenForAnotherMesh) {
  Example good = examples::cubes(examples::box(2, 2, 2));
  good.mesh.quads = good.surface.quads;
  std::mt19937 random(7);
  for (const auto& format : examples::kMeshFormats) {
    SCOPED_TRACE(format.name);
    const std::string bytes = format.write(good.mesh);
    ASSERT_EQ(judge(format.name, bytes, good), "");
    std::size_t refused = 0;
    constexpr std::size_t kDamages = 700;
    for (std::size_t round = 0; round < kDamages; ++round) {
      std::string bad = bytes;
      char& byte = bad[random() % bad.size()];
      byte = round % 2 == 0 ? static_cast<char>(random() % 256) : "0123456789 \n-."[random() % 14];
      if (!judge(format.name, bad, good).empty()) ++refused;
    }
    EXPECT_GE(refused, kDamages / 4);
    for (std::size_t size = 0; size < bytes.size(); size += 11) {
      const std::string cut = bytes.substr(0, size);
      static_cast<void>(judge(format.name, cut, good));
      if (size < bytes.size() * 9 / 10) {
        EXPECT_NE(judge(format.name, cut, good), "") << size;
      }
    }
  }
}

TEST(MeshSabotage, NoDamagedSurfaceFileIsTakenForAnotherSurface) {
  const Example good = examples::cubes(examples::box(2, 2, 2));
  std::mt19937 random(8);
  for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"a.obj", examples::obj(good.surface)}, {"a.off", examples::off(good.surface)}}) {
    std::size_t refused = 0;
    for (std::size_t round = 0; round < 700; ++round) {
      std::string bad = bytes;
      bad[random() % bad.size()] = "0123456789 \n-.vf#"[random() % 17];
      try {
        const Surface surface = parse_surface(name, bad);
        if (!check_mesh(good.mesh, &surface).accepted) {
          ++refused;
          continue;
        }
        ASSERT_EQ(surface.points.size(), good.surface.points.size());
        EXPECT_EQ(surface.points, good.surface.points);
        EXPECT_EQ(surface.quads, good.surface.quads);
      } catch (const Malformed&) {
        ++refused;
      }
    }
    EXPECT_GE(refused, 300U);
  }
}

}  // namespace
}  // namespace hexatlas::check
