#include "meshing/hybrid/lattice_tets.hpp"

#include <algorithm>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::hybrid {
namespace {

using Index = mesh::Index;

/// The vertices of a facet, ascending, and whose it is: 4 t + the vertex opposite to it.
struct OwnedFacet {
  std::array<Index, 3> vertices{};
  std::uint32_t owner = 0;
};

OwnedFacet owned_facet(const FlippedTets::Tetrahedron& tetrahedron, std::uint32_t t,
                       std::size_t facet) {
  OwnedFacet result{{}, static_cast<std::uint32_t>(4 * t + facet)};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != facet) result.vertices[count++] = tetrahedron[i];
  std::sort(result.vertices.begin(), result.vertices.end());
  return result;
}

bool comes_before(const OwnedFacet& a, const OwnedFacet& b) { return a.vertices < b.vertices; }

}  // namespace

FlippedTets::FlippedTets(std::span<const mesh::Point> points, std::vector<Tetrahedron> tetrahedra)
    : points_(points), tetrahedra_(std::move(tetrahedra)), at_(points.size(), kOutside) {
  core::expects(tetrahedra_.size() < (std::size_t{1} << 30U), "fewer than 2^30 tetrahedra");
  for (TetIndex t = 0; t < tetrahedra_.size(); ++t)
    for (const Index v : tetrahedra_[t]) at_[v] = t;
  seen_.assign(tetrahedra_.size(), 0);
  glue();
}

void FlippedTets::glue() {
  std::vector<OwnedFacet> facets;
  facets.reserve(4 * tetrahedra_.size());
  for (TetIndex t = 0; t < tetrahedra_.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) facets.push_back(owned_facet(tetrahedra_[t], t, i));
  std::sort(facets.begin(), facets.end(), comes_before);
  across_.assign(4 * tetrahedra_.size(), kOutside);
  for (std::size_t i = 1; i < facets.size(); ++i) {
    if (facets[i].vertices != facets[i - 1].vertices) continue;
    across_[facets[i].owner] = facets[i - 1].owner / 4;
    across_[facets[i - 1].owner] = facets[i].owner / 4;
  }
}

exact::Sign FlippedTets::orientation(Index a, Index b, Index c, Index d) const {
  const auto at = [this](Index v) {
    const mesh::Point& p = points_[v];
    return exact::Point3{p.x, p.y, p.z};
  };
  return exact::sign_of_orientation(at(a), at(b), at(c), at(d));
}

std::span<const FlippedTets::TetIndex> FlippedTets::star(Index v) const {
  ++question_;
  found_.assign(1, at_[v]);
  seen_[at_[v]] = question_;
  for (std::size_t next = 0; next < found_.size(); ++next) {
    const TetIndex t = found_[next];
    for (std::size_t i = 0; i < 4; ++i) {
      const TetIndex beyond = across(t, i);
      if (tetrahedra_[t][i] == v || beyond == kOutside || seen_[beyond] == question_) continue;
      seen_[beyond] = question_;
      found_.push_back(beyond);
    }
  }
  return found_;
}

std::optional<FlippedTets::TetIndex> FlippedTets::with(std::span<const Index> vertices) const {
  for (const TetIndex t : star(vertices.front()))
    if (std::all_of(vertices.begin(), vertices.end(),
                    [&](Index v) { return place_of(tetrahedra_[t], v) < 4; }))
      return t;
  return std::nullopt;
}

std::optional<FlippedTets::Ring> FlippedTets::ring(Index a, Index b, TetIndex at) const {
  // With the vertices a b c d of a right-handed tetrahedron in an even order, d follows c.
  std::array<Index, 2> others{};
  std::size_t count = 0;
  for (const Index v : tetrahedra_[at])
    if (v != a && v != b) others[count++] = v;
  if (orientation(a, b, others[0], others[1]) == exact::Sign::negative)
    std::swap(others[0], others[1]);
  Ring result;
  const Index first = others[0];
  Index last = first;
  Index next = others[1];
  for (TetIndex t = at;;) {
    result.tetrahedra.push_back(t);
    result.vertices.push_back(last);
    t = across(t, place_of(tetrahedra_[t], last));
    if (t == kOutside) return std::nullopt;
    if (next == first) return result;
    Index after = next;
    for (const Index v : tetrahedra_[t])
      if (v != a && v != b && v != next) after = v;
    last = std::exchange(next, after);
  }
}

void FlippedTets::replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh) {
  struct Open {
    OwnedFacet facet;
    bool is_outside;
  };
  std::vector<Open> open;
  for (const TetIndex t : old)
    for (std::size_t i = 0; i < 4; ++i) {
      const TetIndex beyond = across(t, i);
      if (std::find(old.begin(), old.end(), beyond) != old.end()) continue;
      OwnedFacet facet = owned_facet(tetrahedra_[t], t, i);
      if (beyond != kOutside)
        for (std::size_t j = 0; j < 4; ++j)
          if (across(beyond, j) == t &&
              owned_facet(tetrahedra_[beyond], beyond, j).vertices == facet.vertices)
            facet.owner = static_cast<std::uint32_t>(4 * beyond + j);
      open.push_back({facet, beyond == kOutside});
    }
  for (const TetIndex t : old) tetrahedra_[t] = {kGone, kGone, kGone, kGone};
  for (const Tetrahedron& vertices : fresh) {
    const auto t = static_cast<TetIndex>(tetrahedra_.size());
    tetrahedra_.push_back(vertices);
    across_.insert(across_.end(), 4, kOutside);
    seen_.push_back(0);
    for (const Index v : vertices) at_[v] = t;
    for (std::size_t i = 0; i < 4; ++i) {
      const OwnedFacet facet = owned_facet(vertices, t, i);
      const auto same = std::find_if(open.begin(), open.end(), [&](const Open& o) {
        return o.facet.vertices == facet.vertices;
      });
      if (same == open.end()) {
        open.push_back({facet, false});
        continue;
      }
      if (!same->is_outside) {
        across_[facet.owner] = same->facet.owner / 4;
        across_[same->facet.owner] = t;
      }
      open.erase(same);
    }
  }
  core::ensures(open.empty(), "tetrahedra are replaced by such with the same boundary");
}

}  // namespace hexatlas::hybrid
