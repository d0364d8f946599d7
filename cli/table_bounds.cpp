#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/long_work.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "cli/table_write.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/bounds.hpp"
#include "tables/fill/filled.hpp"
#include "tables/format/manifest.hpp"

namespace hexatlas::cli {
namespace {

constexpr std::size_t kMostRowsPerStep = 64;

/// What is known of the table that the bounds are for.
struct Given {
  NewTable table;
  Making making;
};

/// Of each mesh; where there is no census, what it would say is not known.
std::map<canon::Code, Found> sources_in(const format::Table& table) {
  std::map<canon::Code, Found> result = found_in_census(table);
  const Found unknown{"table", today()};
  for (std::size_t i = 0; i < table.size(); ++i) result.try_emplace(table.entry(i).code, unknown);
  return result;
}

/// Nor is the seed known where there is no manifest.
Given given(const format::Table& table, const std::string& command) {
  Given result{{build::rows_of(table), {}, table.complete_through()},
               {command, 0, sources_in(table)}};
  for (const format::TableName& name : table.names())
    result.table.names.push_back({name.name, table.entry(name.ordinal).code});
  const std::string manifest = format::manifest_path(table.path());
  if (is_there(manifest)) result.making.seed = format::read_manifest(manifest).seed;
  return result;
}

struct Tally {
  std::size_t raised = 0, replaced = 0, cut = 0;
};

/// The rows that are asked for.
std::vector<format::TableRow*> chosen_from(const format::Table& table,
                                           const TableBoundsOptions& options,
                                           std::vector<format::TableRow>& rows) {
  std::vector<bool> is_chosen(rows.size(), options.only.empty());
  for (const std::string& word : options.only) {
    auto ordinal = table.find_name(word);
    if (const auto code = canon::from_text(word); code && !ordinal) ordinal = table.find(*code);
    if (!ordinal) throw core::InvalidInput(word, "is no name or canonical code in " + table.path());
    is_chosen[*ordinal] = true;
  }
  std::vector<format::TableRow*> result;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (is_chosen[i] && rows[i].code.quads <= options.max_quads) result.push_back(&rows[i]);
  return result;
}

/// The next rows. Those replaced were found by search, now.
void take_step(std::span<format::TableRow* const> rows, const build::BoundOptions& options,
               Making& making, Tally& tally) {
  const std::vector<build::BoundOutcome> outcomes = build::raise_bounds(rows, options);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (outcomes[i].is_cut) ++tally.cut;
    if (outcomes[i].change == build::BoundOutcome::Change::raised) ++tally.raised;
    if (outcomes[i].change != build::BoundOutcome::Change::replaced) continue;
    ++tally.replaced;
    making.found[rows[i]->code] = {"search", today()};
  }
}

/// The same command was stopped before: bounds are of the boundary, whatever its mesh.
void take_over(const format::Table& earlier, Given& work) {
  const std::map<canon::Code, Found> sources = sources_in(earlier);
  std::size_t taken = 0;
  for (format::TableRow& row : work.table.rows) {
    const auto ordinal = earlier.find(row.code);
    if (!ordinal) continue;
    const format::TableEntry entry = earlier.entry(*ordinal);
    const auto hexahedra = static_cast<int>(row.mesh.hexahedra.size());
    if (entry.hexahedra >= hexahedra && entry.lower_bound <= row.lower_bound) continue;
    const std::uint16_t bound = std::max(row.lower_bound, entry.lower_bound);
    if (bound > std::min(int{entry.hexahedra}, hexahedra))
      throw core::InvalidInput(earlier.path(),
                               "has a mesh below the lower bound in TABLE, or the "
                               "other way round, of " +
                                   canon::to_text(row.code));
    ++taken;
    row.lower_bound = bound;
    if (entry.hexahedra >= hexahedra) continue;
    row.mesh = fill::mesh_in(earlier, *ordinal, earlier.path());
    work.making.found[row.code] = sources.at(row.code);
  }
  if (taken != 0)
    say(fmt::format("goes on with {} of {}", counted(taken, "boundary", "boundaries"),
                    earlier.path()));
}

/// What the earlier one alone has would be gone: it may be the work of days, too.
void expect_nothing_lost(const format::Table& earlier, const format::Table& given) {
  std::size_t lost = 0;
  for (std::size_t i = 0; i < earlier.size(); ++i)
    lost += given.find(earlier.entry(i).code) ? 0 : 1;
  if (lost != 0)
    throw core::InvalidInput(earlier.path(),
                             fmt::format("has {} that TABLE lacks; name another file with -o",
                                         counted(lost, "mesh", "meshes")));
  const auto code_in = [](const format::Table& table, std::size_t ordinal) {
    return table.entry(ordinal).code;
  };
  for (const format::TableName& name : earlier.names())
    if (const auto own = given.find_name(name.name);
        !own || code_in(given, *own) != code_in(earlier, name.ordinal))
      throw core::InvalidInput(earlier.path(), fmt::format("has the name {}, which TABLE lacks; "
                                                           "name another file with -o",
                                                           name.name));
}

/// What is at -o already, if that is another table than the one given; one that is damaged may be
/// the work of days, and is not replaced.
void take_over_what_is_there(const std::string& output, const format::Table& given, Given& work) {
  if (!is_there(output)) return;
  std::optional<format::Table> earlier;
  try {
    earlier = format::Table::open(output);
  } catch (const core::InvalidInput& no_table) {
    if (core::read_file(output).starts_with("hexatlas")) throw;
    say(fmt::format("note: {}; it will be replaced", no_table.what()));
    return;
  }
  if (earlier->sha256() == given.sha256()) return;
  expect_nothing_lost(*earlier, given);
  take_over(*earlier, work);
}

/// Whether all rows had their turn; otherwise a stop was asked for, and the last ones may have been
/// cut short.
bool proceed(Given& work, std::span<format::TableRow* const> rows,
             const TableBoundsOptions& options, const build::BoundOptions& searches, Tally& tally) {
  ProgressLine line;
  PeriodicSave saved(options.save_every,
                     [&] { write_table(options.output, work.table, work.making); });
  // Nothing is saved within a step: hard boundaries come a few at a time.
  const auto least = static_cast<std::size_t>(searches.threads);
  std::size_t step = least;
  for (std::size_t done = 0; done < rows.size() && !stop_requested();) {
    const double begin = seconds();
    step = std::min(step, rows.size() - done);
    take_step(rows.subspan(done, step), searches, work.making, tally);
    done += step;
    step = seconds() - begin < 1 ? std::min(2 * step, kMostRowsPerStep) : least;
    line.update("boundaries", done, rows.size());
    if (done != rows.size()) saved.if_due();
  }
  return !stop_requested();
}

std::map<int, std::size_t> by_bound(const format::Table& table) {
  std::map<int, std::size_t> result;
  for (std::size_t i = 0; i < table.size(); ++i) ++result[table.entry(i).lower_bound];
  return result;
}

std::size_t proven_smallest(const format::Table& table) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < table.size(); ++i)
    count += static_cast<std::size_t>(table.entry(i).lower_bound == table.entry(i).hexahedra);
  return count;
}

std::string json_line(const format::Table& table, const Tally& tally, bool is_finished) {
  nlohmann::ordered_json json;
  json["file"] = table.path();
  json["sha256"] = table.sha256();
  json["entries"] = table.size();
  json["raised"] = tally.raised;
  json["replaced"] = tally.replaced;
  json["proven_smallest"] = proven_smallest(table);
  json["by_bound"] = nlohmann::ordered_json::object();
  for (const auto& [bound, count] : by_bound(table))
    json["by_bound"][std::to_string(bound)] = count;
  json["finished"] = is_finished;
  return to_line(json);
}

std::string text_of(const format::Table& table, const Tally& tally) {
  std::string text = fmt::format(
      "{}: {}, sha256 {}\n{} raised; {} by a smaller mesh; {} as small as their bounds\nlower "
      "bound: "
      "boundaries\n ",
      table.path(), counted(table.size(), "mesh", "meshes"), table.sha256(),
      counted(tally.raised, "lower bound", "lower bounds"),
      counted(tally.replaced, "mesh replaced", "meshes replaced"), proven_smallest(table));
  for (const auto& [bound, count] : by_bound(table)) text += fmt::format(" {}:{}", bound, count);
  return text + "\n";
}

}  // namespace

ExitCode table_bounds(const TableBoundsOptions& options) {
  expect_table_writable(options.output);
  const format::Table before = open_table(options.table);
  Given work = given(before, options.command);
  take_over_what_is_there(options.output, before, work);
  const auto chosen = chosen_from(before, options, work.table.rows);
  Tally tally;
  const bool had_all_turns = proceed(work, chosen, options,
                                     {.max_hexahedra = options.max_hexahedra,
                                      .max_nodes = options.max_nodes,
                                      .threads = parallel::threads_or_all(options.threads),
                                      .stop = &stop_requested()},
                                     tally);
  const format::Table table = write_table(options.output, work.table, work.making);
  const bool is_finished = had_all_turns && tally.cut == 0;
  print(options.json ? json_line(table, tally, is_finished) : text_of(table, tally));
  if (is_finished) return ExitCode::yes;
  if (had_all_turns)
    say(fmt::format(
        "for {} the search did not end: --max-nodes, too many vertices for a search, or "
        "a mesh that may be no ball; their bounds may be too small",
        counted(tally.cut, "boundary", "boundaries")));
  else
    say("stopped; the same command goes on with " + options.output);
  return ExitCode::undecided;
}

}  // namespace hexatlas::cli
