#pragma once
/// \file
/// What writers write to: pieces of a file, collected into blocks. Numbers become text in the
/// shortest decimal form that reads back to the same bits (std::to_chars), whatever the locale.

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "enum/core/files.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

class Output {
 public:
  /// `sink` takes the blocks, in order, and must outlive the output.
  explicit Output(const core::Sink& sink) : sink_(sink) {}

  /// Each as text, one after the other: strings as they are, numbers (integers: not negative), a
  /// point as "x y z".
  template <class... Parts>
  void put(const Parts&... parts) {
    (put_one(parts), ...);
    if (block_.size() >= kBlockBytes) flush();
  }

  /// Each index plus `base`, separated by blanks.
  void put_indices(std::span<const mesh::Index> indices, unsigned base);

  /// The number in binary, little endian.
  template <class Number>
  void put_binary(Number number) {
    append_little(block_, number);
    if (block_.size() >= kBlockBytes) flush();
  }

  /// The objects as they lie in memory. Requires: arrays of numbers without padding.
  template <class Object>
  void put_memory(std::span<const Object> objects) {
    flush();
    sink_({reinterpret_cast<const char*>(objects.data()), objects.size_bytes()});
  }

  /// To be called after the last piece.
  void flush();

 private:
  static constexpr std::size_t kBlockBytes = std::size_t{1} << 20U;

  void put_one(std::string_view text) { block_ += text; }
  void put_one(const char* text) { block_ += text; }
  void put_one(double number);
  void put_one(std::uint64_t number);
  template <std::integral Number>
  requires(sizeof(Number) > 1)  // of a character it would be the number
      void put_one(Number number) {
    put_one(static_cast<std::uint64_t>(number));
  }
  void put_one(const mesh::Point& point);

  const core::Sink& sink_;
  std::string block_;
};

}  // namespace hexatlas::io
