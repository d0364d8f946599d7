#include "tables/check/bound_sphere.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "tables/check/quad_code.hpp"

namespace hexatlas::check {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using QuadsAtEdges = std::map<Edge, std::vector<std::size_t>>;

constexpr std::uint32_t kNone = ~std::uint32_t{0};

Edge edge_of(std::uint32_t u, std::uint32_t v) { return std::minmax(u, v); }

QuadsAtEdges quads_at_edges(std::span<const Quad> quads) {
  QuadsAtEdges at;
  for (std::size_t q = 0; q < quads.size(); ++q) {
    for (std::size_t i = 0; i < 4; ++i) {
      at[edge_of(quads[q][i], quads[q][(i + 1) % 4])].push_back(q);
    }
  }
  return at;
}

bool runs_along(const Quad& quad, std::uint32_t from, std::uint32_t to) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (quad[i] == from && quad[(i + 1) % 4] == to) return true;
  }
  return false;
}

/// The quads turned so that neighbours run along their edge in opposite directions, as far as they
/// are reached from the first; whether all agree is for canonical_code to say.
std::vector<Quad> oriented(std::span<const Quad> quads, const QuadsAtEdges& at) {
  std::vector<Quad> result(quads.begin(), quads.end());
  std::vector<bool> reached(quads.size(), false);
  std::vector<std::size_t> queue = {0};
  reached[0] = true;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Quad quad = result[queue[k]];
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t from = quad[i];
      const std::uint32_t to = quad[(i + 1) % 4];
      for (const std::size_t other : at.at(edge_of(from, to))) {
        if (reached[other]) continue;
        reached[other] = true;
        if (runs_along(result[other], from, to)) {
          std::reverse(result[other].begin(), result[other].end());
        }
        queue.push_back(other);
      }
    }
  }
  return result;
}

/// Extends the map of one quad to all, across edges; nothing if that is impossible.
class Propagation {
 public:
  Propagation(std::span<const Quad> quads, const QuadsAtEdges& at)
      : quads_(quads), at_(at), image_(quads.size() + 2), quad_image_(quads.size()) {}

  /// Takes quad 0 to `target`, its vertex i to that at first + step * i.
  std::optional<BoundAutomorphism> from(std::size_t target, std::size_t first, std::size_t step) {
    std::fill(image_.begin(), image_.end(), kNone);
    std::fill(quad_image_.begin(), quad_image_.end(), kNone);
    for (std::size_t i = 0; i < 4; ++i)
      image_[quads_[0][i]] = quads_[target][(first + step * i) % 4];
    quad_image_[0] = static_cast<std::uint32_t>(target);
    std::vector<std::size_t> queue = {0};
    for (std::size_t k = 0; k < queue.size(); ++k) {
      if (!cross_edges(queue[k], queue)) return std::nullopt;
    }
    return permutation();
  }

 private:
  bool cross_edges(std::size_t quad, std::vector<std::size_t>& queue) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t u = quads_[quad][i];
      const std::uint32_t v = quads_[quad][(i + 1) % 4];
      const std::size_t other = beyond(quad, u, v);
      if (quad_image_[other] != kNone) continue;
      const std::size_t target = beyond(quad_image_[quad], image_[u], image_[v]);
      quad_image_[other] = static_cast<std::uint32_t>(target);
      queue.push_back(other);
      if (!extend(u, v, quads_[other], quads_[target]) ||
          !extend(v, u, quads_[other], quads_[target])) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] std::size_t beyond(std::size_t quad, std::uint32_t u, std::uint32_t v) const {
    const std::vector<std::size_t>& both = at_.at(edge_of(u, v));
    return both[0] == quad ? both[1] : both[0];
  }

  /// The neighbour of u in `quad` that is not v, and the same of the images in `target`.
  bool extend(std::uint32_t u, std::uint32_t v, const Quad& quad, const Quad& target) {
    const std::uint32_t from = neighbour(quad, u, v);
    const std::uint32_t to = neighbour(target, image_[u], image_[v]);
    if (image_[from] == kNone) image_[from] = to;
    return image_[from] == to;
  }

  static std::uint32_t neighbour(const Quad& quad, std::uint32_t u, std::uint32_t v) {
    std::size_t i = 0;
    while (quad[i] != u) ++i;
    return quad[(i + 1) % 4] == v ? quad[(i + 3) % 4] : quad[(i + 1) % 4];
  }

  /// The map, if it is one of all vertices and takes the quads to the quads, each once.
  [[nodiscard]] std::optional<BoundAutomorphism> permutation() const {
    BoundAutomorphism result;
    std::vector<bool> is_hit(image_.size(), false);
    for (const std::uint32_t v : image_) {
      if (v == kNone || is_hit[v]) return std::nullopt;
      is_hit[v] = true;
      result.push_back(static_cast<std::uint8_t>(v));
    }
    std::vector<bool> is_quad_hit(quads_.size(), false);
    for (std::size_t q = 0; q < quads_.size(); ++q) {
      const Quad& target = quads_[quad_image_[q]];
      if (is_quad_hit[quad_image_[q]]) return std::nullopt;
      is_quad_hit[quad_image_[q]] = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t from = image_[quads_[q][i]];
        const std::uint32_t to = image_[quads_[q][(i + 1) % 4]];
        if (!runs_along(target, from, to) && !runs_along(target, to, from)) return std::nullopt;
      }
    }
    return result;
  }

  std::span<const Quad> quads_;
  const QuadsAtEdges& at_;
  std::vector<std::uint32_t> image_;
  std::vector<std::uint32_t> quad_image_;
};

}  // namespace

std::string fault_of_boundary(std::span<const Quad> quads, std::string_view code) {
  // The least 3-connected quadrangulation is the cube; fewer quads would share more than an edge.
  if (quads.size() < 6) return "the boundary has fewer than 6 quads";
  const QuadsAtEdges at = quads_at_edges(quads);
  const bool is_closed = std::all_of(at.begin(), at.end(), [](const auto& edge) {
    return edge.first.first != edge.first.second && edge.second.size() == 2;
  });
  const std::vector<Quad> turned = oriented(quads, at);
  const auto canonical = canonical_code(turned);
  if (!is_closed || !canonical) return "the quads are no quadrangulation of the sphere";
  if (!is_three_connected_by_quads(turned)) return "the boundary is not 3-connected";
  const std::string own = code_text(canonical->word);
  return own == code ? "" : "the code of the boundary is " + own;
}

std::vector<BoundAutomorphism> automorphisms_of(std::span<const Quad> quads) {
  const QuadsAtEdges at = quads_at_edges(quads);
  Propagation propagation(quads, at);
  std::vector<BoundAutomorphism> found;
  for (std::size_t target = 0; target < quads.size(); ++target) {
    for (std::size_t first = 0; first < 4; ++first) {
      for (const std::size_t step : {std::size_t{1}, std::size_t{3}}) {
        if (auto map = propagation.from(target, first, step)) found.push_back(std::move(*map));
      }
    }
  }
  return found;
}

}  // namespace hexatlas::check
