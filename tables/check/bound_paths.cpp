#include "tables/check/bound_paths.hpp"

#include <algorithm>
#include <optional>

namespace hexatlas::check {

namespace {

/// Walks through the image of a state along the path of the state itself.
class ImageWalk {
 public:
  ImageWalk(const BoundState& state, const BoundAutomorphism& automorphism)
      : state_(state), is_used_(state.hexahedra().size(), false), name_(state.vertices()) {
    for (std::size_t v = 0; v < automorphism.size(); ++v) {
      name_[v] = automorphism[v];
      named_.resize(std::max<std::size_t>(named_.size(), automorphism[v] + std::size_t{1}));
      named_[automorphism[v]] = static_cast<std::uint8_t>(v);
    }
  }

  [[nodiscard]] bool is_lesser() {
    for (const PlacedHexahedron& own : state_.hexahedra()) {
      BoundCorners bottom{};
      for (unsigned i = 0; i < 4; ++i) bottom[i] = named_[own.vertices[i]];
      const std::optional<BoundCorners> tops = tops_on(bottom);
      if (!tops) return false;
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint8_t name = name_of((*tops)[i]);
        if (name != own.vertices[4 + i]) return name < own.vertices[4 + i];
      }
    }
    return false;
  }

 private:
  /// Of a hexahedron that was not met before.
  std::optional<BoundCorners> tops_on(const BoundCorners& bottom) {
    static constexpr std::array<BoundCorners, 6> kAbove = {
        {{4, 5, 6, 7}, {0, 1, 2, 3}, {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 0, 4, 5}, {2, 1, 5, 6}}};
    for (std::size_t h = 0; h < is_used_.size(); ++h) {
      const BoundHexahedron& vertices = state_.hexahedra()[h].vertices;
      const std::array<BoundCorners, 6> facets = facets_of(vertices);
      for (unsigned f = 0; f < 6; ++f) {
        if (is_used_[h] || vertex_set(facets[f]) != vertex_set(bottom)) continue;
        is_used_[h] = true;
        BoundCorners tops{};
        for (unsigned i = 0; i < 4; ++i) {
          const auto at = std::find(facets[f].begin(), facets[f].end(), bottom[i]);
          tops[i] = vertices[kAbove[f][static_cast<std::size_t>(at - facets[f].begin())]];
        }
        return tops;
      }
    }
    return std::nullopt;
  }

  /// New vertices get the next names.
  std::uint8_t name_of(std::uint8_t v) {
    if (!name_[v]) {
      name_[v] = static_cast<std::uint8_t>(named_.size());
      named_.push_back(v);
    }
    return *name_[v];
  }

  const BoundState& state_;
  std::vector<bool> is_used_;
  std::vector<std::optional<std::uint8_t>> name_;
  std::vector<std::uint8_t> named_;
};

}  // namespace

bool has_lesser_image(const BoundState& state, std::span<const BoundAutomorphism> automorphisms) {
  return std::any_of(automorphisms.begin(), automorphisms.end(),
                     [&state](const BoundAutomorphism& automorphism) {
                       return ImageWalk(state, automorphism).is_lesser();
                     });
}

}  // namespace hexatlas::check
