#pragma once
/// \file
/// How many of its cases a test goes through. A sanitizer takes ten times as long and looks at what
/// the code does, not at how often it is right: there it is an eighth of them, but at least as many
/// as the test asks for. Some tests are in two programs, one of which runs in release only and goes
/// further.

#include <algorithm>

namespace hexatlas::support {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

[[nodiscard]] constexpr int share_of(int cases, int least = 0) {
  return kSanitized ? std::max(cases / 8, least) : cases;
}
/// Of cases that are listed, not drawn: each one, or each eighth.
inline constexpr int kStride = kSanitized ? 8 : 1;

[[nodiscard]] constexpr int by_length(int cases, int in_a_long_test) {
  return HEXATLAS_LONG != 0 ? in_a_long_test : cases;
}

}  // namespace hexatlas::support
