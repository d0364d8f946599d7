#pragma once
/// \file
/// The manifest beside a table: what it holds, how it was made, and its digest, as JSON.

#include <cstdint>
#include <string>
#include <vector>

#include "tables/format/table.hpp"

namespace hexatlas::format {

/// What is not read off the table itself.
struct Provenance {
  std::string command;  ///< that made the table
  std::uint64_t seed = 0;
  std::string program;  ///< name and version
  std::string commit;   ///< of the sources, "unknown" outside a checkout
};

/// Meshes of one number of quads.
struct Tally {
  int quads = 0;
  std::size_t entries = 0;
  std::size_t least = 0, greatest = 0, total = 0;  ///< hexahedra
};
[[nodiscard]] std::vector<Tally> tally_of(const Table& table);

/// `NAME.hxt` -> `NAME.manifest.json`.
[[nodiscard]] std::string manifest_path(const std::string& table_path);

/// The keys of docs/formats/table.md, in their order.
[[nodiscard]] std::string manifest_text(const Table& table, const Provenance& provenance);

/// What a manifest claims. A table is as its manifest says if manifest_text() of the table and the
/// claimed provenance is the manifest, byte for byte; the provenance itself is only claimed.
/// Throws InvalidInput if it is not a manifest.
struct ManifestClaims {
  std::string sha256;
  std::uint64_t bytes = 0;
  std::uint64_t entries = 0;
  std::string command;
  std::uint64_t seed = 0;
  std::string program, commit;
};
[[nodiscard]] ManifestClaims read_manifest(const std::string& path);

}  // namespace hexatlas::format
