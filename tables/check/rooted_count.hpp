#pragma once
/// \file
/// The number of rooted 3-connected quadrangulations of the sphere, by which the judge knows
/// whether a list of them is complete (docs/theory/proofs/rooted-count.md).
///
/// Definition. A quadrangulation with n quads has 8n flags (a quad, a corner of it, one of two
/// orientations), and its automorphisms, mirror images included, act freely on them; a rooted one
/// is an orbit of flags. So there are 8n / |Aut| of them for each quadrangulation up to
/// isomorphism. Sources. W. T. Tutte, A census of planar maps (1963), for the rooted simple
/// quadrangulations; R. C. Mullin, P. J. Schellenberg, The enumeration of c-nets via
/// quadrangulations (1968), for the substitution.

#include <cstdint>
#include <vector>

namespace hexatlas::check {

/// Numbers of quads up to this can be counted in the integers used.
inline constexpr std::uint32_t kMostCountedQuads = 32;

/// Element n is the number for n quads, up to `most_quads`. Requires most_quads <= 32.
/// Exact: throws std::overflow_error rather than lose a digit, which the tests exclude up to 32.
/// Cost: O(most_quads^4), a few milliseconds.
[[nodiscard]] std::vector<std::uint64_t> rooted_three_connected(std::uint32_t most_quads);

}  // namespace hexatlas::check
