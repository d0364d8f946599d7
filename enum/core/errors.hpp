#pragma once
/// \file
/// The errors of hexatlas, one per party to blame. Expected refusals are values
/// (optional, a status enum), never exceptions; see docs/architecture/README.md.

#include <stdexcept>
#include <string>

namespace hexatlas::core {

/// The file or the user is wrong. what() is "file:line: reason", or "file: reason"
/// where no line applies (line 0). Exit code 3.
struct InvalidInput : std::runtime_error {
  InvalidInput(const std::string& file, std::size_t line, const std::string& reason)
      : std::runtime_error(line == 0 ? file + ": " + reason
                                     : file + ":" + std::to_string(line) + ": " + reason) {}
  InvalidInput(const std::string& file, const std::string& reason)
      : InvalidInput(file, 0, reason) {}
  /// A line that has this form already.
  [[nodiscard]] static InvalidInput as_told(const std::string& line) { return InvalidInput(line); }

 private:
  explicit InvalidInput(const std::string& line) : std::runtime_error(line) {}
};

/// The machine is at its limit: disk full, write error, no memory. Exit code 5.
struct ResourceFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The calling code is wrong: it broke a stated "Requires". Exit code 70.
struct PreconditionViolated : std::logic_error {
  using std::logic_error::logic_error;
};

/// We are wrong: a law that we claim to have proved does not hold. Exit code 70.
struct InternalError : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace hexatlas::core
