#include "tables/sheet/contact_sheet_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hexatlas::sheet {
namespace {

using complex::VertexSet;

constexpr double kMargin = 9;
constexpr int kLights = 8;

struct Colour {
  int red, green, blue;
};
/// By number of boundary triangles; clearly different, in lightness too, for colour-blind eyes.
/// Three tints of each, so that neighbours with the same number are told apart.
constexpr std::array<std::array<Colour, 3>, 5> kColours{
    {{{{203, 70, 46}, {224, 118, 78}, {168, 44, 62}}},
     {{{238, 178, 74}, {247, 212, 122}, {214, 148, 52}}},
     {{{108, 178, 160}, {152, 202, 150}, {72, 150, 150}}},
     {{{92, 128, 190}, {136, 168, 220}, {92, 94, 170}}},
     {{{150, 130, 170}, {150, 130, 170}, {150, 130, 170}}}}};

std::string hex_of(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

/// Towards black below 0.65, towards white above.
Colour lit(Colour colour, double light) {
  const auto channel = [light](int value) {
    const double mixed =
        light < 0.65 ? value * (0.5 + light / 1.3) : value + (255 - value) * (light - 0.65) * 1.3;
    return static_cast<int>(std::lround(mixed));
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

std::string at(Vec p) { return decimal(p.x) + " " + decimal(p.y); }

std::string line_path(Vec a, Vec b) { return "M" + at(a) + "L" + at(b); }

/// An arc on the side away from the middle of the tile.
std::string bow_path(Vec a, Vec b) {
  const Vec middle = 0.5 * (a + b);
  constexpr double kHighest = 16;
  Vec across{a.y - b.y, b.x - a.x, 0};
  if (dot(across, middle - Vec{kTileWidth / 2, kTileHeight / 2, 0}) < 0) across = -1 * across;
  return "M" + at(a) + "Q" + at(middle + std::min(0.3, kHighest / length(across)) * across) + " " +
         at(b);
}

std::string path(std::string_view style, const std::string& lines) {
  return lines.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", style, lines);
}

/// Index of the light of a face with this outward normal on the screen; the lamp is up left.
int light_of(Vec outward) {
  const Vec lamp = unit({-0.45, -0.75, 0.6});
  const double light = 0.5 + 0.5 * dot(unit(outward), lamp);
  return std::clamp(static_cast<int>(light * kLights), 0, kLights - 1);
}

/// The outward normal of the face opposite to corner k.
Vec outward_normal(const Corners& t, std::size_t k) {
  const Vec on = t[(k + 1) % 4];
  const Vec normal = cross(t[(k + 2) % 4] - on, t[(k + 3) % 4] - on);
  return dot(normal, t[k] - on) > 0 ? -1 * normal : normal;
}

/// The faces turned to the eye, then the edges behind them.
std::string piece_drawing(const Corners& t, std::size_t kind, std::size_t tint) {
  std::string text;
  std::array<bool, 4> is_front{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec normal = outward_normal(t, k);
    is_front[k] = normal.z > 1e-9 * length(normal);
    if (!is_front[k]) continue;
    text +=
        fmt::format("<polygon class=\"k{}{}{}\" points=\"{} {} {}\"/>", kind, tint,
                    light_of(normal), at(t[(k + 1) % 4]), at(t[(k + 2) % 4]), at(t[(k + 3) % 4]));
  }
  std::string
      hidden;  // an edge is common to the two faces that are opposite to neither of its ends
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b) {
      bool is_hidden = true;
      for (std::size_t k = 0; k < 4; ++k)
        if (k != a && k != b && is_front[k]) is_hidden = false;
      if (is_hidden) hidden += line_path(t[a], t[b]);
    }
  return text + path("h", hidden);
}

std::string label(std::string_view style, Vec p, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>", style, decimal(p.x),
                     decimal(p.y), text);
}

std::string vertex_labels(const Scene& scene) {
  Vec middle = mean(scene.vertices);
  std::string text;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const Vec p = scene.vertices[v];
    Vec away{p.x - middle.x, p.y - middle.y, 0};
    away = length(away) < 1 ? Vec{0, -1, 0} : unit(away);
    Vec place = p + 6.5 * away + Vec{0, 3, 0};
    place.x = std::clamp(place.x, 4.0, kTileWidth - 4);
    place.y = std::clamp(place.y, 9.0, kTileHeight - 3);
    text += label("v", place, digits_of(complex::bit_of(static_cast<int>(v))));
  }
  return text;
}

std::string frame_drawing(const Frame& frame, const Scene& scene) {
  std::string visible, hidden;
  for (const auto& [from, to] : frame.edges) {
    const Vec a = scene.vertices[from];
    const Vec b = scene.vertices[to];
    const auto on = [&](double t) { return a + t * (b - a); };
    double end = 0;
    for (const auto& part : visible_parts(a, b, scene.pieces)) {
      if (part.first > end) hidden += line_path(on(end), on(part.first));
      visible += line_path(on(part.first), on(part.second));
      end = part.second;
    }
    if (end < 1) hidden += line_path(on(end), b);
  }
  return path("g", hidden) + path("f", visible);
}

Links dual_links(const complex::Triangulation& triangulation) {
  Links links;
  const auto& tetrahedra = triangulation.tetrahedra;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    for (std::size_t j = i + 1; j < tetrahedra.size(); ++j)
      if (std::popcount(static_cast<unsigned>(tetrahedra[i] & tetrahedra[j])) == 3)
        links.emplace_back(i, j);
  return links;
}

/// Per quad the two tetrahedra at its halves, if they are two.
Links quad_links(const complex::Triangulation& triangulation, const complex::Cell& cell) {
  const std::vector<VertexSet> boundary = complex::boundary_triangles(triangulation);
  Links links;
  for (const auto& facet : cell.facets) {
    if (facet.size != 4) continue;
    std::vector<std::size_t> ends;
    for (const VertexSet triangle : boundary) {
      if ((triangle & ~facet.vertices()) != 0) continue;
      for (std::size_t i = 0; i < triangulation.tetrahedra.size(); ++i)
        if ((triangle & ~triangulation.tetrahedra[i]) == 0) ends.push_back(i);
    }
    if (ends.size() == 2 && ends[0] != ends[1])
      links.emplace_back(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
  }
  return links;
}

/// Room is left for arcs and, below, for a note.
std::vector<Vec> fitted(std::vector<Vec> nodes) {
  constexpr double kRoom = 18, kNote = 12, kLongest = 60;
  Vec low = nodes.front(), high = low;
  for (const Vec node : nodes) {
    low = {std::min(low.x, node.x), std::min(low.y, node.y), 0};
    high = {std::max(high.x, node.x), std::max(high.y, node.y), 0};
  }
  const double scale =
      std::min({(kTileWidth - 2 * kRoom) / std::max(high.x - low.x, 1e-9),
                (kTileHeight - 2 * kRoom - kNote) / std::max(high.y - low.y, 1e-9), kLongest});
  for (Vec& node : nodes)
    node = scale * (node - 0.5 * (low + high)) + Vec{kTileWidth / 2, (kTileHeight - kNote) / 2, 0};
  return nodes;
}

}  // namespace

std::string decimal(double number) {
  const long long tenths = std::llround(number * 10);
  std::string text = tenths < 0 ? "-" : "";
  text += std::to_string(std::llabs(tenths) / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(std::llabs(tenths) % 10);
  return text;
}

std::string digits_of(VertexSet set) {
  std::string text;
  for (; set != 0; set = complex::without_least(set))
    text += "0123456789abcdef"[complex::least_vertex(set)];
  return text;
}

std::string colour_rules() {
  std::string text;
  for (std::size_t kind = 0; kind < kColours.size(); ++kind) {
    for (std::size_t tint = 0; tint < kColours[kind].size(); ++tint)
      for (int light = 0; light < kLights; ++light)
        text += fmt::format(".k{}{}{}{{fill:{}}}", kind, tint, light,
                            hex_of(lit(kColours[kind][tint], (light + 0.5) / kLights)));
    text += fmt::format(".d{}{{fill:{}}}\n", kind, hex_of(kColours[kind][0]));
  }
  return text;
}

std::string exploded_drawing(const Frame& frame, const complex::Triangulation& triangulation,
                             const certificate::Realization& points) {
  const Scene scene = scene_of(frame, triangulation, points, kTileWidth, kTileHeight, kMargin);
  const std::vector<std::size_t> kinds = boundary_triangles_per_tetrahedron(triangulation);
  std::vector<std::size_t> tints;  // in turn for each kind
  std::array<std::size_t, kColours.size()> turn{};
  tints.reserve(kinds.size());
  for (const std::size_t kind : kinds) tints.push_back(turn[kind]++ % kColours[kind].size());
  std::string text = "<g class=\"t\">";
  for (const std::size_t i : scene.order)
    text += piece_drawing(scene.pieces[i], kinds[i], tints[i]);
  return text + "</g>" + frame_drawing(frame, scene) + vertex_labels(scene);
}

std::string graph_drawing(const complex::Triangulation& triangulation,
                          const std::optional<complex::Cell>& cell) {
  const Links links = dual_links(triangulation);
  const std::size_t n = triangulation.tetrahedra.size();
  auto distances = path_lengths(n, links);
  for (auto& row : distances)
    for (double& distance : row)
      distance = std::sqrt(distance * std::sqrt(distance));  // less crowded
  const std::vector<Vec> nodes = fitted(stress_layout(distances, true));
  std::string solid, dashed;
  for (const auto& [a, b] : links) solid += line_path(nodes[a], nodes[b]);
  if (cell)
    for (const auto& [a, b] : quad_links(triangulation, *cell)) {
      const bool is_double = std::find(links.begin(), links.end(), std::pair(a, b)) != links.end();
      dashed += is_double ? bow_path(nodes[a], nodes[b]) : line_path(nodes[a], nodes[b]);
    }
  std::string text = path("q", dashed) + path("f", solid);
  const std::vector<std::size_t> kinds = boundary_triangles_per_tetrahedron(triangulation);
  for (std::size_t i = 0; i < n; ++i)
    text += fmt::format("<circle class=\"n d{}\" cx=\"{}\" cy=\"{}\" r=\"10.5\"/>", kinds[i],
                        decimal(nodes[i].x), decimal(nodes[i].y)) +
            label("m", nodes[i] + Vec{0, 2.6, 0}, digits_of(triangulation.tetrahedra[i]));
  return text;
}

}  // namespace hexatlas::sheet
