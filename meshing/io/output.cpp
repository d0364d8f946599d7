#include "meshing/io/output.hpp"

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

void Output::put_one(double number) { append_number(block_, number); }
void Output::put_one(std::uint64_t number) { append_number(block_, number); }

void Output::put_one(const mesh::Point& point) {
  put_one(point.x);
  block_ += ' ';
  put_one(point.y);
  block_ += ' ';
  put_one(point.z);
}

void Output::put_indices(std::span<const mesh::Index> indices, unsigned base) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (i > 0) block_ += ' ';
    put_one(std::uint64_t{indices[i]} + base);
  }
}

void Output::flush() {
  if (!block_.empty()) sink_(block_);
  block_.clear();
}

}  // namespace hexatlas::io
