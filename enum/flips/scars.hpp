#pragma once
/// \file
/// Scars of a front in canonical labels: the related pairs of boundary vertices that lie in no
/// boundary quad. With the canonical code of the boundary they are all that decides what may be
/// glued on (docs/theory/proofs/front.md), so a state of a search is a code and its scars.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/front.hpp"

namespace hexatlas::flips {

/// Boundaries of states have at most 30 quads, so that the pairs of their 32 vertices fit into
/// eight words.
inline constexpr int kMaxStateQuads = 30;
/// Those of states with a symmetry, of which there are far fewer, have at most 40.
inline constexpr int kMaxSymmetricQuads = 40;
/// What most searches limit themselves to, in memory and time: boundaries to be filled, cavities.
inline constexpr int kMaxSearchQuads = 26;

/// A set of pairs of the vertices of a boundary with at most kQuads quads.
template <int kQuads>
class ScarSet {
 public:
  void add(complex::Vertex a, complex::Vertex b) noexcept {
    const std::size_t i = index(a, b);
    words_[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  [[nodiscard]] bool has(complex::Vertex a, complex::Vertex b) const noexcept {
    const std::size_t i = index(a, b);
    return (words_[i / 64] >> (i % 64) & 1U) != 0;
  }
  [[nodiscard]] int size() const noexcept {
    int count = 0;
    for (const std::uint64_t word : words_) count += std::popcount(word);
    return count;
  }
  [[nodiscard]] bool is_subset_of(const ScarSet& other) const noexcept {
    std::uint64_t missing = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) missing |= words_[i] & ~other.words_[i];
    return missing == 0;
  }
  [[nodiscard]] bool is_disjoint_from(const ScarSet& other) const noexcept {
    std::uint64_t common = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) common |= words_[i] & other.words_[i];
    return common == 0;
  }
  /// Cost: that of the pairs in common, of which there are few where this is asked.
  [[nodiscard]] int size_in_common(const ScarSet& other) const noexcept {
    int count = 0;
    for (std::size_t i = 0; i < words_.size(); ++i)
      for (std::uint64_t left = words_[i] & other.words_[i]; left != 0; left &= left - 1) ++count;
    return count;
  }
  /// The scars after renaming the vertices.
  [[nodiscard]] ScarSet renamed(const canon::Labelling& label) const noexcept;
  [[nodiscard]] std::uint64_t hash(std::uint64_t seed) const noexcept;
  /// The same pairs in a set for other boundaries. Requires that they are pairs of vertices of a
  /// boundary with at most kOther quads.
  template <int kOther>
  [[nodiscard]] ScarSet<kOther> as() const noexcept {
    ScarSet<kOther> result;
    std::copy_n(words_.begin(), std::min(words_.size(), result.words_.size()),
                result.words_.begin());
    return result;
  }

  friend auto operator<=>(const ScarSet&, const ScarSet&) = default;

 private:
  template <int>
  friend class ScarSet;
  static constexpr std::size_t kPairs = (kQuads + 2) * (kQuads + 1) / 2;
  [[nodiscard]] static constexpr std::size_t index(complex::Vertex a, complex::Vertex b) noexcept {
    const std::size_t low = a < b ? a : b;
    const std::size_t high = a < b ? b : a;
    return high * (high - 1) / 2 + low;
  }
  std::array<std::uint64_t, (kPairs + 63) / 64> words_{};
};

using Scars = ScarSet<kMaxStateQuads>;

/// The scars of a relation on `vertices` boundary vertices under a labelling: the related pairs
/// that `quads`, the relation of the boundary quads, does not have.
template <class Set = Scars>
[[nodiscard]] Set scars_of(const Relation& related, const Relation& quads, int vertices,
                           const canon::Labelling& label) noexcept {
  Set scars;
  for (int v = 0; v < vertices; ++v) {
    const auto a = static_cast<complex::Vertex>(v);
    VertexSet later = related[a] & ~quads[a] & ~(bit(a) - 1);
    for (; later != 0; later &= later - 1)
      scars.add(label[a], label[static_cast<std::size_t>(std::countr_zero(later))]);
  }
  return scars;
}

/// The front with this boundary and these scars. Requires a set for boundaries as large.
template <class Set>
[[nodiscard]] Front front_with(const complex::Quadrangulation& boundary, const Set& scars) {
  Front front{.boundary = boundary, .related = relation_of_quads(boundary)};
  for (int high = 1; high < boundary.vertices(); ++high)
    for (int low = 0; low < high; ++low) {
      const auto a = static_cast<complex::Vertex>(low);
      const auto b = static_cast<complex::Vertex>(high);
      if (!scars.has(a, b)) continue;
      front.related[a] |= bit(b);
      front.related[b] |= bit(a);
    }
  return front;
}

/// One way to see a boundary as the canonical one, with the scars of a relation on it there.
struct Position {
  canon::Labelling label{};  ///< canonical label of each boundary vertex
  bool is_mirrored = false;
  Scars scars;
};

/// Each of them, one per automorphism, in the order of `flags`, which are those of `boundary`.
[[nodiscard]] std::vector<Position> positions_of(const complex::Quadrangulation& boundary,
                                                 const canon::CanonicalFlags& flags,
                                                 const Relation& related);

/// A front up to isomorphism. Equal states permit the same further hexahedra.
struct State {
  canon::Code code;
  Scars scars;
  friend auto operator<=>(const State&, const State&) = default;
};

/// The state of a front, with the labelling that yields it: of all labellings that attain the
/// code, the one with the least scars. Requires at most kMaxStateQuads quads.
struct CanonicalState {
  State state;
  canon::Labelling label{};
  bool is_mirrored = false;
};
[[nodiscard]] CanonicalState canonical_state(const Front& front);

/// The front of a state, its boundary being the canonical list of quads.
/// Requires that the code can be decoded.
[[nodiscard]] Front front_of(const State& state);

}  // namespace hexatlas::flips
