#pragma once
// What all programs of this experiment share: points, clocks, memory, one line of output.
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

class Random {  // SplitMix64
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double number() {  // in [0, 1)
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15ULL;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ z >> 27) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// x y z after x y z.
inline std::vector<double> points_of(const std::string& kind, std::size_t n) {
  Random random(1);
  std::vector<double> xyz;
  xyz.reserve(3 * n);
  const auto add = [&](double x, double y, double z) { xyz.insert(xyz.end(), {x, y, z}); };
  const auto side = static_cast<std::size_t>(std::llround(std::cbrt(static_cast<double>(n))));
  for (std::size_t i = 0; i < n; ++i) {
    const double a = random.number(), b = random.number(), c = random.number();
    if (kind == "uniform") add(a, b, c);
    else if (kind == "clusters") add(static_cast<double>(i % 20) + 1e-6 * a, static_cast<double>(i * 7 % 20) + 1e-6 * b, 1e-6 * c);
    else if (kind == "sphere") {
      const double z = 2 * a - 1, r = std::sqrt(1 - z * z), t = 6.283185307179586 * b;
      add(r * std::cos(t), r * std::sin(t), z);
    } else if (kind == "paraboloid") add(a, b, a * a + b * b);
    else if (kind == "duplicates" && i % 10 == 9) { const std::size_t j = i / 2; add(xyz[3 * j], xyz[3 * j + 1], xyz[3 * j + 2]); }
    else if (kind == "duplicates") add(a, b, c);
    else if (kind == "grid") add(static_cast<double>(i % side), static_cast<double>(i / side % side), static_cast<double>(i / side / side));
    else std::exit(2);
  }
  return xyz;
}

inline double wall() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline double processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
inline double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

struct Run {
  std::string kind;
  std::size_t n;
  int threads;
  std::vector<double> xyz;
  double wall_start = 0, processor_start = 0;

  Run(int count, char** words)
      : kind(count > 1 ? words[1] : "uniform"),
        n(count > 2 ? std::strtoul(words[2], nullptr, 10) : 100000),
        threads(count > 3 ? std::atoi(words[3]) : 1),
        xyz(points_of(kind, n)) {}
  void begin() { wall_start = wall(), processor_start = processor(); }
  /// To be called when the triangulation is there; then report() with the number of tetrahedra.
  double wall_seconds = 0, processor_seconds = 0, bytes = 0;
  void end() {
    wall_seconds = wall() - wall_start, processor_seconds = processor() - processor_start;
    bytes = peak_bytes();
  }
  void report(const char* program, std::size_t tetrahedra) const {
    std::printf("%s\t%s\t%zu\t%d\t%zu\t%.3f\t%.3f\t%.1f\n", program, kind.c_str(), n, threads,
                tetrahedra, wall_seconds, processor_seconds,
                tetrahedra == 0 ? 0.0 : bytes / static_cast<double>(tetrahedra));
  }
};
