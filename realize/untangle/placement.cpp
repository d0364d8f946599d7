#include "realize/untangle/placement.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "realize/exact/jacobian.hpp"
#include "realize/untangle/energies.hpp"

namespace hexatlas::untangle {
namespace {

constexpr std::size_t kChunk = 1024;
constexpr int kSubdivisionDepth = 4;

}  // namespace

Standing standing_of(const Points& points, const Cell& cell) {
  exact::Hexahedron corners{};
  for (std::size_t v = 0; v < 8; ++v)
    corners[v] = {points(0, cell[v]), points(1, cell[v]), points(2, cell[v])};
  const std::optional<exact::JacobianVerdict> quick = exact::filtered_jacobian_verdict(corners);
  const exact::JacobianVerdict verdict =
      quick ? *quick : exact::exact_jacobian_verdict(corners, kSubdivisionDepth);
  if (verdict.positivity == exact::Positivity::positive) return Standing::valid;
  if (verdict.corner_not_positive) return Standing::inverted;
  return verdict.positivity == exact::Positivity::undecided ? Standing::undecided : Standing::bent;
}

std::vector<Standing> standings_of(const Points& points, const std::vector<Cell>& cells,
                                   int threads) {
  std::vector<Standing> result(cells.size());
  const std::size_t chunks = (cells.size() + kChunk - 1) / kChunk;
  parallel::parallel_for(chunks > 1 ? threads : 1, chunks, [&](std::size_t chunk) {
    const std::size_t end = std::min(cells.size(), (chunk + 1) * kChunk);
    for (std::size_t c = chunk * kChunk; c < end; ++c) result[c] = standing_of(points, cells[c]);
  });
  return result;
}

double scaled_jacobian_of(const Points& points, const Cell& cell) {
  double least = 1;
  for (std::size_t v = 0; v < 8; ++v)
    least =
        std::min(least, scaled_determinant(Problem::matrix_at(points, cell, sample_of_corner(v))));
  return least;
}

bool Placement::is_better_than(const Placement& other) const {
  return std::tuple(other.not_valid, other.inverted, least) >
         std::tuple(not_valid, inverted, other.least);
}

Placement judged(Points points, const std::vector<Cell>& cells, int threads) {
  Placement result;
  result.least = 1;
  for (const Standing standing : standings_of(points, cells, threads)) {
    result.not_valid += standing != Standing::valid ? 1 : 0;
    result.inverted += standing == Standing::inverted ? 1 : 0;
  }
  for (const Cell& cell : cells)
    result.least = std::min(result.least, scaled_jacobian_of(points, cell));
  result.points = std::move(points);
  return result;
}

}  // namespace hexatlas::untangle
