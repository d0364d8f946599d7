#pragma once
/// \file
/// All triangulations of a cell with a given number of interior vertices, up to the symmetry of the
/// cell. Definition of triangulation, equivalence, class size:
/// docs/theory/triangulation-definition.txt.
///
/// Method. One boundary triangulation of each orbit under the symmetries of the cell is filled by
/// FrontSearch in all ways; a filling is kept if it is the least of its images under the
/// stabilizer of that boundary triangulation. So nothing is stored to find duplicates, and every
/// class is met once. A kept filling that is not a ball is dropped.
///
/// Law, tested in every exhaustive run: the fillings met, weighted by the size of their orbit of
/// boundaries, are as many as the sizes of the classes add up to (InternalError otherwise).

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "enum/balls/front_search.hpp"
#include "enum/complex/cell.hpp"
#include "enum/complex/triangulation.hpp"

namespace hexatlas::balls {

struct CensusOptions {
  int interior = 0;                  ///< at most kMaxInterior
  bool boundary_tetrahedra = false;  ///< drop condition 3
  bool keep_classes = true;          ///< false: counts only, in constant memory
  int threads = 1;                   ///< the result does not depend on it
  /// Nodes, at most this many in all; the result then may be a lower bound, the same for any
  /// number of threads.
  std::uint64_t max_nodes = std::numeric_limits<std::uint64_t>::max();
  Prunings prunings{};
  /// Set to true by another thread or a signal handler to stop early; may be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called by one thread at a time with the parts done and all parts; may be empty.
  std::function<void(std::size_t done, std::size_t all)> progress{};
};

inline constexpr int kMaxInterior = 6;

struct TriangulationClass {
  complex::Triangulation canonical;  ///< the least member, see docs/formats/catalogue.md
  std::uint64_t automorphisms = 1;
};

struct ClassCounts {
  std::uint64_t classes = 0;
  std::uint64_t labelled = 0;  ///< sum of the class sizes
  ClassCounts& operator+=(const ClassCounts& other) {
    classes += other.classes;
    labelled += other.labelled;
    return *this;
  }
  friend bool operator==(const ClassCounts&, const ClassCounts&) = default;
};

struct Census {
  std::map<std::size_t, ClassCounts> by_tetrahedra;
  std::vector<TriangulationClass> classes;  ///< by tetrahedra, then canonical form
  std::uint64_t nodes = 0;                  ///< the counting signature of the search
  std::uint64_t not_balls = 0;              ///< classes with good vertex links that are no balls
  std::uint64_t undecided = 0;              ///< classes for which this is not known: not counted
  std::uint64_t symmetries = 1;             ///< order of the group of the cell
  bool exhaustive = false;  ///< the search ended and nothing is undecided: a proof, else a bound

  [[nodiscard]] ClassCounts total() const;
};

/// Requires a cell of cell_of() or cell_named(), 0 <= interior <= kMaxInterior, and at most
/// complex::kMaxTriangulationVertices vertices in all.
[[nodiscard]] Census triangulations(const complex::Cell& cell, const CensusOptions& options);

}  // namespace hexatlas::balls
