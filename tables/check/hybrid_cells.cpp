#include "tables/check/hybrid_cells.hpp"

#include <algorithm>

#include "tables/check/exact.hpp"
#include "tables/check/incidence.hpp"
#include "tables/check/tetrahedron_facets.hpp"

namespace hexatlas::check {

namespace {

template <class Place, std::size_t kSize, std::size_t kCount>
constexpr std::array<FacetPlaces, kCount> facets_from(
    const std::array<std::array<Place, kSize>, kCount>& facets) {
  std::array<FacetPlaces, kCount> all{};
  for (std::size_t f = 0; f < kCount; ++f) {
    all[f].size = kSize;
    for (std::size_t i = 0; i < kSize; ++i) all[f].at[i] = static_cast<std::uint8_t>(facets[f][i]);
  }
  return all;
}

constexpr auto kTetrahedronFacets = facets_from(kFacets);
constexpr auto kHexahedronFacets = facets_from(kQuadCorners);
constexpr std::array<FacetPlaces, 5> kPrismFacets = {
    {{3, {0, 2, 1}}, {3, {3, 4, 5}}, {4, {0, 1, 4, 3}}, {4, {1, 2, 5, 4}}, {4, {2, 0, 3, 5}}}};
constexpr std::array<FacetPlaces, 5> kPyramidFacets = {
    {{4, {0, 3, 2, 1}}, {3, {0, 1, 4}}, {3, {1, 2, 4}}, {3, {2, 3, 4}}, {3, {3, 0, 4}}}};

std::vector<EdgePlaces> make_edges(CellShape shape) {
  std::vector<EdgePlaces> edges;
  for (const FacetPlaces& to : facets_of(shape)) {
    for (std::size_t i = 0; i < to.size; ++i) {
      const std::uint8_t v = to.at[i];
      const std::uint8_t w = to.at[(i + 1) % to.size];
      // The other facet at the edge goes through it from w to v.
      for (const FacetPlaces& from : facets_of(shape)) {
        for (std::size_t k = 0; k < from.size; ++k) {
          if (from.at[k] != w || from.at[(k + 1) % from.size] != v) continue;
          edges.push_back(
              {v, w, from.at[(k + 2) % from.size], to.at[(i + to.size - 1U) % to.size]});
        }
      }
    }
  }
  return edges;
}

mpz_class volume(const std::array<Vector<mpz_class>, 6>& p, std::size_t b, std::size_t c) {
  return determinant<mpz_class>(std::array<Vector<mpz_class>, 3>{
      difference(p[b], p[0]), difference(p[c], p[0]), difference(p[3], p[0])});
}

/// Along the edge from a to d of the prism a b c / d e f. With h = d - a the determinant is
/// det((1 - w)(b - a) + w (e - d), (1 - w)(c - a) + w (f - d), h), whose Bernstein coefficients
/// are, as multiples of h may be added to the other columns, the volumes of a b c d, half the sum
/// of those of a b f d and a e c d, and that of a e f d. If the first and the last one, x and z,
/// are positive, the least value on the edge is positive unless the middle one, y, is negative and
/// y^2 >= x z.
bool is_positive_along_edge(const std::array<const Point*, 6>& corners, Signs& signs) {
  const auto [a, b, c, d, e, f] = corners;
  if (signs.orientation(*a, *b, *c, *d) <= 0 || signs.orientation(*a, *e, *f, *d) <= 0) {
    return false;
  }
  if (signs.orientation(*a, *b, *f, *d) >= 0 && signs.orientation(*a, *e, *c, *d) >= 0) {
    return true;
  }
  const auto p = as_integers(corners);
  const mpz_class middle = volume(p, 1, 5) + volume(p, 4, 2);
  return middle >= 0 || middle * middle < 4 * volume(p, 1, 2) * volume(p, 4, 5);
}

JacobianSign sign_if(bool is_positive) {
  return is_positive ? JacobianSign::kPositive : JacobianSign::kNotPositive;
}

JacobianSign sign_of_prism(const std::array<const Point*, 6>& p, Signs& signs) {
  return sign_if(is_positive_along_edge(p, signs) &&
                 is_positive_along_edge({p[1], p[2], p[0], p[4], p[5], p[3]}, signs) &&
                 is_positive_along_edge({p[2], p[0], p[1], p[5], p[3], p[4]}, signs));
}

JacobianSign sign_of_pyramid(const std::array<const Point*, 5>& p, Signs& signs) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (signs.orientation(*p[i], *p[(i + 1) % 4], *p[(i + 3) % 4], *p[4]) <= 0) {
      return JacobianSign::kNotPositive;
    }
  }
  return JacobianSign::kPositive;
}

}  // namespace

std::span<const std::uint32_t> HybridCell::corners() const {
  constexpr std::array<std::size_t, 4> kCorners = {4, 8, 6, 5};
  return std::span(vertices).first(kCorners[static_cast<std::size_t>(shape)]);
}

std::span<const FacetPlaces> facets_of(CellShape shape) {
  switch (shape) {
    case CellShape::kTetrahedron:
      return kTetrahedronFacets;
    case CellShape::kHexahedron:
      return kHexahedronFacets;
    case CellShape::kPrism:
      return kPrismFacets;
    case CellShape::kPyramid:
      break;
  }
  return kPyramidFacets;
}

const std::vector<EdgePlaces>& edges_of(CellShape shape) {
  static const std::array<std::vector<EdgePlaces>, 4> kEdges = {
      make_edges(CellShape::kTetrahedron), make_edges(CellShape::kHexahedron),
      make_edges(CellShape::kPrism), make_edges(CellShape::kPyramid)};
  return kEdges[static_cast<std::size_t>(shape)];
}

std::vector<HybridCell> cells_of(const HybridMesh& mesh) {
  std::vector<HybridCell> cells;
  cells.reserve(mesh.tetrahedra.size() + mesh.hexahedra.size() + mesh.prisms.size() +
                mesh.pyramids.size());
  const auto add = [&cells](CellShape shape, const auto& list) {
    for (std::uint32_t number = 0; number < list.size(); ++number) {
      HybridCell& cell = cells.emplace_back(HybridCell{shape, number, {}});
      std::copy(list[number].begin(), list[number].end(), cell.vertices.begin());
    }
  };
  add(CellShape::kTetrahedron, mesh.tetrahedra);
  add(CellShape::kHexahedron, mesh.hexahedra);
  add(CellShape::kPrism, mesh.prisms);
  add(CellShape::kPyramid, mesh.pyramids);
  return cells;
}

std::string name_of(const HybridCell& cell) {
  constexpr std::array<const char*, 4> kNames = {"tetrahedron ", "hexahedron ", "prism ",
                                                 "pyramid "};
  return kNames[static_cast<std::size_t>(cell.shape)] + std::to_string(cell.number) + " " +
         listed(cell.corners());
}

JacobianSign jacobian_sign(const HybridCell& cell, const std::vector<Point>& points, Signs& signs) {
  std::array<const Point*, 8> p{};
  for (std::size_t i = 0; i < cell.corners().size(); ++i) p[i] = &points[cell.vertices[i]];
  switch (cell.shape) {
    case CellShape::kTetrahedron:
      return sign_if(signs.orientation(*p[0], *p[1], *p[2], *p[3]) > 0);
    case CellShape::kPrism:
      return sign_of_prism({p[0], p[1], p[2], p[3], p[4], p[5]}, signs);
    case CellShape::kPyramid:
      return sign_of_pyramid({p[0], p[1], p[2], p[3], p[4]}, signs);
    case CellShape::kHexahedron:
      break;
  }
  std::array<Point, 8> corners{};
  for (std::size_t i = 0; i < 8; ++i) corners[kCornerBits[i]] = *p[i];
  return jacobian_sign(corners);
}

}  // namespace hexatlas::check
