// Sequential, or with PARALLEL the lock grid of CGAL over TBB.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "experiments/2026-11-delaunay-peers/common.hpp"
#ifdef PARALLEL
#include <tbb/global_control.h>
#endif

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
#ifdef PARALLEL
using Structure =
    CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                         CGAL::Delaunay_triangulation_cell_base_3<Kernel>,
                                         CGAL::Parallel_tag>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
#else
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;
#endif

int main(int count, char** words) {
  Run run(count, words);
  std::vector<Kernel::Point_3> points;
  for (std::size_t i = 0; i < run.n; ++i)
    points.emplace_back(run.xyz[3 * i], run.xyz[3 * i + 1], run.xyz[3 * i + 2]);
  std::vector<double>().swap(run.xyz);
#ifdef PARALLEL
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, run.threads);
  CGAL::Bbox_3 box;
  for (const auto& p : points) box += p.bbox();
  run.begin();
  Delaunay::Lock_data_structure locks(box, 50);
  const Delaunay t(points.begin(), points.end(), &locks);
  run.end();
  run.report("cgal-parallel", t.number_of_finite_cells());
#else
  run.begin();
  const Delaunay t(points.begin(), points.end());
  run.end();
  run.report("cgal", t.number_of_finite_cells());
#endif
}
