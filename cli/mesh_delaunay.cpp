#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/delaunay/triangulation.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {
namespace {

struct Account {
  std::size_t points = 0, duplicates = 0, hidden = 0, tetrahedra = 0;
  double seconds = 0;  ///< of triangulating, without the files
  int threads = 1;
  double bytes_per_tetrahedron = 0;
};

std::string json_line(const Account& account) {
  nlohmann::ordered_json json;
  json["outcome"] = "meshed";
  json["points"] = account.points;
  json["duplicates"] = account.duplicates;
  json["hidden"] = account.hidden;
  json["tetrahedra"] = account.tetrahedra;
  json["seconds"] = account.seconds;
  json["threads"] = account.threads;
  json["bytes_per_tetrahedron"] = account.bytes_per_tetrahedron;
  return to_line(json);
}

std::string summary(const Account& account, const std::string& output, bool is_weighted) {
  return fmt::format("{}: {} of {}, {}{}\n{:.2f} seconds with {}, {:.0f} bytes per tetrahedron\n",
                     output.empty() ? "counted" : output,
                     counted(account.tetrahedra, "tetrahedron", "tetrahedra"),
                     counted(account.points, "point", "points"),
                     counted(account.duplicates, "duplicate", "duplicates"),
                     is_weighted ? fmt::format(", {} hidden", account.hidden) : "", account.seconds,
                     counted(static_cast<std::size_t>(account.threads), "thread", "threads"),
                     account.bytes_per_tetrahedron);
}

std::string why_degenerate(int dimension, std::size_t points) {
  constexpr std::array<const char*, 3> kWhere{"at one place", "on a line", "in a plane"};
  if (dimension < 0) return "there are no points";
  return fmt::format("{} {}", points == 1 ? "the only point is" : "all points are",
                     kWhere.at(static_cast<std::size_t>(dimension)));
}

}  // namespace

ExitCode mesh_delaunay(const MeshDelaunayOptions& options) {
  if (!are_distinct({options.input, options.output, {}}, "POINTS", "mesh delaunay"))
    return ExitCode::usage;
  if (!options.output.empty()) expect_tetrahedra_writable(options.output);
  const auto [points, weights] = options.weights
                                     ? io::read_weighted_points(options.input)
                                     : mesh::WeightedPoints{io::read_points(options.input), {}};
  const int threads = parallel::threads_or_all(options.threads);
  const double start = seconds();
  const delaunay::Triangulation triangulation =
      options.weights ? delaunay::Triangulation(points, weights, {.threads = threads})
                      : delaunay::Triangulation(points, {.threads = threads});
  const double elapsed = seconds() - start;
  if (triangulation.dimension() < 3) {
    const std::string reason =
        fmt::format("degenerate, {}: no tetrahedron has them for vertices",
                    why_degenerate(triangulation.dimension(), points.size()));
    say(fmt::format("{}: {}", input_name(options.input), reason));
    const nlohmann::ordered_json json{
        {"outcome", "degenerate"}, {"points", points.size()}, {"reason", reason}};
    if (options.json) tell(options.output, to_line(json));
    return ExitCode::no;
  }
  Account account;
  account.points = points.size();
  account.duplicates = triangulation.duplicates();
  account.hidden = triangulation.hidden().size();
  account.tetrahedra = triangulation.size();
  account.seconds = elapsed;
  account.threads = threads;
  account.bytes_per_tetrahedron =
      static_cast<double>(triangulation.bytes()) / static_cast<double>(account.tetrahedra);
  if (!options.output.empty())
    write_tetrahedra(options.output, {points, triangulation.tetrahedra()});
  tell(options.output,
       options.json ? json_line(account) : summary(account, options.output, options.weights));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
