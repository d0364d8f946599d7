#pragma once
/// \file
/// Doubles as odd integers times powers of two. Private to realize/exact.

#include <bit>
#include <cstdint>
#include <limits>

namespace hexatlas::exact {

/// 2^exponent. Requires. A normal double; not checked.
[[nodiscard]] inline double power_of_two(int exponent) noexcept {
  constexpr int kFractionBits = std::numeric_limits<double>::digits - 1;
  const int biased = exponent - (std::numeric_limits<double>::min_exponent - 2);
  return std::bit_cast<double>(static_cast<std::uint64_t>(biased) << kFractionBits);
}

/// value = mantissa 2^exponent, |mantissa| < 2^53 and odd; the exponent of zero is meaningless.
struct BinaryParts {
  std::int64_t mantissa;
  int exponent;
};

/// Requires. A finite value; not checked.
[[nodiscard]] inline BinaryParts binary_parts(double value) noexcept {
  constexpr int kFractionBits = std::numeric_limits<double>::digits - 1;
  constexpr std::uint64_t kHidden = std::uint64_t{1} << kFractionBits;
  constexpr int kExponentMask = 0x7ff;
  constexpr int kLeastExponent =
      std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t fraction = bits & (kHidden - 1);
  const int biased = static_cast<int>(bits >> kFractionBits) & kExponentMask;
  const std::uint64_t magnitude = biased != 0 ? fraction | kHidden : fraction;
  if (magnitude == 0) return {0, 0};
  const int zeros = std::countr_zero(magnitude);
  const auto odd = static_cast<std::int64_t>(magnitude >> zeros);
  return {value < 0 ? -odd : odd, kLeastExponent + (biased != 0 ? biased - 1 : 0) + zeros};
}

}  // namespace hexatlas::exact
