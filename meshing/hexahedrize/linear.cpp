#include "meshing/hexahedrize/linear.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "enum/complex/pair_set.hpp"
#include "enum/core/checks.hpp"
#include "meshing/hexahedrize/pairing.hpp"

namespace hexatlas::hexahedrize {
namespace {

using complex::BoundaryQuad;
using complex::QuadSphere;
using complex::VertexId;
using format::Sector;

/// The vertices of the mesh at those of a sector's surface.
using Surface = std::array<VertexId, format::kSectorSurface>;

/// The two colours of the vertices: neighbours differ. Vertex 0 is black.
std::vector<bool> black_vertices(const QuadSphere& sphere, const Sides& sides) {
  std::vector<bool> black(sphere.vertices(), false);
  std::vector<bool> seen(sphere.quads.size(), false);
  std::vector<std::uint32_t> open{0};
  seen[0] = true;
  // The first quad is begun at its vertex 0 as black; each other one where it meets a former one.
  black[sphere.quads[0][0]] = black[sphere.quads[0][2]] = true;
  while (!open.empty()) {
    const std::uint32_t q = open.back();
    open.pop_back();
    for (std::size_t s = 0; s < 4; ++s) {
      const std::uint32_t next = sides[q][s].quad;
      if (seen[next]) continue;
      seen[next] = true;
      const BoundaryQuad& quad = sphere.quads[next];
      const VertexId shared = sphere.quads[q][s];
      const auto at =
          static_cast<std::size_t>(std::find(quad.begin(), quad.end(), shared) - quad.begin());
      const std::size_t first = black[shared] ? at % 2 : 1 - at % 2;
      black[quad[first]] = black[quad[first + 2]] = true;
      open.push_back(next);
    }
  }
  return black;
}

class Construction {
 public:
  Construction(const QuadSphere& sphere, std::span<const Sector> sectors, const Apart& apart)
      : sphere_(sphere),
        sectors_(sectors),
        apart_(apart),
        sides_(sides_of(sphere)),
        partner_(partners(sides_)),
        black_(black_vertices(sphere, sides_)) {
    result_.used.resize(sectors.size());
    number_skeleton();
  }

  LinearMesh run() {
    std::vector<Surface> surfaces;
    surfaces.reserve(sphere_.quads.size() / 2);
    for (std::uint32_t q = 0; q < sphere_.quads.size(); ++q)
      if (q < partner_[q]) surfaces.push_back(surface_over(q));
    for (const Surface& surface : surfaces) relate_quads(surface);
    for (const Surface& surface : surfaces) fill(surface);
    return std::move(result_);
  }

 private:
  /// Vertices of the mesh in this order: the sphere's, the apex, those between corners and apex,
  /// two for each wall. An edge between partners has no wall, but numbers all the same are cheap.
  void number_skeleton() {
    complex::HexComplex& mesh = result_.mesh;
    apex_ = static_cast<VertexId>(sphere_.vertices());
    mesh.vertices = apex_ + 1;
    for (VertexId v = 0; v < apex_; ++v) {
      after_.push_back(mesh.vertices);
      mesh.vertices += black_[v] ? 1U : 2U;
    }
    inside_wall_.resize(2 * sides_.size());
    for (std::uint32_t q = 0; q < sides_.size(); ++q)
      for (const Side& side : sides_[q])
        if (q < side.quad && partner_[q] != side.quad) {
          inside_wall_[side.edge] = mesh.vertices;
          mesh.vertices += 2;
        }
  }

  /// Corners from 0 on run counter-clockwise from the black end of the edge between the partners.
  [[nodiscard]] Surface surface_over(std::uint32_t q) const {
    std::uint32_t first = q;
    std::uint32_t second = partner_[q];
    if (!black_[sphere_.quads[first][(side_to(first, second) + 1) % 4]]) std::swap(first, second);
    Surface surface{};
    int corner = 0;
    for (const auto& [quad, other] : {std::array{first, second}, std::array{second, first}}) {
      const std::size_t shared = side_to(quad, other);
      for (std::size_t i = 1; i <= 3; ++i, ++corner) {
        const std::size_t side = (shared + i) % 4;
        const VertexId v = sphere_.quads[quad][side];
        surface[static_cast<std::size_t>(corner)] = v;
        surface[format::after_corner(corner)] = after_[v];
        if (corner % 2 == 1) surface[format::before_apex(corner)] = after_[v] + 1;
        const auto [y, z] = format::inside_wall(corner);
        surface[y] = inside_wall_[sides_[quad][side].edge];
        surface[z] = surface[y] + 1;
      }
    }
    surface[format::kSectorApex] = apex_;
    return surface;
  }
  [[nodiscard]] std::size_t side_to(std::uint32_t quad, std::uint32_t other) const {
    std::size_t side = 0;
    while (sides_[quad][side].quad != other) ++side;
    return side;
  }

  void relate_quads(const Surface& surface) {
    static const auto kQuads = format::sector_quads();
    for (const BoundaryQuad& quad : kQuads)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) related_.insert(surface[quad[i]], surface[quad[j]]);
  }

  [[nodiscard]] bool fits(const Sector& sector, const Surface& surface) const {
    return std::none_of(sector.scars.begin(), sector.scars.end(),
                        [&](const format::SurfacePair& scar) {
                          const VertexId a = surface[scar[0]];
                          const VertexId b = surface[scar[1]];
                          return related_.has(a, b) || are_apart(a, b);
                        });
  }
  [[nodiscard]] bool are_apart(VertexId a, VertexId b) const {
    return apart_ && std::max(a, b) < sphere_.vertices() && apart_(a, b);
  }

  void fill(const Surface& surface) {
    const auto sector =
        std::find_if(sectors_.begin(), sectors_.end(),
                     [&](const Sector& candidate) { return fits(candidate, surface); });
    core::expects(sector != sectors_.end(), "one of the sectors has no scars");
    for (const auto& [a, b] : sector->scars) related_.insert(surface[a], surface[b]);
    ++result_.used[static_cast<std::size_t>(sector - sectors_.begin())];
    complex::HexComplex& mesh = result_.mesh;
    for (complex::Hexahedron cell : sector->mesh.hexahedra) {
      for (VertexId& v : cell)
        v = v < format::kSectorSurface ? surface[v] : mesh.vertices + v - format::kSectorSurface;
      mesh.hexahedra.push_back(cell);
    }
    mesh.vertices += sector->mesh.vertices - format::kSectorSurface;
  }

  const QuadSphere& sphere_;
  std::span<const Sector> sectors_;
  const Apart& apart_;
  Sides sides_;
  std::vector<std::uint32_t> partner_;
  std::vector<bool> black_;
  VertexId apex_ = 0;
  std::vector<VertexId> after_;        ///< of each vertex of the sphere, the first one below it
  std::vector<VertexId> inside_wall_;  ///< of each edge, the first of the two in its wall
  complex::PairSet related_;           ///< pairs in quads of boundary and walls, and scars so far
  LinearMesh result_;
};

}  // namespace

LinearMesh mesh_by_sectors(const QuadSphere& sphere, std::span<const Sector> sectors,
                           const Apart& apart) {
  return Construction(sphere, sectors, apart).run();
}

std::size_t hexahedra_bound(std::size_t quads, std::span<const Sector> sectors) {
  const auto always_fits = std::find_if(sectors.begin(), sectors.end(),
                                        [](const Sector& sector) { return sector.scars.empty(); });
  core::expects(always_fits != sectors.end(), "one of the sectors has no scars");
  return always_fits->mesh.hexahedra.size() * (quads / 2);
}

}  // namespace hexatlas::hexahedrize
