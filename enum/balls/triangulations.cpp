#include "enum/balls/triangulations.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/search/depth_first.hpp"

namespace hexatlas::balls {
namespace {

using complex::Cell;
using complex::CutSurface;
using complex::Triangulation;
using complex::VertexMap;
using complex::VertexSet;

using Root = search::Root<FrontSearch::Choice>;
using Tetrahedra = std::vector<VertexSet>;

std::vector<VertexSet> triangle_sets(const CutSurface& surface) {
  std::vector<VertexSet> sets;
  sets.reserve(surface.triangles.size());
  for (const complex::OrientedTriangle& t : surface.triangles) sets.push_back(complex::set_of(t));
  std::sort(sets.begin(), sets.end());
  return sets;
}

/// A boundary triangulation, the number of its images, and the symmetries that fix it.
struct Boundary {
  CutSurface surface;
  std::uint64_t orbit_size = 0;
  std::vector<VertexMap> stabilizer;
};

std::vector<Boundary> boundaries_up_to_symmetry(const Cell& cell,
                                                const std::vector<VertexMap>& group) {
  std::vector<Boundary> result;
  std::set<std::vector<VertexSet>> seen;
  for (const CutSurface& surface : complex::cut_surfaces(cell)) {
    const std::vector<VertexSet> sets = triangle_sets(surface);
    if (seen.contains(sets)) continue;
    Boundary boundary{surface, 0, {}};
    for (const VertexMap& map : group) {
      std::vector<VertexSet> image = sets;
      for (VertexSet& set : image) set = complex::image_of(set, map);
      std::sort(image.begin(), image.end());
      if (image == sets) boundary.stabilizer.push_back(map);
      boundary.orbit_size += seen.insert(image).second ? 1 : 0;
    }
    result.push_back(std::move(boundary));
  }
  return result;
}

/// Each map followed by each permutation of the interior vertices.
std::vector<std::vector<VertexMap>> with_interior_permutations(const std::vector<VertexMap>& maps,
                                                               int first, int count) {
  std::vector<std::uint8_t> order(static_cast<std::size_t>(count));
  std::vector<std::vector<VertexMap>> result;
  for (const VertexMap& map : maps) {
    std::iota(order.begin(), order.end(), static_cast<std::uint8_t>(first));
    result.emplace_back();
    do {
      VertexMap with = map;
      std::copy(order.begin(), order.end(), with.begin() + first);
      result.back().push_back(with);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return result;
}

/// The least image under the maps, as an ascending list.
class LeastImage {
 public:
  const Tetrahedra& of(std::span<const VertexSet> tetrahedra, const std::vector<VertexMap>& maps) {
    least_.clear();
    for (const VertexMap& map : maps) {
      image_.clear();
      for (const VertexSet t : tetrahedra) image_.push_back(complex::image_of(t, map));
      std::sort(image_.begin(), image_.end());
      if (least_.empty() || image_ < least_) least_.swap(image_);
    }
    return least_;
  }

 private:
  Tetrahedra least_, image_;
};

/// What one part of the search found.
struct Part {
  std::map<std::size_t, ClassCounts> by_tetrahedra;
  std::vector<TriangulationClass> classes;
  std::uint64_t nodes = 0, not_balls = 0, undecided = 0;
  std::uint64_t met = 0;       ///< fillings, each counted orbit_size times
  std::uint64_t expected = 0;  ///< sum of the sizes of the classes, balls or not
  bool is_complete = false;
};

class Collector {
 public:
  Collector(const Cell& cell, const CensusOptions& options)
      : vertices_(cell.vertices + options.interior),
        keep_(options.keep_classes),
        group_(complex::symmetries(cell)),
        group_maps_(with_interior_permutations(group_, cell.vertices, options.interior)) {}

  [[nodiscard]] const std::vector<VertexMap>& group() const { return group_; }

  void collect(const Boundary& boundary, const std::vector<std::vector<VertexMap>>& stabilizer,
               std::span<const VertexSet> filling, Part& part) const {
    part.met += boundary.orbit_size;
    LeastImage scratch;
    const Tetrahedra own = scratch.of(filling, stabilizer.front());
    std::uint64_t automorphisms = 1;
    for (std::size_t g = 1; g < stabilizer.size(); ++g) {
      const Tetrahedra& other = scratch.of(filling, stabilizer[g]);
      if (other < own) return;
      if (other == own) ++automorphisms;
    }
    const std::uint64_t size = group_.size() / automorphisms;
    part.expected += size;
    const Triangulation representative{vertices_, own};
    switch (complex::topology_of(representative)) {
      case complex::Topology::ball:
        break;
      case complex::Topology::undecided:
        ++part.undecided;
        return;
      default:
        ++part.not_balls;
        return;
    }
    part.by_tetrahedra[own.size()] += {1, size};
    if (keep_) part.classes.push_back({canonical(representative), automorphisms});
  }

 private:
  [[nodiscard]] Triangulation canonical(const Triangulation& triangulation) const {
    Triangulation least = triangulation;
    LeastImage scratch;
    for (const auto& maps : group_maps_)
      least.tetrahedra = std::min(least.tetrahedra, scratch.of(triangulation.tetrahedra, maps));
    return least;
  }

  int vertices_;
  bool keep_;
  std::vector<VertexMap> group_;
  std::vector<std::vector<VertexMap>> group_maps_;
};

struct Task {
  std::size_t boundary;
  Root root;
};

class Run {
 public:
  Run(const Cell& cell, const CensusOptions& options)
      : cell_(cell),
        options_(options),
        collector_(cell, options),
        boundaries_(boundaries_up_to_symmetry(cell, collector_.group())) {
    if (!options.boundary_tetrahedra)
      for (const complex::CellFacet& facet : cell.facets)
        if (facet.size == 4) forbidden_.push_back(facet.vertices());
    for (const Boundary& boundary : boundaries_)
      stabilizers_.push_back(
          with_interior_permutations(boundary.stabilizer, cell.vertices, options.interior));
  }

  Census census() {
    Part shallow;
    shallow.is_complete = true;
    std::vector<Task> tasks;
    std::uint64_t left = options_.max_nodes;
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      for (Root& root : split(b, left, shallow)) tasks.push_back({b, std::move(root)});
    std::vector<Part> parts(tasks.size());
    const std::uint64_t each = left / std::max<std::size_t>(1, tasks.size());
    const std::uint64_t more = left % std::max<std::size_t>(1, tasks.size());
    parallel::parallel_for(options_.threads, tasks.size(), [&](std::size_t i) {
      run(tasks[i], each + (i < more ? 1 : 0), parts[i]);
      report(tasks.size());
    });
    parts.push_back(std::move(shallow));
    return merged(parts);
  }

 private:
  /// Deep enough for some thousand tasks on the hexahedron, which balances two or many threads.
  static constexpr std::size_t kSplitDepth = 3;
  /// Nodes between looks at the request to stop: a fraction of a second.
  static constexpr std::uint64_t kSlice = 100'000;

  [[nodiscard]] bool is_stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  [[nodiscard]] FrontSearch problem_of(std::size_t b) const {
    return FrontSearch(boundaries_[b].surface.triangles, cell_.vertices, options_.interior,
                       forbidden_, options_.prunings);
  }

  search::Exploration<FrontSearch::Choice> explore(FrontSearch& problem, std::size_t b,
                                                   const Root& root, search::Budget budget,
                                                   Part& part) const {
    auto result = search::explore(problem, root, budget, [&](const FrontSearch& found) {
      collector_.collect(boundaries_[b], stabilizers_[b], found.tetrahedra(), part);
      return !is_stopped();
    });
    part.nodes += result.counts.nodes;
    return result;
  }

  /// The top of the search for one boundary; what is left. Takes its nodes from `left`.
  std::vector<Root> split(std::size_t b, std::uint64_t& left, Part& part) const {
    if (left == 0 || is_stopped()) return {Root{}};
    FrontSearch problem = problem_of(b);
    auto result = explore(problem, b, {}, {.nodes = left, .depth = kSplitDepth}, part);
    left -= std::min(left, result.counts.nodes);
    return std::move(result.unexplored);
  }

  /// Explores a task in slices, until it is done, `nodes` are spent, or a stop is requested.
  void run(const Task& task, std::uint64_t nodes, Part& part) const {
    if (nodes == 0 || is_stopped()) return;
    FrontSearch problem = problem_of(task.boundary);
    std::vector<Root> pending{task.root};  // the next one last
    while (!pending.empty() && nodes > 0 && !is_stopped()) {
      const Root root = std::move(pending.back());
      pending.pop_back();
      auto result = explore(problem, task.boundary, root, {.nodes = std::min(nodes, kSlice)}, part);
      nodes -= std::min(nodes, result.counts.nodes);
      std::move(result.unexplored.rbegin(), result.unexplored.rend(), std::back_inserter(pending));
    }
    part.is_complete = pending.empty();
  }

  void report(std::size_t all) {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    options_.progress(++done_, all);
  }

  [[nodiscard]] Census merged(std::vector<Part>& parts) const {
    Census census;
    census.symmetries = collector_.group().size();
    std::uint64_t met = 0, expected = 0;
    bool is_complete = true;
    for (Part& part : parts) {
      for (const auto& [size, counts] : part.by_tetrahedra) census.by_tetrahedra[size] += counts;
      std::move(part.classes.begin(), part.classes.end(), std::back_inserter(census.classes));
      census.nodes += part.nodes;
      census.not_balls += part.not_balls;
      census.undecided += part.undecided;
      met += part.met;
      expected += part.expected;
      is_complete = is_complete && part.is_complete;
    }
    std::sort(census.classes.begin(), census.classes.end(), [](const auto& a, const auto& b) {
      const auto key = [](const TriangulationClass& c) {
        return std::pair(c.canonical.tetrahedra.size(), std::cref(c.canonical.tetrahedra));
      };
      return key(a).first != key(b).first ? key(a).first < key(b).first
                                          : key(a).second.get() < key(b).second.get();
    });
    core::ensures(!is_complete || met == expected,
                  "the labelled fillings are as many as the sizes of the classes add up to");
    census.exhaustive = is_complete && census.undecided == 0;
    return census;
  }

  const Cell& cell_;
  const CensusOptions& options_;
  Collector collector_;
  std::vector<Boundary> boundaries_;
  std::vector<std::vector<std::vector<VertexMap>>> stabilizers_;
  std::vector<VertexSet> forbidden_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace

ClassCounts Census::total() const {
  ClassCounts sum;
  for (const auto& [size, counts] : by_tetrahedra) sum += counts;
  return sum;
}

Census triangulations(const Cell& cell, const CensusOptions& options) {
  core::expects(options.interior >= 0 && options.interior <= kMaxInterior &&
                    cell.vertices + options.interior <= complex::kMaxTriangulationVertices,
                "triangulations: too many interior vertices");
  return Run(cell, options).census();
}

}  // namespace hexatlas::balls
