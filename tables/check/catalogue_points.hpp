#pragma once
/// \file
/// Internal to the judge: whether given points with integer coordinates realize a triangulation.
/// All signs are exact, in 128 bits, and zeros are treated as such: the points need not be in
/// general position.
///
/// *Two tetrahedra* s and t that are not flat meet outside their common face exactly if there is an
/// affine dependency whose positive points are all in s and negative ones all in t: a point in both
/// has two different barycentric representations, and their difference is one. Each dependency is a
/// sum of minimal ones without cancellation, and each minimal one that involves points of s and t
/// only is that of five of these points, not all in a plane. So all fives of the points of s and t
/// are tried. *Convex position* is the same, with one point on a side.

#include <string>
#include <vector>

#include "tables/check/triangulation_laws.hpp"

namespace hexatlas::check {

/// Law::kOrientation, kEmbedded, and for other conditions kConvex or kJacobian: as the condition
/// asks. `signs` as in coherent_signs. Requires |coordinates| < 2^20. Sets `undecided` if the
/// Jacobian determinant (jacobian.hpp) is the only thing not shown; then the law is returned with
/// it. Cost: O(t^2 C(8,5) + C(n,5)).
[[nodiscard]] CatalogueFinding check_points(const Tetrahedra& tetrahedra,
                                            const std::vector<int>& signs,
                                            const std::vector<LatticePoint>& points,
                                            Condition condition, bool& undecided);

}  // namespace hexatlas::check
