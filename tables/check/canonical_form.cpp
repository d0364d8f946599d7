#include "tables/check/canonical_form.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace hexatlas::check {

namespace {

/// Keeps the least list offered, and how often it was.
class Least {
 public:
  /// Sorts the candidate.
  void offer(Tetrahedra& candidate) {
    std::sort(candidate.begin(), candidate.end());
    if (form_.automorphisms == 0 || candidate < form_.least) {
      form_.least = candidate;
      form_.automorphisms = 0;
    }
    if (candidate == form_.least) ++form_.automorphisms;
  }
  [[nodiscard]] CanonicalForm take() { return std::move(form_); }

 private:
  CanonicalForm form_;
};

/// Numberings of a ball from its tetrahedra.
class BallNumbering {
 public:
  explicit BallNumbering(const Tetrahedra& tetrahedra) : tetrahedra_(tetrahedra) {
    across_.resize(tetrahedra.size());
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
      across_[t].fill(kNoNeighbour);
      for (std::size_t s = 0; s < tetrahedra.size(); ++s) {
        const unsigned opposite = tetrahedra[t] & ~unsigned{tetrahedra[s]};
        if (std::popcount(opposite) == 1) {
          across_[t][static_cast<std::size_t>(std::countr_zero(opposite))] = s;
        }
      }
    }
  }

  /// The number of each vertex if those of tetrahedron `start` are numbered as in `first`.
  const VertexPermutation& from(std::size_t start, const std::array<std::uint8_t, 4>& first) {
    number_.fill(kNone);
    vertex_ = {};
    next_number_ = 0;
    for (const std::uint8_t v : first) give_number(v);
    visited_.assign(tetrahedra_.size(), false);
    queue_.assign(1, start);
    visited_[start] = true;
    std::size_t head = 0;
    while (head < queue_.size()) visit_neighbours(queue_[head++]);  // which makes it longer
    return number_;
  }

 private:
  static constexpr std::uint8_t kNone = 0xFF;
  static constexpr std::size_t kNoNeighbour = ~std::size_t{0};

  void give_number(std::uint8_t v) {
    vertex_[next_number_] = v;
    number_[v] = next_number_++;
  }

  void visit_neighbours(std::size_t t) {
    const VertexBits numbers = image_of(tetrahedra_[t], number_);
    for (unsigned rest = numbers; rest != 0; rest &= rest - 1) {
      const std::size_t next =
          across_[t][vertex_[static_cast<std::size_t>(std::countr_zero(rest))]];
      if (next == kNoNeighbour || visited_[next]) continue;
      visited_[next] = true;
      queue_.push_back(next);
      const unsigned fourth = tetrahedra_[next] & ~unsigned{tetrahedra_[t]};
      const auto v = static_cast<std::uint8_t>(std::countr_zero(fourth));
      if (number_[v] == kNone) give_number(v);
    }
  }

  const Tetrahedra& tetrahedra_;
  /// Index of the tetrahedron across the triangle opposite to a vertex.
  std::vector<std::array<std::size_t, kMostCatalogueVertices>> across_;
  VertexPermutation number_{};
  VertexPermutation vertex_{};  ///< by number
  std::uint8_t next_number_ = 0;
  std::vector<bool> visited_;
  std::vector<std::size_t> queue_;
};

Tetrahedra images_of(const Tetrahedra& tetrahedra, const VertexPermutation& map) {
  Tetrahedra images;
  images.reserve(tetrahedra.size());
  for (const VertexBits tetrahedron : tetrahedra) images.push_back(image_of(tetrahedron, map));
  return images;
}

}  // namespace

std::vector<VertexPermutation> with_interior_permutations(
    const std::vector<VertexPermutation>& symmetries, int boundary_vertices, int interior) {
  std::vector<std::uint8_t> order(static_cast<std::size_t>(interior));
  std::iota(order.begin(), order.end(), static_cast<std::uint8_t>(boundary_vertices));
  std::vector<VertexPermutation> result;
  do {
    for (VertexPermutation map : symmetries) {
      std::copy(order.begin(), order.end(), map.begin() + boundary_vertices);
      result.push_back(map);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

CanonicalForm form_in_cell(const Tetrahedra& tetrahedra,
                           const std::vector<VertexPermutation>& permutations) {
  Least least;
  for (const VertexPermutation& map : permutations) {
    Tetrahedra images = images_of(tetrahedra, map);
    least.offer(images);
  }
  return least.take();
}

CanonicalForm form_of_ball(const Tetrahedra& tetrahedra) {
  BallNumbering numbering(tetrahedra);
  Least least;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    std::array<std::uint8_t, 4> first{};
    unsigned rest = tetrahedra[t];
    for (std::uint8_t& v : first) {
      v = static_cast<std::uint8_t>(std::countr_zero(rest));
      rest &= rest - 1;
    }
    do {
      Tetrahedra images = images_of(tetrahedra, numbering.from(t, first));
      least.offer(images);
    } while (std::next_permutation(first.begin(), first.end()));
  }
  return least.take();
}

}  // namespace hexatlas::check
