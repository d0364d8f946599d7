#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>

#include "cli/command_line_parts.hpp"
#include "cli/table_write.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::cli {
namespace {

void add_save_every(CLI::App& command, int& seconds) {
  command.add_option("--save-every", seconds, "Seconds between two saves, at least")
      ->check(CLI::Range(0, 86'400))
      ->capture_default_str();
}

void expect_file(const std::string& output) {
  if (std::filesystem::path(output).extension() != ".hxt")
    throw CLI::ValidationError(
        "--output", "must end in .hxt, so that its manifest and its census are no other table's");
}

/// A state in the place of the table, or of what lies beside it, would be lost.
void expect_apart(const std::string& state, const std::string& output) {
  if (state == "-") throw CLI::ValidationError("--state", "needs the name of a file");
  const auto [table, manifest, census] = table_files(output);
  expect_different_files({}, {{"--output", table},
                              {"its manifest", manifest},
                              {"its census", census},
                              {"--state", state}});
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

  auto* list = table.add_subcommand(
      "list",
      "The boundaries of a table with the numbers of their meshes, as lines of a .tsv file");
  auto list_options = std::make_shared<TableListOptions>();
  list->add_option("TABLE", list_options->table, "Table [the one beside the program]");
  list->add_option("--quads", list_options->quads, "Only boundaries with so many quads")
      ->check(CLI::Range(6, 64));
  list->add_option("--at-least", list_options->at_least,
                   "Only meshes with at least so many hexahedra")
      ->check(CLI::Range(0, 65535));
  list->add_option("-o,--output", list_options->output, "File to write [standard output]");
  list->footer(example("hexatlas table list --quads 20 --at-least 50"));
  list->callback(
      [list_options, &action] { action = [list_options] { return table_list(*list_options); }; });

  auto* check = table.add_subcommand("check", "Judge every mesh of a table anew");
  auto check_options = std::make_shared<TableCheckOptions>();
  check->add_option("TABLE", check_options->table, "Table [the one beside the program]");
  check
      ->add_option("--complete-through", check_options->complete_through,
                   "Refuse it unless it has every 3-connected quadrangulation with an even number "
                   "of quads from 6 to N")
      ->type_name("N")
      ->check(CLI::Range(6, 32));
  add_shard(*check, check_options->shard,
            "Judge the meshes of one of M shares only, R/M, and all else: several processors or "
            "machines judge a large table together. Blocks of meshes are shared, of 64 as the "
            "program writes them");
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
      ->add_option(
          "-o,--output", options->output,
          "Table to write (.hxt), with manifest and census; it may be TABLE. Bounds and smaller "
          "meshes of a table that is there already are taken over, so that a search that "
          "was stopped goes on")
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
  bounds
      ->add_option("--only", options->only,
                   "A boundary, by name or canonical code; may be repeated, and all others are "
                   "left as they are")
      ->allow_extra_args(false);  // the next word may be TABLE
  bounds->add_option("--max-nodes", options->max_nodes, "Of the searches for one boundary")
      ->check(at_least_one);
  add_save_every(*bounds, options->save_every);
  bounds->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*bounds, options->threads);
  bounds->footer(example("hexatlas table bounds my.hxt -o my.hxt --max-hexes 10"));
  bounds->callback([options, &action] {
    expect_file(options->output);
    action = [options] { return table_bounds(*options); };
  });
}

/// Adds the options that say how much is tried.
class Effort {
 public:
  explicit Effort(CLI::App& command) : command_(command) {}

  template <class Value>
  void operator()(const std::string& name, Value& value, Value least, Value most,
                  const std::string& help) const {
    command_.add_option(name, value, help)
        ->check(CLI::Range(least, most))
        ->capture_default_str()
        ->group("Effort");
  }

 private:
  CLI::App& command_;
};

/// Of sweeps, rounds and exchange.
void add_sweep(const Effort& effort, build::SearchOptions& search) {
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
}

/// Of cuts.
void add_cuts(const Effort& effort, build::SearchOptions& search) {
  effort("--cut", search.cut, std::size_t{0}, std::size_t{1'000'000},
         "Boundaries per round that are cut in two, those with the largest meshes");
  effort("--cuts-each", search.cuts_each, std::size_t{1}, std::size_t{10'000},
         "Cuts of each of these");
  effort("--cut-growths", search.cut_growths, 0, 1'000'000, "Exchanges tried per cut");
  effort("--cut-interior", search.cut_interior, 0, 8,
         "Vertices inside the disc of a cut, at most; each one takes several times as long");
  effort("--cut-uphill", search.cut_uphill, 0U, 20U,
         "Hexahedra that exchange may add for a while to the meshes from cuts");
}

/// Of collars, with a symmetry or without.
void add_collars(const Effort& effort, build::SearchOptions& search) {
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
    effort(prefix + "-widest", collars->max_quads, 6, flips::kMaxSymmetricQuads,
           fmt::format("Quads of the boundaries inside such a collar, at most{}", hint));
    effort(prefix + "-width", collars->fronts_per_level, std::size_t{1}, std::size_t{100'000'000},
           "Such collars of one boundary expanded per number of hexahedra");
    effort(prefix + "-narrow", collars->scars_per_quad, 0U, 1000U,
           "How much such collars with few quads inside are preferred: a quad counts as so many of "
           "the pairs of vertices that a collar relates");
  }
  effort("--guided", search.guided, 0, 20,
         "Not 0: half of the symmetric collars, and of those with more than 30 quads inside, are "
         "those that come to the fewest hexahedra with a ball that is known, each pair of vertices "
         "that both relate counting as so many (try 2)");
}

/// Of annealing.
void add_annealing(const Effort& effort, build::SearchOptions& search) {
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
}

void add_table_build(CLI::App& table, Action& action, const std::string& command_line) {
  auto* build = table.add_subcommand("build", "Search for meshes and write them as a table");
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
      "have been for other boundaries but needs the same --seed, --width, --per-class, --widest, "
      "--irregular and --simple-zones, and any number of tables (.hxt); of equally small meshes "
      "those of the first table stay");
  add_save_every(*build, options->save_every);
  const Effort effort(*build);
  build::SearchOptions& search = options->search;
  add_sweep(effort, search);
  add_cuts(effort, search);
  add_collars(effort, search);
  add_annealing(effort, search);
  effort("--memory", options->memory_gib, 1, 4096,
         "GiB that the balls may take, about, and once more what is grown inwards to meet them");
  add_seed(*build, search.balls.seed);
  add_threads(*build, options->threads);
  build->footer(
      example("hexatlas table build -o my.hxt --max-quads 14 --width 20000 --state my.state"));
  build->callback([options, &action] {
    expect_file(options->output);
    expect_apart(options->state, options->output);
    action = [options] { return table_build(*options); };
  });
}

}  // namespace

void add_table(CLI::App& app, Action& action, const std::string& command_line) {
  auto* table = app.add_subcommand("table", "Make, read and judge tables of meshes");
  table->require_subcommand(1);
  add_table_build(*table, action, command_line);
  add_table_bounds(*table, action, command_line);
  add_table_readers(*table, action);
}

}  // namespace hexatlas::cli
