#include "enum/flips/symmetric_front.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <utility>

#include "enum/cells/cube_symmetries.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/crown.hpp"
#include "enum/flips/named_front.hpp"

namespace hexatlas::flips {
namespace {

using complex::Quadrangulation;
using complex::Vertex;
using QuadSet = std::uint64_t;

QuadSet patch_of(const Quadrangulation& q, Flip flip) {
  QuadSet result = QuadSet{1} << flip.bottom;
  for (int i = 0; i < 4; ++i)
    if (flip.has(static_cast<unsigned>(i)))
      result |=
          QuadSet{1} << Quadrangulation::quad_of(q.twin(Quadrangulation::dart(flip.bottom, i)));
  return result;
}

/// Glues orbits on one front.
class Gluer {
 public:
  Gluer(const SymmetricFront& from, int max_quads,
        const std::function<void(const GluedOrbit&)>& visit)
      : from_(from), max_quads_(max_quads), visit_(visit), start_(named(from.front)) {
    const Quadrangulation& q = from.front.boundary;
    std::array<VertexSet, complex::kMaxQuads> quad{};
    for (int i = 0; i < q.quads(); ++i)
      quad[static_cast<std::size_t>(i)] = set_of(q.vertices_of(i));
    for (int i = 0; i < q.quads(); ++i) {
      const VertexSet image = image_of(quad[static_cast<std::size_t>(i)], from.image);
      const auto at = std::find(quad.begin(), quad.begin() + q.quads(), image);
      image_of_quad_[static_cast<std::size_t>(i)] = static_cast<complex::Quad>(at - quad.begin());
    }
  }

  void glue_all() const {
    // Between the two hexahedra of an orbit there may be more quads, by as many as one adds.
    constexpr int kMostAdded = 4;
    for_each_glueable(from_.front, std::min(max_quads_ + kMostAdded, kMaxFrontQuads),
                      [this](Flip flip, const Prism& prism) { glue(flip, prism); });
  }

 private:
  [[nodiscard]] int old_vertices() const noexcept { return from_.front.boundary.vertices(); }
  [[nodiscard]] bool is_old(OrbitVertex v) const noexcept { return v < old_vertices(); }

  void glue(Flip flip, const Prism& prism) const {
    const QuadSet patch = patch_of(from_.front.boundary, flip);
    QuadSet image = 0;
    for (QuadSet left = patch; left != 0; left &= left - 1)
      image |= QuadSet{1} << image_of_quad_[static_cast<std::size_t>(std::countr_zero(left))];
    const bool is_own_image = patch == image;
    // A quad can be glued on once; and of the two orders one is enough.
    if (!is_own_image &&
        ((patch & image) != 0 || std::countr_zero(patch) > std::countr_zero(image)))
      return;
    const OrbitCell cell = named_cell(start_, prism, old_vertices());
    if (!is_own_image) return glue_image(flip, after_gluing(start_, flip, prism, cell), cell);
    const int after = from_.front.boundary.quads() + 6 - 2 * flip.consumed();
    const auto own = extension(cell, cell);
    if (own && after <= max_quads_)
      finish({{flip, {}}, 1}, after_gluing(start_, flip, prism, cell), {cell, cell}, *own);
  }

  /// Looks for the image among the hexahedra that may be glued on next: all its vertices are images
  /// of old ones, or new.
  void glue_image(Flip first, const Named& next, const OrbitCell& cell) const {
    std::array<bool, kNames> may_have{};
    for (const OrbitVertex v : cell) {
      if (is_old(v)) may_have[from_.image[v]] = true;
      if (!is_old(v)) may_have[v] = true;
    }
    const Quadrangulation& q = next.front.boundary;
    for (int bottom = 0; bottom < q.quads(); ++bottom) {
      const auto corners = q.vertices_of(bottom);
      if (!std::all_of(corners.begin(), corners.end(),
                       [&](Vertex v) { return may_have[next.name[v]]; }))
        continue;
      for_each_glueable_on(next.front, static_cast<complex::Quad>(bottom), max_quads_,
                           [&](Flip flip, const Prism& prism) {
                             const OrbitCell other = named_cell(next, prism, old_vertices() + 4);
                             if (const auto image = extension(cell, other))
                               finish({{first, flip}, 2}, after_gluing(next, flip, prism, other),
                                      {cell, other}, *image);
                           });
    }
  }

  /// The images of all names if the involution extends to one that takes `cell` to `other`.
  [[nodiscard]] std::optional<Names> extension(const OrbitCell& cell,
                                               const OrbitCell& other) const {
    Names image{};
    for (const cells::CornerMap& turn : cells::kCubeTables.corner)
      if (extends(cell, other, turn, image)) return image;
    return std::nullopt;
  }
  [[nodiscard]] bool extends(const OrbitCell& cell, const OrbitCell& other,
                             const cells::CornerMap& turn, Names& image) const {
    for (std::size_t c = 0; c < cell.size(); ++c)
      if (is_old(cell[c]) ? other[turn[c]] != from_.image[cell[c]] : is_old(other[turn[c]]))
        return false;
    image.fill(kUnknown);
    std::copy_n(from_.image.begin(), old_vertices(), image.begin());
    for (std::size_t c = 0; c < cell.size(); ++c) {
      if (is_old(cell[c])) continue;
      const OrbitVertex to = other[turn[c]];
      for (const auto& [a, b] : {std::pair(cell[c], to), std::pair(to, cell[c])}) {
        if (image[a] != kUnknown && image[a] != b) return false;
        image[a] = b;
      }
    }
    return true;
  }

  void finish(const Orbit& orbit, const Named& last, const std::array<OrbitCell, 2>& cell,
              const Names& image) const {
    GluedOrbit result = glued_with(last, image);
    result.orbit = orbit;
    std::copy(cell.begin(), cell.end(), result.cell.begin());
    visit_(result);
  }

  const SymmetricFront& from_;
  int max_quads_;
  const std::function<void(const GluedOrbit&)>& visit_;
  Named start_;
  std::array<complex::Quad, complex::kMaxQuads> image_of_quad_{};
};

canon::Labelling after(const canon::Labelling& second, const canon::Labelling& first,
                       int vertices) {
  canon::Labelling result{};
  for (std::size_t v = 0; v < static_cast<std::size_t>(vertices); ++v) result[v] = second[first[v]];
  return result;
}

}  // namespace

std::vector<Involution> involutions_of(const Quadrangulation& boundary, const Scars& scars) {
  core::expects(boundary.is_three_connected(), "symmetries are those of a 3-connected boundary");
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  const int vertices = boundary.vertices();
  // Two canonical labellings differ by an automorphism.
  const canon::Labelling first = canon::labelling_from(boundary, flags.flags[0]);
  const canon::Labelling vertex_of = canon::inverse_of(first, vertices);
  const auto wide = scars.as<kMaxSymmetricQuads>();
  std::vector<Involution> group;  // all that keep the scars, whatever their order
  group.reserve(static_cast<std::size_t>(flags.count));
  for (int i = 0; i < flags.count; ++i) {
    const canon::Flag flag = flags.flags[static_cast<std::size_t>(i)];
    const canon::Labelling image =
        after(vertex_of, canon::labelling_from(boundary, flag), vertices);
    if (wide.renamed(image) == wide)
      group.push_back({image, flag.mirrored != flags.flags[0].mirrored});
  }
  const canon::Labelling identity = group.front().image;
  std::vector<Involution> result;
  for (std::size_t i = 1; i < group.size(); ++i) {
    const canon::Labelling& image = group[i].image;
    if (after(image, image, vertices) != identity) continue;
    const bool is_new = std::none_of(group.begin(), group.end(), [&](const Involution& g) {
      return std::any_of(result.begin(), result.end(), [&](const Involution& known) {
        return after(g.image, image, vertices) == after(known.image, g.image, vertices);
      });
    });
    if (is_new) result.push_back(group[i]);
  }
  return result;
}

SymmetricFront symmetric_front(const Quadrangulation& boundary, const Scars& scars,
                               const Involution& involution) {
  return {front_with(boundary, scars.as<kMaxSymmetricQuads>()), involution.image};
}

std::vector<SymmetricFront> symmetric_fronts(const Quadrangulation& boundary, const Scars& scars) {
  std::vector<SymmetricFront> result;
  for (const Involution& involution : involutions_of(boundary, scars))
    result.push_back(symmetric_front(boundary, scars, involution));
  return result;
}

SymmetricFront front_without_symmetry(const Quadrangulation& boundary, const Scars& scars) {
  core::expects(boundary.is_three_connected(), "only a 3-connected boundary has a filling");
  SymmetricFront result{front_with(boundary, scars.as<kMaxSymmetricQuads>()), {}};
  std::iota(result.image.begin(), result.image.end(), Vertex{0});
  return result;
}

void for_each_glueable_orbit(const SymmetricFront& front, int max_quads,
                             const std::function<void(const GluedOrbit&)>& visit) {
  core::expects(max_quads <= kMaxSymmetricQuads, "a symmetric state has at most 40 quads");
  Gluer(front, max_quads, visit).glue_all();
}

GluedOrbit glued(const SymmetricFront& front, const Orbit& orbit) {
  std::optional<GluedOrbit> found;
  const auto keep = [&](const GluedOrbit& each) {
    if (each.orbit == orbit) found = each;
  };
  if (orbit.crown == 0)
    for_each_glueable_orbit(front, kMaxSymmetricQuads, keep);
  else
    for_each_glueable_crown(front, kMaxSymmetricQuads, keep);
  core::expects(found.has_value(), "the orbit may be glued on");
  return *found;
}

std::uint64_t SymmetricState::hash_of_class() const noexcept {
  return SymmetricState{code, image, {}}.hash(0);
}

std::uint64_t SymmetricState::hash(std::uint64_t seed) const noexcept {
  std::uint64_t h = scars.hash(seed ^ std::hash<canon::Code>{}(code));
  for (int v = 0; v < code.quads + 2; ++v)
    h = (h ^ image[static_cast<std::size_t>(v)]) * 0x9E3779B97F4A7C15ULL;
  return h ^ h >> 29U;
}

CanonicalSymmetricState canonical_state(const SymmetricFront& front) {
  const Quadrangulation& boundary = front.front.boundary;
  core::expects(boundary.quads() <= kMaxSymmetricQuads, "a symmetric state has at most 40 quads");
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  const Relation quads = relation_of_quads(boundary);
  CanonicalSymmetricState result;
  for (int i = 0; i < flags.count; ++i) {
    const canon::Flag flag = flags.flags[static_cast<std::size_t>(i)];
    const canon::Labelling label = canon::labelling_from(boundary, flag);
    SymmetricState state{flags.code, {}, {}};
    state.scars =
        scars_of<SymmetricState::Scars>(front.front.related, quads, boundary.vertices(), label);
    for (std::size_t v = 0; v < static_cast<std::size_t>(boundary.vertices()); ++v)
      state.image[label[v]] = label[front.image[v]];
    if (i > 0 && !(state < result.state)) continue;
    result = {state, label, flag.mirrored};
  }
  return result;
}

std::optional<State> state_without_symmetry(const SymmetricState& state) {
  if (state.code.quads > kMaxStateQuads) return std::nullopt;
  return State{state.code, state.scars.as<kMaxStateQuads>()};
}

SymmetricFront front_of(const SymmetricState& state) {
  const auto boundary = canon::decode(state.code);
  core::expects(boundary.has_value(), "the code of a state can be decoded");
  SymmetricFront result{front_with(*boundary, state.scars)};
  std::copy(state.image.begin(), state.image.end(), result.image.begin());
  return result;
}

}  // namespace hexatlas::flips
