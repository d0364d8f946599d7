#pragma once
/// \file
/// The last look at a mesh before it leaves a search.

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"

namespace hexatlas::build {

/// Throws InternalError unless the mesh obeys the laws (complex::validate) and its boundary is the
/// canonical list of quads of the code, with the same labels and orientation.
void ensure_fills(const complex::HexComplex& mesh, const canon::Code& code);

}  // namespace hexatlas::build
