#pragma once
/// \file
/// The judge of tables of hexahedral meshes (docs/formats/table.md). It checks every law stated
/// there, with its own digest, its own canonical code, and the laws of meshes of verdict.hpp.
///
/// The flips of encoding 0 are replayed, and the order of the hexahedra is then checked to be a
/// shelling; the hexahedra of encoding 1 are shown to be a ball by search (ball.hpp).
///
/// Errors: Malformed only if the file cannot be read; what is wrong with its bytes is a verdict.
/// Completeness is judged without a list of what there is: the sum of 8n / |Aut| over the entries
/// with n quads is compared with the number of rooted objects (rooted_count.hpp), for n up to 32.
///
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
  std::uint64_t rooted_sum = 0;  ///< of 8 * quads / |Aut| over the entries
  std::uint64_t rooted_all = 0;  ///< of all 3-connected ones; 0 above 32 quads: not counted
  /// Whether the entries are all 3-connected quadrangulations with this number of quads: proven by
  /// equal sums, as they are distinct.
  [[nodiscard]] bool is_complete() const { return rooted_all > 0 && rooted_sum == rooted_all; }
};

struct TableVerdict {
  bool accepted = false;
  /// The first broken law; "entry 17: ..." if it concerns an entry, by ordinal.
  std::string reason;
  std::uint64_t bytes = 0;
  std::uint64_t entries = 0;
  std::uint64_t judged_meshes = 0;  ///< so far: of the share
  std::uint64_t names = 0;
  std::uint32_t claimed_through = 0;   ///< what the table claims of itself; 0: nothing
  std::uint32_t complete_through = 0;  ///< proven for all even numbers of quads from 6 to this
  std::uint64_t claimed_bounds = 0;    ///< entries that claim more than one hexahedron to be needed
  std::vector<TableRow> by_quads;      ///< of the entries accepted so far
};

/// The meshes in the blocks with a number that is `part` modulo `parts`. Requires part < parts.
struct TableShare {
  std::uint64_t part = 0;
  std::uint64_t parts = 1;
};

[[nodiscard]] TableVerdict check_table(const std::filesystem::path& path);
/// The same for bytes in memory. Of a share of the meshes, so that several machines judge a table
/// together: all else is judged with each share. A table is valid if and only if all shares of it
/// are accepted.
[[nodiscard]] TableVerdict check_table_bytes(std::string_view bytes, TableShare share = {});

}  // namespace hexatlas::check
