#include "cli/long_work.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/completeness.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"

namespace hexatlas::cli {

balls::Spheres spheres_with(int vertices, int threads) {
  ProgressLine progress;
  return balls::spheres(
      vertices, {threads, [&progress](int n, std::size_t found, std::size_t flipped) {
                   progress.update(fmt::format("spheres with {} vertices", n), flipped, found);
                 }});
}

void realize_classes(format::Catalogue& catalogue, build::RealizeOptions options,
                     const std::string& words) {
  ProgressLine progress;
  options.stop = &stop_requested();
  options.progress = [&](std::size_t done, std::size_t all) { progress.update(words, done, all); };
  build::realize(catalogue, options);
}

std::optional<std::string> prove_completeness(const format::Catalogue& catalogue) {
  ProgressLine progress;
  std::size_t steps = 0;
  return completeness_certificate(
      catalogue, [&](const std::string& step) { progress.update(step, ++steps, 0); });
}

}  // namespace hexatlas::cli
