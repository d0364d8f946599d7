#pragma once
/// \file
/// Internal to the judge: the content of one Zstandard frame (RFC 8878).

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hexatlas::check {

/// Whether the bytes begin as a Zstandard frame, which is no skippable one.
[[nodiscard]] bool begins_zstd_frame(std::string_view bytes) noexcept;

/// Appends the content of `stored`, which must be exactly one frame, to `bytes`; false if it is
/// not, or if there are more than `most` bytes. The memory grows with what is really there.
[[nodiscard]] bool unpack_frame(std::string_view stored, std::uint64_t most, std::string& bytes);

/// The first bytes of the content, `most` of them or all there are; fewer if the frame is broken.
[[nodiscard]] std::string start_of_frame(std::string_view stored, std::size_t most);

}  // namespace hexatlas::check
