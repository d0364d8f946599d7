#pragma once
/// \file
/// Bytes as one zstd frame.

#include <string>
#include <string_view>

namespace hexatlas::format {

/// At a high level: files are written once and read often. The bytes depend on the version of the
/// library. Throws ResourceFailure.
[[nodiscard]] std::string compressed(std::string_view bytes);

/// Whether the frame holds exactly bytes.size() bytes, which then are in `bytes`. Throws bad_alloc
/// where memory is short, which says nothing about the frame.
[[nodiscard]] bool is_unpacked(std::string_view frame, std::string& bytes);

/// Whether these are the first bytes of a frame.
[[nodiscard]] bool is_compressed(std::string_view bytes) noexcept;

}  // namespace hexatlas::format
