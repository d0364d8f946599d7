#pragma once
/// \file
/// Records of the table: a mesh as the way to empty the cavity that its boundary encloses.
/// docs/formats/table.md gives both encodings byte by byte.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::format {

/// The payload of a mesh whose vertices 0 .. quads+1 are those of `boundary`. The hexahedra
/// are taken off in the order given if that is a shelling backwards, else in an order found by
/// shelling_of(); without one they are stored as cells.
/// Requires a mesh that obeys the laws and has this boundary, fewer than 65,536 vertices.
[[nodiscard]] std::string encode_record(const complex::HexComplex& mesh,
                                        const complex::Quadrangulation& boundary);

/// The mesh of a payload, hexahedra in the order of the record; nullopt if the payload does not
/// describe `hexahedra` hexahedra that empty the cavity.
/// Not promised: the strict rule, which was checked when the table was made and which the judge
/// checks. Cost: O(hexahedra * quads) with a small constant.
[[nodiscard]] std::optional<complex::HexComplex> decode_record(
    std::string_view payload, const complex::Quadrangulation& boundary, int hexahedra);

}  // namespace hexatlas::format
