#pragma once
/// \file
/// The command line in parts: each adds verbs whose callbacks set the action to run.

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>

#include "cli/commands.hpp"

namespace hexatlas::cli {

using Action = std::function<ExitCode()>;

[[nodiscard]] inline std::string example(const std::string& text) {
  return "Example:\n  " + text + "\n";
}

inline void add_threads(CLI::App& command, int& threads) {
  command
      .add_option("-j,--threads", threads,
                  "Threads [all processors]; the result does not depend on it")
      ->check(CLI::Range(1, 1024));
}

/// The option --seed. CLI11's own conversion of a word would take "010" for eight.
void add_seed(CLI::App& command, std::uint64_t& seed);

void add_mesh(CLI::App& app, Action& action);
void add_simplify(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);
/// `command_line`: what manifests say of how a table was made.
void add_table(CLI::App& app, Action& action, const std::string& command_line);
void add_enum(CLI::App& app, Action& action);
void add_realize(CLI::App& app, Action& action);
void add_reproduce(CLI::App& app, Action& action);

}  // namespace hexatlas::cli
