#pragma once
/// \file
/// Words and numbers of a text file, with their lines. White space is space, tab, vertical tab,
/// form feed, carriage return and line feed; a line ends at its line feed.
///
/// Numbers follow std::from_chars: decimal point whatever the locale, correct rounding, one
/// leading "+" allowed. Views returned point into the bytes given, which must outlive them.
///
/// Errors: InvalidInput at the line of the word.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

[[nodiscard]] std::string_view without_byte_order_mark(std::string_view bytes);

/// The word in quotes for a message: at most 40 bytes, each printable.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// Whether the word is a number, finite or not.
[[nodiscard]] bool is_number(std::string_view word);

class Scanner {
 public:
  /// `comment`: the character that starts a comment reaching to the end of its line; 0 for none.
  Scanner(std::string_view bytes, std::string file, char comment = '\0',
          std::size_t first_line = 1);

  /// The words of the next line that has any; false at the end.
  [[nodiscard]] bool next_line(std::vector<std::string_view>& words);

  /// True if no word is left.
  [[nodiscard]] bool at_end();

  /// The next word. `expected` says what it should be, for the message if there is none.
  [[nodiscard]] std::string_view word(const char* expected);

  /// The next word, as a finite number, an integer, or an index that the file counts from `base`
  /// (the answer counts from 0; its upper bound is checked by MeshBuilder).
  [[nodiscard]] double real(const char* expected) { return to_real(word(expected)); }
  [[nodiscard]] std::int64_t integer(const char* expected) { return to_integer(word(expected)); }
  [[nodiscard]] mesh::Index index(int base) { return to_index(integer("an index"), base); }

  /// The next word, as a number of objects that occupy at least `bytes_each` bytes of what follows.
  [[nodiscard]] std::size_t count(const char* expected, std::size_t bytes_each);

  [[nodiscard]] double to_real(std::string_view word) const;
  [[nodiscard]] std::int64_t to_integer(std::string_view word) const;
  [[nodiscard]] std::size_t to_count(std::int64_t value, std::size_t bytes_each) const;
  [[nodiscard]] mesh::Index to_index(std::int64_t value, int base) const;

  /// What is left of the current line, without its end; moves to the next line.
  [[nodiscard]] std::string_view rest_of_line();

  /// The next `size` bytes as they are. Lines are not counted in them.
  [[nodiscard]] std::string_view raw(std::size_t size);

  /// Moves to the next occurrence of `mark`; fails if there is none.
  void move_to(std::string_view mark);

  /// Refuses a NUL byte anywhere in the file, at its line.
  void refuse_nul() const;

  [[nodiscard]] std::size_t bytes_left() const { return bytes_.size() - position_; }
  [[nodiscard]] std::size_t line() const { return word_line_; }  ///< of the last word
  [[nodiscard]] const std::string& file() const { return file_; }

  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail_cut(const char* expected);  ///< the file ends too early

 private:
  void skip_space();
  [[nodiscard]] std::string_view take_word();

  std::string_view bytes_;
  std::string file_;
  std::size_t position_ = 0;
  std::size_t line_;       ///< of position_
  std::size_t word_line_;  ///< of the last word
  char comment_;
};

}  // namespace hexatlas::io
