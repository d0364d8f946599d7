// The exhaustive search for hexahedral meshes: nodes per second, on one thread and on two.
#include <benchmark/benchmark.h>

#include "enum/canon/code.hpp"
#include "enum/hexes/hexmeshes.hpp"

namespace {

using namespace hexatlas;

const auto kPyramid = "q1:02228a2a5777df7f";

void search(benchmark::State& state, int hexahedra, int interior, bool ball) {
  const auto boundary = canon::decode(canon::from_text(kPyramid).value()).value();
  const hexes::HexmeshProblem problem(boundary, {hexahedra, interior, ball, true});
  std::uint64_t nodes = 0;
  for (auto _ : state) {
    hexes::HexFrontier frontier = problem.begin();
    problem.go_on(frontier, {.threads = static_cast<int>(state.range(0))}, {});
    nodes += frontier.counts.nodes;
  }
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsRate);
}

/// Schneiders' pyramid with few hexahedra, and with few interior vertices.
void pyramid(benchmark::State& state, int hexahedra, bool ball) {
  search(state, hexahedra, hexes::most_interior_vertices(16, hexahedra), ball);
}
void pyramid_inside(benchmark::State& state, int interior) {
  search(state, hexes::kMaxHexahedra, interior, true);
}

void on_threads(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(pyramid, balls_18, 18, true)->Apply(on_threads);
BENCHMARK_CAPTURE(pyramid, any_16, 16, false)->Apply(on_threads);
BENCHMARK_CAPTURE(pyramid_inside, balls_13, 13)->Apply(on_threads);

}  // namespace
