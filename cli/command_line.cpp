#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

#include "cli/command_line_parts.hpp"
#include "cli/output.hpp"
#include "enum/flips/scars.hpp"

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

std::string verbs_of(const CLI::App& command) {
  std::string list;
  for (const CLI::App* sub : command.get_subcommands({}))
    list += (list.empty() ? "" : ", ") + sub->get_name();
  return list;
}

bool lacks_verb(const CLI::App& command) {
  return command.get_require_subcommand_min() > 0 && command.get_subcommands().empty();
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
      "Mesh of tetrahedra, hexahedra, prisms and pyramids: valid cells, facet to facet, none "
      "over another");
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
  command->add_option("SURFACE", options->surface, "Quad surface, at most 64 quads")->required();
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(example("hexatlas code pyramid.obj"));
  command->callback([options, &action] { action = [options] { return code(*options); }; });
}

void add_table_readers(CLI::App& table, Action& action) {
  auto* info = table.add_subcommand("info", "What a table holds");
  auto info_options = std::make_shared<TableInfoOptions>();
  info->add_option("TABLE", info_options->table, "Table [the one beside the program]");
  auto* by = info->add_option_function<std::string>(
      "--by", [info_options](const std::string&) { info_options->by_quads = true; },
      "quads: how many hexahedra the meshes have, from the census beside the table if there is "
      "one");
  by->check(CLI::IsMember({"quads"}))->type_name("WORD");
  info->add_option("--svg", info_options->svg, "With --by quads: write a bar chart to this file")
      ->needs(by);
  info->add_flag("--json", info_options->json, "Print one JSON object");
  info->footer(example("hexatlas table info --by quads"));
  info->callback(
      [info_options, &action] { action = [info_options] { return table_info(*info_options); }; });

  auto* get = table.add_subcommand("get", "One mesh of a table, as JSON");
  auto get_options = std::make_shared<TableGetOptions>();
  auto* name = get->add_option("--name", get_options->name, "Name of a boundary");
  auto* code = get->add_option("--code", get_options->code, "Canonical code of a boundary");
  name->excludes(code);
  get->add_option("--table", get_options->table, "Table [the one beside the program]");
  get->add_option("-o,--output", get_options->output, "File to write [standard output]");
  get->add_flag(
      "--search", get_options->search,
      "If the boundary is not in the table, search for a way from it to one that is; at most "
      "26 quads");
  get->footer(example("hexatlas table get --name schneiders-pyramid"));
  get->callback([get_options, &action] {
    if (get_options->name.empty() == get_options->code.empty())
      throw CLI::RequiredError("--name or --code");
    action = [get_options] { return table_get(*get_options); };
  });

  auto* check = table.add_subcommand("check", "Judge every mesh of a table anew");
  auto check_options = std::make_shared<TableCheckOptions>();
  check->add_option("TABLE", check_options->table, "Table [the one beside the program]");
  check
      ->add_option("--complete-through", check_options->complete_through,
                   "Refuse it unless it has every 3-connected quadrangulation with an even number "
                   "of quads from 6 to N")
      ->type_name("N")
      ->check(CLI::Range(6, 32));
  check->add_flag("--json", check_options->json, "Print one JSON object");
  check->footer(example("hexatlas table check --complete-through 14"));
  check->callback([check_options, &action] {
    action = [check_options] { return table_check(*check_options); };
  });
}

void add_table_bounds(CLI::App& table, Action& action, const std::string& command_line) {
  auto* bounds = table.add_subcommand(
      "bounds", "Raise the lower bounds of a table by exhaustive search for smaller meshes");
  auto options = std::make_shared<TableBoundsOptions>();
  options->command = command_line;
  bounds->add_option("TABLE", options->table, "Table [the one beside the program]");
  bounds
      ->add_option("-o,--output", options->output,
                   "Table to write (.hxt), with manifest and census; it may be TABLE")
      ->required();
  bounds
      ->add_option("--max-hexes", options->max_hexahedra,
                   "Search for balls with at most this many hexahedra; each one more takes some "
                   "three times as long")
      ->required()
      ->check(CLI::Range(1, 64));
  bounds
      ->add_option("--max-quads", options->max_quads,
                   "Boundaries with more quads are left as they are")
      ->check(CLI::Range(6, 64))
      ->capture_default_str();
  bounds->add_option("--only", options->only,
                     "Boundaries, by name or canonical code; all others are left as they are");
  bounds->add_option("--max-nodes", options->max_nodes, "Of the searches for one boundary")
      ->check(CLI::PositiveNumber);
  bounds->add_option("--save-every", options->save_every, "Seconds between two saves, at least")
      ->check(CLI::Range(0, 86'400))
      ->capture_default_str();
  bounds->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*bounds, options->threads);
  bounds->footer(example("hexatlas table bounds my.hxt -o my.hxt --max-hexes 10"));
  bounds->callback([options, &action] {
    if (options->output.empty() || options->output == "-")
      throw CLI::ValidationError("--output", "a table and its manifest need the name of a file");
    action = [options] { return table_bounds(*options); };
  });
}

void add_table(CLI::App& app, Action& action, const std::string& command_line) {
  auto* table = app.add_subcommand("table", "Make, read and judge tables of meshes");
  table->require_subcommand(1);
  auto* build = table->add_subcommand("build", "Search for meshes and write them as a table");
  auto options = std::make_shared<TableBuildOptions>();
  options->command = command_line;
  build->add_option("-o,--output", options->output, "Table to write (.hxt), with a manifest")
      ->required();
  build
      ->add_option("--max-quads", options->max_quads,
                   "All 3-connected even quadrangulations with at most this many quads")
      ->check(CLI::Range(6, 24))
      ->capture_default_str();
  build->add_option("--also", options->also, "Further boundaries, by name or canonical code");
  build->add_option(
      "--state", options->state,
      "Save the search in this file as it goes and when it is stopped, and go on from "
      "there if the file exists");
  build
      ->add_flag("--so-far", options->so_far,
                 "Do not search on: write what the search saved in --state has found so far")
      ->needs("--state");
  build->add_option(
      "--start-from", options->start_from,
      "Begin a new search with what others found: the file of one saved with --state, which may "
      "have been for other boundaries, and any number of tables (.hxt)");
  build->add_option("--save-every", options->save_every, "Seconds between two saves, at least")
      ->check(CLI::Range(0, 86'400))
      ->capture_default_str();
  const auto effort = [build](const char* name, auto& value, auto least, auto most,
                              const char* help) {
    build->add_option(name, value, help)
        ->check(CLI::Range(least, most))
        ->capture_default_str()
        ->group("Effort");
  };
  build::SearchOptions& search = options->search;
  effort("--width", search.balls.fronts_per_level, std::size_t{1}, std::size_t{100'000'000},
         "Balls expanded per number of hexahedra");
  effort("--per-class", search.balls.fronts_per_class, std::size_t{1}, std::size_t{1'000'000},
         "Balls kept per boundary and number of hexahedra");
  effort("--widest", search.balls.max_quads, 6, flips::kMaxStateQuads,
         "Quads of the boundaries on the way, at most");
  effort(
      "--irregular", search.balls.scars_per_irregularity, 0U, flips::kMaxPerIrregularity,
      "How much balls with vertices of high degree on their boundary are preferred: each unit of "
      "the sum of (degree - 4)^2 counts as so many less of the pairs of vertices that a ball "
      "relates");
  effort("--simple-zones", search.balls.scars_per_simple_zone, 0U, flips::kMaxPerSimpleZone,
         "How much balls are preferred whose boundary has few zones that do not cross themselves: "
         "each counts as so many of these pairs more (try 30, with --irregular 1)");
  effort("--max-hexahedra", search.max_hexahedra, 1, 200, "Hexahedra of the balls grown, at most");
  effort("--rounds", search.rounds, 1, 1000,
         "Rounds of sweep, exchange, cuts, symmetric collars, collars and annealing");
  effort("--growths", search.growths, 0, 1'000'000, "Exchanges tried per boundary and round");
  effort("--cut", search.cut, std::size_t{0}, std::size_t{1'000'000},
         "Boundaries per round that are cut in two, those with the largest meshes");
  effort("--cuts-each", search.cuts_each, std::size_t{1}, std::size_t{10'000},
         "Cuts of each of these");
  effort("--cut-growths", search.cut_growths, 0, 1'000'000, "Exchanges tried per cut");
  effort("--cut-interior", search.cut_interior, 0, 8,
         "Vertices inside the disc of a cut, at most; each one takes several times as long");
  effort("--cut-uphill", search.cut_uphill, 0U, 20U,
         "Hexahedra that exchange may add for a while to the meshes from cuts");
  effort(
      "--symmetric", search.symmetrized, std::size_t{0}, std::size_t{1'000'000},
      "Boundaries per round for which symmetric collars are grown, those with the largest meshes "
      "among the ones that have a symmetry of order two");
  effort("--symmetric-hexahedra", search.max_symmetric, 1, 200,
         "Hexahedra of a symmetric collar, at most");
  effort(
      "--symmetric-ball-hexahedra", search.max_symmetric_ball, 0, 100,
      "Hexahedra of the symmetric balls that fill such collars, beside the balls grown, at most; "
      "0: none of them");
  effort("--symmetric-ball-widest", search.symmetric_balls.max_quads, 6, flips::kMaxSymmetricQuads,
         "Quads of their boundaries on the way, at most");
  effort(
      "--symmetric-ball-width", search.symmetric_balls.fronts_per_level, std::size_t{1},
      std::size_t{100'000'000},
      "Such balls expanded per number of hexahedra, of those with a half-turn and of the others");
  effort("--collared", search.collared, std::size_t{0}, std::size_t{1'000'000},
         "Boundaries per round for which collars are grown, those with the largest meshes");
  effort("--collar-hexahedra", search.max_collar, 1, 200, "Hexahedra of a collar, at most");
  for (const auto& [name, collars, hint] :
       {std::tuple("--symmetric", &search.symmetric, ""),
        std::tuple("--collar", &search.collars,
                   "; beyond 30 each takes three times the memory, but of the hardest boundaries "
                   "hardly any others lead anywhere (try 36, with --collar-narrow 12)")}) {
    const std::string prefix = name;
    effort((prefix + "-widest").c_str(), collars->max_quads, 6, flips::kMaxSymmetricQuads,
           fmt::format("Quads of the boundaries inside such a collar, at most{}", hint).c_str());
    effort((prefix + "-width").c_str(), collars->fronts_per_level, std::size_t{1},
           std::size_t{100'000'000},
           "Such collars of one boundary expanded per number of hexahedra");
    effort((prefix + "-narrow").c_str(), collars->scars_per_quad, 0U, 1000U,
           "How much such collars with few quads inside are preferred: a quad counts as so many of "
           "the pairs of vertices that a collar relates");
  }
  effort("--guided", search.guided, 0, 20,
         "Not 0: half of the symmetric collars, and of those with more than 30 quads inside, are "
         "those that come to the fewest hexahedra with a ball that is known, each pair of vertices "
         "that both relate counting as so many (try 2)");
  effort("--annealed", search.annealed, std::size_t{0}, std::size_t{1'000'000},
         "Boundaries per round whose meshes are annealed, those with the largest ones");
  effort("--anneal-starts", search.anneal_starts, std::size_t{1}, std::size_t{1'000},
         "Meshes that annealing of one of these begins with: the one known, and others by collars, "
         "with a symmetry or without, of as many dual classes as there are");
  effort("--anneal-faulty", search.anneal_faulty, std::size_t{0}, std::size_t{100'000},
         "Further meshes that it begins with: balls in collars that do not quite fit, so that the "
         "mesh breaks the strict rule in a few places; as many with symmetric collars, and as many "
         "with symmetric balls in these");
  effort("--anneal-cut", search.anneal_cut, std::size_t{0}, std::size_t{100'000},
         "And more such meshes: two balls, side by side, in collars that do not quite fit");
  effort(
      "--anneal-transplant", search.anneal_transplant, std::size_t{0}, std::size_t{100'000},
      "And more such meshes, some without a fault: a part of a mesh of a similar boundary, and a "
      "ball in place of the rest");
  effort("--anneal-rounds", search.anneal_rounds, 1, 10'000'000,
         "Rounds of annealing of each mesh; each takes about 0.012 seconds of one processor");
  effort("--anneal-symmetric", search.anneal_symmetric, 0, 10'000'000,
         "Rounds of annealing that keeps a symmetry of order two, of each mesh that has one and "
         "for each that it has; each takes 0.02 to 0.1 seconds of one processor");
  effort(
      "--anneal-leaps", search.anneal_leaps, 0, 10'000'000,
      "Meshes made from the least ones known of the same boundary by an exchange of a large part, "
      "each of which is annealed as long");
  effort("--memory", options->memory_gib, 1, 4096,
         "GiB that the balls may take, about, and once more what is grown inwards to meet them");
  add_seed(*build, search.balls.seed);
  add_threads(*build, options->threads);
  build->footer(
      example("hexatlas table build -o my.hxt --max-quads 14 --width 20000 --state my.state"));
  build->callback([options, &action] {
    if (options->output.empty() || options->output == "-")
      throw CLI::ValidationError("--output", "a table and its manifest need the name of a file");
    action = [options] { return table_build(*options); };
  });
  add_table_bounds(*table, action, command_line);
  add_table_readers(*table, action);
}

}  // namespace

void add_seed(CLI::App& command, std::uint64_t& seed) {
  const auto read = [&seed](const std::string& word) {
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, seed);
    if (error != std::errc{} || end != last)
      throw CLI::ValidationError("--seed", "`" + word + "` is no integer from 0 to 2^64 - 1");
  };
  command.add_option_function<std::string>("--seed", read, "Seed of the search")
      ->type_name("UINT")
      ->default_str(std::to_string(seed));
}

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
  for (const std::string& word : words) command_line += " " + word;
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return wrong_usage(app, words, error);
    std::ostringstream help_or_version, unused;
    app.exit(error, help_or_version, unused);
    print(help_or_version.str());
    return ExitCode::yes;
  }
  return action();
}

}  // namespace hexatlas::cli
