#pragma once
/// \file
/// A store of fronts up to isomorphism: for each canonical boundary the fronts known, each with
/// the gluing that made it from another one.
///
/// A *family* is the set of stored fronts with one canonical boundary. Within a family a front
/// whose scars contain those of another one, of the same or a lower level, is not kept: whatever
/// may be glued on it may be glued on the other (pruning `dominance`, docs/theory/proofs/front.md).
/// Families are dealt to shards by a hash of their codes; distinct shards may be changed by
/// distinct threads at the same time.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/quad_flip.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::flips {

/// A front in a store. Stable from the end of the pass in which it came.
struct FrontId {
  std::uint32_t family = 0;
  std::uint32_t place = 0;  ///< within the family
  friend auto operator<=>(FrontId, FrontId) = default;
};

enum class FrontMark : std::uint8_t {
  waiting,  ///< never chosen for expansion
  chosen,   ///< in the frontier, to be expanded next
  expanded
};

/// By which means a front was found first.
enum class FrontOrigin : std::uint8_t {
  grown,      ///< by a sweep of the beam
  exchanged,  ///< part of a mesh made smaller (replacement.hpp)
  met,        ///< part of a mesh from a collar and a ball (meeting.hpp)
  joined,     ///< part of a mesh from two balls along a disc (cut.hpp)
  known       ///< part of a mesh that was known before the search
};
inline constexpr std::uint8_t kFrontOrigins = 5;

struct StoredFront {
  Scars scars;
  FrontId parent;  ///< of the start: itself
  Flip flip;       ///< made in front_of() the parent's state
  std::uint16_t level = 0;
  std::uint16_t size = 0;  ///< number of scars
  FrontMark mark = FrontMark::waiting;
  FrontOrigin origin = FrontOrigin::grown;
};

class FrontStore {
 public:
  static constexpr std::size_t kShards = 64;

  struct Limits {
    std::size_t fronts_per_family = 20;  ///< that come in one pass
    std::size_t max_fronts = 60'000'000;
    std::uint64_t seed = 1;     ///< breaks ties among equally many scars
    bool use_dominance = true;  ///< off only to test the pruning
  };

  /// A front that asks for admission.
  struct Offer {
    State state;
    FrontId parent;
    Flip flip;
    std::uint16_t level = 0;
  };

  struct Family {  ///< never without a front
    canon::Code code;
    std::vector<StoredFront> fronts;
    std::uint32_t pass = 0;             ///< the last pass in which fronts came
    std::uint32_t fresh_begin = 0;      ///< first place of that pass
    std::uint16_t level_floor = 65535;  ///< the least level of a front, from the end of a pass on
    bool has_added = false;             ///< some came outside of any pass
    void set_level_floor() noexcept;
  };

  explicit FrontStore(const Limits& limits) : limits_(limits), shards_(kShards) {}

  [[nodiscard]] static std::size_t shard_of(const canon::Code& code) noexcept;

  /// A pass brings fronts of one level. Until it ends, those that came in it may be removed again
  /// and their places are not final.
  void begin_pass() noexcept { ++pass_; }
  /// Admits, refuses, or admits at the cost of fresh fronts that are dominated or, beyond the
  /// limits, of the worst fresh one: most scars first. Requires number == shard_of(code).
  void offer(std::size_t number, const Offer& offer);
  /// Removes the fresh fronts of a shard that are not chosen, but never the first of a family.
  void end_pass(std::size_t number);
  /// Fronts that earlier passes left waiting may be chosen again.
  void begin_sweep() noexcept { is_first_sweep_ = false; }
  /// Whether the family may have fronts of this pass's level, waiting or chosen. In the first sweep
  /// only those families do that got some in this pass, or outside of any pass.
  [[nodiscard]] bool may_have_current(const Family& own) const noexcept {
    return !is_first_sweep_ || own.pass == pass_ || own.has_added;
  }

  /// Adds a front outside of any pass, whatever the limits, unless one of its family, of the same
  /// or a lower level, has a subset of its scars. Returns the new one or that one.
  FrontId add(const Offer& offer, FrontOrigin origin);

  [[nodiscard]] const StoredFront& at(FrontId id) const noexcept {
    return family(id.family).fronts[id.place];
  }
  [[nodiscard]] bool contains(FrontId id) const noexcept {
    const auto& families = shards_[id.family % kShards].families;
    return id.family / kShards < families.size() &&
           id.place < families[id.family / kShards].fronts.size();
  }
  void set_mark(FrontId id, FrontMark mark) noexcept;
  [[nodiscard]] const Family& family(std::uint32_t number) const noexcept {
    return shards_[number % kShards].families[number / kShards];
  }
  [[nodiscard]] std::optional<std::uint32_t> find(const canon::Code& code) const noexcept;
  [[nodiscard]] std::span<const Family> families(std::size_t shard) const noexcept {
    return shards_[shard].families;
  }
  [[nodiscard]] static constexpr std::uint32_t number_of(std::size_t shard,
                                                         std::size_t index) noexcept {
    return static_cast<std::uint32_t>(index * kShards + shard);
  }
  [[nodiscard]] std::size_t fronts() const noexcept;
  [[nodiscard]] std::size_t families() const noexcept;
  /// Whether a limit was ever hit.
  [[nodiscard]] bool is_truncated() const noexcept;
  /// Notes that something was left out elsewhere.
  void set_truncated() noexcept { truncated_ = true; }

  /// Order in which fronts of one family are preferred: fewest scars first, ties by a hash.
  [[nodiscard]] std::uint64_t rank(const StoredFront& front) const noexcept;
  static constexpr std::uint64_t kScar = std::uint64_t{1} << 48U;  ///< what one adds to the rank

  /// For restoring a saved store: a family as the next one of its shard, and the scars of its
  /// fronts later. Requires that the code is not there yet.
  void append_family(const canon::Code& code, std::vector<StoredFront> fronts);
  void set_scars(FrontId id, const Scars& scars) noexcept;
  [[nodiscard]] const Limits& limits() const noexcept { return limits_; }

 private:
  struct Shard {
    std::vector<Family> families;
    std::vector<std::uint32_t> slots;  ///< hash table: index of the family plus 1, 0: free
    std::size_t fronts = 0;
    bool truncated = false;
  };

  [[nodiscard]] static std::size_t slot_of(const Shard& shard, const canon::Code& code) noexcept;
  Family& family_for(Shard& shard, const canon::Code& code);
  [[nodiscard]] bool is_full(const Shard& shard) const noexcept;
  [[nodiscard]] bool is_dominated(const Family& own, const Offer& offer) const noexcept;
  bool make_room(Shard& shard, Family& own, const StoredFront& wanted);

  Limits limits_;
  std::vector<Shard> shards_;
  std::uint32_t pass_ = 0;
  bool truncated_ = false;
  bool is_first_sweep_ = true;
};

}  // namespace hexatlas::flips
