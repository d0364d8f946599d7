// Claim. The list of spheres with eight vertices is complete. Oracle. All labelled closed manifolds
// with eight vertices, by covering triangles, with no flips and no symmetry.
#include <gtest/gtest.h>

#include "tests/enum/balls/sphere_laws.hpp"

namespace {

using namespace hexatlas;

TEST(SpheresLong, AreAllClosedManifoldsWithEightVertices) { support::expect_all_manifolds(8); }

}  // namespace
