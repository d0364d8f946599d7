#pragma once
/// \file
/// What hides what in a drawing of disjoint tetrahedra. Floating point, for pictures only.

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "tables/sheet/contact_sheet_layout.hpp"

namespace hexatlas::sheet {

using Corners = std::array<Vec, 4>;
[[nodiscard]] constexpr Vec centroid(const Corners& t) {
  return 0.25 * (t[0] + t[1] + t[2] + t[3]);
}

struct Rectangle {
  double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;
  void include(Vec p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  [[nodiscard]] bool meets(const Rectangle& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Whether a plane separates the two, which may touch; up to rounding, at a size of about 1.
[[nodiscard]] bool are_apart(const Corners& a, const Corners& b);

/// [i][j] for i < j: normal of the widest gap between the two, pointing from i to j.
using SeparatingNormals = std::vector<std::vector<Vec>>;
[[nodiscard]] SeparatingNormals separating_normals(const std::vector<Corners>& pieces);

struct PaintersOrder {
  std::vector<std::size_t> order;  ///< back to front
  bool is_sure = true;             ///< no: pieces may hide each other in a circle; a guess
};
/// `pieces` on the screen, z towards the eye; `eye` is the direction to the eye in the coordinates
/// of the normals.
[[nodiscard]] PaintersOrder painters_order(const std::vector<Corners>& pieces,
                                           const SeparatingNormals& normals, Vec eye);

/// Parts of the segment a b that no piece hides, as pairs of parameters in [0, 1], ascending. On
/// the screen, z towards the eye.
[[nodiscard]] std::vector<std::pair<double, double>> visible_parts(
    Vec a, Vec b, const std::vector<Corners>& pieces);

}  // namespace hexatlas::sheet
