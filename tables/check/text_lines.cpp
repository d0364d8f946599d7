#include "tables/check/text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "tables/check/malformed.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

template <class Number>
bool parse(std::string_view text, Number& value) {
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const bool usual = digits == "0" ? text.size() == 1 : !digits.starts_with('0');
  return error == std::errc() && end == last && usual;
}

}  // namespace

void LineWords::fail(const std::string& reason) const { throw Malformed(*file_, number_, reason); }

std::string_view LineWords::word() {
  if (!open_) fail("the line ends too early");
  const std::size_t end = rest_.find(' ');
  const std::string_view found = rest_.substr(0, end);
  open_ = end != std::string_view::npos;
  rest_.remove_prefix(open_ ? end + 1 : rest_.size());
  if (found.empty()) fail("words must be separated by one space, without a space at the ends");
  if (!std::all_of(found.begin(), found.end(), [](char c) { return c > ' ' && c <= '~'; })) {
    fail("the word " + in_quotes(found) + " has a character that is no printable ASCII");
  }
  return found;
}

std::uint64_t LineWords::natural() {
  const std::string_view text = word();
  std::uint64_t value = 0;
  if (!parse(text, value)) fail("expected a natural number, found " + in_quotes(text));
  return value;
}

std::int64_t LineWords::integer() {
  const std::string_view text = word();
  std::int64_t value = 0;
  if (!parse(text, value)) fail("expected an integer, found " + in_quotes(text));
  return value;
}

void LineWords::expect(std::string_view wanted) {
  const std::string_view found = word();
  if (found != wanted) fail("expected '" + std::string(wanted) + "', found " + in_quotes(found));
}

void LineWords::expect_end() const {
  if (open_) fail("the line has more words than it should");
}

std::string_view TextLines::peek() const noexcept {
  return rest_.substr(0, rest_.find_first_of(" \n"));
}

LineWords TextLines::next() {
  const std::size_t end = rest_.find('\n');
  if (end == std::string_view::npos)
    throw Malformed(*file_, number_,
                    rest_.empty() ? "the file ends too early" : "the last line has no end");
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end + 1);
  return {*file_, number_++, line};
}

}  // namespace hexatlas::check
