#pragma once
/// \file
/// SHA-256 (FIPS 180-4), by OpenSSL.

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace hexatlas::format {

using Digest = std::array<unsigned char, 32>;

/// Of the parts one after the other.
[[nodiscard]] Digest sha256(std::span<const std::string_view> parts);
[[nodiscard]] std::string to_hex(const Digest& digest);

}  // namespace hexatlas::format
