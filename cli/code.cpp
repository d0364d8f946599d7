#include "enum/canon/code.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/quads/planar_code.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {
namespace {

using complex::Quadrangulation;

std::string line_of(const Quadrangulation& boundary, const canon::CanonicalForm& form) {
  nlohmann::ordered_json json;
  json["code"] = canon::to_text(form.code);
  json["quads"] = boundary.quads();
  json["automorphisms"] = form.automorphisms;
  json["rotations"] = form.rotations;
  json["three_connected"] = boundary.is_three_connected();
  return to_line(json);
}

bool is_list(const std::string& path, std::string_view bytes) {
  return bytes.starts_with(quads::kPlanarCodeHeader) || path.ends_with(".planar_code");
}

/// One line for each.
std::string lines_of_list(std::string_view bytes, const std::string& name, bool as_json) {
  std::string lines;
  quads::for_each_in_planar_code(bytes, name, [&](const Quadrangulation& graph) {
    const canon::CanonicalForm form = canon::canonical_form(graph);
    lines += as_json ? line_of(graph, form) : canon::to_text(form.code) + "\n";
  });
  return lines;
}

Quadrangulation boundary_in(std::string_view bytes, const std::string& path,
                            const std::string& name) {
  const io::FileFormat format = path == "-" ? io::detect_format(bytes, name, io::Content::surface)
                                            : io::format_of_path(path, io::Content::surface);
  const complex::QuadSphere sphere =
      hexahedrize::sphere_of(io::parse_surface(bytes, format, name), name);
  if (sphere.quads.size() > complex::kMaxQuads)
    throw core::InvalidInput(name, "has more than 64 quads, the most that have codes");
  const auto boundary = hexahedrize::small_form(sphere);
  core::ensures(boundary.has_value(), "a sphere of at most 64 quads has a small form");
  return *boundary;
}

}  // namespace

ExitCode code(const CodeOptions& options) {
  const std::string bytes = core::read_file(options.input);
  const std::string name = input_name(options.input);
  if (is_list(options.input, bytes)) {
    print(lines_of_list(bytes, name, options.json));
    return ExitCode::yes;
  }
  const Quadrangulation boundary = boundary_in(bytes, options.input, name);
  const canon::CanonicalForm form = canon::canonical_form(boundary);
  if (options.json) {
    print(line_of(boundary, form));
    return ExitCode::yes;
  }
  print(fmt::format("{}\n{} quads, {} automorphisms of which {} keep the orientation, {}\n",
                    canon::to_text(form.code), boundary.quads(), form.automorphisms, form.rotations,
                    boundary.is_three_connected() ? "3-connected" : "not 3-connected"));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
