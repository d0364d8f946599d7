#include "tables/check/cell_laws.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "tables/check/disjoint_sets.hpp"

namespace hexatlas::check {

namespace {

/// The facet on the left of each directed edge, and the place of its first vertex there.
struct Side {
  std::size_t facet = 0;
  std::size_t place = 0;
};
using Sides = std::map<std::pair<std::uint8_t, std::uint8_t>, Side>;

std::uint8_t at(const CellFacet& facet, std::size_t place) { return facet[place % facet.size()]; }

/// nullopt if an edge is traversed twice in the same direction.
std::optional<Sides> sides_of(const std::vector<CellFacet>& facets) {
  Sides sides;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t i = 0; i < facets[f].size(); ++i) {
      if (!sides.try_emplace({facets[f][i], at(facets[f], i + 1)}, Side{f, i}).second) {
        return std::nullopt;
      }
    }
  }
  return sides;
}

/// The same number for all ways to write the cycle, a different one for each other cycle.
std::uint32_t oriented(CellFacet facet) {
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  std::uint32_t digits = 1;
  for (const std::uint8_t v : facet) digits = 16 * digits + v;
  return digits;
}

/// Tries to extend the map of the first facet onto `target`, whose vertices are the images in
/// order, from facet to facet. The image of a facet in the other direction is a mirror image.
class Extension {
 public:
  Extension(const std::vector<CellFacet>& facets, const Sides& sides)
      : facets_(facets), sides_(sides) {}

  std::optional<VertexPermutation> from(const CellFacet& target, bool is_mirrored) {
    map_.fill(kUnknown);
    is_mirrored_ = is_mirrored;
    std::vector<bool> seen(facets_.size(), false);
    std::vector<std::size_t> queue = {0};
    seen[0] = true;
    if (!assign(facets_[0], target)) return std::nullopt;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const CellFacet& facet = facets_[queue[head]];
      for (std::size_t i = 0; i < facet.size(); ++i) {
        const Side next = sides_.at({at(facet, i + 1), facet[i]});
        if (!assign_across(next)) return std::nullopt;
        if (!seen[next.facet]) queue.push_back(next.facet);
        seen[next.facet] = true;
      }
    }
    return is_permutation() ? std::optional(map_with_fixed_rest()) : std::nullopt;
  }

 private:
  static constexpr std::uint8_t kUnknown = 0xFF;

  bool assign(const CellFacet& facet, const CellFacet& target) {
    if (facet.size() != target.size()) return false;
    for (std::size_t i = 0; i < facet.size(); ++i) {
      std::uint8_t& image = map_[facet[i]];
      if (image != kUnknown && image != target[i]) return false;
      image = target[i];
    }
    return true;
  }

  /// Maps the facet of `side`, two consecutive vertices of which have images.
  bool assign_across(const Side& side) {
    const CellFacet& facet = facets_[side.facet];
    CellFacet source(facet.size());
    CellFacet target(facet.size());
    const std::uint8_t first = map_[facet[side.place]];
    const std::uint8_t second = map_[at(facet, side.place + 1)];
    const auto found =
        sides_.find(is_mirrored_ ? std::pair(second, first) : std::pair(first, second));
    if (found == sides_.end()) return false;
    const CellFacet& other = facets_[found->second.facet];
    if (other.size() != facet.size()) return false;
    for (std::size_t i = 0; i < facet.size(); ++i) {
      source[i] = at(facet, side.place + i);
      const std::size_t back = found->second.place + 1 + other.size() - i;
      target[i] = at(other, is_mirrored_ ? back : found->second.place + i);
    }
    return assign(source, target);
  }

  [[nodiscard]] bool is_permutation() const {
    std::set<std::uint8_t> images;
    std::size_t mapped = 0;
    for (const std::uint8_t image : map_) {
      if (image == kUnknown) continue;
      images.insert(image);
      ++mapped;
    }
    return images.size() == mapped;
  }

  [[nodiscard]] VertexPermutation map_with_fixed_rest() const {
    VertexPermutation result = map_;
    for (std::size_t v = 0; v < result.size(); ++v) {
      if (result[v] == kUnknown) result[v] = static_cast<std::uint8_t>(v);
    }
    return result;
  }

  const std::vector<CellFacet>& facets_;
  const Sides& sides_;
  VertexPermutation map_{};
  bool is_mirrored_ = false;
};

std::vector<CellFacet> cube_facets() {
  return {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
}

std::set<std::uint32_t> cycles_of(const std::vector<CellFacet>& facets) {
  std::set<std::uint32_t> cycles;
  for (const CellFacet& facet : facets) cycles.insert(oriented(facet));
  return cycles;
}

/// Numbers of facets with three and four vertices, and the degrees, which determine these cells.
struct KnownCell {
  std::string_view name;
  std::size_t triangles;
  std::size_t quads;
  std::vector<std::size_t> degrees;  ///< ascending
};

const std::vector<KnownCell>& known_cells() {
  static const std::vector<KnownCell> cells = {
      {"tetrahedron", 4, 0, {3, 3, 3, 3}},
      {"pyramid", 4, 1, {3, 3, 3, 3, 4}},
      {"prism", 2, 3, {3, 3, 3, 3, 3, 3}},
      {"octahedron", 8, 0, {4, 4, 4, 4, 4, 4}},
  };
  return cells;
}

}  // namespace

VertexBits bits_of(const CellFacet& vertices) noexcept {
  unsigned bits = 0;
  for (const std::uint8_t v : vertices) bits |= 1U << v;
  return static_cast<VertexBits>(bits);
}

VertexBits image_of(VertexBits set, const VertexPermutation& map) noexcept {
  unsigned image = 0;
  for (unsigned rest = set; rest != 0; rest &= rest - 1) image |= 1U << map[std::countr_zero(rest)];
  return static_cast<VertexBits>(image);
}

std::string broken_cell_law(const std::vector<CellFacet>& facets, int boundary_vertices) {
  if (facets.size() < 4) return "the cell has less than four facets";
  unsigned used = 0;
  for (const CellFacet& facet : facets) {
    if (std::popcount(bits_of(facet)) != static_cast<int>(facet.size())) {
      return "a facet has a vertex twice";
    }
    used |= bits_of(facet);
  }
  if (std::popcount(used) != boundary_vertices) return "a vertex is on no facet and not interior";
  const std::optional<Sides> sides = sides_of(facets);
  if (!sides) return "an edge occurs twice in the same direction";
  DisjointSets parts(facets.size());
  for (const auto& [edge, side] : *sides) {
    const auto across = sides->find({edge.second, edge.first});
    if (across == sides->end()) return "an edge has a facet on one side only";
    parts.unite(side.facet, across->second.facet);
  }
  if (parts.sets() != 1) return "the cell is not connected";
  const std::size_t edges = sides->size() / 2;
  if (static_cast<std::size_t>(boundary_vertices) + facets.size() != edges + 2) {
    return "the Euler characteristic of the cell is not 2";
  }
  return {};
}

bool is_cell_of_name(const std::string& name, const std::vector<CellFacet>& facets,
                     int boundary_vertices) {
  if (name == "hexahedron") return cycles_of(facets) == cycles_of(cube_facets());
  std::vector<std::size_t> degrees(static_cast<std::size_t>(boundary_vertices), 0);
  std::size_t triangles = 0;
  for (const CellFacet& facet : facets) {
    triangles += facet.size() == 3 ? 1 : 0;
    for (const std::uint8_t v : facet) ++degrees[v];
  }
  std::sort(degrees.begin(), degrees.end());
  return std::all_of(known_cells().begin(), known_cells().end(), [&](const KnownCell& cell) {
    return cell.name != name || (cell.triangles == triangles && cell.degrees == degrees &&
                                 cell.quads == facets.size() - triangles);
  });
}

std::vector<VertexPermutation> symmetries_of(const std::vector<CellFacet>& facets) {
  const Sides sides = sides_of(facets).value();
  Extension extension(facets, sides);
  std::set<VertexPermutation> found;
  const auto try_image = [&](const CellFacet& target, bool is_mirrored) {
    const auto map = extension.from(target, is_mirrored);
    if (map) found.insert(*map);
  };
  for (CellFacet target : facets) {
    for (std::size_t turn = 0; turn < target.size(); ++turn) {
      std::rotate(target.begin(), target.begin() + 1, target.end());
      try_image(target, false);
      try_image({target.rbegin(), target.rend()}, true);
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace hexatlas::check
