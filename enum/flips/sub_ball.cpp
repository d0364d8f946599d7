#include "enum/flips/sub_ball.hpp"

#include <algorithm>
#include <bit>

#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::Vertex;
using complex::VertexId;

/// What the patches of the cube have to do with its corners.
struct PatchCorners {
  bool is_patch = false;
  std::uint8_t reached = 0;  ///< corners in the patch, one bit each
  /// For each corner the later ones in the patch, but in no facet of the patch with it.
  std::array<std::uint8_t, cells::kCubeVertices> apart{};
};

constexpr std::array<PatchCorners, 1U << cells::kCubeFacets> patch_corners() {
  std::array<PatchCorners, 1U << cells::kCubeFacets> result{};
  for (unsigned bits = 0; bits < result.size(); ++bits) {
    PatchCorners& own = result[bits];
    own.is_patch = kind_of(FacetSet{static_cast<std::uint8_t>(bits)}).has_value();
    std::array<unsigned, cells::kCubeVertices> together{};
    for (unsigned f = 0; f < cells::kCubeFacets; ++f) {
      if ((bits >> f & 1U) == 0) continue;
      unsigned corners = 0;
      for (const cells::CubeVertex c : cells::kFacetVertices[f]) corners |= 1U << c;
      for (const cells::CubeVertex c : cells::kFacetVertices[f]) together[c] |= corners;
      own.reached = static_cast<std::uint8_t>(own.reached | corners);
    }
    for (unsigned c = 0; c < cells::kCubeVertices; ++c)
      if ((own.reached >> c & 1U) != 0)
        own.apart[c] = static_cast<std::uint8_t>(own.reached & ~together[c] & (0xFFU << c));
  }
  return result;
}
constexpr auto kPatchCorners = patch_corners();

/// The vertices of a facet, ascending, 16 bits each.
std::uint64_t key_of(const complex::Hexahedron& cell, std::size_t facet) {
  std::array<std::uint64_t, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = cell[cells::kFacetVertices[facet][i]];
  std::sort(v.begin(), v.end());
  return v[0] << 48U | v[1] << 32U | v[2] << 16U | v[3];
}

}  // namespace

SubBall::Neighbours SubBall::neighbours_of(const complex::HexComplex& mesh) {
  Neighbours result(mesh.hexahedra.size());
  for (auto& own : result) own.fill(kOutside);
  const std::vector<complex::Facet> facets = complex::sorted_facets(mesh);
  for (std::size_t i = 0; i + 1 < facets.size(); ++i) {
    if (facets[i].key != facets[i + 1].key) continue;
    result[facets[i].cell][facets[i].facet] = facets[i + 1].cell;
    result[facets[i + 1].cell][facets[i + 1].facet] = facets[i].cell;
  }
  return result;
}

/// Where walks need it, most of a step's time would go into sorting.
std::optional<SubBall::Neighbours> SubBall::neighbours_if_complex(const complex::HexComplex& mesh,
                                                                  int quads) {
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t cell = 0, facet = 0;
    int hexahedra = 0;
  };
  std::size_t size = 64;
  while (size < 2 * cells::kCubeFacets * mesh.hexahedra.size()) size *= 2;
  std::vector<Slot> slots(size);
  Neighbours result(mesh.hexahedra.size());
  int in_one = 0;
  for (std::uint32_t c = 0; c < mesh.hexahedra.size(); ++c)
    for (std::uint32_t f = 0; f < cells::kCubeFacets; ++f) {
      result[c][f] = kOutside;
      const std::uint64_t key = key_of(mesh.hexahedra[c], f);
      std::size_t at = core::mixed(key) & (size - 1);
      while (slots[at].hexahedra > 0 && slots[at].key != key) at = (at + 1) & (size - 1);
      Slot& slot = slots[at];
      if (++slot.hexahedra == 1) {
        slot = {key, c, f, 1};
        ++in_one;
        continue;
      }
      if (slot.hexahedra > 2) return std::nullopt;
      --in_one;
      result[c][f] = slot.cell;
      result[slot.cell][slot.facet] = c;
    }
  if (in_one != quads) return std::nullopt;
  return result;
}

SubBall::SubBall(const complex::HexComplex& mesh, const Neighbours& neighbours, std::uint32_t first,
                 int max_quads)
    : mesh_(mesh), neighbours_(neighbours), max_quads_(max_quads) {
  core::expects(max_quads <= kMaxStateQuads, "the boundary of a ball has few quads");
  restart(first);
}

void SubBall::restart(std::uint32_t first) {
  forget_rim();
  for (auto* touched : {&cells_, &touching_}) {
    for (const std::uint32_t cell : *touched) {
      inside_[cell] = false;
      shared_[cell] = 0;
    }
    touched->clear();
  }
  for (const VertexId v : reached_) first_link_[v] = 0;
  reached_.clear();
  links_.clear();
  inside_.resize(std::max(inside_.size(), mesh_.hexahedra.size()));
  shared_.resize(inside_.size());
  first_link_.resize(std::max<std::size_t>(first_link_.size(), mesh_.vertices));
  quads_ = cells::kCubeFacets;
  take_in(first);
}

bool SubBall::are_related(VertexId u, VertexId v) const noexcept {
  for (std::uint32_t at = first_link_[u]; at != 0; at = links_[at - 1].next) {
    const complex::Hexahedron& cell = mesh_.hexahedra[links_[at - 1].cell];
    if (std::find(cell.begin(), cell.end(), v) != cell.end()) return true;
  }
  return false;
}

/// Condition (*) of docs/theory/proofs/front.md, section 1; a corner beyond the patch must be new.
bool SubBall::may_take_in(std::uint32_t cell, FacetSet patch) const noexcept {
  const PatchCorners& corners = kPatchCorners[patch.bits];
  if (!corners.is_patch) return false;
  const complex::Hexahedron& vertex = mesh_.hexahedra[cell];
  for (unsigned c = 0; c < cells::kCubeVertices; ++c)
    if ((corners.reached >> c & 1U) == 0 && first_link_[vertex[c]] != 0) return false;
  for (unsigned c = 0; c < cells::kCubeVertices; ++c)
    for (unsigned left = corners.apart[c]; left != 0; left &= left - 1)
      if (are_related(vertex[c], vertex[static_cast<std::size_t>(std::countr_zero(left))]))
        return false;
  return true;
}

bool SubBall::grow(std::uint32_t cell) {
  if (inside_[cell]) return false;
  FacetSet patch;
  for (unsigned f = 0; f < cells::kCubeFacets; ++f)
    if (neighbours_[cell][f] != kOutside && inside_[neighbours_[cell][f]])
      patch.bits = static_cast<std::uint8_t>(patch.bits | 1U << f);
  const int after = quads_ + 6 - 2 * patch.size();
  if (after < 6 || after > max_quads_ || !may_take_in(cell, patch)) return false;
  quads_ = after;
  take_in(cell);
  return true;
}

void SubBall::take_in(std::uint32_t cell) {
  rim_.is_current = false;
  inside_[cell] = true;
  cells_.push_back(cell);
  std::erase(touching_, cell);
  for (const std::uint32_t other : neighbours_[cell])
    if (other != kOutside && !inside_[other] && shared_[other]++ == 0) touching_.push_back(other);
  for (const VertexId v : mesh_.hexahedra[cell]) {
    if (first_link_[v] == 0) reached_.push_back(v);
    links_.push_back({cell, first_link_[v]});
    first_link_[v] = static_cast<std::uint32_t>(links_.size());
  }
}

const SubBall::Rim& SubBall::rim_now() const {
  if (!rim_.is_current) make_rim();
  return rim_;
}

void SubBall::forget_rim() const {
  for (std::size_t v = 0; v < static_cast<std::size_t>(rim_.vertices); ++v)
    rim_.at[rim_.vertex[v]] = kNewVertex;
  rim_.vertices = 0;
  rim_.is_current = false;
}

void SubBall::make_rim() const {
  constexpr std::size_t kVertices = kMaxStateQuads + 2;
  forget_rim();
  rim_.at.resize(std::max<std::size_t>(rim_.at.size(), mesh_.vertices), kNewVertex);
  std::array<Vertex, 4 * kMaxStateQuads> origin{};
  std::array<complex::Dart, 4 * kMaxStateQuads> twin{};
  std::array<std::array<complex::Dart, kVertices>, kVertices> dart_between{};
  std::size_t darts = 0;
  for (const std::uint32_t cell : cells_)
    for (unsigned f = 0; f < cells::kCubeFacets; ++f) {
      const std::uint32_t across = neighbours_[cell][f];
      if (across != kOutside && inside_[across]) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const VertexId v = mesh_.hexahedra[cell][cells::kFacetVertices[f][i]];
        if (rim_.at[v] == kNewVertex) {
          rim_.at[v] = static_cast<Vertex>(rim_.vertices);
          rim_.vertex[static_cast<std::size_t>(rim_.vertices++)] = v;
        }
        origin[darts + i] = rim_.at[v];
      }
      for (std::size_t i = 0; i < 4; ++i)
        dart_between[origin[darts + i]][origin[darts + (i + 1) % 4]] =
            static_cast<complex::Dart>(darts + i);
      darts += 4;
    }
  core::check_law([&] { return rim_.vertices == quads_ + 2; },
                  "the boundary of a ball is a sphere");
  for (std::size_t d = 0; d < darts; ++d) {
    const Vertex to = origin[complex::Quadrangulation::next(static_cast<complex::Dart>(d))];
    twin[d] = dart_between[to][origin[d]];
  }
  rim_.front.boundary = complex::Quadrangulation::from_darts({origin.data(), darts},
                                                             {twin.data(), darts}, rim_.vertices);
  std::fill_n(rim_.front.related.begin(), rim_.vertices, VertexSet{0});
  for (const std::uint32_t cell : cells_) relate_vertices_of(cell, rim_.front.related);
  rim_.is_current = true;
}

/// Relates those vertices of a hexahedron that are on the boundary of the ball.
void SubBall::relate_vertices_of(std::uint32_t cell, Relation& related) const {
  VertexSet own = 0;
  for (const VertexId v : mesh_.hexahedra[cell])
    if (rim_.at[v] != kNewVertex) own |= bit(rim_.at[v]);
  relate(own, related);
}

Relation SubBall::related_outside() const {
  (void)rim_now();
  Relation related{};
  for (std::uint32_t cell = 0; cell < mesh_.hexahedra.size(); ++cell)
    if (!inside_[cell]) relate_vertices_of(cell, related);
  return related;
}

Relation SubBall::related_outside(const CellsAt& cells_at) const {
  const Rim& now = rim_now();
  Relation related{};
  for (std::size_t v = 0; v < static_cast<std::size_t>(now.vertices); ++v)
    for (const std::uint32_t cell : cells_at[now.vertex[v]])
      if (!inside_[cell]) relate_vertices_of(cell, related);
  return related;
}

}  // namespace hexatlas::flips
