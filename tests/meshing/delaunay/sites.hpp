#pragma once
/// \file
/// Sites as the parts of meshing/delaunay have them, without a Builder.

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "meshing/delaunay/site.hpp"
#include "realize/exact/orientation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"

namespace hexatlas::delaunay_tests {

/// None, the ghost vertex, and the points.
template <class KeyOf>
std::vector<delaunay::Site> sites_of(const Cloud& points, KeyOf&& key_of) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  std::vector<delaunay::Site> sites(2, {kNowhere, kNowhere, kNowhere, 0});
  for (const mesh::Point& p : points) sites.push_back({p.x, p.y, p.z, key_of(p)});
  return sites;
}

/// Those of the first four points, right-handed. Requires that they span space.
template <class Index>
std::array<Index, 4> first_four(const std::vector<delaunay::Site>& sites) {
  std::array<Index, 4> first{2, 3, 4, 5};
  if (exact::sign_of_orientation(sites[2].point(), sites[3].point(), sites[4].point(),
                                 sites[5].point()) == exact::Sign::negative)
    std::swap(first[0], first[1]);
  return first;
}

}  // namespace hexatlas::delaunay_tests
