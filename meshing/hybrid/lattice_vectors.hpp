#pragma once
/// \file
/// Private to the filling by lattices: vectors in double precision, for measures that decide
/// nothing but which of several right ways is taken.

#include <cmath>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

using Vector = mesh::Point;

[[nodiscard]] inline Vector difference(const Vector& to, const Vector& from) noexcept {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline double dot(const Vector& a, const Vector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline double norm(const Vector& a) noexcept { return std::sqrt(dot(a, a)); }

[[nodiscard]] inline double distance(const Vector& a, const Vector& b) noexcept {
  return norm(difference(a, b));
}

}  // namespace hexatlas::hybrid
