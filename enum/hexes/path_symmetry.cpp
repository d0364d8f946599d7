#include "enum/hexes/path_symmetry.hpp"

#include <algorithm>

#include "enum/canon/code.hpp"

namespace hexatlas::hexes {

std::vector<BoundaryMap> automorphisms_of(const complex::Quadrangulation& boundary) {
  const auto vertices = static_cast<std::size_t>(boundary.vertices());
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  const canon::Labelling label = canon::labelling_from(boundary, flags.flags[0]);
  const canon::Labelling with_label = canon::inverse_of(label, boundary.vertices());
  std::vector<BoundaryMap> maps;
  for (int k = 0; k < flags.count; ++k) {
    const canon::Labelling other =
        canon::labelling_from(boundary, flags.flags[static_cast<std::size_t>(k)]);
    BoundaryMap& map = maps.emplace_back();
    for (std::size_t v = 0; v < vertices; ++v) map[v] = with_label[other[v]];
  }
  return maps;
}

PathSymmetry::PathSymmetry(const complex::Quadrangulation& boundary, bool bars_tops)
    : bars_tops_(bars_tops) {
  const auto vertices = static_cast<std::size_t>(boundary.vertices());
  for (const BoundaryMap& map : automorphisms_of(boundary)) {
    Image image;
    image.label.fill(kUnknown);
    bool is_identity = true;
    for (std::size_t v = 0; v < vertices; ++v) {
      image.label[v] = map[v];
      image.vertex[map[v]] = static_cast<Vertex>(v);
      is_identity = is_identity && map[v] == v;
    }
    image.at.labels = static_cast<std::uint8_t>(vertices);
    if (!is_identity) images_.push_back(image);
  }
}

/// Compares the next hexahedron of the image with that of the mesh.
PathSymmetry::Order PathSymmetry::step(Image& image, const PartialMesh& mesh) {
  Progress& at = image.at;
  const Cell& own = mesh.cells()[at.length];
  Facet bottom{};
  for (std::size_t i = 0; i < 4; ++i) bottom[i] = image.vertex[own[i]];
  const int facet = mesh.facet_at(bottom[0], bottom[2]);
  at.waits_on = static_cast<std::int16_t>(facet);
  for (const int cell : mesh.cells_on(facet)) {
    if (cell < 0 || (at.matched >> cell & 1U) != 0) continue;
    const Facet tops = tops_over(mesh.cells()[static_cast<std::size_t>(cell)], bottom);
    for (std::size_t i = 0; i < 4; ++i) {
      Vertex& label = image.label[tops[i]];
      if (label == kUnknown) {
        label = at.labels++;
        image.vertex[label] = tops[i];
      }
      if (label != own[4 + i]) return label < own[4 + i] ? Order::lesser : Order::greater;
    }
    at.matched |= std::uint64_t{1} << cell;
    ++at.length;
    return Order::equal;
  }
  return Order::unknown;
}

bool PathSymmetry::follow(PartialMesh& mesh) {
  const std::size_t hexahedra = mesh.cells().size();
  for (std::size_t i = 0; i < images_.size(); ++i) {
    Image& image = images_[i];
    if (image.at.is_greater) continue;
    const Progress before = image.at;
    Order order = Order::equal;
    while (order == Order::equal && image.at.length < hexahedra) order = step(image, mesh);
    image.at.is_greater = order == Order::greater;
    const bool has_moved = image.at != before;
    if (has_moved) changes_.push_back({hexahedra - 1, i, before});
    if (order == Order::lesser) return false;
    if (has_moved && order == Order::unknown && bars_tops_) bar(image, mesh);
  }
  return true;
}

/// A top with a lesser label than the first one of the mesh itself would refute.
void PathSymmetry::bar(const Image& image, PartialMesh& mesh) {
  const Cell& own = mesh.cells()[image.at.length];
  VertexSet tops = 0;
  for (std::size_t label = 0; label < std::min<std::size_t>(own[4], image.at.labels); ++label)
    tops |= bit(image.vertex[label]);
  const Facet& facet = mesh.facet(image.at.waits_on);
  std::size_t corner = 0;
  while (facet[corner] != image.vertex[own[0]]) ++corner;
  barred_.push_back({mesh.cells().size() - 1, image.at.waits_on, corner,
                     mesh.bar_tops(image.at.waits_on, corner, tops)});
}

void PathSymmetry::go_back(PartialMesh& mesh, std::size_t hexahedra) noexcept {
  for (; !barred_.empty() && barred_.back().hexahedra >= hexahedra; barred_.pop_back())
    mesh.permit_tops(barred_.back().facet, barred_.back().corner, barred_.back().before);
  for (; !changes_.empty() && changes_.back().hexahedra >= hexahedra; changes_.pop_back()) {
    Image& image = images_[changes_.back().image];
    for (; image.at.labels > changes_.back().before.labels; --image.at.labels)
      image.label[image.vertex[image.at.labels - std::size_t{1}]] = kUnknown;
    image.at = changes_.back().before;
  }
}

int PathSymmetry::automorphisms() const noexcept {
  return 1 + static_cast<int>(std::count_if(images_.begin(), images_.end(), [](const Image& image) {
           return !image.at.is_greater;
         }));
}

}  // namespace hexatlas::hexes
