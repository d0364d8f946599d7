#pragma once
/// \file
/// Cavities that collars leave, looked up among known balls: the inner step of a meeting
/// (meeting.hpp), whatever search the collars come from.

#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "enum/flips/meeting.hpp"
#include "enum/flips/symmetric_beam.hpp"

namespace hexatlas::flips {

struct Cavity {
  State state;
  int collar = 0;  ///< hexahedra taken off
};

/// A cavity and a ball that fills it. The ball's canonical boundary vertex v lies at the cavity's
/// turn[v].
struct Meeting {
  canon::Code boundary;
  std::size_t ball = 0;    ///< its place among those of the boundary
  std::size_t cavity = 0;  ///< its place among those looked up with it
  canon::Labelling turn{};
  bool is_mirrored = false;  ///< the turn reverses orientation
  int hexahedra = 0;         ///< of the collar and the ball
};

/// An automorphism of a canonical list of quads: the image of each vertex.
struct Automorphism {
  canon::Labelling label{};
  bool is_mirrored = false;  ///< it reverses orientation
};
/// All of them. Requires a code that can be decoded.
[[nodiscard]] std::vector<Automorphism> automorphisms_of(const canon::Code& code);

/// Cavities that one task looks up, one after the other, where several threads do.
inline constexpr std::size_t kCavitiesPerTask = 512;

class Matcher {
 public:
  /// `balls` must outlive this. Only meetings with fewer than `below` hexahedra are of interest.
  Matcher(const BallSource& balls, int below, int threads)
      : balls_(balls), below_(below), threads_(threads) {}

  /// The least meeting of these cavities, if it is less than all before; of equal ones that of the
  /// first cavity and its first position. Deterministic for any number of threads.
  [[nodiscard]] std::optional<Meeting> match(std::span<const Cavity> cavities);
  /// Of each of these cavities, which match() must have seen: the least number of hexahedra that a
  /// ball makes with the collar, each scar in common counting as `price` of them; kNoPromise where
  /// no ball is small enough to be of interest.
  [[nodiscard]] std::vector<Promise> promises(std::span<const Cavity> cavities, int price) const;
  /// Only what has fewer hexahedra than this is still of interest.
  [[nodiscard]] int below() const noexcept { return below_; }
  void look_below(int hexahedra) noexcept { below_ = hexahedra; }

 private:
  /// The balls of one class, in every position that the symmetries of their boundary allow.
  struct Fillings {
    struct Position {
      Scars scars;
      std::uint32_t ball = 0;  ///< index into `balls`
      std::uint32_t turn = 0;  ///< index into `automorphisms`
    };
    std::vector<KnownBall> balls;
    std::vector<Automorphism> automorphisms;
    std::vector<Position> positions;  ///< fewest hexahedra first
  };

  void add_class(const Cavity& cavity);
  [[nodiscard]] std::optional<Meeting> match_one(const Cavity& cavity, int below) const;
  [[nodiscard]] Promise promise_of(const Cavity& cavity, int price) const;

  const BallSource& balls_;
  int below_;
  int threads_;
  std::unordered_map<canon::Code, Fillings> known_;
};

/// The boundary of a code. Requires one that has fillings: a 3-connected quadrangulation.
[[nodiscard]] complex::Quadrangulation boundary_of(const canon::Code& target);

/// The collar and a ball in its cavity, whose canonical boundary vertex v lies at the cavity's
/// turn[v], as a mesh of a boundary with so many quads.
[[nodiscard]] complex::HexComplex filled(const Layers& collar, const Layers& ball,
                                         const canon::Labelling& turn, bool is_mirrored, int quads);

/// The mesh that a meeting makes of a boundary with so many quads. `collar` leads to its cavity.
[[nodiscard]] Filling assembled(const BallSource& balls, const Layers& collar,
                                const Meeting& meeting, int quads);

}  // namespace hexatlas::flips
