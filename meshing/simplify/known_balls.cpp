#include "meshing/simplify/known_balls.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/front.hpp"
#include "enum/flips/meeting.hpp"
#include "meshing/simplify/small_meshes.hpp"
#include "tables/fill/filled.hpp"

namespace hexatlas::simplify {
namespace {

using complex::Hexahedron;
using complex::HexComplex;
using complex::Vertex;
using complex::VertexId;
using core::mixed;

constexpr std::size_t kBallsPerBoundary = 24;
constexpr int kSpare = 3;                             ///< hexahedra above the least ball known
constexpr std::size_t kMaxSeenHexahedra = 4'000'000;  ///< 32 bytes each
constexpr std::uint64_t kSearchNodes = 2000;

/// Colours of the vertices, refined twice by the hexahedra around them, added up.
std::uint64_t shape_of(const HexComplex& mesh, std::size_t boundary_vertices) {
  constexpr int kRounds = 2;
  std::vector<std::uint64_t> colour(mesh.vertices);
  for (std::size_t v = 0; v < boundary_vertices; ++v) colour[v] = v + 1;
  std::uint64_t sum = 0;
  for (int round = 0; round <= kRounds; ++round) {
    std::vector<std::uint64_t> next = colour;
    sum = 0;
    for (const Hexahedron& cell : mesh.hexahedra) {
      std::uint64_t own = 0;
      for (const VertexId v : cell) own += mixed(colour[v]);
      own = mixed(own);
      sum += own;
      for (const VertexId v : cell) next[v] += own;
    }
    colour = std::move(next);
  }
  return sum;
}

}  // namespace

Ball ball_of(HexComplex mesh, const complex::Quadrangulation& boundary) {
  const flips::Scars scars = flips::scars_of(mesh, boundary);
  const std::uint64_t shape = shape_of(mesh, static_cast<std::size_t>(boundary.vertices()));
  return {std::move(mesh), scars, shape};
}

Ball ball_at(const flips::SubBall& sub_ball, const HexComplex& mesh, const canon::Labelling& label,
             bool is_mirrored) {
  const complex::Quadrangulation& boundary = sub_ball.front().boundary;
  const auto rim = static_cast<std::size_t>(boundary.vertices());
  std::vector<VertexId> inside;  // few: a search among them is fast
  Ball ball;
  for (const std::uint32_t cell : sub_ball.cells()) {
    Hexahedron moved = mesh.hexahedra[cell];
    for (VertexId& v : moved) {
      if (const Vertex at = sub_ball.boundary_vertex(v); at != flips::kNewVertex) {
        v = label[at];
        continue;
      }
      const auto known = std::find(inside.begin(), inside.end(), v);
      const auto place = static_cast<std::size_t>(known - inside.begin());
      if (known == inside.end()) inside.push_back(v);
      v = static_cast<VertexId>(rim + place);
    }
    if (is_mirrored) cells::exchange_axes(moved);
    ball.mesh.hexahedra.push_back(moved);
  }
  ball.mesh.vertices = static_cast<std::uint32_t>(rim + inside.size());
  ball.scars = flips::scars_of(sub_ball.front().related, flips::relation_of_quads(boundary),
                               boundary.vertices(), label);
  ball.shape = shape_of(ball.mesh, rim);
  return ball;
}

const std::vector<Ball>& KnownBalls::with(const canon::Code& code, int hexahedra) {
  auto at = families_.find(code);
  if (at == families_.end()) {
    const auto ordinal = table_ != nullptr ? table_->find(code) : std::nullopt;
    if (!ordinal && hexahedra > kMaxSmallMesh) return none_;
    at = families_.try_emplace(code).first;
    if (ordinal)
      at->second.balls.push_back(
          ball_of(fill::mesh_in(*table_, *ordinal, table_->path()), canon::decode(code).value()));
  }
  Family& family = at->second;
  if (hexahedra <= kMaxSmallMesh && hexahedra > family.searched && hexahedra < family.given_up)
    search(code, hexahedra, family);
  return family.balls;
}

void KnownBalls::search(const canon::Code& code, int hexahedra, Family& family) {
  const complex::Quadrangulation boundary = canon::decode(code).value();
  SmallMeshes found = small_meshes(boundary, hexahedra, kSearchNodes);
  (found.is_all ? family.searched : family.given_up) = hexahedra;
  for (HexComplex& mesh : found.meshes) {
    Ball ball = ball_of(std::move(mesh), boundary);
    if (std::none_of(family.balls.begin(), family.balls.end(),
                     [&](const Ball& known) { return known.shape == ball.shape; }))
      family.balls.push_back(std::move(ball));
  }
}

void KnownBalls::add(const canon::Code& code, Ball ball, std::uint64_t turn) {
  if (ball.hexahedra() < 2) return;
  // Where nothing more is kept, no family is either.
  if (seen_hexahedra_ >= kMaxSeenHexahedra && !families_.contains(code)) return;
  std::vector<Ball>& balls = families_[code].balls;
  int least = ball.hexahedra();
  for (const Ball& known : balls) {
    if (known.shape == ball.shape) return;
    least = std::min(least, known.hexahedra());
  }
  if (ball.hexahedra() > least + kSpare) return;
  if (balls.size() < kBallsPerBoundary) {
    if (seen_hexahedra_ >= kMaxSeenHexahedra) return;
    seen_hexahedra_ += ball.mesh.hexahedra.size();
    balls.push_back(std::move(ball));
  } else if (Ball& rival = balls[turn % balls.size()]; rival.hexahedra() >= ball.hexahedra()) {
    rival = std::move(ball);
  }
}

}  // namespace hexatlas::simplify
