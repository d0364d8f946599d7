#pragma once
/// \file
/// Private to meshing/delaunay: a list cut into as many parts as there are threads.

#include <cstddef>

#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::delaunay {

/// body(part, begin, end) for each part of [0, count), a thread for each. Requires threads >= 1.
template <class Body>
void for_each_part(int threads, std::size_t count, Body&& body) {
  const auto parts = static_cast<std::size_t>(threads);
  parallel::parallel_for(threads, parts, [&](std::size_t part) {
    body(part, part * count / parts, (part + 1) * count / parts);
  });
}

}  // namespace hexatlas::delaunay
