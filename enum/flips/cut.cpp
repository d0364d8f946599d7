#include "enum/flips/cut.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cstdint>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/circles.hpp"
#include "enum/flips/disc.hpp"

namespace hexatlas::flips {
namespace {

using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;
using complex::VertexId;

constexpr std::size_t kMaxCircle = 10;
constexpr std::size_t kMaxInterior = 8;
constexpr std::size_t kMaxDiscVertices = 16;

/// Pairs of vertices of one disc.
using PairSet = std::bitset<kMaxDiscVertices*(kMaxDiscVertices - 1) / 2>;

/// A pair of vertices of a circle of at most 10, as a bit.
std::uint64_t pair_bit(std::size_t i, std::size_t j) {
  const std::size_t low = std::min(i, j), high = std::max(i, j);
  return std::uint64_t{1} << (high * (high - 1) / 2 + low);
}

/// A disc, with what shows at a glance that it does not fit.
struct Filling {
  Disc quads;
  VertexSet narrow = 0;      ///< the boundary vertices with one quad
  std::uint64_t chords = 0;  ///< the edges between boundary vertices, those of the circle left out
};

/// nullopt if a vertex inside has fewer than 3 quads: no boundary that is 3-connected has one.
std::optional<Filling> filling_of(const Disc& disc, std::size_t length) {
  Filling filling{disc};
  std::array<int, kMaxDiscVertices> degree{};
  for (const QuadVertices& quad : disc)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t v = quad[i];
      const std::size_t w = quad[(i + 1) % 4];
      ++degree[v];
      if (v < length && w < length && (v + 1) % length != w) filling.chords |= pair_bit(v, w);
    }
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (v < length && degree[v] == 1) filling.narrow |= bit(static_cast<Vertex>(v));
    if (v >= length && (degree[v] == 1 || degree[v] == 2)) return std::nullopt;
  }
  return filling;
}

/// Made once for each pair of numbers.
const std::vector<Filling>& fillings(std::size_t length, std::size_t interior) {
  struct Lists {
    std::array<std::array<std::once_flag, kMaxInterior + 1>, kMaxCircle + 1> once;
    std::array<std::array<std::vector<Filling>, kMaxInterior + 1>, kMaxCircle + 1> list;
  };
  static Lists lists;
  std::vector<Filling>& own = lists.list[length][interior];
  std::call_once(lists.once[length][interior], [&] {
    for (const Disc& disc : discs(static_cast<int>(length), static_cast<int>(interior)))
      if (auto filling = filling_of(disc, length)) own.push_back(*std::move(filling));
  });
  return own;
}

/// One of the two balls of a cut: its boundary, and what its vertices are in the cut, where those
/// of the target come first and those inside the disc follow.
struct Side {
  std::vector<Vertex> in_cut;
  canon::CanonicalFlags flags;
  Quadrangulation boundary;
  Relation of_quads{};  ///< in numbers of the cut
  int least = 0;        ///< hexahedra of a ball with this boundary
};

/// A way to fill one side: a ball, turned, and the pairs of the disc that it relates.
struct Turned {
  PairSet pairs;
  int hexahedra = 0;
  std::uint32_t ball = 0;
  std::uint32_t flag = 0;
};

class CutSearch {
 public:
  CutSearch(const BallSource& balls, const canon::Code& target, const CutOptions& options)
      : source_(balls),
        q_(canon::decode(target).value()),
        graph_(graph_of(q_)),
        options_(options),
        below_(options.below) {}

  /// Cuts that may be made are listed first, then tried from the least sum of two balls on: once
  /// meshes are found, most of them need no look at their balls.
  std::vector<complex::HexComplex> run() {
    for (int length = 4; length <= options_.max_circle; length += 2)
      for (const Circle& circle : circles(graph_, q_.vertices(), length)) list_cuts(circle);
    std::stable_sort(cuts_.begin(), cuts_.end(),
                     [](const Cut& a, const Cut& b) { return a.least < b.least; });
    for (const Cut& cut : cuts_) {
      if (cut.least >= below_) break;
      std::array<Side, 2> sides;
      (void)make_sides(cut, sides);
      list_pairs(cut.disc);
      match(sides);
    }
    return std::move(meshes_);
  }

 private:
  struct Cut {
    std::vector<bool> left;  ///< the quads of one side
    Disc disc;               ///< in numbers of the cut
    int least = 0;           ///< no union has fewer hexahedra
  };

  void list_cuts(const Circle& circle) {
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
      for (const Filling& filling : fillings(rim.size(), static_cast<std::size_t>(interior)))
        if ((filling.narrow & needy) == 0 && (filling.chords & near) == 0)
          list_cut(left, rim, filling.quads);
    }
  }

  void list_cut(const std::vector<bool>& left, const Circle& rim, const Disc& disc) {
    Cut cut{left, disc, 0};
    for (QuadVertices& quad : cut.disc)
      for (Vertex& v : quad)
        v = v < rim.size() ? rim[v]
                           : static_cast<Vertex>(q_.vertices() + v - static_cast<int>(rim.size()));
    std::array<Side, 2> sides;
    if (!make_sides(cut, sides)) return;
    cut.least = sides[0].least + sides[1].least;
    if (cut.least < below_) cuts_.push_back(std::move(cut));
  }

  /// False if one of them is no boundary of a known ball.
  bool make_sides(const Cut& cut, std::array<Side, 2>& sides) const {
    for (std::size_t s = 0; s < 2; ++s) {
      std::vector<QuadVertices> quads;
      for (int i = 0; i < q_.quads(); ++i)
        if (cut.left[static_cast<std::size_t>(i)] == (s == 0)) quads.push_back(q_.vertices_of(i));
      for (QuadVertices quad : cut.disc) {
        if (s == 1) std::reverse(quad.begin(), quad.end());
        quads.push_back(quad);
      }
      if (!make_side(quads, sides[s])) return false;
    }
    return true;
  }

  /// False if the quads are no boundary of a known ball.
  bool make_side(const std::vector<QuadVertices>& quads, Side& side) const {
    constexpr Vertex kNone = 0xFF;
    std::array<Vertex, complex::kMaxVertices> number{};
    number.fill(kNone);
    std::vector<QuadVertices> own = quads;
    for (QuadVertices& quad : own)
      for (Vertex& v : quad) {
        if (number[v] == kNone) {
          number[v] = static_cast<Vertex>(side.in_cut.size());
          side.in_cut.push_back(v);
        }
        v = number[v];
      }
    if (side.in_cut.size() != quads.size() + 2) return false;
    const auto boundary = Quadrangulation::from_quads(own);
    if (!boundary || !boundary->is_three_connected()) return false;
    side.boundary = *boundary;
    canon::canonical_flags(*boundary, side.flags);
    const auto least = source_.least_with(side.flags.code);
    if (!least) return false;
    side.least = *least;
    for (const QuadVertices& quad : quads)
      for (const Vertex v : quad) side.of_quads[v] |= set_of(quad);
    return true;
  }

  /// The pairs of vertices of the disc that lie in no quad of it.
  void list_pairs(const std::vector<QuadVertices>& disc) {
    Relation in_disc{};
    VertexSet all = 0;
    for (const QuadVertices& quad : disc) {
      for (const Vertex v : quad) in_disc[v] |= set_of(quad);
      all |= set_of(quad);
    }
    pairs_.clear();
    for (VertexSet rest = all; rest != 0; rest &= rest - 1) {
      const auto a = static_cast<Vertex>(std::countr_zero(rest));
      for (VertexSet later = rest & ~in_disc[a]; later != 0; later &= later - 1)
        pairs_.emplace_back(a, static_cast<Vertex>(std::countr_zero(later)));
    }
  }

  /// In order of hexahedra; of those with the same pairs the first only.
  std::vector<Turned> turned(const Side& side, int below) {
    std::vector<Turned> result;
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
        Turned one{{}, known.hexahedra, ball, flag};
        for (std::size_t p = 0; p < pairs_.size(); ++p) {
          const auto [a, b] = pairs_[p];
          if ((side.of_quads[a] & bit(b)) != 0 ||
              known.scars.has(labels[flag][number[a]], labels[flag][number[b]]))
            one.pairs.set(p);
        }
        const bool is_new = std::none_of(result.begin(), result.end(), [&](const Turned& other) {
          return (other.pairs & ~one.pairs).none();
        });
        if (is_new) result.push_back(one);
      }
    }
    return result;
  }

  const std::vector<KnownBall>& balls_with(const canon::Code& boundary) {
    const auto [known, is_new] = known_.try_emplace(boundary);
    if (is_new) known->second = source_.balls_with(boundary);
    return known->second;
  }

  void match(const std::array<Side, 2>& sides) {
    for (const auto& [a, b] : pairs_)
      if ((sides[0].of_quads[a] & sides[1].of_quads[a] & bit(b)) != 0) return;
    const std::vector<Turned> first = turned(sides[0], below_ - sides[1].least);
    const std::vector<Turned> second = turned(sides[1], below_ - sides[0].least);
    int below = below_;
    std::optional<std::array<Turned, 2>> found;
    for (const Turned& one : first)
      for (const Turned& other : second) {
        if (one.hexahedra + other.hexahedra >= below) break;
        if ((one.pairs & other.pairs).any()) continue;
        below = one.hexahedra + other.hexahedra;
        found = {one, other};
      }
    if (found) keep(assembled(sides, *found));
  }

  void keep(complex::HexComplex mesh) {
    const auto place = std::upper_bound(
        meshes_.begin(), meshes_.end(), mesh,
        [](const auto& a, const auto& b) { return a.hexahedra.size() < b.hexahedra.size(); });
    meshes_.insert(place, std::move(mesh));
    if (meshes_.size() > options_.count) meshes_.pop_back();
    if (meshes_.size() == options_.count)
      below_ = std::min(below_, static_cast<int>(meshes_.back().hexahedra.size()));
  }

  [[nodiscard]] complex::HexComplex assembled(const std::array<Side, 2>& sides,
                                              const std::array<Turned, 2>& chosen) const {
    complex::HexComplex mesh{complex::kMaxVertices, {}};
    for (std::size_t s = 0; s < 2; ++s) {
      const Side& side = sides[s];
      const canon::Flag flag = side.flags.flags[chosen[s].flag];
      const canon::Labelling label = canon::labelling_from(side.boundary, flag);
      std::vector<VertexId> rim(side.in_cut.size());
      for (std::size_t v = 0; v < rim.size(); ++v) rim[label[v]] = side.in_cut[v];
      append_ball(mesh, source_.layers_of(side.flags.code, chosen[s].ball), rim, flag.mirrored);
    }
    return complex::compacted(std::move(mesh), q_.vertices());
  }

  const BallSource& source_;
  Quadrangulation q_;
  Graph graph_;
  CutOptions options_;
  int below_;
  std::vector<complex::HexComplex> meshes_;
  std::unordered_map<canon::Code, std::vector<KnownBall>> known_;
  std::vector<Cut> cuts_;
  std::vector<std::pair<Vertex, Vertex>> pairs_;
};

}  // namespace

std::vector<complex::HexComplex> best_cuts(const BallSource& balls, const canon::Code& target,
                                           const CutOptions& options) {
  core::expects(options.max_circle <= static_cast<int>(kMaxCircle) &&
                    options.max_interior <= static_cast<int>(kMaxInterior) &&
                    options.max_quads <= kMaxSearchQuads && options.count > 0,
                "a cut is small");
  return CutSearch(balls, target, options).run();
}

std::optional<complex::HexComplex> best_cut(const BallSource& balls, const canon::Code& target,
                                            CutOptions options) {
  options.count = 1;
  std::vector<complex::HexComplex> meshes = best_cuts(balls, target, options);
  if (meshes.empty()) return std::nullopt;
  return std::move(meshes.front());
}

}  // namespace hexatlas::flips
