#include "tables/check/scanner.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "tables/check/malformed.hpp"

namespace hexatlas::check {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// from_chars knows no plus sign; files use one.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
  return plus ? text.substr(1) : text;
}

template <typename Number>
bool parse(std::string_view text, Number& value) {
  text = without_plus(text);
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last;
}

}  // namespace

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  for (const char c : word.substr(0, kLongest)) result += (c >= ' ' && c <= '~') ? c : '?';
  return result + (word.size() > kLongest ? "...'" : "'");
}

Scanner::Scanner(const std::string& file, std::string_view text, char comment, std::size_t line)
    : file_(file), text_(text), comment_(comment), line_(line), word_line_(line) {
  if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
}

void Scanner::fail(const std::string& reason) const { throw Malformed(file_, word_line_, reason); }

void Scanner::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\n') {
      ++line_;
    } else if (comment_ != '\0' && text_[at_] == comment_) {
      while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
    } else if (!is_space(text_[at_])) {
      return;
    }
  }
}

bool Scanner::at_end() {
  skip_space();
  word_line_ = line_;
  return at_ == text_.size();
}

std::string_view Scanner::peek() {
  if (at_end()) return {};
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view Scanner::word() {
  const std::string_view next = peek();
  if (next.empty()) fail("the file ends too early");
  at_ += next.size();
  return next;
}

std::string_view Scanner::skip_line() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  std::string_view rest = text_.substr(begin, at_ - begin);
  word_line_ = line_;
  if (at_ < text_.size()) {
    ++at_;
    ++line_;
  }
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

std::string_view Scanner::bytes(std::uint64_t count) {
  if (count > text_.size() - at_) fail("the file ends too early");
  const std::string_view found = text_.substr(at_, count);
  at_ += count;
  return found;
}

void Scanner::skip_paragraph() {
  while (!skip_line().empty()) continue;
}

std::vector<std::string_view> Scanner::line_of_words() {
  std::vector<std::string_view> words;
  if (at_end()) return words;
  const std::size_t line = line_;
  while (!at_end() && line_ == line) words.push_back(word());
  word_line_ = line;
  return words;
}

void Scanner::expect(std::string_view wanted) {
  const std::string_view found = word();
  if (found != wanted) fail("expected '" + std::string(wanted) + "', found " + in_quotes(found));
}

double Scanner::real_from(std::string_view text) const {
  double value = 0;
  if (!parse(text, value)) fail("expected a number, found " + in_quotes(text));
  if (!std::isfinite(value)) fail("the number " + in_quotes(text) + " is not finite");
  return value;
}

std::uint64_t Scanner::natural_from(std::string_view text) const {
  std::uint64_t value = 0;
  if (!parse(text, value)) fail("expected a natural number, found " + in_quotes(text));
  return value;
}

std::int64_t Scanner::integer_from(std::string_view text) const {
  std::int64_t value = 0;
  if (!parse(text, value)) fail("expected an integer, found " + in_quotes(text));
  return value;
}

double Scanner::real() { return real_from(word()); }
std::uint64_t Scanner::natural() { return natural_from(word()); }
std::int64_t Scanner::integer() { return integer_from(word()); }

std::array<double, 3> Scanner::point() {
  const double x = real();
  const double y = real();
  const double z = real();
  return {x, y, z};
}

std::uint32_t Scanner::index(std::uint64_t first, std::uint64_t count) {
  const std::uint64_t value = natural();
  if (value < first || value - first >= count) {
    fail("point " + std::to_string(value) + " is not among the " + std::to_string(count) +
         " points");
  }
  return static_cast<std::uint32_t>(value - first);
}

std::uint64_t Scanner::count(std::uint64_t bytes) {
  const std::uint64_t value = natural();
  if (value > (text_.size() - at_) / bytes || value >= std::numeric_limits<std::int32_t>::max()) {
    fail("the count " + std::to_string(value) + " is more than the rest of the file can hold");
  }
  return value;
}

}  // namespace hexatlas::check
