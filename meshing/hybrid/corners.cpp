#include "meshing/hybrid/corners.hpp"

#include <algorithm>
#include <utility>

#include "meshing/hybrid/blocks.hpp"
#include "meshing/quality/edge.hpp"
#include "meshing/quality/vector.hpp"

namespace hexatlas::hybrid {
namespace {

/// The third vertices of the triangles at each edge, ascending.
class Links {
 public:
  Links(const TetGraph& graph, int threads) : graph_(graph), start_(1, 0) {
    using Rows = std::pair<std::vector<std::uint32_t>, std::vector<Index>>;
    const auto blocks =
        in_blocks<Rows>(graph.points().size(), threads, [&](Index first, Index end, Rows& rows) {
          for (Index v = first; v < end; ++v) add_rows(v, rows);
        });
    start_.reserve(graph.directed_edges() + 1);
    for (const auto& [sizes, vertices] : blocks) {
      for (const std::uint32_t size : sizes) start_.push_back(start_.back() + size);
      vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    }
  }

  [[nodiscard]] std::span<const Index> of(Index v, Index w) const noexcept {
    const Index low = std::min(v, w);
    const std::size_t e = graph_.first_edge(low) + graph_.position(low, std::max(v, w));
    return std::span(vertices_).subspan(start_[e], start_[e + 1] - start_[e]);
  }

 private:
  /// A row for each neighbour of v; for lesser neighbours it is empty.
  void add_rows(Index v, std::pair<std::vector<std::uint32_t>, std::vector<Index>>& rows) const {
    auto& [sizes, vertices] = rows;
    std::vector<std::pair<Index, Index>> around;
    for (const TetIndex t : graph_.star(v))
      for (const Index w : graph_[t])
        if (w > v)
          for (const Index x : graph_[t])
            if (x != v && x != w) around.emplace_back(w, x);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    auto next = around.begin();
    for (const Index w : graph_.neighbours(v)) {
      const auto first = next;
      while (next != around.end() && next->first == w) vertices.push_back((next++)->second);
      sizes.push_back(static_cast<std::uint32_t>(next - first));
    }
  }

  const TetGraph& graph_;
  std::vector<std::size_t> start_;
  std::vector<Index> vertices_;
};

double squared_sine(const Direction& a, const Direction& b) {
  const mesh::Point normal = quality::cross(a, b);
  return quality::dot(normal, normal);
}

/// The corners at one vertex after another.
class Gatherer {
 public:
  Gatherer(const TetGraph& graph, const Links& links, const std::vector<Direction>& directions,
           double least_sine)
      : graph_(graph),
        links_(links),
        directions_(directions),
        least_squared_sine_(least_sine * least_sine),
        place_(graph.points().size()) {}

  /// Appends the corners at v, ascending, and how many there are for each first neighbour.
  void add(Index v, std::vector<std::uint32_t>& sizes, std::vector<Corner>& corners) {
    gather(v);
    const std::size_t degree = graph_.neighbours(v).size();
    sort_by(&Corner::y, degree);
    sort_by(&Corner::x, degree);
    const std::size_t row = sizes.size();
    sizes.resize(row + degree);
    for (auto first = found_.begin(); first != found_.end();) {
      auto last = first;
      while (last != found_.end() && last->x == first->x && last->y == first->y) ++last;
      std::sort(first, last);
      const auto end = std::unique(first, last);
      corners.insert(corners.end(), first, end);
      sizes[row + first->x] += static_cast<std::uint32_t>(end - first);
      first = last;
    }
  }

 private:
  /// All corners at v, some of them twice.
  void gather(Index v) {
    found_.clear();
    const auto neighbours = graph_.neighbours(v);
    for (std::uint32_t x = 0; x < neighbours.size(); ++x) place_[neighbours[x]] = x;
    for (std::uint32_t x = 0; x < neighbours.size(); ++x) {
      const auto link = links_.of(v, neighbours[x]);
      for (std::size_t i = 0; i < link.size(); ++i)
        for (std::size_t j = i + 1; j < link.size(); ++j)
          add_if_wide(v, place_[link[i]], place_[link[j]], neighbours[x]);
      for (const Index w : link)
        if (w > neighbours[x])
          for (const Index z : links_.of(neighbours[x], w))
            if (z != v) add_if_wide(v, x, place_[w], z);
    }
  }

  void add_if_wide(Index v, std::uint32_t x, std::uint32_t y, Index z) {
    const Direction* direction = &directions_[graph_.first_edge(v)];
    if (squared_sine(direction[x], direction[y]) >= least_squared_sine_)
      found_.push_back({x, y, z});
  }

  /// Sorts what was found by a position below `degree`, keeping the order of equal ones.
  void sort_by(std::uint32_t Corner::*key, std::size_t degree) {
    next_.assign(degree + 1, 0);
    for (const Corner& c : found_) ++next_[c.*key + 1];
    for (std::size_t i = 0; i < degree; ++i) next_[i + 1] += next_[i];
    sorted_.resize(found_.size());
    for (const Corner& c : found_) sorted_[next_[c.*key]++] = c;
    found_.swap(sorted_);
  }

  const TetGraph& graph_;
  const Links& links_;
  const std::vector<Direction>& directions_;
  double least_squared_sine_;
  std::vector<std::uint32_t> place_;  ///< of the neighbours of the last vertex, their positions
  std::vector<Corner> found_, sorted_;
  std::vector<std::size_t> next_;
};

}  // namespace

Corners::Corners(const TetGraph& graph, double least_sine, int threads)
    : graph_(&graph), start_(1, 0) {
  directions_.reserve(graph.directed_edges());
  for (Index v = 0; v < graph.points().size(); ++v)
    for (const Index w : graph.neighbours(v))
      directions_.push_back(quality::direction(graph.points()[v], graph.points()[w]));
  const Links links(graph, threads);
  using Rows = std::pair<std::vector<std::uint32_t>, std::vector<Corner>>;
  auto blocks =
      in_blocks<Rows>(graph.points().size(), threads, [&](Index first, Index end, Rows& rows) {
        Gatherer gatherer(graph, links, directions_, least_sine);
        for (Index v = first; v < end; ++v) gatherer.add(v, rows.first, rows.second);
      });
  start_.reserve(graph.directed_edges() + 1);
  for (auto& [sizes, corners] : blocks) {
    for (const std::uint32_t size : sizes) start_.push_back(start_.back() + size);
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    std::vector<Corner>().swap(corners);
  }
  make_tables();
}

void Corners::make_tables() {
  constexpr std::size_t kMostNeighbours = 64;
  const std::size_t vertices = graph_->points().size();
  table_start_.assign(vertices, kNoTable);
  for (Index v = 0; v < vertices; ++v) {
    const std::size_t degree = graph_->neighbours(v).size();
    const std::size_t row = graph_->first_edge(v);
    const std::size_t count = start_[row + degree] - start_[row];
    if (degree > kMostNeighbours || count > 0xFFFF) continue;
    table_start_[v] = table_.size();
    std::uint16_t next = 0;
    for (std::uint32_t x = 0; x < degree; ++x) {
      const auto corners = at(v, x);
      std::size_t i = 0;
      for (std::uint32_t y = 0; y < degree; ++y) {
        table_.push_back(next);
        for (; i < corners.size() && corners[i].y == y; ++i) ++next;
      }
    }
    table_.push_back(next);
  }
}

std::span<const Corner> Corners::search(Index v, std::uint32_t x, std::uint32_t y) const noexcept {
  const auto row = at(v, x);
  const auto first = std::lower_bound(row.begin(), row.end(), y,
                                      [](const Corner& c, std::uint32_t key) { return c.y < key; });
  auto last = first;
  while (last != row.end() && last->y == y) ++last;
  return {first, last};
}

}  // namespace hexatlas::hybrid
