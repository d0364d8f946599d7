#include <tetgen.h>

#include "experiments/2026-11-delaunay-peers/common.hpp"

int main(int count, char** words) {
  Run run(count, words);
  tetgenio in, out;
  in.numberofpoints = static_cast<int>(run.n);
  in.pointlist = new double[3 * run.n];
  std::copy(run.xyz.begin(), run.xyz.end(), in.pointlist);
  std::vector<double>().swap(run.xyz);
  tetgenbehavior options;
  char quiet[] = "QNEF";  // no output of nodes, elements, faces
  options.parse_commandline(quiet);
  run.begin();
  tetrahedralize(&options, &in, &out);
  run.end();
  run.report("tetgen", 0);
}
