#include "enum/flips/mesh_involution.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "enum/cells/cube.hpp"

namespace hexatlas::flips {
namespace {

using complex::Hexahedron;
using complex::VertexId;
using FacetVertices = std::array<VertexId, 4>;  ///< ascending

constexpr VertexId kNone = 0xFFFFFFFF;

/// Follows the hexahedra from the boundary, each with its image.
class Extension {
 public:
  Extension(const complex::HexComplex& mesh, const SubBall::Neighbours& neighbours)
      : mesh_(mesh), neighbours_(neighbours) {
    found_.vertex.assign(mesh.vertices, kNone);
    found_.cell.assign(mesh.hexahedra.size(), SubBall::kOutside);
  }

  std::optional<MeshInvolution> of(const Involution& of_boundary, int quads) {
    std::copy_n(of_boundary.image.begin(), quads + 2, found_.vertex.begin());
    found_.is_mirrored = of_boundary.is_mirrored;
    if (!begin()) return std::nullopt;
    std::size_t done = 0;
    while (done < reached_.size())  // which grows meanwhile
      if (!go_across_all(reached_[done++])) return std::nullopt;
    if (reached_.size() < mesh_.hexahedra.size() || !is_involution()) return std::nullopt;
    return std::move(found_);
  }

 private:
  [[nodiscard]] FacetVertices facet_of(std::uint32_t cell, std::size_t facet) const {
    FacetVertices result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = mesh_.hexahedra[cell][cells::kFacetVertices[facet][i]];
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Requires that the images of its vertices are known.
  [[nodiscard]] FacetVertices image_of_facet(std::uint32_t cell, std::size_t facet) const {
    FacetVertices result = facet_of(cell, facet);
    for (VertexId& v : result) v = found_.vertex[v];
    std::sort(result.begin(), result.end());
    return result;
  }

  [[nodiscard]] std::optional<std::size_t> facet_with(std::uint32_t cell,
                                                      const FacetVertices& vertices) const {
    for (std::size_t f = 0; f < cells::kCubeFacets; ++f)
      if (facet_of(cell, f) == vertices) return f;
    return std::nullopt;
  }

  /// A hexahedron at the boundary and its image.
  bool begin() {
    std::optional<FacetVertices> wanted;
    std::pair<std::uint32_t, std::size_t> first;
    for (std::uint32_t c = 0; c < neighbours_.size() && !wanted; ++c)
      for (std::size_t f = 0; f < cells::kCubeFacets && !wanted; ++f)
        if (neighbours_[c][f] == SubBall::kOutside) {
          wanted = image_of_facet(c, f);
          first = {c, f};
        }
    for (std::uint32_t c = 0; wanted && c < neighbours_.size(); ++c)
      for (std::size_t f = 0; f < cells::kCubeFacets; ++f)
        if (neighbours_[c][f] == SubBall::kOutside && facet_of(c, f) == *wanted)
          return put(first.first, first.second, c, f);
    return false;
  }

  /// The image of one hexahedron is another one, facet onto facet; the images of the vertices of
  /// the facet are known. Returns whether this agrees with what is known.
  bool put(std::uint32_t cell, std::size_t facet, std::uint32_t image, std::size_t image_facet) {
    const Hexahedron& from = mesh_.hexahedra[cell];
    const Hexahedron& to = mesh_.hexahedra[image];
    const std::size_t across = std::size_t{1} << (facet / 2);
    const std::size_t across_image = std::size_t{1} << (image_facet / 2);
    for (const std::size_t corner : cells::kFacetVertices[facet]) {
      const auto at = std::find(to.begin(), to.end(), found_.vertex[from[corner]]);
      if (at == to.end()) return false;
      const auto image_corner = static_cast<std::size_t>(at - to.begin());
      VertexId& opposite = found_.vertex[from[corner ^ across]];
      const VertexId wanted = to[image_corner ^ across_image];
      if (opposite != kNone && opposite != wanted) return false;
      opposite = wanted;
    }
    found_.cell[cell] = image;
    reached_.push_back(cell);
    return true;
  }

  bool go_across_all(std::uint32_t cell) {
    const std::uint32_t image = found_.cell[cell];
    for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
      const FacetVertices vertices = image_of_facet(cell, f);
      const auto g = facet_with(image, vertices);
      if (!g) return false;
      const std::uint32_t next = neighbours_[cell][f];
      const std::uint32_t next_image = neighbours_[image][*g];
      if ((next == SubBall::kOutside) != (next_image == SubBall::kOutside)) return false;
      if (next == SubBall::kOutside) continue;
      if (found_.cell[next] != SubBall::kOutside) {
        if (found_.cell[next] != next_image) return false;
        continue;
      }
      const auto into = facet_with(next, facet_of(cell, f));
      const auto into_image = facet_with(next_image, vertices);
      if (!into || !into_image || !put(next, *into, next_image, *into_image)) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_involution() const {
    const auto& image = found_.vertex;
    for (VertexId v = 0; v < image.size(); ++v)
      if (image[v] == kNone || image[image[v]] != v) return false;
    return true;
  }

  const complex::HexComplex& mesh_;
  const SubBall::Neighbours& neighbours_;
  MeshInvolution found_;
  std::vector<std::uint32_t> reached_;
};

}  // namespace

std::optional<MeshInvolution> extended(const Involution& of_boundary,
                                       const complex::HexComplex& mesh, int quads,
                                       const SubBall::Neighbours& neighbours) {
  return Extension(mesh, neighbours).of(of_boundary, quads);
}

}  // namespace hexatlas::flips
