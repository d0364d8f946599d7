#pragma once
/// \file
/// Checks in tiers. `expects` is cheap and always on; `check_law` runs after each
/// mutation in checked and sanitizer builds (HEXATLAS_CHECKED), at no cost elsewhere.

#include "enum/core/errors.hpp"

namespace hexatlas::core {

#ifdef HEXATLAS_CHECKED
inline constexpr bool kChecked = true;
#else
inline constexpr bool kChecked = false;
#endif

/// A stated precondition. Throws PreconditionViolated.
constexpr void expects(bool condition, const char* requirement) {
  if (!condition) throw PreconditionViolated(requirement);
}

/// A law of our own. `holds()` is evaluated in checked builds only. Throws InternalError.
template <class Predicate>
constexpr void check_law(Predicate&& holds, const char* law) {
  if constexpr (kChecked)
    if (!holds()) throw InternalError(law);
}

/// A law of our own whose test costs next to nothing: always on. Throws InternalError.
constexpr void ensures(bool condition, const char* law) {
  if (!condition) throw InternalError(law);
}

}  // namespace hexatlas::core
