// Claim. Codes do not depend on labels, are equal exactly for isomorphic quadrangulations, can be
// decoded, and count automorphisms; any word whatever is refused or decoded to a quadrangulation.
// Oracle. Scrambled copies; automorphisms by trying all images of an edge; numbers of decodable
// words by Mullin's formula and of rooted quadrangulations by Tutte's.
#include "enum/canon/code.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <unordered_set>

#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using canon::Code;
using complex::Quadrangulation;

/// Laws of the canonical form that need no second quadrangulation.
void expect_lawful(const Quadrangulation& q) {
  const auto form = canon::canonical_form(q);
  const auto decoded = canon::decode(form.code);
  ASSERT_TRUE(decoded.has_value());
  const auto again = canon::canonical_form(*decoded);
  EXPECT_EQ(again.code, form.code);
  EXPECT_EQ(again.automorphisms, form.automorphisms);
  EXPECT_EQ(again.rotations, form.rotations);
  EXPECT_FALSE(again.is_mirrored) << "the canonical list has the orientation of its code";
  const canon::Labelling vertex_of = canon::inverse_of(form.label, q.vertices());
  for (int v = 0; v < q.vertices(); ++v)
    EXPECT_EQ(vertex_of[form.label[static_cast<std::size_t>(v)]], v);
  std::set<oracle::Cycle> labelled, canonical;
  for (const auto& quad : q.list_of_quads()) {
    complex::QuadVertices moved{};
    for (std::size_t i = 0; i < 4; ++i) moved[form.is_mirrored ? 3 - i : i] = form.label[quad[i]];
    labelled.insert(support::cycle(moved));
  }
  int next = 0;  // the canonical list numbers the vertices as they appear
  for (const auto& quad : decoded->list_of_quads()) {
    canonical.insert(support::cycle(quad));
    for (const auto v : quad) {
      EXPECT_LE(v, next);
      next = std::max(next, v + 1);
    }
  }
  EXPECT_EQ(labelled, canonical);
  EXPECT_EQ(canon::from_text(canon::to_text(form.code)), form.code);
  EXPECT_EQ(canon::from_binary(form.code.quads, canon::to_binary(form.code)), form.code);
  EXPECT_EQ(canon::to_text(form.code).size(), 3U + form.code.quads);
  EXPECT_EQ(canon::to_binary(form.code).size(), canon::binary_size(form.code.quads));
}

TEST(Code, DoesNotDependOnLabels) {
  support::Random random(1);
  auto level = support::four_cycle_class();
  for (int n = 2; n <= 9; ++n) {
    for (const auto& [code, map] : level) {
      const auto q = support::quadrangulation(map);
      if (n == 2) continue;  // its two quads have the same vertices: no list by ends for copies
      expect_lawful(q);
      for (const bool mirrored : {false, true})
        for (int i = 0; i < 5; ++i) {
          const auto copy = support::scrambled(q, random, mirrored);
          const auto form = canon::canonical_form(copy);
          EXPECT_EQ(form.code, code);
          expect_lawful(copy);
        }
    }
    level = support::grown(level);
  }
}

RC_GTEST_PROP(Code, OfLargeQuadrangulationsDoesNotDependOnLabels, ()) {
  support::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto size = *rc::gen::inRange<std::size_t>(1, 40);
  const auto q = support::random_shelling(size, 62, random).front().boundary;
  expect_lawful(q);
  const auto form = canon::canonical_form(q);
  const auto copy = canon::canonical_form(support::scrambled(q, random, random.coin()));
  RC_ASSERT(copy.code == form.code);
  RC_ASSERT(copy.automorphisms == form.automorphisms);
}

TEST(Code, CountsAutomorphisms) {
  auto level = support::four_cycle_class();
  for (int n = 3; n <= 9; ++n) {
    level = support::grown(level);
    for (const auto& [code, map] : level) {
      const auto form = canon::canonical_form(support::quadrangulation(map));
      const auto expected = oracle::automorphisms(map);
      EXPECT_EQ(form.automorphisms, expected.all) << canon::to_text(code);
      EXPECT_EQ(form.rotations, expected.rotations) << canon::to_text(code);
      canon::CanonicalFlags flags;
      canon::canonical_flags(support::quadrangulation(map), flags);
      EXPECT_EQ(flags.count, expected.all);
      EXPECT_EQ(flags.code, code);
    }
  }
}

/// Visits all words of 2n letters in which both kinds of parentheses balance, and no others.
template <class Visit>
void for_each_balanced(int letters, int tree, int open, std::string& word, const Visit& visit) {
  if (tree + open > letters) return;
  if (letters == 0) return visit(word);
  for (const char letter : {'0', '1', '2', '3'}) {
    const int t = tree + (letter == '0' ? 1 : 0) - (letter == '1' ? 1 : 0);
    const int o = open + (letter == '2' ? 1 : 0) - (letter == '3' ? 1 : 0);
    if (t < 0 || o < 0) continue;
    word += letter;
    for_each_balanced(letters - 1, t, o, word, visit);
    word.pop_back();
  }
}

Code code_of_letters(const std::string& letters) {
  Code code{.quads = static_cast<std::uint8_t>(letters.size() / 2)};
  for (std::size_t i = 0; i < letters.size(); ++i)
    code.words[i / 32] |= static_cast<std::uint64_t>(letters[i] - '0') << (62 - 2 * (i % 32));
  return code;
}

TEST(Code, DecodesTheWordsThatBalanceAndNoOthers) {
  // Mullin 1967: plane maps with n edges, a root and a spanning tree: C(n) C(n + 1).
  for (unsigned n = 1; n <= 4; ++n) {
    std::uint64_t decoded = 0;
    for (std::uint64_t word = 0; word < std::uint64_t{1} << (4 * n); ++word) {
      Code code{.quads = static_cast<std::uint8_t>(n)};
      code.words[0] = word << (64 - 4 * n);
      const auto q = canon::decode(code);
      if (!q) continue;
      ++decoded;
      ASSERT_FALSE(q->validate());
      ASSERT_EQ(q->quads(), static_cast<int>(n));
      expect_lawful(*q);
      ASSERT_LE(canon::canonical_form(*q).code.quads, code.quads);
    }
    EXPECT_EQ(decoded, oracle::catalan(n) * oracle::catalan(n + 1));
  }
  for (unsigned n = 5; n <= 6; ++n) {
    std::uint64_t words = 0;
    std::string word;
    for_each_balanced(static_cast<int>(2 * n), 0, 0, word, [&](const std::string& letters) {
      ++words;
      ASSERT_TRUE(canon::decode(code_of_letters(letters)).has_value()) << letters;
    });
    EXPECT_EQ(words, oracle::catalan(n) * oracle::catalan(n + 1));
  }
}

TEST(Code, ClassesOfAllQuadrangulationsAddUpToTuttesNumber) {
  // Multiple edges included: 8n / |Aut| summed over the classes is the number of rooted maps.
  for (unsigned n = 1; n <= 6; ++n) {
    std::unordered_set<Code> codes;
    std::uint64_t rooted = 0;
    std::string word;
    for_each_balanced(static_cast<int>(2 * n), 0, 0, word, [&](const std::string& letters) {
      const auto form = canon::canonical_form(canon::decode(code_of_letters(letters)).value());
      if (!codes.insert(form.code).second) return;
      ASSERT_EQ(8 * n % static_cast<unsigned>(form.automorphisms), 0U);
      rooted += 8 * n / static_cast<unsigned>(form.automorphisms);
    });
    EXPECT_EQ(rooted, oracle::rooted_all(n)) << n << " quads";
  }
}

TEST(Code, RandomWordsAreRefusedOrDecoded) {
  support::Random random(3);
  int decoded = 0;
  for (int i = 0; i < 200'000; ++i) {
    Code code{.quads = static_cast<std::uint8_t>(1 + random.below(64))};
    if (i % 4 == 0) code.quads = static_cast<std::uint8_t>(1 + random.below(5));
    for (auto& word : code.words) word = random.bits();
    // Letters beyond the end are not part of the word; clear them, as from_text() leaves them.
    code = canon::from_text(canon::to_text(code)).value();
    const auto q = canon::decode(code);
    if (!q) continue;
    ++decoded;
    ASSERT_FALSE(q->validate());
  }
  EXPECT_GT(decoded, 100);
  // The longest words: 64 quads in one line, and letters that only open.
  std::string line = std::string(64, '0') + std::string(64, '1');
  EXPECT_TRUE(canon::decode(code_of_letters(line)).has_value());
  EXPECT_EQ(canon::decode(code_of_letters(line))->vertices(), 66);
  for (const char letter : {'0', '1', '2', '3'})
    EXPECT_FALSE(canon::decode(code_of_letters(std::string(128, letter))).has_value());
  EXPECT_FALSE(canon::decode(Code{}).has_value());
  EXPECT_FALSE(canon::decode(Code{.quads = 65}).has_value());
}

TEST(Code, TextsOfAnotherFormAreRefused) {
  for (const char* text : {"", "q1:", "q1", "q2:08a5df", "Q1:08a5df", "q1:08A5DF", "q1:08a5dg",
                           " q1:08a5df", "q1:08a5df ", "q1: 08a5df", "08a5df", "q1:08a5\n"})
    EXPECT_FALSE(canon::from_text(text).has_value()) << text;
  EXPECT_TRUE(canon::from_text("q1:" + std::string(64, '0')).has_value());
  EXPECT_FALSE(canon::from_text("q1:" + std::string(65, '0')).has_value());
  EXPECT_FALSE(canon::from_text(std::string("q1:08a5d\0", 9)).has_value());
}

TEST(Code, BinaryFormsOfAnotherSizeAreRefused) {
  EXPECT_FALSE(canon::from_binary(0, "").has_value());
  EXPECT_FALSE(canon::from_binary(65, std::string(33, '\0')).has_value());
  EXPECT_FALSE(canon::from_binary(6, "ab").has_value());
  EXPECT_FALSE(canon::from_binary(6, "abcd").has_value());
  EXPECT_TRUE(canon::from_binary(5, std::string("\x01\x02\x30", 3)).has_value());
  EXPECT_FALSE(canon::from_binary(5, std::string("\x01\x02\x31", 3)).has_value()) << "unused half";
}

TEST(Code, OfTheCubeIsTheOneInTheFormat) {
  // Hand walk of docs/formats/code.md, the same for every flag of the cube.
  EXPECT_EQ(canon::to_text(canon::canonical_form(Quadrangulation::cube()).code), "q1:08a5df");
  EXPECT_EQ(canon::canonical_form(Quadrangulation::cube()).automorphisms, 48);
  EXPECT_EQ(canon::canonical_form(Quadrangulation::cube()).rotations, 24);
}

TEST(Code, OrdersByQuadsFirst) {
  const Code small = canon::from_text("q1:ffffff").value();
  const Code large = canon::from_text("q1:0000000").value();
  EXPECT_LT(small, large);
  EXPECT_LT(canon::from_text("q1:08a5de").value(), canon::from_text("q1:08a5df").value());
}

}  // namespace
