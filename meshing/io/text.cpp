#include "meshing/io/text.hpp"

#include <array>
#include <charconv>

namespace hexatlas::io {
namespace {

template <class Number>
void append_number(std::string& text, Number number) {
  std::array<char, 32> buffer{};  // the longest double has 24 characters, the longest integer 20
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  text.append(buffer.data(), result.ptr);
}

}  // namespace

void append(std::string& text, double number) { append_number(text, number); }
void append(std::string& text, std::uint64_t number) { append_number(text, number); }

void append(std::string& text, const mesh::Point& point) {
  append(text, point.x);
  text += ' ';
  append(text, point.y);
  text += ' ';
  append(text, point.z);
}

void append(std::string& text, std::span<const mesh::Index> indices, unsigned base) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (i > 0) text += ' ';
    append(text, std::uint64_t{indices[i]} + base);
  }
}

}  // namespace hexatlas::io
