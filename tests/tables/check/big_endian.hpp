#pragma once
/// \file
/// Numbers as binary legacy VTK files have them, for the tests of the judge's readers.

#include <cstdint>
#include <string>
#include <vector>

namespace hexatlas::check::examples {

/// Most significant byte first.
template <class Number>
std::string big_endian(const std::vector<Number>& numbers) {
  std::string bytes;
  for (const Number number : numbers)
    for (unsigned i = sizeof(Number); i-- > 0;)
      bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
  return bytes;
}

inline std::string big_endian(const std::vector<std::uint64_t>& numbers, bool is_wide) {
  if (is_wide) return big_endian(numbers);
  return big_endian(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
}

}  // namespace hexatlas::check::examples
