#pragma once
/// \file
/// The words in which exact arithmetic answers. Decisions take a Sign, never a double.

#include <cstdint>

namespace hexatlas::exact {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr Sign opposite(Sign sign) noexcept {
  return static_cast<Sign>(-static_cast<int>(sign));
}

/// A point whose coordinates are the real numbers that the doubles stand for.
struct Point3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace hexatlas::exact
