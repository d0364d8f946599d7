#include <bitset>

#include "enum/canon/code.hpp"
#include "enum/canon/letters.hpp"

namespace hexatlas::canon {
namespace {

using complex::Dart;
using complex::kMaxVertices;
using complex::Quadrangulation;
using complex::Vertex;

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

}  // namespace

std::optional<Quadrangulation> decode(const Code& code) {
  if (code.quads < 1 || code.quads > complex::kMaxQuads) return std::nullopt;
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
