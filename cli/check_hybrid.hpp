#pragma once
/// \file
/// `check --hybrid`: the judge of hybrid meshes.

#include "cli/commands.hpp"

namespace hexatlas::cli {

/// Lets check::Malformed through.
[[nodiscard]] ExitCode check_hybrid_mesh(const CheckOptions& options);

}  // namespace hexatlas::cli
