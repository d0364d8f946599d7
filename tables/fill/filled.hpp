#pragma once
/// \file
/// Whether a mesh fills its boundary: the look before it enters a search, and the last one before
/// it leaves.

#include <cstddef>
#include <optional>
#include <string>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::fill {

/// Why a mesh is none of this boundary: the first law that it breaks (complex::validate), or that
/// its boundary is not the canonical list of quads of the code, with the same labels and
/// orientation. nullopt if it is one.
[[nodiscard]] std::optional<std::string> reason_against(const complex::HexComplex& mesh,
                                                        const canon::Code& code);

/// Throws InternalError if there is such a reason.
void ensure_fills(const complex::HexComplex& mesh, const canon::Code& code);

/// The mesh of an entry of a table from elsewhere. Throws InvalidInput, with `name` for the table,
/// if there is such a reason.
[[nodiscard]] complex::HexComplex mesh_in(const format::Table& table, std::size_t ordinal,
                                          const std::string& name);

}  // namespace hexatlas::fill
