#pragma once
/// \file
/// The verbs of the program: plain options in, an exit code out. Data go to standard output or
/// to a file, words to standard error.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "enum/quads/generate.hpp"
#include "meshing/simplify/simplify.hpp"
#include "realize/untangle/untangle.hpp"
#include "tables/build/search.hpp"

namespace hexatlas::cli {

/// docs/architecture/README.md has the table of exit codes.
enum class ExitCode : std::uint8_t {
  yes = 0,
  no = 1,
  usage = 2,
  invalid_input = 3,
  undecided = 4,
  resources = 5,
  internal = 70
};

struct MeshHexOptions {
  std::string input, output, table, sectors;
  std::string report;           ///< file for a page; empty: none
  std::string method = "auto";  ///< or "table", "zones", "flips", "construction"
  std::size_t layers = 0;       ///< before flips
  std::size_t tries = 0;        ///< of flips; 0: by the number of quads
  bool json = false;
  bool require_valid = false;
  /// Of placing the interior vertices; by default it depends on the size of the mesh.
  std::optional<int> effort;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode mesh_hex(const MeshHexOptions& options);

struct MeshBoundaryOptions {
  std::string boundary;  ///< a name, a canonical code, or a surface file
  std::string output, table;
  std::string report;  ///< file for a page; empty: none
  bool free_boundary = false;
  bool json = false;
  bool require_valid = false;
  int effort = untangle::kDefaultEffort;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode mesh_boundary(const MeshBoundaryOptions& options);

struct MeshDelaunayOptions {
  std::string input;
  std::string output;  ///< empty: count only
  bool weights = false;
  bool json = false;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode mesh_delaunay(const MeshDelaunayOptions& options);

struct MeshHybridOptions {
  std::string input;
  std::string output;
  std::string candidates;       ///< file for their list; empty: none
  bool count = false;           ///< no mesh, and no output
  std::string fill;             ///< "lattice": the input is a surface; empty: tetrahedra
  double spacing = 0;           ///< of the lattice; 0: by the surface
  bool keep_diagonals = false;  ///< of the surface
  double quality = 0.1;         ///< the least, exclusive
  bool conforming = true;
  int rounds = 2;  ///< of exchange
  bool json = false;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode mesh_hybrid(const MeshHybridOptions& options);

struct MeshQuadsOptions {
  std::string input, output;
  double quality = 0.1;  ///< the least, exclusive
  double fold = 45;      ///< the greatest, in degrees
  bool json = false;
};
[[nodiscard]] ExitCode mesh_quads(const MeshQuadsOptions& options);

struct MeshUntangleOptions {
  std::string input, output;
  std::string report;  ///< file for a page; empty: none
  bool harmonic = false;
  bool free_boundary = false;
  bool json = false;
  bool require_valid = false;
  int effort = untangle::kDefaultEffort;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode mesh_untangle(const MeshUntangleOptions& options);

struct SimplifyOptions {
  std::string input, output, table;
  bool without_table = false;
  bool json = false;
  bool require_valid = false;
  bool keep_valid = false;                ///< no more hexahedra not proven valid than before
  int effort = untangle::kDefaultEffort;  ///< of placing the interior vertices
  simplify::Options search;
};
[[nodiscard]] ExitCode simplify_mesh(const SimplifyOptions& options);

/// How `view` begins; on the page all of it can be changed.
struct ViewState {
  std::string
      colour;  ///< jacobian, shape, layer, none; empty: jacobian of hexahedra, shape of mixed
  bool is_sliced = false, is_flipped = false;
  std::string slice_axis = "x";
  double slice_at = 0.5;  ///< fraction of the box
  double explode = 0, shrink = 0;
  unsigned peel = 0;
  std::string singular = "none";        ///< or interior, boundary, all
  double azimuth = 35, elevation = 25;  ///< degrees; of the camera, z is up
};
struct ViewOptions {
  std::string input, output, png;
  ViewState state;
  int width = 1200, height = 900;  ///< of the picture
  int timeout = 120;               ///< seconds for the browser
};
[[nodiscard]] ExitCode view_mesh(const ViewOptions& options);

struct CheckOptions {
  std::string mesh, boundary, completeness, points;
  bool delaunay = false;
  bool weights = false;  ///< of the points: the triangulation is to be regular
  bool hybrid = false;
  bool json = false;
};
[[nodiscard]] ExitCode check(const CheckOptions& options);

struct CodeOptions {
  std::string input;  ///< a quad surface or a list in planar_code
  bool json = false;
};
[[nodiscard]] ExitCode code(const CodeOptions& options);

struct TableBuildOptions {
  std::string output;
  int max_quads = 20;
  std::vector<std::string> also;
  std::string state;                    ///< file to save the search in and go on from; may be empty
  int save_every = 120;                 ///< seconds
  bool so_far = false;                  ///< do not search: write what the saved search has found
  std::vector<std::string> start_from;  ///< what a new search begins with: a saved one, tables
  build::SearchOptions search;
  int memory_gib = 16;
  int threads = 0;  ///< 0: all processors
  std::string command;
};
[[nodiscard]] ExitCode table_build(const TableBuildOptions& options);

struct TableBoundsOptions {
  std::string table, output;
  int max_hexahedra = 0;
  int max_quads = complex::kMaxQuads;
  std::vector<std::string> only;                ///< names or codes; empty: all boundaries
  std::uint64_t max_nodes = ~std::uint64_t{0};  ///< per boundary
  int save_every = 600;                         ///< seconds
  bool json = false;
  int threads = 0;  ///< 0: all processors
  std::string command;
};
[[nodiscard]] ExitCode table_bounds(const TableBoundsOptions& options);

struct TableInfoOptions {
  std::string table;
  bool by_quads = false;
  std::string svg;  ///< file for a bar chart; with by_quads only
  bool json = false;
};
[[nodiscard]] ExitCode table_info(const TableInfoOptions& options);

struct TableGetOptions {
  std::string table, name, code, output;
  bool search = false;
};
[[nodiscard]] ExitCode table_get(const TableGetOptions& options);

struct TableListOptions {
  std::string table, output;
  int quads = 0;     ///< only boundaries with so many; 0: all
  int at_least = 1;  ///< hexahedra
};
[[nodiscard]] ExitCode table_list(const TableListOptions& options);

struct TableCheckOptions {
  std::string table;
  std::string shard;         ///< as for shard_from(); empty: the whole
  int complete_through = 0;  ///< refused unless complete up to this number of quads; 0: anything
  bool json = false;
};
[[nodiscard]] ExitCode table_check(const TableCheckOptions& options);

struct EnumTriangulationsOptions {
  std::string cell, output, completeness;
  int interior = 0;
  bool boundary_tetrahedra = false;
  bool through_spheres = false;
  bool json = false;
  int threads = 0;  ///< 0: all processors
  std::uint64_t max_nodes = ~std::uint64_t{0};
};
[[nodiscard]] ExitCode enum_triangulations(const EnumTriangulationsOptions& options);

struct EnumVerticesOptions {
  int vertices = 0;
  std::string output;
  bool json = false;
  int threads = 0;
};
[[nodiscard]] ExitCode enum_spheres(const EnumVerticesOptions& options);
[[nodiscard]] ExitCode enum_balls(const EnumVerticesOptions& options);
[[nodiscard]] ExitCode enum_polyhedra(const EnumVerticesOptions& options);

/// "R/M" with 0 <= R < M <= 1000000; nullopt if the text is not of this form.
[[nodiscard]] std::optional<quads::Shard> shard_from(const std::string& text);

struct EnumQuadrangulationsOptions {
  int quads = 0;
  std::string class_name = "3-connected";  ///< or min-degree-3, simple
  std::string shard;                       ///< as for shard_from(); empty: the whole
  std::string output;
  bool codes = false;  ///< instead of planar_code
  bool json = false;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode enum_quadrangulations(const EnumQuadrangulationsOptions& options);

struct EnumHexmeshesOptions {
  std::string boundary;  ///< a name, a canonical code, or a surface file
  int max_hexahedra = 0;
  int max_interior = -1;  ///< -1: as many as so many hexahedra may have
  bool ball = false;
  bool first = false;       ///< stop at the first mesh
  std::string output;       ///< one JSON object per line
  std::string certificate;  ///< that there is none
  std::string state;        ///< file to save the search in and go on from; may be empty
  int save_every = 120;     ///< seconds
  std::string shard;        ///< as for shard_from(); empty: the whole
  std::uint64_t max_nodes = ~std::uint64_t{0};
  std::uint64_t probes = 0;  ///< estimate the nodes instead of searching
  std::uint64_t seed = 1;
  bool json = false;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode enum_hexmeshes(const EnumHexmeshesOptions& options);

struct EnumShellingsOptions {
  int hexahedra = 1;
  std::string output;
  bool json = false;
  int memory_gib = 8;
  int threads = 0;  ///< 0: all processors
};
[[nodiscard]] ExitCode enum_shellings(const EnumShellingsOptions& options);

struct RealizeOptions {
  std::string input;  ///< a catalogue, CELL, or CELL:NUMBER
  std::string output;
  bool convex = false, jacobian = false;
  bool quick = false;  ///< the first coordinates found instead of small ones
  bool json = false;
  int threads = 0;
};
[[nodiscard]] ExitCode realize(const RealizeOptions& options);

struct ReproduceOptions {
  std::string name, folder;
  int threads = 0;
};
[[nodiscard]] ExitCode reproduce(const ReproduceOptions& options);

}  // namespace hexatlas::cli
