// Claim. The chart has a bar for each number of hexahedra, its height as its caption says, on one
// scale; text is escaped; medians are medians. Oracle. Sorted lists; the attributes of the
// rectangles, read back from the text.
#include "tables/sheet/distribution_chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace hexatlas;
using sheet::Distribution;

TEST(Distribution, HasTheMedianOfASortedList) {
  unsigned state = 1;
  const auto below = [&](unsigned bound) {
    return (state = state * 1103515245U + 12345U) / 65536U % bound;
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<int> list;
    Distribution distribution;
    for (unsigned i = 0; i < 1 + below(9); ++i) list.push_back(static_cast<int>(1 + below(5)));
    for (const int hexahedra : list) ++distribution.meshes[hexahedra];
    std::sort(list.begin(), list.end());
    EXPECT_EQ(distribution.median(), (list[(list.size() - 1) / 2] + list[list.size() / 2]) / 2.0);
    EXPECT_EQ(distribution.entries(), list.size());
    std::size_t sum = 0;
    for (const int hexahedra : list) sum += static_cast<std::size_t>(hexahedra);
    EXPECT_EQ(distribution.hexahedra(), sum);
  }
}

/// Heights of the bars in order, without the ground.
std::vector<double> heights(const std::string& svg) {
  const std::string bar = "<rect x=";
  const std::string height = " height=\"";
  std::vector<double> result;
  for (auto at = svg.find(bar); at != std::string::npos; at = svg.find(bar, at + 1))
    result.push_back(std::stod(svg.substr(svg.find(height, at) + height.size())));
  return result;
}

TEST(DistributionChart, HeightsAreOnOneScale) {
  const Distribution few{6, {{1, 4}, {7, 8}}, true};
  const std::string linear = sheet::distribution_chart({few, {8, {{40, 2}}, false}}, "t");
  EXPECT_NE(linear.find("linear scale"), std::string::npos);
  const std::vector<double> bars = heights(linear);
  ASSERT_EQ(bars.size(), 3U);
  EXPECT_NEAR(bars[1], 2 * bars[0], 0.02);
  EXPECT_NEAR(bars[1], 4 * bars[2], 0.04);
  const std::string logarithmic =
      sheet::distribution_chart({few, {8, {{40, 1}, {41, 1000}, {42, 10}, {43, 100}}, false}}, "t");
  EXPECT_NE(logarithmic.find("logarithmic scale"), std::string::npos);
  const std::vector<double> logs = heights(logarithmic);
  ASSERT_EQ(logs.size(), 6U);
  EXPECT_GT(logs[2], 5) << "one quadrangulation can be seen";
  EXPECT_NEAR(logs[3] - logs[5], logs[5] - logs[4], 0.03);
  EXPECT_NEAR(logs[4] - logs[2], logs[5] - logs[4], 0.03);
  EXPECT_NEAR(logs[1] - logs[0], std::log10(2) * (logs[5] - logs[4]), 0.03);
}

TEST(DistributionChart, SaysInWordsWhatItShows) {
  const std::string svg = sheet::distribution_chart(
      {{6, {{1, 1}}, true}, {20, {{40, 49'000}, {45, 957}}, false}}, "a < b & c > d");
  EXPECT_NE(svg.find("<title id=\"title\">a &lt; b &amp; c &gt; d</title>"), std::string::npos);
  EXPECT_NE(svg.find("6 quads: 1 quadrangulation (all), median 1;"), std::string::npos);
  EXPECT_NE(svg.find("20 quads: 49,957 quadrangulations, median 40; from 40 to 45"),
            std::string::npos);
  EXPECT_EQ(heights(sheet::distribution_chart({}, "t")).size(), 0U);
}

}  // namespace
