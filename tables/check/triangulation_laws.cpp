#include "tables/check/triangulation_laws.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "tables/check/cell_laws.hpp"

namespace hexatlas::check {

namespace {

/// A triangle of a tetrahedron, by which the triangles in two of them are found.
struct TriangleUse {
  VertexBits triangle = 0;
  std::size_t tetrahedron = 0;
};

/// By triangle, equal ones in the order of the tetrahedra.
std::vector<TriangleUse> sorted_triangles(const Tetrahedra& tetrahedra) {
  std::vector<TriangleUse> uses;
  uses.reserve(4 * tetrahedra.size());
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    for (unsigned rest = tetrahedra[t]; rest != 0; rest &= rest - 1) {
      const unsigned vertex = rest & (0U - rest);
      uses.push_back({static_cast<VertexBits>(tetrahedra[t] & ~vertex), t});
    }
  }
  std::stable_sort(uses.begin(), uses.end(), [](const TriangleUse& a, const TriangleUse& b) {
    return a.triangle < b.triangle;
  });
  return uses;
}

/// (-1)^i, where the vertex opposite to the triangle is the i-th of the tetrahedron from 0.
int side_of(VertexBits tetrahedron, VertexBits triangle) {
  const unsigned vertex = tetrahedron & ~unsigned{triangle};
  return std::popcount(tetrahedron & (vertex - 1U)) % 2 == 0 ? 1 : -1;
}

std::string in_words(VertexBits set, const char* what) {
  return std::string(what) + " " + digits_of(set);
}

}  // namespace

std::string digits_of(VertexBits set) {
  std::string digits;
  for (unsigned rest = set; rest != 0; rest &= rest - 1) {
    digits += "0123456789abcdef"[std::countr_zero(rest)];
  }
  return digits;
}

int parity_of(const std::array<std::uint8_t, 4>& points) noexcept {
  int parity = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (points[i] > points[j]) parity = -parity;
    }
  }
  return parity;
}

CatalogueFinding check_triangles(const Tetrahedra& tetrahedra) {
  Tetrahedra sorted = tetrahedra;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    return BrokenLaw{CatalogueLaw::kTriangles,
                     in_words(*twice, "tetrahedron") + " is listed twice"};
  }
  const std::vector<TriangleUse> uses = sorted_triangles(tetrahedra);
  for (std::size_t i = 0; i + 2 < uses.size(); ++i) {
    if (uses[i].triangle == uses[i + 2].triangle) {
      return BrokenLaw{CatalogueLaw::kTriangles,
                       in_words(uses[i].triangle, "triangle") + " lies in three tetrahedra"};
    }
  }
  return std::nullopt;
}

CatalogueFinding check_vertices(const Tetrahedra& tetrahedra, int vertices) {
  unsigned used = 0;
  for (const VertexBits tetrahedron : tetrahedra) used |= tetrahedron;
  const unsigned missing = ~used & ((1U << static_cast<unsigned>(vertices)) - 1U);
  if (missing == 0) return std::nullopt;
  return BrokenLaw{CatalogueLaw::kVertices,
                   in_words(static_cast<VertexBits>(missing & (0U - missing)), "vertex") +
                       " is in no tetrahedron"};
}

std::vector<VertexBits> boundary_triangles(const Tetrahedra& tetrahedra) {
  const std::vector<TriangleUse> uses = sorted_triangles(tetrahedra);
  std::vector<VertexBits> boundary;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const bool before = i > 0 && uses[i - 1].triangle == uses[i].triangle;
    const bool after = i + 1 < uses.size() && uses[i + 1].triangle == uses[i].triangle;
    if (!before && !after) boundary.push_back(uses[i].triangle);
  }
  return boundary;
}

CatalogueFinding check_boundary(const Tetrahedra& tetrahedra, const std::vector<CellFacet>& facets,
                                OutwardTriangle& outward) {
  const std::vector<VertexBits> boundary = boundary_triangles(tetrahedra);
  std::vector<VertexBits> wanted;
  const auto take = [&](const OutwardTriangle& triangle) {
    const VertexBits bits = bits_of({triangle.begin(), triangle.end()});
    if (!std::binary_search(boundary.begin(), boundary.end(), bits)) return false;
    wanted.push_back(bits);
    outward = triangle;
    return true;
  };
  for (const CellFacet& f : facets) {
    if (f.size() == 3) {
      if (take({f[0], f[1], f[2]})) continue;
      return BrokenLaw{CatalogueLaw::kBoundary,
                       in_words(bits_of(f), "facet") + " is no boundary triangle"};
    }
    const std::size_t before = wanted.size();
    if (take({f[0], f[1], f[2]}) && take({f[0], f[2], f[3]})) continue;
    wanted.resize(before);
    if (take({f[0], f[1], f[3]}) && take({f[1], f[2], f[3]})) continue;
    return BrokenLaw{CatalogueLaw::kBoundary,
                     in_words(bits_of(f), "quad") + " is not cut by one of its diagonals"};
  }
  std::sort(wanted.begin(), wanted.end());
  if (wanted == boundary) return std::nullopt;
  return BrokenLaw{CatalogueLaw::kBoundary, "the boundary triangles are not those of the facets"};
}

CatalogueFinding check_boundary_tetrahedra(const Tetrahedra& tetrahedra,
                                           const std::vector<CellFacet>& facets) {
  for (const CellFacet& facet : facets) {
    if (std::find(tetrahedra.begin(), tetrahedra.end(), bits_of(facet)) != tetrahedra.end()) {
      return BrokenLaw{CatalogueLaw::kBoundaryTetrahedra,
                       in_words(bits_of(facet), "tetrahedron") + " has its vertices on one facet"};
    }
  }
  return std::nullopt;
}

std::vector<int> coherent_signs(const Tetrahedra& tetrahedra) {
  const std::vector<TriangleUse> uses = sorted_triangles(tetrahedra);
  std::vector<std::vector<std::pair<std::size_t, int>>> neighbours(tetrahedra.size());
  for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
    const VertexBits triangle = uses[i].triangle;
    if (triangle != uses[i + 1].triangle) continue;
    const std::size_t s = uses[i].tetrahedron;
    const std::size_t t = uses[i + 1].tetrahedron;
    const int factor = -side_of(tetrahedra[s], triangle) * side_of(tetrahedra[t], triangle);
    neighbours[s].emplace_back(t, factor);
    neighbours[t].emplace_back(s, factor);
  }
  std::vector<int> signs(tetrahedra.size(), 0);
  std::vector<std::size_t> queue = {0};
  signs[0] = 1;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const auto& [next, factor] : neighbours[queue[head]]) {
      if (signs[next] != 0) continue;
      signs[next] = factor * signs[queue[head]];
      queue.push_back(next);
    }
  }
  return signs;
}

std::vector<int> coherent_signs(const Tetrahedra& tetrahedra, const OutwardTriangle& outward) {
  const VertexBits triangle = bits_of({outward.begin(), outward.end()});
  std::vector<int> signs = coherent_signs(tetrahedra);
  const auto owner =
      std::find_if(tetrahedra.begin(), tetrahedra.end(),
                   [&](VertexBits tetrahedron) { return (triangle & ~tetrahedron) == 0; });
  const auto fourth = static_cast<std::uint8_t>(std::countr_zero(*owner & ~unsigned{triangle}));
  const int wanted = -parity_of({outward[0], outward[1], outward[2], fourth});
  if (signs[static_cast<std::size_t>(owner - tetrahedra.begin())] != wanted) {
    for (int& sign : signs) sign = -sign;
  }
  return signs;
}

}  // namespace hexatlas::check
