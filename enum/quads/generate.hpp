#pragma once
/// \file
/// All quadrangulations of the sphere with n quads in a class, one of each isomorphism class,
/// mirror images identified, without a list of those met before.
///
/// Method. B. D. McKay's canonical construction path (J. Algorithms 26, 1998) with the
/// expansions of [BrinkmannGreenbergGreenhillMcKayThomasWollan2005]: a map is expanded in one way
/// per orbit of its automorphism group, and the larger map is kept if the reduction that undoes the
/// expansion is in the orbit of its canonical reduction. So each class has one parent class, and
/// the classes form trees that are walked depth first.
/// docs/theory/proofs/quadrangulation-generation.md has the theorems.

#include <atomic>
#include <cstdint>
#include <functional>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::quads {

enum class Class : std::uint8_t {
  simple,           ///< no two edges have the same ends; all degrees are then 2 or more
  min_degree_3,     ///< simple, all degrees 3 or more
  three_connected,  ///< complex::Quadrangulation::is_three_connected()
};

inline constexpr int kMinQuads = 2;
inline constexpr int kMaxQuads = complex::kMaxQuads;

/// Part `part` of `parts`. The parts are disjoint, and all of them together are the whole, for any
/// number of parts. A part may be empty.
struct Shard {
  std::uint64_t part = 0;
  std::uint64_t parts = 1;
};

struct Sums {
  std::uint64_t classes = 0;                 ///< mirror images identified
  std::uint64_t orientation_preserving = 0;  ///< mirror images told apart
  /// Sum of 8n / |Aut|, mirror symmetries included: the number of maps with a distinguished flag.
  std::uint64_t rooted = 0;
  bool complete = true;  ///< false: stopped early, the sums are those of the maps met

  Sums& operator+=(const Sums& other) {
    classes += other.classes;
    orientation_preserving += other.orientation_preserving;
    rooted += other.rooted;
    complete = complete && other.complete;
    return *this;
  }
  friend bool operator==(const Sums&, const Sums&) = default;
};

/// Called with each map, the order of its automorphism group, and the number of its automorphisms
/// that keep the orientation.
using Visit =
    std::function<void(const complex::Quadrangulation&, int automorphisms, int rotations)>;

struct GenerateOptions {
  Shard shard{};
  /// Set to true by another thread or a signal handler to stop early; may be null.
  const std::atomic<bool>* stop = nullptr;
};

/// Requires kMinQuads <= quads <= kMaxQuads and shard.part < shard.parts. `visit` may be empty,
/// which saves the making of quadrangulations. The order of visits is the same in every run.
/// Memory: O(quads^2). Time: a few microseconds per class for a whole, see tests/bench; a part
/// repeats the top of the tree: some milliseconds, of a thousand or more parts up to a second. Not
/// promised: which of the two mirror images is visited, or in which labels.
Sums generate(Class which, int quads, const Visit& visit = {}, const GenerateOptions& options = {});

}  // namespace hexatlas::quads
