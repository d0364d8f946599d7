#pragma once
/// \file
/// Products of vectors in double precision.

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::quality {

[[nodiscard]] inline double dot(const mesh::Point& a, const mesh::Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline mesh::Point cross(const mesh::Point& a, const mesh::Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace hexatlas::quality
