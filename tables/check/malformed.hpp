#pragma once
/// \file
/// The one exception of the judge: a file that cannot be read as what it claims to be. Whatever
/// can be read is judged, and the judgement is a value.

#include <cstddef>
#include <stdexcept>
#include <string>

namespace hexatlas::check {

/// what() is "file:line: reason", or "file: reason" where no line applies (line 0).
struct Malformed : std::runtime_error {
  Malformed(const std::string& file, std::size_t line, const std::string& reason)
      : std::runtime_error(line == 0 ? file + ": " + reason
                                     : file + ":" + std::to_string(line) + ": " + reason) {}
};

}  // namespace hexatlas::check
