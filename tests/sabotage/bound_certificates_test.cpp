// Claim. The judge accepts the certificates that the search writes, and no changed one that a
// second reading of docs/formats/bound.md does not accept too. Oracle. bound_oracle.hpp, which
// shares nothing with the judge and the search but the document.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/hexes/bound_log.hpp"
#include "tables/build/hexmesh_search.hpp"
#include "tables/check/bound.hpp"
#include "tables/check/malformed.hpp"
#include "tests/sabotage/bound_oracle.hpp"

namespace {

using namespace hexatlas;
using sabotage::BoundText;

struct Claim {
  const char* code = nullptr;
  int hexahedra = 0;
  bool ball = false, symmetry = false;
  int interior = -1;  ///< -1: as many as there may be
};

constexpr std::array<Claim, 10> kClaims{{{"q1:02228a2a5777df7f", 13, true, true},
                                         {"q1:02228a2a5777df7f", 11, true, false},
                                         {"q1:02228a2a5777df7f", 10, false, true},
                                         {"q1:088a577f", 17, true, true},
                                         {"q1:088a577f", 13, false, false},
                                         {"q1:0888a55dff", 14, true, true},
                                         {"q1:022972977f", 1, false, true},
                                         {"q1:02228a2a5777df7f", 64, true, true, 9},
                                         {"q1:02228a2a5777df7f", 36, true, false, 5},
                                         {"q1:088a577f", 30, true, true, 13}}};

complex::Quadrangulation boundary_of(const Claim& claim) {
  return canon::decode(canon::from_text(claim.code).value()).value();
}

hexes::SearchLimits limits_of(const Claim& claim) {
  const int most = hexes::most_interior_vertices(boundary_of(claim).quads(), claim.hexahedra);
  return {claim.hexahedra, claim.interior < 0 ? most : claim.interior, claim.ball, claim.symmetry};
}

TEST(BoundCertificates, OfTheSearchAreAccepted) {
  for (const Claim& claim : kClaims) {
    const auto log = hexes::bound_log(boundary_of(claim), limits_of(claim), {.threads = 2});
    ASSERT_TRUE(log.is_complete);
    EXPECT_EQ(hexes::bound_log(boundary_of(claim), limits_of(claim), {}).bytes, log.bytes);
    const auto verdict = check::check_bound_bytes(
        build::bound_certificate(boundary_of(claim), limits_of(claim), log), "bound");
    EXPECT_TRUE(verdict.accepted) << claim.code << ' ' << verdict.fault;
    EXPECT_EQ(verdict.records, log.records);
    EXPECT_EQ(verdict.hexahedra, claim.hexahedra);
    EXPECT_EQ(verdict.any_interior, claim.interior < 0);
  }
}

TEST(BoundCertificates, AreNotWrittenWhereThereIsAMesh) {
  const Claim claim{"q1:022972977f", 2, true, true};
  const auto log = hexes::bound_log(boundary_of(claim), limits_of(claim), {});
  EXPECT_TRUE(log.has_found_a_mesh);
  EXPECT_FALSE(log.is_complete);
}

TEST(BoundCertificates, EndAtTheFirstMesh) {
  const Claim claim{"q1:022222a575df7f", 16, true, true};
  const auto log = hexes::bound_log(boundary_of(claim), limits_of(claim), {});
  EXPECT_TRUE(log.has_found_a_mesh);
  EXPECT_LT(log.records, 10'000U);  // of some millions
}

/// The certificate of a claim in the words of the second reading.
BoundText text_of(const Claim& claim) {
  BoundText text{claim.code, {}};
  for (const auto& quad : boundary_of(claim).list_of_quads())
    text.quads.push_back({quad[0], quad[1], quad[2], quad[3]});
  const hexes::SearchLimits limits = limits_of(claim);
  text.is_ball = limits.ball;
  text.hexahedra = limits.max_hexahedra;
  text.interior = limits.max_interior;
  text.has_symmetry = limits.up_to_symmetry;
  text.log = hexes::bound_log(boundary_of(claim), limits, {}).bytes;
  return text;
}

std::string changed(std::string log, std::mt19937_64& random) {
  const std::size_t at = random() % log.size();
  const auto byte = static_cast<char>(random() % 4 == 0 ? random() % 256 : random() % 24);
  switch (random() % 5) {
    case 0:
      log.erase(at, 1);
      break;
    case 1:
      log.insert(at, 1, byte);
      break;
    case 2:
      std::swap(log[at], log[random() % log.size()]);
      break;
    case 3:
      log.resize(at);
      break;
    default:
      log[at] = byte;
  }
  return log;
}

TEST(BoundCertificates, ChangedOnesAreRefusedUnlessTheyProveTheSame) {
  std::mt19937_64 random(11);
  int changes = 0, accepted = 0;
  for (const Claim& claim :
       {Claim{"q1:02228a2a5777df7f", 9, true, true}, Claim{"q1:088a577f", 12, true, true},
        Claim{"q1:088a577f", 11, false, false}, Claim{"q1:02228a2a5777df7f", 8, false, true},
        Claim{"q1:02228a2a5777df7f", 64, true, true, 5}}) {
    const BoundText whole = text_of(claim);
    for (int round = 0; round < 300; ++round) {
      BoundText text = whole;
      text.log = changed(whole.log, random);
      if (text.log == whole.log) continue;
      ++changes;
      if (!check::check_bound_bytes(sabotage::framed(sabotage::text_of(text)), "log").accepted)
        continue;
      ++accepted;
      EXPECT_TRUE(sabotage::SlowBound(text).judge());
    }
  }
  EXPECT_GE(changes, 1000);
  EXPECT_LT(accepted, changes / 10);
}

}  // namespace
