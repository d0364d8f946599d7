// Times of the enumerations of triangulations and spheres. Not a test: run by hand.
#include <benchmark/benchmark.h>

#include "enum/balls/spheres.hpp"
#include "enum/balls/spheres_cells.hpp"
#include "enum/balls/triangulations.hpp"
#include "enum/complex/cell.hpp"

namespace {

using namespace hexatlas;

void triangulations(benchmark::State& state, const char* cell, int interior, int threads) {
  std::uint64_t nodes = 0;
  for (auto _ : state) {
    const balls::Census census = balls::triangulations(
        *complex::cell_named(cell),
        {.interior = interior, .keep_classes = interior == 0, .threads = threads});
    nodes = census.nodes;
    state.counters["classes"] = static_cast<double>(census.total().classes);
  }
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(triangulations, hexahedron, "hexahedron", 0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangulations, hexahedron_interior_1, "hexahedron", 1, 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(triangulations, hexahedron_interior_1_two_threads, "hexahedron", 1, 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void spheres(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(balls::spheres(static_cast<int>(state.range(0))));
}
BENCHMARK(spheres)->Arg(8)->Arg(9)->Unit(benchmark::kMillisecond);

void hexahedron_from_spheres(benchmark::State& state) {
  const balls::Spheres list = balls::spheres(9);
  for (auto _ : state)
    benchmark::DoNotOptimize(balls::triangulations_from(list, *complex::cell_named("hexahedron")));
}
BENCHMARK(hexahedron_from_spheres)->Unit(benchmark::kMillisecond);

}  // namespace
