#include "realize/untangle/untangle.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "enum/core/checks.hpp"
#include "realize/untangle/attempt.hpp"
#include "realize/untangle/frame.hpp"
#include "realize/untangle/harmonic.hpp"

namespace hexatlas::untangle {
namespace {

constexpr std::size_t kMostCellsAtOnce = 20'000;  ///< larger meshes are improved in parts
constexpr double kWorkPerEffort = 1e6;
constexpr double kEvaluationsOfAPart = 100;  ///< wanted; else fewer points move
constexpr int kMaxParts = 8;
constexpr std::size_t kWorstCells = 2'000;
/// Of the least scaled Jacobian: so much more, or so many times as much.
constexpr double kWorthTheSpacing = 0.05, kTimesWorthTheSpacing = 1.5;

void expect_requirements(const Mesh& mesh, const Options& options) {
  core::expects(mesh.is_free.size() == mesh.points.size(), "untangle: one flag per point");
  core::expects(0 <= options.effort && options.effort <= kMaxEffort, "untangle: effort");
  core::expects(options.threads >= 1, "untangle: at least one thread");
  for (Cell cell : mesh.hexahedra) {
    std::sort(cell.begin(), cell.end());
    core::expects(std::adjacent_find(cell.begin(), cell.end()) == cell.end(),
                  "untangle: a hexahedron with a repeated vertex");
    core::expects(cell.back() < mesh.points.size(), "untangle: index of a point out of range");
  }
}

/// By exact integration (Simpson's rule on the samples) if that is positive.
double volume_of(const Points& points, const std::vector<Cell>& cells) {
  double total = 0;
  for (const Cell& cell : cells)
    for (std::size_t i = 0; i < kSamples; ++i) {
      const auto weight = [](std::size_t k) { return k == 1 ? 4.0 / 6 : 1.0 / 6; };
      total += weight(i % 3) * weight(i / 3 % 3) * weight(i / 9) *
               Problem::matrix_at(points, cell, i).determinant();
    }
  return total;
}

/// The points of these cells, and of those around them if there is a ring, as far as they may move.
std::vector<std::uint8_t> free_near(const Task& task, const std::vector<std::uint8_t>& is_bad,
                                    int rings) {
  std::vector<std::uint8_t> is_cell_near = is_bad;
  std::vector<std::uint8_t> is_near(task.is_free.size());
  for (int ring = 0; ring <= rings; ++ring) {
    for (std::size_t c = 0; c < task.cells.size(); ++c)
      if (is_cell_near[c] != 0)
        for (const std::uint32_t v : task.cells[c]) is_near[v] = 1;
    for (std::size_t c = 0; c < task.cells.size(); ++c)
      for (const std::uint32_t v : task.cells[c]) is_cell_near[c] |= is_near[v];
  }
  for (std::size_t v = 0; v < is_near.size(); ++v) is_near[v] &= task.is_free[v];
  return is_near;
}

/// The part of a task in which only these points move.
Task part_of(const Task& task, std::vector<std::uint8_t> is_free) {
  Task part;
  for (const Cell& cell : task.cells)
    if (std::any_of(cell.begin(), cell.end(), [&](std::uint32_t v) { return is_free[v] != 0; }))
      part.cells.push_back(cell);
  part.is_free = std::move(is_free);
  return part;
}

/// A task whose points are those of its cells alone, in their order: each evaluation of an energy
/// begins with a copy of all points.
struct Excerpt {
  Task task;
  std::vector<Eigen::Index> point;  ///< the number of each one before
};

Excerpt excerpt_of(const Task& task) {
  std::vector<std::uint32_t> number(task.is_free.size());
  for (const Cell& cell : task.cells)
    for (const std::uint32_t v : cell) number[v] = 1;
  Excerpt result{{task.cells, {}}, {}};
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    number[v] = static_cast<std::uint32_t>(result.point.size());
    result.point.push_back(static_cast<Eigen::Index>(v));
    result.task.is_free.push_back(task.is_free[v]);
  }
  for (Cell& cell : result.task.cells)
    for (std::uint32_t& v : cell) v = number[v];
  return result;
}

Points placed_at_once(const Task& task, const Points& start, Work& work) {
  Work first(work.left() / 2, work.threads());
  Placement best = unfolded(task, start, 1, first);
  work.spend(work.left() / 2 - first.left());
  if (best.not_valid > 0) {
    Placement other = unfolded_from_many(task, start, work);
    if (other.is_better_than(best)) best = std::move(other);
  }
  return raised(task, best, work).points;
}

/// Cells that are not valid; if there are none, the worst ones.
std::vector<std::uint8_t> bad_cells(const Task& task, const Points& points, int threads,
                                    bool& any) {
  const std::vector<Standing> standing = standings_of(points, task.cells, threads);
  std::vector<std::uint8_t> is_bad(task.cells.size());
  any = false;
  for (std::size_t c = 0; c < is_bad.size(); ++c) {
    is_bad[c] = standing[c] != Standing::valid ? 1 : 0;
    any = any || is_bad[c] != 0;
  }
  if (any) return is_bad;
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(is_bad.size());
  for (std::size_t c = 0; c < is_bad.size(); ++c)
    order.emplace_back(scaled_jacobian_of(points, task.cells[c]), c);
  const auto worst =
      order.begin() + static_cast<std::ptrdiff_t>(std::min(kWorstCells, order.size()));
  std::nth_element(order.begin(), worst - 1, order.end());
  for (auto it = order.begin(); it != worst; ++it) is_bad[it->second] = 1;
  return is_bad;
}

Points placed_in_parts(const Task& task, Points points, Work& work) {
  for (int i = 0; i < kMaxParts && work.left() > 0; ++i) {
    bool is_any_bad = false;
    const auto is_bad = bad_cells(task, points, work.threads(), is_any_bad);
    Task part = part_of(task, free_near(task, is_bad, 1));
    const auto wanted = [&part] {
      return kEvaluationsOfAPart * static_cast<double>(part.cells.size());
    };
    if (work.left() < 2 * wanted()) part = part_of(task, free_near(task, is_bad, 0));
    if (part.cells.empty()) break;
    Work own(std::min(work.left(), std::max(work.left() / 2, wanted())), work.threads());
    const double before = own.left();
    const Excerpt excerpt = excerpt_of(part);
    const Points start = points(Eigen::all, excerpt.point);
    const Placement best = is_any_bad ? unfolded(excerpt.task, start, 1, own)
                                      : judged(start, excerpt.task.cells, work.threads());
    points(Eigen::all, excerpt.point) = raised(excerpt.task, best, own).points;
    work.spend(before - own.left());
    if (!is_any_bad || before == own.left()) break;
  }
  return points;
}

/// Places before any descent.
struct FirstPlaces {
  Points points;
  bool keeps_spacing = false;  ///< of the boundary; then all cells are valid
  double least = 0;            ///< scaled Jacobian, if so
};

/// Harmonic ones, unless those that keep the spacing make all cells valid. `part` has the cells
/// with free points.
FirstPlaces first_places(Points points, const Task& task, const Task& part, int threads) {
  Points spaced = points;
  place_by_sheets(spaced, task.cells, task.is_free);
  Placement placed = judged(std::move(spaced), part.cells, threads);
  if (placed.not_valid == 0) return {std::move(placed.points), true, placed.least};
  place_harmonically(points, task.cells, task.is_free, 0);
  return {std::move(points)};
}

/// By descents. They make cells of one size and all directions alike, and so lose a spacing, which
/// only hexahedra that are much better are worth.
Points improved(const Task& task, const FirstPlaces& start, Work& work) {
  if (start.keeps_spacing && start.least + kWorthTheSpacing >= 1) return start.points;
  Points points = task.cells.size() <= kMostCellsAtOnce ? placed_at_once(task, start.points, work)
                                                        : placed_in_parts(task, start.points, work);
  if (!start.keeps_spacing) return points;
  Placement placed = judged(std::move(points), task.cells, work.threads());
  const double least =
      std::min(start.least + kWorthTheSpacing, start.least * kTimesWorthTheSpacing);
  const bool is_worth_it = placed.not_valid == 0 && placed.least > least;
  return is_worth_it ? placed.points : start.points;
}

}  // namespace

std::vector<exact::Point3> untangled(const Mesh& mesh, const Options& options) {
  expect_requirements(mesh, options);
  std::vector<std::uint8_t> is_used(mesh.points.size());
  for (const Cell& cell : mesh.hexahedra)
    for (const std::uint32_t v : cell) is_used[v] = 1;
  std::vector<std::uint32_t> listed;
  bool is_any_fixed = false;
  for (std::uint32_t v = 0; v < is_used.size(); ++v)
    is_any_fixed = is_any_fixed || (is_used[v] != 0 && mesh.is_free[v] == 0);
  const bool starts_as_given = options.starts_as_given || !is_any_fixed;
  for (std::uint32_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0 && (starts_as_given || mesh.is_free[v] == 0)) listed.push_back(v);

  Task whole{mesh.hexahedra, mesh.is_free};
  for (std::size_t v = 0; v < is_used.size(); ++v) whole.is_free[v] &= is_used[v];
  for (const std::uint32_t v : listed)
    core::expects(std::isfinite(mesh.points[v].x) && std::isfinite(mesh.points[v].y) &&
                      std::isfinite(mesh.points[v].z),
                  "untangle: finite coordinates");
  const Frame frame(mesh.points, listed);
  FirstPlaces start{Points::Zero(3, static_cast<Eigen::Index>(mesh.points.size()))};
  for (const std::uint32_t v : listed) start.points.col(v) = frame.inside(mesh.points[v]);
  const Task task = part_of(whole, whole.is_free);
  if (!starts_as_given) start = first_places(std::move(start.points), whole, task, options.threads);

  double unit = 1;
  if (options.effort > 0 && !task.cells.empty()) {
    const double volume = volume_of(start.points, task.cells);
    const double least_volume = 1e-6;  // of 8
    unit = std::cbrt(std::max(volume, least_volume) / static_cast<double>(task.cells.size()));
    Work work(kWorkPerEffort * options.effort, options.threads);
    start.points /= unit;
    start.points = improved(task, start, work);
  }
  std::vector<exact::Point3> result = mesh.points;
  for (std::size_t v = 0; v < result.size(); ++v)
    if (task.is_free[v] != 0)
      result[v] = frame.outside(unit * start.points.col(static_cast<Eigen::Index>(v)));
  return result;
}

}  // namespace hexatlas::untangle
