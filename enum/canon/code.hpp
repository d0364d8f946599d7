#pragma once
/// \file
/// Canonical codes of quadrangulations of the sphere.
///
/// Definition. docs/formats/code.md: the least word, over the flags with the greatest degrees,
/// of a depth-first walk around the plane map whose vertices are one colour class and whose
/// edges are the quads. Two bits per letter, two letters per quad, so n quads take n
/// hexadecimal digits. Two quadrangulations have equal codes if and only if they are
/// isomorphic, mirror images identified (docs/theory/proofs/canonical-code.md).
///
/// Sources. The contour code of a plane map with a spanning tree is R. C. Mullin's (Canad. J.
/// Math. 19, 1967); taking the least over all flags is L. Weinberg's (IEEE Trans. Circuit Theory
/// 13, 1966).

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::canon {

/// The code of a quadrangulation. Ordered by the number of quads, then by the word.
struct Code {
  std::uint8_t quads = 0;
  /// Two letters per hexadecimal digit, 32 letters per element, the first letter highest.
  std::array<std::uint64_t, 4> words{};

  friend auto operator<=>(const Code&, const Code&) = default;
};

/// ceil(quads / 2): the length of the binary form.
[[nodiscard]] constexpr std::size_t binary_size(int quads) noexcept {
  return static_cast<std::size_t>(quads + 1) / 2;
}

/// Two digits per byte, as in docs/formats/code.md. Compares as the codes do.
[[nodiscard]] std::string to_binary(const Code& code);
[[nodiscard]] std::optional<Code> from_binary(int quads, std::string_view bytes);

/// "q1:" and one hexadecimal digit per quad.
[[nodiscard]] std::string to_text(const Code& code);
/// nullopt if the text is not of this form. The word itself is checked by decode().
[[nodiscard]] std::optional<Code> from_text(std::string_view text);

/// A flag: a dart and an orientation of the sphere.
struct Flag {
  complex::Dart dart = 0;
  bool mirrored = false;
};

/// New number of each vertex.
using Labelling = std::array<complex::Vertex, complex::kMaxVertices>;

struct CanonicalForm {
  Code code;
  Labelling label{};         ///< canonical label of each vertex
  bool is_mirrored = false;  ///< the labelling reverses orientation
  int automorphisms = 0;     ///< order of the group, mirror symmetries included
  int rotations = 0;         ///< those that keep the orientation
};

/// The canonical form. Requires a valid quadrangulation (any connectivity, multiple edges
/// allowed). Prefers a labelling that keeps the orientation where both attain the code.
/// Cost: O(n) per candidate flag, at most 8n of them, usually few.
[[nodiscard]] CanonicalForm canonical_form(const complex::Quadrangulation& q);

/// All flags that attain the code: one per automorphism, in increasing order of (mirrored, dart).
/// Each gives a canonical labelling by labelling_from().
struct CanonicalFlags {
  Code code;
  std::array<Flag, 8 * complex::kMaxQuads> flags;
  int count = 0;
};
void canonical_flags(const complex::Quadrangulation& q, CanonicalFlags& result);
[[nodiscard]] Labelling labelling_from(const complex::Quadrangulation& q, Flag flag);
/// For each of the labels 0 .. vertices-1 the vertex that has it. Requires that each one has.
[[nodiscard]] Labelling inverse_of(const Labelling& label, int vertices);

/// The quadrangulation of a word, whose list of quads is the canonical list if the word is a
/// code. nullopt if the word is not the contour of a quadrangulation of the sphere.
/// Not promised: that the word is canonical; compare with canonical_form().
[[nodiscard]] std::optional<complex::Quadrangulation> decode(const Code& code);

}  // namespace hexatlas::canon

template <>
struct std::hash<hexatlas::canon::Code> {
  [[nodiscard]] std::size_t operator()(const hexatlas::canon::Code& code) const noexcept {
    std::uint64_t h = code.quads;
    for (const std::uint64_t word : code.words) {
      h = (h ^ word) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29U;
    }
    return static_cast<std::size_t>(h);
  }
};
