#pragma once
/// \file
/// Private to the filling by lattices: vectors in double precision, for measures that decide
/// nothing but which of several right ways is taken.

#include <cmath>

#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/vector.hpp"

namespace hexatlas::hybrid {

using Vector = mesh::Point;

[[nodiscard]] inline Vector difference(const Vector& to, const Vector& from) noexcept {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

using quality::cross;
using quality::dot;

[[nodiscard]] inline double norm(const Vector& a) noexcept { return std::sqrt(dot(a, a)); }

[[nodiscard]] inline double distance(const Vector& a, const Vector& b) noexcept {
  return norm(difference(a, b));
}

}  // namespace hexatlas::hybrid
