#include "realize/untangle/harmonic.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "enum/complex/union_find.hpp"
#include "enum/core/random.hpp"

namespace hexatlas::untangle {
namespace {

constexpr Eigen::Index kMaxFactorized = 30'000;
constexpr int kMaxIterations = 300;

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Weights = std::vector<double>;  ///< one per edge

std::vector<Edge> edges_of(const std::vector<Cell>& cells) {
  std::vector<Edge> edges;
  edges.reserve(12 * cells.size());
  for (const Cell& cell : cells)
    for (unsigned v = 0; v < 8; ++v)
      for (const unsigned axis : {1U, 2U, 4U})
        if ((v & axis) == 0) edges.emplace_back(std::minmax(cell[v], cell[v | axis]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::size_t number_of(const std::vector<Edge>& edges, std::uint32_t a, std::uint32_t b) {
  const auto at = std::lower_bound(edges.begin(), edges.end(), Edge(std::minmax(a, b)));
  return static_cast<std::size_t>(at - edges.begin());
}

/// Of the edges, which are opposite each other.
complex::UnionFind sheets_of(const std::vector<Cell>& cells, const std::vector<Edge>& edges) {
  complex::UnionFind sheets(edges.size());
  for (const Cell& cell : cells)
    for (const unsigned axis : {1U, 2U, 4U}) {
      const std::size_t first = number_of(edges, cell[0], cell[axis]);
      for (unsigned v = 1; v < 8; ++v)
        if ((v & axis) == 0) sheets.unite(first, number_of(edges, cell[v], cell[v | axis]));
    }
  return sheets;
}

struct Mean {
  double sum = 0, count = 0;
  void add(double x) {
    sum += x;
    ++count;
  }
  [[nodiscard]] double value() const { return count == 0 ? 0 : sum / count; }
};

Weights weights_by_sheet(const Points& points, const std::vector<Cell>& cells,
                         const std::vector<Edge>& edges, const std::vector<std::uint8_t>& is_free) {
  constexpr double kLeast = 1e-12;  // of the mean length: edges may have none
  complex::UnionFind sheets = sheets_of(cells, edges);
  std::vector<Mean> lengths(edges.size());
  Mean all;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [a, b] = edges[e];
    if (is_free[a] != 0 || is_free[b] != 0) continue;
    const double length = (points.col(a) - points.col(b)).norm();
    lengths[sheets.find(e)].add(length);
    all.add(length);
  }
  Weights weights(edges.size(), 1);
  if (all.value() == 0) return weights;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Mean& own = lengths[sheets.find(e)];
    const double length = own.count == 0 ? all.value() : own.value();
    weights[e] = all.value() / std::max(length, kLeast * all.value());
  }
  return weights;
}

double weight_of(const Edge& edge, std::uint64_t seed) {
  if (seed == 0) return 1;
  const std::uint64_t bits =
      core::mixed(seed + core::mixed((std::uint64_t{edge.first} << 32U) | edge.second));
  const double uniform = static_cast<double>(bits >> 11U) * 0x1p-53;
  return std::exp2(6 * uniform - 3);
}

/// Of the points: free, and connected with a fixed one by a path of edges.
std::vector<std::uint8_t> determined(const std::vector<Edge>& edges,
                                     const std::vector<std::uint8_t>& is_free) {
  std::vector<std::vector<std::uint32_t>> neighbours(is_free.size());
  std::vector<std::uint8_t> is_used(is_free.size());
  for (const Edge& edge : edges) {
    neighbours[edge.first].push_back(edge.second);
    neighbours[edge.second].push_back(edge.first);
    is_used[edge.first] = is_used[edge.second] = 1;
  }
  std::vector<std::uint8_t> is_seen(is_free.size());
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t v = 0; v < is_free.size(); ++v)
    if (is_used[v] != 0 && is_free[v] == 0) {
      is_seen[v] = 1;
      waiting.push_back(v);
    }
  while (!waiting.empty()) {
    const std::uint32_t v = waiting.back();
    waiting.pop_back();
    for (const std::uint32_t w : neighbours[v])
      if (std::exchange(is_seen[w], std::uint8_t{1}) == 0) waiting.push_back(w);
  }
  for (std::size_t v = 0; v < is_free.size(); ++v) is_seen[v] &= is_free[v];
  return is_seen;
}

using Matrix = Eigen::SparseMatrix<double>;

/// The rows of the result solve the system for x, y, z. Points that no number becomes of stay.
Eigen::MatrixX3d solution(const Matrix& matrix, const Eigen::MatrixX3d& right,
                          const Eigen::MatrixX3d& guess) {
  if (matrix.rows() <= kMaxFactorized) {
    const Eigen::SimplicialLDLT<Matrix> factors(matrix);
    Eigen::MatrixX3d result = factors.solve(right);
    return factors.info() == Eigen::Success && result.allFinite() ? result : guess;
  }
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setMaxIterations(kMaxIterations);
  solver.setTolerance(1e-6);
  solver.compute(matrix);
  Eigen::MatrixX3d result = solver.solveWithGuess(right, guess);
  return result.allFinite() ? result : guess;
}

void place_by_weights(Points& points, const std::vector<Edge>& edges, const Weights& weights,
                      const std::vector<std::uint8_t>& is_free) {
  const std::vector<std::uint8_t> is_wanted = determined(edges, is_free);
  std::vector<Eigen::Index> row(is_free.size(), -1);
  std::vector<Eigen::Index> wanted;
  for (std::size_t v = 0; v < is_free.size(); ++v)
    if (is_wanted[v] != 0) {
      row[v] = static_cast<Eigen::Index>(wanted.size());
      wanted.push_back(static_cast<Eigen::Index>(v));
    }
  const auto rows = static_cast<Eigen::Index>(wanted.size());
  if (rows == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(rows, 3);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const double weight = weights[e];
    for (const auto& [from, to] : {edges[e], Edge{edges[e].second, edges[e].first}}) {
      if (row[from] < 0) continue;
      entries.emplace_back(row[from], row[from], weight);
      if (row[to] >= 0)
        entries.emplace_back(row[from], row[to], -weight);
      else
        right.row(row[from]) += weight * points.col(to).transpose();
    }
  }
  Matrix matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixX3d guess(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i)
    guess.row(i) = points.col(wanted[static_cast<std::size_t>(i)]).transpose();
  const Eigen::MatrixX3d solved = solution(matrix, right, guess);
  for (Eigen::Index i = 0; i < rows; ++i)
    points.col(wanted[static_cast<std::size_t>(i)]) = solved.row(i).transpose();
}

}  // namespace

void place_harmonically(Points& points, const std::vector<Cell>& cells,
                        const std::vector<std::uint8_t>& is_free, std::uint64_t seed) {
  const std::vector<Edge> edges = edges_of(cells);
  Weights weights;
  weights.reserve(edges.size());
  for (const Edge& edge : edges) weights.push_back(weight_of(edge, seed));
  place_by_weights(points, edges, weights, is_free);
}

void place_by_sheets(Points& points, const std::vector<Cell>& cells,
                     const std::vector<std::uint8_t>& is_free) {
  const std::vector<Edge> edges = edges_of(cells);
  place_by_weights(points, edges, weights_by_sheet(points, cells, edges, is_free), is_free);
}

}  // namespace hexatlas::untangle
