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
#include <type_traits>
#include <utility>

#include "realize/exact/determinant.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;

/// step(0), ..., step(kCount - 1) with constant indices: a loop would keep the limbs in memory.
template <std::size_t kCount, class Step>
[[gnu::always_inline]] inline void unrolled(const Step& step) noexcept {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) __attribute__((always_inline)) {
    (step(std::integral_constant<std::size_t, kIndex>{}), ...);
  }
  (std::make_index_sequence<kCount>{});
}

/// Least limb first.
template <std::size_t kLimbs>
struct Limbs {
  std::array<std::uint64_t, kLimbs> limb;

  [[nodiscard]] bool is_negative() const noexcept { return limb[kLimbs - 1] >> 63U != 0; }

  /// Limbs 2i and 2i + 1.
  [[nodiscard]] [[gnu::always_inline]] UnsignedWide pair(std::size_t i) const noexcept {
    return UnsignedWide{limb[2 * i + 1]} << 64U | limb[2 * i];
  }
  [[gnu::always_inline]] void set_pair(std::size_t i, UnsignedWide value) noexcept {
    limb[2 * i] = static_cast<std::uint64_t>(value);
    limb[2 * i + 1] = static_cast<std::uint64_t>(value >> 64U);
  }

  [[gnu::always_inline]] friend Limbs operator+(const Limbs& a, const Limbs& b) noexcept {
    Limbs sum{};
    bool carry = false;
    unrolled<kLimbs / 2>([&](auto i) __attribute__((always_inline)) {
      const UnsignedWide without_carry = a.pair(i) + b.pair(i);
      const UnsignedWide digit = without_carry + carry;
      carry = (without_carry < a.pair(i)) | (digit < without_carry);
      sum.set_pair(i, digit);
    });
    if constexpr (kLimbs % 2 != 0)
      sum.limb[kLimbs - 1] = a.limb[kLimbs - 1] + b.limb[kLimbs - 1] + carry;
    return sum;
  }
  [[gnu::always_inline]] friend Limbs operator-(const Limbs& a, const Limbs& b) noexcept {
    Limbs rest{};
    bool borrow = false;
    unrolled<kLimbs / 2>([&](auto i) __attribute__((always_inline)) {
      const UnsignedWide without_borrow = a.pair(i) - b.pair(i);
      const UnsignedWide digit = without_borrow - borrow;
      borrow = (a.pair(i) < b.pair(i)) | (without_borrow < digit);
      rest.set_pair(i, digit);
    });
    if constexpr (kLimbs % 2 != 0)
      rest.limb[kLimbs - 1] = a.limb[kLimbs - 1] - b.limb[kLimbs - 1] - borrow;
    return rest;
  }
  friend bool operator==(const Limbs&, const Limbs&) = default;
};

/// a - b 2^(64 kShift) if `condition`, else a; without a branch, since signs are not predictable.
template <std::size_t kShift, std::size_t kA, std::size_t kB>
[[gnu::always_inline]] inline void subtract_shifted_if(bool condition, Limbs<kA>& a,
                                                       const Limbs<kB>& b) noexcept {
  static_assert(kShift + kB == kA);
  const std::uint64_t mask = condition ? ~std::uint64_t{0} : 0;
  Limbs<kB> high{};
  Limbs<kB> masked{};
  unrolled<kB>([&](auto i) __attribute__((always_inline)) {
    high.limb[i] = a.limb[i + kShift];
    masked.limb[i] = b.limb[i] & mask;
  });
  high = high - masked;
  unrolled<kB>([&](auto i) __attribute__((always_inline)) { a.limb[i + kShift] = high.limb[i]; });
}

/// The whole product. A negative factor a was read as a + 2^(64 kA), which is corrected.
template <std::size_t kA, std::size_t kB>
[[nodiscard]] [[gnu::always_inline]] inline Limbs<kA + kB> operator*(const Limbs<kA>& a,
                                                                     const Limbs<kB>& b) noexcept {
  Limbs<kA + kB> product{};
  if constexpr (kA == 1 && kB == 1) {
    product.set_pair(0, static_cast<UnsignedWide>(Wide{static_cast<std::int64_t>(a.limb[0])} *
                                                  static_cast<std::int64_t>(b.limb[0])));
    return product;
  }
  unrolled<kA>([&](auto i) __attribute__((always_inline)) {
    UnsignedWide carry = 0;
    unrolled<kB>([&](auto j) __attribute__((always_inline)) {
      carry += UnsignedWide{a.limb[i]} * b.limb[j] + product.limb[i + j];
      product.limb[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64U;
    });
    product.limb[i + kB] = static_cast<std::uint64_t>(carry);
  });
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
