#include "meshing/hybrid/selection.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "enum/core/checks.hpp"
#include "meshing/hybrid/occupancy.hpp"
#include "meshing/quality/report.hpp"
#include "meshing/quality/volume.hpp"

namespace hexatlas::hybrid {
namespace {

double volume(const TetGraph& graph, TetIndex t) {
  return quality::volume(quality::corners_of(graph.points(), graph[t]));
}

class Selector {
 public:
  Selector(const TetGraph& graph, const Candidates& candidates, SelectionOptions options)
      : graph_(graph),
        candidates_(candidates),
        options_(std::move(options)),
        occupancy_(graph.size()) {
    list_cells();
    sort_by_weight();
    sort_by_quality();
    list_by_tetrahedron(graph.size());
  }

  std::vector<Cell> run() {
    for (const std::uint32_t name : by_quality_)
      if (const CellView cell = view(name); occupancy_.fits(cell)) put(name);
    for (int round = 0; round < options_.rounds; ++round)
      if (!exchange(static_cast<std::size_t>(round))) break;
    // An exchange frees edges and diagonals also where it does not look.
    for (const std::uint32_t name : by_quality_)
      if (is_in_[name] == 0 && occupancy_.fits(view(name))) put(name);
    std::vector<Cell> chosen;
    for (std::uint32_t name = 0; name < cells_.size(); ++name)
      if (is_in_[name] != 0) chosen.push_back(cells_[name]);
    std::sort(chosen.begin(), chosen.end());
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
  }

  /// So that the heavier of two cells has the lesser name.
  void sort_by_weight() {
    struct Weighed {
      double weight;
      Cell cell;
    };
    std::vector<Weighed> weighed;
    weighed.reserve(cells_.size());
    for (const Cell cell : cells_) {
      double sum = 0;
      for (const TetIndex t : view_of(candidates_, cell).inner) sum += volume(graph_, t);
      weighed.push_back({sum * options_.factor[static_cast<std::size_t>(cell.shape)], cell});
    }
    std::sort(weighed.begin(), weighed.end(), [](const Weighed& a, const Weighed& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.cell < b.cell;
    });
    weight_.reserve(cells_.size());
    for (std::size_t i = 0; i < weighed.size(); ++i) {
      cells_[i] = weighed[i].cell;
      weight_.push_back(weighed[i].weight);
    }
    if (!weight_.empty()) least_gain_ = 1e-12 * weight_.front();
  }

  void sort_by_quality() {
    by_quality_.resize(cells_.size());
    std::iota(by_quality_.begin(), by_quality_.end(), 0U);
    std::sort(by_quality_.begin(), by_quality_.end(), [this](std::uint32_t a, std::uint32_t b) {
      if (cells_[a].shape != cells_[b].shape) return cells_[a].shape < cells_[b].shape;
      const double one = view(a).quality;
      const double other = view(b).quality;
      return one != other ? one > other : cells_[a] < cells_[b];
    });
  }

  /// In each row the heavier ones first.
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

  /// The candidates that have a tetrahedron of one of these cells and otherwise free ones, the
  /// heaviest first.
  [[nodiscard]] Names free_rivals(const Names& names) const {
    Names result;
    for (const std::uint32_t name : names)
      for (const TetIndex t : view(name).inner)
        for (std::size_t i = at_start_[t]; i < at_start_[t + 1]; ++i)
          if (is_free(at_[i])) result.push_back(at_[i]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  [[nodiscard]] bool is_free(std::uint32_t name) const {
    const auto inner = view(name).inner;
    return std::all_of(inner.begin(), inner.end(),
                       [this](TetIndex t) { return occupancy_.owner(t) == Occupancy::kFree; });
  }

  /// The cells in with a tetrahedron of this one.
  [[nodiscard]] Names owners(const CellView& cell) const {
    Names result;
    for (const TetIndex t : cell.inner)
      if (const std::uint32_t owner = occupancy_.owner(t); owner != Occupancy::kFree)
        if (std::find(result.begin(), result.end(), owner) == result.end()) result.push_back(owner);
    return result;
  }

  [[nodiscard]] double weight_of(const Names& names) const {
    return std::accumulate(names.begin(), names.end(), 0.0,
                           [this](double sum, std::uint32_t name) { return sum + weight_[name]; });
  }

  /// The cells in that are not compatible with this one.
  [[nodiscard]] Names blockers(const CellView& cell) const {
    Names near;
    for (const Index v : cell.vertices)
      for (const TetIndex t : graph_.star(v))
        if (const std::uint32_t owner = occupancy_.owner(t); owner != Occupancy::kFree)
          near.push_back(owner);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase_if(near, [&](std::uint32_t name) { return are_compatible(cell, view(name)); });
    return near;
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
      for (const std::uint32_t rival : free_rivals(out))
        if (occupancy_.fits(view(rival))) enter(rival);
    if (is_possible && gain > least_gain_) return true;
    for (const std::uint32_t name : entered) take(name);
    for (const std::uint32_t name : out) put(name);
    return false;
  }

  void report(std::size_t tried) const {
    constexpr std::size_t kSeldom = 1024;
    if (options_.progress && tried % kSeldom == 0)
      options_.progress(tried, cells_.size() * static_cast<std::size_t>(options_.rounds));
  }

  /// One round; false if nothing was gained.
  bool exchange(std::size_t round) {
    std::size_t tried = round * cells_.size();
    // Of many candidates only those are tried that promise more.
    const double share = cells_.size() < kFew ? 0 : kShare;
    bool is_better = false;
    for (const std::uint32_t name : by_quality_) {
      report(tried++);
      if (is_in_[name] != 0) {
        is_better = try_exchange({name}, Occupancy::kFree) || is_better;
        continue;
      }
      const double most = share > 0 ? weight_[name] / share : std::numeric_limits<double>::max();
      if (weight_of(owners(view(name))) >= most) continue;
      const Names out = blockers(view(name));
      if (weight_of(out) < most) is_better = try_exchange(out, name) || is_better;
    }
    return is_better;
  }

  static constexpr std::size_t kFew = 20'000;
  static constexpr double kShare = 0.8;

  const TetGraph& graph_;
  const Candidates& candidates_;
  SelectionOptions options_;
  Occupancy occupancy_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> is_in_;
  Names by_quality_;
  std::vector<double> weight_;
  double least_gain_ = 0;  ///< smaller gains may be rounding
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
