#include "enum/flips/faults.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>

#include "enum/cells/cube.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;
using complex::VertexId;

/// A pair of vertices, ascending, of a hexahedron.
struct Occurrence {
  VertexId a, b;
  std::uint32_t cell;
  bool operator<(const Occurrence& other) const noexcept {
    return std::tie(a, b, cell) < std::tie(other.a, other.b, other.cell);
  }
};

bool has(const complex::Hexahedron& cell, std::size_t facet, VertexId v) {
  return std::any_of(cells::kFacetVertices[facet].begin(), cells::kFacetVertices[facet].end(),
                     [&](auto i) { return cell[i] == v; });
}

/// The classes of the hexahedra of one pair, joined through facets with both of its vertices.
int classes_of(const HexComplex& mesh, const SubBall::Neighbours& neighbours,
               std::span<const Occurrence> own) {
  std::vector<std::uint32_t> open, left;
  for (const Occurrence& one : own) left.push_back(one.cell);
  int classes = 0;
  for (; !left.empty(); ++classes) {
    open.push_back(left.back());
    left.pop_back();
    while (!open.empty()) {
      const std::uint32_t cell = open.back();
      open.pop_back();
      for (std::size_t facet = 0; facet < cells::kCubeFacets; ++facet) {
        const auto next = std::find(left.begin(), left.end(), neighbours[cell][facet]);
        if (next == left.end() || !has(mesh.hexahedra[cell], facet, own[0].a) ||
            !has(mesh.hexahedra[cell], facet, own[0].b))
          continue;
        open.push_back(*next);
        left.erase(next);
      }
    }
  }
  return classes;
}

}  // namespace

int faults_of(const HexComplex& mesh, const SubBall::Neighbours& neighbours) {
  std::vector<Occurrence> all;
  for (std::uint32_t cell = 0; cell < mesh.hexahedra.size(); ++cell)
    for (const VertexId a : mesh.hexahedra[cell])
      for (const VertexId b : mesh.hexahedra[cell])
        if (a < b) all.push_back({a, b, cell});
  std::sort(all.begin(), all.end());
  int faults = 0;
  for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
    while (next < all.size() && all[next].a == all[i].a && all[next].b == all[i].b) ++next;
    if (next - i > 1)
      faults += classes_of(mesh, neighbours, std::span(all).subspan(i, next - i)) - 1;
  }
  return faults;
}

}  // namespace hexatlas::flips
