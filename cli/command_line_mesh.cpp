#include <fmt/format.h>

#include <limits>
#include <memory>

#include "cli/command_line_parts.hpp"
#include "enum/flips/scars.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"

namespace hexatlas::cli {
namespace {

void add_mesh_to_write(CLI::App& app, std::string& output) {
  app.add_option("-o,--output", output,
                 "Mesh to write: .vtu .vtk .mesh .msh, or - for standard output (.vtk)")
      ->required();
}

void add_require_valid(CLI::App& app, bool& require_valid) {
  app.add_flag("--require-valid", require_valid,
               "Exit with 4 unless every hexahedron is proven valid");
}

template <class Options>
void add_report(CLI::App& app, Options& options) {
  app.add_flag("--json", options.json, "Print one JSON object");
  app.add_option("--report", options.report,
                 "Write a page on the mesh: what was done, quality, singular edges (.html); - for "
                 "standard output");
  add_require_valid(app, options.require_valid);
}

void add_effort(CLI::App& app, int& effort, const char* without = "first places only") {
  app.add_option(
         "--effort", effort,
         std::string("Limit of the work to place vertices, about seconds on one core; 0: ") +
             without)
      ->check(CLI::Range(0, untangle::kMaxEffort))
      ->capture_default_str();
}

void add_mesh_boundary(CLI::App& mesh, Action& action) {
  auto* command = mesh.add_subcommand(
      "boundary", "Mesh of the table with coordinates for a boundary that has none");
  auto options = std::make_shared<MeshBoundaryOptions>();
  command
      ->add_option("BOUNDARY", options->boundary,
                   "Name or canonical code of a boundary, or a file as `hexatlas code` takes it, "
                   "whose points are not used")
      ->required();
  add_mesh_to_write(*command, options->output);
  command->add_option("--table", options->table, "Table of meshes [the one beside the program]");
  command->add_flag("--free-boundary", options->free_boundary,
                    "Let the boundary move too; without, it is a convex polyhedron whose edges "
                    "touch a sphere");
  add_report(*command, *options);
  add_effort(*command, options->effort);
  add_threads(*command, options->threads);
  command->footer("With -o - the summary, or the JSON, goes to standard error.\n" +
                  example("hexatlas mesh boundary schneiders-pyramid -o pyramid.vtu"));
  command->callback([options, &action] { action = [options] { return mesh_boundary(*options); }; });
}

void add_mesh_untangle(CLI::App& mesh, Action& action) {
  auto* command = mesh.add_subcommand(
      "untangle",
      "Better places for the interior vertices of a mesh; the boundary and interfaces stay");
  auto options = std::make_shared<MeshUntangleOptions>();
  command
      ->add_option("MESH", options->input,
                   "Hexahedral mesh: .vtu .vtk .mesh .msh, or - for standard input")
      ->required();
  add_mesh_to_write(*command, options->output);
  auto* harmonic =
      command->add_flag("--harmonic", options->harmonic,
                        "Forget where the interior vertices are: begin with harmonic places, or "
                        "those that the spacing of the boundary asks for");
  command
      ->add_flag("--free-boundary", options->free_boundary,
                 "Move all vertices, those of interfaces too")
      ->excludes(harmonic);
  add_report(*command, *options);
  add_effort(*command, options->effort, "first places with --harmonic, else those given");
  add_threads(*command, options->threads);
  command->footer(
      "What is between two regions (references of MEDIT, entities of Gmsh), and quads inside that\n"
      "the file lists, stay in their places as the boundary does; the output names neither.\n"
      "With -o - the summary, or the JSON, goes to standard error.\n" +
      example("hexatlas mesh untangle mesh.vtu -o better.vtu"));
  command->callback([options, &action] { action = [options] { return mesh_untangle(*options); }; });
}

void add_mesh_delaunay(CLI::App& mesh, Action& action) {
  auto* command = mesh.add_subcommand("delaunay", "Delaunay triangulation of points: tetrahedra");
  auto options = std::make_shared<MeshDelaunayOptions>();
  command
      ->add_option("POINTS", options->input,
                   "Points: .xyz .bin .ply, or those of .obj .off .vtk .vtu .mesh .msh; - for "
                   "standard input")
      ->required();
  command->add_option("-o,--output", options->output,
                      "Mesh to write: .vtu .vtk .mesh .msh .hxtet, or - for standard output "
                      "(.vtk); without, the tetrahedra are counted");
  command->add_flag("--weights", options->weights,
                    "POINTS (.xyz .bin) have a fourth number, the weight: regular triangulation, "
                    "by power distances");
  command->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*command, options->threads);
  command->footer(
      "Of several triangulations that are Delaunay, the one chosen depends on the points only.\n"
      "Exit code 1 if all points are in one plane. `hexatlas check --delaunay` judges a mesh.\n" +
      example("hexatlas mesh delaunay points.xyz -o tetrahedra.vtu"));
  command->callback([options, &action] { action = [options] { return mesh_delaunay(*options); }; });
}

void add_mesh_hybrid(CLI::App& mesh, Action& action) {
  auto* command = mesh.add_subcommand(
      "hybrid", "Tetrahedra combined into hexahedra, prisms and pyramids: a hex-dominant mesh");
  auto options = std::make_shared<MeshHybridOptions>();
  command
      ->add_option("TETMESH", options->input,
                   "Tetrahedral mesh: .vtu .vtk .mesh .msh .hxtet, or - for standard input")
      ->required();
  auto* output =
      command->add_option("-o,--output", options->output,
                          "Mesh to write: .vtu .vtk .mesh .msh, or - for standard output (.vtk)");
  command->add_flag("--count", options->count, "Find and count the candidates only")
      ->excludes(output);
  command->add_option("--candidates", options->candidates,
                      "File for the list of all candidates; - for standard output");
  auto* fill = command
                   ->add_option("--fill", options->fill,
                                "Make the tetrahedra first, inside a closed surface: with points "
                                "on a lattice")
                   ->check(CLI::IsMember({"lattice"}));
  command
      ->add_option("--spacing", options->spacing,
                   "Of the lattice [that of squares whose halves are the triangles]")
      ->check(
          number_between(std::numeric_limits<double>::min(), std::numeric_limits<double>::max()))
      ->needs(fill);
  command
      ->add_flag("--keep-diagonals", options->keep_diagonals,
                 "The triangles of the surface stay, or are split, also where it is flat and other "
                 "diagonals make more cubes")
      ->needs(fill);
  command
      ->add_option(
          "--quality", options->quality,
          "Least scaled Jacobian of a cell that is chosen, exclusive; what closes the gaps "
          "between them may have less")
      ->check(number_between(0, 0.999))
      ->capture_default_str();
  command->add_flag("--conforming,!--no-conforming", options->conforming,
                    "Put pyramids where a quad meets two triangles, or give up the cell [yes]");
  command->add_option("--rounds", options->rounds, "Rounds of exchange after the greedy choice")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*command, options->threads);
  command->footer(
      "Either --output or --count. Regions and coloured triangles beside tetrahedra\n"
      "of .mesh and .msh are respected. `hexatlas check --hybrid` judges the mesh.\n" +
      example("hexatlas mesh hybrid tetrahedra.msh -o hybrid.vtu") +
      example("hexatlas mesh hybrid surface.obj --fill lattice -o hybrid.vtu"));
  command->callback([options, &action] { action = [options] { return mesh_hybrid(*options); }; });
}

void add_mesh_quads(CLI::App& mesh, Action& action) {
  auto* command =
      mesh.add_subcommand("quads", "Triangles of a surface combined into quads: quad-dominant");
  auto options = std::make_shared<MeshQuadsOptions>();
  command
      ->add_option("TRIANGLES", options->input,
                   "Surface of triangles: .obj .off .vtk .vtu .mesh .msh, or - for standard input")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Surface to write: .obj .off .vtk .vtu .mesh .msh, or - for standard output "
                   "(.vtk)")
      ->required();
  command
      ->add_option("--quality", options->quality, "Least sine of the corners of a quad, exclusive")
      ->check(number_between(0, 0.999))
      ->capture_default_str();
  command
      ->add_option(
          "--fold", options->fold,
          "Greatest angle between the two triangles of a quad, in degrees, 0 if they lie in "
          "one plane: where the surface bends more, its edges stay")
      ->check(number_between(0, 180))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "The points stay; triangles of no quad stay. References of MEDIT and entities of Gmsh go "
      "with\n"
      "the quads, names of groups do not.\n" +
      example("hexatlas mesh quads triangles.obj -o quads.obj"));
  command->callback([options, &action] { action = [options] { return mesh_quads(*options); }; });
}

}  // namespace

void add_mesh(CLI::App& app, Action& action) {
  auto* mesh = app.add_subcommand("mesh", "Make meshes");
  mesh->require_subcommand(1);
  auto* hex = mesh->add_subcommand("hex", "Hexahedral mesh of a ball given by its quad surface");
  auto options = std::make_shared<MeshHexOptions>();
  hex->add_option("INPUT", options->input,
                  "Quad surface: .obj .off .vtk .vtu .mesh .msh, or - for standard input")
      ->required();
  add_mesh_to_write(*hex, options->output);
  hex->add_option(
         "--method", options->method,
         "table: only what the table has; zones: layers, for blocks, swept bodies, recesses and "
         "their like; "
         "flips: any size, usually about one hexahedron per quad; construction: any size, at most "
         "25 hexahedra per quad, proven; auto: the first of these that can, or the next where that "
         "leaves fewer hexahedra not valid")
      ->check(CLI::IsMember({"auto", "table", "zones", "flips", "construction"}))
      ->capture_default_str();
  hex->add_option(
         "--layers", options->layers,
         "Layers of hexahedra below the whole boundary first, for good shapes there; with zones "
         "or flips")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  hex->add_option("--tries", options->tries,
                  "Orders in which flips are tried, the fewest hexahedra count [50 for small "
                  "surfaces, 1 from 20000 quads on]")
      ->check(CLI::Range(1, 1'000'000));
  hex->add_option("--table", options->table, "Table of meshes [the one beside the program]");
  hex->add_option("--sectors", options->sectors,
                  "Sectors of the construction [those beside the program]");
  add_report(*hex, *options);
  hex->add_option(
         "--effort", options->effort,
         fmt::format("Limit of the work to place the interior vertices of each mesh tried, "
                     "about seconds on one core; 0: first places only [{}; 0 above {} "
                     "hexahedra]",
                     untangle::kDefaultEffort, hexahedrize::kSmallMesh))
      ->check(CLI::Range(0, untangle::kMaxEffort));
  add_threads(*hex, options->threads);
  hex->footer("With -o - the summary, or the JSON, goes to standard error.\n" +
              example("hexatlas mesh hex pyramid.obj -o pyramid.vtu"));
  hex->callback([options, &action] { action = [options] { return mesh_hex(*options); }; });
  add_mesh_boundary(*mesh, action);
  add_mesh_untangle(*mesh, action);
  add_mesh_delaunay(*mesh, action);
  add_mesh_hybrid(*mesh, action);
  add_mesh_quads(*mesh, action);
}

void add_simplify(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "simplify", "Fewer hexahedra for a mesh of a ball, by exchange of cavities; same boundary");
  auto options = std::make_shared<SimplifyOptions>();
  simplify::Options& search = options->search;
  command
      ->add_option("MESH", options->input,
                   "Hexahedral mesh: .vtu .vtk .mesh .msh, or - for standard input")
      ->required();
  add_mesh_to_write(*command, options->output);
  auto* table = command->add_option("--table", options->table,
                                    "Table of meshes [the one beside the program]");
  command->add_flag("--no-table", options->without_table, "Use no table")->excludes(table);
  command->add_option("--tries", search.tries, "Cavities grown")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000'000}))
      ->capture_default_str();
  command
      ->add_option("--uphill", search.uphill,
                   "Hexahedra that meshes on the way may have above the least one")
      ->check(CLI::Range(0U, 20U))
      ->capture_default_str();
  command->add_option("--cavity", search.max_cavity, "Quads of the boundary of a cavity, at most")
      ->check(CLI::Range(6, flips::kMaxSearchQuads))
      ->capture_default_str();
  command->add_flag("!--parts", search.whole, "Never take the whole mesh for a cavity");
  command->add_flag("--keep-valid", options->keep_valid,
                    "Take back what leaves more hexahedra that are not proven valid than there "
                    "were, at most 50 times: slower, and less becomes smaller");
  add_seed(*command, search.seed);
  add_effort(*command, options->effort);
  command->add_flag("--json", options->json, "Print one JSON object");
  add_require_valid(*command, options->require_valid);
  command->footer(
      "Boundary points stay bit for bit; interior ones are placed anew if the mesh gets smaller;\n"
      "fewer hexahedra can be worse ones, down to inverted, without --keep-valid: the quality of\n"
      "both meshes is told.\n"
      "Regions, references and quads that the file lists are not kept, nor what is between them.\n"
      "Exit code 4 if it was stopped; the least mesh so far is written then. With -o - the\n"
      "summary, or the JSON, goes to standard error.\n" +
      example("hexatlas simplify large.vtu -o small.vtu"));
  command->callback([options, &action] { action = [options] { return simplify_mesh(*options); }; });
}

}  // namespace hexatlas::cli
