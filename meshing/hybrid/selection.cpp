#include "meshing/hybrid/selection.hpp"

#include <algorithm>
#include <tuple>

#include "enum/core/checks.hpp"
#include "meshing/hybrid/occupancy.hpp"
#include "meshing/quality/edge.hpp"

namespace hexatlas::hybrid {
namespace {

double volume(const TetGraph& graph, TetIndex t) {
  const auto points = graph.points();
  const mesh::Point& o = points[graph[t][0]];
  std::array<mesh::Point, 3> edge{};
  for (std::size_t i = 0; i < 3; ++i) {
    const mesh::Point& p = points[graph[t][i + 1]];
    edge[i] = {p.x - o.x, p.y - o.y, p.z - o.z};
  }
  return quality::determinant(edge[0], edge[1], edge[2]) / 6;
}

class Selector {
 public:
  Selector(const TetGraph& graph, const Candidates& candidates, const SelectionOptions& options)
      : candidates_(candidates), options_(options), occupancy_(graph.size()) {
    list_cells();
    weigh(graph);
    list_by_tetrahedron(graph.size());
  }

  std::vector<Cell> run() {
    for (const std::uint32_t name : by_quality_)
      if (const CellView cell = view(name); occupancy_.fits(cell)) put(name);
    for (int round = 0; round < options_.rounds; ++round)
      if (!exchange()) break;
    // An exchange frees edges and diagonals also where it does not look.
    for (const std::uint32_t name : by_quality_)
      if (is_in_[name] == 0 && occupancy_.fits(view(name))) put(name);
    std::vector<Cell> chosen;
    for (std::uint32_t name = 0; name < cells_.size(); ++name)
      if (is_in_[name] != 0) chosen.push_back(cells_[name]);
    return chosen;
  }

 private:
  using Names = std::vector<std::uint32_t>;  ///< of cells: places in cells_

  [[nodiscard]] CellView view(std::uint32_t name) const {
    return view_of(candidates_, cells_[name]);
  }
  void put(std::uint32_t name) {
    occupancy_.put(view(name), name);
    is_in_[name] = 1;
  }
  void take(std::uint32_t name) {
    occupancy_.take(view(name));
    is_in_[name] = 0;
  }

  void list_cells() {
    const auto add = [this](Shape shape, std::size_t count) {
      if (options_.factor[static_cast<std::size_t>(shape)] <= 0) return;
      for (std::size_t i = 0; i < count; ++i)
        cells_.push_back({shape, static_cast<std::uint32_t>(i)});
    };
    add(Shape::hexahedron, candidates_.hexahedra.cells.size());
    add(Shape::prism, candidates_.prisms.cells.size());
    add(Shape::pyramid, candidates_.pyramids.cells.size());
    core::expects(cells_.size() < Occupancy::kFree, "fewer than 2^32 - 1 candidates");
    is_in_.assign(cells_.size(), 0);
    by_quality_.resize(cells_.size());
    for (std::uint32_t name = 0; name < cells_.size(); ++name) by_quality_[name] = name;
    std::sort(by_quality_.begin(), by_quality_.end(), [this](std::uint32_t a, std::uint32_t b) {
      if (cells_[a].shape != cells_[b].shape) return cells_[a].shape < cells_[b].shape;
      const double one = view(a).quality;
      const double other = view(b).quality;
      return one != other ? one > other : a < b;
    });
  }

  void weigh(const TetGraph& graph) {
    weight_.reserve(cells_.size());
    for (const Cell cell : cells_) {
      double sum = 0;
      for (const TetIndex t : view_of(candidates_, cell).inner) sum += volume(graph, t);
      weight_.push_back(sum * options_.factor[static_cast<std::size_t>(cell.shape)]);
    }
  }

  /// In each row better weights first.
  void list_by_tetrahedron(std::size_t tetrahedra) {
    at_start_.assign(tetrahedra + 1, 0);
    for (const Cell cell : cells_)
      for (const TetIndex t : view_of(candidates_, cell).inner) ++at_start_[t + 1];
    for (std::size_t t = 0; t < tetrahedra; ++t) at_start_[t + 1] += at_start_[t];
    at_.resize(at_start_.back());
    std::vector<std::size_t> next(at_start_.begin(), at_start_.end() - 1);
    for (std::uint32_t name = 0; name < cells_.size(); ++name)
      for (const TetIndex t : view(name).inner) at_[next[t]++] = name;
  }

  [[nodiscard]] bool is_heavier(std::uint32_t a, std::uint32_t b) const {
    return std::tuple(-weight_[a], cells_[a].shape, a) <
           std::tuple(-weight_[b], cells_[b].shape, b);
  }

  /// The candidates that have a tetrahedron of the cell, the heaviest first.
  [[nodiscard]] Names rivals(std::uint32_t name) const {
    Names result;
    for (const TetIndex t : view(name).inner)
      for (std::size_t i = at_start_[t]; i < at_start_[t + 1]; ++i) result.push_back(at_[i]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    std::sort(result.begin(), result.end(),
              [this](std::uint32_t a, std::uint32_t b) { return is_heavier(a, b); });
    return result;
  }

  /// The cells in with a tetrahedron of this one.
  [[nodiscard]] Names owners(const CellView& cell) const {
    Names result;
    for (const TetIndex t : cell.inner)
      if (const std::uint32_t owner = occupancy_.owner(t); owner != Occupancy::kFree)
        if (std::find(result.begin(), result.end(), owner) == result.end()) result.push_back(owner);
    return result;
  }

  /// Takes `out` out, puts `in` in unless it is kFree, and fills up from what else fits there;
  /// undone unless the weight grows.
  bool try_exchange(const Names& out, std::uint32_t in) {
    double gain = 0;
    for (const std::uint32_t name : out) {
      take(name);
      gain -= weight_[name];
    }
    Names entered;
    const auto enter = [&](std::uint32_t name) {
      put(name);
      entered.push_back(name);
      gain += weight_[name];
    };
    bool is_possible = true;
    if (in != Occupancy::kFree) {
      is_possible = occupancy_.fits(view(in));
      if (is_possible) enter(in);
    }
    if (is_possible)
      for (const std::uint32_t name : out)
        for (const std::uint32_t rival : rivals(name))
          if (is_in_[rival] == 0 && rival != name && occupancy_.fits(view(rival))) enter(rival);
    if (is_possible && gain > kLeastGain * weight_[out.front()]) return true;
    for (const std::uint32_t name : entered) take(name);
    for (const std::uint32_t name : out) put(name);
    return false;
  }

  /// One round; false if nothing was gained.
  bool exchange() {
    bool is_better = false;
    for (const std::uint32_t name : by_quality_) {
      if (is_in_[name] != 0) {
        is_better = try_exchange({name}, Occupancy::kFree) || is_better;
        continue;
      }
      const Names out = owners(view(name));
      double lost = 0;
      for (const std::uint32_t owner : out) lost += weight_[owner];
      if (!out.empty() && lost < weight_[name]) is_better = try_exchange(out, name) || is_better;
    }
    return is_better;
  }

  /// Smaller gains may be rounding.
  static constexpr double kLeastGain = 1e-9;

  const Candidates& candidates_;
  SelectionOptions options_;
  Occupancy occupancy_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> is_in_;
  Names by_quality_;
  std::vector<double> weight_;
  std::vector<std::size_t> at_start_;
  Names at_;
};

}  // namespace

std::vector<Cell> selection(const TetGraph& graph, const Candidates& candidates,
                            const SelectionOptions& options) {
  core::expects(options.rounds >= 0, "a number of rounds");
  return Selector(graph, candidates, options).run();
}

}  // namespace hexatlas::hybrid
