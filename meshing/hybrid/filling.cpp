#include "meshing/hybrid/filling.hpp"

#include <algorithm>

namespace hexatlas::hybrid {
namespace {

constexpr unsigned set_of_face(const cells::ShapeFacet& face) {
  unsigned set = 0;
  for (const cells::ShapeVertex v : face) set |= 1U << v;
  return set;
}

/// With the numbers of tetrahedra that a filling may have.
template <std::size_t kFaces>
constexpr CellShape shape_of(const std::array<cells::ShapeFacet, kFaces>& faces, std::size_t fewest,
                             std::size_t most) {
  CellShape shape{fewest, most, 0, {}, {}, {}};
  shape.face_of.fill(kNoFace);
  for (std::size_t f = 0; f < kFaces; ++f) {
    shape.faces[f] = faces[f];
    shape.sizes[f] = cells::is_triangle(faces[f]) ? 3 : 4;
    shape.triangles += shape.sizes[f] - 2;
    for (unsigned set = 0; set < 256; ++set)
      if (std::popcount(set) >= 3 && (set & ~set_of_face(faces[f])) == 0)
        shape.face_of[set] = static_cast<std::uint8_t>(f);
  }
  return shape;
}

}  // namespace

constexpr CellShape kHexahedronShape = shape_of(cells::kFacetVertices, 5, kMostInside);
constexpr CellShape kPrismShape = shape_of(cells::kPrismFacets, 3, 6);
constexpr CellShape kPyramidShape = shape_of(cells::kPyramidFacets, 2, 3);

/// One triangle of a filling's boundary.
struct FaceTriangle {
  unsigned set = 0;
  bool is_on_boundary = false;
  std::uint64_t colour = 0;
};

struct Filler::Work {
  const CellShape& shape;
  Filling filling{};
  int triangles = 0;
  std::array<std::array<FaceTriangle, 2>, 6> on{};
  std::array<std::uint8_t, 6> count{};
  std::array<TetIndex, 6> flat{};  ///< on the face, TetGraph::kOutside if there is none
};

/// Takes the tetrahedron in, unless it is; false if there are too many.
bool Filler::visit(Work& work, TetIndex t) const {
  Filling& filling = work.filling;
  const auto inside = filling.inside();
  if (std::find(inside.begin(), inside.end(), t) != inside.end()) return true;
  if (filling.inner == work.shape.most) return false;
  filling.tetrahedra[filling.inner++] = t;
  return true;
}

/// What lies beyond a facet is inside, flat, or outside; false if the cell cannot be filled.
bool Filler::cross(Work& work, TetIndex t, unsigned facet) const {
  const TetIndex beyond = graph_->across(t, facet);
  const Tetrahedron& vertices = (*graph_)[t];
  unsigned set = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (i != facet) set |= bit(vertices[i]);
  const std::uint8_t face = set < 256 ? work.shape.face_of[set] : kNoFace;
  if (face == kNoFace)
    return beyond != TetGraph::kOutside && graph_->colour(t, facet) == 0 && visit(work, beyond);
  if (work.count[face] == work.shape.sizes[face] - 2) return false;
  work.on[face][work.count[face]++] = {set, beyond == TetGraph::kOutside, graph_->colour(t, facet)};
  ++work.triangles;
  if (beyond == TetGraph::kOutside) return true;
  if (set_of((*graph_)[beyond]) < 256 && work.shape.face_of[set_of((*graph_)[beyond])] == face)
    work.flat[face] = beyond;
  return true;
}

/// Whether the two triangles of a quad are alike for a mesh in which they are one facet: those of
/// the filling, and, if a flat tetrahedron lies on them, the two on its other side.
bool Filler::are_alike(const Work& work, std::size_t face) const {
  const auto& [one, other] = work.on[face];
  if (one.is_on_boundary != other.is_on_boundary || one.colour != other.colour) return false;
  const TetIndex flat = work.flat[face];
  if (flat == TetGraph::kOutside) return true;
  std::array<unsigned, 2> outer{};
  std::size_t count = 0;
  const Tetrahedron& vertices = (*graph_)[flat];
  for (unsigned facet = 0; facet < 4; ++facet) {
    const unsigned set = set_of(vertices) & ~bit(vertices[facet]);
    if (set != one.set && set != other.set) outer[count++] = facet;
  }
  return (graph_->across(flat, outer[0]) == TetGraph::kOutside) ==
             (graph_->across(flat, outer[1]) == TetGraph::kOutside) &&
         graph_->colour(flat, outer[0]) == graph_->colour(flat, outer[1]);
}

bool Filler::is_accepted(const Work& work) const {
  const CellShape& shape = work.shape;
  if (work.filling.inner < shape.fewest || work.triangles != shape.triangles) return false;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    if (shape.sizes[f] != 4) continue;
    const auto& [one, other] = work.on[f];
    const unsigned diagonal = one.set & other.set;
    const auto& face = shape.faces[f];
    if (diagonal != (1U << face[0] | 1U << face[2]) && diagonal != (1U << face[1] | 1U << face[3]))
      return false;
    if (!are_alike(work, f)) return false;
  }
  return true;
}

/// Appends the flat tetrahedra; false if there are too many, or several regions.
bool Filler::complete(Work& work) const {
  Filling& filling = work.filling;
  std::sort(filling.tetrahedra.begin(), filling.tetrahedra.begin() + filling.inner);
  for (const TetIndex flat : work.flat) {
    if (flat == TetGraph::kOutside) continue;
    if (filling.all().size() == work.shape.most) return false;
    filling.tetrahedra[filling.all().size()] = flat;
    ++filling.flat;
  }
  std::sort(filling.tetrahedra.begin() + filling.inner,
            filling.tetrahedra.begin() + filling.inner + filling.flat);
  const std::uint32_t region = graph_->region(filling.tetrahedra[0]);
  const auto all = filling.all();
  return std::all_of(all.begin(), all.end(),
                     [&](TetIndex t) { return graph_->region(t) == region; });
}

std::optional<Filling> Filler::filling(const CellShape& shape, std::span<const Index> vertices,
                                       TetIndex start) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    corner_of_[vertices[i]] = static_cast<std::uint8_t>(i);
  Work work{shape};
  work.flat.fill(TetGraph::kOutside);
  bool is_good = visit(work, start);
  for (std::size_t next = 0; is_good && next < work.filling.inner; ++next)
    for (unsigned facet = 0; is_good && facet < 4; ++facet)
      is_good = cross(work, work.filling.tetrahedra[next], facet);
  is_good = is_good && is_accepted(work) && complete(work);
  for (const Index v : vertices) corner_of_[v] = kNone;
  if (!is_good) return std::nullopt;
  return work.filling;
}

}  // namespace hexatlas::hybrid
