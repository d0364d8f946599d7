#pragma once
/// \file
/// Letters of a code (docs/formats/code.md), two bits each.

#include <cstdint>

#include "enum/canon/code.hpp"

namespace hexatlas::canon {

inline constexpr int kLettersPerWord = 32;
inline constexpr int kMaxLetters = 2 * complex::kMaxQuads;

enum class Letter : std::uint8_t { down = 0, up = 1, open = 2, close = 3 };

[[nodiscard]] constexpr std::uint64_t place(Letter letter, int index) noexcept {
  const int shift = 62 - 2 * (index % kLettersPerWord);
  return static_cast<std::uint64_t>(letter) << static_cast<unsigned>(shift);
}

[[nodiscard]] constexpr Letter letter_at(const Code& code, int index) noexcept {
  const int shift = 62 - 2 * (index % kLettersPerWord);
  const std::uint64_t word = code.words[static_cast<std::size_t>(index / kLettersPerWord)];
  return static_cast<Letter>(word >> static_cast<unsigned>(shift) & 3U);
}

}  // namespace hexatlas::canon
