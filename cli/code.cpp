#include "enum/canon/code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/core/errors.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {

ExitCode code(const CodeOptions& options) {
  const mesh::SurfaceMesh surface = io::read_surface(options.surface);
  const auto result = complex::sphere_of(surface.quads, surface.points.size());
  if (const auto* law = std::get_if<complex::BrokenLaw>(&result)) {
    const bool has_line = law->cell && *law->cell < surface.quad_line.size();
    throw core::InvalidInput(options.surface, has_line ? surface.quad_line[*law->cell] : 0,
                             law->reason);
  }
  std::vector<complex::QuadVertices> quads;
  for (const auto& quad : std::get<complex::QuadSphere>(result).quads) {
    if (quads.size() == complex::kMaxQuads)
      throw core::InvalidInput(options.surface, "has more than 64 quads, the most that have codes");
    complex::QuadVertices small{};
    std::transform(quad.begin(), quad.end(), small.begin(),
                   [](complex::VertexId v) { return static_cast<complex::Vertex>(v); });
    quads.push_back(small);
  }
  const auto boundary = complex::Quadrangulation::from_quads(quads);
  if (!boundary)
    throw core::InvalidInput(options.surface,
                             "two edges join the same two points; such surfaces have no code here");
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
