#pragma once
/// \file
/// Whether integer points realize a triangulation under a condition: the exact decision.
///
/// Definition. docs/theory/triangulation-definition.txt, for points in general position (no four in
/// a plane), which are enough since the conditions are open. The signs of the tetrahedra are given;
/// their convention is that of docs/formats/catalogue.md.
///
/// Method. In general position five points C have exactly one Radon partition C = P + N. If it is
/// forbidden, the condition fails:
///   embedded, jacobian: P and N are both faces of tetrahedra;
///   convex: so, or P or N is a single vertex.
/// Proof for embedded. A point common to tetrahedra s and t but not to their common face gives an
/// affine dependence with its positive part in s and its negative part in t; one of its conformal
/// circuits is such a partition. Conversely, the common point of conv P and conv N, P in s and N in
/// t, is in the common face only if P and N are, which have five points together. The Jacobian
/// determinant is judged by realize/exact/jacobian.hpp.
///
/// Cost. Preparation 2^n + C(n,5) words; a decision C(n,4) determinants and C(n,5) look-ups, about
/// a microsecond for n = 8; tens of microseconds more for the Jacobian determinant.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"

namespace hexatlas::conditions {

/// Least index first of what fails.
enum class PointsVerdict : std::uint8_t {
  satisfied,
  out_of_range,          ///< a coordinate of absolute value 2^20 or more
  degenerate,            ///< four points in a plane
  wrong_sign,            ///< of a tetrahedron
  forbidden_partition,   ///< two tetrahedra meet improperly, or a point is inside the others' hull
  jacobian_not_positive  ///< or not known to be positive after kJacobianDepth subdivisions
};

inline constexpr int kJacobianDepth = 6;

class PointsJudge {
 public:
  /// Requires: 4 to 16 vertices; a sign +1 or -1 per tetrahedron; eight vertices, numbered as the
  /// cube, for the condition jacobian. Else PreconditionViolated.
  PointsJudge(const complex::Triangulation& triangulation, std::span<const int> signs,
              certificate::Condition condition);

  /// Exact. Requires a point per vertex, else PreconditionViolated.
  [[nodiscard]] PointsVerdict verdict(std::span<const certificate::IntegerPoint> points) const;

  /// The number of degenerate four-point sets, of tetrahedra with a wrong sign, and of forbidden
  /// partitions, for a descent over integer points: 0 exactly if `verdict` is satisfied,
  /// apart from the Jacobian determinant. Points must be in range.
  [[nodiscard]] int violations(std::span<const certificate::IntegerPoint> points) const;

 private:
  struct Quadruple {
    std::array<std::uint8_t, 4> vertices;  ///< ascending
    std::int8_t required;                  ///< +1 or -1: a tetrahedron; 0: any
  };
  struct Quintuple {
    std::array<std::uint8_t, 5> vertices;  ///< ascending
    std::array<std::uint16_t, 5> without;  ///< index of the quadruple without the i-th vertex
  };
  struct Count {
    int degenerate = 0, wrong = 0, forbidden = 0;
  };

  void list_subsets(const complex::Triangulation& triangulation, std::span<const int> signs);
  void mark_faces(const complex::Triangulation& triangulation);
  [[nodiscard]] Count count(std::span<const certificate::IntegerPoint> points) const;
  [[nodiscard]] bool forbidden(const Quintuple& five,
                               std::span<const std::int8_t> signs) const noexcept;

  int vertices_;
  certificate::Condition condition_;
  std::vector<Quadruple> quadruples_;  ///< by variable - 1
  std::vector<Quintuple> quintuples_;
  std::vector<std::uint8_t> is_face_;  ///< by set of vertices
};

}  // namespace hexatlas::conditions
