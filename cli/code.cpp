#include "enum/canon/code.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {

ExitCode code(const CodeOptions& options) {
  const mesh::SurfaceMesh surface = io::read_surface(options.surface);
  const complex::QuadSphere sphere = hexahedrize::sphere_of(surface, options.surface);
  if (sphere.quads.size() > complex::kMaxQuads)
    throw core::InvalidInput(options.surface, "has more than 64 quads, the most that have codes");
  const auto boundary = hexahedrize::small_form(sphere);
  core::ensures(boundary.has_value(), "a sphere of at most 64 quads has a small form");
  const canon::CanonicalForm form = canon::canonical_form(*boundary);
  nlohmann::ordered_json json;
  json["code"] = canon::to_text(form.code);
  json["quads"] = boundary->quads();
  json["automorphisms"] = form.automorphisms;
  json["rotations"] = form.rotations;
  json["three_connected"] = boundary->is_three_connected();
  if (options.json) {
    print(to_line(json));
    return ExitCode::yes;
  }
  print(fmt::format("{}\n{} quads, {} automorphisms of which {} keep the orientation, {}\n",
                    canon::to_text(form.code), boundary->quads(), form.automorphisms,
                    form.rotations,
                    boundary->is_three_connected() ? "3-connected" : "not 3-connected"));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
