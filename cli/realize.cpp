#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/cell_input.hpp"
#include "cli/commands.hpp"
#include "cli/long_work.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/catalogues.hpp"
#include "tables/build/realize.hpp"
#include "tables/check/catalogue.hpp"
#include "tables/check/malformed.hpp"
#include "tables/format/frame.hpp"

namespace hexatlas::cli {
namespace {

using certificate::Condition;

struct Input {
  format::Catalogue catalogue;
  bool is_compressed = false;  ///< then the output is so, too
};

/// What a catalogue says is kept and counted, so it is judged first. Whether it was; if not, it is
/// said why.
bool is_true(const std::string& bytes, const std::string& file) {
  try {
    const check::CatalogueVerdict verdict = check::check_catalogue_bytes(bytes, file);
    if (verdict.undecided)
      say(fmt::format("{}: undecided: {}; what it says is not known to be true", file,
                      verdict.reason));
    else if (!verdict.accepted)
      throw core::InvalidInput(file, verdict.reason);
    return !verdict.undecided;
  } catch (const check::Malformed& error) {
    throw core::InvalidInput::as_told(error.what());
  }
}

/// CELL, CELL:NUMBER or a catalogue file; none if that is not known to be true.
std::optional<Input> input_from(const std::string& input) {
  const std::size_t colon = input.find(':');
  const std::string name = input.substr(0, colon);
  const auto cell = complex::cell_named(name);
  if (!cell) {
    const std::string bytes = core::read_file(input);
    if (!is_true(bytes, input)) return std::nullopt;
    return Input{format::catalogue_from(bytes, input), format::is_compressed(bytes)};
  }
  const balls::CensusOptions options;
  format::Catalogue all =
      build::catalogue_of(*cell, name, options, balls::triangulations(*cell, options));
  if (colon == std::string::npos) return Input{std::move(all)};
  std::size_t number = 0;
  const char* const last = input.data() + input.size();
  const auto [end, error] = std::from_chars(input.data() + colon + 1, last, number);
  if (error != std::errc{} || end != last || number == 0 || number > all.classes.size())
    throw core::InvalidInput(
        input, fmt::format("classes of the {} are numbered 1 to {}", name, all.classes.size()));
  return Input{build::part_of(all, number)};
}

Condition condition_of(const RealizeOptions& options) {
  if (options.jacobian) return Condition::jacobian;
  return options.convex ? Condition::convex : Condition::embedded;
}

}  // namespace

ExitCode realize(const RealizeOptions& options) {
  if (!options.output.empty()) core::expect_writable(options.output);
  auto input = input_from(options.input);
  if (!input) return ExitCode::undecided;
  auto& [catalogue, is_compressed] = *input;
  const Condition condition = condition_of(options);
  if (condition == Condition::jacobian && !build::is_hexahedron(catalogue))
    throw core::InvalidInput(options.input,
                             "--jacobian is for the hexahedron without interior vertex");
  build::RealizeOptions build_options;
  build_options.condition = condition;
  build_options.threads = parallel::threads_or_all(options.threads);
  if (options.quick) build_options.effort.coordinates.shrink_starts = 0;
  realize_classes(catalogue, build_options, "classes");
  if (!options.output.empty()) {
    const std::string bytes = format::catalogue_bytes(catalogue);
    core::write_file(options.output, is_compressed ? format::compressed(bytes) : bytes);
  }
  const build::AnswerCounts counts = build::count_answers(catalogue, condition);
  const std::size_t classes = catalogue.classes.size();
  std::string text;
  if (options.json) {
    nlohmann::ordered_json json;
    json["condition"] = certificate::name_of(condition);
    json["classes"] = classes;
    json["realizable"] = counts.realizable;
    json["refuted"] = counts.refuted;
    json["open"] = counts.open;
    text = to_line(json);
  } else {
    text = fmt::format("{}: {} {}: {} realizable, {} refuted, {} open\n", options.input,
                       counted(classes, "class", "classes"), certificate::name_of(condition),
                       counts.realizable, counts.refuted, counts.open);
  }
  tell(options.output, text);
  if (counts.open != 0) return ExitCode::undecided;
  return classes == 1 && counts.refuted == 1 ? ExitCode::no : ExitCode::yes;
}

}  // namespace hexatlas::cli
