#pragma once
/// \file
/// The table of hexahedral meshes (docs/formats/table.md): written whole, read through a memory
/// map, without any search code.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"

namespace hexatlas::format {

inline constexpr std::uint32_t kTableVersion = 2;

/// What the index says of one mesh.
struct TableEntry {
  canon::Code code;
  std::uint16_t hexahedra = 0;
  std::uint16_t interior_vertices = 0;
  std::uint16_t lower_bound = 1;  ///< proven for this boundary; 1: nothing claimed
};

/// A name for an entry.
struct TableName {
  std::string name;
  std::size_t ordinal = 0;
};

/// An open table. Cheap to copy; copies share the map. Safe to use from several threads.
class Table {
 public:
  /// Maps the file and verifies sizes, layout and digest.
  /// Throws InvalidInput: missing, not a table, of another version, truncated, altered.
  /// Cost: one pass over the file.
  [[nodiscard]] static Table open(const std::string& path);
  /// The same for bytes in memory, which are copied; `name` stands for the file in messages.
  [[nodiscard]] static Table from_bytes(std::string bytes, const std::string& name);

  [[nodiscard]] std::size_t size() const noexcept;
  /// N, if the table claims to have an entry for every 3-connected quadrangulation with an even
  /// number of quads from 6 to N; 0 if it claims nothing. Not verified here: the judge does that.
  [[nodiscard]] int complete_through() const noexcept;
  /// Requires ordinal < size(). Entries ascend by code.
  [[nodiscard]] TableEntry entry(std::size_t ordinal) const;
  /// Binary search. Cost: O(log size).
  [[nodiscard]] std::optional<std::size_t> find(const canon::Code& code) const;
  /// The mesh of an entry: vertices 0 .. quads+1 are those of the boundary in canonical labels.
  /// Throws InvalidInput if the record does not fit its entry, which a verified file excludes.
  [[nodiscard]] complex::HexComplex mesh(std::size_t ordinal) const;

  [[nodiscard]] const std::vector<TableName>& names() const noexcept;
  [[nodiscard]] std::optional<std::size_t> find_name(std::string_view name) const;
  /// Of the whole file, in hexadecimal.
  [[nodiscard]] std::string sha256() const;
  [[nodiscard]] std::size_t bytes() const noexcept;
  [[nodiscard]] const std::string& path() const noexcept;

 private:
  struct Content;
  explicit Table(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  std::shared_ptr<const Content> content_;
};

/// A mesh to be stored: its boundary vertices come first, in canonical labels of `code`.
struct TableRow {
  canon::Code code;
  complex::HexComplex mesh;
  std::uint16_t lower_bound = 1;
};
struct TableRowName {
  std::string name;
  canon::Code code;
};

/// The bytes of a table: rows in any order, the same bytes for the same rows.
/// Requires distinct codes, valid meshes with these boundaries, names among the rows, and
/// `complete_through` 0 or even, from 6 to 64. Not verified: that this claim is true.
[[nodiscard]] std::string table_bytes(std::vector<TableRow> rows, std::vector<TableRowName> names,
                                      int complete_through = 0);

}  // namespace hexatlas::format
