// Claim. An involution of a boundary extends to a mesh exactly where hexahedra go to hexahedra; a
// symmetric walk keeps it, and the boundary, and knows the faults of its mesh, which obeys the
// strict rule when there are none. Only symmetric balls change how many hexahedra are their own
// images. Annealing that keeps an involution finds fewer hexahedra by itself, the same for any
// number of threads.
// Oracle. Sets: images of hexahedra, boundaries, faults; the involution carried over from facet to
// facet.
#include "enum/flips/symmetric_walk.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "enum/flips/annealing.hpp"
#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/extension.hpp"
#include "tests/enum/flips/faults.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::HexComplex;
using flips::SubBall;
using flips::SymmetricBeam;
using support::cells_of;

constexpr flips::BeamOptions kWidths{
    .max_quads = 22, .fronts_per_class = 100, .fronts_per_level = 60, .threads = 2};

/// A mesh and an involution that it has.
struct Symmetric {
  HexComplex mesh;
  canon::Code code;
  flips::Involution involution;
};

/// Some balls with so many hexahedra and at least 10 quads.
std::vector<Symmetric> symmetric_meshes(bool are_mirrored, int hexahedra, std::size_t count) {
  SymmetricBeam beam(flips::small_symmetric_balls(4, are_mirrored), flips::Growth::outward,
                     kWidths);
  while (beam.level() < hexahedra) (void)beam.expand_level();
  std::vector<Symmetric> result;
  for (std::size_t i = 0; i < beam.nodes().size() && result.size() < count; i += 7) {
    const auto& node = beam.nodes()[i];
    if (node.state.code.quads < 10) continue;
    Symmetric own{support::mesh_of(beam.layers_to(node)), node.state.code, {{}, are_mirrored}};
    std::copy(node.state.image.begin(), node.state.image.begin() + node.state.code.quads + 2,
              own.involution.image.begin());
    result.push_back(std::move(own));
  }
  return result;
}

/// Whether it is an involution of the mesh and the given one on the boundary.
void expect_involution(const flips::MeshInvolution& found, const flips::Involution& of_boundary,
                       const HexComplex& mesh, int quads) {
  const auto& image = found.vertex;
  ASSERT_EQ(image.size(), mesh.vertices);
  for (std::uint32_t v = 0; v < image.size(); ++v) ASSERT_EQ(image[image[v]], v);
  for (std::uint32_t v = 0; v < static_cast<std::uint32_t>(quads) + 2; ++v)
    ASSERT_EQ(image[v], of_boundary.image[v]);
  for (std::size_t c = 0; c < mesh.hexahedra.size(); ++c) {
    std::set<std::uint32_t> moved;
    for (const auto v : mesh.hexahedra[c]) moved.insert(image[v]);
    const auto& to = mesh.hexahedra[found.cell[c]];
    ASSERT_EQ(moved, std::set<std::uint32_t>(to.begin(), to.end()));
  }
}

TEST(MeshInvolution, IsThereWhereHexahedraGoToHexahedra) {
  const auto beam = support::grown(16, 40, 2'000, 12);
  std::size_t there = 0, not_there = 0;
  for (const auto& code : beam.codes()) {
    const auto involutions = flips::involutions_of(canon::decode(code).value());
    if (involutions.empty()) continue;
    for (const auto& record : beam.fronts_of(code)) {
      const auto mesh = flips::filling_of(beam, record.id).mesh;
      for (const auto& involution : involutions) {
        const auto found =
            flips::extended(involution, mesh, code.quads, SubBall::neighbours_of(mesh));
        if (found) {
          expect_involution(*found, involution, mesh, code.quads);
          ++there;
          continue;
        }
        const std::vector<int> image(involution.image.begin(),
                                     involution.image.begin() + code.quads + 2);
        ASSERT_FALSE(support::Extension(mesh, image).is_there()) << canon::to_text(code);
        ++not_there;
      }
    }
  }
  EXPECT_GT(there, 50U);
  EXPECT_GT(not_there, 50U);
}

std::size_t own_images_in(const flips::MeshInvolution& involution) {
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < involution.cell.size(); ++c)
    count += involution.cell[c] == c ? 1U : 0U;
  return count;
}

struct Walked {
  int changes = 0, with_faults = 0, without = 0;
  int of_own_images = 0;  ///< changes of the number of hexahedra that are their own images
};

/// Walks from each of these meshes, each change checked.
Walked walked(const std::vector<Symmetric>& meshes, const flips::Beam& beam,
              const flips::SymmetricBalls* symmetric) {
  Walked result;
  for (const Symmetric& own : meshes) {
    const int quads = own.code.quads;
    flips::SymmetricWalk walk(own.mesh, quads, own.involution, beam, symmetric, 5);
    flips::BallLayers layers(beam);
    const auto boundary = oracle::boundary(cells_of(own.mesh));
    std::size_t own_images = own_images_in(
        flips::extended(own.involution, own.mesh, quads, SubBall::neighbours_of(own.mesh)).value());
    for (int step = 0; step < 240; ++step) {
      const flips::Climate climate =
          step / 30 % 2 == 0 ? flips::Climate(0.8, 0.7) : flips::Climate(0.3, 0.01);
      if (!walk.step(climate, layers)) continue;
      const auto cells = cells_of(walk.mesh());
      EXPECT_EQ(oracle::boundary(cells), boundary);
      EXPECT_EQ(walk.faults(), support::faults_of(cells));
      EXPECT_EQ(walk.faults() == 0, oracle::obeys_strict_rule(cells) &&
                                        support::fault_of_mesh(walk.mesh(), own.code).empty());
      const auto found =
          flips::extended(own.involution, walk.mesh(), quads, SubBall::neighbours_of(walk.mesh()));
      EXPECT_TRUE(found.has_value());
      if (!found) return result;
      expect_involution(*found, own.involution, walk.mesh(), quads);
      const std::size_t now = own_images_in(*found);
      if (now != own_images) ++result.of_own_images;
      own_images = now;
      ++result.changes;
      ++(walk.faults() == 0 ? result.without : result.with_faults);
    }
  }
  return result;
}

// Meshes with crowns have no hexahedra that are their own images under a half-turn, and hardly get
// any: so many meshes and steps.
TEST(SymmetricWalk, KeepsTheInvolutionAndKnowsTheFaults) {
  const auto beam = support::grown(18, 30, 3'000, 22);
  const flips::SymmetricBalls symmetric(kWidths, 12);
  for (const bool are_mirrored : {false, true}) {
    const auto meshes = symmetric_meshes(are_mirrored, 16, 18);
    ASSERT_EQ(meshes.size(), 18U);
    const Walked walk = walked(meshes, beam, &symmetric);
    EXPECT_GT(walk.with_faults, 72) << are_mirrored;
    EXPECT_GT(walk.without, 72) << are_mirrored;
    EXPECT_GT(walk.of_own_images, 5) << are_mirrored;
  }
}

TEST(SymmetricWalk, ChangesNoHexahedronThatIsItsOwnImageWithoutSymmetricBalls) {
  const auto beam = support::grown(18, 30, 3'000, 22);
  for (const bool are_mirrored : {false, true}) {
    const auto meshes = symmetric_meshes(are_mirrored, 16, 8);
    const Walked walk = walked(meshes, beam, nullptr);
    EXPECT_GT(walk.changes, 40) << are_mirrored;
    EXPECT_EQ(walk.of_own_images, 0) << are_mirrored;
  }
}

TEST(SymmetricAnnealing, FindsFewerHexahedraForAnyNumberOfThreads) {
  const auto beam = support::grown(18, 30, 3'000, 30);
  const flips::SymmetricBalls symmetric(kWidths, 12);
  // An odd number, so that the axis of a half-turn leads through hexahedra. One with 24 and crowns
  // around it stays what it is.
  for (const bool are_mirrored : {false, true}) {
    const auto meshes = symmetric_meshes(are_mirrored, 25, 4);
    ASSERT_EQ(meshes.size(), 4U);
    for (const Symmetric& own : meshes) {
      const auto least = [&](int symmetric_rounds, int threads) {
        return flips::least_by_annealing({{own.mesh}, {}}, own.code.quads, beam,
                                         {.rounds = 0,  // of the other annealing
                                          .leaps = 0,
                                          .threads = threads,
                                          .symmetric_rounds = symmetric_rounds,
                                          .symmetric = &symmetric});
      };
      const HexComplex found = least(2, 1);
      EXPECT_EQ(support::fault_of_mesh(found, own.code), "") << canon::to_text(own.code);
      EXPECT_LT(found.hexahedra.size(), own.mesh.hexahedra.size()) << canon::to_text(own.code);
      EXPECT_TRUE(
          flips::extended(own.involution, found, own.code.quads, SubBall::neighbours_of(found)));
      EXPECT_EQ(least(2, 3).hexahedra, found.hexahedra);
      EXPECT_EQ(least(0, 1).hexahedra, own.mesh.hexahedra);
    }
  }
}

}  // namespace
