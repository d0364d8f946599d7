// Times of the operations whose cost the documents state. Not a test: run by hand.
#include <benchmark/benchmark.h>

#include <vector>

#include "enum/flips/beam.hpp"
#include "tables/format/table.hpp"
#include "tests/enum/support.hpp"
#include "tests/shipped.hpp"

namespace {

using namespace hexatlas;

constexpr int kQuads = 20;

flips::State single() { return flips::canonical_state(flips::single_hexahedron()).state; }

flips::BeamOptions narrow(int threads) {
  flips::BeamOptions options;
  options.max_quads = 22;
  options.fronts_per_class = 2;
  options.fronts_per_level = 20'000;
  options.threads = threads;
  return options;
}

const format::Table& table() {
  static const format::Table kTable = format::Table::open(support::kShippedTable);
  return kTable;
}

/// Those with 20 quads of the table, in random labels, in random order.
const std::vector<complex::Quadrangulation>& boundaries() {
  static const std::vector<complex::Quadrangulation> kList = [] {
    support::Random random(1);
    std::vector<complex::Quadrangulation> result;
    for (std::size_t i = 0; i < table().size(); ++i)
      if (const auto code = table().entry(i).code; code.quads == kQuads)
        result.push_back(support::scrambled(canon::decode(code).value(), random, random.coin()));
    random.shuffle(result);
    return result;
  }();
  return kList;
}

void canonical_form(benchmark::State& state) {
  const auto& list = boundaries();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(canon::canonical_form(list[i++ % list.size()]));
  state.counters["classes"] = static_cast<double>(list.size());
}
BENCHMARK(canonical_form);

void look_up(benchmark::State& state) {
  const auto& list = boundaries();
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(table().find(canon::canonical_form(list[i++ % list.size()]).code));
  state.counters["entries"] = static_cast<double>(table().size());
}
BENCHMARK(look_up);

void look_up_and_mesh(benchmark::State& state) {
  const auto& list = boundaries();
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        table().mesh(table().find(canon::canonical_form(list[i++ % list.size()]).code).value()));
}
BENCHMARK(look_up_and_mesh);

void beam_levels(benchmark::State& state) {
  std::uint64_t candidates = 0;
  for (auto _ : state) {
    flips::BeamOptions options = narrow(static_cast<int>(state.range(0)));
    options.fronts_per_class = 20;
    flips::Beam beam(single(), options);
    while (beam.level() < 16) beam.expand_level();
    candidates += beam.candidates();
  }
  state.counters["candidates"] =
      benchmark::Counter(static_cast<double>(candidates), benchmark::Counter::kIsRate);
}
BENCHMARK(beam_levels)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void validate(benchmark::State& state) {
  const auto side = static_cast<unsigned>(state.range(0));
  const auto mesh = support::mesh_of(oracle::grid(side, side, side));
  for (auto _ : state) benchmark::DoNotOptimize(complex::validate(mesh));
}
BENCHMARK(validate)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
