// Claim. A beam that was saved and restored goes on as if it had never stopped; bytes that are not
// what was saved are refused, or every state restored from them has the mesh that it claims.
// Oracle. The uninterrupted search; meshes by sets.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "enum/core/errors.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/flips/replacement.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using flips::Beam;

const flips::State kSingle = flips::canonical_state(flips::single_hexahedron()).state;

flips::BeamOptions narrow() {
  flips::BeamOptions options;
  options.max_quads = 20;
  options.fronts_per_class = 4;
  options.fronts_per_level = 150;
  return options;
}

Beam restored(const std::string& bytes, const flips::BeamOptions& options = narrow()) {
  return Beam::from_bytes(bytes, kSingle, options, "saved");
}

TEST(SavedBeam, GoesOnAsIfItHadNeverStopped) {
  Beam beam(kSingle, narrow());
  for (int level = 0; level < 20; ++level) {
    const std::string bytes = beam.to_bytes();
    flips::BeamOptions threads = narrow();
    threads.threads = 1 + level % 3;
    Beam other = restored(bytes, threads);
    EXPECT_EQ(other.to_bytes(), bytes);
    (void)beam.expand_level();
    (void)other.expand_level();
    ASSERT_EQ(other.to_bytes(), beam.to_bytes()) << level;
  }
  EXPECT_FALSE(beam.is_exhaustive());
  beam.rewind();
  Beam again = restored(beam.to_bytes());
  for (int level = 0; level < 20; ++level) {
    (void)beam.expand_level();
    (void)again.expand_level();
  }
  EXPECT_EQ(again.to_bytes(), beam.to_bytes());
}

/// Annealing draws its random numbers by the least level of each family, in which a sweep after the
/// first one leaves nothing of what it passed over.
TEST(SavedBeam, KnowsTheLeastLevelOfEachFamily) {
  flips::BeamOptions thin = narrow();
  thin.fronts_per_class = 3;
  thin.fronts_per_level = 60;
  Beam beam(kSingle, thin);
  for (int sweep = 0; sweep < 2; ++sweep) {
    if (sweep > 0) beam.rewind();
    for (int level = 0; level < 30; ++level) (void)beam.expand_level();
    std::size_t added = 0;
    for (const auto& code : beam.codes()) {
      const auto id = beam.smallest(code).value();
      if (beam.level_of(id) < 3 || id.family % 3 != 0) continue;
      if (const auto mesh = flips::smaller_by_replacement(flips::filling_of(beam, id).mesh,
                                                          code.quads, beam, {20, 1, true, 0})) {
        (void)flips::add_ball(beam, *mesh, flips::FrontOrigin::exchanged);
        ++added;
      }
    }
    EXPECT_GT(added, 0U);
  }
  beam.rewind();
  for (int level = 0; level < 30; ++level) (void)beam.expand_level();
  const Beam again = restored(beam.to_bytes(), thin);
  for (std::size_t shard = 0; shard < flips::FrontStore::kShards; ++shard) {
    const auto families = beam.store().families(shard);
    const auto others = again.store().families(shard);
    ASSERT_EQ(families.size(), others.size());
    for (std::size_t i = 0; i < families.size(); ++i) {
      EXPECT_EQ(families[i].level_floor, others[i].level_floor);
      for (const auto& front : families[i].fronts) EXPECT_GE(front.level, families[i].level_floor);
    }
  }
}

TEST(SavedBeam, MayHoldBallsThatWereAddedWithWiderBoundaries) {
  flips::BeamOptions wide = narrow();
  wide.max_quads = 24;
  Beam source(kSingle, wide);
  for (int level = 0; level < 8; ++level) (void)source.expand_level();
  Beam beam(kSingle, narrow());
  std::size_t added = 0;
  for (const auto& code : source.codes())
    if (code.quads == 24) {
      const auto mesh = flips::filling_of(source, source.fronts_of(code)[0].id).mesh;
      (void)flips::add_ball(beam, mesh, flips::FrontOrigin::met);
      ++added;
    }
  EXPECT_GT(added, 10U);
  EXPECT_EQ(restored(beam.to_bytes()).to_bytes(), beam.to_bytes());
}

TEST(SavedBeam, OfOtherOptionsOrCutShortIsRefused) {
  Beam beam(kSingle, narrow());
  for (int level = 0; level < 8; ++level) (void)beam.expand_level();
  const std::string bytes = beam.to_bytes();
  flips::BeamOptions other = narrow();
  other.seed = 2;
  EXPECT_THROW((void)restored(bytes, other), core::InvalidInput);
  other = narrow();
  other.max_quads = 22;
  EXPECT_THROW((void)restored(bytes, other), core::InvalidInput);
  other = narrow();
  other.scars_per_irregularity = 1;
  EXPECT_THROW((void)restored(bytes, other), core::InvalidInput);
  other = narrow();
  other.scars_per_simple_zone = 1;
  EXPECT_THROW((void)restored(bytes, other), core::InvalidInput);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 40)
    EXPECT_THROW((void)restored(bytes.substr(0, size)), core::InvalidInput) << size;
  EXPECT_THROW((void)restored(bytes + "x"), core::InvalidInput);
}

TEST(SavedBeam, NeverGivesAMeshThatIsNone) {
  Beam beam(kSingle, narrow());
  for (int level = 0; level < 9; ++level) (void)beam.expand_level();
  const std::string bytes = beam.to_bytes();
  std::mt19937_64 random(3);
  int refused = 0;
  for (int trial = 0; trial < support::share_of(100); ++trial) {
    std::string damaged = bytes;
    damaged[random() % damaged.size()] ^= static_cast<char>(1U << random() % 8);
    try {
      const Beam other = restored(damaged);
      for (const auto& code : other.codes())
        for (const auto& record : other.fronts_of(code))
          ASSERT_EQ(support::fault_of_filling(flips::filling_of(other, record.id).mesh, code), "");
    } catch (const core::InvalidInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, support::share_of(50));
}

}  // namespace
