#pragma once
/// \file
/// Beam search over boundary classes: shellings grown hexahedron by hexahedron, several kept
/// for each canonical boundary.
///
/// A state is a front up to isomorphism: a canonical boundary and its scars (scars.hpp). Level
/// h holds states reached by h gluings. Dominated states are dropped (front_store.hpp). Of the
/// rest of one level at most `fronts_per_class` of a class are kept, those with the fewest scars,
/// and at most `fronts_per_level` are expanded: the first ones of all classes, then the second
/// ones, and so on. If neither limit was ever hit, the search was exhaustive: it saw every boundary
/// that a shelling can reach while its boundaries stay within max_quads, at its least level.
///
/// A search may be swept again: after rewind(), states that came by add() since are expanded
/// level by level, and what follows from them.
///
/// Sources. The flips: Verhetsel, Pellerin, Remacle (ACM TOG 38(4), 2019). Scars, dominance and the
/// order of expansion are of this project.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/front_store.hpp"

namespace hexatlas::flips {

inline constexpr unsigned kMaxPerIrregularity = 50;
inline constexpr unsigned kMaxPerSimpleZone = 500;

struct BeamOptions {
  int max_quads = 22;                 ///< of boundaries grown, at most kMaxStateQuads
  std::size_t fronts_per_class = 20;  ///< per level
  std::size_t fronts_per_level = 200'000;
  std::size_t max_fronts = 60'000'000;  ///< in memory, about 100 bytes each; then no more come
  /// Among the fronts of different classes a quad of the boundary counts as so many scars.
  unsigned scars_per_quad = 0;
  /// And each unit of its irregularity as so many scars less: boundaries with vertices of high
  /// degree, and hence many of degree 3, are few among those grown, and the hardest to fill.
  unsigned scars_per_irregularity = 0;  ///< at most kMaxPerIrregularity
  /// And each zone of the boundary that does not cross itself as so many scars more: the fewer a
  /// boundary has of them, the harder it is to fill (docs/architecture/decisions/0033).
  unsigned scars_per_simple_zone = 0;  ///< at most kMaxPerSimpleZone
  std::uint64_t seed = 1;              ///< breaks ties among equally many scars
  int threads = 1;                     ///< does not change the result
  bool use_dominance = true;           ///< off only to test the pruning
};

/// What a boundary with at most `max_quads` quads adds to the scars of its fronts by these options,
/// and a constant. Requires that the code can be decoded.
[[nodiscard]] std::uint64_t price_of(const canon::Code& code, const BeamOptions& options,
                                     int max_quads);

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

  /// Expands the states of the last level that were chosen. Returns how many of the next one are
  /// chosen, all of them or those that the limit admits; 0: nothing more follows from this sweep.
  std::size_t expand_level();
  /// Back to level 0, for another sweep.
  void rewind();

  [[nodiscard]] int level() const noexcept { return level_; }
  /// The greatest level that has a state.
  [[nodiscard]] int last_level() const noexcept { return last_level_; }
  /// The states of the last level that are to be expanded.
  [[nodiscard]] std::span<const FrontId> frontier() const noexcept { return frontier_; }
  /// Whether no limit was hit: with an empty frontier the answers are then theorems.
  [[nodiscard]] bool is_exhaustive() const noexcept { return !store_.is_truncated(); }
  [[nodiscard]] std::size_t fronts() const noexcept { return store_.fronts(); }
  [[nodiscard]] std::size_t classes() const noexcept { return store_.families(); }
  /// Hexahedra tried since the start: the signature of the run.
  [[nodiscard]] std::uint64_t candidates() const noexcept { return candidates_; }
  [[nodiscard]] const BeamOptions& options() const noexcept { return options_; }

  [[nodiscard]] State state(FrontId id) const {
    return {store_.family(id.family).code, store_.at(id).scars};
  }
  [[nodiscard]] FrontOrigin origin_of(FrontId id) const noexcept { return store_.at(id).origin; }
  [[nodiscard]] int level_of(FrontId id) const noexcept { return store_.at(id).level; }
  /// The states of a class in order of level, empty if it was not reached.
  [[nodiscard]] std::vector<FrontRecord> fronts_of(const canon::Code& code) const;
  /// The first state of the least level that the class has, and that level.
  [[nodiscard]] std::optional<FrontId> smallest(const canon::Code& code) const;
  [[nodiscard]] std::optional<int> first_level(const canon::Code& code) const;
  /// All classes reached, in increasing order.
  [[nodiscard]] std::vector<canon::Code> codes() const;
  [[nodiscard]] const FrontStore& store() const noexcept { return store_; }

  /// Glues a hexahedron on a state, whatever the limits. Returns the state made, or one that was
  /// known and dominates it: one with the same boundary, a subset of its scars and no greater
  /// level. Requires that the flip may be made. `label` receives the canonical label of each vertex
  /// of flipped(front_of(state(from))).
  FrontId add(FrontId from, Flip flip, FrontOrigin origin, canon::Labelling& label);

  struct Step {
    FrontId from;
    Flip flip;
  };
  /// From the start to the state: the fronts passed and the flips made in them, in terms of
  /// front_of(state(from)).
  [[nodiscard]] std::vector<Step> path_to(FrontId id) const;

  /// All that a search needs to go on as if it had never stopped, about 12 bytes per state.
  [[nodiscard]] std::string to_bytes() const;
  /// The search that to_bytes() described, from the same start. Every state is made again by its
  /// flip, so that no damage of the bytes can give a wrong one. Throws InvalidInput, with `name`
  /// for the file, if the bytes are damaged or of a search with other options; the number of
  /// threads and max_fronts may be others.
  [[nodiscard]] static Beam from_bytes(std::string_view bytes, const State& start,
                                       const BeamOptions& options, const std::string& name);

 private:
  struct Chunk;
  struct Waiting;

  void expand_batch(std::span<const FrontId> batch);
  [[nodiscard]] std::vector<Waiting> waiting(std::size_t shard) const;
  void choose_frontier();
  void collect_chosen();
  void restore_level(std::span<const FrontId> ids, const std::string& name);

  BeamOptions options_;
  FrontStore store_;
  std::vector<FrontId> frontier_;
  std::uint64_t candidates_ = 0;
  int level_ = 0;
  int last_level_ = 0;
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

/// Puts a ball, grown outward, into a mesh, its last hexahedron first: `rim[v]` is the mesh vertex
/// of canonical boundary vertex v of the ball; its other vertices are new. `is_mirrored`: the
/// canonical list of quads is clockwise from outside there.
void append_ball(complex::HexComplex& mesh, const Layers& ball,
                 std::span<const complex::VertexId> rim, bool is_mirrored);

}  // namespace hexatlas::flips
