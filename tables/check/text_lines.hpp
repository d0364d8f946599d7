#pragma once
/// \file
/// Internal to the judge: text of which each byte is prescribed. Lines end in one '\n', words are
/// separated by one space and consist of the characters '!' to '~', numbers have no plus sign and
/// no leading zero. So a text that is read has one way to be written.
///
/// Errors: Malformed with file and line. The texts and the name must outlive what refers to them.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hexatlas::check {

/// The words of one line.
class LineWords {
 public:
  LineWords(const std::string& file, std::size_t number, std::string_view line)
      : file_(&file), number_(number), rest_(line) {}

  [[nodiscard]] std::size_t number() const noexcept { return number_; }
  [[nodiscard]] bool at_end() const noexcept { return !open_; }
  [[nodiscard]] std::string_view word();
  [[nodiscard]] std::uint64_t natural();
  [[nodiscard]] std::int64_t integer();
  void expect(std::string_view wanted);
  void expect_end() const;
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  const std::string* file_;
  std::size_t number_;
  std::string_view rest_;
  bool open_ = true;  ///< a word must follow
};

class TextLines {
 public:
  /// `first`: the number of the first line.
  TextLines(const std::string& file, std::string_view text, std::size_t first = 1)
      : file_(&file), rest_(text), number_(first) {}

  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }
  [[nodiscard]] std::size_t number() const noexcept { return number_; }  ///< of the next line
  /// What is left, from the next line on.
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }
  /// The first word of the next line, up to a space; empty at the end.
  [[nodiscard]] std::string_view peek() const noexcept;
  [[nodiscard]] LineWords next();

 private:
  const std::string* file_;
  std::string_view rest_;
  std::size_t number_;
};

}  // namespace hexatlas::check
