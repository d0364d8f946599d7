#pragma once
/// \file
/// Points that satisfy as many slacks as possible, by descent. Private to realize/solve.
///
/// Method. Coordinates are sines of free variables, so that the points stay in the cube [-1,1]^3,
/// which also fixes the affine scale in each direction. `satisfy` lessens the sum of squares of
/// max(0, margin - slack) for falling margins; `widen` raises a smooth lower bound of the least
/// slack, -log(sum exp(-sharpness slack)) / sharpness, for rising sharpness. Both by the
/// limited-memory method of Broyden, Fletcher, Goldfarb, Shanno with a backtracking line search;
/// source: D. Liu, J. Nocedal, "On the limited memory BFGS method for large scale optimization",
/// Math. Programming 45 (1989).

#include <random>
#include <vector>

#include "realize/solve/coordinates_slack.hpp"

namespace hexatlas::solve {

/// Uniform in [0, 1), the same on all machines.
[[nodiscard]] double uniform(std::mt19937_64& random);

class CoordinateDescent {
 public:
  CoordinateDescent(CoordinateSlacks& slacks, int vertices, int steps);

  /// Points in [-1,1]^3, x y z of vertex 0, 1, ...
  [[nodiscard]] std::vector<double> points() const;
  void start_anywhere(std::mt19937_64& random);

  /// True if all slacks are positive in the end.
  bool satisfy();
  void widen();
  [[nodiscard]] double least_slack();

 private:
  template <class Weigh>
  void descend(const Weigh& weigh);

  CoordinateSlacks& slacks_;
  std::vector<double> angles_;
  int steps_;
};

}  // namespace hexatlas::solve
