#include "meshing/quality/self_meeting.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "meshing/quality/box_tree.hpp"
#include "realize/exact/patch.hpp"
#include "realize/exact/patch_separation.hpp"

namespace hexatlas::quality {
namespace {

using Quad = std::array<mesh::Index, 4>;

exact::Point3 as_exact(const mesh::Point& p) { return {p.x, p.y, p.z}; }

exact::Patch patch_of(const mesh::SurfaceMesh& surface, const Quad& quad) {
  exact::Patch result{};
  std::transform(quad.begin(), quad.end(), result.begin(),
                 [&](mesh::Index v) { return as_exact(surface.points[v]); });
  return result;
}

Box box_of_quad(const mesh::SurfaceMesh& surface, const Quad& quad) {
  std::array<mesh::Point, 4> points{};
  std::transform(quad.begin(), quad.end(), points.begin(),
                 [&](mesh::Index v) { return surface.points[v]; });
  return box_of(points);
}

bool has(const Quad& quad, mesh::Index v) {
  return std::find(quad.begin(), quad.end(), v) != quad.end();
}

bool has_edge(const Quad& quad, mesh::Index v, mesh::Index w) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::minmax(quad[i], quad[(i + 1) % 4]) == std::minmax(v, w)) return true;
  return false;
}

exact::Twins twins_of(const Quad& first, const Quad& second) {
  exact::Twins twin{};
  for (std::size_t i = 0; i < 4; ++i)
    twin[i] = static_cast<std::uint8_t>(std::find(second.begin(), second.end(), first[i]) -
                                        second.begin());
  return twin;
}

class Search {
 public:
  explicit Search(const mesh::SurfaceMesh& surface) : surface_(surface) {}

  [[nodiscard]] std::optional<SelfMeeting> run() const {
    const auto count = static_cast<std::uint32_t>(surface_.quads.size());
    std::vector<Box> boxes;
    boxes.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Quad& quad = surface_.quads[i];
      if (exact::is_folded(patch_of(surface_, quad))) return SelfMeeting{i, i};
      boxes.push_back(box_of_quad(surface_, quad));
    }
    const BoxTree tree(std::move(boxes));
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < count; ++i) {
      tree.later_meeting(i, near);
      for (const std::uint32_t j : near)
        if (meet_wrongly(surface_.quads[i], surface_.quads[j])) return SelfMeeting{i, j};
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool meet_wrongly(const Quad& first, const Quad& second) const {
    const exact::Patch a = patch_of(surface_, first);
    const exact::Patch b = patch_of(surface_, second);
    if (exact::separated(a, b, twins_of(first, second))) return false;
    return edge_meets(first, second, b) || edge_meets(second, first, a);
  }

  /// Of a quad that is not folded, an edge meets what is shared in its own shared ends only.
  [[nodiscard]] bool edge_meets(const Quad& quad, const Quad& other,
                                const exact::Patch& patch) const {
    const Box around = box_of_quad(surface_, other);
    for (std::size_t i = 0; i < 4; ++i) {
      const mesh::Index v = quad[i];
      const mesh::Index w = quad[(i + 1) % 4];
      if (has_edge(other, v, w)) continue;
      const std::array ends{surface_.points[v], surface_.points[w]};
      if (!box_of(ends).meets(around)) continue;
      if (exact::meets({as_exact(ends[0]), as_exact(ends[1]), has(other, v), has(other, w)}, patch))
        return true;
    }
    return false;
  }

  const mesh::SurfaceMesh& surface_;
};

}  // namespace

std::optional<SelfMeeting> first_self_meeting(const mesh::SurfaceMesh& surface) {
  core::expects(surface.quads.size() <= std::numeric_limits<std::uint32_t>::max(),
                "self meeting: too many quads");
  for (const Quad& quad : surface.quads)
    for (const mesh::Index v : quad)
      core::expects(v < surface.points.size(), "self meeting: no such point");
  return Search(surface).run();
}

}  // namespace hexatlas::quality
