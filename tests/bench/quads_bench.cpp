// Times of the generation of quadrangulations. Not a test: run by hand.
#include <benchmark/benchmark.h>

#include "enum/quads/generate.hpp"

namespace {

using namespace hexatlas;

void quadrangulations(benchmark::State& state, quads::Class which, int size) {
  std::uint64_t classes = 0;
  for (auto _ : state) classes = quads::generate(which, size).classes;
  state.counters["classes"] = static_cast<double>(classes);
  state.counters["classes/s"] = benchmark::Counter(static_cast<double>(classes),
                                                   benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(quadrangulations, three_connected_20, quads::Class::three_connected, 20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quadrangulations, three_connected_22, quads::Class::three_connected, 22)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quadrangulations, min_degree_3_20, quads::Class::min_degree_3, 20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quadrangulations, simple_14, quads::Class::simple, 14)
    ->Unit(benchmark::kMillisecond);

}  // namespace
