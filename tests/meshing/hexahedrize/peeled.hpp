#pragma once
/// \file
/// What the tests of peeling share: the table and the sectors that are shipped, and what is
/// expected of every mesh that is made.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "meshing/hexahedrize/peel.hpp"
#include "tests/meshing/hexahedrize/judged.hpp"
#include "tests/meshing/hexahedrize/sectors.hpp"
#include "tests/meshing/hexahedrize/spheres.hpp"
#include "tests/shipped.hpp"

namespace hexatlas::support {

using complex::QuadSphere;
using hexahedrize::PeeledMesh;
using hexahedrize::PeelOptions;

inline const format::Table& table() {
  static const auto kTable = format::Table::open(kShippedTable);
  return kTable;
}

/// The judge accepts the mesh, as a ball.
inline void expect_accepted(const complex::HexComplex& mesh, const QuadSphere& sphere) {
  const auto fault = complex::validate(mesh);
  ASSERT_FALSE(fault) << sphere.quads.size() << " quads: " << fault->reason;
  const check::Verdict verdict = support::judged(mesh, sphere);
  EXPECT_TRUE(verdict.accepted) << sphere.quads.size() << " quads: " << verdict.reason;
  EXPECT_TRUE(verdict.is_ball);
  EXPECT_FALSE(verdict.boundary_reversed);
}

inline void expect_true_account(const PeeledMesh& made, const QuadSphere& sphere) {
  const auto& account = made.account;
  const std::size_t rest = made.mesh.hexahedra.size() - account.peeled;
  EXPECT_GE(account.cavity, 6U);
  EXPECT_EQ(account.cavity % 2, 0U);
  if (account.rest == hexahedrize::Rest::table) {
    EXPECT_TRUE(made.used.empty());
    EXPECT_GE(rest, 1U);
  } else {
    ASSERT_EQ(made.used.size(), sectors().size());
    EXPECT_EQ(std::accumulate(made.used.begin(), made.used.end(), std::size_t{0}),
              account.cavity / 2);
    std::size_t hexahedra = 0;
    for (std::size_t i = 0; i < made.used.size(); ++i)
      hexahedra += made.used[i] * sectors()[i].mesh.hexahedra.size();
    EXPECT_EQ(rest, hexahedra);
  }
  // The hexahedra of the account can be put on the cavity again, the last one first: so those of
  // the rest are a complex with this number of boundary quads.
  complex::HexComplex filling{made.mesh.vertices, {}};
  filling.hexahedra.assign(made.mesh.hexahedra.begin() + static_cast<long>(account.peeled),
                           made.mesh.hexahedra.end());
  EXPECT_EQ(complex::boundary_of(filling).size(), account.cavity);
  if (account.peeled == 0) {
    EXPECT_EQ(account.cavity, sphere.quads.size());
  }
}

/// `may_be_undecided`: of a large mesh that sectors end, or two balls of the table joined along a
/// disc, the judge may find no proof that it is a ball. All else is decided.
inline PeeledMesh expect_peeled(const QuadSphere& sphere, const format::Table* from,
                                const PeelOptions& options = {}, bool may_be_undecided = false) {
  PeeledMesh made = hexahedrize::mesh_by_peeling(sphere, from, sectors(), options);
  if (may_be_undecided) {
    EXPECT_FALSE(complex::validate(made.mesh));
    const check::Verdict verdict = support::judged(made.mesh, sphere);
    EXPECT_TRUE(verdict.accepted || verdict.undecided) << verdict.reason;
    EXPECT_FALSE(verdict.boundary_reversed);
  } else {
    expect_accepted(made.mesh, sphere);
  }
  expect_true_account(made, sphere);
  EXPECT_GE(made.account.layers, options.layers);
  EXPECT_GE(made.account.peeled, options.layers * sphere.quads.size());
  return made;
}

}  // namespace hexatlas::support
