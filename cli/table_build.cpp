#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/long_work.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "cli/table_write.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/flips/symmetric_beam.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/bounds.hpp"
#include "tables/build/census.hpp"
#include "tables/build/named.hpp"
#include "tables/build/search.hpp"
#include "tables/fill/filled.hpp"

namespace hexatlas::cli {
namespace {

canon::Code code_of(const std::string& name_or_code) {
  if (const auto* named = build::named_boundary(name_or_code))
    return canon::from_text(named->code).value();
  const auto code = canon::from_text(name_or_code);
  const auto boundary = code ? canon::decode(*code) : std::nullopt;
  if (!boundary || canon::canonical_form(*boundary).code != *code)
    throw core::InvalidInput(name_or_code, "is neither a known name nor a canonical code");
  if (code->quads % 2 != 0 || !boundary->is_three_connected() ||
      code->quads > flips::kMaxSearchQuads)
    throw core::InvalidInput(name_or_code,
                             "no search here: a boundary needs an even number of at most " +
                                 std::to_string(flips::kMaxSearchQuads) +
                                 " quads and a 3-connected graph");
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

build::SearchOptions search_options(const TableBuildOptions& options) {
  constexpr std::size_t kBytesPerFront = 140;  // itself, its share of the tables, and slack
  constexpr std::size_t kBytesPerSymmetricFront = 400;
  build::SearchOptions search = options.search;
  search.balls.threads = parallel::threads_or_all(options.threads);
  const std::size_t bytes = static_cast<std::size_t>(options.memory_gib) << 30U;
  search.balls.max_fronts = bytes / kBytesPerFront;
  search.collars.max_fronts =
      bytes / (flips::are_wide(search.collars) ? kBytesPerSymmetricFront : kBytesPerFront);
  search.symmetric.max_fronts = search.symmetric_balls.max_fronts = bytes / kBytesPerSymmetricFront;
  return search;
}

build::TableSearch::Origins origins_of(const format::Table& table) {
  build::TableSearch::Origins origins;
  for (const auto& [code, found] : found_in_census(table))
    origins[code] = build::origin_named(found.source);
  return origins;
}

/// A table, or the bytes of a saved search.
using TableOrSearch = std::variant<format::Table, std::string>;

TableOrSearch read_start(const std::string& file) {
  std::string bytes = core::read_state(file);
  if (build::TableSearch::is_saved(bytes)) return bytes;
  return format::Table::from_bytes(std::move(bytes), file);
}

/// A table that is begun with and replaced keeps each boundary.
void expect_nothing_lost(const TableBuildOptions& options,
                         const std::vector<canon::Code>& targets) {
  for (const std::string& file : options.start_from) {
    if (!is_there(file) || !same_files({"", file}, {{"", options.output}})) continue;
    const TableOrSearch start = read_start(file);
    const auto* table = std::get_if<format::Table>(&start);
    if (table == nullptr) continue;
    std::size_t lost = 0;
    for (std::size_t i = 0; i < table->size(); ++i)
      lost += std::binary_search(targets.begin(), targets.end(), table->entry(i).code) ? 0 : 1;
    if (lost != 0)
      throw core::InvalidInput(
          file, fmt::format("has {} of other boundaries than this search is for, which would be "
                            "lost; name another file with -o, or more with --max-quads and --also",
                            counted(lost, "mesh", "meshes")));
  }
}

/// A new search that begins with what the files have: at most one saved search, and tables.
build::TableSearch begin_with(const std::vector<std::string>& files,
                              std::vector<canon::Code> targets,
                              const build::SearchOptions& options) {
  std::optional<build::TableSearch> search;
  std::vector<format::Table> tables;
  for (const std::string& file : files) {
    TableOrSearch start = read_start(file);
    if (auto* table = std::get_if<format::Table>(&start)) {
      tables.push_back(std::move(*table));
      continue;
    }
    if (search) throw core::InvalidInput(file, "a second saved search; one can be begun with");
    search = build::TableSearch::started_from(std::get<std::string>(start), targets, options, file);
  }
  if (!search) search.emplace(std::move(targets), options);
  for (const format::Table& table : tables)
    say(fmt::format(
        "{}: {} taken over", table.path(),
        counted(search->take_over(table, table.path(), origins_of(table)), "mesh", "meshes")));
  // A search only makes them smaller.
  for (const build::TableSearch::Row& row : search->rows())
    for (const format::Table& table : tables)
      if (const auto ordinal = table.find(row.code))
        build::expect_not_refuted(table.path(), row.code, table.entry(*ordinal).lower_bound,
                                  static_cast<std::size_t>(row.hexahedra));
  return *std::move(search);
}

build::TableSearch begin(const TableBuildOptions& options) {
  std::vector<canon::Code> targets = boundaries(options);
  expect_nothing_lost(options, targets);
  const build::SearchOptions search = search_options(options);
  if (!options.state.empty() && is_there(options.state)) {
    if (!options.start_from.empty())
      say(
          fmt::format("note: {} goes on with what it has; only a new search begins with what "
                      "--start-from names",
                      options.state));
    if (!options.so_far) heed_stops();
    return build::TableSearch::from_bytes(core::read_state(options.state), std::move(targets),
                                          search, options.state);
  }
  if (options.so_far)
    throw core::InvalidInput(options.state, "is not there: there is no search so far");
  return begin_with(options.start_from, std::move(targets), search);
}

/// Whether the search came to its end; otherwise a stop was asked for.
bool proceed(build::TableSearch& search, const std::string& state, double save_every) {
  ProgressLine line;
  const auto save = [&] {
    if (!state.empty()) core::write_file(state, search.to_bytes());
  };
  PeriodicSave saved(save_every, save);
  while (!search.is_finished() && !stop_requested()) {
    const auto progress = search.progress();
    line.update(progress.phase, progress.done, progress.total);
    search.step();
    saved.if_due();
  }
  if (search.is_finished())
    saved.try_now();
  else
    save();
  return search.is_finished();
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

/// The claim of completeness that the meshes found bear out.
int complete_through(int max_quads, const std::vector<canon::Code>& without_mesh) {
  int complete = max_quads - max_quads % 2;
  for (const canon::Code& code : without_mesh)
    complete = std::min(complete, static_cast<int>(code.quads) - 2);
  return complete < 6 ? 0 : complete;
}

std::map<canon::Code, Found> found_of(const build::TableSearch& search, const std::string& date) {
  std::map<canon::Code, Found> result;
  for (const auto& row : search.rows())
    result[row.code] = {std::string(build::name_of(row.origin)), date};
  return result;
}

/// Of equally small meshes the one of a table stays, with how and when it was found, and of two
/// tables that of the first, so that what is no improvement changes nothing. What the tables claim
/// of bounds stays true.
class KnownRows {
 public:
  KnownRows(std::vector<format::TableRow>& rows, int threads)
      : rows_(rows), is_kept_(rows.size()), threads_(threads) {}

  void keep(const format::Table& table, std::map<canon::Code, Found>& found) {
    const std::map<canon::Code, Found> known = found_in_census(table);
    std::vector<std::pair<std::size_t, std::size_t>> equal;  // of the rows, of the table
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      format::TableRow& row = rows_[i];
      const auto ordinal = table.find(row.code);
      if (!ordinal) continue;
      const auto& entry = table.entry(*ordinal);
      row.lower_bound = std::max(row.lower_bound, entry.lower_bound);
      build::expect_not_refuted(table.path(), row.code, row.lower_bound, row.mesh.hexahedra.size());
      if (is_kept_[i] || entry.hexahedra != row.mesh.hexahedra.size()) continue;
      is_kept_[i] = true;
      equal.emplace_back(i, *ordinal);
      if (const auto at = known.find(row.code); at != known.end()) found[row.code] = at->second;
    }
    parallel::parallel_for(threads_, equal.size(), [&](std::size_t k) {
      const auto [row, ordinal] = equal[k];
      rows_[row].mesh = fill::mesh_in(table, ordinal, table.path());
    });
  }

 private:
  std::vector<format::TableRow>& rows_;
  std::vector<bool> is_kept_;
  int threads_;
};

void keep_known(const std::vector<std::string>& files, int threads,
                std::vector<format::TableRow>& rows, std::map<canon::Code, Found>& found) {
  KnownRows known(rows, threads);
  for (const std::string& file : files) {
    if (!is_there(file)) continue;  // the search was saved since
    const TableOrSearch start = read_start(file);
    if (const auto* table = std::get_if<format::Table>(&start)) known.keep(*table, found);
  }
}

}  // namespace

ExitCode table_build(const TableBuildOptions& options) {
  expect_table_writable(options.output);
  const std::string date = today();
  if (!options.state.empty()) core::expect_writable(options.state);
  build::TableSearch search = begin(options);
  if (!options.so_far && !proceed(search, options.state, options.save_every)) {
    say(options.state.empty()
            ? "stopped; no table was written (--state FILE would have saved the search)"
            : "stopped; the same command goes on from " + options.state);
    return ExitCode::undecided;
  }
  const std::vector<canon::Code> without_mesh = search.without_mesh();
  constexpr std::size_t kMissingShown = 10;
  for (std::size_t i = 0; i < std::min(kMissingShown, without_mesh.size()); ++i)
    say("no mesh found for " + canon::to_text(without_mesh[i]) + "; it is not in the table");
  if (without_mesh.size() > kMissingShown)
    say(fmt::format("no mesh found for {} boundaries in all", without_mesh.size()));
  NewTable made{build::table_rows(search), {}, complete_through(options.max_quads, without_mesh)};
  std::map<canon::Code, Found> found = found_of(search, date);
  keep_known(options.start_from, search.balls().options().threads, made.rows, found);
  made.names = names_among(made.rows);
  const format::Table table = write_table(
      options.output, made, {options.command, options.search.balls.seed, std::move(found)});
  print(fmt::format("{}: {}, {} bytes, sha256 {}\n", options.output,
                    counted(table.size(), "mesh", "meshes"), table.bytes(), table.sha256()));
  return without_mesh.empty() ? ExitCode::yes : ExitCode::undecided;
}

}  // namespace hexatlas::cli
