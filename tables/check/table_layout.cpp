#include "tables/check/table_layout.hpp"

#include <algorithm>

#include "tables/check/sha256.hpp"

namespace hexatlas::check {

namespace {

constexpr std::uint64_t kHeader = 128;
constexpr std::uint64_t kSection = 32;
constexpr std::uint64_t kDirectoryEntry = 16;
constexpr std::uint64_t kEntryTail = 8;
constexpr std::uint64_t kDigestAt = 96;
constexpr std::uint64_t kDigest = 32;
constexpr std::uint32_t kFewestQuads = 6;
constexpr std::uint32_t kMostQuads = 64;
constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 26;

class LayoutReader {
 public:
  LayoutReader(std::string_view bytes, TableLayout& layout) : bytes_(bytes), layout_(layout) {}

  std::string read() {
    for (const auto& part : {&LayoutReader::header, &LayoutReader::digest, &LayoutReader::sections,
                             &LayoutReader::directory, &LayoutReader::names}) {
      std::string broken = (this->*part)();
      if (!broken.empty()) return broken;
    }
    return {};
  }

 private:
  [[nodiscard]] std::uint64_t at(std::uint64_t offset, unsigned size) const {
    return number_at(bytes_, offset, size);
  }
  [[nodiscard]] bool fits(std::uint64_t from, std::uint64_t count, std::uint64_t size) const {
    return from <= bytes_.size() && count <= (bytes_.size() - from) / size;
  }

  std::string header() {
    if (bytes_.size() < kHeader) return "the file is shorter than its header";
    if (bytes_.substr(0, 8) != "hexatlas") return "the file does not begin with 'hexatlas'";
    if (at(8, 4) != 2) return "the version is not 2";
    if (at(12, 4) != 0x0A0B0C0D) return "the byte order is wrong";
    if (at(16, 8) != bytes_.size()) return "the size of the file is not that of its header";
    const std::string_view zero = bytes_.substr(76, 20);
    if (zero.find_first_not_of('\0') != std::string_view::npos)
      return "bytes 76 to 95 are not zero";
    const std::uint64_t through = at(72, 4);
    if (through != 0 && (through < kFewestQuads || through > kMostQuads || through % 2 != 0))
      return "the claim of completeness names an impossible number of quads";
    layout_.complete_through = static_cast<std::uint32_t>(through);
    layout_.entries = at(24, 8);
    layout_.entries_per_block = at(44, 4);
    layout_.names = at(40, 4);
    if (layout_.entries_per_block == 0) return "a block has no entries";
    if (layout_.entries > bytes_.size()) return "the number of entries is too large";
    const std::uint64_t per_block = layout_.entries_per_block;
    if (at(36, 4) != (layout_.entries + per_block - 1) / per_block) {
      return "the number of blocks is wrong";
    }
    return {};
  }

  std::string digest() {
    Sha256 sha;
    sha.add(bytes_.substr(0, kDigestAt));
    sha.add(std::string(kDigest, '\0'));
    sha.add(bytes_.substr(kHeader));
    const auto wanted = sha.digest();
    const bool same =
        std::equal(wanted.begin(), wanted.end(), bytes_.begin() + kDigestAt,
                   [](std::uint8_t a, char b) { return a == static_cast<unsigned char>(b); });
    return same ? "" : "the SHA-256 is not that of the file";
  }

  std::string sections() {
    const std::uint64_t count = at(32, 4);
    if (!fits(kHeader, count, kSection)) return "the sections are cut";
    std::uint64_t next_entry = 0;
    std::uint32_t least = kFewestQuads;
    end_ = kHeader + count * kSection;
    if (at(48, 8) != end_) return "the index does not follow the sections";
    for (std::uint64_t s = 0; s < count; ++s) {
      const std::uint64_t from = kHeader + s * kSection;
      const TableSection section{static_cast<std::uint32_t>(at(from, 4)),
                                 static_cast<std::uint32_t>(at(from + 4, 4)), at(from + 8, 8),
                                 at(from + 16, 8), at(from + 24, 8)};
      const std::string name = "section " + std::to_string(s);
      if (section.quads < least || section.quads > kMostQuads) {
        return name + " has a wrong number of quads";
      }
      if (section.key_bytes != (section.quads + 1) / 2) return name + " has a wrong length of key";
      if (section.first != next_entry) return name + " has a wrong first ordinal";
      if (section.offset != end_) return name + " has a wrong offset";
      if (section.count == 0 || !fits(end_, section.count, section.key_bytes + kEntryTail)) {
        return name + " has a wrong number of entries";
      }
      least = section.quads + 1;
      next_entry += section.count;
      end_ += section.count * (section.key_bytes + kEntryTail);
      layout_.sections.push_back(section);
    }
    return next_entry == layout_.entries ? "" : "the sections do not hold all entries";
  }

  std::string directory() {
    const std::uint64_t count = at(36, 4);
    if (at(56, 8) != end_) return "the block directory does not follow the index";
    if (!fits(end_, count, kDirectoryEntry)) return "the block directory is cut";
    const std::uint64_t from = end_;
    end_ += count * kDirectoryEntry;
    for (std::uint64_t b = 0; b < count; ++b) {
      const std::uint64_t entry = from + b * kDirectoryEntry;
      const TableBlock block{at(entry, 8), at(entry + 8, 4), at(entry + 12, 4)};
      if (block.offset != end_) return "block " + std::to_string(b) + " has a wrong offset";
      if (!fits(end_, block.stored, 1)) return "block " + std::to_string(b) + " is cut";
      if (block.unpacked > kMostUnpacked) {
        return "block " + std::to_string(b) + " unpacks to more than 64 MiB";
      }
      end_ += block.stored;
      layout_.blocks.push_back(block);
    }
    return {};
  }

  std::string names() {
    if (at(64, 8) != end_) return "the names do not follow the blocks";
    std::string_view before;
    for (std::uint64_t i = 0; i < layout_.names; ++i) {
      const std::string which = "name " + std::to_string(i);
      if (!fits(end_, 5, 1)) return which + " is cut";
      const std::uint64_t length = at(end_ + 4, 1);
      if (!fits(end_ + 5, length, 1)) return which + " is cut";
      const std::string_view name = bytes_.substr(end_ + 5, length);
      if (at(end_, 4) >= layout_.entries) return which + " is that of no entry";
      if (name.empty()) return which + " is empty";
      if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != name.npos) {
        return which + " has a character that is not allowed";
      }
      if (i > 0 && name <= before) return which + " is out of order";
      before = name;
      end_ += 5 + length;
    }
    return end_ == bytes_.size() ? "" : "the file does not end after the names";
  }

  std::string_view bytes_;
  TableLayout& layout_;
  std::uint64_t end_ = 0;  ///< where the next part must begin
};

}  // namespace

std::uint64_t number_at(std::string_view bytes, std::uint64_t at, unsigned size) {
  std::uint64_t value = 0;
  for (unsigned i = size; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

std::string read_layout(std::string_view bytes, TableLayout& layout) {
  return LayoutReader(bytes, layout).read();
}

}  // namespace hexatlas::check
