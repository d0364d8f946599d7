#include "realize/untangle/problem.hpp"

#include <algorithm>
#include <utility>

namespace hexatlas::untangle {

Problem::Problem(Points points, const std::vector<Cell>& cells,
                 const std::vector<std::uint8_t>& is_free)
    : points_(std::move(points)) {
  std::vector<std::size_t> uses(is_free.size());
  for (const Cell& cell : cells) {
    std::uint8_t moving = 0;
    for (std::size_t v = 0; v < 8; ++v) moving |= static_cast<std::uint8_t>(is_free[cell[v]] << v);
    if (moving == 0) continue;
    for (const std::uint32_t v : cell) uses[v] += is_free[v];
    cells_.push_back(cell);
    seen_.push_back(samples_that_see(moving));
    masks_.push_back(kCornerSamples & seen_.back());
  }
  std::vector<std::size_t> next(is_free.size());
  first_.push_back(0);
  for (std::uint32_t v = 0; v < uses.size(); ++v) {
    if (uses[v] == 0) continue;
    free_.push_back(v);
    next[v] = first_.back();
    first_.push_back(first_.back() + uses[v]);
  }
  places_.resize(first_.back());
  for (std::size_t c = 0; c < cells_.size(); ++c)
    for (std::size_t v = 0; v < 8; ++v)
      if (uses[cells_[c][v]] != 0) places_[next[cells_[c][v]]++] = 8 * c + v;
}

Points Problem::points_at(const Variables& x) const {
  Points points = points_;
  for (std::size_t i = 0; i < free_.size(); ++i)
    points.col(free_[i]) = x.segment<3>(static_cast<Eigen::Index>(3 * i));
  return points;
}

Variables Problem::variables_of(const Points& points) const {
  Variables x(variables());
  for (std::size_t i = 0; i < free_.size(); ++i)
    x.segment<3>(static_cast<Eigen::Index>(3 * i)) = points.col(free_[i]);
  return x;
}

void Problem::gather(int threads, Variables& gradient) const {
  gradient.resize(static_cast<Eigen::Index>(variables()));
  const std::size_t chunks = (free_.size() + kChunk - 1) / kChunk;
  parallel::parallel_for(chunks > 1 ? threads : 1, chunks, [&](std::size_t chunk) {
    const std::size_t end = std::min(free_.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      Eigen::Vector3d total = Eigen::Vector3d::Zero();
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
        total += Eigen::Map<const Eigen::Vector3d>(scratch_.data() + 3 * places_[k]);
      gradient.segment<3>(static_cast<Eigen::Index>(3 * i)) = total;
    }
  });
}

}  // namespace hexatlas::untangle
