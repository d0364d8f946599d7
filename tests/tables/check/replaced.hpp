#pragma once
/// \file
/// Texts with a change, for the tests of the judge's readers.

#include <gtest/gtest.h>

#include <string>

namespace hexatlas::check::examples {

/// The text with its first `old`, which it must have, replaced.
inline std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), fresh);
}

}  // namespace hexatlas::check::examples
