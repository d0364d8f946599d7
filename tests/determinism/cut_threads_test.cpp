// Claim. Cuts and exchanges of many boundaries at once give what they give one after the other, the
// lists of discs being made by whichever thread comes first.
// Oracle. The run on one thread, after it.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "enum/flips/cut.hpp"
#include "enum/flips/replacement.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tests/enum/flips/small_beam.hpp"

namespace {

using namespace hexatlas;

std::vector<std::vector<complex::Hexahedron>> meshes(const flips::Beam& beam, int threads) {
  std::vector<canon::Code> codes = beam.codes();
  std::erase_if(codes, [](const canon::Code& code) { return code.quads < 12; });
  std::vector<std::vector<complex::Hexahedron>> result(codes.size());
  parallel::parallel_for(threads, codes.size(), [&](std::size_t i) {
    auto mesh = flips::best_cut(flips::BeamBalls(beam), codes[i], {});
    if (!mesh) return;
    const auto smaller = flips::smaller_by_replacement(*mesh, codes[i].quads, beam,
                                                       {5, 1, /*keep_shellable=*/false});
    result[i] = smaller ? smaller->hexahedra : mesh->hexahedra;
  });
  return result;
}

TEST(CutThreads, DoNotChangeTheResult) {
  const flips::Beam beam = support::grown(18, 6, 300, 14);
  const auto together = meshes(beam, 4);
  EXPECT_EQ(together, meshes(beam, 1));
  EXPECT_GT(std::count_if(together.begin(), together.end(),
                          [](const auto& cells) { return !cells.empty(); }),
            30);
}

}  // namespace
