#pragma once
/// \file
/// From arguments to verbs.

#include "cli/commands.hpp"

namespace hexatlas::cli {

/// Parses the arguments and runs the verb. Help and version are printed; wrong usage is told in
/// one line, with the nearest name where one was mistyped.
[[nodiscard]] ExitCode run_command_line(int argc, char** argv);

}  // namespace hexatlas::cli
