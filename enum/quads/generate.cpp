#include "enum/quads/generate.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/quads/planar_map.hpp"
#include "enum/quads/reductions.hpp"
#include "enum/quads/rivals.hpp"
#include "enum/quads/symmetry.hpp"

namespace hexatlas::quads {
namespace {

/// Nodes that first have this many quads are dealt out to the shards in turn: the least number for
/// which each shard gets several, or the last one for which all nodes above take less than a
/// second.
int split_quads(Class which, std::uint64_t parts) {
  struct Level {
    int quads;
    std::uint64_t nodes;  ///< at least so many
  };
  // With the published numbers of classes: OEIS A113201; of minimum degree 3 there are more than
  // 3-connected ones, A007022.
  static constexpr std::array kSimple{Level{10, 800}, Level{11, 3'300}, Level{12, 15'800},
                                      Level{13, 77'000}};
  static constexpr std::array kOthers{Level{16, 450}, Level{17, 1'300}, Level{18, 4'400},
                                      Level{19, 14'500}, Level{20, 49'000}};
  constexpr std::uint64_t kNodesPerShard = 8;
  const auto of = [&](const auto& levels) {
    const auto enough = std::find_if(levels.begin(), levels.end() - 1, [&](const Level& level) {
      return level.nodes / kNodesPerShard >= parts;
    });
    return enough->quads;
  };
  return which == Class::simple ? of(kSimple) : of(kOthers);
}

/// Depth-first walk of the trees of a class down to maps of one size.
template <Class kClass>
class Walk {
 public:
  Walk(int quads, const Visit& visit, const GenerateOptions& options)
      : quads_(quads),
        split_(std::min(quads, split_quads(kClass, options.shard.parts))),
        visit_(visit),
        options_(options) {}

  Sums run() {
    if constexpr (kClass == Class::simple) {
      grow_base(four_cycle());
    } else {
      for (int n = 6; n <= quads_; n += 2) grow_base(pseudo_double_wheel(n));
    }
    return sums_;
  }

 private:
  void grow_base(const PlanarMap& base) {
    map_ = base;
    FlagList all;
    for (int d = 0; d < map_.darts; ++d) {
      all.push_back({static_cast<Dart>(d), false});
      all.push_back({static_cast<Dart>(d), true});
    }
    Symmetry symmetry;
    core::ensures(least_is_ours(map_, all, all.size(), symmetry),
                  "the least of all codes is attained");
    visit_node(symmetry, 0);
  }

  /// A node of the tree, whose parent had `parent_quads`.
  void visit_node(const Symmetry& symmetry, int parent_quads) {
    const bool is_dealt = parent_quads < split_ && map_.quads() >= split_;
    if (is_dealt && next_part_++ % options_.shard.parts != options_.shard.part) return;
    if (map_.quads() == quads_)
      count(symmetry);
    else
      expand(symmetry);
  }

  void count(const Symmetry& symmetry) {
    const int automorphisms = symmetry.automorphisms();
    const int rotations = symmetry.rotations();
    ++sums_.classes;
    sums_.orientation_preserving += automorphisms == rotations ? 2 : 1;
    sums_.rooted += static_cast<std::uint64_t>(8 * quads_ / automorphisms);
    if (visit_) visit_(quadrangulation_of(map_), automorphisms, rotations);
  }

  void expand(const Symmetry& symmetry) {
    if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed))
      sums_.complete = false;
    if (!sums_.complete) return;
    std::vector<DartImages> images;
    if (symmetry.automorphisms() > 1) images = dart_images(map_, symmetry);
    if constexpr (kClass == Class::simple) expand_p0(images);
    expand_p1(images);
    if constexpr (kClass != Class::simple)
      if (map_.quads() + 4 <= quads_) expand_p3(images);
  }

  using Images = std::vector<DartImages>;

  void expand_p0(const Images& images) {
    const int parent_quads = map_.quads();
    const int darts = map_.darts;
    const P0Rivals rivals(map_);
    for (int i = 0; i < darts; ++i) {
      const auto p = static_cast<Dart>(i);
      const auto is_least = [&](Dart q) { return p <= q && p <= map_.across(q); };
      if (!is_least(p) || rivals.refute(map_, p) || !is_least_of_corners(images, p, is_least))
        continue;
      const Dart s = map_.expand_p0(p);
      FlagList candidates;
      const std::size_t ours = best_p0_flags(map_, s, candidates);
      keep_if_canonical(candidates, ours, parent_quads);
      map_.reduce_p0();
    }
  }

  /// Whether P1 at h gives a map of the class; for simple ones, of minimum degree 3, since others
  /// are made by P0.
  [[nodiscard]] bool may_expand_p1(Dart h) const noexcept {
    const Vertex b = map_.head(map_.ccw[h]);
    const Vertex d = map_.head(map_.cw[h]);
    if constexpr (kClass == Class::simple) {
      const int raised = (map_.degree[b] == 2 ? 1 : 0) + (map_.degree[d] == 2 ? 1 : 0);
      return raised == vertices_of_degree_2();
    }
    return kClass != Class::three_connected || !is_diagonal(map_, b, d);
  }

  [[nodiscard]] int vertices_of_degree_2() const noexcept {
    return static_cast<int>(
        std::count(map_.degree.begin(), map_.degree.begin() + map_.vertices, 2));
  }

  void expand_p1(const Images& images) {
    if (kClass == Class::simple && vertices_of_degree_2() > 2) return;
    const int parent_quads = map_.quads();
    const int darts = map_.darts;
    const P1Rivals<kClass> rivals(map_);
    for (int i = 0; i < darts; ++i) {
      const auto h = static_cast<Dart>(i);
      if (map_.degree[map_.origin[h]] <= 3 || rivals.refute(map_, h) || !may_expand_p1(h)) continue;
      if (!std::all_of(images.begin(), images.end(),
                       [h](const DartImages& image) { return h <= image.of[h]; }))
        continue;
      const Dart first_of_c = map_.expand_p1(h);
      FlagList candidates;
      const std::size_t ours = best_p1_flags<kClass>(map_, h, candidates);
      keep_if_canonical(candidates, ours, parent_quads);
      map_.reduce_p1(h, first_of_c);
    }
  }

  void expand_p3(const Images& images) {
    const int parent_quads = map_.quads();
    const int darts = map_.darts;
    for (int i = 0; i < darts; ++i) {
      const auto p = static_cast<Dart>(i);
      const auto is_least = [&](Dart q) {
        return p <= q && p <= map_.along(q) && p <= map_.across(q) &&
               p <= map_.along(map_.across(q));
      };
      if (!is_least(p) || !is_least_of_corners(images, p, is_least)) continue;
      const Dart r = map_.expand_p3(p);
      if (!has_p1_reduction<kClass>(map_)) {
        FlagList candidates;
        const std::size_t ours = best_p3_flags<kClass>(map_, r, candidates);
        keep_if_canonical(candidates, ours, parent_quads);
      }
      map_.reduce_p3();
    }
  }

  /// Whether is_least(q) for the images q of the corner of the quad left of p.
  template <class IsLeast>
  [[nodiscard]] bool is_least_of_corners(const Images& images, Dart p, IsLeast&& is_least) const {
    return std::all_of(images.begin(), images.end(), [&](const DartImages& image) {
      return is_least(image.mirrored ? map_.cw[image.of[p]] : image.of[p]);
    });
  }

  void keep_if_canonical(const FlagList& candidates, std::size_t ours, int parent_quads) {
    Symmetry symmetry;
    if (ours != 0 && least_is_ours(map_, candidates, ours, symmetry))
      visit_node(symmetry, parent_quads);
  }

  int quads_;
  int split_;
  const Visit& visit_;
  const GenerateOptions& options_;
  PlanarMap map_{};
  Sums sums_{};
  std::uint64_t next_part_ = 0;
};

}  // namespace

Sums generate(Class which, int quads, const Visit& visit, const GenerateOptions& options) {
  core::expects(kMinQuads <= quads && quads <= kMaxQuads, "the number of quads is out of range");
  core::expects(options.shard.part < options.shard.parts, "there is no such shard");
  switch (which) {
    case Class::simple:
      return Walk<Class::simple>(quads, visit, options).run();
    case Class::min_degree_3:
      return Walk<Class::min_degree_3>(quads, visit, options).run();
    case Class::three_connected:
      return Walk<Class::three_connected>(quads, visit, options).run();
  }
  throw core::PreconditionViolated("there is no such class");
}

}  // namespace hexatlas::quads
