#pragma once
/// \file
/// SHA-256 (FIPS 180-4), written for the judge so that it trusts no library of the writer.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hexatlas::check {

class Sha256 {
 public:
  void add(std::string_view bytes);
  /// The digest of all bytes added. Nothing may be added afterwards.
  [[nodiscard]] std::array<std::uint8_t, 32> digest();

 private:
  void compress(const std::uint8_t* block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_ = {};
  std::uint64_t length_ = 0;
};

/// In lower-case hexadecimal.
[[nodiscard]] std::string sha256_hex_of(std::string_view bytes);
/// Of the whole file. Errors: Malformed if it cannot be read.
[[nodiscard]] std::string sha256_hex(const std::filesystem::path& path);

}  // namespace hexatlas::check
