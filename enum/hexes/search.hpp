#pragma once
/// \file
/// Exhaustive search for hexahedral meshes with a given boundary.
///
/// Backtracking: of the facets on which a hexahedron is still due, the one with the fewest
/// candidates gets it, one top vertex after the other; new vertices are numbered as they appear, so
/// no mesh comes twice. The prunings (bounds.hpp) lose nothing within the limits and have a switch
/// each; docs/theory/proofs/hexahedral-search.md.
///
/// Source. The bounds of 17 hexahedra and 18 interior vertices for Schneiders' pyramid: Verhetsel,
/// Pellerin, Remacle, "A 44-element mesh of Schneiders' pyramid" (IMR 2018), by a search on lists
/// of vertices. State, prunings and order of this one are of this project.
///
/// Claim. The complete states are exactly the complexes of at most max_hexahedra hexahedra and
/// max_interior interior vertices, each component of which (by facets) has a facet on the boundary,
/// that obey the strict rule and whose facets in one hexahedron are the quads of the boundary.
/// Each is met once, with its interior vertices numbered by first appearance. They need not be
/// balls. With `ball` all balls are met, and others perhaps; with `up_to_symmetry` one of the
/// images of each.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/hexes/bounds.hpp"
#include "enum/hexes/partial_mesh.hpp"
#include "enum/hexes/path_symmetry.hpp"

namespace hexatlas::hexes {

/// Which prunings are on.
struct Prunings {
  bool face_budget = true;    ///< exceeds_face_budget()
  bool links = true;          ///< closes_badly()
  bool corner_budget = true;  ///< new_vertices_within()
  bool ears = true;           ///< its ears
  bool candidates = true;     ///< Tightest::is_refuted
  bool cover = true;          ///< facets_apart()
  bool partners = true;       ///< partners_of(); for balls only
  bool balance = true;        ///< PartialMesh::balance(); for balls only
  bool barred_tops = true;    ///< those of PathSymmetry; no log has it
};

/// Why no mesh within the limits follows from a state (docs/formats/bound.md).
struct Refutation {
  enum class Rule : std::uint8_t {
    face_budget = 1,  ///< exceeds_face_budget()
    corner_budget,    ///< new_vertices_within()
    link,             ///< closes_badly()
    symmetry,         ///< PathSymmetry
    facets_apart,     ///< facets_apart()
    partners,         ///< partners_of()
    no_candidate      ///< tightest()
  };
  Rule rule = Rule::face_budget;
  /// Among the open facets of the state, by ascending number: of facets_apart; the facet of
  /// no_candidate.
  std::vector<std::size_t> places{};
};

struct SearchLimits {
  int max_hexahedra = 0;  ///< at most kMaxHexahedra
  int max_interior = 0;   ///< vertices; with those of the boundary at most kMaxMeshVertices
  bool ball = false;      ///< nothing but balls is asked for
  /// Of the images of a mesh under the automorphisms of the boundary one is asked for, not all:
  /// see path_symmetry.hpp.
  bool up_to_symmetry = false;
};

/// No mesh of so many hexahedra has more interior vertices: 2 H + 1 - n / 2.
[[nodiscard]] int most_interior_vertices(int boundary_quads, int hexahedra) noexcept;

/// A backtracking problem in the sense of enum/search. Cost of a node: tens of nanoseconds, of one
/// that completes a hexahedron microseconds.
class HexSearch {
 public:
  /// The next top vertex.
  struct Choice {
    Vertex top = 0;
    friend bool operator==(Choice, Choice) = default;
  };

  /// Ascending.
  class Choices {
   public:
    struct End {};
    class Iterator {
     public:
      explicit Iterator(VertexSet left) : left_(left) {}
      Choice operator*() const { return {static_cast<Vertex>(std::countr_zero(left_))}; }
      Iterator& operator++() {
        left_ &= left_ - 1;
        return *this;
      }
      friend bool operator==(const Iterator& at, End) { return at.left_ == 0; }

     private:
      VertexSet left_;
    };
    explicit Choices(VertexSet tops) : tops_(tops) {}
    [[nodiscard]] Iterator begin() const { return Iterator(tops_); }
    [[nodiscard]] End end() const { return {}; }

   private:
    VertexSet tops_;
  };

  /// Requires a 3-connected boundary and limits within their ranges.
  HexSearch(const complex::Quadrangulation& boundary, const SearchLimits& limits,
            Prunings prunings = {});

  [[nodiscard]] bool is_complete() const noexcept { return mesh_.open_count() == 0; }
  [[nodiscard]] Choices choices() const noexcept;
  [[nodiscard]] bool apply(Choice choice);
  void undo() noexcept;

  [[nodiscard]] const PartialMesh& mesh() const noexcept { return mesh_; }
  /// Why the last apply() was refused, or the initial state has no choices.
  [[nodiscard]] const Refutation& refutation() const noexcept { return refutation_; }
  /// Of a complete state of a search up to symmetry: how many automorphisms of the boundary the
  /// mesh has too.
  [[nodiscard]] int automorphisms() const noexcept { return paths_->automorphisms(); }
  /// The quad on which the search begins, or -1 if the limits refute at once.
  [[nodiscard]] int first_quad() const noexcept { return levels_.front().bottom; }

 private:
  struct Level {
    int bottom = -1;           ///< of the hexahedron begun after this one
    NewVertices new_vertices;  ///< that it may bring
    VertexSet saturated = 0;
  };

  [[nodiscard]] bool open_level();
  void go_back() noexcept;
  [[nodiscard]] bool is_refuted_by_last();
  [[nodiscard]] bool is_refuted_by_partners(Level& level);
  [[nodiscard]] bool is_refuted_by_budgets(int left, Level& level);
  [[nodiscard]] bool is_refuted_by_corners(int left, bool ears, Level& level);
  [[nodiscard]] bool is_refuted_by_facets_apart(int left);
  bool refute(Refutation::Rule rule) {
    refutation_.rule = rule;
    return true;
  }

  SearchLimits limits_;
  Prunings prunings_;
  PartialMesh mesh_;
  std::optional<PathSymmetry> paths_;
  std::vector<Level> levels_;
  OpenFacets open_;
  Refutation refutation_;
};

/// The complex of a complete state, boundary vertices first. Each hexahedron is right-handed if the
/// facet that it was put on is counter-clockwise from outside; so all are, if the boundary's quads
/// are and the complex can be oriented.
[[nodiscard]] complex::HexComplex complex_of(const PartialMesh& mesh);

}  // namespace hexatlas::hexes
