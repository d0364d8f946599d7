#pragma once
/// \file
/// What `mesh hybrid` says of its work.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/conforming.hpp"
#include "meshing/hybrid/selection.hpp"
#include "meshing/quality/report.hpp"

namespace hexatlas::cli {

struct LatticeAccount {
  std::size_t points = 0, added_on_surface = 0, exchanged_diagonals = 0;
  double spacing = 0;
};

struct HybridAccount {
  std::optional<LatticeAccount> lattice;  ///< without: the tetrahedra were given
  std::size_t tetrahedra = 0;
  double quality = 0;
  std::array<std::size_t, hybrid::kShapes> candidates{};  ///< by shape
  std::size_t undecided = 0;
  std::vector<std::size_t> classes;          ///< of hexahedra by class, at last those of none
  std::optional<hybrid::Combined> combined;  ///< without: candidates were counted only
  quality::HybridReport report;              ///< of the mesh
  std::size_t points_inside_cells = 0;       ///< vertices of tetrahedra that no cell has
  double search_seconds = 0;                 ///< for the candidates
  double seconds = 0;                        ///< without files and lattice
  int threads = 1;
};

[[nodiscard]] std::string json_line(const HybridAccount& account);
[[nodiscard]] std::string summary(const HybridAccount& account, const std::string& output);

/// docs/formats/candidates.md.
[[nodiscard]] std::string candidates_text(const hybrid::Candidates& candidates, double quality);

}  // namespace hexatlas::cli
