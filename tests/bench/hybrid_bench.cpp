// Times of the search for combinations of tetrahedra, on a lattice and on random points, by
// threads; `hexahedra` are the candidates found per second, beside prisms and pyramids.
// Not a test: run by hand.
#include <benchmark/benchmark.h>

#include <random>
#include <variant>

#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/selection.hpp"
#include "tests/meshing/hybrid/kuhn.hpp"

namespace {

using namespace hexatlas;

hybrid::TetGraph graph_of(const mesh::TetMesh& mesh) {
  return std::get<hybrid::TetGraph>(hybrid::TetGraph::of({mesh.points, mesh.tetrahedra}));
}

void search(benchmark::State& state, const mesh::TetMesh& mesh) {
  const hybrid::TetGraph graph = graph_of(mesh);
  const auto threads = static_cast<int>(state.range(1));
  std::size_t found = 0;
  for (auto _ : state) {
    const hybrid::Candidates candidates = hybrid::candidates(graph, 0.1, threads);
    found += candidates.hexahedra.cells.size();
    benchmark::DoNotOptimize(candidates);
  }
  state.counters["hexahedra"] =
      benchmark::Counter(static_cast<double>(found), benchmark::Counter::kIsRate);
  state.counters["per_iteration"] =
      static_cast<double>(found) / static_cast<double>(state.iterations());
}

void search_lattice(benchmark::State& state) {
  search(state, hybrid_tests::kuhn(static_cast<unsigned>(state.range(0)), 1));
}
void search_random(benchmark::State& state) {
  std::mt19937_64 random(1);
  search(state, hybrid_tests::random_delaunay(static_cast<std::size_t>(state.range(0)), 1U << 30U,
                                              random));
}

void select_random(benchmark::State& state) {
  std::mt19937_64 random(1);
  const mesh::TetMesh mesh =
      hybrid_tests::random_delaunay(static_cast<std::size_t>(state.range(0)), 1U << 30U, random);
  const hybrid::TetGraph graph = graph_of(mesh);
  const hybrid::Candidates candidates = hybrid::candidates(graph, 0.1, 2);
  hybrid::SelectionOptions options;
  options.rounds = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(hybrid::selection(graph, candidates, options));
}

}  // namespace

BENCHMARK(search_lattice)
    ->Args({20, 1})
    ->Args({20, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(search_random)
    ->Args({5000, 1})
    ->Args({5000, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(select_random)->Args({5000, 0})->Args({5000, 2})->Unit(benchmark::kMillisecond);
