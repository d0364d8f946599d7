#include "tables/sheet/contact_sheet_scene.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "tables/sheet/contact_sheet_occlusion.hpp"
#include "tables/sheet/contact_sheet_relax.hpp"

namespace hexatlas::sheet {
namespace {

using complex::VertexSet;

constexpr std::array<double, 3> kSpreads{1.1, 1.6, 2.2};
constexpr double kPixel = 3;

Frame frame_on(std::size_t vertices, Links edges, const std::vector<std::uint8_t>& facet) {
  // The square roots of the path lengths of the cube are the distances of its corners.
  auto distances = path_lengths(vertices, edges);
  for (auto& row : distances)
    for (double& distance : row) distance = std::sqrt(distance);
  std::vector<Vec> shape = stress_layout(distances, false);

  std::vector<Vec> on_facet;
  on_facet.reserve(facet.size());
  for (const std::uint8_t v : facet) on_facet.push_back(shape[v]);
  const Vec middle = mean(on_facet);
  const Vec side = unit(on_facet[1] - on_facet[0]);
  Vec up = unit(cross(side, on_facet[2] - on_facet[0]));
  if (dot(up, middle) > 0) up = -1 * up;
  const Vec third = cross(up, side);
  for (Vec& point : shape) point = {dot(side, point), dot(third, point), dot(up, point)};
  return {std::move(edges), std::move(shape)};
}

std::vector<Corners> moved_apart(const std::vector<Corners>& tetrahedra, double spread) {
  std::vector<Vec> centroids;
  centroids.reserve(tetrahedra.size());
  for (const Corners& t : tetrahedra) centroids.push_back(centroid(t));
  const Vec centre = mean(centroids);
  std::vector<Corners> moved = tetrahedra;
  for (std::size_t i = 0; i < moved.size(); ++i)
    for (Vec& corner : moved[i]) corner = corner + spread * (centroids[i] - centre);
  return moved;
}

/// Where to look from: a square of places around the upright axis, at three heights.
std::vector<Vec> eyes() {
  std::vector<Vec> all;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y) {
      if (std::max(std::abs(x), std::abs(y)) != 4) continue;
      const double around = length({static_cast<double>(x), static_cast<double>(y), 0});
      for (const double height : {0.25, 0.45, 0.7})
        all.push_back(unit({x / around, y / around, height}));
    }
  return all;
}

struct Look {
  Vec right, up, eye;
  explicit Look(Vec towards)
      : right(unit(cross({0, 0, 1}, towards))), up(cross(towards, right)), eye(towards) {}
  [[nodiscard]] Vec of(Vec p) const { return {dot(right, p), -dot(up, p), dot(eye, p)}; }
};

/// Turns everything to the eye and fits it into the tile.
void place(Scene& scene, const Look& look, double width, double height, double margin) {
  Rectangle box;
  for (Corners& piece : scene.pieces)
    for (Vec& corner : piece) box.include(corner = look.of(corner));
  for (Vec& vertex : scene.vertices) box.include(vertex = look.of(vertex));
  const double scale = std::min((width - 2 * margin) / (box.right - box.left),
                                (height - 2 * margin) / (box.bottom - box.top));
  const Vec middle{(box.left + box.right) / 2, (box.top + box.bottom) / 2, 0};
  const auto placed = [&](Vec p) { return scale * (p - middle) + Vec{width / 2, height / 2, 0}; };
  for (Corners& piece : scene.pieces)
    for (Vec& corner : piece) corner = placed(corner);
  for (Vec& vertex : scene.vertices) vertex = placed(vertex);
}

void fill(std::vector<std::size_t>& raster, std::size_t columns, const std::array<Vec, 3>& triangle,
          std::size_t colour) {
  Rectangle box;
  for (const Vec corner : triangle) box.include(corner);
  const auto side = [&](std::size_t i, Vec p) {
    const Vec a = triangle[i];
    const Vec b = triangle[(i + 1) % 3];
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  for (auto row = static_cast<std::size_t>(box.top / kPixel);
       static_cast<double>(row) * kPixel < box.bottom; ++row)
    for (auto column = static_cast<std::size_t>(box.left / kPixel);
         static_cast<double>(column) * kPixel < box.right; ++column) {
      const Vec p{(static_cast<double>(column) + 0.5) * kPixel,
                  (static_cast<double>(row) + 0.5) * kPixel, 0};
      const double a = side(0, p), b = side(1, p), c = side(2, p);
      if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))
        raster[row * columns + column] = colour;
    }
}

/// How well the tetrahedra are seen: the sum over them of the square root of the visible area times
/// the part of the whole outline that it is.
double seen(const Scene& scene, double width, double height) {
  const auto columns = static_cast<std::size_t>(width / kPixel) + 1;
  const auto rows = static_cast<std::size_t>(height / kPixel) + 1;
  const std::size_t n = scene.pieces.size();
  std::vector<std::size_t> raster(columns * rows, n);
  std::vector<double> whole(n, 0);
  for (const std::size_t i : scene.order)
    for (std::size_t k = 0; k < 4; ++k) {
      const Corners& t = scene.pieces[i];
      const std::array<Vec, 3> face{t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]};
      fill(raster, columns, face, i);
      // Front and back cover the outline once each, and a half of the area each time.
      whole[i] += std::abs(cross(face[1] - face[0], face[2] - face[0]).z) / 4;
    }
  std::vector<double> visible(n + 1, 0);
  for (const std::size_t i : raster) visible[i] += kPixel * kPixel;
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += std::sqrt(visible[i]) * std::min(1.0, visible[i] / std::max(whole[i], 1.0));
  return sum;
}

}  // namespace

Frame frame_of(const complex::Cell& cell) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& facet : cell.facets)
    for (std::size_t i = 0; i < facet.size; ++i) {
      const std::size_t a = facet.vertex[i];
      const std::size_t b = facet.vertex[(i + 1) % facet.size];
      edges.emplace(std::min(a, b), std::max(a, b));
    }
  return frame_on(static_cast<std::size_t>(cell.vertices), {edges.begin(), edges.end()},
                  {cell.facets[0].vertex.begin(), cell.facets[0].vertex.begin() + 3});
}

Frame frame_of(const complex::Triangulation& ball) {
  std::set<std::pair<std::size_t, std::size_t>> inner, outer;
  const auto insert_edges = [](auto& edges, VertexSet set) {
    for (VertexSet a = set; a != 0; a = complex::without_least(a))
      for (VertexSet b = complex::without_least(a); b != 0; b = complex::without_least(b))
        edges.emplace(complex::least_vertex(a), complex::least_vertex(b));
  };
  for (const VertexSet t : ball.tetrahedra) insert_edges(inner, t);
  const std::vector<VertexSet> triangles = complex::boundary_triangles(ball);
  for (const VertexSet t : triangles) insert_edges(outer, t);
  std::vector<std::uint8_t> facet;
  for (VertexSet t = triangles.front(); t != 0; t = complex::without_least(t))
    facet.push_back(static_cast<std::uint8_t>(complex::least_vertex(t)));
  Frame frame =
      frame_on(static_cast<std::size_t>(ball.vertices), {inner.begin(), inner.end()}, facet);
  frame.edges.assign(outer.begin(), outer.end());
  return frame;
}

std::vector<std::size_t> boundary_triangles_per_tetrahedron(
    const complex::Triangulation& triangulation) {
  const std::vector<VertexSet> triangles = complex::boundary_triangles(triangulation);
  std::vector<std::size_t> numbers;
  for (const VertexSet t : triangulation.tetrahedra)
    numbers.push_back(static_cast<std::size_t>(std::count_if(
        triangles.begin(), triangles.end(), [t](VertexSet f) { return (f & t) == f; })));
  return numbers;
}

Scene scene_of(const Frame& frame, const complex::Triangulation& triangulation,
               const certificate::Realization& points, double width, double height, double margin) {
  std::vector<Vec> given;
  for (const auto& point : points)
    given.push_back({static_cast<double>(point[0]), static_cast<double>(point[1]),
                     static_cast<double>(point[2])});
  const std::vector<Vec> vertices = relaxed(alike(given, frame.shape), triangulation);
  const std::vector<Corners> tetrahedra = corners_of(triangulation, vertices);
  const SeparatingNormals normals = separating_normals(moved_apart(tetrahedra, 1));

  Scene best;
  double most = -1;
  for (const double spread : kSpreads)
    for (const Vec eye : eyes()) {
      Scene scene{{}, moved_apart(tetrahedra, spread), vertices};
      place(scene, Look(eye), width, height, margin);
      PaintersOrder order = painters_order(scene.pieces, normals, eye);
      scene.order = std::move(order.order);
      const double score = seen(scene, width, height) * (order.is_sure ? 1 : 0.5);
      if (score <= most) continue;
      most = score;
      best = std::move(scene);
    }
  return best;
}

}  // namespace hexatlas::sheet
