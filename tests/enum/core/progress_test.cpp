#include "enum/core/progress.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace hexatlas::core {
namespace {

using Reader = Progress::Reader;

TEST(Progress, IsSaidOnATerminalAtMostFiveTimesASecondAndAtEachPhase) {
  Progress progress(Reader::terminal, 100);
  EXPECT_EQ(progress.update("cuts", 0, 10, 100.0), "cuts: 0 of 10, 0 s");
  EXPECT_EQ(progress.update("cuts", 1, 10, 100.1), std::nullopt);
  EXPECT_EQ(progress.update("collars", 0, 7, 100.15), "collars: 0 of 7, 0 s");
  EXPECT_EQ(progress.update("collars", 1, 7, 101.15), "collars: 1 of 7, 1 s");
}

TEST(Progress, ToldToALogIsRareAndNeverSilentForMoreThanTenMinutes) {
  Progress progress(Reader::log, 0);
  std::vector<int> said;
  for (int second = 0; second <= 3600; ++second)
    if (progress.update("cuts", 1, 2, second)) said.push_back(second);
  EXPECT_EQ(said, (std::vector{60, 120, 240, 480, 960, 1560, 2160, 2760, 3360}));
}

TEST(Progress, NamesEachPhaseInALogUnlessSomethingWasSaidWithinAMinute) {
  Progress progress(Reader::log, 1000);
  EXPECT_EQ(progress.update("sweep", 0, 2, 1000), std::nullopt);
  ASSERT_TRUE(progress.update("sweep", 1, 2, 1240));
  EXPECT_EQ(progress.update("cuts", 0, 9, 1299), std::nullopt);
  EXPECT_EQ(progress.update("collars", 0, 7, 1300), "collars: 0 of 7, 0 s");
  EXPECT_EQ(progress.update("collars", 1, 7, 1400), std::nullopt);
  EXPECT_EQ(progress.update("annealing", 0, 5, 1400), "annealing: 0 of 5, 0 s");
  // What is said of phases puts off nothing else.
  EXPECT_EQ(progress.update("annealing", 1, 5, 1480),
            "annealing: 1 of 5, 80 s, about 5 min more at this pace");
}

TEST(Progress, EstimatesWhatIsLeftFromThePaceOfThePhase) {
  Progress progress(Reader::terminal, 0);
  // A search that goes on began at 500 of 1,000: its pace is that of what it did since.
  ASSERT_TRUE(progress.update("collars", 500, 1000, 50));
  EXPECT_EQ(progress.update("collars", 501, 1000, 51), "collars: 501 of 1000, 1 s");
  EXPECT_EQ(progress.update("collars", 600, 1000, 60),
            "collars: 600 of 1000, 10 s, about 40 s more at this pace");
  EXPECT_EQ(progress.update("collars", 600, 1000, 350),
            "collars: 600 of 1000, 5 min, about 20 min more at this pace");
  EXPECT_EQ(progress.update("collars", 601, 1000, 10'150),
            "collars: 601 of 1000, 3 h, about 11 h more at this pace");
  EXPECT_EQ(progress.update("collars", 1000, 1000, 10'151), "collars: 1000 of 1000, 3 h");
}

TEST(Progress, EstimatesNothingWhereTheTotalIsUnknownOrGrows) {
  Progress progress(Reader::terminal, 0);
  ASSERT_TRUE(progress.update("spheres", 1, 2, 0));
  EXPECT_EQ(progress.update("spheres", 10, 90, 10), "spheres: 10 of 90, 10 s");
  EXPECT_EQ(progress.update("spheres", 20, 90, 20), "spheres: 20 of 90, 20 s");
  EXPECT_EQ(progress.update("steps", 1, 0, 21), "steps: 1, 0 s");
  EXPECT_EQ(progress.update("steps", 2, 0, 30), "steps: 2, 9 s");
}

}  // namespace
}  // namespace hexatlas::core
