#include "realize/untangle/harmonic.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "enum/core/random.hpp"

namespace hexatlas::untangle {
namespace {

constexpr Eigen::Index kMaxFactorized = 30'000;
constexpr int kMaxIterations = 300;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

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

}  // namespace

void place_harmonically(Points& points, const std::vector<Cell>& cells,
                        const std::vector<std::uint8_t>& is_free, std::uint64_t seed) {
  const std::vector<Edge> edges = edges_of(cells);
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
  for (const Edge& edge : edges) {
    const double weight = weight_of(edge, seed);
    for (const auto& [from, to] : {edge, Edge{edge.second, edge.first}}) {
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

}  // namespace hexatlas::untangle
