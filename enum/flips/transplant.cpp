#include "enum/flips/transplant.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/disc.hpp"
#include "enum/flips/donors.hpp"
#include "enum/flips/exchange.hpp"
#include "enum/flips/numbered_boundary.hpp"
#include "enum/flips/scars.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

using complex::BoundaryQuad;
using complex::HexComplex;
using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;
using complex::VertexId;
using core::Random;

constexpr std::size_t kPerTask = 256;  ///< tries
constexpr std::size_t kFurther = 24;   ///< hexahedra of a ball beside those that must go
constexpr std::size_t kStepsOverTorn = 40;
constexpr std::size_t kFitsEach = 3;  ///< balls taken for one cavity

/// What a transplant leaves open.
struct Cavity {
  NumberedBoundary<VertexId> rim;  ///< names: the vertices of the donor's mesh
  Relation gained{};               ///< pairs in a quad of the target's disc, and in no other one
};

/// A transplant and a ball in its cavity.
struct Union {
  std::uint32_t donor = 0;
  std::vector<std::uint32_t> taken_out;  ///< hexahedra of the donor
  FrontId ball;
  std::vector<VertexId> rim;  ///< of each canonical boundary vertex of the ball
  bool is_mirrored = false;
  int hexahedra = 0;
  int faults = 0;
};

/// The cavity that is left when `ball`, a part of the donor's mesh, is taken out.
std::optional<Cavity> cavity_of(const Donor& donor, const SubBall& ball) {
  std::vector<BoundaryQuad> quads;
  const Quadrangulation& around = ball.front().boundary;
  for (int k = 0; k < around.quads(); ++k) {
    const QuadVertices own = around.vertices_of(k);
    const BoundaryQuad quad{ball.rim(own[0]), ball.rim(own[1]), ball.rim(own[2]), ball.rim(own[3])};
    if (std::find(donor.lost.begin(), donor.lost.end(), ascending(quad)) == donor.lost.end())
      quads.push_back(quad);
  }
  const std::size_t kept = quads.size();
  for (const QuadVertices& quad : donor.gained)
    quads.push_back({quad[0], quad[1], quad[2], quad[3]});
  auto rim = three_connected_boundary(quads);
  if (!rim) return std::nullopt;
  Cavity result{*std::move(rim), {}};
  Relation outside{};
  for (std::size_t k = 0; k < quads.size(); ++k)
    relate(set_of(result.rim.boundary.vertices_of(static_cast<int>(k))),
           k < kept ? outside : result.gained);
  for (std::size_t v = 0; v < result.rim.name.size(); ++v) result.gained[v] &= ~outside[v];
  return result;
}

/// The pairs of the cavity's vertices that some hexahedron of the transplant has.
Relation related_by_transplant(const Donor& donor, const SubBall& ball, const Cavity& cavity) {
  std::vector<VertexSet> own(donor.mesh.vertices, 0);
  for (std::size_t v = 0; v < cavity.rim.name.size(); ++v)
    own[cavity.rim.name[v]] = bit(static_cast<Vertex>(v));
  Relation related{};
  for (std::uint32_t c = 0; c < donor.mesh.hexahedra.size(); ++c) {
    if (ball.contains(c)) continue;
    VertexSet set = 0;
    for (const VertexId v : donor.mesh.hexahedra[c]) set |= own[v];
    relate(set, related);
  }
  return related;
}

/// The faults that any ball in the cavity has with the transplant: it has the quads of the target's
/// disc, two vertices of which the transplant may relate.
int faults_of_disc(const Cavity& cavity, const Relation& related) {
  int twice = 0;
  for (std::size_t v = 0; v < cavity.rim.name.size(); ++v)
    twice += std::popcount(cavity.gained[v] & related[v] & ~bit(static_cast<Vertex>(v)));
  return twice / 2;
}

class Transplants {
 public:
  Transplants(const Beam& balls, const MeshSource& meshes, const canon::Code& target,
              const TransplantOptions& options)
      : balls_(balls),
        target_(target),
        options_(options),
        donors_(donors_of(target, meshes, options)) {}

  std::vector<FaultyMesh> run() {
    if (donors_.empty()) return {};
    std::vector<std::vector<Union>> found((options_.tries + kPerTask - 1) / kPerTask);
    parallel::parallel_for(options_.threads, found.size(), [&](std::size_t i) {
      Random random(core::mixed(options_.seed + i));
      const std::size_t end = std::min(kPerTask, options_.tries - i * kPerTask);
      for (std::size_t k = 0; k < end; ++k) try_one(random, found[i]);
    });
    return some_of(found);
  }

 private:
  /// Grows a ball in some donor and looks for what fits in its place, step by step.
  void try_one(Random& random, std::vector<Union>& found) const {
    const auto number = static_cast<std::uint32_t>(random.below(donors_.size()));
    const Donor& donor = donors_[number];
    SubBall ball(donor.mesh, donor.neighbours, donor.torn[random.below(donor.torn.size())]);
    const int weight = static_cast<int>(random.below(5));
    if (!grow_over_torn(donor, ball, weight, random)) return;
    const std::size_t size = ball.cells().size() + random.below(kFurther);
    do {
      add_unions(number, ball, found);
    } while (ball.cells().size() < size && ball.grow_somewhere(random, weight));
  }

  static bool grow_over_torn(const Donor& donor, SubBall& ball, int weight, Random& random) {
    for (std::size_t i = 0; i < kStepsOverTorn; ++i) {
      std::size_t inside = 0;
      for (bool has_grown = true; has_grown;) {
        has_grown = false;
        inside = 0;
        for (const std::uint32_t cell : donor.torn) {
          if (!ball.contains(cell) && ball.grow(cell)) has_grown = true;
          if (ball.contains(cell)) ++inside;
        }
      }
      if (inside == donor.torn.size()) return true;
      if (!ball.grow_somewhere(random, weight)) return false;
    }
    return false;
  }

  void add_unions(std::uint32_t number, const SubBall& ball, std::vector<Union>& found) const {
    const Donor& donor = donors_[number];
    const int quads =
        ball.quads() - static_cast<int>(donor.lost.size()) + static_cast<int>(donor.gained.size());
    if (quads > balls_.options().max_quads) return;
    const auto cavity = cavity_of(donor, ball);
    if (!cavity) return;
    canon::CanonicalFlags flags;
    canon::canonical_flags(cavity->rim.boundary, flags);
    const auto family = balls_.store().find(flags.code);
    const int left = static_cast<int>(donor.mesh.hexahedra.size() - ball.cells().size());
    if (!family || left + balls_.store().family(*family).level_floor + 1 >= options_.wanted.below)
      return;
    const Relation related = related_by_transplant(donor, ball, *cavity);
    const auto positions = positions_of(cavity->rim.boundary, flags, related);
    const std::vector<VertexId>& names = cavity->rim.name;
    const int of_disc = faults_of_disc(*cavity, related);
    for (const Fitting& own : fittings_of(*family, positions, left, of_disc)) {
      const Position& position = positions[own.position];
      Union& made = found.emplace_back(Union{.donor = number,
                                             .taken_out = ball.cells(),
                                             .ball = {*family, own.place},
                                             .rim = std::vector<VertexId>(names.size()),
                                             .is_mirrored = position.is_mirrored,
                                             .hexahedra = own.hexahedra,
                                             .faults = own.faults});
      for (std::size_t v = 0; v < names.size(); ++v) made.rim[position.label[v]] = names[v];
    }
  }

  /// A ball in a cavity. Ordered by its price.
  struct Fitting {
    int price = 0;  ///< hexahedra and faults
    std::uint32_t position = 0;
    std::uint32_t place = 0;  ///< in the family
    int hexahedra = 0;
    int faults = 0;
    friend auto operator<=>(const Fitting&, const Fitting&) = default;
  };

  /// The best few ways to fill a cavity with so many hexahedra left around it and so many faults
  /// whatever fills it.
  [[nodiscard]] std::vector<Fitting> fittings_of(std::uint32_t family,
                                                 const std::vector<Position>& positions, int left,
                                                 int least_faults) const {
    std::vector<Fitting> result;
    const auto& fronts = balls_.store().family(family).fronts;
    for (std::uint32_t p = 0; p < positions.size(); ++p)
      for (std::uint32_t k = 0; k < fronts.size(); ++k) {
        const int hexahedra = left + fronts[k].level + 1;
        if (hexahedra >= options_.wanted.below) continue;
        const int faults = least_faults + fronts[k].scars.size_in_common(positions[p].scars);
        if (!options_.wanted.includes(hexahedra, faults)) continue;
        result.push_back({hexahedra + options_.wanted.price * faults, p, k, hexahedra, faults});
      }
    const std::size_t kept = std::min(kFitsEach, result.size());
    std::partial_sort(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(kept),
                      result.end());
    result.resize(kept);
    return result;
  }

  /// The least one without faults, and others drawn by their kinds.
  [[nodiscard]] std::vector<FaultyMesh> some_of(
      const std::vector<std::vector<Union>>& found) const {
    FaultyKinds<const Union*> kinds;
    const Union* least = nullptr;
    for (const auto& of_task : found)
      for (const Union& own : of_task) {
        if (own.faults == 0 && (least == nullptr || own.hexahedra < least->hexahedra)) least = &own;
        kinds.add(own.faults, own.hexahedra, &own);
      }
    std::vector<FaultyMesh> result;
    if (least != nullptr) add_mesh(*least, result);
    Random random(options_.seed);
    while (result.size() < options_.wanted.count) {
      const auto next = kinds.draw(random);
      if (!next) break;
      if (next->first != least) add_mesh(*next->first, result);
    }
    return result;
  }

  void add_mesh(const Union& own, std::vector<FaultyMesh>& result) const {
    HexComplex mesh =
        exchanged(donors_[own.donor].mesh, own.taken_out,
                  layers_along(balls_, own.ball, Growth::outward), own.rim, own.is_mirrored);
    mesh = complex::compacted(std::move(mesh), target_.quads + 2);
    if (SubBall::neighbours_if_complex(mesh, target_.quads))
      result.push_back({std::move(mesh), own.faults});
  }

  const Beam& balls_;
  const canon::Code& target_;
  const TransplantOptions& options_;
  std::vector<Donor> donors_;
};

}  // namespace

std::vector<FaultyMesh> transplants(const Beam& balls, const MeshSource& meshes,
                                    const canon::Code& target, const TransplantOptions& options) {
  core::expects(target.quads <= kMaxSearchQuads &&
                    options.max_circle <= static_cast<int>(kMaxDiscCircle) &&
                    options.max_interior <= static_cast<int>(kMaxDiscInterior) &&
                    options.max_circle + options.max_interior <= static_cast<int>(kMaxDiscVertices),
                "a boundary with few quads, and small discs");
  return Transplants(balls, meshes, target, options).run();
}

}  // namespace hexatlas::flips
