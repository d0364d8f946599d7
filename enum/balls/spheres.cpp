#include "enum/balls/spheres.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "enum/canon/nauty/triangulation_form.hpp"
#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::balls {
namespace {

using complex::bit_of;
using complex::least_vertex;
using complex::Triangulation;
using complex::VertexSet;
using complex::without_least;

/// The vertices of the link of each edge and each triangle; no vertices if it is no face.
class Links {
 public:
  explicit Links(const Triangulation& triangulation) {
    for (const VertexSet tetrahedron : triangulation.tetrahedra)
      for (VertexSet rest = tetrahedron; rest != 0; rest = without_least(rest)) {
        const VertexSet a = bit_of(least_vertex(rest));
        add(tetrahedron ^ a, a);
        for (VertexSet later = without_least(rest); later != 0; later = without_least(later)) {
          const auto edge = static_cast<unsigned>(a | bit_of(least_vertex(later)));
          add(edge, tetrahedron ^ edge);
        }
      }
  }
  [[nodiscard]] VertexSet of(VertexSet face) const { return link_[face]; }
  /// Edges and triangles, ascending.
  [[nodiscard]] std::vector<VertexSet> faces(int vertices) const {
    std::vector<VertexSet> result;
    for (unsigned face = 0; face < 1U << static_cast<unsigned>(vertices); ++face)
      if (link_[face] != 0) result.push_back(static_cast<VertexSet>(face));
    return result;
  }

 private:
  void add(unsigned face, unsigned vertices) {
    link_[face] = static_cast<VertexSet>(link_[face] | vertices);
  }
  std::array<VertexSet, std::size_t{1} << kMaxSphereVertices> link_{};
};

/// Replaces A * dB by dA * B; tetrahedra ascending.
Triangulation flip(const Triangulation& sphere, VertexSet a, VertexSet b) {
  Triangulation result{sphere.vertices, {}};
  result.tetrahedra.reserve(sphere.tetrahedra.size() + 3);
  const auto both = static_cast<unsigned>(a | b);
  for (const VertexSet tetrahedron : sphere.tetrahedra)
    if ((tetrahedron & a) != a) result.tetrahedra.push_back(tetrahedron);
  for (VertexSet rest = a; rest != 0; rest = without_least(rest))
    result.tetrahedra.push_back(static_cast<VertexSet>(both ^ bit_of(least_vertex(rest))));
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  return result;
}

/// FNV-1a.
struct Hash {
  std::size_t operator()(const Triangulation& triangulation) const noexcept {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const VertexSet tetrahedron : triangulation.tetrahedra)
      hash = (hash ^ tetrahedron) * 1099511628211ULL;
    return static_cast<std::size_t>(hash ^ hash >> 32U);
  }
};

/// Canonical forms, each once, in the order of arrival.
class Classes {
 public:
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] const Triangulation& operator[](std::size_t i) const { return *order_[i]; }
  [[nodiscard]] bool contains(const Triangulation& form) const { return set_.contains(form); }
  void insert(Triangulation&& form) {
    const auto [place, is_new] = set_.insert(std::move(form));
    if (is_new) order_.push_back(&*place);
  }

 private:
  std::unordered_set<Triangulation, Hash> set_;
  std::vector<const Triangulation*> order_;  // nodes of the set stay where they are
};

/// Enough for all threads to be busy, few enough for the forms of a block to need little memory.
constexpr std::size_t kBlock = 512;

/// Adds the canonical forms of neighbours(0), .., neighbours(count - 1) in this order. The set
/// is only read while the threads run.
template <class Neighbours>
void add_forms(Classes& classes, int threads, std::size_t count, const Neighbours& neighbours) {
  std::vector<std::vector<Triangulation>> fresh(count);
  parallel::parallel_for(threads, count, [&](std::size_t i) {
    for (const Triangulation& neighbour : neighbours(i)) {
      Triangulation form = canon::triangulation_form(neighbour).canonical;
      if (!classes.contains(form)) fresh[i].push_back(std::move(form));
    }
  });
  for (auto& list : fresh)
    for (Triangulation& form : list) classes.insert(std::move(form));
}

Triangulation boundary_of_simplex() {
  Triangulation result{kMinSphereVertices, {}};
  for (int v = kMinSphereVertices; v-- > 0;)
    result.tetrahedra.push_back(static_cast<VertexSet>(31U ^ bit_of(v)));
  return result;
}

void check_by_shellings(const Spheres& list, int threads) {
  parallel::parallel_for(threads, list.found.size(), [&](std::size_t i) {
    core::ensures(complex::search_shelling(list.found[i]).outcome == complex::ShellingSearch::found,
                  "a sphere on at most ten vertices has a shelling");
  });
}

}  // namespace

bool is_before(const Triangulation& a, const Triangulation& b) {
  const std::size_t size_a = a.tetrahedra.size();
  const std::size_t size_b = b.tetrahedra.size();
  return size_a != size_b ? size_a < size_b : a.tetrahedra < b.tetrahedra;
}

std::vector<Triangulation> flipped(const Triangulation& sphere) {
  core::expects(sphere.vertices <= kMaxSphereVertices, "at most kMaxSphereVertices vertices");
  const Links links(sphere);
  std::vector<Triangulation> result;
  for (const VertexSet a : links.faces(sphere.vertices)) {
    const VertexSet b = links.of(a);
    const int size =
        std::popcount(static_cast<unsigned>(a)) + std::popcount(static_cast<unsigned>(b));
    if (size == 5 && links.of(b) == 0) result.push_back(flip(sphere, a, b));
  }
  return result;
}

std::vector<Triangulation> subdivided(const Triangulation& sphere) {
  std::vector<Triangulation> result;
  for (const VertexSet tetrahedron : sphere.tetrahedra) {
    result.push_back(flip(sphere, tetrahedron, bit_of(sphere.vertices)));
    ++result.back().vertices;
  }
  return result;
}

Spheres next_spheres(const Spheres& list, const SphereOptions& options) {
  core::expects(list.vertices < kMaxSphereVertices, "at most kMaxSphereVertices vertices");
  Classes classes;
  for (std::size_t begin = 0; begin < list.found.size(); begin += kBlock)
    add_forms(classes, options.threads, std::min(kBlock, list.found.size() - begin),
              [&](std::size_t i) { return subdivided(list.found[begin + i]); });
  std::size_t done = 0;
  while (done < classes.size()) {
    const std::size_t count = std::min(kBlock, classes.size() - done);
    add_forms(classes, options.threads, count,
              [&](std::size_t i) { return flipped(classes[done + i]); });
    done += count;
    if (options.progress) options.progress(list.vertices + 1, classes.size(), done);
  }
  Spheres result{list.vertices + 1, {}};
  result.found.reserve(classes.size());
  for (std::size_t i = 0; i < classes.size(); ++i) result.found.push_back(classes[i]);
  std::sort(result.found.begin(), result.found.end(), is_before);
  check_by_shellings(result, options.threads);
  return result;
}

Spheres spheres(int vertices, const SphereOptions& options) {
  core::expects(vertices >= kMinSphereVertices && vertices <= kMaxSphereVertices,
                "kMinSphereVertices to kMaxSphereVertices vertices");
  Spheres list{kMinSphereVertices, {canon::triangulation_form(boundary_of_simplex()).canonical}};
  check_by_shellings(list, 1);
  while (list.vertices < vertices) list = next_spheres(list, options);
  return list;
}

PuncturedSphere punctured(const Triangulation& sphere, int vertex) {
  core::expects(vertex >= 0 && vertex < sphere.vertices, "a vertex of the sphere");
  unsigned link = 0;
  for (const VertexSet tetrahedron : sphere.tetrahedra)
    if ((tetrahedron & bit_of(vertex)) != 0) link |= tetrahedron;
  link ^= bit_of(vertex);
  PuncturedSphere result;
  result.boundary_vertices = std::popcount(link);
  result.ball.vertices = sphere.vertices - 1;
  int next_boundary = 0;
  int next_interior = result.boundary_vertices;
  for (int v = 0; v < sphere.vertices; ++v) {
    const bool is_boundary = (link & bit_of(v)) != 0;
    int& next = is_boundary ? next_boundary : next_interior;
    result.labels[static_cast<std::size_t>(v)] =
        static_cast<std::uint8_t>(v == vertex ? result.ball.vertices : next++);
  }
  for (const VertexSet tetrahedron : sphere.tetrahedra)
    if ((tetrahedron & bit_of(vertex)) == 0)
      result.ball.tetrahedra.push_back(complex::image_of(tetrahedron, result.labels));
  std::sort(result.ball.tetrahedra.begin(), result.ball.tetrahedra.end());
  return result;
}

std::vector<Ball> balls(const Spheres& list, int threads) {
  std::vector<std::vector<Ball>> found(list.found.size());
  parallel::parallel_for(threads, list.found.size(), [&](std::size_t i) {
    const Triangulation& sphere = list.found[i];
    const canon::TriangulationForm form = canon::triangulation_form(sphere);
    for (int v = 0; v < sphere.vertices; ++v) {
      if (form.orbit[static_cast<std::size_t>(v)] != v) continue;
      const PuncturedSphere rest = punctured(sphere, v);
      canon::TriangulationForm ball = canon::triangulation_form(rest.ball);
      found[i].push_back({std::move(ball.canonical), rest.boundary_vertices, ball.automorphisms});
    }
  });
  std::vector<Ball> result;
  for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(result));
  std::sort(result.begin(), result.end(), [](const Ball& a, const Ball& b) {
    return is_before(a.triangulation, b.triangulation);
  });
  return result;
}

}  // namespace hexatlas::balls
