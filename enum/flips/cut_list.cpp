#include "enum/flips/cut_list.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/flips/circles.hpp"
#include "enum/flips/numbered_boundary.hpp"

namespace hexatlas::flips {

using complex::QuadVertices;
using complex::Vertex;
using complex::VertexId;

CutList::CutList(const BallSource& balls, const canon::Code& target, const CutOptions& options)
    : source_(balls), q_(canon::decode(target).value()), graph_(graph_of(q_)), options_(options) {
  core::expects(options.max_circle <= static_cast<int>(kMaxDiscCircle) &&
                    options.max_interior <= static_cast<int>(kMaxDiscInterior) &&
                    options.max_quads <= kMaxStateQuads,
                "a cut is small");
  for (int length = 4; length <= options_.max_circle; length += 2)
    for (const Circle& circle : circles(graph_, q_.vertices(), length)) list_cuts(circle);
}

void CutList::list_cuts(const Circle& circle) {
  const std::vector<bool> left = left_of(q_, circle);
  // Quads of either side, in all and at each vertex.
  std::array<std::size_t, 2> count{};
  std::array<std::array<std::uint8_t, complex::kMaxVertices>, 2> degree{};
  for (int i = 0; i < q_.quads(); ++i) {
    const std::size_t side = left[static_cast<std::size_t>(i)] ? 0 : 1;
    ++count[side];
    for (const Vertex v : q_.vertices_of(i)) ++degree[side][v];
  }
  // The circle runs around the left side; from there the disc is seen the other way round.
  Circle rim = circle;
  std::reverse(rim.begin() + 1, rim.end());
  VertexSet needy = 0;  // a vertex needs three quads on either side
  std::uint64_t near = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (degree[0][rim[i]] == 1 || degree[1][rim[i]] == 1) needy |= bit(static_cast<Vertex>(i));
    for (std::size_t j = 0; j < i; ++j)
      if ((graph_[rim[i]] & bit(rim[j])) != 0) near |= pair_bit(i, j);
  }
  const auto most = static_cast<std::size_t>(options_.max_quads);
  for (int interior = 0; interior <= options_.max_interior; ++interior) {
    const std::size_t size = rim.size() / 2 - 1 + static_cast<std::size_t>(interior);
    if (rim.size() + static_cast<std::size_t>(interior) > kMaxDiscVertices) break;
    if ((count[0] + size) % 2 != 0 || std::max(count[0], count[1]) + size > most) continue;
    for (const MarkedDisc& disc : marked_discs(rim.size(), static_cast<std::size_t>(interior)))
      if ((disc.narrow & needy) == 0 && (disc.chords & near) == 0) list_cut(left, rim, disc.quads);
  }
}

void CutList::list_cut(const std::vector<bool>& left, const Circle& rim, const Disc& disc) {
  Cut cut{left, placed(disc, rim, static_cast<Vertex>(q_.vertices())), 0};
  const auto sides = sides_if_known(cut);
  if (!sides) return;
  cut.least = (*sides)[0].least + (*sides)[1].least;
  if (cut.least < options_.below) cuts_.push_back(std::move(cut));
}

/// nullopt if one of them is no boundary of a known ball.
std::optional<CutSides> CutList::sides_if_known(const Cut& cut) const {
  CutSides sides;
  for (std::size_t s = 0; s < 2; ++s) {
    std::vector<QuadVertices> quads;
    for (int i = 0; i < q_.quads(); ++i)
      if (cut.left[static_cast<std::size_t>(i)] == (s == 0)) quads.push_back(q_.vertices_of(i));
    for (QuadVertices quad : cut.disc) {
      if (s == 1) std::reverse(quad.begin(), quad.end());
      quads.push_back(quad);
    }
    auto side = side_if_known(quads);
    if (!side) return std::nullopt;
    sides[s] = *std::move(side);
  }
  return sides;
}

CutSides CutList::sides_of(const Cut& cut) const { return sides_if_known(cut).value(); }

/// nullopt if the quads are no boundary of a known ball.
std::optional<CutSide> CutList::side_if_known(const std::vector<QuadVertices>& quads) const {
  auto numbered = three_connected_boundary(quads);
  if (!numbered) return std::nullopt;
  CutSide side;
  side.in_cut = std::move(numbered->name);
  side.boundary = numbered->boundary;
  canon::canonical_flags(side.boundary, side.flags);
  const auto least = source_.least_with(side.flags.code);
  if (!least) return std::nullopt;
  side.least = *least;
  for (const QuadVertices& quad : quads) relate(set_of(quad), side.of_quads);
  return side;
}

CutList::Pairs CutList::pairs_of(const Cut& cut) {
  Relation in_disc{};
  VertexSet all = 0;
  for (const QuadVertices& quad : cut.disc) {
    relate(set_of(quad), in_disc);
    all |= set_of(quad);
  }
  Pairs result;
  for (VertexSet rest = all; rest != 0; rest &= rest - 1) {
    const auto a = static_cast<Vertex>(std::countr_zero(rest));
    for (VertexSet later = rest & ~in_disc[a]; later != 0; later &= later - 1)
      result.emplace_back(a, static_cast<Vertex>(std::countr_zero(later)));
  }
  return result;
}

bool CutList::related_by_quads(const CutSides& sides, const Pairs& pairs) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    const auto [a, b] = pair;
    return (sides[0].of_quads[a] & sides[1].of_quads[a] & bit(b)) != 0;
  });
}

std::vector<TurnedBall> CutList::turned(const CutSide& side, const Pairs& pairs, int below) {
  std::vector<TurnedBall> result;
  std::array<Vertex, complex::kMaxVertices> number{};
  for (std::size_t v = 0; v < side.in_cut.size(); ++v)
    number[side.in_cut[v]] = static_cast<Vertex>(v);
  std::vector<canon::Labelling> labels;
  labels.reserve(static_cast<std::size_t>(side.flags.count));
  for (int i = 0; i < side.flags.count; ++i)
    labels.push_back(
        canon::labelling_from(side.boundary, side.flags.flags[static_cast<std::size_t>(i)]));
  const std::vector<KnownBall>& balls = balls_with(side.flags.code);
  for (std::uint32_t ball = 0; ball < balls.size(); ++ball) {
    const KnownBall& known = balls[ball];
    if (known.hexahedra >= below) break;
    for (std::uint32_t flag = 0; flag < labels.size(); ++flag) {
      TurnedBall one{{}, known.hexahedra, ball, flag};
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        const auto [a, b] = pairs[p];
        if ((side.of_quads[a] & bit(b)) != 0 ||
            known.scars.has(labels[flag][number[a]], labels[flag][number[b]]))
          one.pairs.set(p);
      }
      result.push_back(one);
    }
  }
  return result;
}

const std::vector<KnownBall>& CutList::balls_with(const canon::Code& boundary) {
  const auto [known, is_new] = known_.try_emplace(boundary);
  if (is_new) known->second = source_.balls_with(boundary);
  return known->second;
}

complex::HexComplex CutList::assembled(const CutSides& sides,
                                       const std::array<TurnedBall, 2>& chosen) const {
  complex::HexComplex mesh{complex::kMaxVertices, {}};
  for (std::size_t s = 0; s < 2; ++s) {
    const CutSide& side = sides[s];
    const canon::Flag flag = side.flags.flags[chosen[s].flag];
    const canon::Labelling label = canon::labelling_from(side.boundary, flag);
    std::vector<VertexId> rim(side.in_cut.size());
    for (std::size_t v = 0; v < rim.size(); ++v) rim[label[v]] = side.in_cut[v];
    append_ball(mesh, source_.layers_of(side.flags.code, chosen[s].ball), rim, flag.mirrored);
  }
  return complex::compacted(std::move(mesh), q_.vertices());
}

}  // namespace hexatlas::flips
