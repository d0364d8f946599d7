#include "meshing/io/scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include "enum/core/errors.hpp"

namespace hexatlas::io {
namespace {

/// Of a line: a view costs far more memory than a short word.
constexpr std::size_t kMostWords = std::size_t{1} << 20U;

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// from_chars takes no leading "+", which the file formats allow.
std::string_view without_plus(std::string_view word) {
  const bool is_signed = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return is_signed ? word.substr(1) : word;
}

template <class Number>
std::errc convert(std::string_view word, Number& value) {
  const std::string_view digits = without_plus(word);
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (error != std::errc{}) return error;
  return end == last ? std::errc{} : std::errc::invalid_argument;
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view bytes) {
  return bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

bool is_number(std::string_view word) {
  double value = 0;
  return convert(word, value) == std::errc{};
}

Scanner::Scanner(std::string_view bytes, std::string file, char comment, std::size_t first_line)
    : bytes_(bytes),
      file_(std::move(file)),
      line_(first_line),
      word_line_(first_line),
      comment_(comment) {}

void Scanner::skip_space() {
  while (position_ < bytes_.size()) {
    const char c = bytes_[position_];
    if (c == '\n') {
      ++line_;
    } else if (comment_ != '\0' && c == comment_) {
      position_ = std::min(bytes_.find('\n', position_), bytes_.size());
      continue;
    } else if (!is_blank(c)) {
      return;
    }
    ++position_;
  }
}

std::string_view Scanner::take_word() {
  const std::size_t first = position_;
  while (position_ < bytes_.size()) {
    const char c = bytes_[position_];
    if (c == '\n' || is_blank(c) || (comment_ != '\0' && c == comment_)) break;
    ++position_;
  }
  return bytes_.substr(first, position_ - first);
}

bool Scanner::next_line(std::vector<std::string_view>& words) {
  words.clear();
  if (at_end()) return false;
  word_line_ = line_;
  while (position_ < bytes_.size() && line_ == word_line_) {
    if (words.size() == kMostWords)
      fail("line of more than " + std::to_string(kMostWords) + " words");
    words.push_back(take_word());
    skip_space();
  }
  return true;
}

bool Scanner::at_end() {
  skip_space();
  return position_ == bytes_.size();
}

std::string_view Scanner::word(const char* expected) {
  if (at_end()) fail_cut(expected);
  word_line_ = line_;
  return take_word();
}

std::size_t Scanner::count(const char* expected, std::size_t bytes_each) {
  return to_count(integer(expected), bytes_each);
}

double Scanner::to_real(std::string_view word) const {
  double value = 0;
  const std::errc error = convert(word, value);
  if (error == std::errc::result_out_of_range)
    fail(in_quotes(word) + " is outside the range of double precision");
  if (error != std::errc{}) fail(in_quotes(word) + " is not a number");
  if (!std::isfinite(value)) fail(in_quotes(word) + " is not a finite number");
  return value;
}

std::int64_t Scanner::to_integer(std::string_view word) const {
  std::int64_t value = 0;
  const std::errc error = convert(word, value);
  if (error == std::errc::result_out_of_range) fail("integer " + in_quotes(word) + " is too large");
  if (error != std::errc{}) fail(in_quotes(word) + " is not an integer");
  return value;
}

std::size_t Scanner::to_count(std::int64_t value, std::size_t bytes_each) const {
  if (value < 0) fail("count " + std::to_string(value) + " is negative");
  // The last object may lack the separator after it.
  if (static_cast<std::uint64_t>(value) > (bytes_left() + 1) / bytes_each)
    fail("count " + std::to_string(value) + " is too large: only " + std::to_string(bytes_left()) +
         " bytes follow");
  return static_cast<std::size_t>(value);
}

mesh::Index Scanner::to_index(std::int64_t value, int base) const {
  if (value < base)
    fail("index " + std::to_string(value) + " is below " + std::to_string(base) +
         ", the first index");
  if (value - base >= std::numeric_limits<mesh::Index>::max())
    fail("index " + std::to_string(value) + " is too large");
  return static_cast<mesh::Index>(value - base);
}

std::string_view Scanner::rest_of_line() {
  const std::size_t end = std::min(bytes_.find('\n', position_), bytes_.size());
  std::string_view rest = bytes_.substr(position_, end - position_);
  word_line_ = line_;
  position_ = std::min(end + 1, bytes_.size());
  if (end < bytes_.size()) ++line_;
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  return rest;
}

std::string_view Scanner::raw(std::size_t size) {
  if (size > bytes_left()) fail_cut("binary data");
  const std::string_view data = bytes_.substr(position_, size);
  position_ += size;
  return data;
}

void Scanner::move_to(std::string_view mark) {
  const std::size_t found = bytes_.find(mark, position_);
  if (found == std::string_view::npos) fail("no " + in_quotes(mark) + " follows");
  const auto skipped = bytes_.substr(position_, found - position_);
  line_ += static_cast<std::size_t>(std::count(skipped.begin(), skipped.end(), '\n'));
  position_ = found;
}

void Scanner::refuse_nul() const {
  const std::size_t nul = bytes_.find('\0');
  if (nul == std::string_view::npos) return;
  const auto before = bytes_.substr(0, nul);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  throw core::InvalidInput(file_, static_cast<std::size_t>(line),
                           "NUL byte; a text file is expected");
}

void Scanner::fail(const std::string& reason) const {
  throw core::InvalidInput(file_, word_line_, reason);
}

void Scanner::fail_cut(const char* expected) {
  position_ = bytes_.size();
  // A final line feed ends the last line and starts no other.
  word_line_ = !bytes_.empty() && bytes_.back() == '\n' && line_ > 1 ? line_ - 1 : line_;
  fail(std::string("the file ends where ") + expected + " is expected");
}

}  // namespace hexatlas::io
