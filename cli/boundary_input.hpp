#pragma once
/// \file
/// A boundary named on the command line, or read from a surface file.

#include <string>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::cli {

struct NamedBoundary {
  std::string code;                     ///< canonical
  complex::Quadrangulation boundary{};  ///< in canonical labels
};

/// A name of build::kNamedBoundaries, a canonical code, or a surface file of quads. Throws
/// InvalidInput: none of these, not canonical, more than 64 quads, not 3-connected or odd, so that
/// there is no mesh.
[[nodiscard]] NamedBoundary boundary_from(const std::string& name_code_or_file);

/// Throws InvalidInput unless `word` is the canonical code of the boundary that it stands for.
void expect_canonical(const std::string& word, const complex::Quadrangulation& boundary);

}  // namespace hexatlas::cli
