// Times of in-sphere and orientation signs, one call on average, and of the verdicts on hexahedra.
// Not a test: run by hand.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "realize/exact/in_sphere.hpp"
#include "realize/exact/jacobian.hpp"
#include "realize/exact/orientation.hpp"

namespace {

using namespace hexatlas;
using exact::Point3;

using Tuple = std::array<Point3, 5>;

enum class Points { generic, integer_grid, decimal_grid, cube_of_grid, sphere, wide };

Point3 random_point(Points kind, std::mt19937_64& random) {
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -53); };
  const auto step = [&] { return static_cast<double>(random() % 100); };
  const auto wide = [&] {
    return std::ldexp(unit() - 0.5, static_cast<int>(random() % 300) - 150);
  };
  switch (kind) {
    case Points::generic:
      return {unit(), unit(), unit()};
    case Points::integer_grid:
      return {step(), step(), step()};
    case Points::decimal_grid:
      return {0.01 * step(), 0.01 * step(), 0.01 * step()};
    case Points::wide:
      return {wide(), wide(), wide()};
    default:
      break;
  }
  while (true) {
    const Point3 p{unit() * 2 - 1, unit() * 2 - 1, unit() * 2 - 1};
    const double length = std::hypot(p.x, p.y, p.z);
    if (length > 0.1 && length < 1) return {p.x / length, p.y / length, p.z / length};
  }
}

/// Five different vertices of a cube of side 1: a tie.
Tuple corners(double unit, std::mt19937_64& random) {
  Tuple result;
  const std::array<std::uint64_t, 3> origin{random() % 99, random() % 99, random() % 99};
  const std::uint64_t mask = random();
  const std::uint64_t first = random() % 8;
  for (std::uint64_t i = 0; i < 5; ++i) {
    const std::uint64_t corner = (first + i * (mask % 4 * 2 + 1)) % 8;
    const auto at = [&](std::size_t k) {
      return unit * static_cast<double>(origin[k] + (corner >> k & 1U));
    };
    result[i] = {at(0), at(1), at(2)};
  }
  return result;
}

std::vector<Tuple> tuples(Points kind, bool ties) {
  std::mt19937_64 random(20261122);
  std::vector<Tuple> result(4096);
  for (Tuple& tuple : result) {
    if (ties) {
      tuple = corners(kind == Points::integer_grid ? 1 : 0.01, random);
    } else {
      for (Point3& p : tuple) p = random_point(kind, random);
    }
  }
  return result;
}

template <class Predicate>
void time(benchmark::State& state, const std::vector<Tuple>& input, const Predicate& predicate) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(predicate(input[i]));
    i = (i + 1) % input.size();
  }
}

void in_sphere(benchmark::State& state, Points kind, bool ties) {
  time(state, tuples(kind, ties),
       [](const Tuple& p) { return exact::sign_of_in_sphere(p[0], p[1], p[2], p[3], p[4]); });
}
void perturbed(benchmark::State& state, Points kind, bool ties) {
  time(state, tuples(kind, ties), [](const Tuple& p) {
    return exact::sign_of_perturbed_in_sphere(p[0], p[1], p[2], p[3], p[4]);
  });
}
void orientation(benchmark::State& state, Points kind, bool ties) {
  time(state, tuples(kind, ties),
       [](const Tuple& p) { return exact::sign_of_orientation(p[0], p[1], p[2], p[3]); });
}

/// Unit cubes with corners moved by up to 0.2: all valid, as those of a mesh are.
std::vector<exact::Hexahedron> moved_cubes() {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  std::vector<exact::Hexahedron> result(4096);
  for (exact::Hexahedron& h : result)
    for (std::size_t v = 0; v < 8; ++v) {
      const auto at = [&](std::size_t k) {
        return static_cast<double>(v >> k & 1U) + move(random);
      };
      h[v] = {at(0), at(1), at(2)};
    }
  return result;
}

void jacobian_single(benchmark::State& state) {
  const std::vector<exact::Hexahedron> input = moved_cubes();
  for (auto _ : state)
    for (const auto& h : input) benchmark::DoNotOptimize(exact::filtered_jacobian_verdict(h));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(input.size()));
}
BENCHMARK(jacobian_single);

void jacobian_batch(benchmark::State& state) {
  const std::vector<exact::Hexahedron> input = moved_cubes();
  std::vector<std::optional<exact::JacobianVerdict>> verdicts(input.size());
  for (auto _ : state) {
    exact::filtered_jacobian_verdicts(input, verdicts);
    benchmark::DoNotOptimize(verdicts.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(input.size()));
}
BENCHMARK(jacobian_batch);
BENCHMARK_CAPTURE(in_sphere, generic, Points::generic, false);
BENCHMARK_CAPTURE(in_sphere, integer_grid, Points::integer_grid, false);
BENCHMARK_CAPTURE(in_sphere, integer_tie, Points::integer_grid, true);
BENCHMARK_CAPTURE(in_sphere, decimal_tie, Points::decimal_grid, true);
BENCHMARK_CAPTURE(in_sphere, sphere, Points::sphere, false);
BENCHMARK_CAPTURE(in_sphere, wide_exponents, Points::wide, false);
BENCHMARK_CAPTURE(perturbed, generic, Points::generic, false);
BENCHMARK_CAPTURE(perturbed, integer_tie, Points::integer_grid, true);
BENCHMARK_CAPTURE(perturbed, decimal_tie, Points::decimal_grid, true);
BENCHMARK_CAPTURE(perturbed, sphere, Points::sphere, false);
BENCHMARK_CAPTURE(orientation, generic, Points::generic, false);
BENCHMARK_CAPTURE(orientation, integer_tie, Points::integer_grid, true);
BENCHMARK_CAPTURE(orientation, decimal_tie, Points::decimal_grid, true);
BENCHMARK_CAPTURE(orientation, wide_exponents, Points::wide, false);

}  // namespace
