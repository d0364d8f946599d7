#pragma once
/// \file
/// Numbers in the binary parts of mesh files: little endian, as on the machines that hexatlas
/// builds for.

#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

namespace hexatlas::io {

static_assert(std::endian::native == std::endian::little,
              "binary mesh data are copied; a big-endian machine needs byte swaps here");

/// The number in the first bytes. Requires: bytes.size() >= sizeof(Number).
template <class Number>
[[nodiscard]] Number load_little(std::string_view bytes) {
  Number value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

template <class Number>
void append_little(std::string& bytes, Number value) {
  const auto buffer = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  bytes.append(buffer.data(), buffer.size());
}

}  // namespace hexatlas::io
