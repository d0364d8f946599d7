// The exhaustive search for hexahedral meshes: nodes per second, on one thread and on two.
#include <benchmark/benchmark.h>

#include "enum/canon/code.hpp"
#include "enum/hexes/hexmeshes.hpp"

namespace {

using namespace hexatlas;

/// Schneiders' pyramid.
void pyramid(benchmark::State& state, int hexahedra, bool ball) {
  const auto boundary = canon::decode(canon::from_text("q1:02228a2a5777df7f").value()).value();
  const hexes::HexmeshProblem problem(
      boundary,
      {hexahedra, hexes::most_interior_vertices(boundary.quads(), hexahedra), ball, true});
  std::uint64_t nodes = 0;
  for (auto _ : state) {
    hexes::HexFrontier frontier = problem.begin();
    problem.go_on(frontier, {.threads = static_cast<int>(state.range(0))}, {});
    nodes += frontier.counts.nodes;
  }
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(pyramid, balls_17, 17, true)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pyramid, any_15, 15, false)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
