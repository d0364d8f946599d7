#include "enum/flips/crown.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/named_front.hpp"

namespace hexatlas::flips {
namespace {

using complex::Quadrangulation;
using complex::Vertex;

constexpr int kLeastInCrown = 4;  // around an edge inside

/// Glues crowns on one front.
class Crowner {
 public:
  Crowner(const SymmetricFront& from, int max_quads,
          const std::function<void(const GluedOrbit&)>& visit)
      : from_(from), max_quads_(max_quads), visit_(visit) {}

  void glue_all() {
    const auto degrees = from_.front.boundary.degrees();
    for (int i = 0; i < from_.front.boundary.vertices(); ++i) {
      const auto v = static_cast<Vertex>(i);
      if (from_.image[v] == v && degrees[v] >= kLeastInCrown && degrees[v] <= kMostInOrbit) glue(v);
    }
  }

 private:
  /// The hexahedra from half on are images of those before.
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
    add(0, named(from_.front));
  }

  /// Whether the involution turns the quads around the vertex by half.
  [[nodiscard]] bool is_turned() const {
    for (std::size_t i = 0; i < half(); ++i) {
      VertexSet image = 0;
      for (VertexSet left = star_[i]; left != 0; left &= left - 1)
        image |= bit(from_.image[static_cast<std::size_t>(std::countr_zero(left))]);
      if (image != star_[i + half()]) return false;
    }
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

  /// Glues the hexahedra from the i-th on.
  void add(std::size_t i, const Named& at) {
    if (i == star_.size()) return finish(at);
    const auto bottom = place_of(star_[i], at);
    if (!bottom) return;
    // All sets of sides, not one for each patch: the bottom is given.
    for (unsigned left = possible_sides(at.front, *bottom); left != 0; left &= left - 1) {
      const Flip flip{*bottom, static_cast<std::uint8_t>(std::countr_zero(left))};
      const int after = at.front.boundary.quads() + 6 - 2 * flip.consumed();
      if (after < 6 || after > kMaxFrontQuads) continue;
      const auto prism = prism_of(at.front.boundary, flip);
      if (!prism || !may_glue(at.front, flip, *prism)) continue;
      const int first_new = from_.front.boundary.vertices() + 4 * static_cast<int>(i);
      const OrbitCell cell = named_cell(at, *prism, first_new);
      const auto above = std::find(cell.begin(), cell.end(), around_) - cell.begin();
      const OrbitVertex end = cell[top_above(static_cast<std::size_t>(above))];
      if (i == 0 ? end < from_.front.boundary.vertices() : end != end_) continue;
      const Names before = image_;
      if (i == 0) image_[end] = end_ = end;
      cell_[i] = cell;
      if (i < half() || takes(cell_[i - half()], cell))
        add(i + 1, after_gluing(at, flip, *prism, cell));
      image_ = before;
    }
  }

  /// The corner of the top above a corner of the bottom.
  [[nodiscard]] static std::size_t top_above(std::size_t corner) {
    const auto& order = cells::kCornerOfPrism;
    const auto at = std::find(order.begin(), order.begin() + 4, corner) - order.begin();
    return order[static_cast<std::size_t>(at) + 4];
  }

  /// Extends the involution by what takes the hexahedron to the other one, bottom to bottom, if
  /// that does not contradict it.
  [[nodiscard]] bool takes(const OrbitCell& cell, const OrbitCell& other) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t corner = cells::kCornerOfPrism[i];
      const auto to = std::find(other.begin(), other.end(), image_[cell[corner]]) - other.begin();
      const OrbitVertex top = cell[top_above(corner)];
      const OrbitVertex other_top = other[top_above(static_cast<std::size_t>(to))];
      for (const auto& [a, b] : {std::pair(top, other_top), std::pair(other_top, top)}) {
        if (image_[a] != kUnknown && image_[a] != b) return false;
        image_[a] = b;
      }
    }
    return true;
  }

  void finish(const Named& last) {
    ++crowns_;  // the place among all, whatever the limit
    if (last.front.boundary.quads() > max_quads_) return;
    GluedOrbit result = glued_with(last, image_);
    result.orbit = {.size = static_cast<std::uint8_t>(star_.size()), .crown = crowns_};
    std::copy_n(cell_.begin(), star_.size(), result.cell.begin());
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
  std::uint16_t crowns_ = 0;
};

}  // namespace

void for_each_glueable_crown(const SymmetricFront& front, int max_quads,
                             const std::function<void(const GluedOrbit&)>& visit) {
  core::expects(max_quads <= kMaxSymmetricQuads, "a symmetric state has at most 40 quads");
  Crowner(front, max_quads, visit).glue_all();
}

}  // namespace hexatlas::flips
