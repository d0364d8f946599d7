// Claim. The census of shellable balls does not depend on the number of threads.
// Oracle. The run on one thread.
#include <gtest/gtest.h>

#include <string>

#include "enum/hexes/shellings.hpp"

namespace {

using namespace hexatlas;

std::string list(int threads) {
  return hexes::shellings_text(hexes::shellable_balls({.hexahedra = 6, .threads = threads}),
                               threads);
}

TEST(ShellingsThreads, DoNotChangeTheResult) {
  const std::string together = list(4);
  EXPECT_EQ(together, list(1));
  EXPECT_EQ(together.substr(0, 18), "shellings 1 6 441\n");
}

}  // namespace
