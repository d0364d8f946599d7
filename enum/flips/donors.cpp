#include "enum/flips/donors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/flips/circles.hpp"
#include "enum/flips/disc.hpp"

namespace hexatlas::flips {
namespace {

using complex::BoundaryQuad;
using complex::HexComplex;
using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;
using complex::VertexId;

constexpr int kOfEachBoundary = 4;    ///< ways to see a boundary as alike
constexpr std::size_t kLeftOver = 4;  ///< quads outside of the disc, at least

/// Whether each vertex inside has three quads: those of a 3-connected boundary do.
bool may_be_on_boundary(const Disc& disc, int circle, int interior) {
  std::vector<int> degree(static_cast<std::size_t>(circle + interior));
  for (const QuadVertices& quad : disc)
    for (const Vertex v : quad) ++degree[v];
  return std::all_of(degree.begin() + circle, degree.end(), [](int d) { return d >= 3; });
}

class Donors {
 public:
  Donors(const canon::Code& target, const MeshSource& meshes, const TransplantOptions& options)
      : target_(target), q_(canon::decode(target).value()), meshes_(meshes), options_(options) {}

  std::vector<Donor> run() {
    const Graph graph = graph_of(q_);
    for (int length = 4; length <= options_.max_circle; length += 2) {
      list_discs(length);
      for (const Circle& circle : circles(graph, q_.vertices(), length)) {
        const std::vector<bool> left = left_of(q_, circle);
        add_with(circle, left, true);
        add_with(circle, left, false);
      }
    }
    return std::move(result_);
  }

 private:
  /// The discs that fit into circles of a length, by the number of vertices inside.
  void list_discs(int length) {
    discs_.clear();
    for (int interior = 0; interior <= options_.max_interior; ++interior) {
      auto own = discs(length, interior);
      std::erase_if(own,
                    [&](const Disc& disc) { return !may_be_on_boundary(disc, length, interior); });
      discs_.push_back(std::move(own));
    }
  }

  /// Replaces the disc on one side of the circle.
  void add_with(const Circle& circle, const std::vector<bool>& left, bool gained_is_left) {
    std::vector<QuadVertices> gained;
    std::vector<QuadVertices> kept;
    for (int k = 0; k < q_.quads(); ++k)
      (left[static_cast<std::size_t>(k)] == gained_is_left ? gained : kept)
          .push_back(q_.vertices_of(k));
    if (gained.size() > static_cast<std::size_t>(options_.max_gained) || kept.size() < kLeftOver)
      return;
    const std::size_t length = circle.size();
    for (const auto& own : discs_)
      for (const Disc& disc : own) {
        const std::size_t quads = kept.size() + disc.size();
        if (quads % 2 != 0 || quads < 6 || quads > kMaxSearchQuads) continue;
        std::vector<QuadVertices> lost;
        for (const QuadVertices& quad : disc) {
          QuadVertices& in_place = lost.emplace_back();
          for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t v = quad[i];
            if (v >= length)
              in_place[i] = static_cast<Vertex>(q_.vertices() + static_cast<int>(v - length));
            else
              in_place[i] = circle[gained_is_left ? v : (length - v) % length];
          }
        }
        add(kept, gained, lost);
      }
  }

  /// The donor with the disc `lost` in place of `gained`, if it is one.
  void add(const std::vector<QuadVertices>& kept, const std::vector<QuadVertices>& gained,
           const std::vector<QuadVertices>& lost) {
    std::array<Vertex, complex::kMaxVertices> number{};
    number.fill(kNewVertex);
    std::vector<Vertex> vertex;
    std::vector<QuadVertices> quads;
    for (const auto* part : {&kept, &lost})
      for (const QuadVertices& quad : *part) {
        QuadVertices& own = quads.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
          if (number[quad[i]] == kNewVertex) {
            number[quad[i]] = static_cast<Vertex>(vertex.size());
            vertex.push_back(quad[i]);
          }
          own[i] = number[quad[i]];
        }
      }
    if (vertex.size() != quads.size() + 2) return;
    const auto boundary = Quadrangulation::from_quads(quads);
    if (!boundary || !boundary->is_three_connected()) return;
    const canon::CanonicalForm form = canon::canonical_form(*boundary);
    if (form.code == target_ || seen_[form.code] == kOfEachBoundary) return;
    auto mesh = meshes_(form.code, options_.wanted.below);
    if (!mesh) return;
    ++seen_[form.code];
    if (form.is_mirrored) mesh = complex::mirrored(*std::move(mesh));
    result_.push_back(donor(in_numbers_of_target(*std::move(mesh), form, vertex), gained, lost));
  }

  /// `vertex`: in numbers of the target, of each vertex of the boundary that the form is of. The
  /// vertices inside follow.
  [[nodiscard]] HexComplex in_numbers_of_target(HexComplex mesh, const canon::CanonicalForm& form,
                                                const std::vector<Vertex>& vertex) const {
    const auto on_boundary = static_cast<int>(vertex.size());
    const canon::Labelling of_label = canon::inverse_of(form.label, on_boundary);
    const VertexId first_inside =
        std::max<VertexId>(static_cast<VertexId>(q_.vertices()),
                           VertexId{*std::max_element(vertex.begin(), vertex.end())} + 1);
    const auto boundary_vertices = static_cast<VertexId>(on_boundary);
    for (complex::Hexahedron& cell : mesh.hexahedra)
      for (VertexId& v : cell)
        v = v < boundary_vertices ? vertex[of_label[v]] : v - boundary_vertices + first_inside;
    mesh.vertices = mesh.vertices - boundary_vertices + first_inside;
    return mesh;
  }

  [[nodiscard]] Donor donor(HexComplex mesh, const std::vector<QuadVertices>& gained,
                            const std::vector<QuadVertices>& lost) const {
    Donor result{std::move(mesh), {}, gained, {}, {}};
    result.neighbours = SubBall::neighbours_of(result.mesh);
    std::vector<bool> is_inside(result.mesh.vertices);
    for (const QuadVertices& quad : lost) {
      result.lost.push_back(ascending({quad[0], quad[1], quad[2], quad[3]}));
      for (const Vertex v : quad)
        if (v >= q_.vertices()) is_inside[v] = true;
    }
    const auto is_torn = [&](const complex::Hexahedron& cell) {
      return std::any_of(cell.begin(), cell.end(), [&](VertexId v) { return is_inside[v]; }) ||
             std::any_of(cells::kFacetVertices.begin(), cells::kFacetVertices.end(),
                         [&](const auto& facet) {
                           const BoundaryQuad own = ascending(
                               {cell[facet[0]], cell[facet[1]], cell[facet[2]], cell[facet[3]]});
                           return std::find(result.lost.begin(), result.lost.end(), own) !=
                                  result.lost.end();
                         });
    };
    for (std::uint32_t c = 0; c < result.mesh.hexahedra.size(); ++c)
      if (is_torn(result.mesh.hexahedra[c])) result.torn.push_back(c);
    return result;
  }

  const canon::Code& target_;
  Quadrangulation q_;
  const MeshSource& meshes_;
  const TransplantOptions& options_;
  std::vector<std::vector<Disc>> discs_;
  std::map<canon::Code, int> seen_;
  std::vector<Donor> result_;
};

}  // namespace

std::vector<Donor> donors_of(const canon::Code& target, const MeshSource& meshes,
                             const TransplantOptions& options) {
  return Donors(target, meshes, options).run();
}

}  // namespace hexatlas::flips
