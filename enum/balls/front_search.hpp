#pragma once
/// \file
/// The search for all triangulations of a ball with a given boundary of triangles: backtracking
/// over tetrahedra on the open triangle with the fewest possible apexes.
///
/// State. The front: the oriented triangles on which a tetrahedron is still due, at first the
/// boundary. A tetrahedron a b c d on the front triangle a b c replaces it by a b d, b c d, c a d,
/// and a triangle that meets its own opposite is closed. The front is a cycle at any time.
///
/// Prunings, each without loss (docs/theory/proofs/front-search.md):
///  - sides: no triangle gets a third tetrahedron, or two on the same side;
///  - edge links: around an edge the tetrahedra, with the outside, form one circle; a circle that
///    closes while others are open refutes, and a closed edge takes no further triangle;
///  - vertex links: the link of a vertex without front triangles, coned outside, is a sphere;
///  - open triangles: a front triangle without an apex refutes.
///
/// Source. The idea of choosing the most constrained triangle: Pellerin, Verhetsel, Remacle, "There
/// are 174 subdivisions of the hexahedron into tetrahedra" (2018); the data structure is ours.
///
/// Claim. The complete states are exactly the sets of tetrahedra that satisfy conditions 2, 3 and 4
/// of docs/theory/triangulation-definition.txt, are connected and orientable, and in which the link
/// of each vertex is a sphere or a disc; each set is met once, with its interior vertices numbered
/// by first appearance. Condition 5 is for the caller: complex::topology_of.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/complex/cell.hpp"
#include "enum/complex/triangulation.hpp"

namespace hexatlas::balls {

/// Which prunings are on. All may be switched off but `sides`, which is the definition itself.
struct Prunings {
  bool edge_links = true;
  bool vertex_links = true;
  bool open_triangles = true;
};

/// A backtracking problem in the sense of enum/search. Cost of a node: O(front) words.
class FrontSearch {
 public:
  /// The tetrahedron a b c d on the front triangle a b c.
  struct Choice {
    std::uint8_t a, b, c, d;
    friend bool operator==(const Choice&, const Choice&) = default;
  };

  /// The apexes of one front triangle, ascending.
  class Choices {
   public:
    struct End {};
    class Iterator {
     public:
      Iterator(Choice base, unsigned apexes) : base_(base), apexes_(apexes) {}
      Choice operator*() const {
        return {base_.a, base_.b, base_.c, static_cast<std::uint8_t>(std::countr_zero(apexes_))};
      }
      Iterator& operator++() {
        apexes_ &= apexes_ - 1U;
        return *this;
      }
      friend bool operator==(const Iterator& at, End) { return at.apexes_ == 0; }

     private:
      Choice base_;
      unsigned apexes_;
    };
    Choices(Choice base, unsigned apexes) : base_(base), apexes_(apexes) {}
    [[nodiscard]] Iterator begin() const { return {base_, apexes_}; }
    [[nodiscard]] End end() const { return {}; }

   private:
    Choice base_;
    unsigned apexes_;
  };

  /// `boundary`: a simplicial sphere on the vertices 0 .. boundary_vertices-1, counter-clockwise
  /// from outside. `forbidden`: sets of four vertices that are no tetrahedron. Requires
  /// boundary_vertices + interior <= kMaxTriangulationVertices.
  FrontSearch(std::span<const complex::OrientedTriangle> boundary, int boundary_vertices,
              int interior, std::span<const complex::VertexSet> forbidden, Prunings prunings = {});
  FrontSearch(const FrontSearch&) = delete;  // what undo() restores is known by address
  FrontSearch& operator=(const FrontSearch&) = delete;
  ~FrontSearch() = default;

  [[nodiscard]] bool is_complete() const noexcept;
  [[nodiscard]] Choices choices() const noexcept;
  [[nodiscard]] bool apply(Choice choice);
  void undo() noexcept;

  /// In the order of the choices.
  [[nodiscard]] std::span<const complex::VertexSet> tetrahedra() const noexcept {
    return tetrahedra_;
  }

 private:
  static constexpr std::size_t kVertices = complex::kMaxTriangulationVertices;
  using Mask = std::uint16_t;
  using Grid = std::array<std::array<Mask, kVertices>, kVertices>;
  struct Arc;

  void set(Mask& word, Mask value);
  void open(std::size_t a, std::size_t b, std::size_t c);
  void close(std::size_t a, std::size_t b, std::size_t c);
  void add_face(std::size_t a, std::size_t b, std::size_t c);
  void bar(std::size_t a, std::size_t b, std::size_t c);
  void bar_edge(std::size_t a, std::size_t b);
  [[nodiscard]] bool closes_one_of_many(const Arc& arc) const noexcept;
  void add_arc(const Arc& arc);
  [[nodiscard]] bool finish_vertex(std::size_t v);
  [[nodiscard]] bool link_is_sphere(std::size_t v) const noexcept;
  [[nodiscard]] unsigned apexes_of(std::size_t a, std::size_t b, std::size_t c) const noexcept;

  struct Saved {
    Mask* word;
    Mask value;
  };

  std::size_t vertices_, boundary_vertices_;
  Prunings prunings_;
  /// All at [a][b], as sets of c; a triangle a b c with its orientation stands at ab, bc and ca.
  Grid front_{};    ///< a b c is in the front
  Grid allowed_{};  ///< the face a b c may be added: it is unused, or its opposite is in the front
  Grid used_{};     ///< the triangle, in either orientation, has been added
  /// mate_[a][b][c]: the tetrahedra around the edge ab, and the outside, that end at the front
  /// triangle a b c form a path; it ends at the front triangle b a m. The value is m.
  std::array<Grid, kVertices> mate_{};
  std::array<Mask, kVertices> front_at_{};   ///< number of front triangles at a vertex
  std::array<Mask, kVertices> facets_at_{};  ///< tetrahedra, and boundary triangles, at a vertex
  /// forbidden_[a][b][c]: apexes ruled out by `forbidden`.
  std::array<Grid, kVertices> forbidden_{};
  Mask apexes_ = 0;  ///< vertices that may still be an apex
  Mask unused_ = 0;  ///< interior vertices that have not appeared
  Mask open_ = 0;    ///< number of front triangles
  std::vector<Saved> trail_;
  std::vector<std::size_t> marks_;
  std::vector<complex::VertexSet> tetrahedra_;
};

}  // namespace hexatlas::balls
