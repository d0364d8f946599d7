#pragma once
/// \file
/// Internal to the judge: the binary arrays of VTK's XML files. An array is a header and data. The
/// header has words of 4 or 8 bytes: without compression one, the number of bytes of the data; with
/// compression the number of blocks, the bytes of a full block, the bytes of the last block if it
/// is not full (else 0), and the stored bytes of each block. In base64, header and data are one run
/// without compression and two runs with it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace hexatlas::check {

struct VtuEncoding {
  bool base64 = true;
  bool zlib = false;
  std::size_t word = 4;  ///< bytes of a word of the header
};

/// The data of the array that begins at `stored`, which may go on beyond it. `wanted` is the number
/// of bytes that it must have. Says what is wrong by `fail`, which does not return.
[[nodiscard]] std::string decode_vtu_array(std::string_view stored, const VtuEncoding& encoding,
                                           std::uint64_t wanted,
                                           const std::function<void(const std::string&)>& fail);

}  // namespace hexatlas::check
