#pragma once
/// \file
/// Integers of fixed width in two's complement, for determinants that double precision cannot
/// decide: no allocation, no loops of unknown length. Private to realize/exact.
///
/// Widths. Let the coordinates of vectors be below 2^(64 W - 2) in absolute value. Then, with s =
/// 64 W, what determinants and in-sphere tests compute from them fits:
///   squared lengths            3 2^(2s - 4)  < 2^(2s - 2)    2 W limbs
///   minors of two vectors      2 2^(2s - 4)  < 2^(2s - 2)    2 W limbs
///   determinants of three      6 2^(3s - 6)  < 2^(3s - 3)    3 W limbs
///   the sum of four of them   24 2^(3s - 6)  < 2^(3s - 1)    3 W limbs
///   four of them by squares   72 2^(5s - 10) < 2^(5s - 3)    5 W limbs
/// and so do the partial sums, in any order. An operation beyond its width wraps around.

#include <array>
#include <cstddef>
#include <cstdint>

#include "realize/exact/determinant.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;

/// Least limb first.
template <std::size_t kLimbs>
struct Limbs {
  std::array<std::uint64_t, kLimbs> limb;

  [[nodiscard]] bool is_negative() const noexcept { return limb[kLimbs - 1] >> 63U != 0; }

  Limbs& operator+=(const Limbs& other) noexcept {
    UnsignedWide carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      carry += UnsignedWide{limb[i]} + other.limb[i];
      limb[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64U;
    }
    return *this;
  }
  Limbs& operator-=(const Limbs& other) noexcept {
    UnsignedWide carry = 1;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      carry += UnsignedWide{limb[i]} + ~other.limb[i];
      limb[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64U;
    }
    return *this;
  }
  friend Limbs operator+(Limbs a, const Limbs& b) noexcept { return a += b; }
  friend Limbs operator-(Limbs a, const Limbs& b) noexcept { return a -= b; }
  friend bool operator==(const Limbs&, const Limbs&) = default;
};

/// a - b 2^(64 kShift) if `condition`, else a; without a branch, since signs are not predictable.
template <std::size_t kShift, std::size_t kA, std::size_t kB>
void subtract_shifted_if(bool condition, Limbs<kA>& a, const Limbs<kB>& b) noexcept {
  static_assert(kShift + kB == kA);
  const std::uint64_t mask = condition ? ~std::uint64_t{0} : 0;
  UnsignedWide carry = 1;
  for (std::size_t i = 0; i < kB; ++i) {
    carry += UnsignedWide{a.limb[i + kShift]} + ~(b.limb[i] & mask);
    a.limb[i + kShift] = static_cast<std::uint64_t>(carry);
    carry >>= 64U;
  }
}

/// The whole product. A negative factor a was read as a + 2^(64 kA), which is corrected.
template <std::size_t kA, std::size_t kB>
[[nodiscard]] Limbs<kA + kB> operator*(const Limbs<kA>& a, const Limbs<kB>& b) noexcept {
  Limbs<kA + kB> product{};
  for (std::size_t i = 0; i < kA; ++i) {
    UnsignedWide carry = 0;
    for (std::size_t j = 0; j < kB; ++j) {
      carry += UnsignedWide{a.limb[i]} * b.limb[j] + product.limb[i + j];
      product.limb[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64U;
    }
    product.limb[i + kB] = static_cast<std::uint64_t>(carry);
  }
  subtract_shifted_if<kA>(a.is_negative(), product, b);
  subtract_shifted_if<kB>(b.is_negative(), product, a);
  return product;
}

template <std::size_t kLimbs>
[[nodiscard]] Sign sign_of(const Limbs<kLimbs>& value) noexcept {
  if (value.is_negative()) return Sign::negative;
  return value == Limbs<kLimbs>{} ? Sign::zero : Sign::positive;
}

template <std::size_t kLimbs>
struct Degrees<Limbs<kLimbs>> {
  using Two = Limbs<2 * kLimbs>;
  using Three = Limbs<3 * kLimbs>;
  using Five = Limbs<5 * kLimbs>;
};

}  // namespace hexatlas::exact
