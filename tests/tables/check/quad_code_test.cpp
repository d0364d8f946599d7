// Claim. The judge's canonical code is that of docs/formats/code.md; its two tests of
// 3-connectedness agree; its SHA-256 is the standard's.
// Oracle. The word of the cube, worked out by hand below; automorphism groups known from geometry;
// sums of 8 n / |Aut| and counts of classes from the literature (A007022); random relabellings;
// the test vectors of FIPS 180-4.
#include "tables/check/quad_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tables/check/sha256.hpp"
#include "tests/tables/check/example_meshes.hpp"

namespace hexatlas::check {
namespace {

std::vector<Quad> surface_of_box(int a, int b, int c) {
  return examples::cubes(examples::box(a, b, c)).surface.quads;
}

// By hand: all flags of the cube are equivalent. One colour class is a tetrahedron p q r s with the
// quads as its six edges. Let the edges be pq = 1, and counter-clockwise at p: pq, pr, ps; hence at
// q: pq, qs, qr; at r: pr, qr, rs; at s: ps, rs, qs. From p in pq:
//   0 to q; next after pq at q: qs, new, s not reached:   0 to s
//   next after qs at s: ps, new, p reached:               2
//   next at s: rs, new, r not reached:                    0 to r
//   next after rs at r: pr, new, p reached:               2
//   next at r: qr, new, q reached:                        2
//   next at r: rs, tree:                                  1 to s
//   next after rs at s: qs, tree:                         1 to q
//   next after qs at q: qr, open:                         3
//   next at q: pq, tree:                                  1 to p
//   next after pq at p: pr, open:                         3
//   next at p: ps, open:                                  3
constexpr const char* kCubeWord = "002022113133";

std::string letters(const CodeWord& word) {
  std::string text;
  for (const unsigned letter : word) text += static_cast<char>('0' + letter);
  return text;
}

TEST(QuadCode, OfTheCube) {
  const auto code = canonical_code(surface_of_box(1, 1, 1));
  ASSERT_TRUE(code);
  EXPECT_EQ(letters(code->word), kCubeWord);
  EXPECT_EQ(code_text(code->word), "q1:08a5df");
  EXPECT_EQ(code->automorphisms, 48U);
}

TEST(QuadCode, CountsSymmetries) {
  EXPECT_EQ(canonical_code(surface_of_box(2, 1, 1))->automorphisms, 16U);
  EXPECT_EQ(canonical_code(surface_of_box(2, 2, 1))->automorphisms, 16U);
  EXPECT_EQ(canonical_code(surface_of_box(2, 2, 2))->automorphisms, 48U);
  EXPECT_EQ(canonical_code(surface_of_box(3, 2, 1))->automorphisms, 8U);
}

TEST(QuadCode, IgnoresLabelsRotationsAndMirrorImages) {
  std::mt19937 random(1);
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{1, 1, 1}, {2, 1, 1}, {3, 2, 1}}) {
    std::vector<Quad> quads = surface_of_box(a, b, c);
    const CodeWord word = canonical_code(quads)->word;
    for (int round = 0; round < 40; ++round) {
      std::vector<std::uint32_t> labels(quads.size() + 2);
      for (std::uint32_t v = 0; v < labels.size(); ++v) labels[v] = v;
      std::shuffle(labels.begin(), labels.end(), random);
      std::shuffle(quads.begin(), quads.end(), random);
      for (Quad& quad : quads) {
        for (std::uint32_t& vertex : quad) vertex = labels[vertex];
        std::rotate(quad.begin(), quad.begin() + random() % 4, quad.end());
        if (round % 2 == 1) std::reverse(quad.begin(), quad.end());
      }
      const auto code = canonical_code(quads);
      ASSERT_TRUE(code);
      EXPECT_EQ(code->word, word);
    }
  }
}

/// Rotated so that the least vertex is first.
std::set<Quad> cycles(std::vector<Quad> quads, bool mirrored) {
  std::set<Quad> result;
  for (Quad& quad : quads) {
    if (mirrored) std::reverse(quad.begin(), quad.end());
    std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
    result.insert(quad);
  }
  return result;
}

TEST(QuadCode, DecodesToTheCanonicalListOfQuads) {
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{1, 1, 1}, {2, 1, 1}, {3, 2, 2}}) {
    std::vector<Quad> quads = surface_of_box(a, b, c);
    const auto code = canonical_code(quads);
    std::string reason;
    const auto decoded = decode_word(code->word, reason);
    ASSERT_TRUE(decoded) << reason;
    for (Quad& quad : quads) {
      for (std::uint32_t& vertex : quad) vertex = code->labels[vertex];
    }
    EXPECT_EQ(cycles(*decoded, false), cycles(quads, code->is_mirrored));
    EXPECT_EQ((*decoded)[0], (Quad{0, 1, 2, 3}));
  }
}

TEST(QuadCode, RefusesWordsThatAreNoSphere) {
  std::string reason;
  const auto decodes = [&reason](CodeWord word) { return decode_word(word, reason).has_value(); };
  EXPECT_FALSE(decodes({}));
  EXPECT_FALSE(decodes({1, 0}));
  EXPECT_FALSE(decodes({0, 0, 1}));
  EXPECT_FALSE(decodes({3, 2}));
  EXPECT_FALSE(decodes({2, 3}));  // a loop: a quad with a vertex twice
  EXPECT_FALSE(decodes({0, 1}));  // one edge: both faces are the same
  EXPECT_TRUE(decodes({0, 2, 1, 3}));
}

TEST(QuadCode, KeysAreCodesInBytes) {
  const auto word = word_of_key(std::string("\x08\xa5\xdf", 3), 6);
  ASSERT_TRUE(word);
  EXPECT_EQ(letters(*word), kCubeWord);
  EXPECT_EQ(key_of_word(*word), "\x08\xa5\xdf");
  EXPECT_FALSE(word_of_key("\x08\xa5", 6));
  EXPECT_FALSE(word_of_key(std::string("\x08\xa5\xdf\x01", 4), 7));
  EXPECT_TRUE(word_of_key(std::string("\x08\xa5\xdf\x10", 4), 7));
}

/// All words of 2 n letters that are canonical codes of simple quadrangulations, by trying all
/// words in which both kinds of parentheses balance. Returns |Aut| of each.
void all_codes(std::size_t length, CodeWord& word, unsigned tree, unsigned open,
               std::map<std::string, unsigned>& found) {
  const std::size_t left = length - word.size();
  if (left < tree + open) return;
  if (left == 0) {
    std::string reason;
    const auto quads = decode_word(word, reason);
    const auto code = quads ? canonical_code(*quads) : std::nullopt;
    if (code && code->word == word) found.emplace(letters(word), code->automorphisms);
    return;
  }
  for (std::uint8_t letter = 0; letter < 4; ++letter) {
    if ((letter == 1 && tree == 0) || (letter == 3 && open == 0)) continue;
    word.push_back(letter);
    all_codes(length, word, tree + (letter == 0) - (letter == 1),
              open + (letter == 2) - (letter == 3), found);
    word.pop_back();
  }
}

TEST(QuadCode, FindsAllSmallQuadrangulationsOnce) {
  // Classes of simple quadrangulations with n quads (plantri), and the sum of 8 n / |Aut|, which is
  // 2 (3k)! / ((2k+1)! (k+1)!) with k = n - 1 (rooted non-separable planar maps).
  const std::map<std::size_t, std::pair<std::size_t, unsigned>> known = {
      {3, {1, 2}}, {4, {2, 6}}, {5, {3, 22}}, {6, {9, 91}}};
  for (const auto& [n, expected] : known) {
    std::map<std::string, unsigned> found;
    CodeWord word;
    all_codes(2 * n, word, 0, 0, found);
    EXPECT_EQ(found.size(), expected.first) << n;
    std::size_t flags = 0;
    std::size_t three_connected = 0;
    for (const auto& [code, automorphisms] : found) {
      flags += 8 * n / automorphisms;
      std::string reason;
      CodeWord decoded;
      for (const char letter : code) decoded.push_back(static_cast<std::uint8_t>(letter - '0'));
      const auto quads = decode_word(decoded, reason);
      ASSERT_EQ(is_three_connected_by_removal(*quads), is_three_connected_by_quads(*quads));
      if (is_three_connected_by_removal(*quads)) ++three_connected;
    }
    EXPECT_EQ(three_connected, n == 6 ? 1U : 0U);
    EXPECT_EQ(flags, expected.second) << n;
  }
}

TEST(QuadCode, TestsOfConnectednessAgree) {
  // Boxes are 3-connected; a box with a quad replaced by a quad in a quad is still, one with two
  // quads sharing a path of two edges is not.
  std::vector<Quad> quads = surface_of_box(2, 2, 1);
  EXPECT_TRUE(is_three_connected_by_removal(quads));
  EXPECT_TRUE(is_three_connected_by_quads(quads));
  const Quad split = quads.back();
  const auto added = static_cast<std::uint32_t>(quads.size() + 2);
  quads.back() = {split[0], split[1], split[2], added};
  quads.push_back({split[0], added, split[2], split[3]});
  EXPECT_FALSE(is_three_connected_by_removal(quads));
  EXPECT_FALSE(is_three_connected_by_quads(quads));
}

TEST(Sha256, AgreesWithTheStandard) {
  EXPECT_EQ(sha256_hex_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex_of("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex_of(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  Sha256 pieces;
  Sha256 whole;
  for (int i = 0; i < 300; ++i) pieces.add(std::string(static_cast<std::size_t>(i % 7), 'x'));
  whole.add(std::string(897, 'x'));
  EXPECT_EQ(pieces.digest(), whole.digest());
}

}  // namespace
}  // namespace hexatlas::check
