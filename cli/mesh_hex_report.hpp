#pragma once
/// \file
/// The report of `mesh hex`.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/mesh_report.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/self_meeting.hpp"
#include "tables/check/verdict.hpp"

namespace hexatlas::cli {

/// A surface, what was said of it, the mesh made of it, and what the judge says of that.
struct MeshHexAccount {
  const mesh::SurfaceMesh& surface;
  const std::vector<std::string>& notes;
  const hexahedrize::Hexahedrized& made;
  const check::Verdict& verdict;
  const std::optional<quality::SelfMeeting>& meeting;  ///< among the notes as well
};

/// What filled the rest, after "filled by".
[[nodiscard]] const char* words_for(hexahedrize::Rest rest);

[[nodiscard]] double per_quad(std::size_t hexahedra, std::size_t quads);

/// Requires a verdict that is accepted or undecided.
[[nodiscard]] MeshReport report_of(const MeshHexOptions& options, const MeshHexAccount& account,
                                   const quality::Report& quality, double seconds);

}  // namespace hexatlas::cli
