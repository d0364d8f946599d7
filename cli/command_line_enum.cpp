#include <memory>

#include "cli/command_line_parts.hpp"
#include "enum/balls/polyhedra.hpp"
#include "enum/balls/spheres.hpp"
#include "enum/balls/triangulations.hpp"
#include "enum/hexes/partial_mesh.hpp"
#include "enum/hexes/small_ball.hpp"

namespace hexatlas::cli {
namespace {

void add_triangulations(CLI::App& parent, Action& action) {
  auto* command = parent.add_subcommand(
      "triangulations", "All triangulations of a cell, up to the symmetry of the cell");
  auto options = std::make_shared<EnumTriangulationsOptions>();
  command
      ->add_option("CELL", options->cell,
                   "tetrahedron, pyramid, prism, octahedron, hexahedron, or a surface file of "
                   "triangles and quads with at most 12 vertices")
      ->required();
  command->add_option("--interior", options->interior, "Number of interior vertices")
      ->check(CLI::Range(0, balls::kMaxInterior))
      ->capture_default_str();
  command->add_flag("--boundary-tetrahedra", options->boundary_tetrahedra,
                    "Allow tetrahedra with all four vertices on one facet");
  auto* spheres = command->add_flag(
      "--through-spheres", options->through_spheres,
      "The second road: from the list of 3-spheres, at most 9 vertices in all; not "
      "proven to be exhaustive");
  auto* count = command->add_flag("--count")->description("Counts only; the default without -o");
  command
      ->add_option("-o,--output", options->output,
                   "Catalogue of the classes to write (.hxc), or - for standard output")
      ->excludes(count);
  command
      ->add_option("--completeness", options->completeness,
                   "Proof to write (.hxl) that the hexahedron has no other classes")
      ->excludes(count);
  command->add_flag("--json", options->json, "Print one JSON object");
  command
      ->add_option("--max-nodes", options->max_nodes,
                   "Stop after about this many nodes; the counts then are lower bounds")
      ->check(at_least_one)
      ->excludes(spheres);
  add_threads(*command, options->threads);
  command->footer("Exit code 4 if the search did not end.\n" +
                  example("hexatlas enum triangulations hexahedron -o hexahedron.hxc"));
  command->callback([options, &action] {
    expect_different_files({"CELL", options->cell}, {{"--output", options->output},
                                                     {"--completeness", options->completeness}});
    action = [options] { return enum_triangulations(*options); };
  });
}

void add_quadrangulations(CLI::App& parent, Action& action) {
  auto* command = parent.add_subcommand(
      "quadrangulations", "Quadrangulations of the sphere, one of each pair of mirror images");
  auto options = std::make_shared<EnumQuadrangulationsOptions>();
  command->add_option("--quads", options->quads, "Number of quads")
      ->check(CLI::Range(quads::kMinQuads, quads::kMaxQuads))
      ->required();
  command->add_option("--class", options->class_name, "3-connected, min-degree-3 or simple")
      ->check(CLI::IsMember({"3-connected", "min-degree-3", "simple"}))
      ->capture_default_str();
  auto* count = command->add_flag("--count")->description("Counts only; the default without -o");
  add_shard(*command, options->shard,
            "Part R of M as R/M, R from 0 on; the parts 0 to M-1 are together the whole");
  auto* output = command
                     ->add_option("-o,--output", options->output,
                                  "List to write in planar_code, or - for standard output")
                     ->excludes(count);
  command
      ->add_flag("--codes", options->codes,
                 "Write canonical codes, as `table list` does, one in each line")
      ->needs(output);
  command->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*command, options->threads);
  command->footer("Exit code 4 if the search was stopped.\n" +
                  example("hexatlas enum quadrangulations --quads 14 -o quads14.planar_code"));
  command->callback(
      [options, &action] { action = [options] { return enum_quadrangulations(*options); }; });
}

void add_hexmeshes(CLI::App& parent, Action& action) {
  auto* command = parent.add_subcommand(
      "hexmeshes", "All hexahedral meshes of a boundary, up to the symmetry of the boundary");
  auto options = std::make_shared<EnumHexmeshesOptions>();
  command
      ->add_option("BOUNDARY", options->boundary,
                   "Name (see `hexatlas table info`), canonical code, or a file of one "
                   "quadrangulation as `hexatlas code` takes it")
      ->required();
  command->add_option("--max-hexes", options->max_hexahedra, "At most so many hexahedra")
      ->check(CLI::Range(1, hexes::kMaxHexahedra))
      ->required();
  command->add_option("--max-interior", options->max_interior, "At most so many interior vertices")
      ->check(CLI::Range(0, hexes::kMaxMeshVertices));
  command->add_flag("--ball", options->ball,
                    "Balls only; otherwise any complex that obeys the strict rule");
  auto* first = command->add_flag("--first", options->first, "Stop at the first mesh");
  auto* count = command->add_flag("--count")->description("Counts only; the default without -o");
  auto* output = command
                     ->add_option("-o,--output", options->output,
                                  "List of the meshes to write, one JSON object per line, or - for "
                                  "standard output")
                     ->excludes(count);
  auto* certificate =
      command->add_option("--certificate", options->certificate,
                          "Proof to write (.hxb) that there is none; the search is run for it");
  auto* shard = add_shard(*command, options->shard,
                          "Part R of M as R/M, R from 0 on; counts and meshes add up");
  auto* state = command->add_option("--state", options->state,
                                    "File to save the search in, and to go on from if it is there");
  command->add_option("--save-every", options->save_every, "Seconds between saves")
      ->check(CLI::Range(0, 86400))
      ->capture_default_str()
      ->needs(state);
  auto* nodes = command
                    ->add_option("--max-nodes", options->max_nodes,
                                 "Stop after so many nodes; the counts then are lower bounds")
                    ->check(at_least_one);
  auto* estimate = command->add_option("--estimate", options->probes,
                                       "Do not search: estimate the nodes by so many probes");
  estimate->check(CLI::Range(2, 1000000000));
  for (auto* other : {output, shard, state, nodes, certificate, first}) estimate->excludes(other);
  for (auto* other : {output, shard, state, nodes, first}) certificate->excludes(other);
  add_seed(*command, options->seed, "Of the estimate")->needs(estimate);
  command->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*command, options->threads);
  command->footer(
      "Exit code 1 if the boundary is proven to have no mesh, without a search, or if a "
      "certificate\nis asked for and there is a mesh; 4 if the search did not end, unless --first "
      "has "
      "found one.\n" +
      example("hexatlas enum hexmeshes schneiders-pyramid --max-hexes 16 --ball "
              "--certificate pyramid-16.hxb"));
  command->callback([options, &action] {
    if (options->state == "-") throw CLI::ValidationError("--state", "needs the name of a file");
    expect_different_files({"BOUNDARY", options->boundary},
                           {{"--output", options->output},
                            {"--certificate", options->certificate},
                            {"--state", options->state}});
    action = [options] { return enum_hexmeshes(*options); };
  });
}

void add_shellings(CLI::App& parent, Action& action) {
  auto* command = parent.add_subcommand(
      "shellings", "Shellable hexahedral balls, one of each pair of mirror images");
  auto options = std::make_shared<EnumShellingsOptions>();
  command
      ->add_option("--hexes", options->hexahedra, "Number of hexahedra; counts come for less, too")
      ->check(CLI::Range(1, hexes::kMaxBallHexahedra))
      ->required();
  command->add_option("-o,--output", options->output,
                      "List of the balls with this number to write, or - for standard output");
  command->add_flag("--json", options->json, "Print one JSON object");
  command->add_option("--memory", options->memory_gib, "GiB that the lists may take, about")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  add_threads(*command, options->threads);
  command->footer(
      "Exit code 4 if the search was stopped; the numbers printed are exact all the same. 5 if "
      "the lists need more memory.\n" +
      example("hexatlas enum shellings --hexes 7 -o shellings7.txt"));
  command->callback(
      [options, &action] { action = [options] { return enum_shellings(*options); }; });
}

struct VerticesVerb {
  const char *name, *help, *footer;
  int least, greatest;
  bool has_output;
  ExitCode (*run)(const EnumVerticesOptions&);
};

void add_vertices_verb(CLI::App& parent, Action& action, const VerticesVerb& verb) {
  auto* command = parent.add_subcommand(verb.name, verb.help);
  auto options = std::make_shared<EnumVerticesOptions>();
  command->add_option("--vertices", options->vertices, "Number of vertices")
      ->check(CLI::Range(verb.least, verb.greatest))
      ->required();
  if (verb.has_output)
    command->add_option("-o,--output", options->output, "Catalogue to write (.hxc)");
  command->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*command, options->threads);
  command->footer(verb.footer);
  command->callback(
      [options, run = verb.run, &action] { action = [options, run] { return run(*options); }; });
}

}  // namespace

void add_enum(CLI::App& app, Action& action) {
  auto* parent = app.add_subcommand("enum", "Enumerate up to isomorphism");
  parent->require_subcommand(1);
  add_triangulations(*parent, action);
  add_quadrangulations(*parent, action);
  add_hexmeshes(*parent, action);
  add_shellings(*parent, action);
  add_vertices_verb(*parent, action,
                    {"spheres", "Triangulated 3-spheres, by bistellar flips",
                     "Example:\n  hexatlas enum spheres --vertices 9\n", balls::kMinSphereVertices,
                     balls::kMaxSphereVertices, false, enum_spheres});
  add_vertices_verb(
      *parent, action,
      {"balls", "Triangulated 3-balls, from the spheres with one vertex more",
       "Example:\n  hexatlas enum balls --vertices 7 -o balls.hxc\n", balls::kMinSphereVertices - 1,
       balls::kMaxSphereVertices - 1, true, enum_balls});
  add_vertices_verb(
      *parent, action,
      {"polyhedra", "Polyhedra with triangles and quads, and the triangulations of each",
       "Example:\n  hexatlas enum polyhedra --vertices 8\n", 4, balls::kMaxPolyhedronVertices,
       false, enum_polyhedra});
}

void add_realize(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "realize", "Coordinates for triangulations, or proofs that there are none");
  auto options = std::make_shared<RealizeOptions>();
  command
      ->add_option("INPUT", options->input,
                   "Catalogue (.hxc), the name of a cell, or one class of it as CELL:NUMBER")
      ->required();
  command->add_option("-o,--output", options->output,
                      "Catalogue with certificates to write, or - for standard output");
  auto* convex = command->add_flag("--convex", options->convex, "Points in convex position");
  command
      ->add_flag("--jacobian", options->jacobian,
                 "The trilinear hexahedron has a positive Jacobian everywhere")
      ->excludes(convex);
  command->add_flag("--quick", options->quick,
                    "Take the first coordinates found instead of small ones");
  command->add_flag("--json", options->json, "Print one JSON object");
  add_threads(*command, options->threads);
  command->footer(
      "Answers that the catalogue has already are kept. Exit code 4 if a class stays open, 1 if "
      "the one class asked for is refuted.\n" +
      example("hexatlas realize hexahedron -o hexahedron.hxc"));
  command->callback([options, &action] { action = [options] { return realize(*options); }; });
}

void add_reproduce(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("reproduce", "Reproduce a published result from scratch and judge it");
  auto options = std::make_shared<ReproduceOptions>();
  command->add_option("NAME", options->name, "hexahedron-174")
      ->required()
      ->check(CLI::IsMember({"hexahedron-174"}));
  command->add_option("-o,--output", options->folder,
                      "Folder for the catalogue, the certificate and the contact sheet");
  add_threads(*command, options->threads);
  command->footer(example("hexatlas reproduce hexahedron-174 -o result"));
  command->callback([options, &action] { action = [options] { return reproduce(*options); }; });
}

}  // namespace hexatlas::cli
