#include "tables/check/quad_code.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "tables/check/disjoint_sets.hpp"

namespace hexatlas::check {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Side i of a quad is the edge from its vertex i to its vertex i + 1.
struct Side {
  std::uint32_t quad = 0;
  unsigned side = 0;
};

/// A quadrangulation of the sphere with the other quad at each side.
struct Sphere {
  std::span<const Quad> quads;
  std::vector<std::array<Side, 4>> across;
  std::vector<unsigned> degree;
};

std::optional<Sphere> sphere_of(std::span<const Quad> quads) {
  Sphere sphere{quads, std::vector<std::array<Side, 4>>(quads.size()),
                std::vector<unsigned>(quads.size() + 2, 0)};
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides;
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t from = quads[q][i];
      const std::uint32_t to = quads[q][(i + 1) % 4];
      if (from >= sphere.degree.size() || from == quads[q][(i + 2) % 4]) return std::nullopt;
      if (!sides.emplace(std::pair(from, to), Side{q, i}).second) return std::nullopt;
      ++sphere.degree[from];
    }
  }
  DisjointSets components(quads.size());
  for (const auto& [edge, side] : sides) {
    const auto other = sides.find({edge.second, edge.first});
    if (other == sides.end()) return std::nullopt;
    sphere.across[side.quad][side.side] = other->second;
    components.unite(side.quad, other->second.quad);
  }
  // Closed, connected, with 2 n edges and n quads on n + 2 vertices: Euler characteristic 2. Each
  // vertex has one cycle of quads, else splitting it would give a surface of characteristic
  // above 2.
  const bool all_used = std::count(sphere.degree.begin(), sphere.degree.end(), 0U) == 0;
  if (quads.empty() || components.sets() != 1 || !all_used) return std::nullopt;
  return sphere;
}

/// A flag: the corner of a quad, and the orientation in which quads are read.
struct Flag {
  std::uint32_t quad = 0;
  unsigned corner = 0;
  bool mirrored = false;
};

/// Vertices (v, a, w, b) of the quad from the corner on, counter-clockwise in the orientation.
Quad read_from(const Sphere& sphere, const Flag& flag) {
  Quad read{};
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned step = flag.mirrored ? 4 - i : i;
    read[i] = sphere.quads[flag.quad][(flag.corner + step) % 4];
  }
  return read;
}

/// The corner at the same vertex v in the other quad at the edge {v, b}. That edge is the side that
/// ends at v, or in the mirrored orientation the side that begins there.
Flag turned(const Sphere& sphere, const Flag& flag) {
  const unsigned side = flag.mirrored ? flag.corner : (flag.corner + 3) % 4;
  const Side other = sphere.across[flag.quad][side];
  return {other.quad, flag.mirrored ? (other.side + 1) % 4 : other.side, flag.mirrored};
}

Flag opposite(const Flag& flag) { return {flag.quad, (flag.corner + 2) % 4, flag.mirrored}; }

enum class State : std::uint8_t { kNew, kTree, kOpen };

/// The walk of code.md: its word, and the quads in the order of their first meeting.
struct Walk {
  CodeWord word;
  std::vector<Quad> met;
};

Walk walk_from(const Sphere& sphere, Flag at) {
  Walk walk;
  std::vector<State> state(sphere.quads.size(), State::kNew);
  std::vector<bool> reached(sphere.degree.size(), false);
  reached[sphere.quads[at.quad][at.corner]] = true;
  for (std::size_t step = 0; step < 2 * sphere.quads.size(); ++step) {
    const Quad read = read_from(sphere, at);
    if (state[at.quad] == State::kNew) {
      walk.met.push_back(read);
      const bool tree = !reached[read[2]];
      walk.word.push_back(tree ? 0 : 2);
      state[at.quad] = tree ? State::kTree : State::kOpen;
      reached[read[2]] = true;
      if (tree) at = opposite(at);
    } else {
      const bool tree = state[at.quad] == State::kTree;
      walk.word.push_back(tree ? 1 : 3);
      if (tree) at = opposite(at);
    }
    at = turned(sphere, at);
  }
  return walk;
}

/// Vertices numbered by first appearance.
std::vector<std::uint32_t> labels_by_appearance(const std::vector<Quad>& met, std::size_t count) {
  std::vector<std::uint32_t> labels(count, kNone);
  std::uint32_t next = 0;
  for (const Quad& quad : met) {
    for (const std::uint32_t vertex : quad) {
      if (labels[vertex] == kNone) labels[vertex] = next++;
    }
  }
  return labels;
}

/// The ends of the edges of one colour class, from a word: the other end of each, and the next one
/// counter-clockwise at its vertex. End i belongs to letter i.
struct Ends {
  std::vector<std::size_t> other;
  std::vector<std::size_t> next;
  std::vector<std::uint32_t> vertex;
  std::uint32_t vertices = 0;
};

bool match_ends(std::span<const std::uint8_t> word, Ends& ends) {
  struct TreeEdge {
    std::size_t end;
    std::uint32_t from;
  };
  std::vector<TreeEdge> tree;
  std::vector<std::size_t> open;
  ends.other.resize(word.size());
  ends.vertex.resize(word.size());
  ends.vertices = 1;
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    ends.vertex[i] = at;
    if (word[i] == 0) {
      tree.push_back({i, at});
      at = ends.vertices++;
    } else if (word[i] == 2) {
      open.push_back(i);
    } else if (word[i] == 1 ? tree.empty() : open.empty()) {
      return false;
    } else {
      const std::size_t first = word[i] == 1 ? tree.back().end : open.back();
      if (word[i] == 1) {
        at = tree.back().from;
        tree.pop_back();
      } else {
        open.pop_back();
      }
      ends.other[i] = first;
      ends.other[first] = i;
    }
  }
  return tree.empty() && open.empty();
}

void order_ends(Ends& ends) {
  ends.next.resize(ends.vertex.size());
  std::vector<std::size_t> first(ends.vertices, ends.vertex.size());
  std::vector<std::size_t> last(ends.vertices, ends.vertex.size());
  for (std::size_t i = 0; i < ends.vertex.size(); ++i) {
    const std::uint32_t v = ends.vertex[i];
    if (first[v] == ends.vertex.size()) {
      first[v] = i;
    } else {
      ends.next[last[v]] = i;
    }
    last[v] = i;
  }
  for (std::uint32_t v = 0; v < ends.vertices; ++v) {
    if (last[v] < ends.vertex.size()) ends.next[last[v]] = first[v];
  }
}

/// The graph, and a search in it that leaves out one vertex.
class Graph {
 public:
  explicit Graph(std::span<const Quad> quads) : neighbours_(quads.size() + 2) {
    for (const Quad& quad : quads) {
      for (std::size_t i = 0; i < 4; ++i) {  // the quad across the edge adds the other direction
        neighbours_[quad[i]].push_back(quad[(i + 1) % 4]);
      }
    }
  }

  /// Whether the rest is connected without `absent`, and stays so without any further vertex.
  bool stays_two_connected_without(std::uint32_t absent) {
    depth_.assign(neighbours_.size(), 0);
    absent_ = absent;
    reached_ = 0;
    cut_ = false;
    (void)search(absent == 0 ? 1 : 0, 1);
    return !cut_ && reached_ + 1 == neighbours_.size();
  }

 private:
  /// Depth first from `at`; the least depth of a neighbour of what is found. A vertex separates
  /// what is found from one of its children if that reaches no higher than the vertex itself; the
  /// first vertex, which nothing lies above, separates if it has two children.
  std::size_t search(std::uint32_t at, std::size_t depth) {
    depth_[at] = depth;
    ++reached_;
    std::size_t least = depth;
    std::size_t children = 0;
    for (const std::uint32_t next : neighbours_[at]) {
      if (next == absent_) continue;
      if (depth_[next] != 0) {
        least = std::min(least, depth_[next]);
        continue;
      }
      const std::size_t reach = search(next, depth + 1);
      least = std::min(least, reach);
      cut_ = cut_ || (depth == 1 ? ++children > 1 : reach >= depth);
    }
    return least;
  }

  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::vector<std::size_t> depth_;  ///< from 1; 0: not found yet
  std::uint32_t absent_ = kNone;
  std::size_t reached_ = 0;
  bool cut_ = false;
};

bool shares_at_most_an_edge(const Quad& p, const Quad& q) {
  std::array<std::pair<unsigned, unsigned>, 16> shared;
  std::size_t count = 0;
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned j = 0; j < 4; ++j) {
      if (p[i] == q[j]) shared[count++] = {i, j};
    }
  }
  if (count < 2) return true;
  return count == 2 && (shared[0].first + shared[1].first) % 2 == 1 &&
         (shared[0].second + shared[1].second) % 2 == 1;
}

}  // namespace

std::optional<CanonicalCode> canonical_code(std::span<const Quad> quads) {
  const std::optional<Sphere> sphere = sphere_of(quads);
  if (!sphere) return std::nullopt;
  CanonicalCode code;
  std::array<unsigned, 4> greatest = {};
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    for (unsigned choice = 0; choice < 8; ++choice) {
      const Flag flag{q, choice % 4, choice >= 4};
      std::array<unsigned, 4> degrees{};
      const Quad read = read_from(*sphere, flag);
      for (std::size_t i = 0; i < 4; ++i) degrees[i] = sphere->degree[read[i]];
      if (degrees < greatest) continue;
      Walk walk = walk_from(*sphere, flag);
      const bool better = degrees > greatest || walk.word < code.word;
      greatest = degrees;
      if (!better && walk.word == code.word) ++code.automorphisms;
      if (!better) continue;
      code = {std::move(walk.word), labels_by_appearance(walk.met, quads.size() + 2), flag.mirrored,
              1};
    }
  }
  return code;
}

std::optional<std::vector<Quad>> decode_word(std::span<const std::uint8_t> word,
                                             std::string& reason) {
  const auto refuse = [&reason](const char* why) {
    reason = why;
    return std::nullopt;
  };
  Ends ends;
  if (word.empty() || !match_ends(word, ends)) return refuse("the parentheses do not balance");
  order_ends(ends);
  // The face between an end and the next one at its vertex is kept along i -> other(next(i)).
  std::vector<std::uint32_t> face(word.size(), kNone);
  std::uint32_t vertices = ends.vertices;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (face[i] != kNone) continue;
    for (std::size_t j = i; face[j] == kNone; j = ends.other[ends.next[j]]) face[j] = vertices;
    ++vertices;
  }
  if (vertices != word.size() / 2 + 2) return refuse("it encodes no sphere");
  std::vector<Quad> quads;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] != 0 && word[i] != 2) continue;
    const std::size_t other = ends.other[i];
    quads.push_back({ends.vertex[i], face[other], ends.vertex[other], face[i]});
  }
  const std::vector<std::uint32_t> labels = labels_by_appearance(quads, vertices);
  for (Quad& quad : quads) {
    for (std::uint32_t& vertex : quad) vertex = labels[vertex];
    if (quad[0] == quad[2] || quad[1] == quad[3]) return refuse("a quad has a vertex twice");
  }
  return quads;
}

bool is_three_connected_by_removal(std::span<const Quad> quads) {
  Graph graph(quads);
  for (std::uint32_t v = 0; v < quads.size() + 2; ++v) {
    if (!graph.stays_two_connected_without(v)) return false;
  }
  return true;
}

bool is_three_connected_by_quads(std::span<const Quad> quads) {
  for (std::size_t p = 0; p < quads.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      if (!shares_at_most_an_edge(quads[p], quads[q])) return false;
    }
  }
  return true;
}

std::string code_text(std::span<const std::uint8_t> word) {
  std::string text = "q1:";
  for (std::size_t i = 0; i + 1 < word.size(); i += 2) {
    text += "0123456789abcdef"[4U * word[i] + word[i + 1]];
  }
  return text;
}

std::string key_of_word(std::span<const std::uint8_t> word) {
  std::string key((word.size() + 3) / 4, '\0');
  for (std::size_t i = 0; i < word.size(); ++i) {
    const unsigned bits = static_cast<unsigned>(word[i]) << (6 - 2 * (i % 4));
    key[i / 4] = static_cast<char>(static_cast<unsigned char>(key[i / 4]) | bits);
  }
  return key;
}

std::optional<CodeWord> word_of_key(std::string_view key, std::size_t quads) {
  if (key.size() != (quads + 1) / 2) return std::nullopt;
  CodeWord word;
  for (const char byte : key) {
    for (int shift = 6; shift >= 0; shift -= 2) {
      word.push_back(static_cast<std::uint8_t>(static_cast<unsigned char>(byte) >> shift & 3));
    }
  }
  for (std::size_t i = 2 * quads; i < word.size(); ++i) {
    if (word[i] != 0) return std::nullopt;
  }
  word.resize(2 * quads);
  return word;
}

}  // namespace hexatlas::check
