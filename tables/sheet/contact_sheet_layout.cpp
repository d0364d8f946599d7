#include "tables/sheet/contact_sheet_layout.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

namespace hexatlas::sheet {
namespace {

constexpr int kStarts = 24;
constexpr int kSteps = 400;

double stress_of(const std::vector<Vec>& points,
                 const std::vector<std::vector<double>>& distances) {
  double stress = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double error = length(points[i] - points[j]) - distances[i][j];
      stress += error * error;
    }
  return stress;
}

/// One step of majorization, which never increases the stress.
std::vector<Vec> majorized(const std::vector<Vec>& points,
                           const std::vector<std::vector<double>>& distances) {
  std::vector<Vec> next(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i == j) continue;
      const Vec offset = points[i] - points[j];
      const double apart = std::max(length(offset), 1e-9);
      next[i] = next[i] + (distances[i][j] / apart / static_cast<double>(points.size())) * offset;
    }
  return next;
}

using Matrix = std::array<Vec, 3>;  ///< rows

double determinant(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }

Vec product(const Matrix& m, Vec v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

/// Affine image such that the first `leading` points have mean 0 and sum p p^T over them is their
/// number times the unit matrix; by Gram-Schmidt on the coordinates, so orientations are kept.
std::vector<Vec> rounded(std::vector<Vec> points, std::size_t leading) {
  constexpr std::array<double Vec::*, 3> kCoordinates{&Vec::x, &Vec::y, &Vec::z};
  const Vec middle = mean({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(leading)});
  for (Vec& point : points) point = point - middle;
  const auto product_of = [&](double Vec::*a, double Vec::*b) {
    double sum = 0;
    for (std::size_t i = 0; i < leading; ++i) sum += points[i].*a * points[i].*b;
    return sum / static_cast<double>(leading);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = kCoordinates[i];
    for (std::size_t j = 0; j < i; ++j) {
      const double overlap = product_of(a, kCoordinates[j]);
      for (Vec& point : points) point.*a -= overlap * point.*kCoordinates[j];
    }
    const double size = std::sqrt(product_of(a, a));
    for (Vec& point : points) point.*a /= size;
  }
  return points;
}

/// The orthogonal factor of the polar decomposition, by Newton's iteration.
Matrix nearest_rotation(Matrix m) {
  for (int step = 0; step < 40; ++step) {
    const double volume = determinant(m);
    const Matrix inverse_transposed{(1 / volume) * cross(m[1], m[2]),
                                    (1 / volume) * cross(m[2], m[0]),
                                    (1 / volume) * cross(m[0], m[1])};
    for (std::size_t i = 0; i < 3; ++i) m[i] = 0.5 * (m[i] + inverse_transposed[i]);
  }
  return m;
}

}  // namespace

Vec mean(const std::vector<Vec>& points) {
  Vec sum;
  for (const Vec point : points) sum = sum + point;
  return (1 / static_cast<double>(points.size())) * sum;
}

std::vector<std::vector<double>> path_lengths(std::size_t nodes, const Links& links) {
  std::vector<std::vector<double>> length(nodes,
                                          std::vector<double>(nodes, static_cast<double>(nodes)));
  for (std::size_t v = 0; v < nodes; ++v) length[v][v] = 0;
  for (const auto& [a, b] : links) length[a][b] = length[b][a] = 1;
  for (std::size_t via = 0; via < nodes; ++via)
    for (std::size_t a = 0; a < nodes; ++a)
      for (std::size_t b = 0; b < nodes; ++b)
        length[a][b] = std::min(length[a][b], length[a][via] + length[via][b]);
  return length;
}

std::vector<Vec> stress_layout(const std::vector<std::vector<double>>& distances, bool is_flat) {
  std::mt19937_64 random(1);
  const auto coordinate = [&random] {
    return static_cast<double>(random() >> 11U) / static_cast<double>(std::uint64_t{1} << 52U) - 1;
  };
  std::vector<Vec> best;
  double least = 0;
  for (int start = 0; start < kStarts; ++start) {
    std::vector<Vec> points(distances.size());
    for (Vec& point : points) {
      point.x = coordinate();
      point.y = coordinate();
      point.z = is_flat ? 0 : coordinate();
    }
    for (int step = 0; step < kSteps; ++step) points = majorized(points, distances);
    const double stress = stress_of(points, distances);
    if (best.empty() || stress < least) {
      best = std::move(points);
      least = stress;
    }
  }
  return best;
}

Likeness alike(const std::vector<Vec>& points, const std::vector<Vec>& shape) {
  std::vector<Vec> round = rounded(points, shape.size());
  Matrix best;  // sum of shape p^T, as sum p p^T is the unit matrix
  double size = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec s = shape[i];
    const Vec p = round[i];
    best = {best[0] + s.x * p, best[1] + s.y * p, best[2] + s.z * p};
    size += dot(s, s);
  }
  const double scale = 1 / std::sqrt(size * static_cast<double>(shape.size()) / 3);
  for (Vec& row : best) row = scale * row;
  std::vector<Vec> target = shape;
  if (determinant(best) < 0) {
    best[0] = -1 * best[0];
    for (Vec& s : target) s.x = -s.x;
  }
  Matrix map{Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  if (determinant(best) > 1e-6) {
    map = nearest_rotation(best);
    for (std::size_t i = 0; i < 3; ++i) map[i] = 0.5 * (map[i] + best[i]);
  }
  for (Vec& point : round) point = product(map, point);
  return {std::move(round), std::move(target)};
}

}  // namespace hexatlas::sheet
