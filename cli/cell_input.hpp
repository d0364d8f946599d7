#pragma once
/// \file
/// A cell named on the command line, or read from a surface file.

#include <string>

#include "enum/complex/cell.hpp"

namespace hexatlas::cli {

struct NamedCell {
  std::string name;  ///< fit for the header of a catalogue
  complex::Cell cell;
};

/// A name of complex::cell_names(), or a file of triangles and quads, whose points are numbered by
/// the order of those that facets use. Throws InvalidInput: no such file, no sphere, too many
/// vertices.
[[nodiscard]] NamedCell cell_from(const std::string& name_or_file);

}  // namespace hexatlas::cli
