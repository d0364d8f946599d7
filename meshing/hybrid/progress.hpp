#pragma once
/// \file
/// How far a computation is that may take minutes.

#include <cstddef>
#include <functional>

namespace hexatlas::hybrid {

/// Called at times, by one thread at a time, with what is done and all that is to be done; not
/// called if it is empty. It has no say in the result.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

}  // namespace hexatlas::hybrid
