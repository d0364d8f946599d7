#pragma once
/// \file
/// Internal to the judge: proofs that a hexahedral mesh is a ball.
///
/// *Shelling.* Take hexahedra off one by one. If a hexahedron meets the rest exactly in a disc of
/// its quads, then the whole is a ball if the rest is, since two balls glued along a disc in both
/// boundaries are a ball. One hexahedron is a ball. *Collapse.* Remove pairs of a face and the
/// only face that contains it, until a vertex is left. A compact 3-manifold that collapses to a
/// vertex is a ball (J. H. C. Whitehead, Simplicial spaces, nuclei and m-groups, 1939).
///
/// Both searches are greedy, with a fixed list of deterministic orders. Not promised: that one of
/// them succeeds on every ball; there are balls without shelling and balls without collapse.
/// Cost of one order: O(H * degree * log H).

#include <cstdint>
#include <span>

#include "tables/check/incidence.hpp"

namespace hexatlas::check {

/// Whether taking the hexahedra off in this order is a shelling read backwards. The order must
/// name each hexahedron once; the last one is left over.
[[nodiscard]] bool is_removal_order(const Incidence& incidence,
                                    std::span<const std::uint32_t> order);

/// How many hexahedra can be taken off as in a shelling read backwards, in the order in which they
/// are listed; one is left over. If the others are a ball, so is the whole.
[[nodiscard]] std::uint32_t listed_removals(const Incidence& incidence);

/// Whether a shelling was found. Requires: all laws before kBall.
[[nodiscard]] bool find_shelling(const Incidence& incidence);

/// Whether a collapse to a vertex was found. Requires: all laws before kBall.
[[nodiscard]] bool find_collapse(const Incidence& incidence);

}  // namespace hexatlas::check
