#pragma once
/// \file
/// The census of shellable hexahedral balls.
///
/// Definition. A ball is *shellable* if it arises from one hexahedron by gluing on one more at a
/// time, each along a patch of the boundary, so that each ball on the way obeys the strict rule
/// (enum/complex/hex_complex.hpp). Classes are those of isomorphism, mirror images identified.
///
/// Method. All hexahedra are glued on one ball of each class with H - 1 hexahedra in all ways; the
/// canonical words of the results are sorted. Each class with H hexahedra is met, since without the
/// last hexahedron of a shelling it is a shellable ball (docs/theory/proofs/shellable-balls.md).
///
/// Law, tested for each class of each level: the ways to glue that lead to it, weighted by 1 /
/// |Aut| of what they start from, are as many as its hexahedra that can be taken off to leave a
/// class of the list, by 1 / |Aut| of its own (InternalError otherwise).

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/hexes/ball_word.hpp"

namespace hexatlas::hexes {

struct ShellingOptions {
  int hexahedra = 1;                                  ///< at most kMaxBallHexahedra
  int threads = 1;                                    ///< the result does not depend on it
  std::uint64_t max_bytes = std::uint64_t{8} << 30U;  ///< that the lists may take, about
  /// Set to true by another thread or a signal handler to stop early; may be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called by one thread at a time with a number of hexahedra, the balls with one less that have
  /// been gone through, and all of those; may be empty.
  std::function<void(int hexahedra, std::size_t done, std::size_t all)> progress{};
};

struct ShellableBall {
  Word word;
  std::uint32_t automorphisms = 1;  ///< mirror symmetries included
};

struct ShellingCounts {
  int hexahedra = 1;
  std::uint64_t meshes = 0;
  std::uint64_t boundaries = 0;      ///< of these meshes, up to isomorphism
  std::uint64_t new_boundaries = 0;  ///< of no mesh of the census with fewer hexahedra
  /// Ways to take a hexahedron off so that a ball is left that is not shellable.
  std::uint64_t unshellable_rests = 0;
};

struct ShellingCensus {
  std::vector<ShellingCounts> by_hexahedra;  ///< from 1 on, what is finished
  std::vector<ShellableBall> classes;        ///< of the last entry there, by word
  bool exhaustive = false;  ///< not stopped: all numbers asked for are there; each is a proof
};

/// Requires 1 <= options.hexahedra <= kMaxBallHexahedra.
/// Throws ResourceFailure if the lists need more than max_bytes. Cost: some microseconds for each
/// gluing; about ten gluings for each class, and 250 bytes for each of the largest size.
[[nodiscard]] ShellingCensus shellable_balls(const ShellingOptions& options);

/// The code of the boundary. Requires a ball.
[[nodiscard]] canon::Code boundary_code(const SmallBall& ball);

/// The same ball with its hexahedra in the order of a shelling and its vertices in the order of
/// their first appearance; of all such orders, the last hexahedron is the first possible one, and
/// so on. Requires a shellable ball, each vertex of which is in a hexahedron.
[[nodiscard]] SmallBall in_shelling_order(const SmallBall& ball);

/// The file of docs/formats/shellings.md. Requires that the census is exhaustive.
[[nodiscard]] std::string shellings_text(const ShellingCensus& census, int threads);

}  // namespace hexatlas::hexes
