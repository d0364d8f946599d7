#pragma once
/// \file
/// Private to meshing/hybrid: work on each vertex by several threads, with a result that does not
/// depend on their number.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "enum/parallel/parallel_for.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

/// one Result for each block, in their order; work(first, end, result) is
/// called once for each block. There are at most 256 blocks or so, so that work may begin with
/// memory for all vertices.
template <class Result, class Work>
std::vector<Result> in_blocks(std::size_t vertices, int threads, const Work& work) {
  const std::size_t block = std::max<std::size_t>(512, vertices / 256);
  std::vector<Result> results((vertices + block - 1) / block);
  parallel::parallel_for(threads, results.size(), [&](std::size_t i) {
    work(static_cast<mesh::Index>(i * block),
         static_cast<mesh::Index>(std::min(vertices, (i + 1) * block)), results[i]);
  });
  return results;
}

}  // namespace hexatlas::hybrid
