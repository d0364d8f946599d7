#include "tables/check/catalogue_points.hpp"

#include <cstdint>

#include "tables/check/circuits.hpp"
#include "tables/check/jacobian.hpp"

namespace hexatlas::check {

namespace {

/// Signs of all fours of the points, computed once.
class PointSigns {
 public:
  explicit PointSigns(const std::vector<LatticePoint>& points)
      : sign_(std::size_t{1} << points.size()) {
    const auto all = static_cast<VertexBits>((1U << points.size()) - 1U);
    for_each_subset(all, 4, [&](VertexBits four) {
      std::array<std::size_t, 4> at{};
      unsigned rest = four;
      for (std::size_t& place : at) {
        place = static_cast<std::size_t>(std::countr_zero(rest));
        rest &= rest - 1;
      }
      const Wide value = determinant(difference(points[at[1]], points[at[0]]),
                                     difference(points[at[2]], points[at[0]]),
                                     difference(points[at[3]], points[at[0]]));
      sign_[four] = static_cast<std::int8_t>(value > 0 ? 1 : (value < 0 ? -1 : 0));
    });
  }

  [[nodiscard]] int operator()(VertexBits four) const { return sign_[four]; }

 private:
  std::vector<std::int8_t> sign_;  ///< by set
};

bool is_inside(unsigned set, unsigned other) { return (set & ~other) == 0; }

/// Whether the two meet in their common face only.
bool meet_properly(VertexBits s, VertexBits t, const PointSigns& sign) {
  bool properly = true;
  for_each_subset(static_cast<VertexBits>(s | t), 5, [&](VertexBits five) {
    const Circuit c = circuit_of(five, sign);
    if ((c.positive | c.negative) == 0) return;  // five points in a plane
    if (is_inside(c.positive, s) && is_inside(c.negative, t)) properly = false;
    if (is_inside(c.negative, s) && is_inside(c.positive, t)) properly = false;
  });
  return properly;
}

CatalogueFinding check_embedded(const Tetrahedra& tetrahedra, const std::vector<int>& signs,
                                const PointSigns& sign) {
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    if (sign(tetrahedra[t]) == signs[t]) continue;
    return BrokenLaw{CatalogueLaw::kOrientation, "the points of tetrahedron " +
                                                     digits_of(tetrahedra[t]) +
                                                     " are not oriented as they should be"};
  }
  for (std::size_t s = 0; s < tetrahedra.size(); ++s) {
    for (std::size_t t = s + 1; t < tetrahedra.size(); ++t) {
      if (meet_properly(tetrahedra[s], tetrahedra[t], sign)) continue;
      return BrokenLaw{CatalogueLaw::kEmbedded, "tetrahedra " + digits_of(tetrahedra[s]) + " and " +
                                                    digits_of(tetrahedra[t]) +
                                                    " meet outside their common face"};
    }
  }
  return std::nullopt;
}

CatalogueFinding check_convex(std::size_t points, const PointSigns& sign) {
  unsigned inner = 0;
  for_each_subset(static_cast<VertexBits>((1U << points) - 1U), 5, [&](VertexBits five) {
    const Circuit c = circuit_of(five, sign);
    if (std::popcount(c.positive) == 1) inner |= c.positive;
    if (std::popcount(c.negative) == 1) inner |= c.negative;
  });
  if (inner == 0) return std::nullopt;
  return BrokenLaw{CatalogueLaw::kConvex,
                   "point " + digits_of(static_cast<VertexBits>(inner & (0U - inner))) +
                       " is in the convex hull of others"};
}

}  // namespace

CatalogueFinding check_points(const Tetrahedra& tetrahedra, const std::vector<int>& signs,
                              const std::vector<LatticePoint>& points, Condition condition,
                              bool& undecided) {
  const PointSigns sign(points);
  CatalogueFinding found = check_embedded(tetrahedra, signs, sign);
  if (found || condition == Condition::kEmbedded) return found;
  if (condition == Condition::kConvex) return check_convex(points.size(), sign);
  const JacobianSign jacobian = jacobian_sign(points);
  if (jacobian == JacobianSign::kPositive) return std::nullopt;
  undecided = jacobian == JacobianSign::kUnknown;
  return BrokenLaw{CatalogueLaw::kJacobian,
                   undecided ? "the Jacobian determinant is neither shown positive nor found not "
                               "positive"
                             : "the Jacobian determinant is not positive everywhere"};
}

}  // namespace hexatlas::check
