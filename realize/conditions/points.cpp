#include "realize/conditions/points.hpp"

#include <algorithm>
#include <bit>

#include "enum/core/checks.hpp"
#include "realize/chirotope/chirotope.hpp"
#include "realize/exact/integer_orientation.hpp"
#include "realize/exact/jacobian.hpp"

namespace hexatlas::conditions {
namespace {

using certificate::Condition;
using certificate::IntegerPoint;
using complex::bit_of;
using complex::VertexSet;

static_assert(certificate::kCoordinateBound <= exact::kIntegerPointBound);

constexpr std::size_t kMaxQuadruples = 1820;  // C(16,4)

bool in_range(std::span<const IntegerPoint> points) {
  return std::all_of(points.begin(), points.end(), [](const IntegerPoint& p) {
    return std::all_of(p.begin(), p.end(), [](std::int64_t x) {
      return -certificate::kCoordinateBound < x && x < certificate::kCoordinateBound;
    });
  });
}

bool jacobian_positive(std::span<const IntegerPoint> points) {
  exact::Hexahedron corners{};
  std::transform(points.begin(), points.end(), corners.begin(), [](const IntegerPoint& p) {
    return exact::Point3{static_cast<double>(p[0]), static_cast<double>(p[1]),
                         static_cast<double>(p[2])};
  });
  const auto filtered = exact::filtered_jacobian_verdict(corners);
  const auto verdict =
      filtered ? *filtered : exact::exact_jacobian_verdict(corners, kJacobianDepth);
  return verdict.positivity == exact::Positivity::positive;
}

std::size_t index_of(VertexSet four) {
  const auto [a, b, c, d] = complex::vertices_of(four);
  return static_cast<std::size_t>(chirotope::literal_of(a, b, c, d) - 1);
}

}  // namespace

PointsJudge::PointsJudge(const complex::Triangulation& triangulation, std::span<const int> signs,
                         Condition condition)
    : vertices_(triangulation.vertices), condition_(condition) {
  core::expects(vertices_ >= 4 && vertices_ <= complex::kMaxTriangulationVertices,
                "points: 4 to 16 vertices");
  core::expects(signs.size() == triangulation.tetrahedra.size(), "points: a sign per tetrahedron");
  core::expects(std::all_of(signs.begin(), signs.end(), [](int s) { return s == 1 || s == -1; }),
                "points: signs are +1 or -1");
  core::expects(condition != Condition::jacobian || vertices_ == 8,
                "points: the condition jacobian needs eight vertices");
  list_subsets(triangulation, signs);
  mark_faces(triangulation);
}

void PointsJudge::list_subsets(const complex::Triangulation& triangulation,
                               std::span<const int> signs) {
  const unsigned sets = 1U << static_cast<unsigned>(vertices_);
  // Sets in ascending order have ascending variables.
  for (unsigned set = 0; set < sets; ++set) {
    if (std::popcount(set) == 4)
      quadruples_.push_back({complex::vertices_of(static_cast<VertexSet>(set)), 0});
    if (std::popcount(set) != 5) continue;
    Quintuple five{};
    std::size_t i = 0;
    for (auto rest = static_cast<VertexSet>(set); rest != 0; rest = complex::without_least(rest)) {
      const int v = complex::least_vertex(rest);
      five.vertices[i] = static_cast<std::uint8_t>(v);
      five.without[i++] =
          static_cast<std::uint16_t>(index_of(static_cast<VertexSet>(set) ^ bit_of(v)));
    }
    quintuples_.push_back(five);
  }
  for (std::size_t i = 0; i < signs.size(); ++i)
    quadruples_[index_of(triangulation.tetrahedra[i])].required =
        static_cast<std::int8_t>(signs[i]);
}

void PointsJudge::mark_faces(const complex::Triangulation& triangulation) {
  is_face_.assign(std::size_t{1} << static_cast<unsigned>(vertices_), 0);
  for (const VertexSet tetrahedron : triangulation.tetrahedra)
    for (VertexSet face = tetrahedron; face != 0;
         face = static_cast<VertexSet>((face - 1U) & tetrahedron))
      is_face_[face] = 1;
}

bool PointsJudge::forbidden(const Quintuple& five,
                            std::span<const std::int8_t> signs) const noexcept {
  VertexSet all = 0;
  VertexSet side = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const VertexSet bit = bit_of(five.vertices[i]);
    all |= bit;
    if ((signs[five.without[i]] > 0) == (i % 2 == 0)) side |= bit;
  }
  const auto other = static_cast<VertexSet>(all ^ side);
  if (is_face_[side] != 0 && is_face_[other] != 0) return true;
  return condition_ == Condition::convex &&
         (std::has_single_bit(side) || std::has_single_bit(other));
}

PointsJudge::Count PointsJudge::count(std::span<const IntegerPoint> points) const {
  core::expects(points.size() == static_cast<std::size_t>(vertices_), "points: one per vertex");
  std::array<std::int8_t, kMaxQuadruples> signs;  // NOLINT(*-member-init): filled below
  Count result;
  for (std::size_t i = 0; i < quadruples_.size(); ++i) {
    const auto& [v, required] = quadruples_[i];
    signs[i] = static_cast<std::int8_t>(
        exact::sign_of_orientation(points[v[0]], points[v[1]], points[v[2]], points[v[3]]));
    result.degenerate += signs[i] == 0 ? 1 : 0;
    result.wrong += required * signs[i] < 0 ? 1 : 0;
  }
  for (const Quintuple& five : quintuples_) result.forbidden += forbidden(five, signs) ? 1 : 0;
  return result;
}

int PointsJudge::violations(std::span<const IntegerPoint> points) const {
  const Count found = count(points);
  return found.degenerate + found.wrong + found.forbidden;
}

PointsVerdict PointsJudge::verdict(std::span<const IntegerPoint> points) const {
  core::expects(points.size() == static_cast<std::size_t>(vertices_), "points: one per vertex");
  if (!in_range(points)) return PointsVerdict::out_of_range;
  const Count found = count(points);
  if (found.degenerate != 0) return PointsVerdict::degenerate;
  if (found.wrong != 0) return PointsVerdict::wrong_sign;
  if (found.forbidden != 0) return PointsVerdict::forbidden_partition;
  if (condition_ == Condition::jacobian && !jacobian_positive(points))
    return PointsVerdict::jacobian_not_positive;
  return PointsVerdict::satisfied;
}

}  // namespace hexatlas::conditions
