#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/mesh_report.hpp"
#include "cli/output.hpp"
#include "cli/view_page.hpp"
#include "cli/view_picture.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {
namespace {

using AnyMesh = std::variant<mesh::HexMesh, mesh::HybridMesh, mesh::FacetMesh>;

/// The cells of dimension 3 of the file, or, if it has none, its triangles and quads. Of a file
/// that has neither the first refusal is told.
AnyMesh read_any(const ViewOptions& options) {
  const bool is_stream = options.input == "-";
  const std::string file = is_stream ? "standard input" : options.input;
  const std::string bytes = core::read_file(options.input);
  const io::FileFormat format =
      is_stream ? io::detect_format(bytes, file) : io::format_of_path(file);
  if (!io::holds(format, io::Content::hybrid)) return io::parse_facets(bytes, format, file);
  try {
    mesh::HybridMesh mesh = io::parse_hybrid(bytes, format, file);
    if (!mesh.tetrahedra.empty() || !mesh.prisms.empty() || !mesh.pyramids.empty()) return mesh;
    return mesh::HexMesh{std::move(mesh.points), std::move(mesh.hexahedra)};
  } catch (const core::InvalidInput&) {
    try {
      return io::parse_facets(bytes, format, file);
    } catch (const core::InvalidInput&) {
    }
    throw;
  }
}

ExitCode wrong_use(const std::string& reason) {
  say(reason + ". See `hexatlas view --help`.");
  return ExitCode::usage;
}

/// What of the options contradicts the mesh.
std::string contradiction(const ViewOptions& options, const AnyMesh& mesh, const Page& page) {
  const ViewState& state = options.state;
  const bool is_surface = std::holds_alternative<mesh::FacetMesh>(mesh);
  const bool is_hybrid = std::holds_alternative<mesh::HybridMesh>(mesh);
  if (is_surface && !state.colour.empty() && state.colour != "none")
    return "--colour " + state.colour + " is for cells in space, and the mesh is a surface";
  if (is_hybrid && state.colour == "jacobian")
    return "--colour jacobian is for meshes of hexahedra alone";
  if (!is_hybrid && state.colour == "shape")
    return "--colour shape is for meshes of several shapes";
  if (is_hybrid && state.singular != "none")
    return "--singular is for meshes of hexahedra alone, or surfaces";
  if (state.peel >= page.layers)
    return fmt::format("--peel {} leaves nothing of a mesh with {}", state.peel,
                       counted(page.layers, "layer", "layers"));
  return "";
}

Page page_for(const AnyMesh& mesh, const PageRequest& request) {
  return std::visit([&](const auto& some) { return page_of(some, request); }, mesh);
}

void expect_outputs_writable(const ViewOptions& options) {
  for (const std::string& output : {options.output, options.png})
    if (!output.empty()) core::expect_writable(output);
}

}  // namespace

ExitCode view_mesh(const ViewOptions& options) {
  if (options.output.empty() && options.png.empty())
    return wrong_use("--output or --png is needed");
  if (!are_distinct({options.input, options.output, options.png, "--png"}, "MESH", "view"))
    return ExitCode::usage;
  if (page_parts().before.empty())
    throw core::ResourceFailure(
        "this program was built without the page of `view` (HEXATLAS_VIEW=OFF)");
  expect_outputs_writable(options);
  const std::string chromium = options.png.empty() ? "" : browser();
  const AnyMesh mesh = read_any(options);
  PageRequest request{shown_name(options.input, "standard input"), options.state, {}};
  const Page page = page_for(mesh, request);
  if (const std::string fault = contradiction(options, mesh, page); !fault.empty())
    return wrong_use(fault);
  const std::string where = options.output == "-" || options.png == "-" ? "-" : "";
  if (!options.png.empty()) {
    request.picture = {options.width, options.height};
    const std::string picture = picture_of(page_for(mesh, request).html, chromium,
                                           {options.width, options.height, options.timeout});
    if (picture.empty()) {
      say("stopped; nothing was written");
      return ExitCode::undecided;
    }
    core::write_file(options.png, picture);
    tell(where, fmt::format("{}: {}\n", options.png, page.summary));
  }
  if (!options.output.empty()) {
    core::write_file(options.output, page.html);
    tell(where, fmt::format("{}: {}\n", options.output, page.summary));
  }
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
