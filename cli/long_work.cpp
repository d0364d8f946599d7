#include "cli/long_work.hpp"

#include <fmt/format.h>

#include <exception>
#include <utility>

#include "cli/completeness.hpp"
#include "cli/interrupt.hpp"
#include "enum/core/errors.hpp"

namespace hexatlas::cli {

void PeriodicSave::if_due() {
  if (seconds() - last_ >= every_) try_now();
}

void PeriodicSave::try_now() {
  const auto failed = [this](const std::exception& error) {
    if (!std::exchange(has_failed_, true))
      say(fmt::format("note: this save failed, the work goes on: {}", error.what()));
  };
  try {
    save_();
    has_failed_ = false;
  } catch (const core::InvalidInput& error) {
    failed(error);
  } catch (const core::ResourceFailure& error) {
    failed(error);
  }
  last_ = seconds();
}

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
