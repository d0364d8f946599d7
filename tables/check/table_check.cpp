#include "tables/check/table_check.hpp"

#include <algorithm>
#include <optional>

#include "tables/check/file_bytes.hpp"
#include "tables/check/judge_cells.hpp"
#include "tables/check/payload.hpp"
#include "tables/check/quad_code.hpp"
#include "tables/check/rooted_count.hpp"
#include "tables/check/table_layout.hpp"
#include "tables/check/zstd_frame.hpp"

namespace hexatlas::check {

namespace {

constexpr std::uint64_t kLengthBytes = 4;

/// By number of quads.
const std::vector<std::uint64_t>& rooted_all() {
  static const std::vector<std::uint64_t> kCounts = rooted_three_connected(kMostCountedQuads);
  return kCounts;
}

/// A key decoded.
struct Boundary {
  std::vector<Quad> quads;  ///< the canonical list
  unsigned automorphisms = 0;
};

/// Returns what is wrong with a key, or nothing.
std::string decode_key(std::string_view key, std::size_t quads, Boundary& boundary) {
  const std::optional<CodeWord> word = word_of_key(key, quads);
  if (!word) return "the unused half byte of the key is not zero";
  std::string reason;
  const auto decoded = decode_word(*word, reason);
  if (!decoded) return "the key is no code: " + reason;
  const auto code = canonical_code(*decoded);
  if (!code) return "the key encodes no simple quadrangulation of the sphere";
  if (code->word != *word) return "the key is not the canonical code of what it encodes";
  if (!is_three_connected_by_removal(*decoded) || !is_three_connected_by_quads(*decoded)) {
    return "the quadrangulation is not 3-connected";
  }
  boundary = {*decoded, code->automorphisms};
  return {};
}

struct IndexEntry {
  std::string_view key;
  std::uint32_t hexahedra;
  std::uint32_t interior;
  std::uint32_t lower_bound;
  std::uint32_t zero;
};

class TableJudge {
 public:
  TableJudge(std::string_view bytes, TableShare share) : bytes_(bytes), share_(share) {}

  TableVerdict judge() {
    verdict_.bytes = bytes_.size();
    verdict_.reason = read_layout(bytes_, layout_);
    verdict_.claimed_through = layout_.complete_through;
    if (verdict_.reason.empty()) verdict_.reason = judge_entries();
    if (verdict_.reason.empty()) verdict_.reason = judge_completeness();
    verdict_.entries = layout_.entries;
    verdict_.names = layout_.names;
    verdict_.accepted = verdict_.reason.empty();
    return verdict_;
  }

 private:
  std::string judge_entries() {
    for (const TableSection& section : layout_.sections) {
      verdict_.by_quads.push_back({.quads = section.quads});
      if (section.quads <= kMostCountedQuads) {
        verdict_.by_quads.back().rooted_all = rooted_all()[section.quads];
      }
      std::string_view before;
      for (std::uint64_t i = 0; i < section.count; ++i) {
        const IndexEntry entry = entry_at(section, i);
        const std::uint64_t ordinal = section.first + i;
        const bool is_shared = ordinal / layout_.entries_per_block % share_.parts == share_.part;
        std::string broken = is_shared ? open_block(ordinal) : "";
        if (!broken.empty()) return broken;
        Boundary boundary;
        if (i > 0 && entry.key <= before) broken = "the keys are not in ascending order";
        if (broken.empty()) broken = judge_key(section.quads, entry, boundary);
        if (broken.empty() && is_shared) broken = judge_mesh(boundary, entry, payload_of(ordinal));
        if (!broken.empty()) return "entry " + std::to_string(ordinal) + ": " + broken;
        count(entry, boundary.automorphisms);
        before = entry.key;
      }
    }
    return {};
  }

  [[nodiscard]] IndexEntry entry_at(const TableSection& section, std::uint64_t i) const {
    const std::uint64_t at = section.offset + i * (section.key_bytes + 8);
    const auto field = [&](unsigned index) {
      return static_cast<std::uint32_t>(
          number_at(bytes_, at + section.key_bytes + std::uint64_t{2} * index, 2));
    };
    return {bytes_.substr(at, section.key_bytes), field(0), field(1), field(2), field(3)};
  }

  /// Unpacks the next block if entry `ordinal` is its first, and finds the payloads in it.
  std::string open_block(std::uint64_t ordinal) {
    if (ordinal % layout_.entries_per_block != 0) return {};
    const std::uint64_t b = ordinal / layout_.entries_per_block;
    const TableBlock& block = layout_.blocks[b];
    const std::string name = "block " + std::to_string(b);
    block_.clear();
    payloads_.clear();
    if (!unpack_frame(bytes_.substr(block.offset, block.stored), block.unpacked, block_) ||
        block_.size() != block.unpacked) {
      return name + " is not one Zstandard frame of the stated length";
    }
    const std::uint64_t records = std::min(layout_.entries_per_block, layout_.entries - ordinal);
    if (records > block_.size() / kLengthBytes) return name + " is cut";
    std::uint64_t at = records * kLengthBytes;
    const std::string_view unpacked = block_;
    for (std::uint64_t r = 0; r < records; ++r) {
      const std::uint64_t length = number_at(unpacked, r * kLengthBytes, 4);
      if (length > unpacked.size() - at) return name + " is shorter than its payloads";
      payloads_.push_back(unpacked.substr(at, length));
      at += length;
    }
    return at == unpacked.size() ? "" : name + " is not filled by its payloads";
  }

  [[nodiscard]] std::string_view payload_of(std::uint64_t ordinal) const {
    return payloads_[ordinal % layout_.entries_per_block];
  }

  static std::string judge_key(std::uint32_t quads, const IndexEntry& entry, Boundary& boundary) {
    if (entry.zero != 0) return "the last two bytes are not zero";
    if (entry.lower_bound == 0) return "the lower bound is 0";
    if (entry.hexahedra < entry.lower_bound) {
      return "the number of hexahedra is below the lower bound";
    }
    return decode_key(entry.key, quads, boundary);
  }

  std::string judge_mesh(const Boundary& boundary, const IndexEntry& entry,
                         std::string_view payload) {
    Filling filling;
    std::string broken =
        read_payload(payload, boundary.quads, entry.hexahedra, entry.interior, filling);
    if (!broken.empty()) return broken;
    std::vector<Quad> found;
    const Verdict verdict =
        judge_cells(filling.cells, filling.vertex_count, {}, filling.removal_order, found);
    if (!verdict.accepted) return verdict.reason;
    if (sorted_cycles(found) != sorted_cycles(boundary.quads)) {
      return "the boundary of the mesh is not that of the key";
    }
    if (verdict.interior_vertices != entry.interior) {
      return "the number of interior vertices is not that of the mesh";
    }
    ++verdict_.judged_meshes;
    return {};
  }

  /// Each key is canonical, of another class than the others, and 3-connected, so the sums are
  /// equal exactly when no class is missing.
  std::string judge_completeness() {
    const auto sum_at = [&](std::uint32_t quads) {
      for (const TableRow& row : verdict_.by_quads) {
        if (row.quads == quads) return row.rooted_sum;
      }
      return std::uint64_t{0};
    };
    for (std::uint32_t n = 6; n <= kMostCountedQuads && sum_at(n) == rooted_all()[n]; n += 2) {
      verdict_.complete_through = n;
    }
    if (layout_.complete_through <= verdict_.complete_through) return {};
    const std::string claim = "complete through " + std::to_string(layout_.complete_through) +
                              " quads, as the table claims, ";
    if (layout_.complete_through > kMostCountedQuads) {
      return claim + "is more than can be judged";
    }
    const std::uint32_t n = std::max(verdict_.complete_through + 2, 6U);
    return claim + "it is not: with " + std::to_string(n) + " quads the rooted sum is " +
           std::to_string(sum_at(n)) + " of " + std::to_string(rooted_all()[n]);
  }

  void count(const IndexEntry& entry, unsigned automorphisms) {
    TableRow& row = verdict_.by_quads.back();
    const std::uint32_t hexahedra = entry.hexahedra;
    if (entry.lower_bound > 1) ++verdict_.claimed_bounds;
    row.rooted_sum += std::uint64_t{8} * row.quads / automorphisms;
    row.least_hexahedra = row.entries == 0 ? hexahedra : std::min(row.least_hexahedra, hexahedra);
    row.greatest_hexahedra = std::max(row.greatest_hexahedra, hexahedra);
    row.total_hexahedra += hexahedra;
    ++row.entries;
  }

  std::string_view bytes_;
  TableShare share_;
  TableLayout layout_;
  TableVerdict verdict_;
  std::string block_;
  std::vector<std::string_view> payloads_;
};

}  // namespace

TableVerdict check_table_bytes(std::string_view bytes, TableShare share) {
  return TableJudge(bytes, share).judge();
}

TableVerdict check_table(const std::filesystem::path& path) {
  return check_table_bytes(bytes_of_file(path));
}

}  // namespace hexatlas::check
