#pragma once
/// \file
/// The canonical code of a quadrangulation (docs/formats/code.md), from its definition and as
/// plainly as possible: all flags are tried.
///
/// Preconditions are named below. Errors: none; refusals are values. Cost: O(n^2) each.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

/// The letters 0 .. 3 of a code.
using CodeWord = std::vector<std::uint8_t>;

struct CanonicalCode {
  CodeWord word;
  std::vector<std::uint32_t> labels;  ///< canonical label of each vertex, for one best flag
  bool is_mirrored = false;           ///< that flag reads the quads clockwise
  unsigned automorphisms = 0;         ///< flags that attain the word, mirror symmetries included
};

/// The code of the quadrangulation with these quads, all counter-clockwise or all clockwise.
/// Nothing if the quads are not a connected closed oriented surface of Euler characteristic 2
/// without double edges, on the vertices 0 .. n + 1.
[[nodiscard]] std::optional<CanonicalCode> canonical_code(std::span<const Quad> quads);

/// The canonical list of quads of a word; nothing, and the reason, if it encodes no sphere. Not
/// promised: that the word is canonical.
[[nodiscard]] std::optional<std::vector<Quad>> decode_word(std::span<const std::uint8_t> word,
                                                           std::string& reason);

/// Whether the graph stays connected when any two vertices are removed. Requires quads that are
/// coherently oriented, each edge in two of them, on the vertices 0 .. n + 1; recursion as deep as
/// n.
[[nodiscard]] bool is_three_connected_by_removal(std::span<const Quad> quads);
/// Whether any two quads share nothing, one vertex, or the two ends of an edge of both. For a
/// sphere of quads this is equivalent (facets of a 3-connected planar graph meet in a face).
[[nodiscard]] bool is_three_connected_by_quads(std::span<const Quad> quads);

/// "q1:" and the hexadecimal digits of the word.
[[nodiscard]] std::string code_text(std::span<const std::uint8_t> word);
/// The binary form, ceil(n / 2) bytes for 2 n letters, and back; nothing if an unused half byte is
/// not zero or the number of bytes is wrong.
[[nodiscard]] std::string key_of_word(std::span<const std::uint8_t> word);
[[nodiscard]] std::optional<CodeWord> word_of_key(std::string_view key, std::size_t quads);

}  // namespace hexatlas::check
