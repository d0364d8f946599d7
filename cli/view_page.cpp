#include "cli/view_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/output.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/vtu_data.hpp"
#include "meshing/quality/report.hpp"
#include "meshing/view/structure.hpp"

namespace hexatlas::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Bits of the status of a hexahedron on the page, besides quality::Validity in its order.
constexpr std::uint8_t kInverted = 4;

/// The named arrays of the page, as elements that hold base64.
class Data {
 public:
  template <class Number, class Numbers>
  void add(const char* name, const Numbers& numbers) {
    std::string bytes;
    for (const auto& number : numbers) io::append_little(bytes, static_cast<Number>(number));
    add_bytes(name, bytes);
  }
  void add_bytes(const char* name, std::string_view bytes) {
    html_ += fmt::format("<script type=\"application/octet-stream\" id=\"data-{}\">{}</script>\n",
                         name, io::to_base64(bytes));
  }
  void add_edges(const std::vector<view::Edge>& edges) {
    std::vector<std::uint32_t> numbers;
    for (const view::Edge& edge : edges)
      numbers.insert(numbers.end(), {edge.a, edge.b, edge.valence, edge.is_boundary ? 1U : 0U});
    add<std::uint32_t>("edges", numbers);
  }
  [[nodiscard]] const std::string& html() const { return html_; }

 private:
  std::string html_;
};

struct Frame {
  std::array<double, 3> centre{};
  double scale = 1;  ///< half of the longest side
};

/// Halves are added, not sums halved: coordinates may be close to the largest double.
template <class Cells>
Frame frame_of(const std::vector<mesh::Point>& points, const Cells& cells) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const auto& cell : cells)
    for (const mesh::Index v : cell) {
      const std::array<double, 3> at{points[v].x, points[v].y, points[v].z};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
  Frame frame{{}, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    frame.centre[k] = low[k] / 2 + high[k] / 2;
    frame.scale = std::max(frame.scale, high[k] / 2 - low[k] / 2);
  }
  if (frame.scale == 0) frame.scale = 1;
  return frame;
}

void add_points(Data& data, const std::vector<mesh::Point>& points, const Frame& frame) {
  std::vector<double> numbers;
  for (const mesh::Point& p : points) {
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k)  // points that no cell uses may be anywhere
      numbers.push_back(std::clamp((at[k] - frame.centre[k]) / frame.scale, -1e30, 1e30));
  }
  data.add<float>("points", numbers);
}

template <class Cells>
std::vector<mesh::Index> flat(const Cells& cells) {
  std::vector<mesh::Index> numbers;
  for (const auto& cell : cells) numbers.insert(numbers.end(), cell.begin(), cell.end());
  return numbers;
}

Json json_of(const ViewState& state, const std::string& usual_colour) {
  const auto shows = [&](const char* kind) {
    return state.singular == "all" || state.singular == kind;
  };
  Json json;
  json["colour"] = state.colour.empty() ? usual_colour : state.colour;
  json["slice"] = {{"on", state.is_sliced},
                   {"axis", state.slice_axis},
                   {"at", state.slice_at},
                   {"flip", state.is_flipped},
                   {"normal", {1, 0, 0}}};
  json["peel"] = state.peel;
  json["explode"] = state.explode;
  json["shrink"] = state.shrink;
  json["singular"] = {{"interior", shows("interior")}, {"boundary", shows("boundary")}};
  json["outline"] = true;
  json["camera"] = {state.azimuth, state.elevation};
  return json;
}

Json about(const PageRequest& request, const char* kind, const Frame& frame) {
  Json json;
  json["name"] = request.name;
  json["kind"] = kind;
  json["centre"] = frame.centre;
  json["scale"] = frame.scale;
  json["layers"] = 1;
  json["picture"] = nullptr;
  if (request.picture) json["picture"] = *request.picture;
  return json;
}

std::string assembled(const Json& json, const Data& data) {
  std::string text = to_line(json);
  text.pop_back();
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");  // a name may hold the end of a script
  const PageParts parts = page_parts();
  return fmt::format("{}<script type=\"application/json\" id=\"data-about\">{}</script>\n{}{}",
                     parts.before, text, data.html(), parts.after);
}

/// What the page knows of the quality of each hexahedron.
struct Qualities {
  std::vector<double> jacobians;
  std::string status;
  std::size_t valid = 0, inverted = 0, undecided = 0;
  double least = 1, sum = 0;
};

Qualities qualities_of(const mesh::HexMesh& mesh) {
  Qualities result;
  for (const auto& hexahedron : mesh.hexahedra) {
    const quality::Corners corners = quality::corners_of<8>(mesh.points, hexahedron);
    const quality::Verdict verdict = quality::verdict_of_hexahedron(corners);
    const double jacobian = quality::scaled_jacobian(corners);
    result.jacobians.push_back(jacobian);
    result.least = std::min(result.least, jacobian);
    result.sum += jacobian;
    result.valid += verdict.validity == quality::Validity::valid ? 1 : 0;
    result.undecided += verdict.validity == quality::Validity::undecided ? 1 : 0;
    result.inverted += verdict.inverted ? 1 : 0;
    result.status.push_back(static_cast<char>(static_cast<unsigned>(verdict.validity) |
                                              (verdict.inverted ? kInverted : 0U)));
  }
  return result;
}

}  // namespace

Page page_of(const mesh::HexMesh& mesh, const PageRequest& request) {
  const view::Neighbours neighbours = view::neighbours_of(mesh);
  const std::vector<std::uint32_t> layers = view::layers_of(neighbours);
  const std::vector<view::Edge> edges = view::singular_edges(mesh, neighbours);
  const view::VertexCounts vertices = view::count_vertices(mesh, neighbours);
  const Qualities qualities = qualities_of(mesh);
  const std::size_t count = mesh.hexahedra.size();
  const std::size_t depth = std::size_t{*std::max_element(layers.begin(), layers.end())} + 1;

  const Frame frame = frame_of(mesh.points, mesh.hexahedra);
  Json json = about(request, "hexahedra", frame);
  json["layers"] = depth;
  json["minScaledJacobian"] = qualities.least;
  json["meanScaledJacobian"] = qualities.sum / static_cast<double>(count);
  json["counts"] = {{"hexahedra", count},
                    {"vertices", vertices.used},
                    {"interior", vertices.interior},
                    {"valid", qualities.valid},
                    {"inverted", qualities.inverted},
                    {"undecided", qualities.undecided}};
  json["state"] = json_of(request.state, "jacobian");

  Data data;
  add_points(data, mesh.points, frame);
  data.add<std::uint32_t>("cells", flat(mesh.hexahedra));
  data.add<std::uint32_t>("neighbours", flat(neighbours));
  data.add<std::uint32_t>("layers", layers);
  data.add<float>("jacobians", qualities.jacobians);
  data.add_bytes("status", qualities.status);
  data.add_edges(edges);

  const auto inside = static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const view::Edge& edge) { return !edge.is_boundary; }));
  return {assembled(json, data),
          fmt::format("{} in {}, {} ({} interior), {} ({} interior)",
                      counted(count, "hexahedron", "hexahedra"), counted(depth, "layer", "layers"),
                      counted(vertices.used, "vertex", "vertices"), vertices.interior,
                      counted(edges.size(), "singular edge", "singular edges"), inside),
          count, depth};
}

Page page_of(const mesh::HybridMesh& mesh, const PageRequest& request) {
  const view::Solids solids = view::solids_of(mesh);
  const view::Neighbours neighbours = view::neighbours_of(solids);
  const std::vector<std::uint32_t> layers = view::layers_of(neighbours);
  const view::VertexCounts vertices = view::count_vertices(solids, neighbours);
  const std::size_t depth = std::size_t{*std::max_element(layers.begin(), layers.end())} + 1;

  const Frame frame = frame_of(mesh.points, solids.corners);
  Json json = about(request, "hybrid", frame);
  json["layers"] = depth;
  json["counts"] = {{"tetrahedra", mesh.tetrahedra.size()},
                    {"hexahedra", mesh.hexahedra.size()},
                    {"prisms", mesh.prisms.size()},
                    {"pyramids", mesh.pyramids.size()},
                    {"vertices", vertices.used},
                    {"interior", vertices.interior}};
  json["state"] = json_of(request.state, "shape");
  Data data;
  add_points(data, mesh.points, frame);
  data.add<std::uint32_t>("cells", flat(solids.corners));
  data.add<std::uint8_t>("shapes", solids.shapes);
  data.add<std::uint32_t>("neighbours", flat(neighbours));
  data.add<std::uint32_t>("layers", layers);
  data.add_edges({});
  return {assembled(json, data),
          fmt::format("{}, {}, {}, {} in {}, {} ({} interior)",
                      counted(mesh.tetrahedra.size(), "tetrahedron", "tetrahedra"),
                      counted(mesh.hexahedra.size(), "hexahedron", "hexahedra"),
                      counted(mesh.prisms.size(), "prism", "prisms"),
                      counted(mesh.pyramids.size(), "pyramid", "pyramids"),
                      counted(depth, "layer", "layers"),
                      counted(vertices.used, "vertex", "vertices"), vertices.interior),
          solids.corners.size(), depth};
}

Page page_of(const mesh::FacetMesh& surface, const PageRequest& request) {
  std::vector<std::array<mesh::Index, 4>> cells;
  std::vector<bool> is_used(surface.points.size());
  std::size_t triangles = 0;
  for (const mesh::Facet& facet : surface.facets) {
    auto& cell = cells.emplace_back(facet.vertices);
    if (facet.size == 3) {
      cell[3] = cell[2];  // as the page wants it
      ++triangles;
    }
    for (const mesh::Index v : cell) is_used[v] = true;
  }
  const auto vertices = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), true));
  const std::size_t quads = cells.size() - triangles;
  const std::vector<view::Edge> edges = view::singular_edges(surface);

  const Frame frame = frame_of(surface.points, cells);
  Json json = about(request, "facets", frame);
  json["counts"] = {{"quads", quads}, {"triangles", triangles}, {"vertices", vertices}};
  json["state"] = json_of(request.state, "none");
  Data data;
  add_points(data, surface.points, frame);
  data.add<std::uint32_t>("cells", flat(cells));
  data.add_edges(edges);
  return {
      assembled(json, data),
      fmt::format("{}, {}, {}, {} not in two facets", counted(quads, "quad", "quads"),
                  counted(triangles, "triangle", "triangles"),
                  counted(vertices, "vertex", "vertices"), counted(edges.size(), "edge", "edges")),
      cells.size()};
}

}  // namespace hexatlas::cli
