#pragma once
/// \file
/// Work that may take long, with a line of progress while it lasts.

#include <optional>
#include <string>

#include "enum/balls/spheres.hpp"
#include "tables/build/realize.hpp"
#include "tables/format/catalogue.hpp"

namespace hexatlas::cli {

/// balls::spheres(). It cannot be stopped early.
[[nodiscard]] balls::Spheres spheres_with(int vertices, int threads);

/// build::realize(), stopped by stop_requested(); `stop` and `progress` of the options are set
/// here. The line begins with `words`.
void realize_classes(format::Catalogue& catalogue, build::RealizeOptions options,
                     const std::string& words);

/// completeness_certificate(). It cannot be stopped early.
[[nodiscard]] std::optional<std::string> prove_completeness(const format::Catalogue& catalogue);

}  // namespace hexatlas::cli
