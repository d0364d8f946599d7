#pragma once
/// \file
/// Numbers in sentences.

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace hexatlas::core {

/// "1 hexahedron", "36 hexahedra".
[[nodiscard]] inline std::string counted(std::size_t number, std::string_view one,
                                         std::string_view many) {
  return std::to_string(number) + " " + std::string(number == 1 ? one : many);
}

/// The shortest decimal number that reads back as the same double.
[[nodiscard]] inline std::string shortest(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

/// "(0.5, 1, -2)".
[[nodiscard]] inline std::string place(double x, double y, double z) {
  return "(" + shortest(x) + ", " + shortest(y) + ", " + shortest(z) + ")";
}

}  // namespace hexatlas::core
