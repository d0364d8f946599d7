// Claim. Annealing finds meshes with fewer hexahedra, never one larger than those that it begins
// with, the same for any number of threads; by leaps and by
// beginnings with faults it finds some that it does not find without.
// Oracle. Meshes checked by sets.
#include "enum/flips/annealing.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "enum/complex/dual_class.hpp"
#include "enum/flips/faulty_meeting.hpp"
#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using support::grown;

TEST(Annealing, FindsFewerHexahedraForAnyNumberOfThreads) {
  const auto beam = grown(20, 30, 2'000, 34);
  std::size_t reduced = 0;
  for (const auto& code : beam.codes()) {
    const auto records = beam.fronts_of(code);
    if (records.back().level < records.front().level + 6 || code.quads > 16) continue;
    const auto mesh = flips::filling_of(beam, records.back().id).mesh;
    flips::AnnealingOptions options{.rounds = 2, .leaps = 2, .seed = 7, .threads = 1};
    const auto least = flips::least_by_annealing({{mesh}, {}}, code.quads, beam, options);
    EXPECT_LT(least.hexahedra.size(), mesh.hexahedra.size()) << canon::to_text(code);
    EXPECT_EQ(support::fault_of_mesh(least, code), "") << canon::to_text(code);
    options.threads = 3;
    EXPECT_EQ(flips::least_by_annealing({{mesh}, {}}, code.quads, beam, options).hexahedra,
              least.hexahedra);
    if (++reduced == 8) break;
  }
  EXPECT_EQ(reduced, 8U);
}

TEST(Annealing, BeginsWithSeveralMeshes) {
  const auto beam = grown(20, 30, 2'000, 34);
  std::size_t tried = 0;
  for (const auto& code : beam.codes()) {
    const auto records = beam.fronts_of(code);
    if (records.size() < 5 || code.quads < 12) continue;
    std::vector<complex::HexComplex> starts;
    for (std::size_t i = 5; i-- > 0;)
      starts.push_back(flips::filling_of(beam, records[i * (records.size() - 1) / 4].id).mesh);
    flips::AnnealingOptions options{.rounds = 1, .leaps = 3, .seed = 3, .threads = 1};
    const auto least = flips::least_by_annealing({starts, {}}, code.quads, beam, options);
    for (const auto& mesh : starts) EXPECT_LE(least.hexahedra.size(), mesh.hexahedra.size());
    EXPECT_EQ(support::fault_of_mesh(least, code), "") << canon::to_text(code);
    options.threads = 2;
    EXPECT_EQ(flips::least_by_annealing({starts, {}}, code.quads, beam, options).hexahedra,
              least.hexahedra);
    if (++tried == 4) break;
  }
  EXPECT_EQ(tried, 4U);
}

TEST(Annealing, FindsMeshesOfOtherDualClassesByLeaps) {
  const auto beam = grown(20, 30, 2'000, 44);
  std::size_t tried = 0, in_other_class = 0;
  for (const auto& code : beam.codes()) {
    const auto records = beam.fronts_of(code);
    if ((records.back().level - records.front().level) % 2 == 0) continue;
    const auto mesh = flips::filling_of(beam, records.back().id).mesh;
    flips::AnnealingOptions options{.rounds = 1, .leaps = 0, .seed = 5, .threads = 2};
    const auto without = flips::least_by_annealing({{mesh}, {}}, code.quads, beam, options);
    options.leaps = 8;
    const auto least = flips::least_by_annealing({{mesh}, {}}, code.quads, beam, options);
    ASSERT_LE(least.hexahedra.size(), without.hexahedra.size()) << canon::to_text(code);
    ASSERT_EQ(support::fault_of_mesh(least, code), "") << canon::to_text(code);
    if (least.hexahedra.size() < without.hexahedra.size() &&
        complex::dual_class(least, mesh, static_cast<complex::VertexId>(code.quads + 2)) != 0)
      ++in_other_class;
    if (++tried == 20 || in_other_class == 3) break;
  }
  EXPECT_EQ(in_other_class, 3U) << "of " << tried;
}

TEST(Annealing, FindsFewerHexahedraBeginningWithFaults) {
  const auto beam = grown(20, 30, 2'000, 44);
  std::size_t tried = 0, smaller = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads != 20 || beam.first_level(code).value() < 38) continue;
    const auto mesh = flips::filling_of(beam, beam.smallest(code).value()).mesh;
    const flips::AnnealingOptions options{.rounds = 2, .leaps = 0, .seed = 7, .threads = 2};
    const auto without = flips::least_by_annealing({{mesh}, {}}, code.quads, beam, options);
    const flips::FaultyMeetingOptions meetings{
        .collars = {.max_quads = 22, .fronts_per_class = 10, .fronts_per_level = 200},
        .max_collar = 6,
        .wanted = {.below = static_cast<int>(without.hexahedra.size()) + 12, .count = 20}};
    const auto faulty = flips::faulty_meetings(beam, code, meetings);
    if (faulty.size() < 6) continue;
    const auto least = flips::least_by_annealing({{mesh}, faulty}, code.quads, beam, options);
    ASSERT_LE(least.hexahedra.size(), without.hexahedra.size()) << canon::to_text(code);
    ASSERT_EQ(support::fault_of_mesh(least, code), "") << canon::to_text(code);
    if (least.hexahedra.size() < without.hexahedra.size()) ++smaller;
    if (++tried == 40 || smaller == 2) break;
  }
  EXPECT_EQ(smaller, 2U) << "of " << tried;
}

TEST(Annealing, KeepsWhatItBeganWithIfItFindsNothing) {
  const auto beam = grown(12, 5, 100, 6);
  const auto code = beam.codes().front();  // the cube
  const auto mesh = flips::filling_of(beam, beam.fronts_of(code).front().id).mesh;
  EXPECT_EQ(flips::least_by_annealing({{mesh}, {}}, code.quads, beam, {.rounds = 2}).hexahedra,
            mesh.hexahedra);
}

}  // namespace
