#pragma once
/// \file
/// The command line in parts: each adds verbs whose callbacks set the action to run.

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"

namespace hexatlas::cli {

using Action = std::function<ExitCode()>;

[[nodiscard]] inline std::string example(const std::string& text) {
  return "Example:\n  " + text + "\n";
}

/// A number of things of which there is no most: digits that make 1 to 2^64 - 1. CLI11 takes -1 for
/// the greatest.
[[nodiscard]] std::string at_least_one(const std::string& text);

/// A number from `least` to `greatest`; CLI::Range takes what is no number, "nan", for one.
[[nodiscard]] std::function<std::string(const std::string&)> number_between(double least,
                                                                            double greatest);

/// For an option that names a file to write: what of the endings it may have, or - for standard
/// output.
[[nodiscard]] std::function<std::string(const std::string&)> ends_in(
    std::vector<std::string> endings);

/// Wrong usage: an output in the place of the input, or of another output, would be lost.
void expect_different_files(const NamedFile& input, const std::vector<NamedFile>& outputs);

inline void add_threads(CLI::App& command, int& threads) {
  command
      .add_option("-j,--threads", threads,
                  "Threads [all processors]; the result does not depend on it")
      ->check(CLI::Range(1, 1024));
}

/// The option --shard, checked to be as for shard_from().
inline CLI::Option* add_shard(CLI::App& command, std::string& shard, const char* help) {
  return command.add_option("--shard", shard, help)->check([](const std::string& text) {
    return shard_from(text) ? std::string() : "must be R/M with 0 <= R < M <= 1000000";
  });
}

/// The option --seed.
CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed,
                      const char* of_what = "Seed of the search");

void add_mesh(CLI::App& app, Action& action);
void add_simplify(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);
/// `command_line`: what manifests say of how a table was made.
void add_table(CLI::App& app, Action& action, const std::string& command_line);
void add_enum(CLI::App& app, Action& action);
void add_realize(CLI::App& app, Action& action);
void add_reproduce(CLI::App& app, Action& action);

}  // namespace hexatlas::cli
