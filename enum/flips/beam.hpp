#pragma once
/// \file
/// Beam search over boundary classes: shellings grown hexahedron by hexahedron, several kept
/// for each canonical boundary.
///
/// A state is a front up to isomorphism: a canonical boundary and its scars (scars.hpp). Level
/// h holds states reached by h gluings. Within a class a state whose scars contain those of
/// another one, of the same or a lower level, is dropped: whatever may be glued on it may be
/// glued on the other (pruning `dominance`, docs/theory/proofs/front.md). Of the rest of one
/// level at most `fronts_per_class` with the fewest scars are kept, and at most `fronts_per_level`
/// of those are expanded. If neither limit was ever hit, the search was exhaustive: it saw every
/// boundary that a shelling can reach while its boundaries stay within max_quads, at its least
/// level.
///
/// Sources. The flips: Verhetsel, Pellerin, Remacle (ACM TOG 38(4), 2019). Scars and dominance
/// are of this project.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::flips {

struct BeamOptions {
  int max_quads = 22;                 ///< of any boundary, at most kMaxSearchQuads
  std::size_t fronts_per_class = 20;  ///< per level
  std::size_t fronts_per_level = 200'000;
  std::size_t max_fronts = 60'000'000;  ///< in memory, about 90 bytes each
  std::uint64_t seed = 1;               ///< breaks ties among equally many scars
  int threads = 1;                      ///< does not change the result
  bool use_dominance = true;            ///< off only to test the pruning
};

/// A state in a beam. Stable until the beam is destroyed.
struct FrontId {
  std::uint32_t shard = 0;
  std::uint32_t index = 0;
  friend auto operator<=>(FrontId, FrontId) = default;
};

/// What a beam knows of one state.
struct FrontRecord {
  FrontId id;
  int level = 0;  ///< hexahedra glued since the start; the start has level 0
  Scars scars;
};

class Beam {
 public:
  /// Level 0 is the start alone. Requires options within their ranges.
  Beam(const State& start, const BeamOptions& options);
  Beam(const Beam&) = delete;
  Beam& operator=(const Beam&) = delete;
  Beam(Beam&&) noexcept;
  Beam& operator=(Beam&&) noexcept;
  ~Beam();

  /// Expands the last level. Returns the number of states of the new one; 0: finished.
  /// Throws ResourceFailure when max_fronts would be exceeded.
  std::size_t expand_level();

  [[nodiscard]] int level() const noexcept { return level_; }
  /// The states of the last level that are to be expanded.
  [[nodiscard]] std::span<const FrontId> frontier() const noexcept { return frontier_; }
  /// Whether no limit was hit: with an empty frontier the answers are then theorems.
  [[nodiscard]] bool is_exhaustive() const noexcept { return !truncated_; }
  [[nodiscard]] std::size_t fronts() const noexcept;
  [[nodiscard]] std::size_t classes() const noexcept;
  /// Hexahedra tried since the start: the signature of the run.
  [[nodiscard]] std::uint64_t candidates() const noexcept { return candidates_; }

  [[nodiscard]] State state(FrontId id) const;
  [[nodiscard]] int level_of(FrontId id) const noexcept;
  /// The states of a class in order of level, empty if it was not reached.
  [[nodiscard]] std::vector<FrontRecord> fronts_of(const canon::Code& code) const;
  [[nodiscard]] std::optional<int> first_level(const canon::Code& code) const;
  /// All classes reached, in increasing order.
  [[nodiscard]] std::vector<canon::Code> codes() const;

  struct Step {
    FrontId from;
    Flip flip;
  };
  /// From the start to the state: the fronts passed and the flips made in them, in terms of
  /// front_of(state(from)).
  [[nodiscard]] std::vector<Step> path_to(FrontId id) const;

 private:
  struct Candidate;
  struct Shard;
  using Chunks = std::vector<std::vector<Candidate>>;

  void expand_batch(std::span<const FrontId> batch);
  void merge(Shard& shard, std::uint32_t number, const Chunks& chunks);
  void admit(Shard& shard, const Candidate& candidate);
  void collect_frontier();

  BeamOptions options_;
  std::vector<Shard> shards_;
  std::vector<FrontId> frontier_;
  std::uint64_t candidates_ = 0;
  int level_ = 0;
  bool truncated_ = false;
};

/// On which side of the front the hexahedra of a beam lie.
enum class Growth : std::uint8_t {
  outward,  ///< the start is a single hexahedron, the front encloses what was built
  inward    ///< the start is a boundary, the front encloses what is still to be filled
};

/// Hexahedra along a path, in the order of gluing, with vertices numbered as they appear: first
/// those of the start. `rim[v]` is the mesh vertex of canonical boundary vertex v of the last
/// front. The hexahedra are right-handed if the start's list of quads is counter-clockwise from
/// outside; `is_mirrored` says that the last front's list is clockwise then.
struct Layers {
  std::vector<complex::Hexahedron> hexahedra;
  std::uint32_t vertices = 0;
  std::vector<std::uint32_t> rim;
  bool is_mirrored = false;
};
[[nodiscard]] Layers layers_along(const Beam& beam, FrontId id, Growth growth);

}  // namespace hexatlas::flips
