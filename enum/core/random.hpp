#pragma once
/// \file
/// Random numbers that are the same everywhere, for choices that need a seed.

#include <cstddef>
#include <cstdint>

namespace hexatlas::core {

/// The bits of a number, mixed: the output function of SplitMix64.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t z) noexcept {
  z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ z >> 27U) * 0x94D049BB133111EBULL;
  return z ^ z >> 31U;
}

/// SplitMix64: Steele, Lea, Flood (OOPSLA 2014). Fast, and good enough to choose by.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] std::uint64_t number() noexcept { return mixed(state_ += 0x9E3779B97F4A7C15ULL); }
  /// In [0, n), with a bias below n / 2^64. Requires n > 0.
  [[nodiscard]] std::size_t below(std::size_t n) noexcept {
    return static_cast<std::size_t>(number() % n);
  }
  /// In [0, 1), a multiple of 2^-53.
  [[nodiscard]] double uniform() noexcept { return static_cast<double>(number() >> 11U) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace hexatlas::core
