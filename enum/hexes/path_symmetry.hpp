#pragma once
/// \file
/// Which of the images of a mesh under the automorphisms of its boundary a search is to find: the
/// one whose path comes first.
///
/// The *path* of a mesh is the list of the top vertices in the order in which a search puts them,
/// new ones with the next number. The search goes on by what it has chosen alone, so each mesh has
/// one path, and its image under an automorphism of the boundary has another one. It is followed as
/// far as the hexahedra that are there tell: a state is refuted as soon as some image has a lesser
/// path, as another mesh is found instead of each that follows
/// (docs/theory/proofs/hexahedral-search.md, section 7).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "enum/hexes/partial_mesh.hpp"

namespace hexatlas::hexes {

/// Image of each vertex of the boundary.
using BoundaryMap = std::array<Vertex, complex::kMaxVertices>;

/// All automorphisms, mirror symmetries included; the identity is among them. Requires a
/// 3-connected quadrangulation.
[[nodiscard]] std::vector<BoundaryMap> automorphisms_of(const complex::Quadrangulation& boundary);

/// The images of the mesh of a search.
class PathSymmetry {
 public:
  /// `bars_tops`: see follow(). Requires a 3-connected quadrangulation.
  PathSymmetry(const complex::Quadrangulation& boundary, bool bars_tops);

  /// Follows the images after one more hexahedron. False if one has a lesser path. Otherwise may
  /// bar tops from the facets on which images wait, where they would have one. Cost: some tens of
  /// nanoseconds per automorphism.
  [[nodiscard]] bool follow(PartialMesh& mesh);
  /// Back to the state that there was with so many hexahedra. Requires that those after them have
  /// not been taken off the mesh, or were never followed.
  void go_back(PartialMesh& mesh, std::size_t hexahedra) noexcept;

  /// Of a complete mesh: the automorphisms of the boundary that it has too.
  [[nodiscard]] int automorphisms() const noexcept;

 private:
  static constexpr Vertex kUnknown = 0xFF;
  /// What changes with each hexahedron.
  struct Progress {
    std::uint64_t matched = 0;   ///< hexahedra on the path of the image so far
    std::uint8_t length = 0;     ///< hexahedra, those of the mesh itself with the same tops
    std::uint8_t labels = 0;     ///< vertices met on it
    bool is_greater = false;     ///< at the next one
    std::int16_t waits_on = -1;  ///< the facet of the mesh on which that is due
    friend bool operator==(const Progress&, const Progress&) = default;
  };
  /// The image under one automorphism.
  struct Image {
    Progress at;
    std::array<Vertex, kMaxMeshVertices> label{};   ///< of the vertices of the mesh
    std::array<Vertex, kMaxMeshVertices> vertex{};  ///< with each label
  };
  struct Change {
    std::size_t hexahedra = 0;  ///< that there were before
    std::size_t image = 0;
    Progress before;
  };
  struct Barred {
    std::size_t hexahedra = 0;
    int facet = 0;
    std::size_t corner = 0;
    VertexSet before = 0;
  };
  enum class Order : std::uint8_t { equal, lesser, greater, unknown };

  [[nodiscard]] static Order step(Image& image, const PartialMesh& mesh);
  void bar(const Image& image, PartialMesh& mesh);

  bool bars_tops_;
  std::vector<Image> images_;  ///< the identity is not among them
  std::vector<Change> changes_;
  std::vector<Barred> barred_;
};

}  // namespace hexatlas::hexes
