#include "enum/flips/crown.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/named_front.hpp"

namespace hexatlas::flips {
namespace {

using complex::Quadrangulation;
using complex::Vertex;

constexpr int kLeastInCrown = 4;  // around an edge inside

/// Of a top in a key: a vertex that was not there before.
constexpr OrbitVertex kNewTop = 0xFE;

/// Glues crowns on one front.
class Crowner {
 public:
  Crowner(const SymmetricFront& from, int max_quads,
          const std::function<void(const GluedOrbit&)>& visit)
      : from_(from), max_quads_(max_quads), visit_(visit) {}

  void glue_all() {
    const auto degrees = from_.front.boundary.degrees();
    for (int i = 0; i < old_vertices(); ++i) {
      const auto v = static_cast<Vertex>(i);
      if (from_.image[v] == v && degrees[v] >= kLeastInCrown && degrees[v] <= kMostInOrbit) glue(v);
    }
  }

 private:
  [[nodiscard]] int old_vertices() const noexcept { return from_.front.boundary.vertices(); }
  [[nodiscard]] std::size_t half() const noexcept { return star_.size() / 2; }

  void glue(Vertex v) {
    const Quadrangulation& q = from_.front.boundary;
    around_ = v;
    star_.clear();
    complex::Dart first = 0;
    while (q.origin(first) != v) ++first;
    complex::Dart dart = first;
    do {
      star_.push_back(set_of(q.vertices_of(Quadrangulation::quad_of(dart))));
      dart = q.turn_left(dart);
    } while (dart != first);
    if (!is_turned()) return;
    image_.fill(kUnknown);
    std::copy_n(from_.image.begin(), q.vertices(), image_.begin());
    top_.fill(kUnknown);
    seen_.clear();
    add({}, named(from_.front));
  }

  /// Whether the involution turns the quads around the vertex by half.
  [[nodiscard]] bool is_turned() const {
    for (std::size_t i = 0; i < half(); ++i)
      if (image_of(star_[i], from_.image) != star_[i + half()]) return false;
    return star_.size() % 2 == 0;
  }

  /// Where the quad of the former boundary is now.
  [[nodiscard]] static std::optional<complex::Quad> place_of(VertexSet quad, const Named& at) {
    for (int i = 0; i < at.front.boundary.quads(); ++i) {
      const auto corners = at.front.boundary.vertices_of(i);
      if (std::all_of(corners.begin(), corners.end(), [&](Vertex v) {
            return at.name[v] < kMaxFrontQuads + 2 && (quad & bit(at.name[v])) != 0;
          }))
        return static_cast<complex::Quad>(i);
    }
    return std::nullopt;
  }

  /// Glues the hexahedra on that are not there yet, in any order: which one may come next depends
  /// on what the others leave of the boundary. The places of those there are in `there`. The new
  /// edge is on the boundary only in facets of those, so the next one is a neighbour of one.
  void add(const std::vector<std::size_t>& there, const Named& at) {
    if (there.size() == star_.size()) return finish(there, at);
    // The involution takes a crown that begins in the second half to one that begins in the first.
    const std::size_t end = there.empty() ? half() : star_.size();
    const auto is_there = [&](std::size_t i) {
      return std::find(there.begin(), there.end(), i % star_.size()) != there.end();
    };
    for (std::size_t i = 0; i < end; ++i)
      if (there.empty() || (!is_there(i) && (is_there(i + 1) || is_there(i + star_.size() - 1))))
        add(i, there, at);
  }

  void add(std::size_t i, const std::vector<std::size_t>& there, const Named& at) {
    const auto bottom = place_of(star_[i], at);
    if (!bottom) return;
    // All sets of sides, not one for each patch: the bottom is given.
    for (unsigned left = possible_sides(at.front, *bottom); left != 0; left &= left - 1) {
      const Flip flip{*bottom, static_cast<std::uint8_t>(std::countr_zero(left))};
      const int after = at.front.boundary.quads() + 6 - 2 * flip.consumed();
      if (after < 6 || after > kMaxFrontQuads) continue;
      const auto prism = prism_of(at.front.boundary, flip);
      if (!prism || !may_glue(at.front, flip, *prism)) continue;
      const OrbitCell cell = named_cell(at, *prism, old_vertices() + 4 * static_cast<int>(i));
      const OrbitVertex end = top_above(around_, cell);
      if (there.empty() ? end < old_vertices() : end != end_) continue;
      const Names image_before = image_;
      const Names top_before = top_;
      if (there.empty()) image_[end] = end_ = end;
      if (extends(i, there, cell) && is_first(cell)) {
        cell_[i] = cell;
        std::vector<std::size_t> with = there;
        with.push_back(i);
        add(with, after_gluing(at, flip, *prism, cell));
      }
      image_ = image_before;
      top_ = top_before;
    }
  }

  /// Of a hexahedron the vertex of the top above one of the bottom.
  [[nodiscard]] static OrbitVertex top_above(OrbitVertex v, const OrbitCell& cell) {
    std::size_t k = 0;
    while (cell[cells::kCornerOfPrism[k]] != v) ++k;
    return cell[cells::kCornerOfPrism[4 + k]];
  }

  /// Extends the involution by what takes the i-th hexahedron to its image, bottom to bottom, if
  /// the image is there, and if that does not contradict it.
  [[nodiscard]] bool extends(std::size_t i, const std::vector<std::size_t>& there,
                             const OrbitCell& cell) {
    const std::size_t image = (i + half()) % star_.size();
    if (std::find(there.begin(), there.end(), image) == there.end()) return true;
    const OrbitCell& other = cell_[image];
    for (std::size_t k = 0; k < 4; ++k) {
      const OrbitVertex top = cell[cells::kCornerOfPrism[4 + k]];
      const OrbitVertex other_top = top_above(image_[cell[cells::kCornerOfPrism[k]]], other);
      for (const auto& [a, b] : {std::pair(top, other_top), std::pair(other_top, top)}) {
        if (image_[a] != kUnknown && image_[a] != b) return false;
        image_[a] = b;
      }
    }
    return true;
  }

  /// Whether the same hexahedra, up to the names of new vertices, were not there before in another
  /// order: they are the same if the tops above all vertices are. Each has one such vertex, across
  /// from the one around which they are, for itself.
  [[nodiscard]] bool is_first(const OrbitCell& cell) {
    for (std::size_t k = 0; k < 4; ++k) {
      const OrbitVertex top = cell[cells::kCornerOfPrism[4 + k]];
      top_[cell[cells::kCornerOfPrism[k]]] = top < old_vertices() ? top : kNewTop;
    }
    return seen_.insert(top_).second;
  }

  void finish(const std::vector<std::size_t>& order, const Named& last) {
    ++crowns_;  // the place among all, whatever the limit
    if (last.front.boundary.quads() > max_quads_) return;
    GluedOrbit result = glued_with(last, image_);
    result.orbit = {.size = static_cast<std::uint8_t>(star_.size()), .crown = crowns_};
    for (std::size_t i = 0; i < order.size(); ++i) result.cell[i] = cell_[order[i]];
    visit_(result);
  }

  const SymmetricFront& from_;
  int max_quads_;
  const std::function<void(const GluedOrbit&)>& visit_;
  Vertex around_ = 0;
  OrbitVertex end_ = 0;          ///< of the new edge
  std::vector<VertexSet> star_;  ///< the quads at the vertex, counter-clockwise
  std::array<OrbitCell, kMostInOrbit> cell_{};
  Names image_{};
  Names top_{};  ///< above each vertex of a bottom: an old vertex, kNewTop or kUnknown
  std::set<Names> seen_;
  std::uint16_t crowns_ = 0;
};

}  // namespace

void for_each_glueable_crown(const SymmetricFront& front, int max_quads,
                             const std::function<void(const GluedOrbit&)>& visit) {
  core::expects(max_quads <= kMaxSymmetricQuads, "a symmetric state has at most 40 quads");
  Crowner(front, max_quads, visit).glue_all();
}

}  // namespace hexatlas::flips
