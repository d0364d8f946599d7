#pragma once
/// \file
/// What the verbs that write a hexahedral mesh share.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/report.hpp"
#include "meshing/quality/self_meeting.hpp"
#include "tables/check/mesh.hpp"

namespace hexatlas::cli {

/// The files of a verb; "-" is a standard stream.
struct MeshFiles {
  std::string input, output;
  std::string report{};  ///< empty: none
  const char* report_option = "--report";
  std::string table{};    ///< asked for, which the verb reads besides; empty: none
  std::string sectors{};  ///< likewise
};

/// The mesh and the surface as the judge takes them.
[[nodiscard]] check::Mesh for_judge(const mesh::HexMesh& mesh);
[[nodiscard]] check::Surface for_judge(const mesh::SurfaceMesh& surface);

/// Whether no output takes the place of another one, of the input, of the sectors asked for, or of
/// the table asked for and what lies beside it, which would lose one of them; says so if one does.
/// `input` is its word on the command line of the verb.
[[nodiscard]] bool are_distinct(const MeshFiles& files, const char* input, const char* verb);

/// Before long work: that the mesh and the report can be written.
void expect_outputs_writable(const MeshFiles& files);

/// io::expect_hexahedra_writable() for write_mesh().
void expect_mesh_writable(const std::string& output);
/// Writes the mesh; on standard output as .vtk.
void write_mesh(const std::string& output, const mesh::HexMesh& mesh);
/// The same for tetrahedra.
void expect_tetrahedra_writable(const std::string& output);
void write_tetrahedra(const std::string& output, const mesh::TetView& mesh);
/// The same for triangles and quads.
void expect_facets_writable(const std::string& output);
void write_facets(const std::string& output, const mesh::FacetMesh& mesh);
/// The same for cells of several shapes.
void expect_hybrid_writable(const std::string& output);
void write_hybrid(const std::string& output, const mesh::HybridMesh& mesh);

/// tell(), with the mesh or the report on standard output.
void tell(const MeshFiles& files, const std::string& text);

/// Why there is no mesh: a sentence on `name`, and with `json` an object that holds it. An empty
/// code is one that was not computed.
struct WithoutMesh {
  std::string outcome;
  std::size_t quads = 0;
  std::string reason;
  std::string code;
};
void tell(const MeshFiles& files, const std::string& name, const WithoutMesh& why, bool json);

/// Turns over each part of the mesh that is inside out, which has a negative volume; says so.
/// Requires a mesh without hexahedrize::fault_of_sides().
void turn_over_what_is_inside_out(mesh::HexMesh& mesh, const std::string& file);

/// A quality with four digits; one that these would make 0 with its exponent.
[[nodiscard]] std::string in_short(double quality);

/// Two lines: the scaled Jacobians and what is proven; the hexahedra by tenths of the scaled
/// Jacobian.
[[nodiscard]] std::string quality_text(const quality::Report& report);

/// The same as members of a JSON object.
void add_quality(nlohmann::ordered_json& json, const quality::Report& report);

/// Why no mesh with this surface for its boundary is right in space.
[[nodiscard]] std::string in_words(const mesh::SurfaceMesh& surface,
                                   const quality::SelfMeeting& meeting);
/// The same as a member: null or two quads, equal ones for a folded quad.
void add_self_meeting(nlohmann::ordered_json& json,
                      const std::optional<quality::SelfMeeting>& meeting);

/// The answer once a mesh is written: `undecided`, and why, if validity was asked for and some
/// hexahedra are not proven valid.
[[nodiscard]] ExitCode answer_for(const quality::Report& report, bool require_valid);

}  // namespace hexatlas::cli
