#pragma once
/// \file
/// A bar chart of scaled Jacobians, as a part of a page.

#include <cstddef>
#include <string>

#include "meshing/quality/report.hpp"

namespace hexatlas::cli {

/// "below 0.1", "0.1 to 0.2", ..., "0.9 to 1".
[[nodiscard]] std::string histogram_bin(std::size_t bin);

/// An element `svg` with axes, labels, a title and a description. `id` opens the names of its
/// parts, which are unique on a page. Its colours are those that the page gives to the classes bar,
/// inverted, grid, axis, count and label. Inverted hexahedra are told apart in the first bar: but
/// for rounding, none of them has a scaled Jacobian above 0.
[[nodiscard]] std::string histogram_chart(const quality::Report& report, const std::string& id);

}  // namespace hexatlas::cli
