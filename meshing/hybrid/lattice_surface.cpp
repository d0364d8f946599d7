#include "meshing/hybrid/lattice_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>

#include "enum/complex/union_find.hpp"
#include "enum/core/checks.hpp"
#include "meshing/hybrid/lattice.hpp"
#include "meshing/hybrid/lattice_vectors.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::hybrid {
namespace {

using complex::BrokenLaw;
using Index = mesh::Index;
using Triangle = ClosedSurface::Triangle;

/// Whether three points are on a line: so are their shadows on the three planes of coordinates.
bool are_on_a_line(const mesh::Point& a, const mesh::Point& b, const mesh::Point& c) {
  const auto is_flat = [](double ax, double ay, double bx, double by, double cx, double cy) {
    return exact::sign_of_orientation({ax, ay, 0}, {bx, by, 0}, {cx, cy, 0}, {ax, ay, 1}) ==
           exact::Sign::zero;
  };
  return is_flat(a.x, a.y, b.x, b.y, c.x, c.y) && is_flat(a.y, a.z, b.y, b.z, c.y, c.z) &&
         is_flat(a.z, a.x, b.z, b.x, c.z, c.x);
}

std::optional<BrokenLaw> fault_of_facets(const mesh::FacetMesh& surface) {
  if (surface.facets.empty()) return BrokenLaw{"the surface has no triangles"};
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    const mesh::Facet& facet = surface.facets[i];
    if (facet.size != 3)
      return BrokenLaw{
          "facet " + std::to_string(i) + " is a quad: the surface has to be of " + "triangles", i};
    const auto& v = facet.vertices;
    for (std::size_t k = 0; k < 3; ++k)
      core::expects(v[k] < surface.points.size() && mesh::is_finite(surface.points[v[k]]),
                    "indices of points with finite coordinates");
    if (are_on_a_line(surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]))
      return BrokenLaw{"triangle " + std::to_string(i) + " has no area", i};
  }
  return std::nullopt;
}

/// Of the points that are used.
std::optional<BrokenLaw> fault_of_places(const std::vector<mesh::Point>& points,
                                         std::vector<Index> used) {
  const auto place = [&](Index v) { return std::tuple(points[v].x, points[v].y, points[v].z); };
  std::sort(used.begin(), used.end(),
            [&](Index v, Index w) { return place(v) != place(w) ? place(v) < place(w) : v < w; });
  for (std::size_t i = 1; i < used.size(); ++i)
    if (points[used[i]] == points[used[i - 1]])
      return BrokenLaw{"points " + std::to_string(used[i - 1]) + " and " + std::to_string(used[i]) +
                       " of the surface are at the same place"};
  return std::nullopt;
}

std::optional<BrokenLaw> fault_of_edges(const std::vector<Triangle>& triangles) {
  std::map<std::array<Index, 2>, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      at[{low, high}].push_back(t);
    }
  for (const auto& [edge, owners] : at) {
    const std::string name = std::to_string(edge[0]) + " " + std::to_string(edge[1]);
    if (owners.size() != 2)
      return BrokenLaw{"the surface is not closed: the edge " + name + " is in " +
                           std::to_string(owners.size()) + " triangles, not in 2",
                       owners[0]};
    const Triangle& first = triangles[owners[0]];
    if (std::is_permutation(first.begin(), first.end(), triangles[owners[1]].begin()))
      return BrokenLaw{"triangles " + std::to_string(owners[0]) + " and " +
                           std::to_string(owners[1]) + " have the same vertices",
                       owners[1]};
  }
  return std::nullopt;
}

}  // namespace

std::variant<ClosedSurface, BrokenLaw> ClosedSurface::of(const mesh::FacetMesh& surface,
                                                         double flatness) {
  if (auto fault = fault_of_facets(surface)) return *fault;
  std::vector<Index> renamed(surface.points.size(), kNone);
  for (const mesh::Facet& facet : surface.facets)
    for (std::size_t k = 0; k < 3; ++k) renamed[facet.vertices[k]] = 0;
  ClosedSurface result(flatness);
  std::vector<Index> used;
  for (std::size_t v = 0; v < renamed.size(); ++v) {
    if (renamed[v] == kNone) continue;
    renamed[v] = static_cast<Index>(used.size());
    used.push_back(static_cast<Index>(v));
    result.points_.push_back(surface.points[v]);
  }
  std::vector<Triangle> as_given;
  for (const mesh::Facet& facet : surface.facets) {
    const auto& v = facet.vertices;
    as_given.push_back({v[0], v[1], v[2]});
    result.triangles_.push_back({renamed[v[0]], renamed[v[1]], renamed[v[2]]});
  }
  if (auto fault = fault_of_edges(as_given)) return *fault;
  if (auto fault = fault_of_places(surface.points, used)) return *fault;
  result.at_.reserve(result.triangles_.size() * 3 / 2);
  for (std::uint32_t t = 0; t < result.triangles_.size(); ++t) result.attach(t);
  result.colour();
  return result;
}

bool ClosedSurface::has_triangle(Index a, Index b, Index c) const {
  const auto found = at_.find(key(a, b));
  if (found == at_.end()) return false;
  return third(found->second[0], a, b) == c || third(found->second[1], a, b) == c;
}

std::vector<ClosedSurface::Edge> ClosedSurface::edges() const {
  std::vector<Edge> result;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangles_[t][k];
      const Index b = triangles_[t][(k + 1) % 3];
      const Pair& pair = at_.at(key(a, b));
      if (std::min(pair[0], pair[1]) == t) result.push_back({a, b});
    }
  return result;
}

ClosedSurface::Edge ClosedSurface::opposite(Index a, Index b) const {
  const Pair& pair = at_.at(key(a, b));
  return {third(pair[0], a, b), third(pair[1], a, b)};
}

ClosedSurface::Index ClosedSurface::third(std::uint32_t triangle, Index a, Index b) const {
  for (const Index v : triangles_[triangle])
    if (v != a && v != b) return v;
  return a;
}

bool ClosedSurface::can_exchange(Index a, Index b) const {
  const auto [c, d] = opposite(a, b);
  if (has_edge(c, d)) return false;
  const Vector ab = difference(points_[b], points_[a]);
  const Vector ac = difference(points_[c], points_[a]);
  const Vector ad = difference(points_[d], points_[a]);
  const Vector up = cross(ab, ac);
  if (!(std::abs(dot(up, ad)) <= flatness_ * norm(up) * norm(ab))) return false;
  const Vector cd = difference(points_[d], points_[c]);
  constexpr double kLeastShare = 1e-6;  // of the area: else a new triangle would have nearly none
  const double least = kLeastShare * dot(up, up);
  const double at_a = dot(up, cross(cd, difference(points_[a], points_[c])));
  const double at_b = dot(up, cross(cd, difference(points_[b], points_[c])));
  return dot(up, cross(ad, ab)) > 0 && at_a < -least && at_b > least;
}

void ClosedSurface::exchange(Index a, Index b) {
  const Pair pair = at_.at(key(a, b));
  const auto [c, d] = opposite(a, b);
  at_.erase(key(a, b));
  at_.emplace(key(c, d), pair);
  // Each triangle keeps its place among the triangles of the two sides that stay at it.
  const auto replace_owner = [&](Index v, Index w, std::uint32_t from, std::uint32_t to) {
    Pair& owners = at_.at(key(v, w));
    *std::find(owners.begin(), owners.end(), from) = to;
  };
  replace_owner(b, c, pair[0], pair[1]);
  replace_owner(a, d, pair[1], pair[0]);
  triangles_[pair[0]] = {a, d, c};
  triangles_[pair[1]] = {b, c, d};
}

bool ClosedSurface::is_delaunay(Index a, Index b) const {
  const auto [c, d] = opposite(a, b);
  const auto at = [&](Index v) {
    const Vector to_a = difference(points_[a], points_[v]);
    const Vector to_b = difference(points_[b], points_[v]);
    return std::array{dot(to_a, to_b), norm(cross(to_a, to_b))};
  };
  const auto [cos_c, sin_c] = at(c);
  const auto [cos_d, sin_d] = at(d);
  const double size = std::hypot(cos_c, sin_c) * std::hypot(cos_d, sin_d);
  constexpr double kTie = 1e-9;  // of the sine of the sum of the angles
  return cos_c * sin_d + sin_c * cos_d >= -kTie * size;
}

std::size_t ClosedSurface::make_flat_parts_delaunay() {
  std::vector<Edge> open = edges();
  const std::size_t most = 20 * open.size();  // rounding could make it go round in circles
  std::size_t count = 0;
  while (!open.empty() && count < most) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (!has_edge(a, b) || is_delaunay(a, b) || !can_exchange(a, b)) continue;
    const auto [c, d] = opposite(a, b);
    exchange(a, b);
    ++count;
    for (const Edge& side : {Edge{a, c}, Edge{c, b}, Edge{b, d}, Edge{d, a}}) open.push_back(side);
  }
  return count;
}

void ClosedSurface::split(Index a, Index b) {
  const Pair pair = at_.at(key(a, b));
  const mesh::Point& p = points_[a];
  const mesh::Point& q = points_[b];
  const auto middle = static_cast<Index>(points_.size());
  points_.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
  at_.erase(key(a, b));
  for (const std::uint32_t t : pair) {
    const auto fresh = static_cast<std::uint32_t>(triangles_.size());
    Triangle one = triangles_[t];
    Triangle other = one;
    std::replace(one.begin(), one.end(), b, middle);
    std::replace(other.begin(), other.end(), a, middle);
    const Index apex = third(t, a, b);
    Pair& owners = at_.at(key(b, apex));
    *std::find(owners.begin(), owners.end(), t) = fresh;
    triangles_[t] = one;
    triangles_.push_back(other);
    colours_.push_back(colours_[t]);
    at_.emplace(key(middle, apex), Pair{t, fresh});
  }
  const auto count = static_cast<std::uint32_t>(triangles_.size());
  at_.emplace(key(a, middle), pair);
  at_.emplace(key(middle, b), Pair{count - 2, count - 1});
}

void ClosedSurface::attach(std::uint32_t triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto edge = key(triangles_[triangle][k], triangles_[triangle][(k + 1) % 3]);
    const auto [it, is_new] = at_.try_emplace(edge, Pair{triangle, kNone});
    if (!is_new) it->second[1] = triangle;
  }
}

void ClosedSurface::colour() {
  const double least = std::cos(kSharpAngle * std::numbers::pi / 180);
  complex::UnionFind patches(triangles_.size());
  for (const auto& [a, b] : edges()) {
    const auto [c, d] = opposite(a, b);
    const Vector ab = difference(points_[b], points_[a]);
    const Vector left = cross(ab, difference(points_[c], points_[a]));
    const Vector right = cross(difference(points_[d], points_[a]), ab);
    const Pair& pair = at_.at(key(a, b));
    if (dot(left, right) >= least * norm(left) * norm(right)) patches.unite(pair[0], pair[1]);
  }
  std::map<std::size_t, std::uint32_t> names;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    colours_.push_back(names.try_emplace(patches.find(t), names.size()).first->second);
}

}  // namespace hexatlas::hybrid
