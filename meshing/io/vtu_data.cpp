#include "meshing/io/vtu_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint64_t kBlockBytes = std::uint64_t{1} << 15U;

constexpr std::array<int, 256> make_digit_values() {
  std::array<int, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<int>(i);
  return values;
}

constexpr auto kDigitValues = make_digit_values();

constexpr bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Bytes taken from the front, decoded from base64 if need be.
class ByteStream {
 public:
  ByteStream(std::string_view data, bool is_base64, const Place& place)
      : data_(data), is_base64_(is_base64), place_(place) {}

  /// The next bytes. In base64 a text ends with the group of 4 characters that holds the last
  /// of them, and the next one starts behind it.
  [[nodiscard]] std::string take(std::uint64_t size) {
    check_available(size);
    if (!is_base64_) {
      const std::string_view bytes = data_.substr(position_, size);
      position_ += size;
      return std::string(bytes);
    }
    std::string bytes;
    bytes.reserve(size + 2);
    while (bytes.size() < size) {
      if (bytes.size() % 3 != 0) place_.fail("base64 text ends before its array");
      append_group(bytes);
    }
    bytes.resize(size);
    return bytes;
  }

  void check_available(std::uint64_t size) const {
    const std::uint64_t left = data_.size() - position_;
    if (size > (is_base64_ ? left / 4 * 3 + 3 : left))
      place_.fail("array of " + std::to_string(size) + " bytes is cut");
  }

  void rewind() { position_ = 0; }
  [[nodiscard]] std::uint64_t left() const { return data_.size() - position_; }
  [[nodiscard]] bool was_padded() const { return position_ > 0 && data_[position_ - 1] == '='; }

 private:
  [[nodiscard]] char next_character() {
    while (position_ < data_.size() && is_space(data_[position_])) ++position_;
    if (position_ == data_.size()) place_.fail("base64 text is cut");
    return data_[position_++];
  }

  void append_group(std::string& bytes) {
    std::uint32_t value = 0;
    int padding = 0;
    for (int i = 0; i < 4; ++i) {
      const char c = next_character();
      const int digit = kDigitValues[static_cast<unsigned char>(c)];
      if (c == '=' && i >= 2) {
        ++padding;
      } else if (digit < 0 || padding > 0) {
        place_.fail(in_quotes(std::string_view(&c, 1)) + " in base64 text");
      }
      value = value << 6U | static_cast<std::uint32_t>(std::max(digit, 0));
    }
    for (int i = 0; i < 3 - padding; ++i)
      bytes.push_back(static_cast<char>(value >> (16U - 8U * static_cast<unsigned>(i)) & 0xFFU));
  }

  std::string_view data_;
  bool is_base64_;
  const Place& place_;
  std::size_t position_ = 0;
};

[[nodiscard]] std::uint64_t load_header(std::string_view header, std::size_t index,
                                        std::size_t width) {
  const std::string_view bytes = header.substr(index * width, width);
  return width == 4 ? load_little<std::uint32_t>(bytes) : load_little<std::uint64_t>(bytes);
}

[[nodiscard]] std::string decode_plain(ByteStream& stream, const VtuEncoding& encoding) {
  const std::string header = stream.take(encoding.header_bytes);
  const std::uint64_t size = load_header(header, 0, encoding.header_bytes);
  // Some writers end the base64 text of the header with padding and start another.
  if (!encoding.is_base64 || stream.was_padded()) return stream.take(size);
  stream.check_available(size);
  stream.rewind();
  return stream.take(encoding.header_bytes + size).substr(encoding.header_bytes);
}

struct BlockSizes {
  std::uint64_t block, last;
  std::vector<std::uint64_t> compressed;

  [[nodiscard]] std::uint64_t size_of(std::size_t i) const {
    return i + 1 == compressed.size() && last != 0 ? last : block;
  }
};

[[nodiscard]] BlockSizes read_block_sizes(ByteStream& stream, std::size_t width,
                                          const Place& place) {
  const std::uint64_t blocks = load_header(stream.take(width), 0, width);
  if (blocks > stream.left() / width + 1) place.fail("array of compressed blocks is cut");
  stream.rewind();
  const std::string header = stream.take(width * (3 + blocks));
  BlockSizes sizes{load_header(header, 1, width), load_header(header, 2, width), {}};
  for (std::size_t i = 0; i < blocks; ++i)
    sizes.compressed.push_back(load_header(header, 3 + i, width));
  return sizes;
}

[[nodiscard]] std::string decode_compressed(ByteStream& stream, std::size_t width,
                                            const Place& place) {
  const BlockSizes sizes = read_block_sizes(stream, width, place);
  std::uint64_t from = 0, to = 0;
  for (std::size_t i = 0; i < sizes.compressed.size(); ++i) {
    const std::uint64_t packed = sizes.compressed[i], unpacked = sizes.size_of(i);
    if (packed > stream.left() - std::min(from, stream.left()))
      place.fail("array of compressed blocks is cut");
    if (unpacked > kLargestRatio * packed) place.fail("compressed block cannot have its size");
    from += packed;
    to += unpacked;
    if (to > core::kMaxFileBytes) place.fail("compressed array is larger than 4 GiB");
  }
  const std::string packed = stream.take(from);
  std::string bytes(to, '\0');
  std::size_t source = 0, target = 0;
  for (std::size_t i = 0; i < sizes.compressed.size(); ++i) {
    uLongf size = sizes.size_of(i);
    const int status =
        ::uncompress(reinterpret_cast<Bytef*>(bytes.data() + target), &size,
                     reinterpret_cast<const Bytef*>(packed.data() + source), sizes.compressed[i]);
    if (status != Z_OK || size != sizes.size_of(i)) place.fail("compressed block is damaged");
    source += sizes.compressed[i];
    target += size;
  }
  return bytes;
}

[[nodiscard]] std::string compress_block(std::string_view bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status = ::compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6);
  core::ensures(status == Z_OK, "zlib fails only for want of memory or of space");
  packed.resize(size);
  return packed;
}

}  // namespace

void Place::fail(const std::string& reason) const { throw core::InvalidInput(file, line, reason); }

std::string decode_array(std::string_view data, const VtuEncoding& encoding, const Place& place) {
  ByteStream stream(data, encoding.is_base64, place);
  return encoding.is_compressed ? decode_compressed(stream, encoding.header_bytes, place)
                                : decode_plain(stream, encoding);
}

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 3; ++k)
      value = value << 8U | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(k <= group.size() ? kAlphabet[value >> (18 - 6 * k) & 0x3FU] : '=');
  }
  return text;
}

std::string encode_array(std::string_view bytes) {
  std::string header, packed;
  const std::uint64_t blocks = (bytes.size() + kBlockBytes - 1) / kBlockBytes;
  append_little<std::uint64_t>(header, blocks);
  append_little<std::uint64_t>(header, kBlockBytes);
  append_little<std::uint64_t>(header, bytes.size() % kBlockBytes);
  for (std::size_t first = 0; first < bytes.size(); first += kBlockBytes) {
    const std::string block = compress_block(bytes.substr(first, kBlockBytes));
    append_little<std::uint64_t>(header, block.size());
    packed += block;
  }
  return to_base64(header) + to_base64(packed);
}

}  // namespace hexatlas::io
