#pragma once
/// \file
/// Lower bounds for the meshes of a table: for each boundary the exhaustive search for balls with
/// fewer hexahedra (enum/hexes/search.hpp), as far as it is told to go.
///
/// A bound is proven by a search that came to its end, not by a certificate: that of one boundary
/// is what `hexatlas enum hexmeshes CODE --ball --certificate` writes.

#include <atomic>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tables/format/table.hpp"

namespace hexatlas::build {

struct BoundOptions {
  int max_hexahedra = 0;  ///< balls with at most so many are searched for
  /// Of the searches for one boundary together; what they have excluded by then stays.
  std::uint64_t max_nodes = std::numeric_limits<std::uint64_t>::max();
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< set from elsewhere to end early
};

/// What the searches say of one boundary.
struct BoundOutcome {
  enum class Change : std::uint8_t {
    none,     ///< nothing that was not known
    raised,   ///< fewer hexahedra than the bound are impossible now
    replaced  ///< there is a smaller mesh, which is the row's now; the bound is its size
  };
  Change change = Change::none;
  /// Stopped, or the nodes were spent, or a mesh may be a ball or not, or one with so many
  /// hexahedra may have more vertices than a search takes: the bound might be greater.
  bool is_cut = false;
};

/// Raises the bound of a row, one number of hexahedra after the other: each is excluded by a search
/// of its own, so a ball that is met has as few as can be. A bound that is the number of hexahedra
/// of the mesh says that none has fewer. Requires a bound that is true. One thread.
/// \throws core::InvalidInput where the boundary is not 3-connected, or the bound is seen to be
/// false.
/// Cost: some 3 times as much for each further hexahedron; 20 quads: 30 ms for 12 hexahedra.
[[nodiscard]] BoundOutcome raise_bound(format::TableRow& row, const BoundOptions& options);

/// raise_bound() for each row, on several threads; the outcomes in the order of the rows. Requires
/// different rows.
[[nodiscard]] std::vector<BoundOutcome> raise_bounds(std::span<format::TableRow* const> rows,
                                                     const BoundOptions& options);

/// \throws core::InvalidInput where a mesh of so many hexahedra refutes a bound that the source,
/// a file or so, claims for its boundary.
void expect_not_refuted(const std::string& source, const canon::Code& code, int bound,
                        std::size_t hexahedra);

/// The rows of a table, as they were written. Cost: that of unpacking and validating each mesh.
/// \throws core::InvalidInput where a mesh is none of its boundary, or refutes the bound of its
/// row.
[[nodiscard]] std::vector<format::TableRow> rows_of(const format::Table& table);

}  // namespace hexatlas::build
