#pragma once
/// \file
/// The binary arrays of VTK XML files: base64 or raw, compressed by zlib or not, each with a
/// header of little-endian integers of 4 or 8 bytes. Source: "VTK File Formats", section "XML File
/// Formats", and RFC 4648 for base64.
///
///   uncompressed   [number of bytes][bytes]                        one base64 text
///   compressed     [blocks][size of a block][size of the last, partial block or 0]
///                  [compressed size of each block]                 one base64 text
///                  [compressed blocks]                             another one
///
/// Errors: InvalidInput at the line given. The decoded size is compared with the size of what is
/// there before memory is taken.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hexatlas::io {

inline constexpr std::uint64_t kLargestRatio = 1032;  ///< that zlib's deflate can reach

struct VtuEncoding {
  bool is_base64;
  bool is_compressed;
  std::size_t header_bytes;  ///< 4 or 8
};

/// Where an array stands, for messages.
struct Place {
  const std::string& file;
  std::size_t line;
  [[noreturn]] void fail(const std::string& reason) const;
};

/// The array at the start of `data`; what follows it is not looked at.
[[nodiscard]] std::string decode_array(std::string_view data, const VtuEncoding& encoding,
                                       const Place& place);

/// The bytes as base64 text, padded, in one line.
[[nodiscard]] std::string to_base64(std::string_view bytes);

/// The array as base64 text, compressed, with headers of 8 bytes.
[[nodiscard]] std::string encode_array(std::string_view bytes);

}  // namespace hexatlas::io
