#pragma once
/// \file
/// Slow states of a certificate of a lower bound (docs/formats/bound.md), for tests: each is
/// computed anew from its list of hexahedra.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/sabotage/bound_text.hpp"

namespace hexatlas::sabotage {

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

/// How many new vertices may come, in all and of each colour.
struct SlowNew {
  int all = 0;
  std::array<int, 2> of_colour = {1000, 1000};
  [[nodiscard]] bool is_negative() const { return all < 0 || of_colour[0] < 0 || of_colour[1] < 0; }
};

/// Everything about one state.
class SlowState {
 public:
  enum Kind { kFree, kEdge, kDiagonal, kBody };

  /// `saturated`: of the state before the last hexahedron.
  SlowState(const BoundText& text, const std::vector<SlowHex>& hexes, IntSet saturated)
      : ball_(text.is_ball),
        interior_(text.interior),
        saturated_(std::move(saturated)),
        n_(static_cast<int>(text.quads.size()) + 2),
        hexes_(hexes) {
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
    if (!ball_) return;
    find_colours();
    saturate();
  }

  [[nodiscard]] const IntSet& saturated() const { return saturated_; }
  [[nodiscard]] bool lacks_partners() const { return lacks_partners_; }

  /// By the limit of interior vertices: for balls the greatest numbers that balance the colours.
  [[nodiscard]] SlowNew may_come() const {
    if (!ball_) return {interior_ - (vertices_ - n_)};
    std::array<int, 2> outside{};
    std::array<int, 2> inside{};
    for (int v = 0; v < vertices_; ++v) ++(v < n_ ? outside : inside)[colour(v)];
    for (int all = interior_; all > -100; --all) {
      for (int i = -200; i <= 200; ++i) {
        if (outside[0] + 2 * i == outside[1] + 2 * (all - i))
          return {all - inside[0] - inside[1], {i - inside[0], all - i - inside[1]}};
      }
    }
    return {-1};
  }
  [[nodiscard]] SlowNew within_room(int left) const {
    SlowNew may = may_come();
    if (!ball_) return {std::min(may.all, room(left))};
    for (; may.all > room(left); may.all -= 2) {
      --may.of_colour[0];
      --may.of_colour[1];
    }
    return may;
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
  [[nodiscard]] std::vector<SlowHex> children(int f, const SlowNew& news) const {
    if (news.is_negative()) return {};
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
            SlowNew left = news;
            for (std::size_t i = 0; i < 4; ++i) {
              h[i] = facet(f).corners[i];
              const int top = std::array{a, b, c, d}[i];
              h[i + 4] = top < 0 ? next++ : top;
              if (top >= 0) continue;
              --left.all;
              if (ball_) --left.of_colour[1 - colour(h[i])];
            }
            if (!left.is_negative() && may_be_put(h)) list.push_back(h);
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

  [[nodiscard]] std::size_t colour(int v) const {
    return static_cast<std::size_t>(colour_[static_cast<std::size_t>(v)]);
  }

  /// Those that v may still meet, of one colour.
  [[nodiscard]] IntSet strangers(int v, std::size_t of_colour) const {
    IntSet set;
    for (int u = 0; u < vertices_; ++u) {
      if (u != v && colour(u) == of_colour && kind(u, v) == kFree && open_at(u) > 0) set.insert(u);
    }
    return set;
  }
  /// Whether a edges to come at v find what they need.
  [[nodiscard]] bool has_partners(int v, int a) const {
    if (a > 0 && saturated_.contains(v)) return false;
    const SlowNew may = may_come();
    const int c = open_at(v) - 2 * savings(v) + 2 * a;
    const int f = open_at(v) - 3 * savings(v) + 3 * a;
    const IntSet others = strangers(v, 1 - colour(v));
    int ends = may.of_colour[1 - colour(v)];
    for (const int u : others) ends += saturated_.contains(u) ? 0 : 1;
    const int far = count(others) + may.of_colour[1 - colour(v)];
    const int same = count(strangers(v, colour(v))) + may.of_colour[colour(v)];
    const bool none_is_negative = !may.is_negative();
    return none_is_negative && (a == 0 || a <= ends) && c + a <= far && f <= same;
  }
  [[nodiscard]] int least_edges(int v) const {
    int a = 0;
    while (v >= n_ && hexes_at(v) + open_at(v) - 2 * savings(v) + 2 * a < 4) ++a;
    return a;
  }
  void saturate() {
    for (std::size_t before = 1000; before != saturated_.size();) {
      before = saturated_.size();
      lacks_partners_ = false;
      for (int v = 0; v < vertices_; ++v) {
        if (open_at(v) == 0) continue;
        lacks_partners_ = lacks_partners_ || !has_partners(v, least_edges(v));
        if (least_edges(v) == 0 && !has_partners(v, 1)) saturated_.insert(v);
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
    if (!turn(u, a.at(i + 1), a.at(i)) || !turn(u, a.at(i - 1), a.at(i))) return false;
    if (a.has(u) || !is(u, a.at(i), kEdge) || !is(u, a.at(i + 1), kDiagonal) ||
        !is(u, a.at(i - 1), kDiagonal) || kind(u, a.at(i + 2)) != kFree) {
      return false;
    }
    if (!ball_) return true;
    return colour(u) != colour(a.at(i)) && open_at(u) > 0 && may_be_edge(u, a.at(i));
  }

  /// For balls.
  [[nodiscard]] bool may_be_edge(int u, int v) const {
    if (kind(u, v) == kEdge) return !open_with(u, v).empty();
    return !saturated_.contains(u) && !saturated_.contains(v);
  }
  [[nodiscard]] bool may_be_put(const SlowHex& h) const {
    if (IntSet(h.begin(), h.end()).size() != 8) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      const int t = h[4 + i];
      const int next = h[4 + (i + 1) % 4];
      if (!is(t, next, kEdge) || !is(t, h[4 + (i + 2) % 4], kDiagonal)) return false;
      if (ball_ && (!may_be_edge(t, next) || !may_be_edge(t, h[i]))) return false;
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
  int interior_;
  IntSet saturated_;
  bool lacks_partners_ = false;
  int n_;
  int vertices_ = 0;
  std::vector<SlowHex> hexes_;
  std::map<std::pair<int, int>, Kind> pairs_;
  std::vector<SlowFacet> facets_;
  std::vector<int> open_;
  std::vector<int> colour_;
};

}  // namespace hexatlas::sabotage
