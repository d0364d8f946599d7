#include "enum/quads/symmetry.hpp"

#include <algorithm>
#include <bitset>

namespace hexatlas::quads {
namespace {

template <bool kMirrored>
Dart turn(const PlanarMap& map, Dart d) noexcept {
  return kMirrored ? map.cw[d] : map.ccw[d];
}

/// Calls on_letter(letter) for each letter of the code of a flag until it returns false.
template <bool kMirrored, class OnLetter>
void walk(const PlanarMap& map, Dart start, OnLetter&& on_letter) noexcept {
  constexpr std::uint8_t kNotMet = 0xFF;
  std::array<std::uint8_t, complex::kMaxVertices> number{};
  std::array<Dart, complex::kMaxVertices> entry{};  // the first `met` are set
  std::fill_n(number.begin(), map.vertices, kNotMet);
  number[map.origin[start]] = 0;
  entry[0] = start;
  int met = 1;
  for (int i = 0; i < map.vertices; ++i) {
    Dart d = entry[static_cast<std::size_t>(i)];
    const Dart stop = d;
    do {
      const Vertex v = map.head(d);
      std::uint8_t letter = number[v];
      if (letter == kNotMet) {
        letter = static_cast<std::uint8_t>(map.vertices + map.degree[v]);
        number[v] = static_cast<std::uint8_t>(met);
        entry[static_cast<std::size_t>(met++)] = twin(d);
      }
      if (!on_letter(letter)) return;
      d = turn<kMirrored>(map, d);
    } while (d != stop);
  }
}

using Word = std::array<std::uint8_t, complex::kMaxDarts>;

template <bool kMirrored>
void write(const PlanarMap& map, Dart start, Word& word) noexcept {
  std::size_t i = 0;
  walk<kMirrored>(map, start, [&](std::uint8_t letter) noexcept {
    word[i++] = letter;
    return true;
  });
}

template <bool kMirrored>
int compare(const PlanarMap& map, Dart start, const Word& word) noexcept {
  std::size_t i = 0;
  int order = 0;
  walk<kMirrored>(map, start, [&](std::uint8_t letter) noexcept {
    order = int{letter} - int{word[i++]};
    return order == 0;
  });
  return order;
}

void write(const PlanarMap& map, Flag flag, Word& word) noexcept {
  flag.mirrored ? write<true>(map, flag.dart, word) : write<false>(map, flag.dart, word);
}

/// Negative: the code of the flag is less than the word.
int compare(const PlanarMap& map, Flag flag, const Word& word) noexcept {
  return flag.mirrored ? compare<true>(map, flag.dart, word) : compare<false>(map, flag.dart, word);
}

DartImages images_between(const PlanarMap& map, Flag from, Flag to) {
  DartImages images;
  images.mirrored = from.mirrored != to.mirrored;
  std::bitset<complex::kMaxDarts> known;
  std::vector<Dart> todo{from.dart};
  images.of[from.dart] = to.dart;
  known.set(from.dart);
  const auto learn = [&](Dart d, Dart image) {
    if (known[d]) return;
    known.set(d);
    images.of[d] = image;
    todo.push_back(d);
  };
  while (!todo.empty()) {
    const Dart d = todo.back();
    todo.pop_back();
    const Dart image = images.of[d];
    learn(twin(d), twin(image));
    learn(map.ccw[d], images.mirrored ? map.cw[image] : map.ccw[image]);
  }
  return images;
}

}  // namespace

int Symmetry::rotations() const noexcept {
  return static_cast<int>(std::count_if(flags.begin(), flags.end(), [this](Flag flag) {
    return flag.mirrored == flags[0].mirrored;
  }));
}

bool least_is_ours(const PlanarMap& map, const FlagList& candidates, std::size_t ours,
                   Symmetry& symmetry) noexcept {
  symmetry.flags.clear();
  symmetry.flags.push_back(candidates[0]);
  if (candidates.size() == 1) return true;
  Word least;
  write(map, candidates[0], least);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const Flag flag = candidates[i];
    const int order = compare(map, flag, least);
    if (order > 0) continue;
    if (order < 0) {
      if (i >= ours) return false;
      symmetry.flags.clear();
      write(map, flag, least);
    }
    symmetry.flags.push_back(flag);
  }
  return true;
}

std::vector<DartImages> dart_images(const PlanarMap& map, const Symmetry& symmetry) {
  std::vector<DartImages> result;
  for (const Flag flag : symmetry.flags)
    result.push_back(images_between(map, symmetry.flags[0], flag));
  return result;
}

}  // namespace hexatlas::quads
