#include "enum/canon/code.hpp"

#include <algorithm>
#include <bitset>

#include "enum/core/checks.hpp"

namespace hexatlas::canon {
namespace {

using complex::Dart;
using complex::kMaxQuads;
using complex::kMaxVertices;
using complex::Quadrangulation;
using complex::Vertex;

constexpr int kLettersPerWord = 32;
constexpr int kMaxLetters = 2 * kMaxQuads;

enum class Letter : std::uint8_t { down = 0, up = 1, open = 2, close = 3 };

constexpr std::uint64_t place(Letter letter, int index) noexcept {
  const int shift = 62 - 2 * (index % kLettersPerWord);
  return static_cast<std::uint64_t>(letter) << static_cast<unsigned>(shift);
}

constexpr Letter letter_at(const Code& code, int index) noexcept {
  const int shift = 62 - 2 * (index % kLettersPerWord);
  const std::uint64_t word = code.words[static_cast<std::size_t>(index / kLettersPerWord)];
  return static_cast<Letter>(word >> static_cast<unsigned>(shift) & 3U);
}

/// Next corner at the vertex stood at, counter-clockwise in the orientation of the walk.
template <bool kMirrored>
Dart turn(const Quadrangulation& q, Dart d) noexcept {
  return kMirrored ? q.turn_right(d) : q.turn_left(d);
}

/// The walk of docs/formats/code.md. Calls on_letter(letter, corner) at each step, before the
/// action, until it returns false.
template <bool kMirrored, class OnLetter>
void walk(const Quadrangulation& q, Dart start, OnLetter&& on_letter) {
  enum : std::uint8_t { kNew, kTree, kOpen };
  std::array<std::uint8_t, kMaxQuads> state{};
  std::bitset<128> reached;
  reached.set(q.origin(start));
  Dart corner = start;
  for (int step = 0; step < 2 * q.quads(); ++step) {
    std::uint8_t& quad = state[Quadrangulation::quad_of(corner)];
    const Dart across = Quadrangulation::opposite(corner);
    Letter letter = Letter::close;
    Dart after = corner;
    if (quad == kNew) {
      const bool is_reached = reached[q.origin(across)];
      letter = is_reached ? Letter::open : Letter::down;
      quad = is_reached ? kOpen : kTree;
      reached.set(q.origin(across));
      if (!is_reached) after = across;
    } else if (quad == kTree) {
      letter = Letter::up;
      after = across;
    }
    if (!on_letter(letter, corner)) return;
    corner = turn<kMirrored>(q, after);
  }
}

/// Compares the word of a flag with the least so far, letter by letter, and replaces it if
/// the new one is less. Gives up at the first greater letter.
class LeastWord {
 public:
  explicit LeastWord(int quads) { code_.quads = static_cast<std::uint8_t>(quads); }

  /// Negative: a new least word; zero: the least word again; positive: a greater one.
  template <bool kMirrored>
  int offer(const Quadrangulation& q, Dart start) {
    int index = 0;
    int order = empty_ ? -1 : 0;
    Code word{.quads = code_.quads};
    walk<kMirrored>(q, start, [&](Letter letter, Dart) {
      if (order == 0) {
        const Letter least = letter_at(code_, index);
        if (letter != least) order = letter < least ? -1 : 1;
      }
      word.words[static_cast<std::size_t>(index / kLettersPerWord)] |= place(letter, index);
      ++index;
      return order <= 0;
    });
    if (order < 0) code_ = word;
    empty_ = false;
    return order;
  }
  [[nodiscard]] const Code& code() const noexcept { return code_; }

 private:
  Code code_;
  bool empty_ = true;
};

/// (deg v, deg a, deg w, deg b) of a flag as one number, at most 255 each.
class DegreeKeys {
 public:
  explicit DegreeKeys(const Quadrangulation& q) : q_(q), degree_(q.degrees()) {}
  [[nodiscard]] std::uint32_t operator()(Flag flag) const noexcept {
    const Dart d = flag.dart;
    const std::uint32_t v = at(d);
    const std::uint32_t a = at(Quadrangulation::next(d));
    const std::uint32_t w = at(Quadrangulation::opposite(d));
    const std::uint32_t b = at(Quadrangulation::prev(d));
    return flag.mirrored ? v << 24U | b << 16U | w << 8U | a : v << 24U | a << 16U | w << 8U | b;
  }
  [[nodiscard]] std::uint32_t at(Dart d) const noexcept { return degree_[q_.origin(d)]; }

 private:
  const Quadrangulation& q_;
  std::array<std::uint8_t, kMaxVertices> degree_;
};

/// Flags with the greatest degree key, darts ascending, plain before mirrored.
void greatest_flags(const Quadrangulation& q, CanonicalFlags& result) {
  const DegreeKeys key(q);
  std::uint32_t greatest = 0;
  result.count = 0;
  for (const bool mirrored : {false, true})
    for (int i = 0; i < q.darts(); ++i) {
      const Flag flag{static_cast<Dart>(i), mirrored};
      if (key.at(flag.dart) < greatest >> 24U) continue;
      const std::uint32_t k = key(flag);
      if (k < greatest) continue;
      if (k > greatest) result.count = 0;
      greatest = k;
      result.flags[static_cast<std::size_t>(result.count++)] = flag;
    }
}

template <bool kMirrored>
Labelling label(const Quadrangulation& q, Dart start) {
  Labelling result{};
  std::bitset<128> labelled;
  std::bitset<kMaxQuads> met;
  Vertex next = 0;
  const auto number = [&](Vertex v) {
    if (labelled[v]) return;
    labelled.set(v);
    result[v] = next++;
  };
  walk<kMirrored>(q, start, [&](Letter, Dart d) {
    if (met[Quadrangulation::quad_of(d)]) return true;
    met.set(Quadrangulation::quad_of(d));
    number(q.origin(d));
    number(q.origin(kMirrored ? Quadrangulation::prev(d) : Quadrangulation::next(d)));
    number(q.origin(Quadrangulation::opposite(d)));
    number(q.origin(kMirrored ? Quadrangulation::next(d) : Quadrangulation::prev(d)));
    return true;
  });
  return result;
}

/// The ends of the edges of a plane map, one per letter, read from a word.
struct Contour {
  std::array<int, kMaxLetters> mate{};       ///< the other end of the same edge
  std::array<int, kMaxLetters> successor{};  ///< next end counter-clockwise at the same vertex
  std::array<Vertex, kMaxLetters> vertex{};
  int vertices = 0;
};

std::optional<Contour> read_contour(const Code& code) {
  Contour c;
  const int letters = 2 * code.quads;
  std::array<int, kMaxLetters> first{}, last{}, tree{}, open{};
  std::array<Vertex, kMaxLetters> parent{};
  int tree_size = 0, open_size = 0;
  Vertex here = 0;
  c.vertices = 1;
  first.fill(-1);
  for (int i = 0; i < letters; ++i) {
    c.vertex[i] = here;
    if (first[here] < 0)
      first[here] = i;
    else
      c.successor[last[here]] = i;
    last[here] = i;
    const Letter letter = letter_at(code, i);
    if (letter == Letter::down) {
      parent[tree_size] = here;
      tree[tree_size++] = i;
      here = static_cast<Vertex>(c.vertices++);
    } else if (letter == Letter::open) {
      open[open_size++] = i;
    } else {
      int& size = letter == Letter::up ? tree_size : open_size;
      if (size == 0) return std::nullopt;
      const int start = letter == Letter::up ? tree[--size] : open[--size];
      if (letter == Letter::up) here = parent[size];
      c.mate[i] = start;
      c.mate[start] = i;
    }
  }
  if (tree_size != 0 || open_size != 0) return std::nullopt;
  for (int v = 0; v < c.vertices; ++v) c.successor[last[v]] = first[v];
  return c;
}

constexpr std::string_view kTextPrefix = "q1:";
constexpr std::string_view kDigits = "0123456789abcdef";

std::uint64_t digit_at(const Code& code, int index) noexcept {
  return code.words[static_cast<std::size_t>(index / 16)] >> (60U - 4U * (index % 16U)) & 15U;
}

void set_digit(Code& code, int index, std::uint64_t digit) noexcept {
  code.words[static_cast<std::size_t>(index / 16)] |= digit << (60U - 4U * (index % 16U));
}

}  // namespace

std::string to_binary(const Code& code) {
  std::string result(binary_size(code.quads), '\0');
  for (int i = 0; i < code.quads; ++i) {
    const auto digit = static_cast<unsigned>(digit_at(code, i));
    auto& byte = result[static_cast<std::size_t>(i / 2)];
    byte = static_cast<char>(static_cast<unsigned char>(byte) | (i % 2 == 0 ? digit << 4U : digit));
  }
  return result;
}

std::optional<Code> from_binary(int quads, std::string_view bytes) {
  if (quads < 1 || quads > kMaxQuads || bytes.size() != binary_size(quads)) return std::nullopt;
  Code code{.quads = static_cast<std::uint8_t>(quads)};
  for (int i = 0; i < 2 * static_cast<int>(bytes.size()); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[static_cast<std::size_t>(i / 2)]);
    const std::uint64_t digit = i % 2 == 0 ? byte >> 4U : byte & 15U;
    if (i < quads)
      set_digit(code, i, digit);
    else if (digit != 0)
      return std::nullopt;
  }
  return code;
}

std::string to_text(const Code& code) {
  std::string result(kTextPrefix);
  for (int i = 0; i < code.quads; ++i) result += kDigits[digit_at(code, i)];
  return result;
}

std::optional<Code> from_text(std::string_view text) {
  if (!text.starts_with(kTextPrefix)) return std::nullopt;
  text.remove_prefix(kTextPrefix.size());
  if (text.empty() || text.size() > kMaxQuads) return std::nullopt;
  Code code{.quads = static_cast<std::uint8_t>(text.size())};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = kDigits.find(text[i]);
    if (digit == std::string_view::npos) return std::nullopt;
    set_digit(code, static_cast<int>(i), digit);
  }
  return code;
}

void canonical_flags(const Quadrangulation& q, CanonicalFlags& result) {
  core::expects(q.quads() >= 1, "a quadrangulation has a quad");
  greatest_flags(q, result);
  LeastWord least(q.quads());
  int kept = 0;
  for (int i = 0; i < result.count; ++i) {
    const Flag flag = result.flags[static_cast<std::size_t>(i)];
    const int order =
        flag.mirrored ? least.offer<true>(q, flag.dart) : least.offer<false>(q, flag.dart);
    if (order > 0) continue;
    if (order < 0) kept = 0;
    result.flags[static_cast<std::size_t>(kept++)] = flag;
  }
  result.count = kept;
  result.code = least.code();
}

Labelling labelling_from(const Quadrangulation& q, Flag flag) {
  return flag.mirrored ? label<true>(q, flag.dart) : label<false>(q, flag.dart);
}

CanonicalForm canonical_form(const Quadrangulation& q) {
  CanonicalFlags all;
  canonical_flags(q, all);
  CanonicalForm result;
  result.code = all.code;
  result.label = labelling_from(q, all.flags[0]);
  result.is_mirrored = all.flags[0].mirrored;
  result.automorphisms = all.count;
  const auto same_orientation = [&](const Flag& f) { return f.mirrored == result.is_mirrored; };
  result.rotations = static_cast<int>(
      std::count_if(all.flags.begin(), all.flags.begin() + all.count, same_orientation));
  return result;
}

std::optional<Quadrangulation> decode(const Code& code) {
  if (code.quads < 1 || code.quads > kMaxQuads) return std::nullopt;
  const auto contour = read_contour(code);
  if (!contour) return std::nullopt;
  const int letters = 2 * code.quads;

  // Dart at each end: of its quad (v, a, w, b), v -> a if the end was met first, else w -> b.
  std::array<Dart, kMaxLetters> dart_of{};
  int quads = 0;
  for (int i = 0; i < letters; ++i)
    dart_of[i] = contour->mate[i] > i ? Quadrangulation::dart(quads++, 0)
                                      : Quadrangulation::opposite(dart_of[contour->mate[i]]);
  std::array<Dart, complex::kMaxDarts> twin{};
  for (int i = 0; i < letters; ++i) {
    const Dart before = Quadrangulation::prev(dart_of[i]);
    twin[before] = dart_of[contour->successor[i]];
    twin[dart_of[contour->successor[i]]] = before;
  }

  // Vertices are the orbits of darts around a point; numbered by first appearance.
  const int darts = 4 * code.quads;
  std::array<Vertex, complex::kMaxDarts> origin{};
  std::bitset<complex::kMaxDarts> met;
  int vertices = 0;
  for (int i = 0; i < darts; ++i) {
    if (met[i]) continue;
    if (vertices == kMaxVertices) return std::nullopt;
    for (auto d = static_cast<Dart>(i); !met[d]; d = twin[Quadrangulation::prev(d)]) {
      met.set(d);
      origin[d] = static_cast<Vertex>(vertices);
    }
    ++vertices;
  }
  const auto size = static_cast<std::size_t>(darts);
  auto result = Quadrangulation::from_darts({origin.data(), size}, {twin.data(), size}, vertices);
  if (result.validate()) return std::nullopt;
  return result;
}

}  // namespace hexatlas::canon
