#pragma once
/// \file
/// Balls with an involution, and the cavities of symmetric collars that they fill.
///
/// Why. A beam of single hexahedra holds next to nothing with boundaries of 30 quads and more, but
/// symmetric balls are few: of 20 hexahedra, with up to 36 quads on the way, those that have a
/// half-turn have 165,059 states. So a collar and a ball can meet at long boundaries, half-way,
/// each of them one of all there are or of many.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "enum/flips/faults.hpp"
#include "enum/flips/symmetric_beam.hpp"

namespace hexatlas::flips {

/// A cavity with an involution and a ball that fills it and has the same one. The ball's canonical
/// boundary vertex v lies at the cavity's turn[v].
struct SymmetricFit {
  std::size_t cavity = 0;       ///< its place among those looked up
  bool is_of_mirrored = false;  ///< the involution reverses orientation
  std::uint32_t ball = 0;       ///< its place among the balls of its kind
  canon::Labelling turn{};
  bool is_mirrored = false;  ///< the turn reverses orientation
  int hexahedra = 0;         ///< of the collar and the ball
};

/// A ball in a cavity of its kind, whatever they have in common. There may be millions.
struct SymmetricPairing {
  std::uint32_t ball = 0;       ///< as in SymmetricFit
  std::uint16_t turn = 0;       ///< among the turns that the cavity has
  bool is_of_mirrored = false;  ///< as in SymmetricFit
};

class SymmetricBalls {
 public:
  /// Grows them, with at most so many hexahedra; the limits are for half-turns and for what
  /// reverses orientation, each by itself. Cost: some 100 microseconds for each that is grown from.
  SymmetricBalls(const BeamOptions& options, int max_hexahedra);

  /// How many were grown from, which are those that fill cavities.
  [[nodiscard]] std::size_t size() const noexcept;

  /// Of all balls in all these cavities of collars the union with the fewest hexahedra that obeys
  /// the strict rule, if it has fewer than `below`; of equal ones that of the first cavity,
  /// for any number of threads.
  [[nodiscard]] std::optional<SymmetricFit> least_fit(std::span<const SymmetricBeam::Node> cavities,
                                                      int below, int threads) const;
  [[nodiscard]] Layers layers_of(const SymmetricFit& fit) const;

  /// Calls visit(pairing, hexahedra of both, faults) for each ball and turn in this cavity that
  /// `wanted` includes. Deterministic order.
  using Visit = std::function<void(const SymmetricPairing&, int hexahedra, int faults)>;
  void for_each_pairing(const SymmetricBeam::Node& cavity, const FaultyWanted& wanted,
                        const Visit& visit) const;
  /// What such a pairing is; `cavity` of the result is 0.
  [[nodiscard]] SymmetricFit fit_of(const SymmetricBeam::Node& cavity,
                                    const SymmetricPairing& pairing) const;

 private:
  struct Entry {
    std::uint64_t kind = 0;  ///< hash of the class
    std::uint32_t ball = 0;  ///< among those expanded
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  /// Calls visit(index of the beam, place of the ball) for those of the cavity's kind, those of
  /// each beam in order of hexahedra, until it returns false, then those of the next.
  template <class OfKind>
  void for_each_of_kind(const SymmetricBeam::Node& cavity, OfKind&& visit) const;
  void fit_one(const SymmetricBeam::Node& cavity, SymmetricFit& best) const;

  std::array<SymmetricBeam, 2> beams_;         ///< half-turns; what reverses orientation
  std::array<std::vector<Entry>, 2> by_kind_;  ///< ascending
};

}  // namespace hexatlas::flips
