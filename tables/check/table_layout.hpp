#pragma once
/// \file
/// Internal to the judge: the parts of a table file and how they follow one another.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexatlas::check {

/// The little-endian number in `size` bytes at `at`. Requires: they lie inside.
[[nodiscard]] std::uint64_t number_at(std::string_view bytes, std::uint64_t at, unsigned size);

struct TableSection {
  std::uint32_t quads = 0;
  std::uint32_t key_bytes = 0;
  std::uint64_t first = 0;  ///< ordinal of its first entry
  std::uint64_t count = 0;
  std::uint64_t offset = 0;
};

struct TableBlock {
  std::uint64_t offset = 0;
  std::uint64_t stored = 0;
  std::uint64_t unpacked = 0;
};

struct TableLayout {
  std::uint64_t entries = 0;
  std::uint64_t entries_per_block = 0;
  std::uint64_t names = 0;
  std::uint32_t complete_through = 0;  ///< as claimed; 0: nothing
  std::vector<TableSection> sections;
  std::vector<TableBlock> blocks;
};

/// Reads header, sections, block directory and names, and checks them, with the digest. Returns
/// the first broken law, or nothing if all parts are as they should be.
[[nodiscard]] std::string read_layout(std::string_view bytes, TableLayout& layout);

}  // namespace hexatlas::check
