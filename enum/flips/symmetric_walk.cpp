#include "enum/flips/symmetric_walk.hpp"

#include <cmath>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/draw.hpp"
#include "enum/flips/faults.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;
using complex::Vertex;
using complex::VertexId;

constexpr std::uint64_t kInvariantOneIn = 5;  ///< steps, if there are symmetric balls
constexpr std::uint64_t kSamePrice = 8;       ///< of so many exchanges that change neither number

MeshInvolution extended_to(const HexComplex& mesh, int quads, const Involution& of_boundary,
                           const SubBall::Neighbours& neighbours) {
  auto result = extended(of_boundary, mesh, quads, neighbours);
  core::expects(result.has_value(), "the mesh has the involution of its boundary");
  return *std::move(result);
}

}  // namespace

SymmetricWalk::SymmetricWalk(HexComplex mesh, int quads, const Involution& of_boundary,
                             const Beam& balls, const SymmetricBalls* symmetric, std::uint64_t seed)
    : mesh_(std::move(mesh)),
      quads_(quads),
      of_boundary_(of_boundary),
      balls_(balls),
      symmetric_(symmetric),
      random_(seed),
      neighbours_(SubBall::neighbours_of(mesh_)),
      involution_(extended_to(mesh_, quads, of_boundary, neighbours_)),
      ball_(mesh_, neighbours_, 0, widest_on_the_way(balls)),
      faults_(faults_of(mesh_, neighbours_)) {}

bool SymmetricWalk::step(const Climate& climate, BallLayers& layers) {
  if (symmetric_ != nullptr && random_.below(kInvariantOneIn) == 0)
    return invariant_exchange(climate);
  return double_exchange(climate, layers);
}

/// Grows a ball that shares no hexahedron with its image. Returns whether it came to its size.
bool SymmetricWalk::grow_apart() {
  const auto& image = involution_.cell;
  const auto first = static_cast<std::uint32_t>(random_.below(mesh_.hexahedra.size()));
  if (is_own_image(first)) return false;
  ball_.restart(first);
  const std::size_t size = size_of_exchange(random_);
  const int weight = static_cast<int>(random_.below(5));
  const auto is_apart = [&](std::uint32_t cell) {
    return !is_own_image(cell) && !ball_.contains(image[cell]);
  };
  return ball_.grow_to(size, random_, weight, is_apart);
}

/// Grows a ball that is its own image. Returns whether it came to its size.
bool SymmetricWalk::grow_own_image() {
  const auto grow_image_of = [&](std::uint32_t cell) {
    return is_own_image(cell) || ball_.grow(involution_.cell[cell]);
  };
  const auto first = static_cast<std::uint32_t>(random_.below(mesh_.hexahedra.size()));
  ball_.restart(first);
  if (!grow_image_of(first)) return false;
  const std::size_t size = size_of_exchange(random_);
  const int weight = static_cast<int>(random_.below(5));
  while (ball_.cells().size() < size)
    if (!ball_.grow_somewhere(random_, weight) || !grow_image_of(ball_.cells().back()))
      return false;
  return true;
}

bool SymmetricWalk::double_exchange(const Climate& climate, BallLayers& layers) {
  if (!grow_apart() || ball_.quads() > balls_.options().max_quads) return false;
  const auto drawn = draw(ball_, balls_, climate, std::nullopt, random_, sums_);
  if (!drawn) return false;
  return accept(doubly_exchanged(layers.of(drawn->fit.ball), drawn->fit),
                faults_ + 2 * drawn->faults, climate);
}

/// The mesh with the ball and its image exchanged; vertices not numbered without gaps yet.
HexComplex SymmetricWalk::doubly_exchanged(const Layers& layers, const Fit& fit) const {
  const HexComplex once = exchanged(mesh_, ball_, layers, fit);
  const VertexId own_vertices = mesh_.vertices;
  const VertexId inside = once.vertices - own_vertices;
  HexComplex result{once.vertices + inside, {}};
  std::size_t at = 0;  // in `once`, which has the hexahedra outside of the ball in their order
  for (std::uint32_t cell = 0; cell < mesh_.hexahedra.size(); ++cell) {
    if (ball_.contains(cell)) continue;
    if (!ball_.contains(involution_.cell[cell])) result.hexahedra.push_back(once.hexahedra[at]);
    ++at;
  }
  for (; at < once.hexahedra.size(); ++at) {
    complex::Hexahedron cell = once.hexahedra[at];
    result.hexahedra.push_back(cell);
    for (VertexId& v : cell) v = v < own_vertices ? involution_.vertex[v] : v + inside;
    if (involution_.is_mirrored) cells::exchange_axes(cell);
    result.hexahedra.push_back(cell);
  }
  return result;
}

/// What is left without the ball, which is its own image.
SymmetricFront SymmetricWalk::cavity_of_ball() const {
  SymmetricFront result{{ball_.front().boundary, ball_.related_outside()}, {}};
  const Relation quads = relation_of_quads(result.front.boundary);
  for (std::size_t v = 0; v < static_cast<std::size_t>(result.front.boundary.vertices()); ++v) {
    result.front.related[v] |= quads[v];
    result.image[v] = ball_.boundary_vertex(involution_.vertex[ball_.rim(static_cast<Vertex>(v))]);
  }
  return result;
}

bool SymmetricWalk::invariant_exchange(const Climate& climate) {
  if (!grow_own_image()) return false;
  const int size = static_cast<int>(ball_.cells().size());
  const Front& front = ball_.front();
  const auto vertices = static_cast<std::size_t>(front.boundary.vertices());
  const CanonicalSymmetricState canonical = canonical_state(cavity_of_ball());
  SymmetricBeam::Node node;
  node.state = canonical.state;
  struct Way {
    SymmetricPairing pairing;
    int hexahedra, faults;  ///< more than now
  };
  std::vector<Way> ways;
  const int own = scars_of<SymmetricState::Scars>(front.related, relation_of_quads(front.boundary),
                                                  front.boundary.vertices(), canonical.label)
                      .size_in_common(canonical.state.scars);
  constexpr double kToStay = 1;
  double total = kToStay;
  sums_.clear();
  symmetric_->for_each_pairing(
      node, {.price = 0, .below = size + kMostClimb + 1},
      [&](const SymmetricPairing& pairing, int hexahedra, int faults) {
        ways.push_back({pairing, hexahedra - size, faults - own});
        total += std::sqrt(climate.factor(ways.back().hexahedra, ways.back().faults));
        sums_.push_back(total);
      });
  const auto drawn = drawn_by_weight(sums_, kToStay, random_);
  if (!drawn) return false;
  const Way& way = ways[*drawn];
  if (way.hexahedra == 0 && way.faults == 0 && random_.below(kSamePrice) != 0) return false;
  const SymmetricFit fit = symmetric_->fit_of(node, way.pairing);
  std::vector<VertexId> canonical_rim(vertices), rim(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    canonical_rim[canonical.label[v]] = ball_.rim(static_cast<Vertex>(v));
  for (std::size_t v = 0; v < vertices; ++v) rim[v] = canonical_rim[fit.turn[v]];
  return accept(exchanged(mesh_, ball_.cells(), symmetric_->layers_of(fit), rim,
                          canonical.is_mirrored != fit.is_mirrored),
                faults_ + way.faults, climate);
}

/// A ball and its image may have faults with each other that the draw did not see: these are paid
/// for here.
bool SymmetricWalk::accept(HexComplex made, int expected_faults, const Climate& climate) {
  made = complex::compacted(std::move(made), quads_ + 2);
  auto neighbours = SubBall::neighbours_if_complex(made, quads_);
  if (!neighbours) return false;
  const int faults = faults_of(made, *neighbours);
  if (faults > expected_faults &&
      random_.uniform() >= std::sqrt(climate.factor(0, faults - expected_faults)))
    return false;
  auto involution = extended(of_boundary_, made, quads_, *neighbours);
  core::expects(involution.has_value(), "a symmetric exchange keeps the involution");
  mesh_ = std::move(made);
  neighbours_ = *std::move(neighbours);
  involution_ = *std::move(involution);
  faults_ = faults;
  return true;
}

}  // namespace hexatlas::flips
