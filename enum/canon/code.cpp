#include "enum/canon/code.hpp"

#include <algorithm>
#include <bitset>

#include "enum/canon/letters.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::canon {
namespace {

using complex::Dart;
using complex::kMaxVertices;
using complex::Quadrangulation;
using complex::Vertex;

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
  std::array<std::uint8_t, complex::kMaxQuads> state{};
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
  std::bitset<complex::kMaxQuads> met;
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

}  // namespace

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

Labelling inverse_of(const Labelling& label, int vertices) {
  Labelling result{};
  for (std::size_t v = 0; v < static_cast<std::size_t>(vertices); ++v)
    result[label[v]] = static_cast<Vertex>(v);
  return result;
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

}  // namespace hexatlas::canon
