#pragma once
/// \file
/// The judge of tables of hexahedral meshes (docs/formats/table.md). It checks every law stated
/// there, with its own digest, its own canonical code, and the laws of meshes of verdict.hpp.
///
/// The flips of encoding 0 are replayed, and the order of the hexahedra is then checked to be a
/// shelling; the hexahedra of encoding 1 are shown to be a ball by search (ball.hpp).
///
/// Errors: Malformed only if the file cannot be read; what is wrong with its bytes is a verdict.
/// Cost: O(H * degree + n^3) per entry, well below a millisecond for 50 hexahedra and n = 20.
/// Not promised: that a lower bound is true. It is a claim about all meshes, of which the table
/// holds no proof; here it is compared with H only.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hexatlas::check {

/// Entries with one number of quads.
struct TableRow {
  std::uint32_t quads = 0;
  std::uint64_t entries = 0;
  std::uint32_t least_hexahedra = 0;
  std::uint32_t greatest_hexahedra = 0;
  std::uint64_t total_hexahedra = 0;
};

struct TableVerdict {
  bool accepted = false;
  /// The first broken law; "entry 17: ..." if it concerns an entry, by ordinal.
  std::string reason;
  std::uint64_t bytes = 0;
  std::uint64_t entries = 0;
  std::uint64_t names = 0;
  std::vector<TableRow> by_quads;  ///< of the entries accepted so far
};

[[nodiscard]] TableVerdict check_table(const std::filesystem::path& path);
/// The same for bytes in memory.
[[nodiscard]] TableVerdict check_table_bytes(std::string_view bytes);

}  // namespace hexatlas::check
