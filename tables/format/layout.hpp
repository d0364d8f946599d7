#pragma once
/// \file
/// Offsets of docs/formats/table.md, shared by the writer and the reader of tables/format.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::format::layout {

inline constexpr std::string_view kMagic = "hexatlas";
inline constexpr std::uint32_t kByteOrder = 0x0A0B0C0D;

inline constexpr std::size_t kVersion = 8;
inline constexpr std::size_t kByteOrderMark = 12;
inline constexpr std::size_t kFileSize = 16;
inline constexpr std::size_t kEntries = 24;
inline constexpr std::size_t kSections = 32;
inline constexpr std::size_t kBlocks = 36;
inline constexpr std::size_t kNames = 40;
inline constexpr std::size_t kEntriesPerBlock = 44;
inline constexpr std::size_t kIndexOffset = 48;
inline constexpr std::size_t kDirectoryOffset = 56;
inline constexpr std::size_t kNamesOffset = 64;
inline constexpr std::size_t kCompleteThrough = 72;
inline constexpr std::size_t kZeros = 76;  ///< up to the digest
inline constexpr std::size_t kDigest = 96;
inline constexpr std::size_t kHeaderSize = 128;

inline constexpr std::size_t kSectionSize = 32;
inline constexpr std::size_t kEntryFields = 8;  ///< after the key
inline constexpr std::size_t kDirectoryEntrySize = 16;

/// A claim of completeness is none (0) or names an even number of quads from 6 on.
[[nodiscard]] constexpr bool is_claim(std::uint32_t quads) noexcept {
  return quads == 0 || (quads >= 6 && quads <= complex::kMaxQuads && quads % 2 == 0);
}

/// Names have the characters a-z, 0-9 and '-', at least one and at most 255.
[[nodiscard]] constexpr bool is_name(std::string_view name) noexcept {
  constexpr std::string_view kCharacters = "abcdefghijklmnopqrstuvwxyz0123456789-";
  return !name.empty() && name.size() < 256 &&
         name.find_first_not_of(kCharacters) == std::string_view::npos;
}

}  // namespace hexatlas::format::layout
