#pragma once
/// \file
/// Little-endian unsigned integers in byte strings.

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace hexatlas::format {

template <std::unsigned_integral T>
void put(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

/// Requires at + sizeof(T) <= bytes.size().
template <std::unsigned_integral T>
[[nodiscard]] T get(std::string_view bytes, std::size_t at) noexcept {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    value = static_cast<T>(value | static_cast<T>(static_cast<unsigned char>(bytes[at + i]))
                                       << (8 * i));
  return value;
}

}  // namespace hexatlas::format
