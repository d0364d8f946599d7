#pragma once
/// \file
/// The certificate that a list of the triangulations of the hexahedron is complete. The formula is
/// that of the judge, so that the judge's reading of the definition is the only one; a solver
/// refutes it.

#include <functional>
#include <optional>
#include <string>

#include "tables/format/catalogue.hpp"

namespace hexatlas::cli {

/// Told in words what is being done.
using StepReport = std::function<void(const std::string& step)>;

/// The text of docs/formats/completeness.md, or nullopt if the list is not complete.
/// Requires a catalogue of the hexahedron without interior vertex and boundary tetrahedra.
[[nodiscard]] std::optional<std::string> completeness_certificate(
    const format::Catalogue& catalogue, const StepReport& report);

}  // namespace hexatlas::cli
