#include "meshing/hybrid/candidates.hpp"

#include <algorithm>
#include <mutex>

#include "enum/core/checks.hpp"
#include "meshing/hybrid/around.hpp"
#include "meshing/hybrid/blocks.hpp"
#include "meshing/hybrid/corners.hpp"
#include "meshing/hybrid/hexahedron_search.hpp"
#include "meshing/hybrid/prism_search.hpp"

namespace hexatlas::hybrid {
namespace {

template <std::size_t N>
void append(CandidateList<N>& all, CandidateList<N>& more) {
  for (Candidate<N> cell : more.cells) {
    cell.first += all.tetrahedra.size();
    all.cells.push_back(cell);
  }
  all.tetrahedra.insert(all.tetrahedra.end(), more.tetrahedra.begin(), more.tetrahedra.end());
  more = {};
}

/// Adds up what several threads have done.
class Report {
 public:
  Report(const Progress& progress, std::size_t all) : progress_(progress), all_(all) {}

  void add(std::size_t done) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    done_ += done;
    progress_(done_, all_);
  }

 private:
  const Progress& progress_;
  std::size_t all_, done_ = 0;
  std::mutex mutex_;
};

}  // namespace

Candidates candidates(const TetGraph& graph, double quality, int threads,
                      const Progress& progress) {
  core::expects(quality >= 0 && quality < 1, "a quality in [0, 1)");
  // No scaled Jacobian is above the sine of an angle between its edges.
  constexpr double kRounding = 1e-9;
  const Corners corners(graph, std::max(0.0, quality - kRounding), threads);
  Report report(progress, graph.points().size());
  auto blocks = in_blocks<Candidates>(
      graph.points().size(), threads, [&](Index first, Index end, Candidates& found) {
        Around around(graph, corners);
        HexahedronSearch hexahedra(graph, corners, quality);
        PrismSearch prisms(graph, corners, quality);
        for (Index v = first; v < end; ++v) {
          around.visit(v);
          found.undecided += hexahedra.visit(around, found.hexahedra);
          prisms.visit(around, found.prisms);
        }
        report.add(end - first);
      });
  auto pyramid_blocks = in_blocks<CandidateList<5>>(
      graph.size(), threads, [&](TetIndex first, TetIndex end, CandidateList<5>& found) {
        PyramidSearch pyramids(graph, quality);
        for (TetIndex t = first; t < end; ++t) pyramids.visit(t, found);
      });
  Candidates all;
  for (auto& block : pyramid_blocks) append(all.pyramids, block);
  for (Candidates& block : blocks) {
    append(all.hexahedra, block.hexahedra);
    append(all.prisms, block.prisms);
    all.undecided += block.undecided;
  }
  return all;
}

}  // namespace hexatlas::hybrid
