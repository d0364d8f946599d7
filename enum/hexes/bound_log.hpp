#pragma once
/// \file
/// The log of an exhaustive search that finds nothing: the heart of a certificate of a lower bound.
/// Its form and rules: docs/formats/bound.md.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "enum/complex/quadrangulation.hpp"
#include "enum/hexes/search.hpp"

namespace hexatlas::hexes {

struct BoundLog {
  std::string bytes;
  std::uint64_t records = 0;
  bool is_complete = false;       ///< not stopped
  bool has_found_a_mesh = false;  ///< so there is no such bound; the log is not complete
};

struct BoundLogOptions {
  int threads = 1;
  /// Set to true by another thread or a signal handler to stop early; may be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called by one thread at a time with the parts done and all parts; may be empty.
  std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// The log of the search within the limits, the same for any number of threads. Requires what
/// HexSearch does. Cost: that of the search, and some bytes for each hexahedron put.
[[nodiscard]] BoundLog bound_log(const complex::Quadrangulation& boundary,
                                 const SearchLimits& limits, const BoundLogOptions& options);

}  // namespace hexatlas::hexes
