#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "enum/core/checks.hpp"
#include "tables/format/bytes.hpp"
#include "tables/format/frame.hpp"
#include "tables/format/layout.hpp"
#include "tables/format/record.hpp"
#include "tables/format/sha256.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::format {
namespace {

/// Length, encoding, and 65,535 hexahedra as cells: what is larger is not allocated.
constexpr std::size_t kMaxRecordSize = 4 + 1 + 16 * std::size_t{65'535};
constexpr std::size_t kMaxBlockSize = std::size_t{1}
                                      << 26;  // a small file must not fill the memory

/// A file mapped read-only for the lifetime of the object.
class MappedFile {
 public:
  explicit MappedFile(const std::string& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // no waiting at a pipe
    if (fd < 0)
      throw core::InvalidInput(path, std::string("cannot be opened: ") + std::strerror(errno));
    struct stat status {};
    const bool is_file = ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
    size_ = is_file ? static_cast<std::size_t>(status.st_size) : 0;
    if (size_ > 0) data_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fd, 0);
    ::close(fd);
    if (!is_file) throw core::InvalidInput(path, "is not a regular file");
    if (size_ == 0) throw core::InvalidInput(path, "is empty, not a table");
    if (data_ == MAP_FAILED)
      throw core::ResourceFailure(path + ": cannot be mapped: " + std::strerror(errno));
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile() { ::munmap(data_, size_); }
  [[nodiscard]] std::string_view bytes() const noexcept {
    return {static_cast<const char*>(data_), size_};
  }

 private:
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

struct Section {
  int quads = 0;
  std::size_t key_size = 0, first = 0, count = 0, offset = 0;
  [[nodiscard]] std::size_t entry_size() const noexcept { return key_size + layout::kEntryFields; }
};

}  // namespace

struct Table::Content {
  std::string name;
  std::unique_ptr<const MappedFile> file;  ///< or
  std::string copy;                        ///< the bytes themselves
  std::string_view bytes;
  std::size_t entries = 0, records_per_block = 1, directory = 0;
  std::uint32_t complete_through = 0;
  std::vector<Section> sections;
  std::vector<TableName> names;

  void read_layout();
  [[nodiscard]] std::string_view key(const Section& section, std::size_t ordinal) const {
    return bytes.substr(section.offset + (ordinal - section.first) * section.entry_size(),
                        section.key_size);
  }
  [[nodiscard]] const Section& section_of(std::size_t ordinal) const;
  [[nodiscard]] std::string block(std::size_t number) const;

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw core::InvalidInput(name, reason);
  }
  void check_header() const;
  void check_digest() const;
  void read_sections();
  void read_names(std::size_t at, std::size_t count);
};

void Table::Content::check_header() const {
  if (bytes.size() < layout::kHeaderSize || !bytes.starts_with(layout::kMagic))
    refuse("is not a table of hexatlas");
  const auto version = get<std::uint32_t>(bytes, layout::kVersion);
  if (get<std::uint32_t>(bytes, layout::kByteOrderMark) != layout::kByteOrder)
    refuse("is damaged: the byte order mark is wrong");
  if (version != kTableVersion)
    refuse("is a table of version " + std::to_string(version) + "; this program reads version " +
           std::to_string(kTableVersion));
  const auto size = get<std::uint64_t>(bytes, layout::kFileSize);
  if (size != bytes.size())
    refuse("is truncated or damaged: it has " + std::to_string(bytes.size()) + " bytes of " +
           std::to_string(size));
}

void Table::Content::check_digest() const {
  const std::string zeros(layout::kHeaderSize - layout::kDigest, '\0');
  const std::array<std::string_view, 3> parts{bytes.substr(0, layout::kDigest), zeros,
                                              bytes.substr(layout::kHeaderSize)};
  const Digest digest = format::sha256(parts);
  if (!std::equal(digest.begin(), digest.end(), bytes.begin() + layout::kDigest,
                  [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); }))
    refuse("is damaged: its SHA-256 does not match its content");
}

void Table::Content::read_sections() {
  const auto count = get<std::uint32_t>(bytes, layout::kSections);
  std::size_t offset = get<std::uint64_t>(bytes, layout::kIndexOffset);
  if (offset != layout::kHeaderSize + std::size_t{count} * layout::kSectionSize ||
      offset > bytes.size())
    refuse("is damaged: the index is misplaced");
  std::size_t ordinal = 0;
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t at = layout::kHeaderSize + s * layout::kSectionSize;
    Section section{static_cast<int>(get<std::uint32_t>(bytes, at)),
                    get<std::uint32_t>(bytes, at + 4), get<std::uint64_t>(bytes, at + 8),
                    get<std::uint64_t>(bytes, at + 16), get<std::uint64_t>(bytes, at + 24)};
    const bool ascends = sections.empty() || sections.back().quads < section.quads;
    if (section.quads < 6 || section.quads > complex::kMaxQuads || !ascends ||
        section.key_size != canon::binary_size(section.quads) || section.first != ordinal ||
        section.offset != offset || section.count > (bytes.size() - offset) / section.entry_size())
      refuse("is damaged: section " + std::to_string(s) + " is inconsistent");
    ordinal += section.count;
    offset += section.count * section.entry_size();
    sections.push_back(section);
  }
  if (ordinal != entries || offset != directory)
    refuse("is damaged: the index does not have its " + std::to_string(entries) + " entries");
}

void Table::Content::read_names(std::size_t at, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (bytes.size() - at < 5) refuse("is damaged: the names are cut off");
    const std::size_t ordinal = get<std::uint32_t>(bytes, at);
    const std::size_t length = get<std::uint8_t>(bytes, at + 4);
    at += 5;
    const std::string_view text = bytes.substr(at, length);
    const bool ascends = names.empty() || names.back().name < text;
    if (text.size() < length || ordinal >= entries || !ascends || !layout::is_name(text))
      refuse("is damaged: name " + std::to_string(i) + " is inconsistent");
    names.push_back({std::string(text), ordinal});
    at += length;
  }
  if (at != bytes.size()) refuse("is damaged: bytes follow the names");
}

void Table::Content::read_layout() {
  check_header();
  check_digest();
  complete_through = get<std::uint32_t>(bytes, layout::kCompleteThrough);
  const std::string_view zeros = bytes.substr(layout::kZeros, layout::kDigest - layout::kZeros);
  if (!layout::is_claim(complete_through))
    refuse("is damaged: its claim of completeness is impossible");
  if (zeros.find_first_not_of('\0') != zeros.npos)
    refuse("is damaged: its header has bytes that are not 0 where it must");
  entries = get<std::uint64_t>(bytes, layout::kEntries);
  records_per_block = get<std::uint32_t>(bytes, layout::kEntriesPerBlock);
  directory = get<std::uint64_t>(bytes, layout::kDirectoryOffset);
  const std::size_t blocks = get<std::uint32_t>(bytes, layout::kBlocks);
  const std::size_t names_offset = get<std::uint64_t>(bytes, layout::kNamesOffset);
  if (entries > bytes.size() || records_per_block == 0 ||
      blocks != (entries + records_per_block - 1) / records_per_block)
    refuse("is damaged: the counts in its header disagree");
  read_sections();
  std::size_t offset = directory + blocks * layout::kDirectoryEntrySize;
  for (std::size_t b = 0; b < blocks && offset <= bytes.size(); ++b) {
    const std::size_t at = directory + b * layout::kDirectoryEntrySize;
    if (get<std::uint64_t>(bytes, at) != offset)
      refuse("is damaged: block " + std::to_string(b) + " is misplaced");
    offset += get<std::uint32_t>(bytes, at + 8);
  }
  if (offset != names_offset || names_offset > bytes.size())
    refuse("is damaged: the blocks do not fill their part");
  read_names(names_offset, get<std::uint32_t>(bytes, layout::kNames));
}

const Section& Table::Content::section_of(std::size_t ordinal) const {
  core::expects(ordinal < entries, "the ordinal of an entry is below the number of entries");
  return *std::find_if(sections.begin(), sections.end(),
                       [&](const Section& s) { return ordinal < s.first + s.count; });
}

std::string Table::Content::block(std::size_t number) const {
  const std::size_t at = directory + number * layout::kDirectoryEntrySize;
  const std::string_view stored =
      bytes.substr(get<std::uint64_t>(bytes, at), get<std::uint32_t>(bytes, at + 8));
  const std::size_t unpacked = get<std::uint32_t>(bytes, at + 12);
  const std::size_t records = std::min(records_per_block, entries - number * records_per_block);
  const auto frame_size = ZSTD_getFrameContentSize(stored.data(), stored.size());
  const bool fits = unpacked <= std::min(records * kMaxRecordSize, kMaxBlockSize) &&
                    (frame_size == ZSTD_CONTENTSIZE_UNKNOWN || frame_size == unpacked);
  if (!fits) refuse("is damaged: block " + std::to_string(number) + " has an impossible size");
  std::string raw(unpacked, '\0');
  if (!is_unpacked(stored, raw))
    refuse("is damaged: block " + std::to_string(number) + " cannot be unpacked");
  return raw;
}

Table Table::open(const std::string& path) {
  auto content = std::make_shared<Content>();
  content->name = path;
  content->file = std::make_unique<MappedFile>(path);
  content->bytes = content->file->bytes();
  content->read_layout();
  return Table(std::move(content));
}

Table Table::from_bytes(std::string bytes, const std::string& name) {
  auto content = std::make_shared<Content>();
  content->name = name;
  content->copy = std::move(bytes);
  content->bytes = content->copy;
  content->read_layout();
  return Table(std::move(content));
}

std::size_t Table::size() const noexcept { return content_->entries; }
int Table::complete_through() const noexcept {
  return static_cast<int>(content_->complete_through);
}
std::size_t Table::bytes() const noexcept { return content_->bytes.size(); }
const std::string& Table::path() const noexcept { return content_->name; }
const std::vector<TableName>& Table::names() const noexcept { return content_->names; }

TableEntry Table::entry(std::size_t ordinal) const {
  const Section& section = content_->section_of(ordinal);
  const std::string_view key = content_->key(section, ordinal);
  const auto code = canon::from_binary(section.quads, key);
  if (!code)
    throw core::InvalidInput(
        path(), "is damaged: entry " + std::to_string(ordinal) + " has no code for a key");
  const std::size_t at =
      static_cast<std::size_t>(key.data() - content_->bytes.data()) + section.key_size;
  const auto field = [&](std::size_t i) { return get<std::uint16_t>(content_->bytes, at + 2 * i); };
  return {*code, field(0), field(1), field(2)};
}

std::optional<std::size_t> Table::find(const canon::Code& code) const {
  const auto& sections = content_->sections;
  const auto section = std::find_if(sections.begin(), sections.end(),
                                    [&](const Section& s) { return s.quads == code.quads; });
  if (section == sections.end()) return std::nullopt;
  const std::string key = canon::to_binary(code);
  std::size_t low = section->first;
  std::size_t high = section->first + section->count;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (content_->key(*section, middle) < key)
      low = middle + 1;
    else
      high = middle;
  }
  if (low == section->first + section->count || content_->key(*section, low) != key)
    return std::nullopt;
  return low;
}

complex::HexComplex Table::mesh(std::size_t ordinal) const {
  const TableEntry entry = this->entry(ordinal);
  const std::string raw = content_->block(ordinal / content_->records_per_block);
  const std::size_t first = ordinal / content_->records_per_block * content_->records_per_block;
  const std::size_t records = std::min(content_->records_per_block, content_->entries - first);
  std::size_t at = 4 * records;
  std::size_t length = 0;
  for (std::size_t i = first; i <= ordinal && at <= raw.size(); ++i) {
    at += length;
    length = raw.size() < 4 * records ? 0 : get<std::uint32_t>(raw, 4 * (i - first));
  }
  const auto boundary = canon::decode(entry.code);
  std::optional<complex::HexComplex> mesh;
  if (boundary && at <= raw.size() && length <= raw.size() - at)
    mesh = decode_record(std::string_view(raw).substr(at, length), *boundary, entry.hexahedra);
  if (!mesh)
    throw core::InvalidInput(path(), "is damaged: the record of entry " + std::to_string(ordinal) +
                                         " does not describe a mesh");
  return *std::move(mesh);
}

std::optional<std::size_t> Table::find_name(std::string_view name) const {
  for (const TableName& known : content_->names)
    if (known.name == name) return known.ordinal;
  return std::nullopt;
}

std::string Table::sha256() const {
  const std::array<std::string_view, 1> whole{content_->bytes};
  return to_hex(format::sha256(whole));
}

}  // namespace hexatlas::format
