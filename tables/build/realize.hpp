#pragma once
/// \file
/// Answers for the classes of a catalogue: which can be realized, and by what evidence.

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

#include "enum/complex/cell.hpp"
#include "realize/certificate/certificate.hpp"
#include "realize/solve/decide.hpp"
#include "tables/format/catalogue.hpp"

namespace hexatlas::build {

struct RealizeOptions {
  certificate::Condition condition = certificate::Condition::embedded;
  solve::Effort effort{};
  int threads = 1;  ///< the answers do not depend on it
  /// Set to true elsewhere to stop early: the classes not yet decided are open. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called by one thread at a time; may be empty.
  std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// Answers the condition for each class that has no answer or an open one. Requires a catalogue
/// whose classes are triangulations; for Condition::jacobian is_hexahedron(catalogue).
void realize(format::Catalogue& catalogue, const RealizeOptions& options);

/// Whether it is of the hexahedron, in the numbering of the cube, without interior vertex.
[[nodiscard]] bool is_hexahedron(const format::Catalogue& catalogue);

struct AnswerCounts {
  std::size_t realizable = 0, refuted = 0, open = 0;
};
[[nodiscard]] AnswerCounts count_answers(const format::Catalogue& catalogue,
                                         certificate::Condition condition);

/// +1 or -1 per tetrahedron, its vertices ascending, as docs/formats/catalogue.md fixes the
/// orientation: by the facets of the cell, or, for a ball, +1 for the first tetrahedron.
[[nodiscard]] std::vector<int> signs_of(const format::Catalogue& catalogue,
                                        const complex::Triangulation& triangulation);

}  // namespace hexatlas::build
