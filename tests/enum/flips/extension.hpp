#pragma once
/// \file
/// Symmetric balls as meshes, and whether a symmetry of a boundary is one of the mesh.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "enum/cells/cube_symmetries.hpp"
#include "enum/flips/symmetric_beam.hpp"

namespace hexatlas::support {

/// The ball as filling_of() gives one: canonical boundary vertices first, a shelling backwards.
inline complex::HexComplex mesh_of(const flips::Layers& layers) {
  std::vector<complex::Hexahedron> cells(layers.hexahedra.rbegin(), layers.hexahedra.rend());
  complex::HexComplex mesh{layers.vertices, std::move(cells)};
  if (layers.is_mirrored) mesh = complex::mirrored(std::move(mesh));
  mesh = complex::renumbered(std::move(mesh), layers.rim);
  return complex::compacted(std::move(mesh), static_cast<int>(layers.rim.size()));
}

/// Whether the map of the boundary extends to one of the mesh. The hexahedron at a facet whose
/// image is known goes to the one at the image; so from the boundary inwards.
class Extension {
 public:
  Extension(const complex::HexComplex& mesh, std::vector<int> image)
      : mesh_(mesh), image_(std::move(image)), to_(mesh.hexahedra.size(), -1) {
    image_.resize(mesh.vertices, -1);
  }
  [[nodiscard]] bool is_there() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t a = 0; a < to_.size(); ++a)
        if (to_[a] < 0 && find_image(a)) changed = true;
    }
    return std::none_of(to_.begin(), to_.end(), [](int to) { return to < 0; }) && is_involution();
  }

 private:
  /// A hexahedron with four images known, those of a facet, goes where a turn of some hexahedron
  /// fits them; two that have the facet in common: to the one that is not taken.
  bool find_image(std::size_t a) {
    const auto& cell = mesh_.hexahedra[a];
    std::size_t known = 0;
    for (const auto v : cell) known += image_[v] >= 0 ? 1U : 0U;
    if (known < 4) return false;
    std::optional<std::pair<std::size_t, const cells::CornerMap*>> only;
    for (std::size_t b = 0; b < to_.size(); ++b) {
      if (std::find(to_.begin(), to_.end(), static_cast<int>(b)) != to_.end()) continue;
      for (const auto& turn : cells::kCubeTables.corner) {
        bool fits = true;
        for (std::size_t c = 0; c < cell.size(); ++c) {
          const int image = image_[cell[c]];
          fits = fits && (image < 0 || image == static_cast<int>(mesh_.hexahedra[b][turn[c]]));
        }
        if (!fits) continue;
        if (only) return false;  // later, when more is known
        only.emplace(b, &turn);
      }
    }
    if (!only) return false;
    to_[a] = static_cast<int>(only->first);
    for (std::size_t c = 0; c < cell.size(); ++c)
      image_[cell[c]] = static_cast<int>(mesh_.hexahedra[only->first][(*only->second)[c]]);
    return true;
  }
  [[nodiscard]] bool is_involution() const {
    bool moves = false;
    for (std::size_t v = 0; v < image_.size(); ++v) {
      if (image_[v] < 0 || image_[static_cast<std::size_t>(image_[v])] != static_cast<int>(v))
        return false;
      moves = moves || image_[v] != static_cast<int>(v);
    }
    return moves;
  }

  const complex::HexComplex& mesh_;
  std::vector<int> image_;
  std::vector<int> to_;
};

inline std::vector<int> image_of(const flips::SymmetricState& state) {
  return {state.image.begin(), state.image.begin() + state.code.quads + 2};
}

}  // namespace hexatlas::support
