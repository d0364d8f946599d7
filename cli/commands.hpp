#pragma once
/// \file
/// The verbs of the program: plain options in, an exit code out. Data go to standard output or
/// to a file, words to standard error.

#include <cstdint>
#include <string>
#include <vector>

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
  std::string input, output, table;
  bool json = false;
  bool require_valid = false;
};
[[nodiscard]] ExitCode mesh_hex(const MeshHexOptions& options);

struct CheckOptions {
  std::string mesh, boundary, completeness;
  bool json = false;
};
[[nodiscard]] ExitCode check(const CheckOptions& options);

struct CodeOptions {
  std::string surface;
  bool json = false;
};
[[nodiscard]] ExitCode code(const CodeOptions& options);

struct TableBuildOptions {
  std::string output;
  int max_quads = 14;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all processors
  std::vector<std::string> also;
  int max_ball = 72;    ///< cap on the hexahedra of the balls grown first
  int max_collar = 26;  ///< cap on the hexahedra of the collars
  std::string command;
};
[[nodiscard]] ExitCode table_build(const TableBuildOptions& options);

struct TableInfoOptions {
  std::string table;
  bool json = false;
};
[[nodiscard]] ExitCode table_info(const TableInfoOptions& options);

struct TableGetOptions {
  std::string table, name, code, output;
};
[[nodiscard]] ExitCode table_get(const TableGetOptions& options);

struct TableCheckOptions {
  std::string table;
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

/// The table to read: the one asked for, or the one that comes with the program, beside the
/// executable in tables/ or in ../share/hexatlas/tables/.
/// Throws InvalidInput if it was not asked for and is not there.
[[nodiscard]] std::string table_path(const std::string& asked_for);

}  // namespace hexatlas::cli
