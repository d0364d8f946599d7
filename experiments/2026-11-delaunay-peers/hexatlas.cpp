#include "experiments/2026-11-delaunay-peers/common.hpp"
#include "meshing/delaunay/triangulation.hpp"

int main(int count, char** words) {
  Run run(count, words);
  std::vector<hexatlas::mesh::Point> points;
  points.reserve(run.n);
  for (std::size_t i = 0; i < run.n; ++i)
    points.push_back({run.xyz[3 * i], run.xyz[3 * i + 1], run.xyz[3 * i + 2]});
  std::vector<double>().swap(run.xyz);
  run.begin();
  const hexatlas::delaunay::Triangulation t(points, {.threads = run.threads});
  run.end();
  run.report("hexatlas", t.size());
}
