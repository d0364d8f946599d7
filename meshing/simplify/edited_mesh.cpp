#include "meshing/simplify/edited_mesh.hpp"

#include <algorithm>
#include <utility>

#include "enum/cells/cube.hpp"

namespace hexatlas::simplify {

using complex::Hexahedron;
using complex::VertexId;
using flips::SubBall;

EditedMesh::EditedMesh(complex::HexComplex mesh)
    : mesh_(std::move(mesh)),
      neighbours_(SubBall::neighbours_of(mesh_)),
      cells_at_(mesh_.vertices) {
  for (std::uint32_t cell = 0; cell < mesh_.hexahedra.size(); ++cell)
    for (const VertexId v : mesh_.hexahedra[cell]) cells_at_[v].push_back(cell);
  for (VertexId v = 0; v < mesh_.vertices; ++v)
    if (cells_at_[v].empty()) unused_.push_back(v);
}

void EditedMesh::make(Exchange exchange) {
  std::vector<std::uint32_t>& cells = exchange.cells;
  std::vector<Hexahedron>& instead = exchange.instead;
  std::sort(cells.begin(), cells.end());
  take_new_vertices(instead);
  std::vector<VertexId> former;
  for (const std::uint32_t cell : cells) {
    former.insert(former.end(), mesh_.hexahedra[cell].begin(), mesh_.hexahedra[cell].end());
    take_out(cell);
  }
  while (cells.size() < instead.size()) {
    cells.push_back(static_cast<std::uint32_t>(mesh_.hexahedra.size()));
    mesh_.hexahedra.emplace_back();
    neighbours_.emplace_back();
  }
  for (std::size_t i = 0; i < instead.size(); ++i) put(cells[i], instead[i]);
  for (std::size_t i = 0; i < instead.size(); ++i) link(cells[i]);
  // The last number first: those above a number that falls free are then in use.
  for (; cells.size() > instead.size(); cells.pop_back()) move_last_to(cells.back());
  std::sort(former.begin(), former.end());
  former.erase(std::unique(former.begin(), former.end()), former.end());
  for (const VertexId v : former)
    if (cells_at_[v].empty()) unused_.push_back(v);
}

/// New vertices get numbers that are not in use.
void EditedMesh::take_new_vertices(std::vector<Hexahedron>& cells) {
  const VertexId first = mesh_.vertices;
  std::vector<VertexId> number;
  for (Hexahedron& cell : cells)
    for (VertexId& v : cell) {
      if (v < first) continue;
      while (number.size() <= v - first) {
        if (unused_.empty()) unused_.push_back(mesh_.vertices++);
        number.push_back(unused_.back());
        unused_.pop_back();
      }
      v = number[v - first];
    }
  cells_at_.resize(mesh_.vertices);
}

void EditedMesh::put(std::uint32_t cell, const Hexahedron& vertices) {
  mesh_.hexahedra[cell] = vertices;
  for (const VertexId v : vertices) cells_at_[v].push_back(cell);
}

void EditedMesh::take_out(std::uint32_t cell) {
  for (const VertexId v : mesh_.hexahedra[cell]) std::erase(cells_at_[v], cell);
  for (const std::uint32_t other : neighbours_[cell])
    if (other != SubBall::kOutside)
      std::replace(neighbours_[other].begin(), neighbours_[other].end(), cell, SubBall::kOutside);
  neighbours_[cell].fill(SubBall::kOutside);
}

/// Finds the hexahedra across its facets: those that contain the facet's vertices.
void EditedMesh::link(std::uint32_t cell) {
  const auto holds = [this](std::uint32_t other, VertexId v) {
    const Hexahedron& vertices = mesh_.hexahedra[other];
    return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
  };
  for (std::size_t f = 0; f < cells::kCubeFacets; ++f) {
    std::array<VertexId, 4> facet{};
    for (std::size_t i = 0; i < 4; ++i)
      facet[i] = mesh_.hexahedra[cell][cells::kFacetVertices[f][i]];
    neighbours_[cell][f] = SubBall::kOutside;
    for (const std::uint32_t other : cells_at_[facet[0]]) {
      if (other == cell ||
          !std::all_of(facet.begin() + 1, facet.end(), [&](VertexId v) { return holds(other, v); }))
        continue;
      neighbours_[cell][f] = other;
      for (std::size_t g = 0; g < cells::kCubeFacets; ++g) {
        const auto& corners = cells::kFacetVertices[g];
        if (std::all_of(corners.begin(), corners.end(), [&](cells::CubeVertex c) {
              return std::find(facet.begin(), facet.end(), mesh_.hexahedra[other][c]) !=
                     facet.end();
            }))
          neighbours_[other][g] = cell;
      }
    }
  }
}

/// The last hexahedron gets a number that has fallen free.
void EditedMesh::move_last_to(std::uint32_t cell) {
  const auto last = static_cast<std::uint32_t>(mesh_.hexahedra.size() - 1);
  if (cell != last) {
    mesh_.hexahedra[cell] = mesh_.hexahedra[last];
    neighbours_[cell] = neighbours_[last];
    for (const std::uint32_t other : neighbours_[cell])
      if (other != SubBall::kOutside)
        std::replace(neighbours_[other].begin(), neighbours_[other].end(), last, cell);
    for (const VertexId v : mesh_.hexahedra[cell])
      std::replace(cells_at_[v].begin(), cells_at_[v].end(), last, cell);
  }
  mesh_.hexahedra.pop_back();
  neighbours_.pop_back();
}

}  // namespace hexatlas::simplify
