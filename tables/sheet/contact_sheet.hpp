#pragma once
/// \file
/// The contact sheet of a catalogue: one page that shows every class.

#include <string>

#include "tables/format/catalogue.hpp"

namespace hexatlas::sheet {

/// A page in XHTML that is HTML as well, in UTF-8, with its drawings inside and nothing outside: a
/// tile per class, grouped by the number of tetrahedra, with totals and a histogram. A class with
/// coordinates is drawn with its tetrahedra moved apart (convex ones if it has them, as they look
/// best, else positive-Jacobian, else embedded ones); one without, as the graph of its
/// tetrahedra. The drawn points are deformed to look regular; they are not those of the catalogue.
/// Deterministic. Takes the catalogue at its word: coordinates must be as they say. About 5 KiB and
/// 50 milliseconds per class.
[[nodiscard]] std::string contact_sheet(const format::Catalogue& catalogue);

}  // namespace hexatlas::sheet
