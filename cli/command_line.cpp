#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/command_line_parts.hpp"
#include "cli/output.hpp"

namespace hexatlas::cli {
namespace {

/// Number of insertions, deletions, replacements and exchanges of neighbours.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

const CLI::App& deepest_parsed(const CLI::App& app) {
  for (const CLI::App* sub : app.get_subcommands()) return deepest_parsed(*sub);
  return app;
}

/// The end of a sentence on a mistyped word: the nearest verb or flag of this command, if any.
std::string suggestion(const CLI::App& command, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::App* sub : command.get_subcommands({})) known.push_back(sub->get_name());
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::string typed = word.substr(0, word.find('='));
  std::string best;
  std::size_t least = std::max<std::size_t>(2, typed.size() / 3) + 1;
  for (const std::string& name : known)
    if (const std::size_t d = distance(typed, name); d < least) {
      least = d;
      best = name;
    }
  return best.empty() ? "." : "; did you mean `" + best + "`?";
}

/// The word as a shell reads it, in quotes if it must be.
std::string for_shell(const std::string& word) {
  constexpr std::string_view kPlain = "-_./:,=+@%";
  const auto is_plain = [&](unsigned char c) {
    return (c < 128 && std::isalnum(c) != 0) ||
           kPlain.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string verbs_of(const CLI::App& command) {
  std::string list;
  for (const CLI::App* sub : command.get_subcommands({}))
    list += (list.empty() ? "" : ", ") + sub->get_name();
  return list;
}

bool lacks_verb(const CLI::App& command) {
  return command.get_require_subcommand_min() > 0 && command.get_subcommands().empty();
}

/// The first option with an empty value, as a variable that is not set makes one. To take it for
/// one that was not given would do less than was asked.
const CLI::Option* option_without_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const bool is_flag = option->get_type_size_max() == 0;
    const std::vector<std::string>& values = option->results();
    if (!is_flag && std::any_of(values.begin(), values.end(),
                                [](const std::string& value) { return value.empty(); }))
      return option;
  }
  for (const CLI::App* sub : command.get_subcommands())
    if (const CLI::Option* option = option_without_value(*sub)) return option;
  return nullptr;
}

ExitCode wrong_usage(const CLI::App& app, const std::vector<std::string>& words,
                     const CLI::ParseError& error) {
  const CLI::App& command = deepest_parsed(app);
  std::string path;
  for (const CLI::App* at = &command; at != nullptr; at = at->get_parent())
    path.insert(0, at->get_name() + (path.empty() ? "" : " "));
  const std::vector<std::string> extras = app.remaining(true);
  std::string unknown;
  for (const std::string& word : words)
    if (unknown.empty() && std::find(extras.begin(), extras.end(), word) != extras.end())
      unknown = word;
  if (!unknown.empty())
    say("`" + unknown + "` is unknown to `" + path + "`" + suggestion(command, unknown) + " See `" +
        path + " --help`.");
  else
    say((lacks_verb(command) ? "a verb is needed: " + verbs_of(command)
                             : std::string(error.what())) +
        ". See `" + path + " --help`.");
  return ExitCode::usage;
}

void add_check(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "check",
      "Judge a hexahedral mesh, a Delaunay triangulation, a catalogue of triangulations, a "
      "certificate of a lower bound or sectors; shares no code with their makers");
  auto options = std::make_shared<CheckOptions>();
  command
      ->add_option("FILE", options->mesh,
                   "Mesh (.vtu .vtk .mesh .msh, with --delaunay also .hxtet), catalogue (.hxc), "
                   "certificate (.hxb) or sectors (.hxs)")
      ->required();
  command->add_option("--boundary", options->boundary,
                      "Quad surface that the mesh must have as its boundary; with --hybrid: "
                      "tetrahedral mesh whose boundary it must have");
  command->add_option("--completeness", options->completeness,
                      "Proof that the classes of the catalogue are all (.hxl)");
  auto* hybrid = command->add_flag(
      "--hybrid", options->hybrid,
      "Mesh of tetrahedra, hexahedra, prisms and pyramids: valid cells, facet to facet; with "
      "--boundary nothing covered more often than by the tetrahedra, except between warped quads "
      "of the boundary and their triangles");
  auto* delaunay =
      command->add_flag("--delaunay", options->delaunay,
                        "The mesh must be a Delaunay triangulation of its points, by exact signs");
  delaunay->excludes(hybrid);
  auto* points =
      command
          ->add_option(
              "--points", options->points,
              "With --delaunay: file whose points the mesh must have, in the same order (.xyz, "
              ".bin of doubles, .ply, .obj, .off, or a mesh)")
          ->needs(delaunay);
  command
      ->add_flag("--weights", options->weights,
                 "The points of --points (.xyz .bin) have a fourth number, the weight: the "
                 "triangulation must be regular")
      ->needs(points);
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "A mesh of hexahedra is judged by its labels: a ball, with this boundary. How many of the\n"
      "hexahedra are valid where the points are is told beside it, and no reason to reject it;\n"
      "--hybrid judges the places as well.\n"
      "Examples:\n"
      "  hexatlas check pyramid.vtu --boundary pyramid.obj\n"
      "  hexatlas check --delaunay tetrahedra.vtu --points points.xyz\n"
      "  hexatlas check --hybrid mixed.vtu --boundary tetrahedra.vtu\n"
      "  hexatlas check hexahedron.hxc --completeness hexahedron.hxl\n");
  command->callback([options, &action] { action = [options] { return check(*options); }; });
}

void add_code(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("code", "Canonical code and symmetry of a quadrangulated sphere");
  auto options = std::make_shared<CodeOptions>();
  command
      ->add_option(
          "FILE", options->input,
          "Quad surface, at most 64 quads; or a list of quadrangulations in planar_code, with "
          "the header of this format or named *.planar_code: the code of each, in its order")
      ->required();
  command->add_flag("--json", options->json,
                    "Print one JSON object; of a list one for each, a line each");
  command->footer(
      "Examples:\n"
      "  hexatlas code pyramid.obj\n"
      "  hexatlas code quads14.planar_code\n");
  command->callback([options, &action] { action = [options] { return code(*options); }; });
}

}  // namespace

std::string at_least_one(const std::string& text) {
  std::uint64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc{} && end == last && value >= 1) return {};
  return text + " is no number from 1 to 2^64 - 1";
}

std::function<std::string(const std::string&)> number_between(double least, double greatest) {
  return [=](const std::string& text) -> std::string {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0' && value >= least && value <= greatest) return {};
    return fmt::format("{} is no number from {:g} to {:g}", text, least, greatest);
  };
}

std::function<std::string(const std::string&)> ends_in(std::vector<std::string> endings) {
  return [endings = std::move(endings)](const std::string& file) -> std::string {
    std::string lower = file;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool is_named_so =
        std::any_of(endings.begin(), endings.end(),
                    [&](const std::string& ending) { return lower.ends_with(ending); });
    if (file.empty() || file == "-" || is_named_so) return {};
    return file + " does not end in " + fmt::format("{}", fmt::join(endings, " or "));
  };
}

void expect_different_files(const NamedFile& input, const std::vector<NamedFile>& outputs) {
  if (const auto same = same_files(input, outputs)) throw CLI::ValidationError(*same);
}

CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed, const char* of_what) {
  const auto read = [&seed](const std::string& word) {
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, seed);
    if (error != std::errc{} || end != last)
      throw CLI::ValidationError("--seed", "`" + word + "` is no integer from 0 to 2^64 - 1");
  };
  return command.add_option_function<std::string>("--seed", read, of_what)
      ->type_name("UINT")
      ->default_str(std::to_string(seed));
}

namespace {

/// CLI11 takes "010" for eight and "0x10" for sixteen.
std::string in_decimal(const std::string& word) {
  const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
  const std::size_t first = word.find_first_not_of('0', sign);
  if (first == sign || word.size() == sign) return word;
  if (word.find_first_not_of("0123456789", sign) != std::string::npos)
    throw CLI::ValidationError("`" + word + "` is no number in decimal digits");
  return word.substr(0, sign) + (first == std::string::npos ? "0" : word.substr(first));
}

/// Of all options that are integers.
void read_in_decimal(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_type_name().starts_with("INT") || option->get_type_name().starts_with("UINT"))
      option->transform(in_decimal);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    read_in_decimal(*command);
}

}  // namespace

ExitCode run_command_line(int argc, char** argv) {
  CLI::App app{"hexatlas: exact combinatorial enumeration in mesh generation", "hexatlas"};
  app.set_version_flag("--version", "hexatlas " + version());
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  hexatlas mesh hex pyramid.obj -o pyramid.vtu     mesh a quadrangulated ball\n"
      "  hexatlas check pyramid.vtu --boundary pyramid.obj\n"
      "  hexatlas simplify large.vtu -o small.vtu          fewer hexahedra, the same boundary\n"
      "  hexatlas view pyramid.vtu -o pyramid.html         the mesh in 3D, in a browser\n"
      "  hexatlas table info\n"
      "  hexatlas enum triangulations hexahedron          the 174 subdivisions of the cube\n"
      "  hexatlas realize hexahedron -o hexahedron.hxc    coordinates and refutations\n"
      "Exit codes: 0 done or yes, 1 no, 2 usage, 3 invalid input, 4 undecided, 5 resources.\n");
  const std::vector<std::string> words(argv + 1, argv + argc);
  // Manifests should not depend on where the program happened to lie.
  std::string command_line = "hexatlas";
  for (const std::string& word : words) command_line += " " + for_shell(word);
  Action action;
  add_mesh(app, action);
  add_simplify(app, action);
  add_view(app, action);
  add_check(app, action);
  add_code(app, action);
  add_table(app, action, command_line);
  add_enum(app, action);
  add_realize(app, action);
  add_reproduce(app, action);
  read_in_decimal(app);
  try {
    app.parse(argc, argv);
    if (const CLI::Option* option = option_without_value(app))
      throw CLI::ValidationError(option->get_name(), "the value is empty");
  } catch (const CLI::ParseError& error) {
    // Who misspells a verb and asks for help wants that of another one.
    const bool is_lost = lacks_verb(deepest_parsed(app)) && !app.remaining(true).empty();
    if (error.get_exit_code() != 0 || is_lost) return wrong_usage(app, words, error);
    std::ostringstream help_or_version, unused;
    app.exit(error, help_or_version, unused);
    print(help_or_version.str());
    return ExitCode::yes;
  }
  return action();
}

}  // namespace hexatlas::cli
