#pragma once
/// \file
/// The census beside a table: one row per quadrangulation, as an SQLite database for other programs
/// and for questions by numbers (docs/formats/census.md). The meshes are in the table.

#include <string>
#include <vector>

#include "tables/format/table.hpp"

namespace hexatlas::build {

/// What is known of one quadrangulation.
struct CensusRow {
  std::string code;  ///< canonical, as text
  int quads = 0;
  int automorphisms = 0;  ///< order of the group, mirror images included
  int rotations = 0;      ///< those that keep the orientation
  int hexahedra = 0;      ///< of the smallest mesh found
  int interior_vertices = 0;
  int lower_bound = 1;  ///< proven; 1: nothing claimed
  std::string source;   ///< how the mesh was found: a short word
  std::string found;    ///< when: a date as text, such as 2026-11-21
  friend bool operator==(const CensusRow&, const CensusRow&) = default;
};

/// Where the rows come from.
struct CensusAbout {
  std::string table_sha256;  ///< of the table that has the meshes
  std::string program;       ///< name and version
  std::string commit;        ///< of the sources
  friend bool operator==(const CensusAbout&, const CensusAbout&) = default;
};

struct Census {
  CensusAbout about;
  std::vector<CensusRow> rows;  ///< ascending by code as text
};

/// The row of an entry. Requires that its code can be decoded. Cost: that of a canonical form.
[[nodiscard]] CensusRow census_row(const format::TableEntry& entry, std::string source,
                                   std::string found);

/// `NAME.hxt` -> `NAME.census.sqlite`.
[[nodiscard]] std::string census_path(const std::string& table_path);

/// The bytes of a file, which errors call `path`. Rows in any order; the same rows make the same
/// bytes, with the same version of SQLite.
/// Requires distinct codes and hexahedra >= lower_bound >= 1 in each row.
/// Throws ResourceFailure if memory runs out.
/// Cost: the database is built in memory, about 150 bytes per row.
[[nodiscard]] std::string census_bytes(const std::string& path, Census census);

/// Throws InvalidInput if the file is missing, no census, of another version, or damaged: the
/// structure is tested by SQLite, the content by the digest in it. The bytes are taken as they
/// stand: no lock is taken and no journal is looked at, a file in the middle of a change is
/// damaged. Not verified: that it is true of a table.
[[nodiscard]] Census read_census(const std::string& path);

}  // namespace hexatlas::build
