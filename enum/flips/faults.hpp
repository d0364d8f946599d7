#pragma once
/// \file
/// Meshes that break the strict rule in a few places, and choices among many of them.

#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {

/// The number of faults of a ball glued of hexahedra (walk.hpp), counted pair by pair of vertices.
/// `neighbours`: those of the mesh. Cost: about 0.1 ms for 50 hexahedra.
[[nodiscard]] int faults_of(const complex::HexComplex& mesh, const SubBall::Neighbours& neighbours);

/// Which meshes with faults are asked for.
struct FaultyWanted {
  int price = 1;            ///< hexahedra that a fault counts as
  int below = 1 << 14;      ///< hexahedra and price together are less than this
  std::size_t count = 100;  ///< meshes, at most
  [[nodiscard]] constexpr bool includes(int hexahedra, int faults) const noexcept {
    return hexahedra + price * faults < below;
  }
};

/// Things sorted by the faults and the hexahedra of the meshes that they stand for. Of some kinds
/// there are thousands alike, of others, which may be worth as much, a few.
template <typename T>
class FaultyKinds {
 public:
  void add(int faults, int hexahedra, T one) {
    kinds_[{faults, hexahedra}].push_back(std::move(one));
  }

  /// One of those that are left: first its kind is drawn, each with the same probability, then one
  /// of this kind. nullopt if none is left.
  std::optional<std::pair<T, int>> draw(core::Random& random) {
    if (kinds_.empty()) return std::nullopt;
    const auto kind =
        std::next(kinds_.begin(), static_cast<std::ptrdiff_t>(random.below(kinds_.size())));
    std::vector<T>& own = kind->second;
    std::swap(own.back(), own[random.below(own.size())]);
    std::pair<T, int> result{std::move(own.back()), kind->first.first};
    own.pop_back();
    if (own.empty()) kinds_.erase(kind);
    return result;
  }

 private:
  std::map<std::pair<int, int>, std::vector<T>> kinds_;
};

}  // namespace hexatlas::flips
