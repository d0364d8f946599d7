#include "cli/mesh_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cli/output.hpp"
#include "cli/table_write.hpp"
#include "enum/cells/cube.hpp"
#include "enum/core/files.hpp"
#include "meshing/hexahedrize/sides.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {
namespace {

std::vector<check::Point> points_of(const std::vector<mesh::Point>& points) {
  std::vector<check::Point> result;
  std::transform(points.begin(), points.end(), std::back_inserter(result),
                 [](const mesh::Point& p) {
                   return check::Point{p.x, p.y, p.z};
                 });
  return result;
}

/// Standard output has no extension.
std::optional<io::FileFormat> format_on(const std::string& output) {
  return output == "-" ? std::optional(io::FileFormat::vtk) : std::nullopt;
}

}  // namespace

check::Mesh for_judge(const mesh::HexMesh& mesh) {
  check::Mesh judged{points_of(mesh.points), {}, {}};
  for (const auto& h : mesh.hexahedra)  // bottom and top quads, cyclically
    judged.hexahedra.push_back({h[0], h[1], h[3], h[2], h[4], h[5], h[7], h[6]});
  return judged;
}

check::Surface for_judge(const mesh::SurfaceMesh& surface) {
  return {points_of(surface.points), {surface.quads.begin(), surface.quads.end()}};
}

bool are_distinct(const MeshFiles& files, const char* input, const char* verb) {
  const std::vector<NamedFile> outputs{{"--output", files.output},
                                       {files.report_option, files.report}};
  for (const NamedFile& read : {NamedFile{input, files.input}, {"--sectors", files.sectors}})
    if (const auto same = same_files(read, outputs)) {
      say(fmt::format("{}. See `hexatlas {} --help`.", *same, verb));
      return false;
    }
  return files.table.empty() || std::none_of(outputs.begin(), outputs.end(), [&](const auto& each) {
           return would_lose_table(files.table, each, verb);
         });
}

void expect_outputs_writable(const MeshFiles& files) {
  expect_mesh_writable(files.output);
  if (!files.report.empty()) core::expect_writable(files.report);
}

void expect_mesh_writable(const std::string& output) {
  io::expect_hexahedra_writable(output, format_on(output));
}

void write_mesh(const std::string& output, const mesh::HexMesh& mesh) {
  io::write_hexahedra(output, mesh, format_on(output));
}

void expect_tetrahedra_writable(const std::string& output) {
  io::expect_tetrahedra_writable(output, format_on(output));
}

void write_tetrahedra(const std::string& output, const mesh::TetView& mesh) {
  io::write_tetrahedra(output, mesh, format_on(output));
}

void expect_facets_writable(const std::string& output) {
  io::expect_facets_writable(output, format_on(output));
}

void write_facets(const std::string& output, const mesh::FacetMesh& mesh) {
  io::write_facets(output, mesh, format_on(output));
}

void expect_hybrid_writable(const std::string& output) {
  io::expect_hybrid_writable(output, format_on(output));
}

void write_hybrid(const std::string& output, const mesh::HybridMesh& mesh) {
  io::write_hybrid(output, mesh, format_on(output));
}

void tell(const MeshFiles& files, const std::string& name, const WithoutMesh& why, bool json) {
  say(fmt::format("{}: {}", name, why.reason));
  if (!json) return;
  nlohmann::ordered_json object;
  object["outcome"] = why.outcome;
  object["quads"] = why.quads;
  object["reason"] = why.reason;
  object["code"] = nullptr;
  if (!why.code.empty()) object["code"] = why.code;
  tell(files, to_line(object));
}

void turn_over_what_is_inside_out(mesh::HexMesh& mesh, const std::string& file) {
  std::size_t turned = 0;
  for (const hexahedrize::Part& part : hexahedrize::parts_of(mesh)) {
    if (part.side != exact::Sign::negative) continue;
    for (const std::size_t c : part.cells) cells::exchange_axes(mesh.hexahedra[c]);
    turned += part.cells.size();
  }
  if (turned != 0)
    say(fmt::format("note: {} of the {} hexahedra of {} were inside out and turned over", turned,
                    mesh.hexahedra.size(), file));
}

std::string in_short(double quality) {
  constexpr double kLeastShown = 0.00005;  // of four digits
  return quality == 0 || std::abs(quality) >= kLeastShown ? fmt::format("{:.4f}", quality)
                                                          : fmt::format("{:.1e}", quality);
}

std::string quality_text(const quality::Report& report) {
  std::string bins;
  for (const std::size_t count : report.histogram) bins += fmt::format(" {}", count);
  return fmt::format(
      "scaled Jacobian: minimum {}, mean {}; {} of {} proven valid, {} inverted\n"
      "hexahedra by tenths of it, from below 0.1 to 1:{}\n",
      in_short(report.min_scaled_jacobian), in_short(report.mean_scaled_jacobian), report.valid,
      counted(report.cells, "hexahedron", "hexahedra"), report.inverted, bins);
}

void add_quality(nlohmann::ordered_json& json, const quality::Report& report) {
  json["min_scaled_jacobian"] = report.min_scaled_jacobian;
  json["mean_scaled_jacobian"] = report.mean_scaled_jacobian;
  json["inverted"] = report.inverted;
  json["valid"] = report.valid;
  json["histogram"] = report.histogram;
}

std::string in_words(const mesh::SurfaceMesh& surface, const quality::SelfMeeting& meeting) {
  const auto named = [&](std::uint32_t quad) {
    const std::uint32_t line = quad < surface.quad_line.size() ? surface.quad_line[quad] : 0;
    return line == 0 ? fmt::to_string(quad) : fmt::format("{} (line {})", quad, line);
  };
  if (meeting.is_folded_quad())
    return fmt::format(
        "quad {}, counted from 0, is flat and not strictly convex, so no mesh with this boundary "
        "has only valid hexahedra",
        named(meeting.first));
  return fmt::format(
      "quads {} and {}, counted from 0, meet outside what they share, so in any mesh with this "
      "boundary hexahedra overlap or touch where they must not",
      named(meeting.first), named(meeting.second));
}

void add_self_meeting(nlohmann::ordered_json& json,
                      const std::optional<quality::SelfMeeting>& meeting) {
  json["surface_meets_itself"] = nullptr;
  if (meeting) json["surface_meets_itself"] = {meeting->first, meeting->second};
}

ExitCode answer_for(const quality::Report& report, bool require_valid) {
  if (!require_valid || report.valid == report.cells) return ExitCode::yes;
  say(fmt::format("{} not proven valid, of {}; the mesh was written all the same",
                  counted(report.cells - report.valid, "hexahedron is", "hexahedra are"),
                  report.cells));
  return ExitCode::undecided;
}

void tell(const MeshFiles& files, const std::string& text) {
  tell(files.report == "-" ? files.report : files.output, text);
}

}  // namespace hexatlas::cli
