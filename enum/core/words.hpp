#pragma once
/// \file
/// Numbers in sentences.

#include <cstddef>
#include <string>
#include <string_view>

namespace hexatlas::core {

/// "1 hexahedron", "36 hexahedra".
[[nodiscard]] inline std::string counted(std::size_t number, std::string_view one,
                                         std::string_view many) {
  return std::to_string(number) + " " + std::string(number == 1 ? one : many);
}

}  // namespace hexatlas::core
