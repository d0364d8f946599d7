#pragma once
/// \file
/// Catalogues of triangulations from the engines of enum/balls, to be written by tables/format.

#include <string>
#include <vector>

#include "enum/balls/spheres.hpp"
#include "enum/balls/triangulations.hpp"
#include "enum/complex/cell.hpp"
#include "tables/format/catalogue.hpp"

namespace hexatlas::build {

/// The classes of a census, each in the order of a shelling where one is found; no condition has
/// been asked. Requires a census with its classes of this cell with these options.
[[nodiscard]] format::Catalogue catalogue_of(const complex::Cell& cell, const std::string& name,
                                             const balls::CensusOptions& options,
                                             const balls::Census& census);

/// Balls up to isomorphism. `exhaustive` stays false: the spheres they come from are `found`.
[[nodiscard]] format::Catalogue catalogue_of(const std::vector<balls::Ball>& list, int vertices);

/// Without the answers, and only the class with this number, from 1, if it is not 0; a part is not
/// exhaustive. Requires a number up to that of the classes.
[[nodiscard]] format::Catalogue part_of(const format::Catalogue& catalogue, std::size_t number);

}  // namespace hexatlas::build
