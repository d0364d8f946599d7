#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "meshing/hybrid/quads.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {
namespace {

struct Account {
  std::size_t triangles = 0, candidates = 0, quads = 0;
  double min_quality = 0, mean_quality = 0;  ///< of the quads, if there are any
  double seconds = 0;                        ///< without the files
};

std::string json_line(const Account& account) {
  nlohmann::ordered_json json;
  json["triangles"] = account.triangles;
  json["candidates"] = account.candidates;
  json["selected"] = {{"quads", account.quads},
                      {"triangles", account.triangles - 2 * account.quads}};
  json["min_quality"] = nullptr;
  json["mean_quality"] = nullptr;
  if (account.quads != 0) {
    json["min_quality"] = account.min_quality;
    json["mean_quality"] = account.mean_quality;
  }
  json["seconds"] = account.seconds;
  return to_line(json);
}

std::string summary(const Account& account, const std::string& output) {
  std::string text = fmt::format(
      "{} of {}: {} and {} left, of {}\n", output,
      counted(account.triangles, "triangle", "triangles"), counted(account.quads, "quad", "quads"),
      counted(account.triangles - 2 * account.quads, "triangle", "triangles"),
      counted(account.candidates, "candidate", "candidates"));
  if (account.quads != 0)
    text += fmt::format("least quality {:.3f}, mean {:.3f}\n", account.min_quality,
                        account.mean_quality);
  return text;
}

mesh::FacetMesh triangles_of(const std::string& input) {
  mesh::FacetMesh surface = io::read_facets(input);
  for (const mesh::Facet& facet : surface.facets) {
    if (facet.size != 3)
      throw core::InvalidInput(input_name(input), facet.line,
                               "a quad, where only triangles are expected");
    if (!std::in_range<std::uint32_t>(facet.colour))
      throw core::InvalidInput(
          input_name(input), facet.line,
          fmt::format("reference {} is not between 0 and 4294967295", facet.colour));
  }
  return surface;
}

}  // namespace

ExitCode mesh_quads(const MeshQuadsOptions& options) {
  if (!are_distinct({options.input, options.output, {}}, "TRIANGLES", "mesh quads"))
    return ExitCode::usage;
  expect_facets_writable(options.output);
  const mesh::FacetMesh surface = triangles_of(options.input);
  if (const std::size_t edges = hybrid::incoherent_edges(surface); edges != 0)
    say(fmt::format("note: {} between two triangles of opposite orientation, which make no quad",
                    counted(edges, "edge", "edges")));
  const double start = seconds();
  const auto candidates = hybrid::quad_candidates(surface, {options.quality, options.fold});
  const auto chosen = hybrid::quad_selection(surface, candidates);
  const mesh::FacetMesh result = hybrid::with_quads(surface, candidates, chosen);
  Account account{surface.facets.size(), candidates.size(), chosen.size(), 0, 0, 0};
  account.seconds = seconds() - start;
  if (!chosen.empty()) account.min_quality = 1;
  for (const std::size_t i : chosen) {
    account.min_quality = std::min(account.min_quality, candidates[i].quality);
    account.mean_quality += candidates[i].quality;
  }
  if (!chosen.empty()) account.mean_quality /= static_cast<double>(chosen.size());
  write_facets(options.output, result);
  tell(options.output, options.json ? json_line(account) : summary(account, options.output));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
