// Claim. The judge accepts a log of a complete search, and no log that is none: of any change of a
// log, a header or a frame it says what a slow second reading of docs/formats/bound.md says. False
// claims have no log.
// Oracle. bound_oracle.hpp, which computes each state from its list of hexahedra alone and shares
// nothing with the judge but the document. Not every change is a damage: another place of a branch,
// another rule that holds, another limit within which the same log is right. What is accepted must
// be so by the second reading too. Whether a claim is true is found apart from all rules, by trying
// everything, for up to four hexahedra.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "tables/check/bound.hpp"
#include "tables/check/malformed.hpp"
#include "tests/sabotage/bound_oracle.hpp"
#include "tests/share.hpp"

namespace hexatlas::check {
namespace {

using namespace sabotage;

BoundText cube() {
  return {"q1:08a5df",
          {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
}

/// A ring of 2 k vertices, joined by turns to one of two others.
BoundText double_wheel(int k, const std::string& code) {
  BoundText text{code, {}};
  for (int i = 0; i < 2 * k; ++i) {
    text.quads.push_back({i, (i + 1) % (2 * k), (i + 2) % (2 * k), 2 * k + i % 2});
  }
  return text;
}

BoundText spindle() { return double_wheel(4, "q1:088a577f"); }

/// Layers of a square, vertex 4 z + i.
BoundText column(int cubes, const std::string& code) {
  BoundText text{code, {{0, 1, 2, 3}, {4 * cubes, 4 * cubes + 1, 4 * cubes + 2, 4 * cubes + 3}}};
  for (int z = 0; z < 4 * cubes; z += 4) {
    for (int i = 0; i < 4; ++i) {
      text.quads.push_back({z + i, z + (i + 1) % 4, z + 4 + (i + 1) % 4, z + 4 + i});
    }
  }
  return text;
}

/// Schneiders' pyramid: base points x + 3 y of a square of 3 x 3 points, each side cut at a middle.
BoundText pyramid() {
  BoundText text{"q1:02228a2a5777df7f", {}};
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) {
      const int v = x + 3 * y;
      text.quads.push_back({v, v + 1, v + 4, v + 3});
    }
  }
  const std::array<int, 8> around = {0, 1, 2, 5, 8, 7, 6, 3};
  for (int side = 0; side < 4; ++side) {
    const auto i = static_cast<std::size_t>(2 * side);
    // 9 the apex, 10 .. 13 middles of the slanted edges, 14 .. 17 those of the sides.
    const int own = 10 + side;
    const int next = 10 + (side + 1) % 4;
    text.quads.push_back({around[i], around[i + 1], 14 + side, own});
    text.quads.push_back({around[i + 1], around[(i + 2) % 8], next, 14 + side});
    text.quads.push_back({own, 14 + side, next, 9});
  }
  return text;
}

BoundText limited(BoundText text, bool is_ball, int hexahedra, int interior, bool has_symmetry) {
  text.is_ball = is_ball;
  text.hexahedra = hexahedra;
  text.interior = interior;
  text.has_symmetry = has_symmetry;
  return text;
}

BoundVerdict verdict_of(const BoundText& text) {
  return check_bound_bytes(framed(text_of(text)), "log");
}

bool is_accepted(const BoundText& text) {
  try {
    return verdict_of(text).accepted;
  } catch (const Malformed&) {
    return false;
  }
}

constexpr std::size_t kMostLog = 20'000;

/// True claims with logs that use all records.
const std::vector<BoundText>& samples() {
  static const std::vector<BoundText> all = [] {
    const BoundText wheel = double_wheel(5, "q1:0888a55dff");
    std::vector<BoundText> texts = {
        limited(spindle(), false, 1, 0, false), limited(spindle(), false, 7, 11, true),
        limited(spindle(), true, 9, 15, true),  limited(spindle(), false, 9, 15, false),
        limited(spindle(), true, 10, 4, true),  limited(spindle(), false, 9, 2, true),
        limited(spindle(), true, 8, 13, false), limited(wheel, false, 7, 10, true),
        limited(wheel, true, 8, 12, true),      limited(wheel, false, 6, 2, false),
        limited(pyramid(), false, 7, 7, true),  limited(pyramid(), true, 8, 9, true),
        limited(pyramid(), true, 6, 5, false),  limited(spindle(), true, 30, 10, true),
        limited(spindle(), true, 9, 15, false), limited(wheel, true, 8, 12, false),
        limited(pyramid(), true, 8, 9, false),  limited(wheel, false, 7, 10, false),
        limited(wheel, true, 9, 14, false),     limited(pyramid(), true, 7, 7, false)};
    std::vector<BoundText> some;  // of each boundary, and always the first two
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (i < 2 || i % support::kStride == 0) some.push_back(std::move(texts[i]));
    std::uint64_t seed = 1;
    for (BoundText& text : some) text.log = SlowBound(text).search(++seed, kMostLog).value();
    return some;
  }();
  return all;
}

TEST(BoundSabotage, LogsOfSearchesAreAccepted) {
  for (const BoundText& text : samples()) {
    const BoundVerdict verdict = verdict_of(text);
    EXPECT_TRUE(verdict.accepted) << verdict.fault;
    EXPECT_EQ(verdict.fault, "");
    EXPECT_EQ(verdict.code, text.code);
    EXPECT_EQ(verdict.is_ball, text.is_ball);
    EXPECT_EQ(verdict.hexahedra, text.hexahedra);
    EXPECT_EQ(verdict.interior, text.interior);
    const auto quads = static_cast<int>(text.quads.size());
    EXPECT_EQ(verdict.any_interior, text.interior >= 2 * text.hexahedra + 1 - quads / 2);
    EXPECT_GE(verdict.records, verdict.branches);
    EXPECT_LE(verdict.records + verdict.branches, text.log.size());
    EXPECT_TRUE(SlowBound(text).judge());
    EXPECT_TRUE(is_bound(framed(text_of(text))));
  }
}

TEST(BoundSabotage, SearchesUseAllRules) {
  if (support::kSanitized) GTEST_SKIP() << "of the oracle alone, which the other builds look at";
  std::map<int, int> used;
  const BoundText text = limited(pyramid(), true, 9, 11, true);
  SlowBound search(text);
  ASSERT_TRUE(search.search(7, kMostLog).has_value());
  used = search.used();
  SlowBound other(limited(double_wheel(5, "q1:0888a55dff"), true, 12, 20, true));
  ASSERT_TRUE(other.search(8, kMostLog).has_value());
  SlowBound third(limited(pyramid(), false, 3, 0, true));
  ASSERT_TRUE(third.search(11, kMostLog).has_value());
  for (const SlowBound* more : {&other, &third})
    for (const auto& [record, times] : more->used()) used[record] += times;
  for (int record = 0; record < 7; ++record) {
    EXPECT_GT(used[record], 0) << record;
  }
}

/// Records and places are small numbers.
char random_byte(std::mt19937_64& random) {
  return static_cast<char>(random() % 8 == 0 ? random() % 256 : random() % 8);
}

std::string changed_log(std::string log, std::mt19937_64& random) {
  const auto at = static_cast<std::ptrdiff_t>(random() % log.size());
  switch (random() % 7) {
    case 0:
    case 1:
      log[static_cast<std::size_t>(at)] = random_byte(random);
      break;
    case 2:
      log.insert(log.begin() + at, random_byte(random));
      break;
    case 3:
      log.erase(log.begin() + at);
      break;
    case 4:
      std::swap(log[static_cast<std::size_t>(at)], log[random() % log.size()]);
      break;
    case 5:
      log.resize(static_cast<std::size_t>(at));
      break;
    default: {
      const std::string& other = samples()[random() % samples().size()].log;
      log = log.substr(0, static_cast<std::size_t>(at)) + other.substr(random() % other.size());
    }
  }
  return log;
}

BoundText with_changed_header(BoundText text, std::mt19937_64& random) {
  const int step = random() % 2 == 0 ? 1 : -1;
  switch (random() % 6) {
    case 0:
      text.hexahedra += step;
      break;
    case 1:
      text.interior += step * static_cast<int>(1 + random() % 4);
      break;
    case 2:
      text.is_ball = !text.is_ball;
      break;
    case 3:
      text.has_symmetry = !text.has_symmetry;
      break;
    case 4:
      std::swap(text.quads[0], text.quads[random() % text.quads.size()]);
      break;
    default: {
      SlowQuad& quad = text.quads[random() % text.quads.size()];
      std::rotate(quad.begin(), quad.begin() + 1, quad.end());
      if (random() % 2 == 0) std::reverse(quad.begin(), quad.end());
    }
  }
  text.hexahedra = std::max(text.hexahedra, 0);
  text.interior = std::max(text.interior, 0);
  return text;
}

TEST(BoundSabotage, ChangedLogsAreJudgedAsByTheSlowReading) {
  constexpr int kRounds = support::share_of(3000);
  std::mt19937_64 random(1);
  int accepted = 0;
  int refused = 0;
  for (const BoundText& sample : samples()) {
    std::map<std::string, SlowBound> claims;  // by what stands above their logs
    for (std::size_t round = 0; round < kRounds / samples().size(); ++round) {
      BoundText text = round % 3 == 0 ? with_changed_header(sample, random) : sample;
      if (round % 3 != 0) text.log = changed_log(text.log, random);
      if (random() % 8 == 0) text.log = changed_log(text.log + '\1', random);
      BoundText claim = text;
      claim.log.clear();
      SlowBound& slow = claims.try_emplace(text_of(claim), claim).first->second;
      const bool is_right = slow.judge(text.log);
      ASSERT_EQ(is_accepted(text), is_right) << text_of(text);
      ++(is_right ? accepted : refused);
    }
  }
  EXPECT_GT(accepted, kRounds / 100);
  EXPECT_GT(refused, kRounds / 3);
}

/// What a log says of one state and all below it, replaced by each other record.
TEST(BoundSabotage, AStateIsRefutedByTheRulesThatHold) {
  std::size_t held = 0;
  std::size_t failed = 0;
  for (const BoundText& sample : samples()) {
    SlowBound search(sample);
    BoundText text = sample;
    const std::string log = search.search(11, kMostLog).value();
    for (const SlowVisit& visit : search.visits()) {
      for (const int rule : {1, 2, 3, 4, 6}) {
        text.log = log;
        text.log.replace(visit.begin, visit.end - visit.begin, 1, static_cast<char>(rule));
        const bool holds = visit.rules.contains(rule);
        ASSERT_EQ(is_accepted(text), holds) << "rule " << rule << " at " << visit.begin;
        ++(holds ? held : failed);
      }
    }
  }
  EXPECT_GT(held, std::size_t{support::share_of(500)});
  EXPECT_GT(failed, std::size_t{support::share_of(500)});
}

TEST(BoundSabotage, NoPartAndNoContinuationOfALogIsAccepted) {
  for (const BoundText& text : samples()) {
    BoundText changed = text;
    for (std::size_t size = 0; size < text.log.size(); size += 1 + text.log.size() / 200) {
      changed.log = text.log.substr(0, size);
      EXPECT_FALSE(is_accepted(changed));
    }
    for (int byte = 0; byte < 256; ++byte) {
      changed.log = text.log + static_cast<char>(byte);
      EXPECT_EQ(verdict_of(changed).fault, "bytes after the last record");
    }
  }
}

TEST(BoundSabotage, OtherBoundariesAreRefused) {
  for (const BoundText& text : samples()) {
    for (std::size_t q = 0; q < text.quads.size(); ++q) {
      for (std::size_t i = 0; i < 4; ++i) {
        BoundText changed = text;
        changed.quads[q][i] = (changed.quads[q][i] + 1) % static_cast<int>(text.quads.size() + 2);
        EXPECT_FALSE(is_accepted(changed));
        changed.quads[q] = text.quads[q];
        std::swap(changed.quads[q][i], changed.quads[q][(i + 1) % 4]);
        EXPECT_FALSE(is_accepted(changed));
      }
    }
    BoundText changed = text;
    changed.code[5] = changed.code[5] == '8' ? '9' : '8';
    EXPECT_NE(verdict_of(changed).fault.find("the code of the boundary is "), std::string::npos);
  }
}

TEST(BoundSabotage, NoShortLogProvesThatTheCubeHasNoMesh) {
  constexpr int kLongest = support::kSanitized ? 3 : 4;
  for (int flags = 0; flags < 8; ++flags) {
    BoundText text = limited(cube(), (flags & 1) != 0, 1, (flags & 2) != 0 ? 3 : 0, flags >= 4);
    constexpr int kBytes = 8;  // all records and one that is none
    int logs = 1;
    for (int size = 0; size <= kLongest; ++size, logs *= kBytes) {
      for (int number = 0; number < logs; ++number) {
        text.log.clear();
        for (int rest = number; static_cast<int>(text.log.size()) < size; rest /= kBytes) {
          text.log += static_cast<char>(rest % kBytes);
        }
        ASSERT_FALSE(is_accepted(text)) << number << " of " << logs;
      }
    }
    EXPECT_EQ(SlowBound(text).search(1, kMostLog), std::nullopt);
  }
}

TEST(BoundSabotage, FalseClaimsHaveNoLog) {
  struct Case {
    BoundText boundary;
    int least;  ///< hexahedra of a mesh; 0: more than are tried
    int most;
  };
  const std::vector<Case> cases = {{cube(), 1, 3},
                                   {column(2, "q1:022972977f"), 2, 3},
                                   {column(3, "q1:0208a5e4a5df7f"), 3, 3},
                                   {spindle(), 0, 4},
                                   {double_wheel(5, "q1:0888a55dff"), 0, 4},
                                   {pyramid(), 0, 4}};
  for (const Case& each : cases) {
    for (int hexahedra = 0; hexahedra <= each.most; ++hexahedra) {
      const bool has_mesh = each.least != 0 && hexahedra >= each.least;
      for (int flags = 0; flags < 4; ++flags) {
        const bool is_ball = (flags & 1) != 0;
        BoundText text = limited(each.boundary, is_ball, hexahedra, 2, flags >= 2);
        EXPECT_EQ(SlowBound(limited(text, false, hexahedra, 2, false)).has_mesh(), has_mesh);
        const auto log = SlowBound(text).search(5, kMostLog);
        ASSERT_EQ(log.has_value(), !has_mesh) << text_of(text);
        if (!log) continue;
        text.log = *log;
        EXPECT_EQ(verdict_of(text).fault, "");
        EXPECT_TRUE(is_accepted(text));
        if (each.least == 0) continue;
        // The same log for a claim that is false.
        text.hexahedra = each.least;
        EXPECT_FALSE(is_accepted(text)) << text_of(text);
      }
    }
  }
}

TEST(BoundSabotage, AMeshIsSaidToBeOne) {
  BoundText text = limited(cube(), true, 2, 0, false);
  text.log = std::string("\0\0\1", 3);
  EXPECT_EQ(verdict_of(text).fault, "record 2: the hexahedra are a mesh");
  text = limited(spindle(), true, 7, 11, false);
  const std::map<std::string, std::string> faults = {
      {"", "record 1: the log ends too early"},
      {"\1", "record 1: the face budget is not exceeded"},
      {"\2", "record 1: the corner budget is not exceeded"},
      {"\3", "record 1: no link of the last hexahedron is bad"},
      {"\4", "record 1: no image of the hexahedra has a lesser path"},
      {"\5", "record 1: the log ends too early"},
      {"\5\1\1", "record 1: one facet is given twice"},
      {"\5\1\2", "record 1: two facets may be those of one hexahedron"},
      {"\5\x8", "record 1: no open facet has this place"},
      {"\6", "record 1: no vertex lacks partners"},
      {"\7", "record 1: there is no record 7"},
      {std::string("\0\x8", 2), "record 1: no open facet has this place"},
      {std::string("\0\0", 2), "record 2: the log ends too early"}};
  for (const auto& [log, fault] : faults) {
    text.log = log;
    EXPECT_EQ(verdict_of(text).fault, fault);
  }
  text.hexahedra = 0;
  text.log = std::string("\0\0", 2);
  EXPECT_EQ(verdict_of(text).fault, "record 1: no hexahedron may come any more");
}

TEST(BoundSabotage, WhatIsNoCertificateIsMalformed) {
  const std::string good = text_of(samples()[1]);
  const auto reason = [](const std::string& text) -> std::string {
    try {
      return check_bound_bytes(framed(text), "log").fault;
    } catch (const Malformed& error) {
      return error.what();
    }
  };
  EXPECT_EQ(reason(good), "");
  const std::size_t log_at = good.find("log ");
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_TRUE(reason(good.substr(0, size)).starts_with("log:")) << size;
  }
  for (std::size_t at = 0; at < log_at; ++at) {
    for (const char c : {' ', '\n', 'x', '0', '\0', '\xff'}) {
      std::string bad = good;
      // A zero may lower a limit, within which the same log is right.
      if (bad[at] == c || (c == '0' && at > good.find("hexahedra"))) continue;
      bad[at] = c;
      EXPECT_NE(reason(bad), "") << bad;
    }
  }
  const auto with = [&good](const std::string& old, const std::string& other) {
    std::string text = good;
    return text.replace(text.find(old), old.size(), other);
  };
  EXPECT_TRUE(reason(with("kind any", "kind all")).starts_with("log:12: "));
  EXPECT_TRUE(reason(with("hexahedra 7", "hexahedra 65")).starts_with("log:13: "));
  EXPECT_TRUE(reason(with("hexahedra 7", "hexahedra 07")).starts_with("log:13: "));
  EXPECT_TRUE(reason(with("interior 11", "interior 55")).starts_with("log:14: "));
  EXPECT_TRUE(reason(with("interior 11", "interior -1")).starts_with("log:14: "));
  EXPECT_TRUE(reason(with("quads 8", "quads 65")).starts_with("log:3: "));
  EXPECT_TRUE(reason(with("quads 8", "quads 0")).starts_with("log:4: "));
  EXPECT_TRUE(reason(good + "x").starts_with("log:17: the log has "));

  const std::string frame = framed(good);
  EXPECT_THROW((void)check_bound_bytes(frame + "x", "log"), Malformed);
  EXPECT_THROW((void)check_bound_bytes(frame + frame, "log"), Malformed);
  EXPECT_THROW((void)check_bound_bytes(good, "log"), Malformed);
  EXPECT_THROW((void)check_bound_bytes(frame.substr(0, frame.size() - 1), "log"), Malformed);
  EXPECT_FALSE(is_bound(good));
  EXPECT_FALSE(is_bound(frame.substr(0, 12)));
  EXPECT_FALSE(is_bound(framed("hexatlas catalogue 1\n")));
  EXPECT_FALSE(is_bound(""));
}

}  // namespace
}  // namespace hexatlas::check
