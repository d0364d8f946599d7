#pragma once
/// \file
/// The page of `view`: one file that needs no other and no network. Its scripts and looks come
/// from cli/view, bundled when the program is built; here the mesh is put into it.
///
/// Points are written as single precision, relative to the centre of the box of the mesh and in
/// units of half of its longest side, so that no scale of the coordinates is lost or overflows.
/// The same mesh, name and options give the same bytes.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "cli/commands.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::cli {

/// The page without data: what comes before and after them. Empty in a program that was built
/// without it.
struct PageParts {
  std::string_view before, after;
};
[[nodiscard]] PageParts page_parts();

struct PageRequest {
  std::string name;  ///< of the mesh, for people
  ViewState state;
  std::optional<std::array<int, 2>> picture;  ///< size, for a page without controls
};

/// A page, and in a line what it shows.
struct Page {
  std::string html;
  std::string summary;
  std::size_t cells = 0;
  std::size_t layers = 1;
};

/// Requires: page_parts() are there.
[[nodiscard]] Page page_of(const mesh::HexMesh& mesh, const PageRequest& request);
[[nodiscard]] Page page_of(const mesh::HybridMesh& mesh, const PageRequest& request);
[[nodiscard]] Page page_of(const mesh::FacetMesh& surface, const PageRequest& request);

}  // namespace hexatlas::cli
