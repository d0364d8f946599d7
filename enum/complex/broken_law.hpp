#pragma once
/// \file
/// What validate() answers: nothing, or the name of the broken law with the place.

#include <cstddef>
#include <optional>
#include <string>

namespace hexatlas::complex {

/// The first law found broken. `reason` is a sentence without a full stop that names the
/// vertices; `cell` is the index of a quad or hexahedron at fault, if there is one.
struct BrokenLaw {
  std::string reason;
  std::optional<std::size_t> cell{};
};

}  // namespace hexatlas::complex
