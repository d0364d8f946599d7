#pragma once
/// \file
/// A mesh for a boundary that is not in a table, by way of one that is.
///
/// Methods. Two meshes of the table are joined along a disc (enum/flips/cut.hpp). Collars are grown
/// inwards from the boundary until the mesh that the table has for the cavity fits
/// (enum/flips/meeting.hpp).

#include <cstdint>
#include <optional>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/scars.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::fill {

struct QueryOptions {
  int max_collar = 8;                    ///< hexahedra taken off before the table is reached
  std::size_t collars_per_level = 1000;  ///< more find more and take longer
  std::uint64_t seed = 1;
  int threads = 1;  ///< does not change the result
  /// Pairs of boundary vertices, in canonical labels, that no hexahedron may contain both of.
  flips::Scars apart{};
};

/// The least mesh among all cuts and the thinnest collars that lead to one, validated under the
/// strict rule and against its boundary; vertices 0 .. quads+1 are those of the boundary in
/// canonical labels. If pairs are to be kept apart, cuts are not tried. nullopt if none was found,
/// which proves nothing. Requires the code of a 3-connected quadrangulation with an even number of
/// at most flips::kMaxSearchQuads quads. Throws InvalidInput where a mesh of the table that would
/// be a part of it is none of its boundary. Safe to call from several threads. Cost: tens of
/// milliseconds for boundaries with two or four quads more than the table's.
[[nodiscard]] std::optional<complex::HexComplex> fill_through(const format::Table& table,
                                                              const canon::Code& boundary,
                                                              const QueryOptions& options = {});

}  // namespace hexatlas::fill
