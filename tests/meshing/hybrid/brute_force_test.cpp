// Claim and oracle: those of candidates_test.cpp, on more and larger meshes.
#include "tests/meshing/hybrid/brute_force.hpp"

namespace hexatlas {
namespace {

TEST(CandidatesAtLength, AreThoseOfBruteForceOnRandomDelaunayMeshes) {
  hybrid_tests::expect_as_by_brute_force_at_random(1, 40, 14);
}

}  // namespace
}  // namespace hexatlas
