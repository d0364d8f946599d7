#pragma once
/// \file
/// A small writer of tables for the tests of the judge, from docs/formats/table.md. It shares with
/// the judge only the canonical code and the digest, which have tests of their own.

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tables/check/quad_code.hpp"
#include "tables/check/sha256.hpp"
#include "tests/sabotage/slow_oracle.hpp"
#include "tests/tables/check/example_meshes.hpp"

namespace hexatlas::check::sabotage {

inline void put(std::string& bytes, std::uint64_t value, unsigned size) {
  for (unsigned i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
}

inline void put_at(std::string& bytes, std::size_t at, std::uint64_t value, unsigned size) {
  std::string field;
  put(field, value, size);
  bytes.replace(at, size, field);
}

/// Puts the right digest into a file.
inline void seal(std::string& bytes) {
  bytes.replace(96, 32, std::string(32, '\0'));
  Sha256 sha;
  sha.add(bytes);
  const auto digest = sha.digest();
  bytes.replace(96, 32, std::string(digest.begin(), digest.end()));
}

struct TableEntry {
  unsigned quads = 0;
  std::string key;
  std::uint32_t hexahedra = 0;
  std::uint32_t interior = 0;
  std::uint32_t lower_bound = 1;
  std::string payload;
};

struct Name {
  std::uint32_t ordinal;
  std::string text;
};

/// Where the parts of a written table begin.
struct Parts {
  std::size_t index = 0;
  std::size_t directory = 0;
  std::size_t blocks = 0;
  std::size_t names = 0;
};

/// The beginning of a Zstandard frame (RFC 8878): magic, a descriptor that says "one segment, size
/// in 4 bytes", and the size of the content.
inline std::string frame_header(std::size_t content) {
  std::string frame;
  put(frame, 0xFD2FB528, 4);
  put(frame, 0xA0, 1);
  put(frame, content, 4);
  return frame;
}

/// A frame whose one block is stored without compression. Requires: less than 128 KiB.
inline std::string raw_frame(const std::string& content) {
  std::string frame = frame_header(content.size());
  put(frame, content.size() << 3 | 1, 3);
  return frame + content;
}

/// A frame of 16 MiB of zeros in about 500 bytes, as blocks of one repeated byte.
inline std::string frame_of_zeros() {
  constexpr std::size_t kBlocks = 128;
  constexpr std::size_t kBlock = std::size_t{1} << 17;
  std::string frame = frame_header(kBlocks * kBlock);
  for (std::size_t b = 1; b <= kBlocks; ++b) {
    put(frame, kBlock << 3 | 2 | (b == kBlocks ? 1 : 0), 3);
    put(frame, 0, 1);
  }
  return frame;
}

inline std::string packed_block(const std::vector<TableEntry>& entries, std::size_t from,
                                std::size_t to, std::size_t& unpacked) {
  std::string block;
  for (std::size_t i = from; i < to; ++i) put(block, entries[i].payload.size(), 4);
  for (std::size_t i = from; i < to; ++i) block += entries[i].payload;
  unpacked = block.size();
  return raw_frame(block);
}

/// Entries are written as they are, in the order given.
inline std::string write_table(const std::vector<TableEntry>& entries,
                               const std::vector<Name>& names, std::size_t per_block,
                               std::uint32_t complete_through, Parts& parts) {
  std::map<unsigned, std::size_t> count_of;
  std::string index;
  for (const TableEntry& entry : entries) {
    ++count_of[entry.quads];
    index += entry.key;
    for (const std::uint32_t field : {entry.hexahedra, entry.interior, entry.lower_bound, 0U}) {
      put(index, field, 2);
    }
  }
  const std::size_t blocks = (entries.size() + per_block - 1) / per_block;
  parts.index = 128 + 32 * count_of.size();
  parts.directory = parts.index + index.size();
  parts.blocks = parts.directory + 16 * blocks;
  std::string sections;
  std::size_t first = 0;
  std::size_t offset = parts.index;
  for (const auto& [quads, count] : count_of) {
    const std::size_t key_bytes = (quads + 1) / 2;
    put(sections, quads, 4);
    put(sections, key_bytes, 4);
    put(sections, first, 8);
    put(sections, count, 8);
    put(sections, offset, 8);
    first += count;
    offset += count * (key_bytes + 8);
  }
  std::string directory;
  std::string stored;
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t unpacked = 0;
    const std::string block = packed_block(entries, b * per_block,
                                           std::min(entries.size(), (b + 1) * per_block), unpacked);
    put(directory, parts.blocks + stored.size(), 8);
    put(directory, block.size(), 4);
    put(directory, unpacked, 4);
    stored += block;
  }
  parts.names = parts.blocks + stored.size();
  std::string tail;
  for (const Name& name : names) {
    put(tail, name.ordinal, 4);
    put(tail, name.text.size(), 1);
    tail += name.text;
  }
  std::string header = "hexatlas";
  put(header, 2, 4);
  put(header, 0x0A0B0C0D, 4);
  put(header, parts.names + tail.size(), 8);
  put(header, entries.size(), 8);
  put(header, count_of.size(), 4);
  put(header, blocks, 4);
  put(header, names.size(), 4);
  put(header, per_block, 4);
  put(header, parts.index, 8);
  put(header, parts.directory, 8);
  put(header, parts.names, 8);
  put(header, complete_through, 4);
  header.resize(128, '\0');
  std::string bytes = header + sections + index + directory + stored + tail;
  seal(bytes);
  return bytes;
}

/// A mesh whose boundary has its canonical labels and orientation.
struct Canonical {
  CodeWord word;
  std::vector<Quad> quads;  ///< the canonical list
  std::vector<Hexahedron> cells;
};

inline Canonical canonical(const examples::Example& example) {
  const auto code = canonical_code(example.surface.quads);
  std::string reason;
  Canonical result{code->word, *decode_word(code->word, reason), example.mesh.hexahedra};
  for (Hexahedron& cell : result.cells) {
    for (std::uint32_t& vertex : cell) {
      if (vertex < code->labels.size()) vertex = code->labels[vertex];
    }
    if (code->is_mirrored) {
      for (std::size_t i = 0; i < 4; ++i) std::swap(cell[i], cell[i + 4]);
    }
  }
  return result;
}

/// Encoding 1.
inline std::string cells_payload(const Canonical& mesh) {
  std::string payload = "\x01";
  for (const Hexahedron& cell : mesh.cells) {
    std::array<std::uint32_t, 8> by_bits{};
    for (std::size_t i = 0; i < 8; ++i) by_bits[oracle::kBits[i]] = cell[i];
    for (const std::uint32_t vertex : by_bits) put(payload, vertex, 2);
  }
  return payload;
}

/// Writes the steps of encoding 0 that take the hexahedra off in their order. Throws if that is no
/// shelling read backwards.
class FlipWriter {
 public:
  explicit FlipWriter(const Canonical& mesh) : list_(mesh.quads), cells_(mesh.cells) {}

  std::string payload() {
    std::string steps(1, '\0');
    for (std::size_t c = 0; c + 1 < cells_.size(); ++c) steps += step(cells_[c]);
    return steps;
  }

 private:
  /// The vertex of the cell beside `vertex` that is not in `quad`.
  static std::uint32_t above(const Hexahedron& cell, const Quad& quad, std::uint32_t vertex) {
    const auto at =
        static_cast<std::size_t>(std::find(cell.begin(), cell.end(), vertex) - cell.begin());
    for (std::size_t i = 0; i < 8; ++i) {
      const unsigned differ = oracle::kBits[i] ^ oracle::kBits[at];
      const bool beside = differ == 1 || differ == 2 || differ == 4;
      if (beside && std::find(quad.begin(), quad.end(), cell[i]) == quad.end()) return cell[i];
    }
    throw std::logic_error("not a quad of the hexahedron");
  }

  std::string step(const Hexahedron& cell) {
    std::set<Quad> outer;
    for (const Quad& quad : oracle::outer_quads(cell)) outer.insert(oracle::cycle(quad));
    std::size_t exposed = 0;
    for (const Quad& quad : list_) exposed += outer.contains(oracle::cycle(quad)) ? 1 : 0;
    for (std::size_t place = 0; place < list_.size(); ++place) {
      if (!outer.contains(oracle::cycle(list_[place]))) continue;
      const Quad bottom = list_[place];
      Quad top{};
      for (std::size_t i = 0; i < 4; ++i) top[i] = above(cell, bottom, bottom[i]);
      unsigned sides = 0;
      std::size_t taken = 1;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        if (find({bottom[j], bottom[i], top[i], top[j]}) == list_.size()) continue;
        sides |= 1U << i;
        ++taken;
      }
      if (taken == exposed) return take_off(place, sides, bottom, top);
    }
    throw std::logic_error("no step takes off this hexahedron");
  }

  [[nodiscard]] std::size_t find(const Quad& quad) const {
    const auto same = [&](const Quad& other) {
      return oracle::cycle(other) == oracle::cycle(quad);
    };
    return static_cast<std::size_t>(std::find_if(list_.begin(), list_.end(), same) - list_.begin());
  }

  std::string take_off(std::size_t place, unsigned sides, const Quad& bottom, const Quad& top) {
    std::vector<Quad> added;
    std::set<std::size_t> leaving = {place};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      if ((sides >> i & 1) != 0) {
        leaving.insert(find({bottom[j], bottom[i], top[i], top[j]}));
      } else {
        added.push_back({bottom[i], bottom[j], top[j], top[i]});
      }
    }
    added.push_back(top);
    for (auto it = leaving.rbegin(); it != leaving.rend(); ++it) {
      list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(*it));
    }
    list_.insert(list_.end(), added.begin(), added.end());
    return {static_cast<char>(place), static_cast<char>(sides)};
  }

  std::vector<Quad> list_;
  std::vector<Hexahedron> cells_;
};

inline TableEntry entry_of(const examples::Example& example, bool flips) {
  const Canonical mesh = canonical(example);
  TableEntry entry;
  entry.quads = static_cast<unsigned>(mesh.quads.size());
  entry.key = key_of_word(mesh.word);
  entry.hexahedra = static_cast<std::uint32_t>(mesh.cells.size());
  entry.interior =
      static_cast<std::uint32_t>(example.mesh.points.size() - example.surface.points.size());
  entry.payload = flips ? FlipWriter(mesh).payload() : cells_payload(mesh);
  return entry;
}

inline bool in_order(const TableEntry& a, const TableEntry& b) {
  return std::pair(a.quads, a.key) < std::pair(b.quads, b.key);
}

}  // namespace hexatlas::check::sabotage
