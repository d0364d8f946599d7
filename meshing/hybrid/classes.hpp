#pragma once
/// \file
/// Which of the classes of subdivisions of the hexahedron a candidate is.
///
/// Definition. The fillings without interior vertices of a hexahedron are triangulations of it; up
/// to the symmetries of the cube, mirror images included, there are 174 (J. Pellerin, K. Verhetsel,
/// J.-F. Remacle, "There are 174 subdivisions of the hexahedron into tetrahedra", ACM TOG 37
/// (2018)), of which 171 can be realized. Flat tetrahedra on its quads do not count.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

class HexahedronClasses {
 public:
  /// One triangulation of each class, on the vertices of enum/cells/cube.hpp. Requires at most
  /// kMostInside tetrahedra in each.
  explicit HexahedronClasses(std::span<const complex::Triangulation> classes);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// The place of the candidate's class in the list given; nothing if there are interior vertices
  /// or it is none of them.
  [[nodiscard]] std::optional<std::size_t> class_of(const TetGraph& graph,
                                                    const CandidateList<8>& hexahedra,
                                                    std::size_t candidate) const;

  /// How many there are of each class, and at last of none.
  [[nodiscard]] std::vector<std::size_t> counts(const TetGraph& graph,
                                                const CandidateList<8>& hexahedra) const;

 private:
  /// The sets of vertices of the tetrahedra, ascending, then zeros.
  using Key = std::array<std::uint8_t, 16>;
  struct Hash {
    std::size_t operator()(const Key& key) const noexcept;
  };

  std::size_t size_;
  std::unordered_map<Key, std::size_t, Hash> class_of_;
};

}  // namespace hexatlas::hybrid
