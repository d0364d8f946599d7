#pragma once
/// \file
/// Internal to the judge: a strict scanner of text, word by word, that knows its line.
/// A byte order mark at the start and carriage returns are white space. All numbers are read
/// without regard to the locale. Errors: Malformed with the line of the last word.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexatlas::check {

class Scanner {
 public:
  /// `comment`: from this character to the end of the line is white space; '\0' for none.
  /// `line`: the number of the first line. Both texts must outlive the scanner.
  Scanner(const std::string& file, std::string_view text, char comment = '\0',
          std::size_t line = 1);

  [[nodiscard]] bool at_end();
  [[nodiscard]] std::string_view peek();  ///< the next word, empty at the end
  [[nodiscard]] std::string_view word();
  /// The rest of the current line, without its end.
  std::string_view skip_line();
  /// So many bytes as they are, after what was read; their ends of lines do not count.
  [[nodiscard]] std::string_view bytes(std::uint64_t count);
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - at_; }
  /// Lines up to and with the next empty one.
  void skip_paragraph();
  /// The words of the next line that has any; empty only at the end.
  [[nodiscard]] std::vector<std::string_view> line_of_words();

  void expect(std::string_view wanted);
  [[nodiscard]] double real();
  [[nodiscard]] std::uint64_t natural();
  [[nodiscard]] std::int64_t integer();
  [[nodiscard]] std::array<double, 3> point();
  /// A number in first .. first + count - 1, returned less `first`.
  [[nodiscard]] std::uint32_t index(std::uint64_t first, std::uint64_t count);
  /// A number of items, each of which takes at least `bytes` bytes of what is left.
  [[nodiscard]] std::uint64_t count(std::uint64_t bytes);

  [[nodiscard]] double real_from(std::string_view text) const;
  [[nodiscard]] std::uint64_t natural_from(std::string_view text) const;
  [[nodiscard]] std::int64_t integer_from(std::string_view text) const;
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void skip_space();

  const std::string& file_;
  std::string_view text_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t line_;       ///< line of at_
  std::size_t word_line_;  ///< line of the last word
};

/// A word as it may be quoted in a message: shortened, without control characters.
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace hexatlas::check
