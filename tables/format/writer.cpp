#include <algorithm>
#include <array>

#include "enum/core/checks.hpp"
#include "tables/format/bytes.hpp"
#include "tables/format/frame.hpp"
#include "tables/format/layout.hpp"
#include "tables/format/record.hpp"
#include "tables/format/sha256.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::format {
namespace {

constexpr std::uint32_t kRecordsPerBlock = 64;

struct Parts {
  std::string sections, index, directory, blocks, names;
  std::uint32_t section_count = 0, block_count = 0;
};

void put_index(Parts& parts, const std::vector<TableRow>& rows) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i == 0 || rows[i].code.quads != rows[i - 1].code.quads) starts.push_back(i);
  parts.section_count = static_cast<std::uint32_t>(starts.size());
  const std::size_t index_offset = layout::kHeaderSize + starts.size() * layout::kSectionSize;
  for (std::size_t s = 0; s < starts.size(); ++s) {
    const std::size_t end = s + 1 < starts.size() ? starts[s + 1] : rows.size();
    const std::uint32_t quads = rows[starts[s]].code.quads;
    put(parts.sections, quads);
    put(parts.sections, static_cast<std::uint32_t>(canon::binary_size(rows[starts[s]].code.quads)));
    put(parts.sections, std::uint64_t{starts[s]});
    put(parts.sections, std::uint64_t{end - starts[s]});
    put(parts.sections, std::uint64_t{index_offset + parts.index.size()});
    for (std::size_t i = starts[s]; i < end; ++i) {
      parts.index += canon::to_binary(rows[i].code);
      put(parts.index, static_cast<std::uint16_t>(rows[i].mesh.hexahedra.size()));
      put(parts.index, static_cast<std::uint16_t>(rows[i].mesh.vertices - quads - 2));
      put(parts.index, rows[i].lower_bound);
      put(parts.index, std::uint16_t{0});
    }
  }
}

/// The directory comes before the blocks, so their offsets are known only when it is complete.
void put_blocks(Parts& parts, const std::vector<TableRow>& rows) {
  struct Block {
    std::string stored;
    std::size_t raw_size;
  };
  std::vector<Block> blocks;
  for (std::size_t begin = 0; begin < rows.size(); begin += kRecordsPerBlock) {
    const std::size_t end = std::min<std::size_t>(rows.size(), begin + kRecordsPerBlock);
    std::string lengths, payloads;
    for (std::size_t i = begin; i < end; ++i) {
      const auto boundary = canon::decode(rows[i].code);
      core::expects(boundary.has_value(), "the code of a row can be decoded");
      const std::string payload = encode_record(rows[i].mesh, *boundary);
      put(lengths, static_cast<std::uint32_t>(payload.size()));
      payloads += payload;
    }
    const std::string raw = lengths + payloads;
    blocks.push_back({compressed(raw), raw.size()});
  }
  parts.block_count = static_cast<std::uint32_t>(blocks.size());
  std::size_t offset = layout::kHeaderSize + parts.sections.size() + parts.index.size() +
                       blocks.size() * layout::kDirectoryEntrySize;
  for (const Block& block : blocks) {
    put(parts.directory, std::uint64_t{offset});
    put(parts.directory, static_cast<std::uint32_t>(block.stored.size()));
    put(parts.directory, static_cast<std::uint32_t>(block.raw_size));
    parts.blocks += block.stored;
    offset += block.stored.size();
  }
}

void put_names(Parts& parts, const std::vector<TableRow>& rows, std::vector<TableRowName>& names) {
  std::sort(names.begin(), names.end(),
            [](const TableRowName& a, const TableRowName& b) { return a.name < b.name; });
  for (const TableRowName& name : names) {
    const auto row =
        std::lower_bound(rows.begin(), rows.end(), name.code,
                         [](const TableRow& a, const canon::Code& code) { return a.code < code; });
    core::expects(row != rows.end() && row->code == name.code && layout::is_name(name.name),
                  "a name belongs to a row");
    put(parts.names, static_cast<std::uint32_t>(row - rows.begin()));
    put(parts.names, static_cast<std::uint8_t>(name.name.size()));
    parts.names += name.name;
  }
}

std::string header(const Parts& parts, std::size_t entries, std::size_t names,
                   std::uint32_t complete_through) {
  const std::size_t index = layout::kHeaderSize + parts.sections.size();
  const std::size_t directory = index + parts.index.size();
  const std::size_t names_offset = directory + parts.directory.size() + parts.blocks.size();
  std::string bytes(layout::kMagic);
  put(bytes, kTableVersion);
  put(bytes, layout::kByteOrder);
  put(bytes, std::uint64_t{names_offset + parts.names.size()});
  put(bytes, std::uint64_t{entries});
  put(bytes, parts.section_count);
  put(bytes, parts.block_count);
  put(bytes, static_cast<std::uint32_t>(names));
  put(bytes, kRecordsPerBlock);
  put(bytes, std::uint64_t{index});
  put(bytes, std::uint64_t{directory});
  put(bytes, std::uint64_t{names_offset});
  put(bytes, complete_through);
  bytes.resize(layout::kHeaderSize, '\0');
  return bytes;
}

}  // namespace

std::string table_bytes(std::vector<TableRow> rows, std::vector<TableRowName> names,
                        int complete_through) {
  const auto claim = static_cast<std::uint32_t>(complete_through);
  core::expects(layout::is_claim(claim), "completeness is claimed for even numbers of quads");
  std::sort(rows.begin(), rows.end(),
            [](const TableRow& a, const TableRow& b) { return a.code < b.code; });
  core::expects(std::adjacent_find(rows.begin(), rows.end(),
                                   [](const TableRow& a, const TableRow& b) {
                                     return a.code == b.code;
                                   }) == rows.end(),
                "the codes of a table are distinct");
  Parts parts;
  put_index(parts, rows);
  put_blocks(parts, rows);
  put_names(parts, rows, names);
  std::string bytes = header(parts, rows.size(), names.size(), claim);
  for (const std::string* part :
       {&parts.sections, &parts.index, &parts.directory, &parts.blocks, &parts.names})
    bytes += *part;
  const std::array<std::string_view, 1> whole{bytes};
  const Digest digest = sha256(whole);
  std::copy(digest.begin(), digest.end(), bytes.begin() + layout::kDigest);
  return bytes;
}

}  // namespace hexatlas::format
