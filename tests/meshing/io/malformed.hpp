#pragma once
/// \file
/// Hand-made defects of files, each with the line and the words of its refusal.

#include <gtest/gtest.h>

#include <stdexcept>

#include "enum/core/errors.hpp"
#include "tests/meshing/io/samples.hpp"

namespace hexatlas::io_tests {

inline const std::string kGarbage(
    "\x7f"
    "ELF\x02\x01\x00\x00\x9a\xff\n\x03\x00\xfe",
    14);

/// The text with its first `from` replaced; the defect must find its place.
inline std::string edit(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("nothing to edit: " + from);
  return text.replace(at, from.size(), to);
}

/// The text up to and including the first `last`.
inline std::string until(const std::string& text, const std::string& last) {
  return text.substr(0, text.find(last) + last.size());
}

struct Malformed {
  FileFormat format;
  std::string bytes;
  std::size_t line;  ///< 0: none in the message
  std::string reason;
};

inline void expect_refused(const Malformed& bad, const std::string& message) {
  const std::string start = bad.line == 0 ? "f: " : "f:" + std::to_string(bad.line) + ": ";
  EXPECT_EQ(message.substr(0, start.size()), start) << message;
  EXPECT_NE(message.find(bad.reason), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

template <class Parse>
void expect_all_refused(const std::vector<Malformed>& table, const Parse& parse) {
  for (const Malformed& bad : table) {
    try {
      static_cast<void>(parse(bad.bytes, bad.format, "f"));
      ADD_FAILURE() << "accepted; expected: " << bad.line << ": " << bad.reason;
    } catch (const core::InvalidInput& error) {
      expect_refused(bad, error.what());
    }
  }
}

inline void expect_surfaces_refused(const std::vector<Malformed>& table) {
  expect_all_refused(table, io::parse_surface);
}

}  // namespace hexatlas::io_tests
