#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/generate.hpp"
#include "tables/build/named.hpp"
#include "tables/format/manifest.hpp"

namespace hexatlas::cli {
namespace {

canon::Code code_of(const std::string& name_or_code) {
  for (const auto& named : build::kNamedBoundaries)
    if (named.name == name_or_code) return canon::from_text(named.code).value();
  const auto code = canon::from_text(name_or_code);
  const auto boundary = code ? canon::decode(*code) : std::nullopt;
  if (!boundary || canon::canonical_form(*boundary).code != *code)
    throw core::InvalidInput(name_or_code, "is neither a known name nor a canonical code");
  if (code->quads % 2 != 0 || !boundary->is_three_connected() ||
      code->quads > flips::kMaxSearchQuads)
    throw core::InvalidInput(name_or_code,
                             "no search here: a boundary needs an even number of at most 24 "
                             "quads and a 3-connected graph");
  return *code;
}

std::vector<canon::Code> boundaries(const TableBuildOptions& options) {
  std::vector<canon::Code> codes;
  for (const std::string& also : options.also) codes.push_back(code_of(also));
  const std::vector<canon::Code> all = build::three_connected_codes(options.max_quads);
  codes.insert(codes.end(), all.begin(), all.end());
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

/// A search may take hours: what would make it be in vain is told before.
void expect_writable(const std::string& output) {
  std::filesystem::path path(output);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::status_known(status))
    throw core::InvalidInput(output, "cannot be created: " + error.message());
  if (std::filesystem::is_directory(status)) throw core::InvalidInput(output, "is a directory");
  if (std::filesystem::exists(status)) {
    if (::access(path.c_str(), W_OK) != 0)
      throw core::InvalidInput(output, "cannot be replaced: it is not writable");
    if (!std::filesystem::is_regular_file(status)) return;  // a device is written in place
    path = std::filesystem::canonical(path);
  }
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, error))
    throw core::InvalidInput(output, "cannot be created: there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw core::InvalidInput(output, "cannot be created: the folder is not writable");
}

std::vector<format::TableRowName> names_among(const std::vector<format::TableRow>& rows) {
  std::vector<format::TableRowName> result;
  for (const auto& named : build::kNamedBoundaries) {
    const canon::Code code = canon::from_text(named.code).value();
    if (std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.code == code; }))
      result.push_back({std::string(named.name), code});
  }
  return result;
}

/// The table took the time: it stays where only its manifest cannot be written.
void write_both(const std::string& table_path, const std::string& table,
                const std::string& manifest_path, const std::string& manifest) {
  core::write_file(table_path, table);
  try {
    core::write_file(manifest_path, manifest);
  } catch (const std::exception&) {
    say("the table " + table_path + " was written, its manifest was not");
    throw;
  }
}

}  // namespace

ExitCode table_build(const TableBuildOptions& options) {
  const std::string manifest_path = format::manifest_path(options.output);
  expect_writable(options.output);
  expect_writable(manifest_path);
  const std::vector<canon::Code> codes = boundaries(options);
  const int threads = options.threads > 0 ? options.threads : parallel::available_threads();
  std::vector<build::Stage> stages = build::default_stages(options.seed, threads);
  for (build::Stage& stage : stages) {
    stage.max_ball = std::min(stage.max_ball, options.max_ball);
    stage.max_collar = std::min(stage.max_collar, options.max_collar);
  }
  build::Generated made;
  {
    ProgressLine progress;
    made = build::generate(codes, stages, [&](const build::Progress& p) {
      progress.update(p.phase, p.done, p.total);
    });
  }
  for (const canon::Code& code : made.without_mesh)
    say("no mesh found for " + canon::to_text(code) + "; it is not in the table");
  const std::vector<format::TableRowName> names = names_among(made.rows);
  const std::string bytes = format::table_bytes(std::move(made.rows), names);
  const format::Table table = format::Table::from_bytes(bytes, options.output);
  const std::string manifest = format::manifest_text(
      table, {options.command, options.seed, "hexatlas " + version(), HEXATLAS_COMMIT});
  write_both(options.output, bytes, manifest_path, manifest);
  print(fmt::format("{}: {} meshes, {} bytes, sha256 {}\n", options.output, table.size(),
                    table.bytes(), table.sha256()));
  return made.without_mesh.empty() ? ExitCode::yes : ExitCode::undecided;
}

}  // namespace hexatlas::cli
