#pragma once
/// \file
/// Which flags of a plane map are equivalent, by codes that are compared only as far as needed.
///
/// The code of a flag is the list of adjacencies met by a breadth-first walk from it: vertices
/// are numbered when first met, each in turn shows its neighbours in the orientation of the flag
/// from the edge on by which it was met, a new neighbour as its degree beyond all numbers. Two
/// flags have equal codes if and only if an isomorphism, which may mirror, takes one to the other.
/// This code orders flags within one map; it is not the one of docs/formats/code.md.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/quads/planar_map.hpp"

namespace hexatlas::quads {

using canon::Flag;

/// Flags in a fixed capacity: a map with n quads has 8n.
class FlagList {
 public:
  void clear() noexcept { size_ = 0; }
  void push_back(Flag flag) noexcept { flags_[size_++] = flag; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] Flag operator[](std::size_t i) const noexcept { return flags_[i]; }
  [[nodiscard]] const Flag* begin() const noexcept { return flags_.data(); }
  [[nodiscard]] const Flag* end() const noexcept { return flags_.data() + size_; }

 private:
  std::size_t size_ = 0;
  std::array<Flag, 8 * complex::kMaxQuads> flags_;  // the first size_ are set
};

/// The automorphism group of a map as an orbit of flags: one flag per automorphism.
struct Symmetry {
  FlagList flags;

  [[nodiscard]] int automorphisms() const noexcept { return static_cast<int>(flags.size()); }
  /// Those that keep the orientation.
  [[nodiscard]] int rotations() const noexcept;
};

/// Whether the least code of all candidates is attained by one of the first `ours`; if so
/// the flags that attain it, else nothing useful, are left in `symmetry`.
/// Requires that the candidates are a union of orbits of flags, and ours >= 1.
/// Cost: O(n) per candidate, usually less.
[[nodiscard]] bool least_is_ours(const PlanarMap& map, const FlagList& candidates, std::size_t ours,
                                 Symmetry& symmetry) noexcept;

/// The images of all darts under each automorphism.
struct DartImages {
  bool mirrored = false;
  std::array<Dart, complex::kMaxDarts> of{};
};
[[nodiscard]] std::vector<DartImages> dart_images(const PlanarMap& map, const Symmetry& symmetry);

}  // namespace hexatlas::quads
