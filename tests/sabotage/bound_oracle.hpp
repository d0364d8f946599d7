#pragma once
/// \file
/// A slow reading of docs/formats/bound.md, for tests: each state is a list of hexahedra, from
/// which all that a rule needs is computed anew. It judges logs, and writes some: a naive search
/// that takes any rule that holds.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace hexatlas::sabotage {

using SlowQuad = std::array<int, 4>;
using SlowHex = std::array<int, 8>;
using IntSet = std::set<int>;

struct BoundText {
  std::string code;
  std::vector<SlowQuad> quads;
  bool is_ball = false;
  int hexahedra = 0;
  int interior = 0;
  bool has_symmetry = false;
  std::string log = {};
};

/// Without the frame.
inline std::string text_of(const BoundText& b) {
  std::string text =
      "hexatlas-bound 1\nboundary " + b.code + "\nquads " + std::to_string(b.quads.size()) + "\n";
  for (const SlowQuad& q : b.quads) {
    for (std::size_t i = 0; i < 4; ++i) text += std::to_string(q[i]) + (i < 3 ? " " : "\n");
  }
  return text + "kind " + (b.is_ball ? "ball" : "any") + "\nhexahedra " +
         std::to_string(b.hexahedra) + "\ninterior " + std::to_string(b.interior) + "\nsymmetry " +
         (b.has_symmetry ? "yes" : "no") + "\nlog " + std::to_string(b.log.size()) + "\n" + b.log;
}

/// A Zstandard frame of raw blocks, by hand.
inline std::string framed(const std::string& content) {
  std::string frame = "\x28\xB5\x2F\xFD\xA0";
  for (unsigned i = 0; i < 4; ++i) frame += static_cast<char>(content.size() >> (8 * i) & 255U);
  constexpr std::size_t kBlock = 100'000;
  for (std::size_t at = 0; at == 0 || at < content.size(); at += kBlock) {
    const std::string block = content.substr(at, kBlock);
    const bool is_last = at + kBlock >= content.size();
    const std::size_t head = block.size() << 3U | (is_last ? 1U : 0U);
    for (unsigned i = 0; i < 3; ++i) frame += static_cast<char>(head >> (8 * i) & 255U);
    frame += block;
  }
  return frame;
}

/// The permutations of the vertices that keep the quads, vertex by vertex.
class SlowAutomorphisms {
 public:
  explicit SlowAutomorphisms(const std::vector<SlowQuad>& quads) : map_(quads.size() + 2, -1) {
    for (const SlowQuad& q : quads) {
      facets_.insert(IntSet(q.begin(), q.end()));
      for (std::size_t i = 0; i < 4; ++i) {
        edges_.insert({q[i], q[(i + 1) % 4]});
        edges_.insert({q[(i + 1) % 4], q[i]});
      }
    }
    extend(0);
  }
  std::vector<std::vector<int>> found;

 private:
  void extend(std::size_t v) {
    if (v == map_.size()) {
      for (const IntSet& facet : facets_) {
        IntSet image;
        for (const int u : facet) image.insert(map_[static_cast<std::size_t>(u)]);
        if (!facets_.contains(image)) return;
      }
      found.push_back(map_);
      return;
    }
    for (int w = 0; w < static_cast<int>(map_.size()); ++w) {
      bool fits = std::find(map_.begin(), map_.begin() + static_cast<std::ptrdiff_t>(v), w) ==
                  map_.begin() + static_cast<std::ptrdiff_t>(v);
      for (std::size_t u = 0; u < v && fits; ++u) {
        fits = edges_.contains({static_cast<int>(u), static_cast<int>(v)}) ==
               edges_.contains({map_[u], w});
      }
      if (!fits) continue;
      map_[v] = w;
      extend(v + 1);
    }
  }
  std::set<IntSet> facets_;
  std::set<std::pair<int, int>> edges_;
  std::vector<int> map_;
};

struct SlowFacet {
  SlowQuad corners;
  int missing;  ///< hexahedra that it still takes
  [[nodiscard]] IntSet set() const { return {corners.begin(), corners.end()}; }
  [[nodiscard]] int at(int i) const { return corners[static_cast<std::size_t>((i + 4) % 4)]; }
  [[nodiscard]] int place(int v) const {
    return static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
  }
  [[nodiscard]] bool has(int v) const { return place(v) < 4; }
  [[nodiscard]] bool has_edge(int u, int v) const {
    return has(u) && has(v) && (place(u) + place(v)) % 2 == 1;
  }
};

/// Everything about one state.
class SlowState {
 public:
  enum Kind { kFree, kEdge, kDiagonal, kBody };

  SlowState(const BoundText& text, const std::vector<SlowHex>& hexes)
      : ball_(text.is_ball), n_(static_cast<int>(text.quads.size()) + 2), hexes_(hexes) {
    for (const SlowQuad& q : text.quads) add(q, 1);
    vertices_ = n_;
    for (const SlowHex& h : hexes) {
      for (const int v : h) vertices_ = std::max(vertices_, v + 1);
      for (int a = 0; a < 8; ++a) {
        for (int b = 0; b < a; ++b) pairs_[key(corner(h, a), corner(h, b))] = kind_of(a ^ b);
      }
      for (const SlowQuad& f : facets_of(h)) {
        const auto old = std::find_if(facets_.begin(), facets_.end(), [&f](const SlowFacet& g) {
          return g.set() == IntSet(f.begin(), f.end());
        });
        if (old == facets_.end()) {
          add(f, 1);
        } else {
          --old->missing;
        }
      }
    }
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (facets_[f].missing > 0) open_.push_back(static_cast<int>(f));
    }
    if (ball_) find_colours();
  }

  [[nodiscard]] const std::vector<int>& open() const { return open_; }
  [[nodiscard]] const SlowFacet& facet(int f) const { return facets_[static_cast<std::size_t>(f)]; }

  [[nodiscard]] bool face_budget(int left) const {
    const int f = count(open_);
    return f > 4 * left + 2 * std::min(left, f / 6) || f > 4 * left + 2 * cycles();
  }

  /// Times 12 to stay with integers; then rounded down.
  [[nodiscard]] int room(int left) const {
    int due = 0;
    for (int v = 0; v < vertices_; ++v) {
      int here = 0;
      const int l = open_at(v);
      if (l > 0) here = l - 2 * std::min(savings(v), ear_savings(v));
      if (v >= n_) here = std::max(here, 4 - hexes_at(v));
      due += here;
    }
    int twelfths = 3 * (8 * left - due);
    if (ball_) {
      int e = -1 + vertices_ + count(facets_) - count(hexes_);
      int u = 0;
      for (const auto& [pair, kind] : pairs_) {
        if (kind != kEdge) continue;
        --e;
        const std::vector<int> both = open_with(pair.first, pair.second);
        if (both.size() == 2 && !fit(both[0], both[1])) ++u;
      }
      twelfths = std::min(twelfths, 4 * (6 * left - 3 * e - u) - 2 * count(open_));
    }
    int rounded = twelfths / 12;
    while (12 * rounded > twelfths) --rounded;
    return rounded;
  }

  [[nodiscard]] bool bad_link() const {
    if (!ball_ || hexes_.empty()) return false;
    for (const int v : hexes_.back()) {
      const int l = open_at(v);
      if (l == 0 ? savings(v) != 0 : 3 * savings(v) > l) return true;
    }
    return false;
  }

  [[nodiscard]] bool apart(int f, int g) const {
    const SlowFacet& a = facet(f);
    const SlowFacet& b = facet(g);
    std::vector<int> common;
    for (const int v : a.corners) {
      if (b.has(v)) common.push_back(v);
    }
    if (common.size() == 1) return true;
    if (common.size() == 2) {
      return !a.has_edge(common[0], common[1]) || !b.has_edge(common[0], common[1]) || !fit(f, g);
    }
    for (int turn = 0; turn < 8; ++turn) {
      bool fits = true;
      for (int i = 0; i < 4; ++i)
        fits = fits && above(b.at(turn < 4 ? turn + i : 7 - turn - i), f, i);
      if (fits) return false;
    }
    return true;
  }

  /// The hexahedra on an open facet with at most `news` new vertices, in order.
  [[nodiscard]] std::vector<SlowHex> children(int f, int news) const {
    std::vector<SlowHex> list;
    std::array<std::vector<int>, 4> tops;
    for (int i = 0; i < 4; ++i) {
      for (int u = 0; u < vertices_; ++u) {
        if (above(u, f, i)) tops[static_cast<std::size_t>(i)].push_back(u);
      }
      tops[static_cast<std::size_t>(i)].push_back(-1);
    }
    for (const int a : tops[0]) {
      for (const int b : tops[1]) {
        for (const int c : tops[2]) {
          for (const int d : tops[3]) {
            SlowHex h{};
            int next = vertices_;
            for (std::size_t i = 0; i < 4; ++i) {
              h[i] = facet(f).corners[i];
              const int top = std::array{a, b, c, d}[i];
              h[i + 4] = top < 0 ? next++ : top;
            }
            if (next - vertices_ <= news && may_be_put(h)) list.push_back(h);
          }
        }
      }
    }
    return list;
  }

  static std::array<SlowQuad, 6> facets_of(const SlowHex& h) {
    return {{{h[0], h[1], h[2], h[3]},
             {h[4], h[5], h[6], h[7]},
             {h[0], h[1], h[5], h[4]},
             {h[1], h[2], h[6], h[5]},
             {h[2], h[3], h[7], h[6]},
             {h[3], h[0], h[4], h[7]}}};
  }

 private:
  template <class List>
  static int count(const List& list) {
    return static_cast<int>(list.size());
  }
  static std::pair<int, int> key(int u, int v) { return std::minmax(u, v); }
  /// Corners by coordinates, one bit each.
  static int corner(const SlowHex& h, int bits) {
    return h[std::array<std::size_t, 8>{0, 1, 3, 2, 4, 5, 7, 6}[static_cast<std::size_t>(bits)]];
  }
  static Kind kind_of(int difference) {
    return std::array{kFree, kEdge, kEdge, kDiagonal, kEdge, kDiagonal, kDiagonal, kBody}
        [static_cast<std::size_t>(difference)];
  }
  void add(const SlowQuad& q, int missing) {
    facets_.push_back({q, missing});
    for (std::size_t i = 0; i < 4; ++i) pairs_[key(q[i], q[(i + 1) % 4])] = kEdge;
    pairs_[key(q[0], q[2])] = kDiagonal;
    pairs_[key(q[1], q[3])] = kDiagonal;
  }
  void find_colours() {
    colour_.assign(static_cast<std::size_t>(vertices_), -1);
    colour_[0] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [pair, kind] : pairs_) {
        if (kind != kEdge) continue;
        for (const auto& [a, b] : {pair, std::pair(pair.second, pair.first)}) {
          int& other = colour_[static_cast<std::size_t>(b)];
          const int own = colour_[static_cast<std::size_t>(a)];
          if (own < 0 || other >= 0) continue;
          other = 1 - own;
          changed = true;
        }
      }
    }
  }

  [[nodiscard]] Kind kind(int u, int v) const {
    const auto found = pairs_.find(key(u, v));
    return found == pairs_.end() ? kFree : found->second;
  }
  [[nodiscard]] bool is(int u, int v, Kind wanted) const {
    return kind(u, v) == kFree || kind(u, v) == wanted;
  }
  [[nodiscard]] std::vector<int> open_with(int u, int v) const {
    std::vector<int> list;
    for (const int f : open_) {
      if (facet(f).has_edge(u, v)) list.push_back(f);
    }
    return list;
  }
  [[nodiscard]] int open_at(int v) const {
    return static_cast<int>(
        std::count_if(open_.begin(), open_.end(), [&](int f) { return facet(f).has(v); }));
  }
  [[nodiscard]] int hexes_at(int v) const {
    return static_cast<int>(std::count_if(hexes_.begin(), hexes_.end(), [v](const SlowHex& h) {
      return std::find(h.begin(), h.end(), v) != h.end();
    }));
  }

  [[nodiscard]] bool above(int u, int f, int i) const {
    const SlowFacet& a = facet(f);
    if (a.has(u) || !is(u, a.at(i), kEdge) || !is(u, a.at(i + 1), kDiagonal) ||
        !is(u, a.at(i - 1), kDiagonal) || kind(u, a.at(i + 2)) != kFree) {
      return false;
    }
    if (!ball_) return true;
    const bool same =
        colour_[static_cast<std::size_t>(u)] == colour_[static_cast<std::size_t>(a.at(i))];
    return !same && open_at(u) > 0 && (kind(u, a.at(i)) == kFree || !open_with(u, a.at(i)).empty());
  }

  [[nodiscard]] bool may_be_put(const SlowHex& h) const {
    if (IntSet(h.begin(), h.end()).size() != 8) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      const int t = h[4 + i];
      const int next = h[4 + (i + 1) % 4];
      if (!is(t, next, kEdge) || !is(t, h[4 + (i + 2) % 4], kDiagonal)) return false;
      if (ball_ && kind(t, next) == kEdge && open_with(t, next).empty()) return false;
    }
    const auto facets = facets_of(h);
    return std::all_of(facets.begin() + 1, facets.end(),
                       [this](const SlowQuad& q) { return may_be_facet(q); });
  }
  [[nodiscard]] bool may_be_facet(const SlowQuad& q) const {
    for (const SlowFacet& f : facets_) {
      bool shares = false;
      bool same = true;
      for (std::size_t i = 0; i < 2; ++i) {
        const std::pair own = key(q[i], q[i + 2]);
        const bool there = own == key(f.at(0), f.at(2)) || own == key(f.at(1), f.at(3));
        shares = shares || there;
        same = same && there;
      }
      if (shares && !(same && f.missing > 0)) return false;
    }
    return true;
  }

  /// The opposite corner of a and b at v belongs to the facet of the diagonal a b, if it is one.
  [[nodiscard]] bool turn(int a, int b, int v) const {
    if (kind(a, b) != kDiagonal) return true;
    return std::any_of(open_.begin(), open_.end(), [&](int f) {
      return facet(f).has(a) && facet(f).has(b) && !facet(f).has_edge(a, b) && facet(f).has(v);
    });
  }
  [[nodiscard]] bool fit(int f, int g) const {
    const SlowFacet& a = facet(f);
    const SlowFacet& b = facet(g);
    for (int i = 0; i < 4; ++i) {
      const int u = a.at(i);
      const int v = a.at(i + 1);
      if (!b.has_edge(u, v)) continue;
      const int x = a.at(i + 2);
      const int y = a.at(i + 3);
      const int step = b.at(b.place(u) + 1) == v ? 1 : -1;
      const int z = b.at(b.place(v) + step);
      const int w = b.at(b.place(u) - step);
      return above(z, f, i + 1 - (i == 3 ? 4 : 0)) && above(w, f, i) && turn(x, z, v) &&
             turn(y, w, u);
    }
    return false;
  }

  [[nodiscard]] int savings(int v) const {
    const int l = open_at(v);
    if (ball_) {
      int e = hexes_at(v) + (v < n_ ? 1 : 0);
      for (const auto& [pair, kind] : pairs_) {
        if (kind == kEdge && (pair.first == v || pair.second == v)) ++e;
      }
      for (const SlowFacet& f : facets_) e -= f.has(v) ? 1 : 0;
      return 2 - e;
    }
    if (l < 6) return l / 3;
    std::map<int, int> part;  // of each neighbour
    for (const int f : open_) {
      if (!facet(f).has(v)) continue;
      for (const int step : {-1, 1}) {
        const int a = facet(f).at(facet(f).place(v) + step);
        part.emplace(a, a);
      }
    }
    int merges = 0;
    for (const int f : open_) {
      if (!facet(f).has(v)) continue;
      const int a = part[facet(f).at(facet(f).place(v) + 1)];
      const int b = part[facet(f).at(facet(f).place(v) - 1)];
      if (a == b) continue;
      ++merges;
      for (auto& [vertex, number] : part) number = number == b ? a : number;
    }
    return std::min(l / 3, l - count(part) + (count(part) - merges));
  }

  [[nodiscard]] int ear_savings(int v) const {
    std::vector<IntSet> ears;
    for (const int f : open_) {
      for (const int g : open_) {
        if (f >= g || !facet(f).has(v) || !facet(g).has(v) || !fit(f, g)) continue;
        ears.push_back({f, g});
      }
    }
    bool disjoint = false;
    bool triangle = false;
    for (const IntSet& a : ears) {
      for (const IntSet& b : ears) {
        IntSet both = a;
        both.insert(b.begin(), b.end());
        disjoint = disjoint || both.size() == 4;
        if (a == b || both.size() != 3) continue;
        for (const IntSet& c : ears) {
          IntSet all = both;
          all.insert(c.begin(), c.end());
          triangle = triangle || (c != a && c != b && all.size() == 3);
        }
      }
    }
    return disjoint ? count(ears) / 2 : (triangle ? 1 : 0);
  }

  /// Facets are added one by one; each one whose edges depend on those before adds a dimension.
  [[nodiscard]] int cycles() const {
    using Edges = std::set<std::pair<int, int>>;
    const auto add_to = [](Edges& a, const Edges& b) {
      for (const auto& e : b) {
        if (!a.erase(e)) a.insert(e);
      }
    };
    std::map<std::pair<int, int>, Edges> basis;  // by the first edge
    int dimension = 0;
    for (const int f : open_) {
      Edges edges;
      for (int i = 0; i < 4; ++i) edges.insert(key(facet(f).at(i), facet(f).at(i + 1)));
      while (!edges.empty() && basis.contains(*edges.begin())) {
        add_to(edges, basis[*edges.begin()]);
      }
      if (edges.empty()) {
        ++dimension;
      } else {
        basis[*edges.begin()] = edges;
      }
    }
    return dimension;
  }

  bool ball_;
  int n_;
  int vertices_ = 0;
  std::vector<SlowHex> hexes_;
  std::map<std::pair<int, int>, Kind> pairs_;
  std::vector<SlowFacet> facets_;
  std::vector<int> open_;
  std::vector<int> colour_;
};

/// What a search wrote of one state and all below it, and the rules 1 .. 4 that refute it.
struct SlowVisit {
  std::size_t begin = 0;
  std::size_t end = 0;
  IntSet rules = {};
};

/// What a search or a judge keeps besides the state.
class SlowBound {
 public:
  explicit SlowBound(BoundText text)
      : text_(std::move(text)), automorphisms_(SlowAutomorphisms(text_.quads).found) {}

  /// Whether the log is what it should be.
  bool judge() {
    at_ = 0;
    hexes_.clear();
    return judge_state() && at_ == text_.log.size();
  }

  /// A log, unless a mesh is found or it needs more than `most` bytes. Rules in random order.
  std::optional<std::string> search(std::uint64_t seed, std::size_t most) {
    random_.seed(seed);
    most_ = most;
    hexes_.clear();
    visits_.clear();
    text_.log.clear();
    if (!search_state()) return std::nullopt;
    return text_.log;
  }
  /// How often each record was written.
  [[nodiscard]] const std::map<int, int>& used() const { return used_; }

  /// The states, in the order of their records.
  [[nodiscard]] const std::vector<SlowVisit>& visits() const { return visits_; }

  /// Whether there is a mesh within the limits, by trying everything on the first open facet; what
  /// is cut off has more open facets than the hexahedra to come have facets. For kind `any`.
  bool has_mesh() {
    const SlowState state(text_, hexes_);
    if (state.open().empty()) return true;
    if (static_cast<int>(state.open().size()) > 6 * left()) return false;
    for (const SlowHex& h : state.children(state.open()[0], text_.interior - interior())) {
      hexes_.push_back(h);
      const bool found = has_mesh();
      hexes_.pop_back();
      if (found) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] int left() const { return text_.hexahedra - static_cast<int>(hexes_.size()); }
  [[nodiscard]] int interior() const {
    int most = 0;
    for (const SlowHex& h : hexes_) {
      for (const int v : h) most = std::max(most, v - 1 - static_cast<int>(text_.quads.size()));
    }
    return most;
  }
  [[nodiscard]] int news(const SlowState& state) const {
    return std::min(text_.interior - interior(), state.room(left()));
  }

  [[nodiscard]] bool less_by_symmetry() const {
    if (!text_.has_symmetry || hexes_.empty()) return false;
    const auto n = static_cast<int>(text_.quads.size()) + 2;
    const SlowHex& first = hexes_.front();
    std::vector<int> least;
    for (std::size_t i = 4; i < 8; ++i) least.push_back(first[i] < n ? first[i] : 255);
    const SlowHex& last = hexes_.back();
    for (const SlowQuad& quad : text_.quads) {
      const IntSet on(quad.begin(), quad.end());
      for (const auto& map : automorphisms_) {
        std::vector<int> type;
        for (std::size_t i = 0; i < 4; ++i) {
          // The vertex of the last hexahedron that goes to corner i, and its neighbour off the
          // quad.
          for (int bits = 0; bits < 8; ++bits) {
            const int v = corner(last, bits);
            if (!on.contains(v) || map[static_cast<std::size_t>(v)] != first[i]) continue;
            for (const int step : {1, 2, 4}) {
              const int top = corner(last, bits ^ step);
              if (!on.contains(top))
                type.push_back(top < n ? map[static_cast<std::size_t>(top)] : 255);
            }
          }
        }
        const bool is_facet = std::all_of(quad.begin(), quad.end(), [&last](int v) {
          return std::find(last.begin(), last.end(), v) != last.end();
        });
        if (is_facet && type.size() == 4 && type < least) return true;
      }
    }
    return false;
  }
  static int corner(const SlowHex& h, int bits) {
    return h[std::array<std::size_t, 8>{0, 1, 3, 2, 4, 5, 7, 6}[static_cast<std::size_t>(bits)]];
  }

  int byte() { return at_ < text_.log.size() ? static_cast<unsigned char>(text_.log[at_++]) : -1; }

  bool judge_state() {
    const SlowState state(text_, hexes_);
    const int record = byte();
    if (state.open().empty()) return record == 3 && state.bad_link();
    if (record == 0) return judge_children(state);
    if (record == 1) return state.face_budget(left());
    if (record == 2) return state.room(left()) < 0;
    if (record == 3) return state.bad_link();
    if (record == 4) return less_by_symmetry();
    if (record != 5) return false;
    std::vector<int> facets;
    for (int i = 0; i <= left(); ++i) {
      const int place = byte();
      if (place < 0 || place >= static_cast<int>(state.open().size())) return false;
      facets.push_back(state.open()[static_cast<std::size_t>(place)]);
    }
    for (const int f : facets) {
      if (std::count(facets.begin(), facets.end(), f) != 1) return false;
      for (const int g : facets) {
        if (f != g && !state.apart(f, g)) return false;
      }
    }
    return true;
  }

  bool judge_children(const SlowState& state) {
    const int place = byte();
    if (left() == 0 || place < 0 || place >= static_cast<int>(state.open().size())) return false;
    for (const SlowHex& h :
         state.children(state.open()[static_cast<std::size_t>(place)], news(state))) {
      hexes_.push_back(h);
      const bool good = judge_state();
      hexes_.pop_back();
      if (!good) return false;
    }
    return true;
  }

  bool search_state() {
    if (text_.log.size() > most_) return false;
    const SlowState state(text_, hexes_);
    if (state.open().empty()) {
      if (state.bad_link()) text_.log += '\3';
      return state.bad_link();
    }
    std::vector<std::string> records;
    if (state.face_budget(left())) records.emplace_back("\1");
    if (state.room(left()) < 0) records.emplace_back("\2");
    if (state.bad_link()) records.emplace_back("\3");
    if (less_by_symmetry()) records.emplace_back("\4");
    const std::size_t own = visits_.size();
    visits_.push_back({text_.log.size(), 0});
    for (const std::string& record : records) visits_[own].rules.insert(record[0]);
    const std::string apart = facets_apart(state);
    if (!apart.empty()) records.push_back(apart);
    bool refuted = true;
    if (records.empty()) {
      refuted = search_children(state);
    } else {
      const std::string& taken = records[random_() % records.size()];
      ++used_[taken[0]];
      text_.log += taken;
    }
    visits_[own].end = text_.log.size();
    return refuted;
  }

  std::string facets_apart(const SlowState& state) {
    std::vector<int> places(state.open().size());
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
    for (int round = 0; round < 3; ++round) {
      std::shuffle(places.begin(), places.end(), random_);
      std::string record = "\5";
      std::vector<int> taken;
      for (const int place : places) {
        const int f = state.open()[static_cast<std::size_t>(place)];
        if (std::all_of(taken.begin(), taken.end(), [&](int g) { return state.apart(f, g); })) {
          taken.push_back(f);
          record += static_cast<char>(place);
        }
        if (static_cast<int>(taken.size()) > left()) return record;
      }
    }
    return "";
  }

  bool search_children(const SlowState& state) {
    std::size_t best = 0;
    std::vector<SlowHex> least;
    for (std::size_t place = 0; place < state.open().size(); ++place) {
      std::vector<SlowHex> list = state.children(state.open()[place], news(state));
      if (place > 0 && list.size() >= least.size()) continue;
      best = place;
      least = std::move(list);
    }
    ++used_[0];
    text_.log += {'\0', static_cast<char>(best)};
    for (const SlowHex& h : least) {
      hexes_.push_back(h);
      const bool good = search_state();
      hexes_.pop_back();
      if (!good) return false;
    }
    return true;
  }

  BoundText text_;
  std::vector<std::vector<int>> automorphisms_;
  std::vector<SlowHex> hexes_;
  std::size_t at_ = 0;
  std::size_t most_ = 0;
  std::mt19937_64 random_;
  std::map<int, int> used_;
  std::vector<SlowVisit> visits_;
};

}  // namespace hexatlas::sabotage
