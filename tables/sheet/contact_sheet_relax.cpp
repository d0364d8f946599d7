#include "tables/sheet/contact_sheet_relax.hpp"

#include <limits>

namespace hexatlas::sheet {
namespace {

constexpr double kVolumeWeight = 0.003;
constexpr double kLongestStep = 0.3;
constexpr int kHalvings = 7;

double volume(const Corners& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6; }

class Relaxation {
 public:
  Relaxation(Likeness start, const complex::Triangulation& triangulation)
      : triangulation_(triangulation), state_(std::move(start)) {
    for (const Corners& t : corners_of(triangulation_, state_.points))
      signs_.push_back(volume(t) > 0 ? 1 : -1);
  }

  std::vector<Vec> points() {
    double step = kLongestStep;
    for (int halving = 0; halving < kHalvings; ++halving, step /= 2)
      for (int sweep = 0; sweep < kSweeps && sweep_lowers(step); ++sweep) continue;
    return state_.points;
  }

 private:
  static constexpr int kSweeps = 30;

  bool sweep_lowers(double step) {
    bool is_lower = false;
    for (std::size_t v = 0; v < state_.points.size(); ++v)
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z) {
            const Vec move{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
            if (x == 0 && y == 0 && z == 0) continue;
            if (moves(v, step / length(move) * move)) is_lower = true;
          }
    return is_lower;
  }

  /// Keeps the move if it helps and is allowed.
  bool moves(std::size_t v, Vec move) {
    const double before = energy_at(v);
    const Vec old = state_.points[v];
    state_.points[v] = old + move;
    if (energy_at(v) < before - 1e-9 && is_apart(v)) return true;
    state_.points[v] = old;
    return false;
  }

  [[nodiscard]] bool is_at(std::size_t tetrahedron, std::size_t v) const {
    return (triangulation_.tetrahedra[tetrahedron] & complex::bit_of(static_cast<int>(v))) != 0;
  }

  /// The part of the sum that depends on v.
  [[nodiscard]] double energy_at(std::size_t v) const {
    double energy = 0;
    if (v < state_.shape.size()) {
      const Vec offset = state_.points[v] - state_.shape[v];
      energy = dot(offset, offset);
    }
    const std::vector<Corners> tetrahedra = corners_of(triangulation_, state_.points);
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      if (!is_at(i, v)) continue;
      const double size = signs_[i] * volume(tetrahedra[i]);
      if (size <= 0) return std::numeric_limits<double>::infinity();
      energy += kVolumeWeight / size;
    }
    return energy;
  }

  [[nodiscard]] bool is_apart(std::size_t v) const {
    const std::vector<Corners> tetrahedra = corners_of(triangulation_, state_.points);
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      if (!is_at(i, v)) continue;
      for (std::size_t j = 0; j < tetrahedra.size(); ++j)
        if (i != j && !are_apart(tetrahedra[i], tetrahedra[j])) return false;
    }
    return true;
  }

  const complex::Triangulation& triangulation_;
  Likeness state_;
  std::vector<double> signs_;
};

}  // namespace

std::vector<Corners> corners_of(const complex::Triangulation& triangulation,
                                const std::vector<Vec>& vertices) {
  std::vector<Corners> tetrahedra;
  for (const complex::VertexSet set : triangulation.tetrahedra) {
    Corners corners;
    const auto members = complex::vertices_of(set);
    for (std::size_t i = 0; i < 4; ++i) corners[i] = vertices[members[i]];
    tetrahedra.push_back(corners);
  }
  return tetrahedra;
}

std::vector<Vec> relaxed(Likeness start, const complex::Triangulation& triangulation) {
  return Relaxation(std::move(start), triangulation).points();
}

}  // namespace hexatlas::sheet
