#pragma once
/// \file
/// Work that may take long, with a line of progress while it lasts.

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "cli/output.hpp"
#include "enum/balls/spheres.hpp"
#include "tables/build/realize.hpp"
#include "tables/format/catalogue.hpp"

namespace hexatlas::cli {

/// Saves work that takes long now and then. That it cannot be written is said once, and it is tried
/// again when it is due: the work is unharmed, and whether it can be kept shows at its end.
class PeriodicSave {
 public:
  PeriodicSave(double every, std::function<void()> save)
      : every_(every), save_(std::move(save)), last_(seconds()) {}

  void if_due();
  /// At the end of work that does not need it.
  void try_now();

 private:
  double every_;  ///< seconds
  std::function<void()> save_;
  double last_;
  bool has_failed_ = false;
};

/// balls::spheres(). It cannot be stopped early.
[[nodiscard]] balls::Spheres spheres_with(int vertices, int threads);

/// build::realize(), stopped by stop_requested(); `stop` and `progress` of the options are set
/// here. The line begins with `words`.
void realize_classes(format::Catalogue& catalogue, build::RealizeOptions options,
                     const std::string& words);

/// completeness_certificate(). It cannot be stopped early.
[[nodiscard]] std::optional<std::string> prove_completeness(const format::Catalogue& catalogue);

}  // namespace hexatlas::cli
