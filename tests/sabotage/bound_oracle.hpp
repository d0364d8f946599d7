#pragma once
/// \file
/// A slow reading of docs/formats/bound.md, for tests. It judges logs, and writes some: a naive
/// search that takes any rule that holds.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/sabotage/slow_state.hpp"

namespace hexatlas::sabotage {

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

/// What a search wrote of one state and all below it, and the rules 1 .. 4 and 6 that refute it.
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
  bool judge() { return judge(text_.log); }

  /// The same for another log of this claim; states that both have are computed once.
  bool judge(const std::string& log) {
    text_.log = log;
    at_ = 0;
    hexes_.clear();
    return judge_state({}) && at_ == text_.log.size();
  }

  /// A log, unless a mesh is found or it needs more than `most` bytes. Rules in random order.
  std::optional<std::string> search(std::uint64_t seed, std::size_t most) {
    random_.seed(seed);
    most_ = most;
    hexes_.clear();
    visits_.clear();
    text_.log.clear();
    if (!search_state({})) return std::nullopt;
    return text_.log;
  }
  /// How often each record was written.
  [[nodiscard]] const std::map<int, int>& used() const { return used_; }

  /// The states, in the order of their records.
  [[nodiscard]] const std::vector<SlowVisit>& visits() const { return visits_; }

  /// Whether there is a mesh within the limits, by trying everything on the first open facet; what
  /// is cut off has more open facets than the hexahedra to come have facets. For kind `any`.
  bool has_mesh() {
    const SlowState state(text_, hexes_, {});
    if (state.open().empty()) return true;
    if (static_cast<int>(state.open().size()) > 6 * left()) return false;
    for (const SlowHex& h : state.children(state.open()[0], state.may_come())) {
      hexes_.push_back(h);
      const bool found = has_mesh();
      hexes_.pop_back();
      if (found) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] int left() const { return text_.hexahedra - static_cast<int>(hexes_.size()); }

  /// The image of each hexahedron gets the names that a search would give; it comes first if it
  /// has a lesser top where both differ for the first time.
  [[nodiscard]] bool comes_first(const std::vector<int>& map) const {
    std::map<int, int> name;
    for (std::size_t v = 0; v < map.size(); ++v) name[static_cast<int>(v)] = map[v];
    std::set<SlowHex> left(hexes_.begin(), hexes_.end());
    for (const SlowHex& own : hexes_) {
      const auto on_bottom = [&](int v) {
        return name.contains(v) &&
               std::find(own.begin(), own.begin() + 4, name[v]) != own.begin() + 4;
      };
      const auto image = std::find_if(left.begin(), left.end(), [&](const SlowHex& h) {
        return std::count_if(h.begin(), h.end(), on_bottom) == 4;
      });
      if (image == left.end()) return false;
      const SlowHex met = *image;
      left.erase(image);
      std::map<int, int> top_over;  // by the name below
      for (int bits = 0; bits < 8; ++bits) {
        for (const int step : {1, 2, 4}) {
          const int below = corner(met, bits);
          const int top = corner(met, bits ^ step);
          if (on_bottom(below) && !on_bottom(top)) top_over[name[below]] = top;
        }
      }
      for (std::size_t i = 0; i < 4; ++i) {
        const int next = static_cast<int>(name.size());
        const int named = name.try_emplace(top_over[own[i]], next).first->second;
        if (named != own[i + 4]) return named < own[i + 4];
      }
    }
    return false;
  }
  [[nodiscard]] bool less_by_symmetry() const {
    return text_.has_symmetry &&
           std::any_of(automorphisms_.begin(), automorphisms_.end(),
                       [this](const std::vector<int>& map) { return comes_first(map); });
  }
  static int corner(const SlowHex& h, int bits) {
    return h[std::array<std::size_t, 8>{0, 1, 3, 2, 4, 5, 7, 6}[static_cast<std::size_t>(bits)]];
  }

  int byte() { return at_ < text_.log.size() ? static_cast<unsigned char>(text_.log[at_++]) : -1; }

  /// A state and what was asked of it: the hexahedra on open facets, by place, and rules.
  struct Known {
    SlowState state;
    std::map<int, std::vector<SlowHex>> children = {};
    std::map<int, bool> rules = {};
  };

  /// The state of the hexahedra. These alone decide which vertices were saturated before the last.
  Known& known(const IntSet& saturated) {
    const auto at = known_.find(hexes_);
    if (at != known_.end()) return at->second;
    return known_.emplace(hexes_, Known{SlowState(text_, hexes_, saturated)}).first->second;
  }

  bool judge_state(const IntSet& saturated) {
    Known& own = known(saturated);
    const SlowState& state = own.state;
    const int record = byte();
    if (state.open().empty()) return record == 3 && state.bad_link();
    if (record == 0) return judge_children(own);
    if (record == 5) return judge_apart(state);
    const auto [rule, is_new] = own.rules.try_emplace(record);
    if (is_new) rule->second = holds(record, state);
    return rule->second;
  }

  [[nodiscard]] bool holds(int rule, const SlowState& state) const {
    if (rule == 1) return state.face_budget(left());
    if (rule == 2) return state.within_room(left()).is_negative();
    if (rule == 3) return state.bad_link();
    if (rule == 4) return less_by_symmetry();
    return rule == 6 && text_.is_ball && state.lacks_partners();
  }

  bool judge_apart(const SlowState& state) {
    std::vector<int> facets;
    for (int i = 0; i <= left(); ++i) {
      const int place = byte();
      if (place < 0 || place >= static_cast<int>(state.open().size())) return false;
      facets.push_back(state.open()[static_cast<std::size_t>(place)]);
    }
    for (const int f : facets) {
      if (std::count(facets.begin(), facets.end(), f) != 1) return false;
      for (const int g : facets) {
        if (f < g && !state.apart(f, g)) return false;
      }
    }
    return true;
  }

  bool judge_children(Known& own) {
    const SlowState& state = own.state;
    const int place = byte();
    if (left() == 0 || place < 0 || place >= static_cast<int>(state.open().size())) return false;
    const auto [children, is_new] = own.children.try_emplace(place);
    if (is_new) {
      children->second =
          state.children(state.open()[static_cast<std::size_t>(place)], state.within_room(left()));
    }
    for (const SlowHex& h : children->second) {
      hexes_.push_back(h);
      const bool good = judge_state(state.saturated());
      hexes_.pop_back();
      if (!good) return false;
    }
    return true;
  }

  bool search_state(const IntSet& saturated) {
    if (text_.log.size() > most_) return false;
    const SlowState state(text_, hexes_, saturated);
    if (state.open().empty()) {
      if (state.bad_link()) text_.log += '\3';
      return state.bad_link();
    }
    std::vector<std::string> records;
    for (const int rule : {1, 2, 3, 4, 6})
      if (holds(rule, state)) records.emplace_back(1, static_cast<char>(rule));
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
        if (std::all_of(taken.begin(), taken.end(),
                        [&](int g) { return state.apart(std::min(f, g), std::max(f, g)); })) {
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
      std::vector<SlowHex> list = state.children(state.open()[place], state.within_room(left()));
      if (place > 0 && list.size() >= least.size()) continue;
      best = place;
      least = std::move(list);
    }
    ++used_[0];
    text_.log += {'\0', static_cast<char>(best)};
    for (const SlowHex& h : least) {
      hexes_.push_back(h);
      const bool good = search_state(state.saturated());
      hexes_.pop_back();
      if (!good) return false;
    }
    return true;
  }

  BoundText text_;
  std::vector<std::vector<int>> automorphisms_;
  std::vector<SlowHex> hexes_;
  std::map<std::vector<SlowHex>, Known> known_;
  std::size_t at_ = 0;
  std::size_t most_ = 0;
  std::mt19937_64 random_;
  std::map<int, int> used_;
  std::vector<SlowVisit> visits_;
};

}  // namespace hexatlas::sabotage
