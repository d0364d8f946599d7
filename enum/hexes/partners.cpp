#include "enum/hexes/partners.hpp"

#include <algorithm>
#include <bit>

namespace hexatlas::hexes {
namespace {

/// What the hexahedra to come at a vertex have to do, and the partners that it may have besides new
/// vertices. All numbers are those of section 8 of the proof note.
class Needs {
 public:
  Needs(const PartialMesh& mesh, Vertex v)
      : self_(bit(v)),
        open_(mesh.open_at(v)),
        discs_(2 - mesh.link_euler(v)),
        left_(mesh.new_vertices()),
        other_colour_(mesh.other_colour(v)),
        others_(mesh.unrelated_open(v) & mesh.of_other_colour(v)),
        other_count_(std::popcount(others_)),
        same_count_(std::popcount(mesh.unrelated_open(v)) - other_count_) {
    if (mesh.is_interior(v))
      least_ = std::max(0, (4 - mesh.cells_at(v) - open_ + 2 * discs_ + 1) / 2);
  }

  /// Edges to come, at least.
  [[nodiscard]] int least() const noexcept { return least_; }

  /// Whether there are partners for so many edges to come, those saturated being none for edges.
  [[nodiscard]] bool may_have(int edges, VertexSet saturated) const noexcept {
    const bool is_saturated = (saturated & self_) != 0;
    const int hexahedra = open_ - 2 * discs_ + 2 * edges;
    const int facets = open_ - 3 * discs_ + 3 * edges;
    const int for_edges = is_saturated ? 0 : std::popcount(others_ & ~saturated);
    const int new_ends = edges - for_edges;
    if (is_saturated && new_ends > 0) return false;
    const int new_others = std::max({0, new_ends, hexahedra + edges - other_count_});
    const int new_same = std::max(0, facets - same_count_);
    return new_others + new_same <= left_.all && new_others <= left_.of_colour[other_colour_] &&
           new_same <= left_.of_colour[1 - other_colour_];
  }

 private:
  VertexSet self_;
  int open_, discs_;
  NewVertices left_;
  unsigned other_colour_;
  VertexSet others_;
  int other_count_, same_count_;
  int least_ = 0;
};

}  // namespace

Partners partners_of(const PartialMesh& mesh, VertexSet saturated) {
  for (VertexSet before = ~saturated; before != saturated;) {
    before = saturated;
    for (VertexSet rest = mesh.open_vertices(); rest != 0; rest &= rest - 1) {
      const auto v = static_cast<Vertex>(std::countr_zero(rest));
      const Needs needs(mesh, v);
      if (!needs.may_have(needs.least(), saturated)) return {true, saturated};
      if (needs.least() == 0 && !needs.may_have(1, saturated)) saturated |= bit(v);
    }
  }
  return {false, saturated};
}

}  // namespace hexatlas::hexes
