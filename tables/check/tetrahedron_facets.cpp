#include "tables/check/tetrahedron_facets.hpp"

#include <algorithm>

namespace hexatlas::check {

namespace {

/// A facet whose least vertex is known: the two others, in ascending order, and whether they follow
/// it in this order.
struct Entry {
  std::uint64_t others = 0;
  FacetNumber facet = 0;
  bool ascending = false;
  bool operator<(const Entry& other) const {
    return others != other.others ? others < other.others : facet < other.facet;
  }
};

Entry entry_of(std::span<const Tetrahedron> cells, FacetNumber facet) {
  Triangle corners = facet_of(cells, facet);
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  const auto [low, high] = std::minmax(corners[1], corners[2]);
  return {std::uint64_t{low} << 32 | high, facet, corners[1] < corners[2]};
}

std::uint32_t least_of(const Triangle& corners) {
  return std::min({corners[0], corners[1], corners[2]});
}

/// The facets by their least vertices: those of vertex v are at start[v] .. start[v + 1] - 1.
struct Buckets {
  std::vector<FacetNumber> start;
  std::vector<FacetNumber> facets;
};

Buckets buckets_of(std::span<const Tetrahedron> cells, std::uint64_t vertex_count) {
  const auto facet_count = static_cast<FacetNumber>(4 * cells.size());
  Buckets buckets{std::vector<FacetNumber>(vertex_count + 2, 0),
                  std::vector<FacetNumber>(facet_count)};
  std::vector<FacetNumber>& start = buckets.start;
  for (FacetNumber f = 0; f < facet_count; ++f) ++start[least_of(facet_of(cells, f)) + 2];
  for (std::size_t v = 2; v < start.size(); ++v) start[v] += start[v - 1];
  // Each place goes to its end, which is the start of the next one.
  for (FacetNumber f = 0; f < facet_count; ++f) {
    buckets.facets[start[least_of(facet_of(cells, f)) + 1]++] = f;
  }
  start.pop_back();
  return buckets;
}

/// False at a fault.
bool match(std::span<const Entry> bucket, Facets& facets) {
  for (std::size_t i = 0, end = 0; i < bucket.size(); i = end) {
    while (end < bucket.size() && bucket[end].others == bucket[i].others) ++end;
    if (end - i > 2) {
      facets.crowded = bucket[i].facet;
      return false;
    }
    if (end - i == 1) {
      facets.boundary.push_back(bucket[i].facet);
    } else if (bucket[i].ascending == bucket[i + 1].ascending) {
      facets.same_way = bucket[i].facet;
      return false;
    } else {
      facets.interior.push_back({bucket[i].facet, bucket[i + 1].facet});
    }
  }
  return true;
}

}  // namespace

Triangle facet_of(std::span<const Tetrahedron> cells, FacetNumber facet) {
  const Tetrahedron& cell = cells[facet / 4];
  const auto& places = kFacets[facet % 4];
  return {cell[places[0]], cell[places[1]], cell[places[2]]};
}

Facets facets_of(std::span<const Tetrahedron> cells, std::uint64_t vertex_count) {
  const Buckets buckets = buckets_of(cells, vertex_count);
  Facets facets;
  facets.interior.reserve(2 * cells.size());
  std::vector<Entry> bucket;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    bucket.clear();
    for (FacetNumber i = buckets.start[v]; i < buckets.start[v + 1]; ++i) {
      bucket.push_back(entry_of(cells, buckets.facets[i]));
    }
    std::sort(bucket.begin(), bucket.end());
    if (!match(bucket, facets)) break;
  }
  return facets;
}

}  // namespace hexatlas::check
