#include "enum/flips/donors.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/flips/circles.hpp"
#include "enum/flips/disc.hpp"
#include "enum/flips/numbered_boundary.hpp"

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

class Donors {
 public:
  Donors(const canon::Code& target, const MeshSource& meshes, const TransplantOptions& options)
      : target_(target), q_(canon::decode(target).value()), meshes_(meshes), options_(options) {}

  std::vector<Donor> run() {
    const Graph graph = graph_of(q_);
    for (int length = 4; length <= options_.max_circle; length += 2)
      for (const Circle& circle : circles(graph, q_.vertices(), length)) {
        const std::vector<bool> left = left_of(q_, circle);
        add_with(circle, left, true);
        add_with(circle, left, false);
      }
    return std::move(result_);
  }

 private:
  /// Replaces the disc on one side of the circle.
  void add_with(const Circle& circle, const std::vector<bool>& left, bool gained_is_left) {
    std::vector<QuadVertices> gained;
    std::vector<QuadVertices> kept;
    for (int k = 0; k < q_.quads(); ++k)
      (left[static_cast<std::size_t>(k)] == gained_is_left ? gained : kept)
          .push_back(q_.vertices_of(k));
    if (gained.size() > static_cast<std::size_t>(options_.max_gained) || kept.size() < kLeftOver)
      return;
    Circle rim = circle;  // from the right side it is seen the other way round
    if (!gained_is_left) std::reverse(rim.begin() + 1, rim.end());
    for (int interior = 0; interior <= options_.max_interior; ++interior)
      for (const MarkedDisc& disc : marked_discs(rim.size(), static_cast<std::size_t>(interior))) {
        const std::size_t quads = kept.size() + disc.quads.size();
        if (quads % 2 != 0 || quads < 6 || quads > kMaxSearchQuads) break;  // they are all alike
        add(kept, gained, placed(disc.quads, rim, static_cast<Vertex>(q_.vertices())), interior);
      }
  }

  /// The donor with the disc `lost`, with so many vertices inside, in place of `gained`, if it is
  /// one.
  void add(const std::vector<QuadVertices>& kept, const std::vector<QuadVertices>& gained,
           const Disc& lost, int interior) {
    std::vector<QuadVertices> quads = kept;
    quads.insert(quads.end(), lost.begin(), lost.end());
    const auto numbered = three_connected_boundary(quads);
    if (!numbered) return;
    const canon::CanonicalForm form = canon::canonical_form(numbered->boundary);
    if (form.code == target_) return;
    const auto [at, is_new] = known_.try_emplace(form.code);
    Known& known = at->second;
    if (is_new) known.mesh = meshes_(form.code, options_.wanted.below);
    if (!known.mesh || known.uses == kOfEachBoundary) return;
    ++known.uses;
    result_.push_back(
        donor(in_numbers_of_target(*known.mesh, form, numbered->name, interior), gained, lost));
  }

  /// `name`: in numbers of the target, of each vertex of the boundary that the form is of. The
  /// vertices inside follow those of the target and of the disc with so many inside.
  [[nodiscard]] HexComplex in_numbers_of_target(const HexComplex& known,
                                                const canon::CanonicalForm& form,
                                                const std::vector<Vertex>& name,
                                                int interior) const {
    HexComplex mesh = form.is_mirrored ? complex::mirrored(known) : known;
    const canon::Labelling of_label = canon::inverse_of(form.label, static_cast<int>(name.size()));
    const auto first_inside = static_cast<VertexId>(q_.vertices() + interior);
    const auto on_boundary = static_cast<VertexId>(name.size());
    for (complex::Hexahedron& cell : mesh.hexahedra)
      for (VertexId& v : cell)
        v = v < on_boundary ? name[of_label[v]] : v - on_boundary + first_inside;
    mesh.vertices = mesh.vertices - on_boundary + first_inside;
    return mesh;
  }

  [[nodiscard]] Donor donor(HexComplex mesh, const std::vector<QuadVertices>& gained,
                            const Disc& lost) const {
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

  /// The mesh that is known of a boundary, if any, and how often it has become a donor.
  struct Known {
    std::optional<HexComplex> mesh;
    int uses = 0;
  };

  const canon::Code& target_;
  Quadrangulation q_;
  const MeshSource& meshes_;
  const TransplantOptions& options_;
  std::map<canon::Code, Known> known_;
  std::vector<Donor> result_;
};

}  // namespace

std::vector<Donor> donors_of(const canon::Code& target, const MeshSource& meshes,
                             const TransplantOptions& options) {
  return Donors(target, meshes, options).run();
}

}  // namespace hexatlas::flips
