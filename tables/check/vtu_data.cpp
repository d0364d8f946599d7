#include "tables/check/vtu_data.hpp"

#include <zlib.h>

#include <vector>

namespace hexatlas::check {

namespace {

using Fail = std::function<void(const std::string&)>;

/// zlib expands at most 1032 times; a block that claims more is refused before memory is asked for.
constexpr std::uint64_t kGreatestExpansion = 1040;

int sextet(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// Takes bytes from the front of the stored text.
class Source {
 public:
  Source(std::string_view stored, const VtuEncoding& encoding, const Fail& fail)
      : rest_(stored), base64_(encoding.base64), fail_(fail) {
    const std::size_t begin = base64_ ? rest_.find_first_not_of(" \t\r\n") : 0;
    rest_.remove_prefix(begin == std::string_view::npos ? rest_.size() : begin);
  }

  /// No more bytes than these can be taken.
  [[nodiscard]] std::size_t left() const noexcept { return rest_.size(); }

  /// The next `count` bytes, which in base64 are a run, or the beginning of one if `peek`.
  std::string take(std::uint64_t count, bool peek) {
    const std::uint64_t chars = base64_ ? (count / 3 + (count % 3 != 0)) * 4 : count;
    if (count > rest_.size() || chars > rest_.size()) {
      fail_("an array of data ends too early");
    }
    const std::string_view run = rest_.substr(0, chars);
    if (!peek) rest_.remove_prefix(chars);
    return base64_ ? decode(run, count, peek) : std::string(run);
  }

 private:
  [[nodiscard]] std::string decode(std::string_view run, std::uint64_t count, bool peek) const {
    const std::size_t padding = peek ? 0 : (3 - count % 3) % 3;
    std::string bytes;
    bytes.reserve(run.size() / 4 * 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < run.size(); ++i) {
      const bool pad = i + padding >= run.size();
      const int value = pad ? 0 : sextet(run[i]);
      if (pad ? run[i] != '=' : (value < 0 && !(peek && run[i] == '='))) {
        fail_("an array of data is not base64");
      }
      bits = bits << 6 | static_cast<std::uint32_t>(value < 0 ? 0 : value);
      if (i % 4 == 3) {
        for (int shift = 16; shift >= 0; shift -= 8) {
          bytes += static_cast<char>(bits >> shift & 0xFF);
        }
        bits = 0;
      }
    }
    for (std::size_t i = count; !peek && i < bytes.size(); ++i) {
      if (bytes[i] != 0) fail_("the last bits of an array in base64 are not zero");
    }
    bytes.resize(count);
    return bytes;
  }

  std::string_view rest_;
  bool base64_;
  const Fail& fail_;
};

std::uint64_t word_at(const std::string& bytes, std::size_t index, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[index * size + i]);
  }
  return value;
}

void inflate_block(const std::string& stored, std::uint64_t size, std::string& bytes,
                   const Fail& fail) {
  if (size / kGreatestExpansion > stored.size()) fail("a compressed block is too short");
  const std::size_t begin = bytes.size();
  bytes.resize(begin + size);
  uLongf unpacked = size;
  uLong used = stored.size();
  const int status = uncompress2(reinterpret_cast<Bytef*>(bytes.data() + begin), &unpacked,
                                 reinterpret_cast<const Bytef*>(stored.data()), &used);
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status != Z_OK || unpacked != size || used != stored.size()) {
    fail("a compressed block is damaged");
  }
}

std::string decode_blocks(Source& source, std::size_t word, std::uint64_t wanted,
                          const Fail& fail) {
  const std::uint64_t blocks = word_at(source.take(word, true), 0, word);
  if (blocks > wanted) fail("an array has more compressed blocks than bytes");
  if (blocks > source.left() / word) fail("an array of data ends too early");
  const std::string header = source.take((3 + blocks) * word, false);
  const std::uint64_t full = word_at(header, 1, word);
  const std::uint64_t last = word_at(header, 2, word);
  if (last != 0 && last >= full) fail("the last compressed block is too long");
  std::vector<std::uint64_t> stored;
  std::uint64_t total = 0;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    stored.push_back(word_at(header, 3 + block, word));
    if (stored.back() > (std::uint64_t{1} << 40)) fail("a compressed block is too long");
    total += stored.back();
  }
  const std::string data = source.take(total, false);
  std::string bytes;
  std::size_t begin = 0;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t size = block + 1 == blocks && last != 0 ? last : full;
    if (size > wanted - bytes.size()) fail("an array is longer than it should be");
    inflate_block(data.substr(begin, stored[block]), size, bytes, fail);
    begin += stored[block];
  }
  return bytes;
}

}  // namespace

std::string decode_vtu_array(std::string_view stored, const VtuEncoding& encoding,
                             std::uint64_t wanted, const Fail& fail) {
  Source source(stored, encoding, fail);
  std::string bytes;
  if (encoding.zlib) {
    bytes = decode_blocks(source, encoding.word, wanted, fail);
  } else {
    const std::uint64_t size = word_at(source.take(encoding.word, true), 0, encoding.word);
    if (size != wanted) fail("an array of data has not the length that it should have");
    bytes = source.take(encoding.word + size, false).substr(encoding.word);
  }
  if (bytes.size() != wanted) fail("an array of data has not the length that it should have");
  return bytes;
}

}  // namespace hexatlas::check
