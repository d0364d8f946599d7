#include "enum/flips/cut.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/cut_list.hpp"

namespace hexatlas::flips {
namespace {

/// Of ways with the same pairs, or more, the first only.
std::vector<TurnedBall> without_worse(const std::vector<TurnedBall>& ways) {
  std::vector<TurnedBall> result;
  for (const TurnedBall& one : ways) {
    const bool is_new = std::none_of(result.begin(), result.end(), [&](const TurnedBall& other) {
      return (other.pairs & ~one.pairs).none();
    });
    if (is_new) result.push_back(one);
  }
  return result;
}

class CutSearch {
 public:
  CutSearch(const BallSource& balls, const canon::Code& target, const CutOptions& options)
      : list_(balls, target, options), count_(options.count), below_(options.below) {}

  /// Cuts are tried from the least sum of two balls on: once meshes are found, most of them need
  /// no look at their balls.
  std::vector<complex::HexComplex> run() {
    std::vector<const Cut*> cuts;
    for (const Cut& cut : list_.cuts()) cuts.push_back(&cut);
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const Cut* a, const Cut* b) { return a->least < b->least; });
    for (const Cut* cut : cuts) {
      if (cut->least >= below_) break;
      match(*cut);
    }
    return std::move(meshes_);
  }

 private:
  void match(const Cut& cut) {
    const CutSides sides = list_.sides_of(cut);
    const CutList::Pairs pairs = CutList::pairs_of(cut);
    if (CutList::related_by_quads(sides, pairs)) return;
    const auto first = without_worse(list_.turned(sides[0], pairs, below_ - sides[1].least));
    const auto second = without_worse(list_.turned(sides[1], pairs, below_ - sides[0].least));
    int below = below_;
    std::optional<std::array<TurnedBall, 2>> found;
    for (const TurnedBall& one : first)
      for (const TurnedBall& other : second) {
        if (one.hexahedra + other.hexahedra >= below) break;
        if ((one.pairs & other.pairs).any()) continue;
        below = one.hexahedra + other.hexahedra;
        found = {one, other};
      }
    if (found) keep(list_.assembled(sides, *found));
  }

  void keep(complex::HexComplex mesh) {
    const auto place = std::upper_bound(
        meshes_.begin(), meshes_.end(), mesh,
        [](const auto& a, const auto& b) { return a.hexahedra.size() < b.hexahedra.size(); });
    meshes_.insert(place, std::move(mesh));
    if (meshes_.size() > count_) meshes_.pop_back();
    if (meshes_.size() == count_)
      below_ = std::min(below_, static_cast<int>(meshes_.back().hexahedra.size()));
  }

  CutList list_;
  std::size_t count_;
  int below_;
  std::vector<complex::HexComplex> meshes_;
};

}  // namespace

std::vector<complex::HexComplex> best_cuts(const BallSource& balls, const canon::Code& target,
                                           const CutOptions& options) {
  core::expects(options.count > 0, "a cut is asked for");
  return CutSearch(balls, target, options).run();
}

std::optional<complex::HexComplex> best_cut(const BallSource& balls, const canon::Code& target,
                                            CutOptions options) {
  options.count = 1;
  std::vector<complex::HexComplex> meshes = best_cuts(balls, target, options);
  if (meshes.empty()) return std::nullopt;
  return std::move(meshes.front());
}

}  // namespace hexatlas::flips
